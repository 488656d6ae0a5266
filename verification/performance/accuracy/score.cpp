#include "verification/performance/accuracy/score.h"

#include <algorithm>

#include "verification/performance/accuracy/timing.h"

namespace type21::accuracy {

namespace {

void compare(const Answer& answer, const ExactAnswer& exact, Score& score) {
    ++score.decisions;
    if (answer.undecided) {
        ++score.undecided;
        return;
    }
    const DecisionAnswer& right = exact.answer;
    if (answer.kind != right.kind || answer.segment != right.segment || answer.triangle != right.triangle ||
        answer.side != right.side)
        ++score.wrong;
    // Where a method finds no contact it finds no force. A penetration that is not a number stays one.
    const double penetration = answer.kind == Kind::contact ? answer.penetration : 0.0;
    const double force = stiffness * (penetration < 0 ? 0.0 : penetration);
    if (exact.forced)
        score.force.add(force, exact.force, exact.scale);
    else if (right.kind != Kind::contact && force > 0)
        score.force.add_spurious();
}

}  // namespace

Score score(const Method& method, const std::vector<ExactAnswer>& exact, std::span<const size_t> order,
            double seconds) {
    Score score;
    score.settled.resize(method.stages.size());
    const Watch watch(true);
    for (const size_t number : order) {
        const Answer answer = method.answer(number);
        compare(answer, exact[number], score);
        if (!score.settled.empty()) score.settled[static_cast<size_t>(answer.stage)].push_back(number);
        if (score.decisions % 16 == 0 && watch.seconds() > seconds) break;
    }
    score.seconds = watch.seconds();
    return score;
}

}  // namespace type21::accuracy
