"""A flat tool that translates over fixed nodes: normal force, friction and heat, cycle by cycle, in plain loops.

Chapters 6 to 9 and 11 of the formulation, written again from the text. With `built` the step of D25 and the conductance of D32 are used."""

import math
from dataclasses import dataclass, field

from scene import Scene, cross, dot, interpolated, length, minus


@dataclass
class Heat:
    """Heat laws of a scene; functions of pressure give K."""

    exchange: object  # K of the pressure [power/(area temperature)]
    tool: float = 0.0  # temperature of the tool, or of its nodes at time 0 where it is heated [K]
    heated: bool = False  # Ithe_form 1
    capacity: float = 0.036  # of the blank [energy/(volume temperature)]
    friction: float = 0.0  # Fheat
    reach_radiation: float = 0.0
    radiation: float = 0.0
    reach_conduction: float = 0.0
    share: object = None  # Fcond


@dataclass
class Setup:
    """What a deck says, in its own units: Mg mm s."""

    deck: str
    cycles: int
    mu: object  # (pressure, speed, T of the node, T of the tool, node, quad of the tool) -> coefficient
    step: float = 1e-6
    thickness: float = 1.2
    density: float = 7.8e-7
    modulus: float = 210000.0
    stiffness: float = 0.0  # 0: E t
    gap: float = 0.6
    depth: float = 5.0
    damping: float = 1.0  # VISs
    filter: float = 1.0  # alpha
    active: object = None  # of the time
    area_quads: object = None  # quads of the nodal areas, of the scene; the blank's own by default
    heat: Heat = None
    built: bool = False


@dataclass
class Node:
    friction: list = field(default_factory=lambda: [0.0] * 3)
    offset: float = 0.0
    cycles: int = 0


