#include "verification/criteria/cases/digest.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <vector>
#include <xxhash.h>

#include <fmt/format.h>

namespace type21 {
namespace fs = std::filesystem;

namespace {

class Digest {
  public:
    Digest() : state_(XXH3_createState(), &XXH3_freeState) {
        if (!state_ || XXH3_128bits_reset(state_.get()) == XXH_ERROR)
            throw std::runtime_error("no memory for a digest");
    }

    /// Its length goes first: what follows cannot be taken for a part of it.
    void add_text(const std::string& text) {
        const std::uint64_t size = text.size();
        add(&size, sizeof size);
        add(text.data(), text.size());
    }

    void add_file(const fs::path& path) {
        std::ifstream in(path, std::ios::binary);
        std::array<char, 65536> part;
        std::uint64_t size = 0;
        while (in) {
            in.read(part.data(), part.size());
            size += static_cast<std::uint64_t>(in.gcount());
            add(part.data(), static_cast<size_t>(in.gcount()));
        }
        if (!in.eof()) throw std::runtime_error(fmt::format("{} cannot be read", path.string()));
        add(&size, sizeof size);
    }

    std::string text() const {
        const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
        return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
    }

  private:
    void add(const void* data, size_t size) { XXH3_128bits_update(state_.get(), data, size); }

    std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
};

}  // namespace

bool has_digest() {
    return true;
}

std::string digest_of(const fs::path& file_or_folder) {
    Digest digest;
    if (!fs::is_directory(file_or_folder)) {
        digest.add_file(file_or_folder);
        return digest.text();
    }
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(file_or_folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        digest.add_text(file.lexically_relative(file_or_folder).generic_string());
        digest.add_file(file);
    }
    return digest.text();
}

std::string digest_of_text(const std::string& text) {
    Digest digest;
    digest.add_text(text);
    return digest.text();
}

}  // namespace type21
