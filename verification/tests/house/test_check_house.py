#!/usr/bin/env python3
"""scripts/check_house sees each kind of fault: a small tree in order, then the same with one fault at a time.

usage: test_check_house.py CHECK_HOUSE
"""
import pathlib
import subprocess
import sys
import tempfile

IN_ORDER = {
    "reference/formulation/03_projection.md": "# 3 Projection\n\n## Step 1: Lift\n\n## Step 2: Inside\n\nSee [gap](02_gap.md#step-1-gap).\n",
    "reference/formulation/02_gap.md": "# 2 Gap\n\n## Step 1: Gap\n\nFormulation 3, steps 1 and\n2, and Formulation 2, step 1.\n",
    "reference/contract/scene.h": "#include <vector>\n#include <Eigen/Core>\n#include \"mesh.h\"\n/// Formulation 3, step\n/// 2\n",
    "reference/contract/mesh.h": "#pragma once\n",
    "reference/contact/law.h": "#include \"reference/contract/scene.h\"\n",
    "optimized/search/tree.h": "#include \"reference/contract/scene.h\"\n#include \"optimized/simd/lanes.h\"\n// the core, held\n",
    "optimized/simd/lanes.h": "#include <cmath>\n",
    "optimized/kernel/laws.h": "#include \"optimized/search/tree.h\"\n#include \"reference/contract/scene.h\"\n",
    "verification/results/record/recorder.h": "#include \"verification/results/tables/table.h\"\n",
    "verification/results/tables/table.h": "#include \"verification/support/info.h\"\n",
    "verification/support/info.h": "#include \"optimized/search/tree.h\"\n",
    "README.md": "[text](reference/formulation/03_projection.md) `[no](link.md)`; manual page, comment 3\n",
}
# check, file, line of the finding, what is put there
FAULTS = [
    ("includes", "reference/contract/scene.h", 1, "#include \"reference/contact/law.h\"\n"),
    ("includes", "reference/contract/scene.h", 1, "#include <CGAL/Interval_nt.h>\n"),
    ("includes", "reference/contract/mesh.h", 1, "#include <fmt/format.h>\n"),
    ("includes", "reference/contact/law.h", 1, "#include \"reference/host/march.h\"\n"),
    ("includes", "optimized/search/tree.h", 2, "#include <cmath>\n#include \"reference/contact/law.h\"\n"),
    ("includes", "verification/support/info.h", 1, "#include \"verification/results/tables/table.h\"\n"),
    ("includes", "verification/results/tables/table.h", 1, "#include \"verification/results/record/recorder.h\"\n"),
    ("citations", "reference/contact/law.h", 1, "// Formulation 3, step 4\n"),
    ("citations", "reference/contact/law.h", 2, "\n// Formulation 3, steps 1 to\n// 3\n"),
    ("citations", "reference/contact/law.h", 1, "// Formulation 3, step 2 and 2, step 2\n"),
    ("citations", "reference/contact/law.h", 1, "// Formulation 12, step 1\n"),
    ("citations", "reference/contact/law.h", 1, "// Formulation 3\n"),
    ("citations", "reference/contact/law.h", 1, "// formulation 3, step 1\n"),
    ("citations", "reference/contact/law.h", 1, "// formulation\n// section 3\n"),
    ("citations", "reference/contact/law.h", 1, "// (section 3)\n"),
    ("citations", "README.md", 1, "page, equation (5)\n"),
    ("names", "optimized/search/tree.h", 1, "struct Prism {};\n"),
    ("names", "optimized/search/tree.h", 2, "\nbool held = true;\n"),
    ("names", "optimized/search/funnel.h", 1, "\n"),
    ("names", "reference/contact/law.h", 1, "auto x = exactly<double>(1);\n"),
    ("links", "README.md", 1, "[gone](reference/gone.md)\n"),
    ("links", "README.md", 2, "\n[gone](reference/formulation/02_gap.md#step-9-gone)\n"),
    ("links", "README.md", 1, "[outside](../elsewhere.md)\n"),
]


def main():
    checker = sys.argv[1]
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder) / "house"
        (pathlib.Path(folder) / "elsewhere.md").write_text("outside\n")

        def check(fault=None):
            for name, text in IN_ORDER.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            if fault:
                (root / fault[1]).write_text(fault[3])
            done = subprocess.run([sys.executable, "-B", checker, *([fault[0]] if fault else []), "--root", root],
                                  capture_output=True, text=True)
            if fault and fault[1] not in IN_ORDER:
                (root / fault[1]).unlink()
            return done

        done = check()
        if done.returncode != 0:
            wrong.append(f"a tree in order is refused:\n{done.stdout}{done.stderr}")
        for fault in FAULTS:
            done = check(fault)
            if done.returncode != 3 or f"{fault[1]}:{fault[2]}: " not in done.stdout:
                wrong.append(f"not seen at {fault[1]}:{fault[2]} by {fault[0]} (exit code {done.returncode}): {fault[3]!r}\n{done.stdout}{done.stderr}")
    print("\n".join(wrong) or f"{len(FAULTS)} faults, each seen")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
