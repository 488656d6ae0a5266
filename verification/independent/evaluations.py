"""The criteria whose expected value comes from here: (case, criterion) -> a function that computes it."""

import math
from pathlib import Path

from flat_tool import FlatTool, Heat, Setup
from free_tool import spin
from scene import Scene, columns, interpolated

CASES = Path(__file__).resolve().parents[2] / "cases"


def deck(case, name=None):
    return CASES / case / f"{name or case}_0000.rad"


def coulomb(mu):
    return lambda *_: mu


def of_pressure(factor, scale=1.0):
    """Kthe times fct_IDK of these decks at p / AscaleK."""
    return lambda p: factor * interpolated([(0, 0.2), (200, 1), (1000, 1.5)], p / scale)


def flat(case, column, node=None, name=None, **setup):
    def value():
        found = FlatTool(Setup(deck=deck(case, name), **setup)).run()[column]
        return found if node is None else found[node]

    return value


def viscous(fric, c1=0.0, c2=0.0, c3=0.0, c4=0.0, c5=0.0):
    return lambda p, s, *_: max(1e-30, fric + c1 * p + c2 * s + c3 * p * s + c4 * p * p + c5 * s * s)


LAW_1 = viscous(0.05, 2e-5, 3e-6, 4e-9, 1e-8, 2e-10)


def darmstadt(fric, c1, c2, c3, c4, c5, c6):
    """A term whose coefficient is 0 is 0."""
    return lambda p, s, *_: max(1e-30, fric + sum(c * math.exp(e * s) * power for c, e, power in ((c1, c2, p * p), (c3, c4, p), (c5, c6, 1.0)) if c))


def once(scene):
    """The quads of /SURF/SEG/1, each once."""
    found = {}
    for line in scene.blocks["/SURF/SEG/1"][1:]:
        quad = columns(line)[1:5]
        found.setdefault(frozenset(quad), quad)
    return list(found.values())


def pairs(case):
    """Law 1 with the coefficients of the pair of parts: the part of a node is that of its first shell."""
    scene = Scene(deck(case))
    rows = scene.blocks["/FRICTION/7"][1:]
    law = lambda i: viscous(float(rows[i + 1].split()[1]), *map(float, rows[i].split()))
    listed = {frozenset((int(rows[i][20:30]), int(rows[i][30:40]))): law(i + 1) for i in range(3, len(rows), 3)}
    first = {}
    for number, quad in scene.shell.items():
        for node in quad:
            first.setdefault(node, scene.part[number])
    part = {tuple(quad): scene.part[number] for number, quad in scene.shell.items()}
    return lambda p, s, t, tool, node, quad: listed.get(frozenset((first[node], part[tuple(quad)])), law(1))(p, s)


LIGHT = {"density": 7.8e-9, "damping": 1e-20}
PAST_GAP = {"share": lambda x: interpolated([(0, 1), (0.5, 0.7), (1, 0)], x)}
AT = {"own": Heat(exchange=of_pressure(20.0, 0.5), tool=900.0),
      "radiating": Heat(exchange=of_pressure(20.0), tool=900.0, heated=True, radiation=8e-9, reach_radiation=1.52, reach_conduction=1.21, **PAST_GAP),
      "version_2021": Heat(exchange=lambda p: 22.0, tool=900.0, radiation=6.1e-9, reach_radiation=1.45, reach_conduction=1.15, friction=0.6, **PAST_GAP),
      "falling": Heat(exchange=lambda p: 70.0, tool=500.0),
      "default": Heat(exchange=of_pressure(200000.0), tool=900.0, capacity=0.02)}


def floored(p, s, t, tool, *_):
    return max(0.0, 0.3 * interpolated([(0, 1.0), (300, 0.6), (400, 0.12), (402, 0.036)], 0.5 * (t + tool)))


def spin_of(case, name, axis, used, moment=0.0, built=False):
    return lambda: spin(deck(case, name), axis, 0.9, used, 0.25, 260, 2e-6, -300000.0, moment, built)


