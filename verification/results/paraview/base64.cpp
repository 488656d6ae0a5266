#include "verification/results/paraview/base64.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace type21 {

std::string base64(const void* bytes, std::size_t size) {
    using namespace boost::archive::iterators;
    using Encoder = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
    // Whole groups of three bytes: the last one is filled with zeros, and what stands for them becomes padding.
    std::string input(static_cast<const char*>(bytes), size);
    const std::size_t padding = (3 - size % 3) % 3;
    input.append(padding, '\0');
    std::string out(Encoder(input.cbegin()), Encoder(input.cend()));
    out.replace(out.size() - padding, padding, padding, '=');
    return out;
}

}  // namespace type21
