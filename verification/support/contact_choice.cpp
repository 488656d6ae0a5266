#include "verification/support/contact_choice.h"

#include <stdexcept>

#include "optimized/contact.h"
#include "reference/cycle/contact.h"

namespace type21 {

const std::vector<std::string>& contact_choices() {
    static const std::vector<std::string> names{"reference", "optimized"};
    return names;
}

MakeContact contact_maker(const std::string& with) {
    if (with == "reference") return [](const Scene& s, int i) { return std::make_unique<reference::Contact>(s, i); };
    if (with == "optimized") return [](const Scene& s, int i) { return std::make_unique<optimized::Contact>(s, i); };
    throw std::invalid_argument("--with: " + with + " is not known");
}

}  // namespace type21
