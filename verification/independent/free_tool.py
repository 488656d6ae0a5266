"""A flat tool pressed by a force, free along z and to turn about one axis, damped by Dampr, without friction."""

import math

from scene import Scene, cross, dot, length, minus, offset_step


def spin(deck, axis, inertia, used, dampr, cycles, step, force, moment=0.0, built=False):
    """Spin in the last record, which is that of the middle of the step before. `used` is the inertia of the damper; `built`: D13 and D24."""
    scene, e = Scene(deck), [float(a == axis) for a in range(3)]
    gap, depth, k, tool_mass = 0.6, 5.0, 252000.0, 0.02
    mass = scene.shares(scene.blank, 7.8e-6 * 1.2)
    first, origin = scene.tool[0], scene.x[90001]
    normal = cross(minus(scene.x[first[2]], scene.x[first[0]]), minus(scene.x[first[3]], scene.x[first[1]]))
    start = [part / length(normal) for part in normal]
    plane = dot(minus(scene.x[first[0]], origin), start)  # the tool is where <y, start> is this, in its own frame
    along, speed, angle, angle_before, rate = 0.0, 0.0, 0.0, 0.0, 0.0
    state = {node: [0.0, 0] for node in scene.nodes}
    for cycle in range(cycles - 1):
        before, weight = (step, step) if cycle else (0.0, step / 2)
        turned = angle_before if built else angle
        c, s, across, on = math.cos(turned), math.sin(turned), cross(e, start), dot(e, start)
        nu = [start[a] * c + across[a] * s + e[a] * on * (1 - c) for a in range(3)]
        pushed, torque, stiffness = 0.0, 0.0, 0.0
        for node in scene.nodes:
            r = minus(scene.x[node], [origin[0], origin[1], origin[2] + along])
            distance = dot(r, nu) - plane
            penetration = max(0.0, gap - distance) if -distance < depth else 0.0
            own = state[node]
            if penetration <= 0:
                own[:] = [0.0, 0]
                continue
            p, begins = offset_step(own, penetration, cycle)
            stiff = k if p > 0 or begins else 0.0
            point = [r[a] - distance * nu[a] for a in range(3)]
            turning = cross(e, point)
            velocity = [-rate * turning[a] - (speed if a == 2 else 0.0) for a in range(3)]
            damping = math.sqrt(2 * stiff * mass[node])
            on_tool = [-(stiff * p - damping * dot(velocity, nu)) * part for part in nu]
            pushed += on_tool[2]
            torque += dot(e, cross(point, on_tool))
            stiffness += (stiff + (damping / before if built and before else 0.0)) * dot(point, point)
        braked = 2 * dampr * math.sqrt(used * stiffness) * rate
        speed += (pushed + force) / tool_mass * weight
        rate += (torque + moment - braked) / inertia * weight
        along += speed * step
        angle_before, angle = angle, angle + rate * step
    return rate
