#include "verification/results/record/interface_columns.h"

#include <algorithm>
#include <set>

namespace type21 {

const std::vector<InterfaceColumn>& interface_columns() {
    using T = InterfaceTotals;
    static const std::vector<InterfaceColumn> columns{
        {"FNX", [](const T& t) { return t.normal.x(); }},
        {"FNY", [](const T& t) { return t.normal.y(); }},
        {"FNZ", [](const T& t) { return t.normal.z(); }},
        {"FTX", [](const T& t) { return t.tangential.x(); }},
        {"FTY", [](const T& t) { return t.tangential.y(); }},
        {"FTZ", [](const T& t) { return t.tangential.z(); }},
        {"|FNX|", [](const T& t) { return t.abs_normal.x(); }},
        {"|FNY|", [](const T& t) { return t.abs_normal.y(); }},
        {"|FNZ|", [](const T& t) { return t.abs_normal.z(); }},
        {"||FN||", [](const T& t) { return t.signed_normal; }},
        {"|FX|", [](const T& t) { return t.abs_total.x(); }},
        {"|FY|", [](const T& t) { return t.abs_total.y(); }},
        {"|FZ|", [](const T& t) { return t.abs_total.z(); }},
        {"||F||", [](const T& t) { return t.norm_total; }},
        {"QFRIC", [](const T& t) { return t.friction_heat; }},
        {"CE_ELAST", [](const T& t) { return t.elastic_energy; }},
        {"CE_FRIC", [](const T& t) { return t.friction_energy; }},
        {"CE_DAMP", [](const T& t) { return t.damping_energy; }},
    };
    return columns;
}

std::vector<InterfaceColumn> chosen_columns(const Model& model, int interface) {
    std::set<std::string> asked;
    bool named = false;
    for (const HistoryRequest& request : model.histories) {
        if (request.kind != HistoryRequest::Kind::interface) continue;
        if (std::find(request.objects.begin(), request.objects.end(), interface) == request.objects.end()) continue;
        named = true;
        asked.insert(request.variables.begin(), request.variables.end());
    }
    if (!named) return interface_columns();
    std::vector<InterfaceColumn> chosen;
    for (const InterfaceColumn& column : interface_columns())
        if (asked.contains(column.name)) chosen.push_back(column);
    return chosen;
}

}  // namespace type21
