#include "verification/support/nearest_word.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace type21 {
namespace {

/// Characters to insert, delete or replace, upper and lower case alike (Levenshtein).
size_t changes(std::string_view a, std::string_view b) {
    std::vector<size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), size_t{0});
    for (size_t i = 0; i < a.size(); ++i) {
        size_t diagonal = row[0];
        row[0] = i + 1;
        for (size_t j = 0; j < b.size(); ++j) {
            const bool same =
                std::tolower(static_cast<unsigned char>(a[i])) == std::tolower(static_cast<unsigned char>(b[j]));
            const size_t replaced = diagonal + (same ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& words) {
    std::string_view nearest;
    size_t fewest = std::max<size_t>(word.size() / 3, 1) + 1;
    if (word.size() > 64) return nearest;
    for (const std::string_view one : words) {
        const size_t count = changes(word, one);
        if (count >= fewest) continue;
        fewest = count;
        nearest = one;
    }
    return nearest;
}

}  // namespace type21
