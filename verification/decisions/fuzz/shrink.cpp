#include "verification/decisions/fuzz/shrink.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace type21 {

namespace {

/// Rounded to so many significant bits.
double rounded(double value, int bits) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    return std::ldexp(std::nearbyint(std::ldexp(fraction, bits)), exponent - bits);
}

class Shrinker {
  public:
    Shrinker(SingleQuery single, const std::function<bool(const SingleQuery&)>& fails)
        : best_(std::move(single)), fails_(fails) {}

    SingleQuery run() {
        bool smaller = true;
        while (smaller) {
            smaller = false;
            smaller |= fewer_segments();
            smaller |= fewer_corners();
            smaller |= fewer_nodes();
            smaller |= simpler_numbers();
        }
        return best_;
    }

  private:
    bool keep_if_failing(const SingleQuery& smaller) {
        if (!fails_(smaller)) return false;
        best_ = smaller;
        return true;
    }

    bool fewer_segments() {
        bool any = false;
        for (size_t s = best_.tool.segment.size(); s-- > 0;) {
            SingleQuery smaller = best_;
            smaller.tool.segment.erase(smaller.tool.segment.begin() + static_cast<long>(s));
            any |= keep_if_failing(smaller);
        }
        return any;
    }

    bool fewer_corners() {
        bool any = false;
        for (size_t s = 0; s < best_.tool.segment.size(); ++s) {
            for (size_t left_out = 0; left_out < 4; ++left_out) {
                std::array<int, 4> corner = best_.tool.segment[s];
                if (corner[2] == corner[3]) break;
                std::rotate(corner.begin(), corner.begin() + static_cast<long>(left_out), corner.end());
                SingleQuery smaller = best_;
                smaller.tool.segment[s] = {corner[1], corner[2], corner[3], corner[3]};
                any |= keep_if_failing(smaller);
            }
        }
        return any;
    }

    /// Leaves out the nodes that no segment has. They cannot matter; it is tried all the same.
    bool fewer_nodes() {
        SingleQuery smaller = best_;
        DecisionTool& tool = smaller.tool;
        for (size_t n = tool.node.size(); n-- > 0;) {
            const int rank = static_cast<int>(n);
            const bool used = std::any_of(tool.segment.begin(), tool.segment.end(), [&](const auto& corner) {
                return std::find(corner.begin(), corner.end(), rank) != corner.end();
            });
            if (used) continue;
            tool.node.erase(tool.node.begin() + static_cast<long>(n));
            tool.normal.erase(tool.normal.begin() + static_cast<long>(n));
            for (auto& corner : tool.segment)
                for (int& c : corner)
                    if (c > rank) --c;
        }
        return tool.node.size() < best_.tool.node.size() && keep_if_failing(smaller);
    }

    /// Every number of the query and its tool, in a fixed order.
    static std::vector<double*> numbers(SingleQuery& single) {
        std::vector<double*> all{&single.query.gap, &single.query.depth, &single.query.proximity_reach};
        for (int i = 0; i < 3; ++i)
            all.push_back(&single.query.point[i]);
        for (std::vector<Vec3>* list : {&single.tool.node, &single.tool.normal})
            for (Vec3& v : *list)
                for (int i = 0; i < 3; ++i)
                    all.push_back(&v[i]);
        return all;
    }

    bool simpler_numbers() {
        bool any = false;
        const size_t count = numbers(best_).size();
        for (size_t i = 0; i < count; ++i) {
            for (const int bits : {0, 1, 2, 4, 8, 16, 24, 32, 40, 48}) {
                SingleQuery simpler = best_;
                double& value = *numbers(simpler)[i];
                const double shorter = bits == 0 ? 0.0 : rounded(value, bits);
                if (shorter == value) break;  // no shorter way to write it
                value = shorter;
                if (!std::isfinite(shorter) || !keep_if_failing(simpler)) continue;
                any = true;
                break;
            }
        }
        return any;
    }

    SingleQuery best_;
    const std::function<bool(const SingleQuery&)>& fails_;
};

}  // namespace

SingleQuery shrink(SingleQuery single, const std::function<bool(const SingleQuery&)>& fails) {
    return Shrinker(std::move(single), fails).run();
}

}  // namespace type21
