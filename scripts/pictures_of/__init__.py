"""The pictures of the text and of the design page, one module each: draw(program) returns a matplotlib figure."""

FORMULATION = (
    "sub_triangles",
    "lift",
    "interpolated_normal",
    "kappa",
    "offset_relaxation",
    "pmax_plateau",
    "friction_return",
    "cycle_order",
)
OPTIMIZED = (
    "ranking_safe_radius",
    "contact_safe_radius",
    "exclusive_region",
    "edge_neighbour_zone",
    "separating_lines",
)

FOLDERS = {
    **dict.fromkeys(FORMULATION, "reference/formulation/pictures"),
    **dict.fromkeys(OPTIMIZED, "optimized/pictures"),
}
