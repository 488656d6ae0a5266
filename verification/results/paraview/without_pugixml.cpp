/// @file In place of the writers of .vtu and .pvd where there is no pugixml or no Boost.
#include <stdexcept>

#include "verification/results/paraview/pvd_file.h"
#include "verification/results/paraview/vtu_file.h"

namespace type21 {
namespace {

constexpr const char* reason =
    "this program was built without pugixml and Boost and cannot write files for ParaView; install them (Debian: "
    "libpugixml-dev, libboost-dev) and build it again, or leave out --paraview";

}  // namespace

void write_vtu(const std::filesystem::path&, const VtuGrid&, const std::string&) {
    throw std::runtime_error(reason);
}

PvdFile::PvdFile(const std::filesystem::path&, const std::string&) {
    throw std::runtime_error(reason);
}

void PvdFile::add(double, const std::string&) {
    throw std::runtime_error(reason);
}

}  // namespace type21
