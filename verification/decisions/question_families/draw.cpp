#include "verification/decisions/question_families/draw.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace type21 {

Draw::Draw(std::string_view name, std::uint64_t seed, std::uint64_t index) : state_(0xcbf29ce484222325ULL) {
    // FNV-1a over the name, then a step of the generator for each number.
    for (const char letter : name)
        state_ = (state_ ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
    state_ ^= seed;
    state_ = bits() ^ index;
    state_ = bits();
}

std::uint64_t Draw::bits() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

double Draw::unit() {
    return static_cast<double>(bits() >> 11) * 0x1p-53;
}

int Draw::below(int count) {
    return static_cast<int>((bits() >> 32) * static_cast<std::uint64_t>(count) >> 32);
}

Vec3 Draw::in_cube() {
    const double x = between(-1, 1);
    const double y = between(-1, 1);
    const double z = between(-1, 1);
    return {x, y, z};
}

double Draw::power_of_two(int low, int high) {
    return std::ldexp(1.0, low + below(high - low + 1));
}

double moved(double value, int ulps) {
    const double goal = ulps < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
    for (int i = 0; i < std::abs(ulps); ++i)
        value = std::nextafter(value, goal);
    return value;
}

Turn turn(double degrees) {
    // Series of the angle halved four times, then doubled four times: cos 2x = 1 - 2 sin^2 x, sin 2x = 2 sin x cos x.
    const double x = degrees / 16 * 0.017453292519943295;
    double cosine = 1;
    double sine = x;
    double term = x;
    for (int n = 2; n <= 24; ++n) {
        term = term * x / n;
        const double signed_term = n % 4 < 2 ? term : -term;
        (n % 2 == 0 ? cosine : sine) += signed_term;
    }
    for (int i = 0; i < 4; ++i) {
        const double doubled = 2 * sine * cosine;
        cosine = 1 - 2 * sine * sine;
        sine = doubled;
    }
    return {cosine, sine};
}

Vec3 unit_vector(const Vec3& v) {
    const double largest = v.cwiseAbs().maxCoeff();
    if (!(largest > 0)) return Vec3::Zero();
    // Two steps, since the inverse of a denormal number is infinite.
    const Vec3 scaled(v.x() / largest, v.y() / largest, v.z() / largest);
    const double length = std::sqrt((scaled.x() * scaled.x() + scaled.y() * scaled.y()) + scaled.z() * scaled.z());
    return {scaled.x() / length, scaled.y() / length, scaled.z() / length};
}

}  // namespace type21
