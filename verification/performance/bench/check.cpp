#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "optimized/contact.h"
#include "reference/cycle/contact.h"
#include "verification/decisions/fuzz/fuzz.h"
#include "verification/decisions/queries/decision_text.h"
#include "verification/performance/bench/bare_step.h"
#include "verification/performance/bench/bench.h"
#include "verification/performance/bench/exact_decisions.h"
#include "verification/support/contact_choice.h"

namespace type21::bench {

namespace {

/// The way of a tool that mostly creeps and sometimes leaps, with a little turn that comes and goes: cycle -> pose.
struct Wander {
    int cycle = 0;
    long at = 0;
    Motion next(const BenchScene& scene) {
        constexpr int leaps[] = {1, 1, 1, 2, 1, 7, 1, 1, 40, 1, 1, 190};
        at += leaps[cycle % 12];
        at %= 600;
        Motion motion = scene.motion(static_cast<int>(at));
        if (cycle % 3 == 2) {
            const double angle = 1e-5 * (cycle % 17);
            for (ToolMotion& tool : motion.tools) {
                tool.rotation << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
            }
        }
        // Time goes on although the way comes back.
        motion.time = motion.step * ++cycle;
        return motion;
    }
};

void compare(CheckPart& part, const BenchScene& scene, size_t i, int cycle, const Decision& ours,
             const Decision& truth) {
    ++part.decisions;
    if (same(ours, truth)) return;
    if (part.different++ == 0)
        part.first_difference =
            fmt::format("{}, node {}, cycle {}: {}; exact: {}", scene.name,
                        scene.scene.model->nodes.id[static_cast<size_t>(scene.card().secondary.node[i])], cycle,
                        in_words(ours), in_words(truth));
}

}  // namespace

CheckPart check_steps(const BenchScene& scene, long count, const MakeContact& make) {
    CheckPart part{scene.name + ", step and selection against exact decisions", 0, 0, {}};
    const ExactDecisions exact(scene);
    const auto contact = (make ? make : contact_maker("optimized"))(scene.scene, scene.interface);
    BareStep bare(scene, true);
    Wander wander;
    while (part.decisions < count) {
        const Motion motion = wander.next(scene);
        const std::vector<Decision> truth = exact.at(motion, static_cast<size_t>((count - part.decisions + 1) / 2));
        const ContactStep step = contact->step(motion);
        // Two of three cycles without projections inside the safe radii; the third with.
        bare.step(motion, wander.cycle % 3 == 0 ? BareStep::Until::decide : BareStep::Until::select);
        const std::vector<Decision> selected = bare.decisions();
        for (size_t i = 0; i < truth.size(); ++i) {
            compare(part, scene, i, wander.cycle, step.nodes[i].decision, truth[i]);
            compare(part, scene, i, wander.cycle, selected[i], truth[i]);
        }
    }
    return part;
}

CheckPart check_deck(const BenchScene& scene, long count) {
    CheckPart part{scene.name + ", step against the reference's", 0, 0, {}};
    optimized::Contact contact(scene.scene, scene.interface);
    reference::Contact reference(scene.scene, scene.interface);
    for (int c = 0; c < scene.cycles && part.decisions < count; ++c) {
        const Motion motion = scene.motion(c);
        const ContactStep one = contact.step(motion), other = reference.step(motion);
        for (size_t i = 0; i < other.nodes.size(); ++i)
            compare(part, scene, i, c, one.nodes[i].decision, other.nodes[i].decision);
    }
    return part;
}

CheckPart check_families(long count, int threads) {
    CheckPart part{"adversarial families, decide against exact answers", 0, 0, {}};
    const long each = std::max<long>(1, count / static_cast<long>(question_families().size()));
    for (const QuestionFamily& family : question_families()) {
        FuzzOptions options;
        options.count = each;
        options.method = DecideWith::optimized;
        options.jobs = threads;
        options.seed = 21;
        const FuzzTally tally = fuzz(family, options, [](double) {});
        part.decisions += tally.decisions;
        part.different += tally.different;
        if (part.first_difference.empty() && !tally.failures.empty())
            part.first_difference = fmt::format("{}, block {}, query {}: {}", family.name, tally.failures[0].block,
                                                tally.failures[0].number, tally.failures[0].what);
    }
    return part;
}

}  // namespace type21::bench
