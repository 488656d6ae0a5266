#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
// The calls used here are the same in both. Version 4 has not been tried.
#if TYPE21_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "verification/performance/bench/closest_point.h"

namespace type21::bench {

namespace {

struct Free {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, Free>;
using TreeOf = std::unique_ptr<RTCSceneTy, Free>;

/// What a query carries to its callback.
struct Query {
    const std::vector<std::array<Vec3, 3>>* triangle;
    const std::vector<int>* first;  ///< triangle of each segment
    Vec3 p;
    Nearest best;
};

/// The answer in double; the radius shrinks to it, rounded up by more than single precision loses in a coordinate.
bool ask(RTCPointQueryFunctionArguments* arguments) {
    Query& query = *static_cast<Query*>(arguments->userPtr);
    const auto segment = static_cast<size_t>(arguments->primID);
    const int last = (*query.first)[segment + 1];
    bool nearer = false;
    for (int t = (*query.first)[segment]; t < last; ++t) {
        const auto& corner = (*query.triangle)[static_cast<size_t>(t)];
        const double d2 = distance2_to_triangle(query.p, corner[0], corner[1], corner[2]);
        if (!(d2 < query.best.distance2)) continue;
        query.best = {d2, static_cast<int>(segment)};
        nearer = true;
    }
    if (!nearer) return false;
    const double size = query.p.cwiseAbs().maxCoeff();
    const auto radius = static_cast<float>(std::sqrt(query.best.distance2) * (1 + 1e-6) + 4e-7 * size);
    if (!(radius < arguments->query->radius)) return false;
    arguments->query->radius = radius;
    return true;
}

/// Embree tells of each block that it takes or gives back.
bool count_bytes(void* sum, ssize_t bytes, bool) {
    *static_cast<std::atomic<ssize_t>*>(sum) += bytes;
    return true;
}

class ByEmbree final : public ClosestPoint {
  public:
    ByEmbree(const SurfaceMesh& mesh, double reach) : triangle_(mesh.triangles()), reach_(reach) {
        first_.push_back(0);
        bool quads = false;
        for (const auto& s : mesh.segment) {
            first_.push_back(first_.back() + (s[2] == s[3] ? 1 : 4));
            quads = quads || s[2] != s[3];
        }
        // The centre of a quad is a mean of its corners: their box holds it. A triangle repeats its third corner there.
        device_.reset(rtcNewDevice("threads=1"));
        if (!device_) throw std::runtime_error("bench: Embree gives no device");
        rtcSetDeviceMemoryMonitorFunction(device_.get(), count_bytes, &bytes_);
        tree_.reset(rtcNewScene(device_.get()));
        rtcSetSceneBuildQuality(tree_.get(), RTC_BUILD_QUALITY_MEDIUM);
        RTCGeometry shape = rtcNewGeometry(device_.get(), quads ? RTC_GEOMETRY_TYPE_QUAD : RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* x = static_cast<float*>(rtcSetNewGeometryBuffer(shape, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                              3 * sizeof(float), mesh.node.size()));
        for (size_t i = 0; i < mesh.node.size(); ++i)
            for (size_t a = 0; a < 3; ++a)
                x[3 * i + a] = static_cast<float>(mesh.node[i][static_cast<Eigen::Index>(a)]);
        const size_t corners = quads ? 4 : 3;
        auto* at = static_cast<unsigned*>(rtcSetNewGeometryBuffer(shape, RTC_BUFFER_TYPE_INDEX, 0,
                                                                  quads ? RTC_FORMAT_UINT4 : RTC_FORMAT_UINT3,
                                                                  corners * sizeof(unsigned), mesh.segment.size()));
        for (size_t s = 0; s < mesh.segment.size(); ++s)
            for (size_t j = 0; j < corners; ++j)
                at[corners * s + j] = static_cast<unsigned>(mesh.segment[s][j]);
        rtcSetGeometryPointQueryFunction(shape, ask);
        rtcCommitGeometry(shape);
        rtcAttachGeometry(tree_.get(), shape);
        rtcReleaseGeometry(shape);
        rtcCommitScene(tree_.get());
        if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE)
            throw std::runtime_error("bench: Embree could not build its tree");
    }

    Nearest at(const Vec3& p) const override {
        Query query{&triangle_, &first_, p, {std::numeric_limits<double>::infinity(), -1}};
        RTCPointQuery point{};
        point.x = static_cast<float>(p.x());
        point.y = static_cast<float>(p.y());
        point.z = static_cast<float>(p.z());
        point.radius = static_cast<float>(reach_ * (1 + 1e-6) + 4e-7 * p.cwiseAbs().maxCoeff());
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        rtcPointQuery(tree_.get(), &point, &context, nullptr, &query);
        return query.best;
    }
    size_t bytes() const override {
        return static_cast<size_t>(bytes_) + triangle_.size() * sizeof(triangle_[0]) + first_.size() * sizeof(int);
    }

  private:
    std::atomic<ssize_t> bytes_{0};
    std::vector<std::array<Vec3, 3>> triangle_;
    std::vector<int> first_;
    double reach_;
    Device device_;
    TreeOf tree_;
};

}  // namespace

bool has_embree() {
    return true;
}

std::unique_ptr<ClosestPoint> closest_by_embree(const SurfaceMesh& mesh, double reach) {
    return std::make_unique<ByEmbree>(mesh, reach);
}

}  // namespace type21::bench
