/// @file A whole time-history file: what it records and the values over time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reference/contract/mesh.h"
#include "verification/results/t01/t01_records.h"

namespace type21 {

/// One /TH group.
struct T01Group {
    /// Types of the format.
    static constexpr int node = 0;
    static constexpr int interface = 101;
    static constexpr int rigid_wall = 102;
    static constexpr int rigid_body = 103;

    Id id = 0;
    int type = 0;
    std::string title;
    std::vector<Id> objects;     ///< ids, in the order of the file
    std::vector<int> variables;  ///< codes, in the order of the file
    std::vector<double> values;  ///< [time][object][variable]; only of nodes and interfaces

    bool kept() const { return type == node || type == interface; }
    double value(size_t time, size_t object, size_t variable) const {
        return values[(time * objects.size() + object) * variables.size() + variable];
    }
};

struct T01File {
    std::string file;
    int code = 0;             ///< version of the format: 3040, 3041, 3050, 4021
    std::string title, date;  ///< of the run, and when and by what it was made
    T01Storage storage;
    std::vector<double> time;  ///< finite, not decreasing [time]
    std::vector<T01Group> groups;
};

/// Global, part and subset variables are passed over. Memory is bounded by the size of the file.
/// Measured files are of version 3040 (/TFILE/1 and /TFILE/4); the others follow the description of the format.
/// @throws T01Error
T01File read_t01(const std::filesystem::path& path);

}  // namespace type21
