#include "verification/decisions/fuzz/fuzz.h"

#include <algorithm>
#include <chrono>
#include <mutex>

#include "verification/decisions/fuzz/judgement.h"
#include "verification/decisions/queries/decision_text.h"
#include "verification/support/in_parallel.h"

namespace type21 {

void add_counts(FuzzTally& sum, const FuzzTally& part) {
    sum.decisions += part.decisions;
    sum.contact += part.contact;
    sum.proximity += part.proximity;
    sum.near_border += part.near_border;
    sum.margins += part.margins;
    for (size_t i = 0; i < sum.settled.size(); ++i)
        sum.settled[i] += part.settled[i];
    sum.double_wrong += part.double_wrong;
    sum.second_by_exact += part.second_by_exact;
    sum.different += part.different;
}

namespace {

void add(FuzzTally& sum, const FuzzTally& part, size_t keep) {
    add_counts(sum, part);
    sum.failures.insert(sum.failures.end(), part.failures.begin(), part.failures.end());
    std::sort(sum.failures.begin(), sum.failures.end(), [](const FuzzFailure& a, const FuzzFailure& b) {
        return a.block != b.block ? a.block < b.block : a.number < b.number;
    });
    if (sum.failures.size() > keep) sum.failures.resize(keep);
}

/// The queries of one block, from the first to `count` of them.
FuzzTally answered(const QuestionFamily& family, const FuzzOptions& options, std::uint64_t index, long count) {
    FuzzTally tally;
    const DecisionBlock block = block_of(family, options.seed, index);
    for (size_t q = 0; q < block.queries.size() && tally.decisions < count; ++q) {
        const ContactQuery& query = block.queries[q];
        const long number = static_cast<long>(index) * queries_per_block + static_cast<long>(q);
        const bool full = number % options.full_every == 0;
        const Judgement judgement =
            judge(block.tool, query, options.method, full ? Scrutiny::full : Scrutiny::decision);
        ++tally.decisions;
        if (judgement.expected.kind == Kind::contact) ++tally.contact;
        if (judgement.expected.kind == Kind::proximity) ++tally.proximity;
        if (judgement.expected.stage == Stage::exact) ++tally.second_by_exact;
        ++tally.settled[static_cast<size_t>(judgement.answer.stage)];
        if (!decide(block.tool, query, DecideWith::plain).same_decision(judgement.expected)) ++tally.double_wrong;
        if (full) {
            ++tally.margins;
            if (in_ulps(judgement.margin, query.point) < near_border_ulps) ++tally.near_border;
        }
        if (judgement.wrong.empty()) continue;
        ++tally.different;
        if (tally.failures.size() < options.keep)
            tally.failures.push_back({index, static_cast<int>(q), block.tool, query, judgement.wrong});
    }
    return tally;
}

}  // namespace

FuzzTally fuzz(const QuestionFamily& family, const FuzzOptions& options, const std::function<void(double)>& progress) {
    const auto start = std::chrono::steady_clock::now();
    const long blocks = (options.count + queries_per_block - 1) / queries_per_block;
    FuzzTally sum;
    sum.family = family.name;
    std::mutex lock;
    long done = 0;
    in_parallel(static_cast<size_t>(blocks), options.jobs, [&](size_t b) {
        const long before = static_cast<long>(b) * queries_per_block;
        const FuzzTally part = answered(family, options, b, options.count - before);
        const std::lock_guard guard(lock);
        add(sum, part, options.keep);
        progress(static_cast<double>(++done) / static_cast<double>(blocks));
    });
    sum.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return sum;
}

}  // namespace type21
