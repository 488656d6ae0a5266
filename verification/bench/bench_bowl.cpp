// Time per node and cycle of the bowl scene: bench_bowl [BLANK TOOL CYCLES THREADS]. Prints minima: others share the
// machine.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <tbb/global_control.h>
#include <vector>

#include <fmt/format.h>

#include "optimized/contact.h"
#include "verification/bench/bowl_scene.h"

namespace {

/// Wall time; of one thread its processor time, since others may share the machine.
class Watch {
  public:
    explicit Watch(bool processor) : processor_(processor), wall_(Clock::now()), ticks_(std::clock()) {}
    double nanoseconds() const {
        if (processor_) return 1e9 * static_cast<double>(std::clock() - ticks_) / CLOCKS_PER_SEC;
        return std::chrono::duration<double, std::nano>(Clock::now() - wall_).count();
    }

  private:
    using Clock = std::chrono::steady_clock;
    bool processor_;
    Clock::time_point wall_;
    std::clock_t ticks_;
};

struct Spread {
    double least, median;
};
Spread spread(std::vector<double> times) {
    std::sort(times.begin(), times.end());
    return {times.front(), times[times.size() / 2]};
}

}  // namespace

int main(int count, char** argument) {
    using namespace type21;
    const auto number = [&](int i, int otherwise) { return i < count ? std::atoi(argument[i]) : otherwise; };
    const int blank = number(1, 316), tool = number(2, 220), cycles = number(3, 300), threads = number(4, 1);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(threads));
    for (const bool friction : {false, true}) {
        bench::BowlScene bowl(blank, tool, friction);
        const Watch start(threads == 1);
        optimized::Contact contact(bowl.scene, 0);
        const double build = start.nanoseconds() * 1e-9;
        const double nodes = static_cast<double>(bowl.scene.model->interfaces[0].secondary.node.size());
        std::vector<double> lean, whole;
        double first = 0, second = 0;
        ContactStep step;
        for (int c = 0; c < cycles; ++c) {
            const Motion motion = bowl.motion(c);
            const Watch from(threads == 1);
            if (c % 10 == 9) {
                contact.step_into(motion, step);
                whole.push_back(from.nanoseconds() / nodes);
            } else {
                contact.step_lean(motion);
                lean.push_back(from.nanoseconds() / nodes);
                if (c == 0) first = lean.back();
                if (c == 1) second = lean.back();
            }
        }
        if (whole.empty()) {
            fmt::print(stderr, "bench_bowl: {} cycles are too few: every tenth is a whole step; give 10 or more\n",
                       cycles);
            return 2;
        }
        const Spread l = spread(lean), w = spread(whole);
        const optimized::PathCounts p = contact.paths();
        const double all = static_cast<double>(p.nodes);
        fmt::print(
            "{} nodes on {} quads, friction {}, {} threads: build {:.3f} s, {} B per quad, {} B per node\n"
            "  lean step  least {:.1f} median {:.1f} ns per node and cycle (first {:.0f}, second {:.0f})\n"
            "  whole step least {:.1f} median {:.1f}\n"
            "  certified {:.2f} %, paired {:.2f} %, quiet {:.2f} %, searched {:.2f} %, whole numbers {:.4f} %\n",
            nodes, tool * tool, friction, threads, build, contact.tool_bytes() / static_cast<size_t>(tool * tool),
            contact.bytes_per_node(), l.least, l.median, first, second, w.least, w.median,
            100 * static_cast<double>(p.certified) / all, 100 * static_cast<double>(p.paired) / all,
            100 * static_cast<double>(p.quiet) / all, 100 * static_cast<double>(p.searched) / all,
            100 * static_cast<double>(p.whole) / all);
    }
    return 0;
}
