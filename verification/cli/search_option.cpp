#include <stdexcept>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/support/contact_choice.h"

namespace type21::cli {

void add_search(CLI::App& verb, std::string& search, const std::string& also) {
    verb.add_option("--search", search,
                    "how the optimized contact finds candidates: by a tree of boxes, or by sorted lists that are kept "
                    "within the margin of Bumult" +
                        also)
        ->check(CLI::IsMember(search_choices()));
}

MakeContact chosen_contact(const std::string& with, const std::string& search) {
    try {
        return contact_maker(with, search);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

}  // namespace type21::cli