class FlatTool:
    def __init__(self, setup):
        self.set, self.scene = setup, Scene(setup.deck)
        scene, first = self.scene, self.scene.tool[0]
        normal = cross(minus(scene.x[first[2]], scene.x[first[0]]), minus(scene.x[first[3]], scene.x[first[1]]))
        self.normal = [part / length(normal) for part in normal]
        self.origin = scene.x[first[0]]
        if any(abs(dot(minus(scene.x[node], self.origin), self.normal)) > 1e-9 for quad in scene.tool for node in quad):
            raise ValueError(f"{setup.deck}: the tool is not flat")
        self.area = scene.shares(setup.area_quads(scene) if setup.area_quads else scene.blank)
        self.mass = scene.shares(scene.blank, setup.density * setup.thickness)
        self.node = {node: Node() for node in scene.nodes}
        self.temperature = {node: 300.0 for node in scene.nodes}
        heat = setup.heat
        self.tool_temperature = {node: heat.tool for quad in scene.tool for node in quad} if heat else {}
        self.tool_capacity = scene.shares(scene.tool, 0.036) if heat else {}
        self.impulse, self.friction_impulse, self.energy = [0.0] * 3, [0.0] * 3, 0.0

    def owner(self, place):
        """(tool quad, weights of its corners) of the sub-triangle with the smallest kappa; None beside the tool."""
        best = None
        for quad in self.scene.tool:
            centre = [sum(self.scene.x[node][a] for node in quad) / 4 for a in range(3)]
            r = minus(place, centre)
            for k in range(4):
                e, f = minus(self.scene.x[quad[k]], centre), minus(self.scene.x[quad[(k + 1) % 4]], centre)
                ee, ef, ff, re, rf = dot(e, e), dot(e, f), dot(f, f), dot(r, e), dot(r, f)
                b, c = (re * ff - rf * ef) / (ee * ff - ef * ef), (rf * ee - re * ef) / (ee * ff - ef * ef)
                if b < -0.01 or c < -0.01 or b + c > 1.01:
                    continue
                kappa = abs(1 / 3 - b) + abs(1 / 3 - c) + abs(2 / 3 - b - c)
                if best is None or kappa < best[0] - 1e-13:
                    best = (kappa, quad, k, b, c)
        if best is None:
            return None
        _, quad, k, b, c = best
        weights = {node: (1 - b - c) / 4 for node in quad}
        weights[quad[k]] += b
        weights[quad[(k + 1) % 4]] += c
        return quad, weights

    def step(self, node, distance, velocity, quad, tool_temperature, increment, later):
        """(F_n, F_t, energy of slip) of a node in contact."""
        s, setup = self.node[node], self.set
        penetration = setup.gap - distance
        first = s.cycles == 0 and later
        if first:
            s.offset = penetration
        s.cycles += 1
        s.offset = min(s.offset, 0.95 * s.offset + 0.05 * penetration)
        p = max(0.0, penetration - s.offset)
        k = (setup.stiffness or setup.modulus * setup.thickness) if p > 0 or first else 0.0
        v = [-part for part in velocity]
        vn = dot(v, self.normal)
        force = k * p - setup.damping * math.sqrt(2 * k * self.mass[node]) * vn
        self.energy += 0.5 * k * p * p
        speed = length([v[a] - vn * self.normal[a] for a in range(3)])
        mu = setup.mu(force / self.area[node], speed, self.temperature[node], tool_temperature, node, quad)
        trial = [s.friction[a] + setup.filter * k * v[a] * increment for a in range(3)]
        along = dot(trial, self.normal)
        trial = [trial[a] - along * self.normal[a] for a in range(3)]
        size = length(trial)
        s.friction = [part * (min(1.0, mu * abs(force) / size) if size else 0.0) for part in trial]
        slip = dot(minus(trial, s.friction), s.friction) / k if k else 0.0
        return force, s.friction, slip

    def flow(self, node, distance, force, tool_temperature, dt):
        """Heat that a node gets from the tool in a cycle."""
        heat, g, t = self.set.heat, self.set.gap, self.temperature[node]
        d, sheet, a = max(distance, 0.0), 50 + 0.02 * t, self.area[node]
        if distance <= g:
            k = heat.exchange(abs(force) / a)
            return a * (tool_temperature - t) * dt / (d / sheet + 1 / k) if k else 0.0
        got = 0.0
        if d <= heat.reach_conduction:
            k, f = heat.exchange(0.0), heat.share((d - g) / (heat.reach_conduction - g))
            if k * f > 0:
                got += a * (tool_temperature - t) * dt * (f / (g / sheet + 1 / k) if self.set.built else 1 / (g / sheet + 1 / (k * f)))
        if d <= heat.reach_radiation:
            got += heat.radiation * a * (tool_temperature**4 - t**4) * dt
        return got

    def inside(self, quad, dt):
        """Heat that flows inside a quad of the sheet, which lies in the plane x, y: gradient at its middle."""
        x, area = [self.scene.x[node] for node in quad], self.scene.area(quad)
        rows = [[(x[(c + 1) % 4][1] - x[(c + 3) % 4][1]) / (2 * area), (x[(c + 3) % 4][0] - x[(c + 1) % 4][0]) / (2 * area)] for c in range(4)]
        t = [self.temperature[node] for node in quad]
        gradient = [sum(rows[c][a] * t[c] for c in range(4)) for a in range(2)]
        k = 50 + 0.02 * sum(t) / 4
        return {node: -k * self.set.thickness * area * dot(rows[c], gradient) * dt for c, node in enumerate(quad)}

    def run(self):
        """Values at the end: FN, FT, CE_ELAST and TEMP by node."""
        setup, dt, heat = self.set, self.set.step, self.set.heat
        moved, velocity, time = [0.0] * 3, [0.0] * 3, 0.0
        for cycle in range(setup.cycles):
            before = dt if cycle else 0.0
            weight = dt if cycle else dt / 2
            increment = before
            if setup.built:  # D25
                increment = weight = [0.0, dt / 2][cycle] if cycle < 2 else dt
            gained, self.energy = {}, 0.0
            for node in self.scene.nodes:
                place = minus(self.scene.x[node], moved)
                distance = dot(minus(place, self.origin), self.normal)
                found = self.owner(minus(place, [distance * part for part in self.normal])) if not setup.active or setup.active(time) else None
                tool = sum(w * self.tool_temperature[corner] for corner, w in found[1].items()) if found and heat else 0.0
                force, slip = 0.0, 0.0
                if found and distance < setup.gap and distance > -setup.depth:
                    force, friction, slip = self.step(node, distance, velocity, found[0], tool, increment, cycle > 0)
                    for a in range(3):
                        self.impulse[a] -= force * self.normal[a] * weight
                        self.friction_impulse[a] += friction[a] * weight
                else:
                    self.node[node] = Node()
                if found and heat:
                    got = self.flow(node, distance, force, tool, before)
                    gained[node] = gained.get(node, 0.0) + got + heat.friction * slip
                    if heat.heated:
                        for corner, w in found[1].items():
                            gained[-corner] = gained.get(-corner, 0.0) - got * w
            if heat:
                for quad in self.scene.blank:
                    for node, got in self.inside(quad, before).items():
                        gained[node] = gained.get(node, 0.0) + got
                for node, got in gained.items():
                    if node > 0:
                        self.temperature[node] += got / (self.mass[node] / setup.density * heat.capacity)
                    else:
                        self.tool_temperature[-node] += got / self.tool_capacity[-node]
            velocity = [0.0] * 3
            for a, (function, scale) in self.scene.velocity.items():
                velocity[a] = scale * interpolated(self.scene.functions[function], time + dt / 2)
            moved = [moved[a] + velocity[a] * dt for a in range(3)]
            time += dt
        return {"FNX": self.impulse[0], "FNZ": self.impulse[2], "FTX": self.friction_impulse[0], "CE_ELAST": self.energy, "TEMP": self.temperature}
