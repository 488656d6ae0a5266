#include <memory>
#include <stdexcept>

#include <fmt/format.h>

#include "reference/host/march.h"
#include "verification/performance/bench/bench_scene.h"
#include "verification/support/contact_choice.h"

namespace type21::bench {

namespace {

/// A motion with everything that its spans point to.
struct Recorded {
    std::vector<Vec3> position, velocity;
    std::vector<double> thickness, temperature;
    Motion motion;

    explicit Recorded(const Motion& from)
        : position(from.position.begin(), from.position.end()),
          velocity(from.velocity.begin(), from.velocity.end()),
          thickness(from.thickness.begin(), from.thickness.end()),
          temperature(from.temperature.begin(), from.temperature.end()),
          motion(from) {}
    /// The spans follow where the vectors lie now.
    Motion replay() const {
        Motion out = motion;
        out.position = position;
        out.velocity = velocity;
        out.thickness = thickness;
        out.temperature = temperature;
        return out;
    }
};

/// Thrown to end a march that has shown enough.
struct Enough {};

}  // namespace

BenchScene deck_bench(const HostScene& scene, int interface, int cycles) {
    auto recorded = std::make_shared<std::vector<Recorded>>();
    std::string reason = "it ends";
    try {
        march(scene, contact_maker("optimized"), [&](const CycleRecord& record) {
            recorded->emplace_back(*record.motion);
            if (static_cast<int>(recorded->size()) >= cycles) throw Enough();
        });
    } catch (const Enough&) {
    } catch (const RunStopped& stop) {
        reason = stop.what();
    }
    if (recorded->size() < 3)
        throw std::runtime_error(fmt::format(
            "bench: the deck gives {} cycles ({}); at least 3 are needed to time a step", recorded->size(), reason));
    BenchScene out;
    const Interface& card = scene.model->interfaces[static_cast<size_t>(interface)];
    out.name = scene.model->interfaces.size() == 1 ? scene.host->run_name
                                                   : fmt::format("{}, interface {}", scene.host->run_name, card.id);
    out.title = fmt::format("the first {} cycles of {}", recorded->size(), scene.host->deck_path);
    out.kind = "deck";
    out.scene = scene;
    out.interface = interface;
    out.cycles = static_cast<int>(recorded->size());
    out.motion = [recorded](int cycle) { return (*recorded)[static_cast<size_t>(cycle) % recorded->size()].replay(); };
    return out;
}

}  // namespace type21::bench
