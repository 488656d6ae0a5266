#include "verification/support/contact_choice.h"

#include <stdexcept>

#include "optimized/contact.h"
#include "reference/cycle/contact.h"

namespace type21 {

const std::vector<std::string>& contact_choices() {
    static const std::vector<std::string> names{"reference", "optimized"};
    return names;
}

const std::vector<std::string>& search_choices() {
    static const std::vector<std::string> names{"tree", "sorted"};
    return names;
}

MakeContact contact_maker(const std::string& with, const std::string& search) {
    if (with == "reference") {
        if (!search.empty())
            throw std::invalid_argument("--search " + search + ": the reference has one search only; with --with " +
                                        contact_choices().back() + " there is a choice");
        return [](const Scene& s, int i) { return std::make_unique<reference::Contact>(s, i); };
    }
    if (with != "optimized") throw std::invalid_argument("--with: " + with + " is not known");
    optimized::ContactOptions options;
    if (search == "sorted")
        options.search = optimized::SearchKind::sorted;
    else if (!search.empty() && search != search_choices().front())
        throw std::invalid_argument("--search: " + search + " is not known");
    return [options](const Scene& s, int i) { return std::make_unique<optimized::Contact>(s, i, options); };
}

}  // namespace type21
