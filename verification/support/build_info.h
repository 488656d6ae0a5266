/// @file The program that made a result: version, compiler, flags, machine.
#pragma once

#include <string>

namespace type21 {

struct BuildInfo {
    std::string version;     ///< of the project
    std::string commit;      ///< git describe when the build was configured; "unknown" outside a checkout
    std::string compiler;    ///< name and version
    std::string flags;       ///< of the compiler, for this build type
    std::string build_type;  ///< Release, Debug, ...
    std::string cpu;         ///< model name of the processor at hand; "unknown" where the system does not tell
};

const BuildInfo& build_info();
/// "type21 0.1.0 (a9e9f51)".
std::string program_name();

}  // namespace type21
