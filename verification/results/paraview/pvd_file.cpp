#include "verification/results/paraview/pvd_file.h"

#include <fstream>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

namespace type21 {
namespace {

const std::string head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
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

PvdFile::PvdFile(const std::filesystem::path& path) : path_(path) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << head << tail;
    file.close();
    if (!file) throw std::runtime_error(fmt::format("{}: cannot be written", path_.string()));
    end_ = static_cast<std::streamoff>(head.size());
}

void PvdFile::add(double time, const std::string& file) {
    const std::string text = entry(time, file);
    if (write_at_end(text + tail)) {
        end_ += static_cast<std::streamoff>(text.size());
        return;
    }
    // The place of the old end is there still.
    write_at_end(tail);
    std::error_code ignored;
    std::filesystem::resize_file(path_, static_cast<std::uintmax_t>(end_) + tail.size(), ignored);
    throw std::runtime_error(fmt::format("{}: writing failed (disk full?)", path_.string()));
}

bool PvdFile::write_at_end(const std::string& text) const {
    std::ofstream file(path_, std::ios::binary | std::ios::in);
    file.seekp(end_);
    file << text;
    file.close();
    return static_cast<bool>(file);
}

}  // namespace type21
