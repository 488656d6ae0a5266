#include "verification/criteria/mutation/score.h"

#include <algorithm>
#include <chrono>
#include <mutex>

#include <fmt/format.h>

#include "reference/host/prepare_deck.h"
#include "verification/criteria/cases/evaluate.h"
#include "verification/decisions/queries/decision_json.h"
#include "verification/support/contact_choice.h"
#include "verification/support/in_parallel.h"

namespace type21 {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// One run of a case, with the criteria that hold without a mutation.
struct SoundRun {
    const Case* a_case = nullptr;
    size_t run = 0;
    PreparedDeck deck;
    std::vector<const Criterion*> criteria;
    double seconds = 0;
};

CaseOutcome outcome_of(const SoundRun& one, const fs::path& folder, const MakeContact& make) {
    CaseOutcome outcome;
    outcome.folder = folder;
    const auto start = Clock::now();
    for (const Interface& interface : one.deck.scene->model->interfaces)
        outcome.interfaces.push_back(interface.id);
    try {
        outcome.summary = run_scene(*one.deck.scene, one.deck.problems, folder, {}, one.deck.options(), make);
    } catch (const std::exception& error) {
        outcome.error = error.what();
    }
    outcome.seconds = since(start);
    return outcome;
}

std::vector<SoundRun> sound_runs(const std::vector<Case>& cases, const ScoreOptions& options) {
    std::vector<SoundRun> runs;
    for (const Case& a_case : cases)
        for (size_t r = 0; r < a_case.runs.size(); ++r)
            runs.push_back({&a_case, r, {}, {}, 0});
    in_parallel(runs.size(), options.jobs, [&](size_t i) {
        SoundRun& one = runs[i];
        const CaseRun& run = one.a_case->runs[one.run];
        one.deck = prepare_deck(run.deck.string(), run.as_built, true, run.thickness.string());
        if (!one.deck.scene) return;
        const CaseOutcome outcome =
            outcome_of(one, options.scratch / fmt::format("sound_{}", i), contact_maker(options.with));
        one.seconds = outcome.seconds;
        for (const Criterion& criterion : one.a_case->criteria)
            if (criterion.run == one.run && evaluate(*one.a_case, criterion, outcome).ok)
                one.criteria.push_back(&criterion);
        fs::remove_all(outcome.folder);
    });
    std::erase_if(runs, [](const SoundRun& run) { return !run.deck.scene || run.criteria.empty(); });
    std::stable_sort(runs.begin(), runs.end(),
                     [](const SoundRun& a, const SoundRun& b) { return a.seconds < b.seconds; });
    return runs;
}

bool concerns(const Mutation& mutation, const SoundRun& run) {
    for (size_t i = 0; i < run.deck.scene->model->interfaces.size(); ++i)
        if (mutation.concerns(*run.deck.scene, static_cast<int>(i))) return true;
    return false;
}

void judge_by_cases(const std::vector<SoundRun>& runs, const fs::path& folder, const ScoreOptions& options,
                    MutationVerdict& verdict) {
    const Mutation& mutation = verdict.mutation;
    const MakeContact sound = contact_maker(options.with);
    for (const SoundRun& run : runs) {
        if (!concerns(mutation, run)) continue;
        const MakeContact broken = [&](const Scene& scene, int i) {
            return mutation.concerns(*run.deck.scene, i) ? mutation.contact(scene, i, sound) : sound(scene, i);
        };
        ++verdict.tried;
        const CaseOutcome outcome = outcome_of(run, folder, broken);
        if (!outcome.error.empty()) {
            // A mutation that cannot compute shows nothing.
            verdict.detail = outcome.error;
            continue;
        }
        for (const Criterion* criterion : run.criteria) {
            const CriterionResult result = evaluate(*run.a_case, *criterion, outcome);
            if (result.ok) continue;
            verdict.red = true;
            verdict.case_name = run.a_case->name;
            verdict.run = run.a_case->runs[run.run].name;
            verdict.criterion = result.id;
            verdict.difference = result.difference;
            verdict.tolerance = result.tolerance;
            verdict.detail = result.detail;
            return;
        }
    }
}

void judge_by_decisions(const std::vector<DecisionFile>& files, MutationVerdict& verdict) {
    for (const DecisionFile& file : files) {
        ++verdict.tried;
        for (size_t b = 0; b < file.blocks.size(); ++b) {
            const DecisionBlock& block = file.blocks[b];
            for (size_t q = 0; q < block.answers.size(); ++q) {
                const DecisionAnswer answer = verdict.mutation.decision(block.tool, block.queries[q]);
                verdict.difference += 1;
                if (answer.same_decision(block.answers[q])) continue;
                verdict.red = true;
                verdict.case_name = fmt::format("decisions/{}", file.family);
                verdict.criterion = fmt::format("block {}, query {}", b, q);
                verdict.detail = fmt::format(
                    "after {} right answers: {} segment {} triangle {}, the truth: {} segment "
                    "{} triangle {}",
                    verdict.difference - 1, name(answer.kind), answer.segment, answer.triangle,
                    name(block.answers[q].kind), block.answers[q].segment, block.answers[q].triangle);
                return;
            }
        }
    }
}

/// Small files first.
std::vector<DecisionFile> truth_files(const fs::path& folder) {
    std::vector<std::pair<std::uintmax_t, fs::path>> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".json") paths.emplace_back(entry.file_size(), entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<DecisionFile> files;
    std::vector<std::string> problems;
    for (const auto& [size, path] : paths)
        files.push_back(read_decisions(path, problems));
    if (!problems.empty()) throw std::runtime_error(problems.front());
    return files;
}

}  // namespace

std::vector<MutationVerdict> score(const std::vector<Mutation>& mutations, const std::vector<Case>& cases,
                                   const ScoreOptions& options) {
    const auto has = [&](auto part) { return std::any_of(mutations.begin(), mutations.end(), part); };
    std::vector<SoundRun> runs;
    std::vector<DecisionFile> files;
    if (has([](const Mutation& m) { return m.contact != nullptr; })) runs = sound_runs(cases, options);
    if (has([](const Mutation& m) { return m.decision != nullptr; })) files = truth_files(options.decisions);
    std::vector<MutationVerdict> verdicts(mutations.size());
    std::mutex reporting;
    in_parallel(mutations.size(), options.jobs, [&](size_t i) {
        MutationVerdict& verdict = verdicts[i];
        verdict.mutation = mutations[i];
        const auto start = Clock::now();
        const fs::path folder = options.scratch / mutations[i].name;
        if (mutations[i].decision)
            judge_by_decisions(files, verdict);
        else
            judge_by_cases(runs, folder, options, verdict);
        std::error_code ignored;
        fs::remove_all(folder, ignored);
        verdict.seconds = since(start);
        const std::lock_guard<std::mutex> lock(reporting);
        if (options.progress) options.progress(verdict);
    });
    return verdicts;
}

}  // namespace type21
