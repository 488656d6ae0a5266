#include "verification/criteria/mutation/mutation.h"

namespace type21 {

const std::vector<Mutation>& mutations() {
    static const std::vector<Mutation> table = [] {
        std::vector<Mutation> all;
        for (const auto& room :
             {decision_mutations, force_mutations, friction_mutations, heat_mutations, tool_mutations})
            for (Mutation& mutation : room())
                all.push_back(std::move(mutation));
        return all;
    }();
    return table;
}

}  // namespace type21
