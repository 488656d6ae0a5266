#include "verification/decisions/atlas/atlas.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "verification/decisions/queries/decision_json.h"
#include "verification/decisions/queries/decision_text.h"
#include "verification/support/json_file.h"
#include "verification/support/shown_text.h"

namespace type21 {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const fs::path& folder, const std::vector<std::string>& names,
                               std::vector<std::string>& problems) {
    std::vector<fs::path> files;
    for (const std::string& name : names)
        files.push_back(folder / (name + ".json"));
    std::error_code error;
    if (names.empty())
        for (const auto& entry : fs::directory_iterator(folder, error))
            if (entry.path().extension() == ".json") files.push_back(entry.path());
    if (files.empty()) problems.push_back(fmt::format("{}: there are no entries (*.json)", folder.string()));
    std::sort(files.begin(), files.end());
    return files;
}

/// The parts that the format of decide does not have. Only called for a file that has the format.
void read_words(const nlohmann::json& json, JsonReader& reader, AtlasEntry& entry) {
    const auto words = [&](const char* key, const char* what) {
        const nlohmann::json* text = reader.member(json, key, "", what);
        return text ? reader.text(*text, json_place("", key)) : std::string();
    };
    entry.title = words("title", "a text");
    entry.what = words("what", "one sentence");
    const std::string place = "/blocks/0";
    const nlohmann::json& block = json.at("blocks").at(0);
    if (block.contains("note")) {
        const nlohmann::json& notes = reader.list(block, "note", place);
        for (size_t i = 0; i < notes.size(); ++i)
            entry.note.push_back(reader.text(notes[i], json_place(place + "/note", i)));
    }
    if (entry.note.size() != entry.block.queries.size())
        reader.complain(place + "/note",
                        fmt::format("{} notes for {} queries", entry.note.size(), entry.block.queries.size()));
    if (block.contains("double")) entry.double_answers = read_answers(reader, block, "double", place, entry.block);
}

}  // namespace

std::vector<AtlasEntry> read_atlas(const fs::path& folder, const std::vector<std::string>& names,
                                   std::vector<std::string>& problems) {
    std::vector<AtlasEntry> entries;
    for (const fs::path& file : files_of(folder, names, problems)) {
        const std::string name = shown(file.string(), 400);
        const std::optional<nlohmann::json> json = read_json(file, problems);
        if (!json) continue;
        const size_t before = problems.size();
        const DecisionFile read = decisions_of(*json, name, problems);
        if (problems.size() > before) continue;
        JsonReader reader(name, problems);
        if (read.blocks.size() != 1 || read.blocks[0].answers.empty()) {
            reader.complain("/blocks", "an entry of the atlas is one block with answers");
            continue;
        }
        AtlasEntry& entry = entries.emplace_back();
        entry.name = file.stem().string();
        entry.block = read.blocks[0];
        entry.warnings = warnings(entry.block.tool);
        read_words(*json, reader, entry);
    }
    return entries;
}

std::vector<AtlasAnswer> answers_of(const AtlasEntry& entry, DecideWith method) {
    std::vector<AtlasAnswer> answers;
    for (size_t q = 0; q < entry.block.queries.size(); ++q) {
        const ContactQuery& query = entry.block.queries[q];
        AtlasAnswer& one = answers.emplace_back();
        one.program = decide(entry.block.tool, query, method);
        one.program.margin = margin(entry.block.tool, query);
        one.program.margin_ulps = in_ulps(one.program.margin, query.point);
        one.plain = decide(entry.block.tool, query, DecideWith::plain);
        one.ok = one.program.same_decision(entry.block.answers[q]);
    }
    return answers;
}

std::string to_text(const AtlasEntry& entry, const std::vector<AtlasAnswer>& answers) {
    std::string text = fmt::format("{}: {}\n  {}\n", entry.name, entry.title, entry.what);
    for (const std::string& warning : entry.warnings)
        text += fmt::format("  warning: {}\n", warning);
    for (size_t q = 0; q < answers.size(); ++q) {
        const AtlasAnswer& one = answers[q];
        text +=
            fmt::format("  {:<44} {}; settled by {}, margin {:.3g} ({:.3g} ulps)\n", entry.note[q] + ":",
                        in_words(one.program), name(one.program.stage), one.program.margin, one.program.margin_ulps);
        if (!one.plain.same_decision(entry.block.answers[q]))
            text += fmt::format("  {:<44} plain double: {}\n", "", in_words(one.plain));
        if (!one.ok) text += fmt::format("  {:<44} WRONG, exact: {}\n", "", in_words(entry.block.answers[q]));
    }
    return text;
}

nlohmann::ordered_json to_json(const AtlasEntry& entry, const std::vector<AtlasAnswer>& answers) {
    const auto bare = [](const DecisionAnswer& answer) {
        nlohmann::ordered_json json = to_json(answer);
        for (const char* key : {"stage", "margin", "margin_ulps"})
            json.erase(key);
        return json;
    };
    DecisionFile file;
    file.blocks = {entry.block};
    nlohmann::ordered_json block = to_json(file)["blocks"][0];
    block["answers"] = nlohmann::ordered_json::array();
    block["double"] = nlohmann::ordered_json::array();
    block["program"] = nlohmann::ordered_json::array();
    for (size_t q = 0; q < answers.size(); ++q) {
        block["answers"].push_back(bare(entry.block.answers[q]));
        block["double"].push_back(bare(answers[q].plain));
        block["program"].push_back(to_json(answers[q].program));
        block["program"].back()["ok"] = answers[q].ok;
    }
    nlohmann::ordered_json json;
    json["name"] = entry.name;
    json["title"] = entry.title;
    json["what"] = entry.what;
    json["warnings"] = entry.warnings;
    block["note"] = entry.note;
    json["blocks"] = nlohmann::ordered_json::array({std::move(block)});
    return json;
}

}  // namespace type21
