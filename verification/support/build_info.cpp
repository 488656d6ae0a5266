#include "verification/support/build_info.h"

#include <fstream>

namespace type21 {
namespace {

std::string cpu_model() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const size_t colon = line.find(':');
        if (line.starts_with("model name") && colon != std::string::npos && colon + 2 <= line.size())
            return line.substr(colon + 2);
    }
    return "unknown";
}

}  // namespace

const BuildInfo& build_info() {
    static const BuildInfo info{TYPE21_VERSION, TYPE21_GIT,        TYPE21_COMPILER,
                                TYPE21_FLAGS,   TYPE21_BUILD_TYPE, cpu_model()};
    return info;
}

std::string program_name() {
    return "type21 " + build_info().version + " (" + build_info().commit + ")";
}

}  // namespace type21
