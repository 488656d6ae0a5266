"""A tool of quads that translates and turns at given rates over fixed nodes, with Coulomb friction: chapters 1 and 3 to 8 of the formulation. Needs numpy."""

import numpy as np

from scene import Scene, offset_step


def turned(w):
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    x, y, z = w / angle
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


class Tool:
    """Sub-triangles A, B, C with their normals, in the frame of the tool."""

    def __init__(self, scene):
        at = {node: np.array(scene.x[node]) - np.array(scene.x[90001]) for quad in scene.tool for node in quad}
        normal = {node: np.zeros(3) for node in at}
        for quad in scene.tool:
            middle = sum(at[node] for node in quad) / 4
            for k in range(4):
                one, two = quad[k], quad[(k + 1) % 4]
                area = np.cross(at[one] - middle, at[two] - middle)
                for node in (one, two):
                    normal[node] = normal[node] + area / np.linalg.norm(area)
        normal = {node: n / np.linalg.norm(n) for node, n in normal.items()}
        rows = []
        for quad in scene.tool:
            middle, mean = sum(at[node] for node in quad) / 4, sum(normal[node] for node in quad) / 4
            rows += [(middle, at[one], at[two], mean, normal[one], normal[two]) for one, two in zip(quad, quad[1:] + quad[:1])]
        self.a, self.b, self.c, self.na, self.nb, self.nc = (np.array(part) for part in zip(*rows))
        self.area = np.cross(self.b - self.a, self.c - self.a)
        self.middle = (self.a + self.b + self.c) / 3

    def retained(self, p, gap, depth, near=12.0):
        """(signed distance, normal, point) of the sub-triangle with the smallest kappa; None without contact."""
        rows = np.nonzero(((self.middle - p) ** 2).sum(1) < near * near)[0]
        a, b, c, na, nb, nc, area = (part[rows] for part in (self.a, self.b, self.c, self.na, self.nb, self.nc, self.area))

        def weights(q, u, v, w, m):
            size = (m * m).sum(1)
            return (np.cross(q - u, w - u) * m).sum(1) / size, (np.cross(v - u, q - u) * m).sum(1) / size

        def inside(s, t):
            return (s >= -0.01) & (t >= -0.01) & (s + t <= 1.01)

        height = ((p - a) * area).sum(1)
        leans = [(n * area).sum(1) for n in (na, nb, nc)]
        good = (leans[0] > 0) & (leans[1] > 0) & (leans[2] > 0)
        la, lb, lc = (x + n * (height / lean)[:, None] for x, n, lean in zip((a, b, c), (na, nb, nc), leans))
        lifted = np.cross(lb - la, lc - la)
        good &= (lifted * area).sum(1) > 0
        s, t = weights(p, la, lb, lc, lifted)
        good &= inside(s, t)
        n = (1 - s - t)[:, None] * na + s[:, None] * nb + t[:, None] * nc
        lean = (n * area).sum(1)
        good &= lean > 0
        q = p + n * ((area * (a - p)).sum(1) / lean)[:, None]
        s, t = weights(q, a, b, c, area)
        good &= inside(s, t)
        best = None
        for j in np.nonzero(good)[0]:
            clipped = np.clip([1 - s[j] - t[j], s[j], t[j]], 0, 1)
            foot = clipped / clipped.sum() @ np.array([a[j], b[j], c[j]])
            outside = (p - foot) @ area[j] >= 0
            if (p - foot) @ (p - foot) >= (gap if outside else depth) ** 2:
                continue
            kappa = abs(1 / 3 - s[j]) + abs(1 / 3 - t[j]) + abs(2 / 3 - s[j] - t[j])
            if best is None or kappa < best[0] - 1e-13:
                size = np.linalg.norm(n[j])
                best = (kappa, height[j] * size / lean[j], n[j] / size, q[j])
        return best[1:] if best else None


def impulses(deck, cycles, step, mu, velocity, spin, older_orientation=False, thickness=1.2, density=7.8e-6, modulus=210000.0):
    """FN and FT at the end, with the step of D25. `older_orientation` is D24."""
    scene = Scene(deck)
    tool, centre = Tool(scene), np.array(scene.x[90001])
    mass, k, gap = scene.shares(scene.blank, density * thickness), modulus * thickness, thickness / 2
    edges = [np.linalg.norm(np.array(scene.x[one]) - scene.x[two]) for quad in scene.blank for one, two in zip(quad, quad[1:] + quad[:1])]
    depth = max(gap, min(edges))
    r = before = np.eye(3)
    v, w = np.zeros(3), np.zeros(3)
    friction, state = {node: np.zeros(3) for node in scene.nodes}, {node: [0.0, 0] for node in scene.nodes}
    normal_sum, tangential_sum = np.zeros(3), np.zeros(3)
    for cycle in range(cycles):
        weight = [0.0, step / 2][cycle] if cycle < 2 else step
        pose = before if older_orientation else r
        for node in scene.nodes:
            found = tool.retained(pose.T @ (np.array(scene.x[node]) - centre), gap, depth)
            penetration = max(0.0, gap - found[0]) if found else 0.0
            own = state[node]
            if penetration <= 0:
                own[:], friction[node] = [0.0, 0], np.zeros(3)
                continue
            p, begins = offset_step(own, penetration, cycle)
            stiff = k if p > 0 or begins else 0.0
            nu, arm = pose @ found[1], pose @ found[2]
            relative = -(v + np.cross(w, arm))
            force = stiff * p - np.sqrt(2 * stiff * mass[node]) * (relative @ nu)
            trial = friction[node] + stiff * relative * weight
            trial = trial - (trial @ nu) * nu
            size = np.linalg.norm(trial)
            friction[node] = trial * (min(1.0, mu * abs(force) / size) if size else 0.0)
            normal_sum -= force * nu * weight
            tangential_sum += friction[node] * weight
        v, w = np.array(velocity), np.array(spin)
        centre = centre + v * step
        before, r = r, turned(w * step) @ r
    return normal_sum, tangential_sum
