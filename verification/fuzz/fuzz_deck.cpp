// libFuzzer on the deck reader: any text is read or refused, never a crash, a hang or a leak.
#include <algorithm>
#include <cstring>

#include "verification/fuzz/deck_input.h"
#include "verification/fuzz/deck_mutator.h"

extern "C" {

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    // Both ways to resolve, one for each input.
    const auto departures = size % 2 == 0 ? type21::AsBuilt() : type21::AsBuilt::all();
    type21::fuzz::read_and_resolve(text, departures);
    return 0;
}

/// Three of four changes are of lines and fields, else libFuzzer's own of bytes.
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
    if (seed % 4 == 0) return LLVMFuzzerMutate(data, size, max_size);
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::string changed = type21::fuzz::mutated(text, seed);
    const std::size_t length = std::min(changed.size(), max_size);
    std::memcpy(data, changed.data(), length);
    return length;
}
}
