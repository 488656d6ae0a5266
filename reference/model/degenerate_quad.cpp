#include "reference/model/degenerate_quad.h"

#include <fmt/format.h>

namespace type21 {

bool mend_quad(CardReader& reader, size_t line, std::array<Id, 4>& nodes, std::string_view kind, Id id) {
    std::array<Id, 4>& n = nodes;
    if (n[3] == 0) n[3] = n[2];
    const std::array<Id, 4> written = n;
    if (n[0] == n[3]) {
        n[3] = n[2];
    } else if (n[1] == n[2]) {
        n[2] = n[3];
    } else if (n[0] == n[1]) {
        n = {n[1], n[2], n[3], n[3]};
    }
    const bool triangle = n[2] == n[3];
    if (n[0] == n[1] || n[1] == n[2] || n[0] == n[2] || (!triangle && (n[0] == n[3] || n[1] == n[3]))) {
        reader.error(static_cast<int>(line), "node_ID",
                     id > 0 ? fmt::format("{} {}", kind, id) : fmt::format("{}", fmt::join(written, " ")),
                     fmt::format("a {} has at least three different nodes and does not cross itself", kind),
                     fmt::format("Give the nodes in the order around the {}", kind));
        return false;
    }
    if (n != written)
        reader.warning(static_cast<int>(line), "node_ID", "",
                       fmt::format("a {} that is a triangle repeats its third node; this one repeats another, and is "
                                   "read as a triangle",
                                   kind),
                       "Write the fourth node like the third");
    return true;
}

}  // namespace type21
