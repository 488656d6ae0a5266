// libFuzzer on the deck reader: any text is read or refused, never a crash, a hang or a leak.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "verification/decisions/deck_fuzz/deck_input.h"
#include "verification/decisions/deck_fuzz/deck_mutator.h"

namespace {

/// An input that keeps the processor longer than this is a hang. Wall time would blame a busy machine on the reader.
constexpr double hang = 1.0;  // [s]

double processor_seconds() {
    std::timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

extern "C" {

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    // Both ways to resolve, one for each input.
    const auto departures = size % 2 == 0 ? type21::AsBuilt() : type21::AsBuilt::all();
    const double start = processor_seconds();
    type21::fuzz::read_and_resolve(text, departures);
    const double used = processor_seconds() - start;
    if (used > hang) {
        std::fprintf(stderr, "ERROR: hang: %g s of the processor for one input\n", used);
        std::abort();
    }
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
