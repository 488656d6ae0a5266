/// @file Every field of the twelve lines as text, for `type21 check` and run.json.
#include "reference/model/interface.h"

namespace type21 {

std::vector<FieldRow> field_table(const Interface& interface, const UnitSystem& units) {
    (void)interface;
    (void)units;
    return {};
}

}  // namespace type21
