/// @file Writes a time-history file in any of the forms that the format tells.
#pragma once

#include <bit>
#include <cstdint>
#include <fstream>
#include <string>

#include "verification/results/t01/t01_file.h"

namespace type21::test {

class T01Writer {
  public:
    explicit T01Writer(const T01Storage& storage) : storage_(storage) {}

    /// The groups and their values alone: no parts, materials, subsets or global variables. Versions of 3050 and later
    /// have their additional records.
    std::string bytes(const T01File& file) {
        title_length_ = file.code == 3040 ? 40 : file.code == 3041 ? 80 : 100;
        integer(file.code);
        text(file.title, 80);
        end();
        text(file.date, 80);
        end();
        if (file.code >= 3050) additional();
        for (const size_t count : {size_t{0}, size_t{0}, size_t{0}, size_t{0}, file.groups.size(), size_t{0}})
            integer(static_cast<int>(count));
        end();
        for (const T01Group& group : file.groups)
            head(group);
        for (size_t t = 0; t < file.time.size(); ++t) {
            real(file.time[t]);
            end();
            for (const T01Group& group : file.groups)
                values(group, t);
        }
        return out_;
    }

  private:
    void additional() {
        integer(2);
        end();
        integer(title_length_);
        end();
        for (const double unit : {1000.0, 0.001, 1.0})
            real(unit);
        end();
    }

    void head(const T01Group& group) {
        for (const auto number : {group.id, Id{group.type}, Id{0}, static_cast<Id>(group.objects.size()),
                                  static_cast<Id>(group.variables.size())})
            integer(static_cast<int>(number));
        text(group.title, title_length_);
        end();
        for (const Id object : group.objects) {
            integer(static_cast<int>(object));
            text("object", title_length_);
            end();
        }
        for (const int code : group.variables)
            integer(code);
        if (!group.variables.empty()) end();
    }

    void values(const T01Group& group, size_t t) {
        if (group.values.empty()) return;
        for (size_t object = 0; object < group.objects.size(); ++object)
            for (size_t variable = 0; variable < group.variables.size(); ++variable)
                real(group.value(t, object, variable));
        end();
    }

    void word(std::string& to, std::uint32_t value) const {
        for (int i = 0; i < 4; ++i)
            to.push_back(static_cast<char>(value >> (8 * (storage_.big_endian ? 3 - i : i))));
    }
    void integer(int value) { word(record_, static_cast<std::uint32_t>(value)); }
    void real(double value) {
        if (storage_.real_bytes == 4) return word(record_, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
        const auto bits = std::bit_cast<std::uint64_t>(value);
        const auto high = static_cast<std::uint32_t>(bits >> 32);
        const auto low = static_cast<std::uint32_t>(bits);
        word(record_, storage_.big_endian ? high : low);
        word(record_, storage_.big_endian ? low : high);
    }
    void text(std::string value, int characters) {
        value.resize(static_cast<size_t>(characters), ' ');
        for (size_t i = 0; i < value.size(); i += 4) {
            record_ += value.substr(i, 4);
            if (storage_.text_slot == 8) record_ += "    ";
        }
    }
    void end() {
        word(out_, static_cast<std::uint32_t>(record_.size()));
        out_ += record_;
        word(out_, static_cast<std::uint32_t>(record_.size()));
        record_.clear();
    }

    T01Storage storage_;
    int title_length_ = 40;
    std::string record_, out_;
};

/// Every form of storage that the format tells.
inline std::vector<T01Storage> every_storage() {
    std::vector<T01Storage> all;
    for (const bool big_endian : {true, false})
        for (const int slot : {4, 8})
            for (const int real : {4, 8})
                all.push_back({big_endian, slot, real});
    return all;
}

}  // namespace type21::test
