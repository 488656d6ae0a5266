#include <malloc.h>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include "verification/performance/bench/closest_point.h"

namespace type21::bench {

namespace {

template <class Kernel>
class ByCgal final : public ClosestPoint {
    using Triangle = typename Kernel::Triangle_3;
    using Point = typename Kernel::Point_3;
    using Iterator = typename std::vector<Triangle>::const_iterator;
    using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Iterator>>>;

  public:
    explicit ByCgal(const SurfaceMesh& mesh) {
        const size_t before = in_use();
        for (size_t s = 0; s < mesh.segment.size(); ++s)
            segment_.insert(segment_.end(), mesh.segment[s][2] == mesh.segment[s][3] ? 1 : 4, static_cast<int>(s));
        for (const auto& t : mesh.triangles())
            triangle_.emplace_back(point(t[0]), point(t[1]), point(t[2]));
        tree_.insert(triangle_.cbegin(), triangle_.cend());
        tree_.build();
        tree_.accelerate_distance_queries();
        // Its second tree is built by the first question.
        tree_.closest_point(triangle_.front().vertex(0));
        bytes_ = in_use() - before;
    }
    Nearest at(const Vec3& p) const override {
        const auto [q, at] = tree_.closest_point_and_primitive(point(p));
        const Vec3 way(p.x() - q.x(), p.y() - q.y(), p.z() - q.z());
        return {way.squaredNorm(), segment_[static_cast<size_t>(at - triangle_.cbegin())]};
    }
    size_t bytes() const override { return bytes_; }

  private:
    static size_t in_use() {
        const auto info = mallinfo2();
        return info.uordblks + info.hblkhd;
    }
    static Point point(const Vec3& v) { return Point(v.x(), v.y(), v.z()); }

    std::vector<Triangle> triangle_;
    std::vector<int> segment_;
    Tree tree_;
    size_t bytes_ = 0;
};

}  // namespace

std::unique_ptr<ClosestPoint> closest_by_cgal_double(const SurfaceMesh& mesh) {
    return std::make_unique<ByCgal<CGAL::Simple_cartesian<double>>>(mesh);
}
std::unique_ptr<ClosestPoint> closest_by_cgal_epick(const SurfaceMesh& mesh) {
    return std::make_unique<ByCgal<CGAL::Exact_predicates_inexact_constructions_kernel>>(mesh);
}

}  // namespace type21::bench