VALUES = {
    ("filter_friction_card", "own_filter_of_friction"): flat("filter_friction_card", "FTX", cycles=220, mu=coulomb(0.12), filter=2 * math.pi * 41000 * 1e-6),
    **{("unit_id_interface", name): flat("unit_id_interface", column, cycles=280, mu=coulomb(0.17), filter=2 * math.pi * 21000 * 1e-6, stiffness=61000.0, gap=0.54,
                                         depth=2.2, damping=0.4, active=lambda t: 3.1e-5 <= t <= 2.4e-4)
       for name, column in (("normal_impulse", "FNZ"), ("friction_impulse", "FTX"))},
    ("ascalek_0p5", "pressure_over_ascalek"): flat("ascalek_0p5", "TEMP", 1001, cycles=280, mu=coulomb(0.1), heat=AT["own"]),
    ("ascalek_default", "temperature"): flat("ascalek_default", "TEMP", 1001, cycles=40, mu=coulomb(0.0), heat=AT["default"], **LIGHT),
    **{("fcond_form1_rad", name): flat("fcond_form1_rad", "TEMP", node, cycles=300, mu=coulomb(0.1), heat=AT["radiating"], built=built)
       for name, node, built in (("in_series", 1001, False), ("in_series_patch_2", 1101, False), ("as_built_by_hand", 1001, True))},
    **{("version_2021_heat", name): flat("version_2021_heat", "TEMP", node, cycles=300, mu=coulomb(0.1), heat=AT["version_2021"])
       for name, node in (("in_series", 1001), ("in_series_patch_2", 1101))},
    ("fctidf_negative", "floored_at_zero"): flat("fctidf_negative", "FTX", cycles=300, mu=floored, heat=AT["falling"]),
    ("segment_twice", "counted_once"): flat("segment_twice", "FTX", cycles=220, mu=LAW_1, area_quads=once),
    ("surface_twice", "counted_once"): flat("surface_twice", "FTX", cycles=20, mu=viscous(0.01, 1e-6), **LIGHT),
    ("law2_overflow", "term_is_zero"): flat("law2_overflow", "FTX", cycles=200, mu=darmstadt(0.04, 0.0, 0.9, 5e-5, -1e-4, 0.05, -3e-4)),
    ("law2_zero_term", "mu_is_fric"): flat("law2_zero_term", "FTX", cycles=20, mu=darmstadt(0.05, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0), density=7.8e-9, damping=0.2),
    ("friction_pairs_shared", "part_of_the_first_segment"): lambda: flat("friction_pairs_shared", "FTX", cycles=240, mu=pairs("friction_pairs_shared"))(),
    **{("sensor_logic", name): flat("sensor_logic", column, cycles=240, mu=coulomb(0.1), active=lambda t: 1e-4 <= t < 1.7e-4)
       for name, column in (("window_of_the_sensors", "FTX"), ("normal_impulse", "FNZ"))},
    ("dampr_x", "inertia_about_the_axis"): spin_of("dampr_x", None, 0, 0.9),
    ("dampr_x", "inertia_about_the_axis_without_d40"): spin_of("dampr_x", None, 0, 0.9, built=True),
    ("dampr_axes", "spin_about_y"): spin_of("dampr_axes", "dampr_axes_y", 1, 0.9),
    ("dampr_axes", "spin_about_y_with_d40"): spin_of("dampr_axes", "dampr_axes_y", 1, 0.5),
    ("dampr_axes", "spin_about_z"): spin_of("dampr_axes", "dampr_axes_z", 2, 0.9, 30000.0),
    ("dampr_axes", "spin_about_z_with_d40"): spin_of("dampr_axes", "dampr_axes_z", 2, 0.5, 30000.0),
}


def orientation_of_the_same_time():
    """D24: FNX without it minus FNX with it, as measured."""
    from turning_tool import impulses

    at = lambda older: impulses(deck("rotating_tool"), 400, 2e-6, 0.15, (1500.0, -600.0, -150.0), (-90.0, 60.0, 110.0), older)[0][0]
    return at(False) - at(True)


SLOW = {("rotating_tool", "orientation_of_the_same_time"): orientation_of_the_same_time}
