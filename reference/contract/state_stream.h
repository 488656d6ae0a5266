/// @file StateWriter and StateReader: what a run remembers, as plain bytes, for a checkpoint.
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "vector.h"

namespace type21 {

/// The bytes of a state do not fit the object that they are read into.
struct StateError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A number, a truth value or an enumerator: its bytes are its state.
template <class T>
concept PlainNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// A vector or matrix of Eigen of fixed size.
template <class T>
concept PlainMatrix = requires(T& m) {
    m.data();
    m.coeff(0, 0);
    requires T::SizeAtCompileTime >
    0;
};

/// Writes and reads the same list of fields, so that one function serves both:
///
///     template <class Archive>
///     void visit_state(Archive& archive, Node& node) {
///         auto& [offset, cycles] = node;  // a field that is added later does not compile until it is decided on
///         archive(offset, cycles);
///     }
///
/// An archive takes numbers, enumerators, vectors and matrices of Eigen of fixed size, texts, std::vector and
/// std::optional of these, and everything that has a visit_state, as a function or a member. Bytes are those of the
/// machine: they are read by the program that wrote them.
class StateWriter {
  public:
    template <class... T>
    void operator()(T&&... fields) {
        (put(fields), ...);
    }
    const std::string& bytes() const { return bytes_; }

  private:
    void add(const void* data, size_t size) { bytes_.append(static_cast<const char*>(data), size); }

    template <class T>
    void put(T& field) {
        using Field = std::remove_const_t<T>;
        if constexpr (PlainNumber<Field>) {
            add(&field, sizeof field);
        } else if constexpr (PlainMatrix<Field>) {
            add(field.data(), sizeof(typename Field::Scalar) * static_cast<size_t>(Field::SizeAtCompileTime));
        } else if constexpr (std::is_same_v<Field, std::string>) {
            put_size(field.size());
            add(field.data(), field.size());
        } else if constexpr (requires { field.visit_state(*this); }) {
            field.visit_state(*this);
        } else {
            visit_state(*this, field);
        }
    }
    template <class T>
    void put(std::vector<T>& list) {
        put_list(list);
    }
    template <class T>
    void put(const std::vector<T>& list) {
        put_list(list);
    }
    template <class T>
    void put(std::optional<T>& field) {
        const bool there = field.has_value();
        put(there);
        if (there) put(*field);
    }

    template <class List>
    void put_list(List& list) {
        using T = typename List::value_type;
        put_size(list.size());
        if constexpr (PlainNumber<T> && !std::is_same_v<T, bool>) {
            add(list.data(), list.size() * sizeof(T));
        } else {
            for (auto& one : list)
                put(one);
        }
    }
    void put_size(size_t size) {
        const auto count = static_cast<std::uint64_t>(size);
        add(&count, sizeof count);
    }

    std::string bytes_;
};

/// Reads what a StateWriter wrote, into an object that was made of the same scene: lists keep their size.
class StateReader {
  public:
    /// @param bytes  must outlive this
    explicit StateReader(std::string_view bytes) : rest_(bytes) {}

    /// @throws StateError when the bytes end early, or a list or an optional field has another size than in the object
    template <class... T>
    void operator()(T&... fields) {
        (get(fields), ...);
    }
    /// Everything has been read.
    bool at_end() const { return rest_.empty(); }

  private:
    void take(void* data, size_t size) {
        if (size > rest_.size()) throw StateError("it ends early");
        if (size > 0) std::memcpy(data, rest_.data(), size);
        rest_.remove_prefix(size);
    }

    template <class T>
    void get(T& field) {
        if constexpr (PlainNumber<T>) {
            take(&field, sizeof field);
        } else if constexpr (PlainMatrix<T>) {
            take(field.data(), sizeof(typename T::Scalar) * static_cast<size_t>(T::SizeAtCompileTime));
        } else if constexpr (requires { field.visit_state(*this); }) {
            field.visit_state(*this);
        } else {
            visit_state(*this, field);
        }
    }
    void get(std::string& text) {
        const size_t size = get_size();
        if (size > rest_.size()) throw StateError("it ends early");
        text.assign(rest_.substr(0, size));
        rest_.remove_prefix(size);
    }
    template <class T>
    void get(std::vector<T>& list) {
        const size_t size = get_size();
        if (size != list.size())
            throw StateError("a list has " + std::to_string(size) + " entries, not " + std::to_string(list.size()));
        if constexpr (PlainNumber<T> && !std::is_same_v<T, bool>) {
            take(list.data(), size * sizeof(T));
        } else {
            for (T& one : list)
                get(one);
        }
    }
    template <class T>
    void get(std::optional<T>& field) {
        bool there = false;
        get(there);
        if (there != field.has_value()) throw StateError("it is of other effects");
        if (there) get(*field);
    }
    size_t get_size() {
        std::uint64_t count = 0;
        take(&count, sizeof count);
        return static_cast<size_t>(count);
    }

    std::string_view rest_;
};

}  // namespace type21
