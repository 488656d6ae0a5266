// One node over one quad of the tool, in plain double: from the normals to the force, with nothing but the formulation.
//   usage: one_node [X Y Z]     the node [mm]; default 0.3 0.2 0.1
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

struct V {
    double x, y, z;
    friend V operator+(V u, V v) { return {u.x + v.x, u.y + v.y, u.z + v.z}; }
    friend V operator-(V u, V v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
    friend V operator*(double f, V v) { return {f * v.x, f * v.y, f * v.z}; }
    friend V operator/(V v, double f) { return {v.x / f, v.y / f, v.z / f}; }
    friend double dot(V u, V v) { return u.x * v.x + (u.y * v.y + u.z * v.z); }
    friend V cross(V u, V v) { return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x}; }
    friend V unit(V v) { return v / std::sqrt(dot(v, v)); }
    friend V mean(const std::array<V, 4>& v) { return (v[0] + v[1] + v[2] + v[3]) / 4; }
};
struct Weights {
    double b, c;
    /// Of q in the triangle (a, b, c).
    static Weights of(V q, V a, V b, V c) {
        const V n = cross(b - a, c - a);
        return {-dot(n, cross(a - q, c - q)) / dot(n, n), dot(n, cross(a - q, b - q)) / dot(n, n)};
    }
    bool inside() const { return b >= -0.01 && c >= -0.01 && b + c <= 1.01; }
};

int main(int count, char** word) {
    const bool given = count == 4;
    const V p{given ? std::atof(word[1]) : 0.3, given ? std::atof(word[2]) : 0.2, given ? std::atof(word[3]) : 0.1};
    const std::array<V, 4> x{V{0, 0, 0}, V{1, 0, 0}, V{1, 1, 0.25}, V{0, 1, 0}};  // the quad, one corner raised [mm]
    const double gap = 0.5, depth = 1, stiffness = 100;                           // [mm], [mm], [N/mm]

    // Formulation 1, steps 3 to 5: a normal at each corner, of the four sub-triangles round the mean of the corners.
    const V centre = mean(x);
    std::array<V, 4> normal{};
    for (int k = 0; k < 4; ++k)
        for (int j : {k, (k + 1) % 4})
            normal[j] = normal[j] + unit(cross(x[k] - centre, x[(k + 1) % 4] - centre));
    for (V& n : normal)
        n = unit(n);

    int retained = 0;
    double least = 0, distance = 0;
    V direction{};
    for (int k = 1; k <= 4; ++k) {
        const V a = centre, b = x[k - 1], c = x[k % 4], n_a = mean(normal), n_b = normal[k - 1], n_c = normal[k % 4];
        const V area = cross(b - a, c - a);
        // Formulation 3, step 1: lift the corners along their normals to the height of the node.
        const double height = dot(p - a, area);
        if (height != 0 && (dot(n_a, area) <= 0 || dot(n_b, area) <= 0 || dot(n_c, area) <= 0)) continue;
        const auto lift = [&](V v, V n) { return height == 0 ? v : v + height / dot(n, area) * n; };
        const V up_a = lift(a, n_a), up_b = lift(b, n_b), up_c = lift(c, n_c);
        // Step 2: the node must lie in the lifted triangle.
        const Weights up = Weights::of(p, up_a, up_b, up_c);
        std::printf("sub-triangle %d: step 2 b' = %.4f, c' = %.4f\n", k, up.b, up.c);
        if (dot(cross(up_b - up_a, up_c - up_a), area) <= 0 || !up.inside()) continue;
        // Step 3: interpolate the normal there and follow it down to the sub-triangle.
        const V n = (1 - up.b - up.c) * n_a + up.b * n_b + up.c * n_c;
        const double slope = dot(n, area);
        const Weights down = Weights::of(p - height / slope * n, a, b, c);
        if (slope <= 0 || !down.inside()) continue;
        const auto clip = [](double w) { return std::fmin(std::fmax(w, 0), 1); };
        // Steps 4 and 5: near enough to the clipped point? In front the gap counts, behind DEPTH.
        const double w_a = clip(1 - down.b - down.c), w_b = clip(down.b), w_c = clip(down.c);
        const V offset = p - (w_a * a + w_b * b + w_c * c) / (w_a + w_b + w_c);
        const double limit = dot(offset, area) >= 0 ? gap : depth;
        if (dot(offset, offset) >= limit * limit) continue;
        // Step 6 and Formulation 4, steps 3 and 4: the most central one is retained, the first of equal ones.
        const double third = 1.0 / 3;
        const double kappa =
            std::abs(third - down.b) + std::abs(third - down.c) + std::abs(2 * third - down.b - down.c);
        std::printf("  taken: b = %.4f, c = %.4f, kappa = %.4f\n", down.b, down.c, kappa);
        if (retained != 0 && kappa >= least) continue;
        retained = k;
        least = kappa;
        // Formulation 5, steps 2 and 3: the normal of the contact, and the distance along it.
        direction = unit(n);
        distance = height * std::sqrt(dot(n, n)) / slope;
    }
    if (retained == 0) return std::puts("retained: none, no force"), 0;
    // Formulation 5, step 4 and 7, step 2. At time 0 there is no offset yet, and the elastic force acts in full.
    const double penetration = std::fmax(gap - distance, 0);
    const V force = stiffness * penetration * direction;
    std::printf("retained: sub-triangle %d, distance %.6f, penetration %.6f\n", retained, distance, penetration);
    std::printf("force on the node: %.6f %.6f %.6f\n", force.x, force.y, force.z);
}
