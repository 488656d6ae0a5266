#include "reference/contract/origin.h"

#include <fmt/format.h>

namespace type21 {

std::string to_text(const Origin& origin) {
    const auto with_line = [&](const char* what) {
        return origin.line > 0 ? fmt::format("{} (line {})", what, origin.line) : std::string(what);
    };
    const auto with_reason = [&](const std::string& what) {
        return origin.why.empty() ? what : fmt::format("{}: {}", what, origin.why);
    };
    switch (origin.kind) {
        case Origin::Kind::deck:
            return with_reason(fmt::format("line {}", origin.line));
        case Origin::Kind::fallback:
            return with_reason("default");
        case Origin::Kind::rule:
            return with_reason(with_line("rule"));
        case Origin::Kind::absent:
            return with_reason("not in this version");
    }
    return {};
}

}  // namespace type21
