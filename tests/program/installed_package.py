# SPDX-License-Identifier: GPL-3.0-or-later
"""Installs the build into a fresh folder, and builds and runs the guide's project against it.

usage: installed_package.py CMAKE BUILD_FOLDER SOURCE_FOLDER CXX_COMPILER CXX_FLAGS
"""
import pathlib
import subprocess
import sys
import tempfile

from page_blocks import blocks_of, same_output

PAGE = "experiments/guide/libraries.md"


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, **options)
    if done.returncode != 0:
        sys.exit(f"exit code {done.returncode}: {command}\n{done.stdout}")
    return done.stdout


def main():
    cmake, build, source, compiler, flags = sys.argv[1:6]
    files = dict(blocks_of(source, PAGE, "Use the libraries"))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prefix = folder / "prefix"
        run(cmake, "--install", build, "--prefix", prefix)
        # What is installed must not need the build: its name is nowhere in the package.
        for file in prefix.rglob("*.cmake"):
            for path in (build, source):
                if path in file.read_text():
                    sys.exit(f"{file.name} names {path}")
        project = folder / "project"
        project.mkdir()
        (project / "CMakeLists.txt").write_text(files["cmake"])
        (project / "main.cpp").write_text(files["cpp"])
        run(cmake, "-S", project, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={prefix}",
            f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={flags}",
            "-DCMAKE_BUILD_TYPE=Release")
        run(cmake, "--build", folder / "build")
        same_output(files["text"], run(folder / "build" / "mine"), "the project")
        version = run(prefix / "bin" / "kinex", "--version").strip()
        scenes = prefix / "share" / "kinex" / "scenes"
        stars = scenes / "nearest-dozen.csv"
        run(prefix / "bin" / "kinex", "import", stars, "-o", folder / "stars.json")
        # The log checker is found beside the program, wherever the prefix is.
        square, log = folder / "square.json", folder / "square.jsonl"
        run(prefix / "bin" / "kinex", "gen", "uniform-square", "--n", "6", "-o", square)
        run(prefix / "bin" / "kinex", "run", square, "--maintain", "sorted_list", "--events", log)
        run(prefix / "bin" / "kinex-logcheck", log, "--scene", square)
        # What makes animations says what it needs, and needs nothing of the sources.
        animate = run("/usr/bin/python3", prefix / "share" / "kinex" / "view" / "animate.py", "--help")
        if "an animation" not in animate:
            sys.exit(f"animate.py --help says {animate!r}")
        print(f"installed {version}, built and ran the guide's project")


main()
