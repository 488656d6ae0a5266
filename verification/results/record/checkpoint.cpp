#include "verification/results/record/checkpoint.h"

#include <cerrno>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "verification/support/build_info.h"
#include "verification/support/checksum.h"
#include "verification/support/io_error.h"
#include "verification/support/output_file.h"

namespace type21 {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
namespace {

// A checkpoint is a line of text, a line of JSON, the state, and a line with the checksum of all before it.
const std::string first_line = "type21 checkpoint 1\n";
constexpr size_t checksum_size = 17;  ///< 16 digits and a line end [byte]

Json to_json(const Checkpoint& checkpoint) {
    Json files = Json::array();
    for (const WrittenFile& file : checkpoint.files)
        files.push_back({{"name", file.name}, {"bytes", file.bytes}, {"checksum", file.checksum}});
    const RunIdentity& identity = checkpoint.identity;
    return {{"run_id", checkpoint.run_id},
            {"cycle", checkpoint.cycle},
            {"time", checkpoint.time},
            {"program", identity.program},
            {"inputs", identity.inputs},
            {"as_built", identity.as_built},
            {"with", identity.with},
            {"paraview", identity.paraview},
            {"files", files},
            {"paraview_times", checkpoint.paraview_times},
            {"state_bytes", checkpoint.state.size()}};
}

/// @throws nlohmann::json::exception
Checkpoint from_json(const Json& json) {
    Checkpoint checkpoint;
    json.at("run_id").get_to(checkpoint.run_id);
    json.at("cycle").get_to(checkpoint.cycle);
    json.at("time").get_to(checkpoint.time);
    json.at("program").get_to(checkpoint.identity.program);
    json.at("inputs").get_to(checkpoint.identity.inputs);
    json.at("as_built").get_to(checkpoint.identity.as_built);
    json.at("with").get_to(checkpoint.identity.with);
    json.at("paraview").get_to(checkpoint.identity.paraview);
    for (const Json& file : json.at("files"))
        checkpoint.files.push_back({file.at("name"), file.at("bytes"), file.at("checksum")});
    json.at("paraview_times").get_to(checkpoint.paraview_times);
    return checkpoint;
}

/// @throws CheckpointError
std::string read_all(const fs::path& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error))
        throw CheckpointError(fmt::format("{}: {}", path.string(), error ? error.message() : "is not a file"));
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file)
        throw CheckpointError(
            fmt::format("{}: cannot be read: {}", path.string(), std::generic_category().message(errno)));
    return text;
}

}  // namespace

RunIdentity identity_of(const std::vector<std::string>& files, const std::string& as_built, const std::string& with,
                        bool paraview) {
    const BuildInfo& build = build_info();
    Checksum inputs;
    for (const std::string& file : files) {
        const std::uint64_t bytes = add_file(inputs, file);
        inputs.add(fmt::format("\n{}\n", bytes));  // so that no line can move from one file to the next unseen
    }
    return {fmt::format("{} ({}), {}, {}", build.version, build.commit, build.compiler, build.flags), inputs.text(),
            as_built, with, paraview};
}

void write_checkpoint(const fs::path& path, const Checkpoint& checkpoint) {
    std::string text = first_line + to_json(checkpoint).dump() + "\n" + checkpoint.state;
    Checksum checksum;
    checksum.add(text);
    replace_file(path, text + checksum.text() + "\n");
}

Checkpoint read_checkpoint(const fs::path& path) {
    const std::string text = read_all(path);
    const auto fail = [&](const char* why) { throw CheckpointError(fmt::format("{}: {}", path.string(), why)); };
    if (!text.starts_with(first_line))
        fail(first_line.starts_with(text) ? "is damaged: it ends early"
                                          : "is not a checkpoint of this version of type21");
    if (text.size() < first_line.size() + checksum_size) fail("is damaged: it ends early");
    const std::string_view body(text.data(), text.size() - checksum_size);
    Checksum checksum;
    checksum.add(body);
    if (std::string_view(text).substr(body.size()) != checksum.text() + "\n")
        fail("is damaged: its checksum does not fit, or it ends early");
    const size_t head_end = text.find('\n', first_line.size());
    try {
        Checkpoint checkpoint = from_json(Json::parse(text.substr(first_line.size(), head_end - first_line.size())));
        checkpoint.state = body.substr(head_end + 1);
        return checkpoint;
    } catch (const nlohmann::json::exception&) {
        throw CheckpointError(fmt::format("{}: is not a checkpoint of this version of type21", path.string()));
    }
}

void require_same(const fs::path& path, const RunIdentity& then, const RunIdentity& now) {
    std::string reasons;
    const auto compare = [&](bool same, const std::string& reason) {
        if (!same) reasons += fmt::format("\n  {}", reason);
    };
    compare(then.inputs == now.inputs,
            "the deck has changed since then: its starter or engine deck, a file that it includes, or --thickness");
    compare(then.as_built == now.as_built,
            fmt::format("--as-built was {}, and is {} now", then.as_built, now.as_built));
    compare(then.with == now.with, fmt::format("--with was {}, and is {} now", then.with, now.with));
    compare(then.paraview == now.paraview,
            then.paraview ? "--paraview was given then" : "--paraview was not given then");
    compare(then.program == now.program, fmt::format("the program was {}, and is {} now", then.program, now.program));
    if (!reasons.empty())
        throw CheckpointError(
            fmt::format("{}: the run cannot go on from here, since its results would not be those of one run:{}",
                        path.string(), reasons));
}

void copy_histories(const fs::path& path, const Checkpoint& checkpoint, const fs::path& into) {
    for (const WrittenFile& file : checkpoint.files) {
        const fs::path from = path.parent_path() / file.name;
        errno = 0;
        std::ifstream in(from, std::ios::binary);
        if (!in)
            throw CheckpointError(fmt::format("{}: belongs to the checkpoint {} and cannot be read: {}", from.string(),
                                              path.string(), std::generic_category().message(errno)));
        OutputFile out(into / file.name, OutputFile::Start::create);
        std::string part(1 << 18, '\0');
        std::uint64_t left = file.bytes;
        while (left > 0 && in) {
            in.read(part.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(part.size(), left)));
            const auto count = static_cast<size_t>(in.gcount());
            out.write(std::string_view(part).substr(0, count));
            left -= count;
        }
        out.close();
        if (left > 0 || out.checksum() != file.checksum)
            throw CheckpointError(fmt::format("{}: is not as it was at the checkpoint {}: it has been {}",
                                              from.string(), path.string(), left > 0 ? "cut off" : "changed"));
    }
}

}  // namespace type21
