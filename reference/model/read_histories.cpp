#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "reference/deck/text_file.h"
#include "reference/model/numbers.h"
#include "reference/model/reading.h"

namespace type21 {

namespace {

using Names = std::vector<std::string>;
using Groups = std::map<std::string, Names, std::less<>>;

/// The variables of one kind of object in the order in which Radioss writes them, and the names that stand for several.
struct Variables {
    Names all;
    Groups groups;
};

const Variables& interface_variables() {
    static const Variables variables{
        {"FNX",  "FNY",  "FNZ",   "FTX", "FTY", "FTZ", "SFW",   "|FNX|",    "|FNY|",   "|FNZ|",   "||FN||", "|FX|",
         "|FY|", "|FZ|", "||F||", "MX",  "MY",  "MZ",  "QFRIC", "CE_ELAST", "CE_FRIC", "CE_DAMP", "CAREA"},
        {{"DEF", {"FNX", "FNY", "FNZ", "FTX", "FTY", "FTZ"}}}};
    return variables;
}

Names three(const std::string& stem) {
    return {stem + "X", stem + "Y", stem + "Z"};
}

Names joined(const std::vector<Names>& parts) {
    Names all;
    for (const Names& part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

const Variables& node_variables() {
    static const Variables variables{joined({three("D"),
                                             three("V"),
                                             three("A"),
                                             three("VR"),
                                             three("AR"),
                                             {"X", "Y", "Z", "TEMP"},
                                             three("REAC"),
                                             {"REACXX", "REACYY", "REACZZ"},
                                             three("DR")}),
                                     {{"DEF", joined({three("D"), three("V")})},
                                      {"D", three("D")},
                                      {"V", three("V")},
                                      {"A", three("A")},
                                      {"VR", three("VR")},
                                      {"AR", three("AR")},
                                      {"XYZ", {"X", "Y", "Z"}},
                                      {"DR", three("DR")},
                                      {"REAC", joined({three("REAC"), {"REACXX", "REACYY", "REACZZ"}})}}};
    return variables;
}

const Variables& body_variables() {
    static const Variables variables{joined({three("F"),
                                             three("M"),
                                             three("R"),
                                             {"FXI", "FYI", "FZI", "MXI", "MYI", "MZI"},
                                             three("D"),
                                             three("V"),
                                             three("A"),
                                             three("VR"),
                                             three("AR"),
                                             {"X", "Y", "Z"}}),
                                     {{"DEF", joined({three("F"), three("M"), three("R")})},
                                      {"F", three("F")},
                                      {"M", three("M")},
                                      {"R", three("R")},
                                      {"FI", {"FXI", "FYI", "FZI"}},
                                      {"MI", {"MXI", "MYI", "MZI"}},
                                      {"D", three("D")},
                                      {"V", three("V")},
                                      {"A", three("A")},
                                      {"VR", three("VR")},
                                      {"AR", three("AR")},
                                      {"XYZ", {"X", "Y", "Z"}}}};
    return variables;
}

/// Data lines from `line` on that hold names, up to the first that begins with a number: the ids. Returns that line.
size_t read_variables(CardReader& reader, const Variables& known, HistoryRequest& request) {
    size_t line = 1;
    Names wanted;
    for (; line < reader.line_count(); ++line) {
        Id id = 0;
        if (parse_integer(reader.text(line, 1, 10), id) == NumberFault::none) break;
        for (int first = 1; first <= 91; first += 10) {
            const std::string name = upper(reader.text(line, first, first + 9));
            if (name.empty()) continue;
            if (const auto group = known.groups.find(name); group != known.groups.end()) {
                wanted.insert(wanted.end(), group->second.begin(), group->second.end());
            } else if (std::find(known.all.begin(), known.all.end(), name) != known.all.end()) {
                wanted.push_back(name);
            } else {
                reader.warning(static_cast<int>(line), "var", name, "this variable is not known and is not written",
                               "Choose another name, 10 columns each");
            }
        }
    }
    for (const std::string& name : known.all) {
        if (std::find(wanted.begin(), wanted.end(), name) != wanted.end()) request.variables.push_back(name);
    }
    return line;
}

/// A node a line: id, skew_ID, name. The name may touch the skew_ID, so the latter is no field of a reader.
void read_nodes(Reading& reading, CardReader& reader, size_t line, HistoryRequest& request) {
    for (; line < reader.line_count(); ++line) {
        const Id id = reader.integer(line, 1, 10, "node_ID");
        if (id == 0) continue;
        const auto found = reading.model.nodes.index.find(id);
        if (found == reading.model.nodes.index.end()) {
            reader.error(static_cast<int>(line), "node_ID", fmt::format("{}", id), "there is no node with this id",
                         "Add it to /NODE, or correct the id");
            continue;
        }
        const std::string skew = reader.text(line, 11, 20);
        if (!skew.empty() && skew != "0") {
            reader.warning(static_cast<int>(line), "skew_ID", skew, "local axes are not supported here",
                           "The node is written in global axes");
        }
        reader.skip(line, 21, 101);  // the name
        request.objects.push_back(found->second);
    }
}

void read_objects(Reading& reading, CardReader& reader, size_t line, const Registry& registry,
                  HistoryRequest& request) {
    for (const ListedId& listed : listed_ids(reader, line, registry.keyword.substr(1) + "_ID")) {
        const int index =
            reading.reference(reader, listed.line, registry.keyword.substr(1) + "_ID", listed.id, registry, true);
        if (index >= 0) request.objects.push_back(index);
    }
}

/// Temperatures exist only where an interface exchanges heat.
bool is_thermal(const Model& model) {
    return std::any_of(model.interfaces.begin(), model.interfaces.end(),
                       [](const Interface& interface) { return interface.ithe > 0; });
}

void drop_temperature(const Model& model, CardReader& reader, HistoryRequest& request) {
    const auto found = std::find(request.variables.begin(), request.variables.end(), "TEMP");
    if (found == request.variables.end() || is_thermal(model)) return;
    request.variables.erase(found);
    reader.warning(-1, "var", "TEMP",
                   "no interface exchanges heat (Ithe), so there are no temperatures; it is not written",
                   "Take TEMP out, or set Ithe");
}

/// The interfaces as another reader left them, and the ids of those that were refused.
void note_interfaces(Reading& reading) {
    for (size_t i = 0; i < reading.model.interfaces.size(); ++i) {
        const Interface& interface = reading.model.interfaces[i];
        reading.interfaces.entries.emplace(interface.id,
                                           Registry::Entry{static_cast<int>(i), {interface.file, interface.line}});
    }
    for (const ReadCard& entry : reading.cards) {
        Id id = 0;
        if (entry.match.keyword != Keyword::interface || entry.card->words.size() < 3) continue;
        if (parse_integer(entry.card->words[2], id) == NumberFault::none) reading.interfaces.unsupported.insert(id);
    }
}

}  // namespace

/// /TH/INTER, /TH/NODE and /TH/RBODY.
void read_histories(Reading& reading) {
    note_interfaces(reading);
    const auto next = [&] { return static_cast<int>(reading.model.histories.size()); };
    const auto read = [&](Keyword keyword, HistoryRequest::Kind kind, const Variables& known, auto objects) {
        reading.each(keyword, reading.histories, next, [&](CardReader& reader, Id id) {
            HistoryRequest request;
            request.id = id;
            request.kind = kind;
            request.title = reader.text(0, 1, 100);
            const size_t line = read_variables(reader, known, request);
            objects(reader, line, request);
            reading.model.histories.push_back(std::move(request));
        });
    };
    using Kind = HistoryRequest::Kind;
    read(Keyword::history_interface, Kind::interface, interface_variables(),
         [&](CardReader& reader, size_t line, HistoryRequest& request) {
             read_objects(reading, reader, line, reading.interfaces, request);
         });
    read(Keyword::history_node, Kind::node, node_variables(),
         [&](CardReader& reader, size_t line, HistoryRequest& request) {
             read_nodes(reading, reader, line, request);
             drop_temperature(reading.model, reader, request);
         });
    read(Keyword::history_rigid_body, Kind::rigid_body, body_variables(),
         [&](CardReader& reader, size_t line, HistoryRequest& request) {
             read_objects(reading, reader, line, reading.rigid_bodies, request);
         });
}

}  // namespace type21
