/// @file The columns of interface_<id>.csv: impulses on the tool and energies by their Radioss names.
#pragma once

#include <string>
#include <vector>

#include "reference/host/march.h"

namespace type21 {

struct InterfaceColumn {
    std::string name;
    double (*value)(const InterfaceTotals&);
};

/// Every column in the order of the file: FNX ... CE_DAMP (Formulation 11, step 8).
const std::vector<InterfaceColumn>& interface_columns();

/// Columns of one interface: those that its /TH/INTER groups choose, all when none names it.
std::vector<InterfaceColumn> chosen_columns(const Model& model, int interface);

}  // namespace type21
