/// @file Hand-made histories.
#pragma once

#include "verification/results/tables/csv_table.h"

namespace type21::test {

struct Column {
    std::string name;
    std::vector<double> values;
};

inline CsvTable history(std::vector<double> time, const std::vector<Column>& columns) {
    CsvTable table;
    table.file = "hand-made";
    table.time = std::move(time);
    for (const Column& column : columns) {
        table.columns.push_back(column.name);
        table.values.push_back(column.values);
    }
    return table;
}

inline CsvTable node_history(std::vector<double> time, std::vector<Id> nodes, const std::vector<Column>& columns) {
    CsvTable table = history(std::move(time), columns);
    table.has_object = true;
    table.object = std::move(nodes);
    return table;
}

}  // namespace type21::test
