#!/usr/bin/env python3
"""The installed package, used from outside the source tree.

usage: test_package.py install|cmake|pkg_config --build FOLDER --compiler CXX --version V --scratch FOLDER

install     installs the build into SCRATCH/prefix; headers, libraries and program must be there and be complete
cmake       a project that calls find_package(type21) is built against it and must print the expected numbers
pkg_config  the same source, compiled with what pkg-config says; exit code 77 (skipped) without pkg-config
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
OUTSIDE = HERE / "outside"
# All that a header of the package may include beside the standard library and its neighbours.
ALLOWED = re.compile(r"Eigen/")


def run(*command, **options):
    """Standard output of a command that must succeed."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"error: {' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def check(condition, words):
    if not condition:
        sys.exit(f"error: {words}")


def compare(printed):
    expected = (OUTSIDE / "expected.txt").read_text()
    check(printed == expected, f"the program printed\n{printed}instead of\n{expected}")


def install(options, prefix):
    shutil.rmtree(options.scratch, ignore_errors=True)
    run("cmake", "--install", options.build, "--prefix", prefix)
    headers = sorted((prefix / "include/type21").glob("*.h"))
    check(any(h.name == "make_contact.h" for h in headers), "include/type21/make_contact.h was not installed")
    for header in headers:
        for number, line in enumerate(header.read_text().splitlines(), 1):
            include = re.match(r'#include ([<"])([^>"]+)', line)
            if not include:
                continue
            kind, name = include.groups()
            known = (header.parent / name).exists() if kind == '"' else "/" not in name and "." not in name
            check(known or ALLOWED.match(name), f"{header}:{number}: includes {name}, which a user may not have")
    # Each header stands by itself.
    for header in headers:
        source = options.scratch / "alone.cpp"
        source.write_text(f"#include <type21/{header.name}>\n")
        eigen = run("pkg-config", "--cflags", "eigen3").split() if shutil.which("pkg-config") else ["-I/usr/include/eigen3"]
        run(options.compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", f"-I{prefix}/include", *eigen, source)
    check((prefix / "share/type21/LICENSE").exists(), "share/type21/LICENSE was not installed")
    printed = run(prefix / "bin/type21", "--version")
    check(options.version in printed, f"bin/type21 --version says {printed.strip()}, not {options.version}")


def cmake(options, prefix):
    folder = options.scratch / "cmake"
    shutil.rmtree(folder, ignore_errors=True)
    # CGAL is no concern of a user: a package that asked for it would fail here.
    run("cmake", "-G", "Ninja", "-S", OUTSIDE, "-B", folder, f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_CXX_COMPILER={options.compiler}",
        "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON")
    run("cmake", "--build", folder)
    compare(run(folder / "step_a_contact"))


def pkg_config(options, prefix):
    if not shutil.which("pkg-config"):
        print("skipped: there is no pkg-config")
        return 77
    folder = next(iter(prefix.rglob("type21.pc")), None)
    check(folder, "type21.pc was not installed")
    environment = dict(os.environ, PKG_CONFIG_PATH=str(folder.parent))
    check(run("pkg-config", "--modversion", "type21", env=environment).strip() == options.version, "type21.pc has another version")
    flags = run("pkg-config", "--cflags", "--libs", "--static", "type21", env=environment).split()
    program = options.scratch / "step_by_pkg_config"
    run(options.compiler, "-std=c++20", "-O1", OUTSIDE / "step_a_contact.cpp", "-o", program, *flags)
    libraries = dict(os.environ, LD_LIBRARY_PATH=str(folder.parent.parent))
    compare(run(program, env=libraries))
    return 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("part", choices=["install", "cmake", "pkg_config"])
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--version", required=True)
    parser.add_argument("--scratch", type=pathlib.Path, required=True)
    options = parser.parse_args()
    return {"install": install, "cmake": cmake, "pkg_config": pkg_config}[options.part](options, options.scratch / "prefix")


if __name__ == "__main__":
    sys.exit(main())
