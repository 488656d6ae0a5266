/// @file Which run wrote a file: the run id, in run.json and in every other file of a result.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace type21 {

/// Version of the files of a result: their names, columns and keys. results/README.md says what it stands for.
constexpr int result_schema = 1;

/// A new id, 36 characters, unlike any other: a random UUID (RFC 9562, version 4).
std::string new_run_id();

/// The last line of a CSV, "# type21 schema 1 run <id>", with its line end. It stands last, since readers take the
/// first line for the header; they skip it as a comment.
std::string csv_mark(std::string_view run_id);
/// The same as an XML comment, in the second line of the files for ParaView.
std::string xml_mark(std::string_view run_id);

/// The run id in the mark of a CSV, a .pvd or a .vtu; empty where there is none.
std::string run_id_in(const std::filesystem::path& file);

/// What the files of a result folder say of the run that wrote them.
struct RunFolderCheck {
    bool is_run = false;                ///< there is a run.json of type21
    std::string run_id;                 ///< of run.json; empty in a result of a version without ids
    std::string status;                 ///< of run.json: "completed", "interrupted", ...
    std::vector<std::string> problems;  ///< files of another run or of none, with the reason

    bool finished() const { return status == "completed"; }
};

/// Checks that all files of a folder are of one run. A folder without a run.json of type21, such as that of a case, is
/// no run and has no problems.
RunFolderCheck check_run_id(const std::filesystem::path& folder);

}  // namespace type21
