#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "verification/criteria/mutation/score.h"
#include "verification/support/build_info.h"

namespace type21 {

namespace {

std::string place(const MutationVerdict& v) {
    return v.run.empty() ? v.case_name : fmt::format("{}/{}", v.case_name, v.run);
}

}  // namespace

std::string to_text(const std::vector<MutationVerdict>& verdicts) {
    std::string text = fmt::format("{:<28} {:<34} {:<38} {:<28} {:>10}\n", "mutation", "effect", "fails in",
                                   "criterion", "difference");
    size_t killed = 0;
    for (const MutationVerdict& v : verdicts) {
        killed += v.red ? 1 : 0;
        text += v.red ? fmt::format("{:<28} {:<34} {:<38} {:<28} {:>10.3g}\n", v.mutation.name, v.mutation.effect,
                                    place(v), v.criterion, v.difference)
                      : fmt::format("{:<28} {:<34} SURVIVES: {} ({} runs)\n", v.mutation.name, v.mutation.effect,
                                    v.mutation.broken, v.tried);
    }
    text += fmt::format(
        "mutation score: {} of {} make a criterion fail ({:.0f} %)\n", killed, verdicts.size(),
        verdicts.empty() ? 0.0 : 100.0 * static_cast<double>(killed) / static_cast<double>(verdicts.size()));
    return text;
}

nlohmann::ordered_json to_json(const std::vector<MutationVerdict>& verdicts) {
    nlohmann::ordered_json json{{"mutations", nlohmann::ordered_json::array()}};
    size_t killed = 0;
    for (const MutationVerdict& v : verdicts) {
        killed += v.red ? 1 : 0;
        nlohmann::ordered_json one{{"name", v.mutation.name},
                                   {"effect", v.mutation.effect},
                                   {"broken", v.mutation.broken},
                                   {"case", v.case_name},
                                   {"run", v.run},
                                   {"criterion", v.criterion},
                                   {"red", v.red},
                                   {"difference", v.difference},
                                   {"tolerance", v.tolerance},
                                   {"detail", v.detail},
                                   {"tried", v.tried},
                                   {"seconds", v.seconds}};
        if (!std::isfinite(v.difference)) one["difference"] = "inf";
        json["mutations"].push_back(std::move(one));
    }
    const BuildInfo& build = build_info();
    json["killed"] = killed;
    json["all"] = verdicts.size();
    json["program"] = {{"version", build.version}, {"commit", build.commit}, {"cpu", build.cpu}};
    return json;
}

}  // namespace type21
