#include "verification/decisions/fuzz/fuzz_text.h"

#include <fmt/format.h>

namespace type21 {

namespace {

double percent(long part, long whole) {
    return whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

FuzzTally total(const std::vector<FuzzTally>& tallies) {
    FuzzTally sum;
    sum.family = "all";
    for (const FuzzTally& one : tallies) {
        add_counts(sum, one);
        sum.seconds += one.seconds;
    }
    return sum;
}

std::string line(const FuzzTally& one) {
    const long n = one.decisions;
    return fmt::format(
        "{:<16} {:>11} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>9.4f} {:>10} {:>9.0f}\n",
        one.family, n, percent(one.contact, n), percent(one.proximity, n), percent(n - one.contact - one.proximity, n),
        percent(one.near_border, one.margins), percent(one.settled[0], n), percent(one.settled[1], n),
        percent(one.settled[2], n), percent(one.double_wrong, n), one.different,
        one.seconds > 0 ? static_cast<double>(n) / one.seconds : 0);
}

}  // namespace

std::string to_text(const std::vector<FuzzTally>& tallies, const FuzzOptions& options) {
    std::string text = fmt::format("decisions with {}, seed {}; shares in %\n", name(options.method), options.seed);
    text += fmt::format("{:<16} {:>11} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9} {:>10} {:>9}\n", "family",
                        "decisions", "contact", "proxim.", "none", "border", "double", "interval", "exact", "d. wrong",
                        "DIFFERENT", "per s");
    for (const FuzzTally& one : tallies)
        text += line(one);
    if (tallies.size() > 1) text += line(total(tallies));
    text += fmt::format(
        "border: of every {}th decision, those with a margin below 1e6 ulps; these decisions are also compared with\n"
        "rational numbers and with the candidates in reverse order. double, interval, exact: the stage that settled\n"
        "the decision. d. wrong: decisions that plain double would get wrong\n",
        options.full_every);
    for (const FuzzTally& one : tallies)
        for (const FuzzFailure& failure : one.failures)
            text +=
                fmt::format("{}: block {}, query {}: {}\n", one.family, failure.block, failure.number, failure.what);
    return text;
}

nlohmann::ordered_json to_json(const std::vector<FuzzTally>& tallies, const FuzzOptions& options) {
    nlohmann::ordered_json json;
    json["with"] = name(options.method);
    json["seed"] = options.seed;
    json["families"] = nlohmann::ordered_json::array();
    for (const FuzzTally& one : tallies) {
        nlohmann::ordered_json row;
        row["family"] = one.family;
        row["decisions"] = one.decisions;
        row["contact"] = one.contact;
        row["proximity"] = one.proximity;
        row["margins"] = one.margins;
        row["near_border"] = one.near_border;
        row["settled"] = {{"double", one.settled[0]}, {"interval", one.settled[1]}, {"exact", one.settled[2]}};
        row["double_wrong"] = one.double_wrong;
        row["second_opinion_by_exact"] = one.second_by_exact;
        row["different"] = one.different;
        row["seconds"] = one.seconds;
        json["families"].push_back(std::move(row));
    }
    return json;
}

}  // namespace type21
