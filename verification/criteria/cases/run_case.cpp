#include "verification/criteria/cases/run_case.h"

#include <chrono>
#include <exception>

#include "reference/host/prepare_deck.h"

namespace type21 {

CaseOutcome run_case(const CaseRun& run, const std::filesystem::path& folder, const std::string& with) {
    CaseOutcome outcome;
    outcome.folder = folder;
    const auto start = std::chrono::steady_clock::now();
    try {
        const PreparedDeck prepared = prepare_deck(run.deck.string(), run.as_built, true, run.thickness.string());
        for (const Problem& problem : prepared.problems.list())
            outcome.problems.push_back(to_text(problem));
        outcome.refused = !prepared.scene;
        if (prepared.scene) {
            for (const Interface& interface : prepared.scene->model->interfaces)
                outcome.interfaces.push_back(interface.id);
            outcome.summary = run_scene(*prepared.scene, prepared.problems, folder, {}, prepared.options(), with);
        }
    } catch (const std::exception& error) {
        outcome.error = error.what();
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

}  // namespace type21
