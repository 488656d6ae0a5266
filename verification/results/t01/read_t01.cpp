#include <cmath>

#include <fmt/format.h>

#include "verification/results/t01/t01_file.h"

namespace type21 {
namespace {

/// Reads the head, then one block a time.
class Reader {
  public:
    explicit Reader(const std::filesystem::path& path) : records_(path) { out_.file = path.string(); }

    T01File read() {
        read_title();
        read_counts();
        read_parts();
        for (std::int64_t i = 0; i < std::int64_t{materials_} + properties_; ++i)
            records_.skip("a material or property", 4 + title_bytes());
        for (int i = 0; i < subsets_; ++i)
            read_subset();
        for (int i = 0; i < groups_; ++i)
            read_group();
        while (!records_.at_end())
            read_time();
        out_.storage = records_.storage();
        return std::move(out_);
    }

  private:
    std::uintmax_t title_bytes() const { return records_.text_bytes(static_cast<std::uintmax_t>(title_length_)); }

    int count(std::size_t& at, const char* what) const {
        const int value = records_.integer(at);
        if (value < 0) records_.fail(fmt::format("{} {} cannot be", value, what));
        return value;
    }

    void read_title() {
        records_.next("code and title of the run", 4 + records_.text_bytes(80));
        std::size_t at = 0;
        out_.code = records_.integer(at);
        out_.title = records_.text(at, 80);
        if (out_.code != 3040 && out_.code != 3041 && out_.code != 3050 && out_.code != 4021)
            records_.fail(fmt::format("the format version {} is not known; 3040, 3041, 3050 and 4021 are", out_.code));
        records_.next("date of the run", records_.text_bytes(80));
        at = 0;
        out_.date = records_.text(at, 80);
        title_length_ = out_.code == 3040 ? 40 : 80;
        if (out_.code >= 3050) read_additional();
    }

    /// Versions that give the length of titles and the units: their number, then one record each.
    void read_additional() {
        records_.next("number of additional records", 4);
        std::size_t at = 0;
        if (const int additional = records_.integer(at); additional != 2)
            records_.fail(fmt::format("{} additional records where 2 are known (length of titles, units)", additional));
        records_.next("length of titles", 4);
        at = 0;
        title_length_ = records_.integer(at);
        if (title_length_ < 4 || title_length_ > 1000 || title_length_ % 4 != 0)
            records_.fail(fmt::format("titles of {} characters cannot be", title_length_));
        records_.next("units of mass, length and time", 12, 24);
    }

    void read_counts() {
        records_.next("six counts (parts, materials, properties, subsets, groups, global variables)", 24);
        std::size_t at = 0;
        parts_ = count(at, "parts");
        materials_ = count(at, "materials");
        properties_ = count(at, "properties");
        subsets_ = count(at, "subsets");
        groups_ = count(at, "groups");
        globals_ = count(at, "global variables");
        if (globals_ > 0) records_.skip("codes of the global variables", 4 * std::uintmax_t(globals_));
    }

    void read_parts() {
        for (int i = 0; i < parts_; ++i) {
            records_.next("a part", 16 + 4 + title_bytes());
            std::size_t at = 4 + title_bytes() + 12;
            const int variables = count(at, "variables of a part");
            if (variables > 0) records_.skip("variable codes of a part", 4 * std::uintmax_t(variables));
            part_variables_ += std::uintmax_t(variables);
        }
    }

    void read_subset() {
        records_.next("a subset", 20 + title_bytes());
        std::size_t at = 8;
        const int children = count(at, "children of a subset");
        const int parts = count(at, "parts of a subset");
        const int variables = count(at, "variables of a subset");
        if (children > 0) records_.skip("children of a subset", 4 * std::uintmax_t(children));
        if (parts > 0) records_.skip("parts of a subset", 4 * std::uintmax_t(parts));
        if (variables > 0) records_.skip("variable codes of a subset", 4 * std::uintmax_t(variables));
        subset_variables_ += std::uintmax_t(variables);
    }

    void read_group() {
        records_.next("a /TH group", 20 + title_bytes());
        std::size_t at = 0;
        T01Group group;
        group.id = records_.integer(at);
        group.type = records_.integer(at);
        at += 4;
        const int objects = count(at, "objects of a /TH group");
        const int variables = count(at, "variables of a /TH group");
        group.title = records_.text(at, title_length_);
        for (int i = 0; i < objects; ++i) {
            records_.next("an object of a /TH group", 4 + title_bytes());
            at = 0;
            group.objects.push_back(records_.integer(at));
        }
        if (variables > 0) records_.next("variable codes of a /TH group", 4 * std::uintmax_t(variables));
        at = 0;
        for (int i = 0; i < variables; ++i)
            group.variables.push_back(records_.integer(at));
        out_.groups.push_back(std::move(group));
    }

    std::uintmax_t reals(std::uintmax_t number) const {
        return number * static_cast<std::uintmax_t>(records_.storage().real_bytes);
    }

    void read_time() {
        if (out_.time.empty()) {
            records_.storage().real_bytes = static_cast<int>(records_.next("the first output time", 4, 8).size());
        } else {
            records_.next("an output time", reals(1));
        }
        std::size_t at = 0;
        const double time = records_.real(at);
        if (!std::isfinite(time)) records_.fail(fmt::format("the output time {} is not finite", time));
        if (!out_.time.empty() && time < out_.time.back())
            records_.fail(fmt::format("the output time {:.9g} comes after {:.9g}", time, out_.time.back()));
        const std::string when = fmt::format(" at t = {:.9g}", time);
        if (globals_ > 0) records_.skip("the global variables" + when, reals(std::uintmax_t(globals_)));
        if (part_variables_ > 0) records_.skip("the part variables" + when, reals(part_variables_));
        if (subset_variables_ > 0) records_.skip("the subset variables" + when, reals(subset_variables_));
        for (T01Group& group : out_.groups)
            read_values(group, when);
        out_.time.push_back(time);
    }

    void read_values(T01Group& group, const std::string& when) {
        const std::uintmax_t number = std::uintmax_t{group.objects.size()} * group.variables.size();
        if (number == 0) return;
        records_.next(fmt::format("the values of /TH group {}", group.id) + when, reals(number));
        if (!group.kept()) return;
        std::size_t at = 0;
        for (std::uintmax_t i = 0; i < number; ++i)
            group.values.push_back(records_.real(at));
    }

    T01Records records_;
    T01File out_;
    int title_length_ = 40;
    int parts_ = 0, materials_ = 0, properties_ = 0, subsets_ = 0, groups_ = 0, globals_ = 0;
    std::uintmax_t part_variables_ = 0, subset_variables_ = 0;
};

}  // namespace

T01File read_t01(const std::filesystem::path& path) {
    return Reader(path).read();
}

}  // namespace type21
