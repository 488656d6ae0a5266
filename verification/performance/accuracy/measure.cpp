#include "verification/performance/accuracy/measure.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "verification/decisions/question_families/draw.h"

namespace type21::accuracy {

namespace {

constexpr size_t least_timed = 16;

std::vector<size_t> shuffled(size_t count, std::uint64_t seed) {
    std::vector<size_t> order(count);
    std::iota(order.begin(), order.end(), size_t{0});
    Draw draw("order of the questions", seed, 0);
    for (size_t i = count; i > 1; --i)
        std::swap(order[i - 1], order[static_cast<size_t>(draw.below(static_cast<int>(i)))]);
    return order;
}

/// A method that answers some queries, over and over.
Timed timed_on(const Method& method, std::vector<size_t> numbers) {
    const size_t count = numbers.size();
    return {[&method, numbers = std::move(numbers)] {
                // The answers are used, so that no compiler leaves them out.
                [[maybe_unused]] static volatile int sink = 0;
                int sum = 0;
                for (const size_t number : numbers)
                    sum += method.answer(number).segment;
                sink = sum;
            },
            count,
            {}};
}

std::vector<size_t> first_of(const std::vector<size_t>& numbers, double seconds_each, double seconds) {
    const double fit = seconds_each > 0 ? seconds / seconds_each : 1e9;
    const size_t count = std::max(least_timed, static_cast<size_t>(std::min(fit, 1e9)));
    return {numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(std::min(count, numbers.size()))};
}

SceneRow row_of(const SceneKind& kind, const std::vector<QueryBlock>& blocks, const std::vector<BlockQuery>& queries,
                const std::vector<ExactAnswer>& exact) {
    SceneRow row{std::string(kind.name), std::string(kind.kind), std::string(kind.what)};
    row.decisions = exact.size();
    size_t candidates = 0;
    for (size_t q = 0; q < exact.size(); ++q) {
        const Kind found = exact[q].answer.kind;
        ++(found == Kind::contact ? row.contact : found == Kind::proximity ? row.proximity : row.none);
        row.forced += exact[q].forced ? 1 : 0;
        candidates += queries[q].candidates->ranks().size();
    }
    for (const QueryBlock& block : blocks)
        row.segments += block.tool.segment.size();
    row.candidates = static_cast<double>(candidates) / static_cast<double>(exact.size());
    return row;
}

void measure_scene(const SceneKind& kind, const Options& options, Result& result) {
    const auto say = [&](const char* what) {
        if (options.progress) options.progress(std::string(kind.name) + ": " + what);
    };
    say("exact answers");
    const std::vector<QueryBlock> blocks = kind.make(options.decisions(), options.seed);
    const std::vector<BlockQuery> queries = all_queries(blocks);
    std::vector<ExactAnswer> exact;
    exact.reserve(queries.size());
    for (const BlockQuery& one : queries)
        exact.push_back(exact_answer_of(one.tool(), one.query()));
    result.scenes.push_back(row_of(kind, blocks, queries, exact));

    say("each method is compared with them");
    std::vector<Method> methods = arithmetic_methods(queries);
    for (Method& method : search_methods(blocks, queries))
        methods.push_back(std::move(method));
    const std::vector<size_t> order = shuffled(queries.size(), options.seed);
    std::vector<Timed> timed;
    std::vector<Score> scores;
    for (const Method& method : methods) {
        scores.push_back(score(method, exact, order, options.comparing_seconds()));
        const double each = scores.back().seconds / static_cast<double>(scores.back().decisions);
        timed.push_back(timed_on(method, first_of(order, each, options.pass_seconds())));
    }
    // One more for each stage that settled anything.
    struct Place {
        size_t method, stage;
    };
    std::vector<Place> places;
    for (size_t m = 0; m < methods.size(); ++m) {
        for (size_t s = 0; s < scores[m].settled.size(); ++s) {
            places.push_back({m, s});
            const auto& numbers = scores[m].settled[s];
            const double each = scores[m].seconds / static_cast<double>(scores[m].decisions);
            timed.push_back(timed_on(
                methods[m], numbers.empty() ? numbers : first_of(numbers, each, 0.25 * options.pass_seconds())));
        }
    }
    say("timed in turn");
    interleave(timed, options.repeats_of_all());

    for (size_t m = 0; m < methods.size(); ++m) {
        const Method& method = methods[m];
        result.rows.push_back({std::string(kind.name), std::string(kind.kind), method.group, method.name,
                               method.implementation, method.what, method.exact, std::move(scores[m]),
                               timing_spread(timed[m].ns), timed[m].count});
        if (method.stages.empty()) continue;
        StageCountsRow stage_counts{std::string(kind.name), std::string(kind.kind), method.implementation, {}};
        for (size_t p = 0; p < places.size(); ++p) {
            const Timed& pass = timed[methods.size() + p];
            if (places[p].method == m)
                stage_counts.stages.push_back({method.stages[places[p].stage],
                                               result.rows.back().score.settled[places[p].stage].size(),
                                               pass.ns.empty() ? TimingSpread{} : timing_spread(pass.ns), pass.count});
        }
        result.stage_counts.push_back(std::move(stage_counts));
    }
}

}  // namespace

bool Result::exact_ones_are_right() const {
    return std::all_of(rows.begin(), rows.end(),
                       [](const MethodRow& row) { return !row.exact || row.score.wrong == 0; });
}

Result measure(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    Result result;
    result.options = options;
    for (const SceneKind& kind : scene_kinds())
        if (options.scenes.empty() ||
            std::find(options.scenes.begin(), options.scenes.end(), kind.name) != options.scenes.end())
            measure_scene(kind, options, result);
    if (options.scenes.empty()) result.effects = effect_costs(options.quick, options.progress);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace type21::accuracy
