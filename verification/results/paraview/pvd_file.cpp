#include "verification/results/paraview/pvd_file.h"

#include <cerrno>
#include <fstream>
#include <pugixml.hpp>
#include <sstream>

#include <fmt/format.h>

#include "verification/support/io_error.h"
#include "verification/support/output_file.h"

namespace type21 {
namespace {

const std::string first = "<?xml version=\"1.0\"?>\n";
const std::string head = "<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
const std::string tail = "</Collection>\n</VTKFile>\n";

std::string entry(double time, const std::string& file) {
    pugi::xml_document xml;
    pugi::xml_node node = xml.append_child("DataSet");
    node.append_attribute("timestep") = fmt::format("{:.17g}", time).c_str();
    node.append_attribute("part") = 0;
    node.append_attribute("file") = file.c_str();
    std::ostringstream text;
    node.print(text, "");
    return text.str();
}

}  // namespace

PvdFile::PvdFile(const std::filesystem::path& path, const std::string& mark) : path_(path) {
    replace_file(path, first + mark + head + tail);
    end_ = static_cast<std::streamoff>(first.size() + mark.size() + head.size());
}

void PvdFile::add(double time, const std::string& file) {
    const std::string text = entry(time, file);
    if (write_at_end(text + tail)) {
        end_ += static_cast<std::streamoff>(text.size());
        return;
    }
    const int reason = errno;
    // The place of the old end is there still.
    write_at_end(tail);
    std::error_code ignored;
    std::filesystem::resize_file(path_, static_cast<std::uintmax_t>(end_) + tail.size(), ignored);
    throw IoError(path_, "cannot be written", reason);
}

bool PvdFile::write_at_end(const std::string& text) const {
    errno = 0;
    std::ofstream file(path_, std::ios::binary | std::ios::in);
    file.seekp(end_);
    file << text;
    file.close();
    return static_cast<bool>(file);
}

}  // namespace type21
