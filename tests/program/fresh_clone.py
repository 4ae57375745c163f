# SPDX-License-Identifier: GPL-3.0-or-later
"""The guide's commands for the libraries, in a clone of the sources as they are, with the packages hidden
that only tests need.

usage: fresh_clone.py CMAKE SOURCE_FOLDER CXX_COMPILER configure|build

configure: the first command only, and a look at what it searched for. build: all of them, installed
into a fresh folder, and the guide's project.
"""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

from page_blocks import blocks_of, same_output

PAGE = "experiments/guide/libraries.md"
TEST_PACKAGES = ("GTest", "RAPIDCHECK", "FLINT", "ARB")


def run(command, **options):
    done = subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, **options)
    if done.returncode != 0:
        sys.exit(f"exit code {done.returncode}: {shlex.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def copy_sources(source, clone):
    """What a clone would have if everything were committed: no build folder, nothing ignored."""
    listed = subprocess.run(["git", "-C", source, "ls-files", "-z", "--cached", "--others",
                             "--exclude-standard"], stdout=subprocess.PIPE, check=False)
    if listed.returncode != 0:
        print("the sources are no git repository: skipped")
        sys.exit(0)
    for name in filter(None, listed.stdout.decode().split("\0")):
        file = pathlib.Path(source) / name
        if file.is_file():
            (clone / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, clone / name)


def commands_of(source):
    text = (pathlib.Path(source) / PAGE).read_text()
    section = text[text.index("## Use the libraries"):]
    line = re.search(r"^    (cmake -S .*)$", section, re.MULTILINE)
    if line is None:
        sys.exit(f"{PAGE} has no commands under \"Use the libraries\"")
    return [shlex.split(one) for one in line.group(1).split("&&")]


def main():
    cmake, source, compiler, form = sys.argv[1:5]
    commands = commands_of(source)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        clone, prefix = folder / "clone", folder / "prefix"
        copy_sources(source, clone)
        configure = commands[0] + ["-DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON"]
        environment = dict(os.environ, CXX=compiler, CCACHE_BASEDIR=str(clone), CCACHE_NOHASHDIR="1")
        if shutil.which("ninja"):  # as tests/run: what it has compiled is found by ccache
            environment["CMAKE_GENERATOR"] = "Ninja"
        run([cmake] + configure[1:], cwd=clone, env=environment)
        cache = (clone / "build" / "CMakeCache.txt").read_text()
        for package in TEST_PACKAGES:
            if re.search(rf"^{package}_(DIR|LIBRARY)\b", cache, re.MULTILINE):
                sys.exit(f"the default configuration looks for {package}, which only tests need")
        if form == "configure":
            print("a fresh clone configures without the packages of the tests")
            return
        for command in commands[1:]:
            run([cmake] + [str(prefix) if word == "/usr/local" else word for word in command[1:]],
                cwd=clone, env=environment)
        files = dict(blocks_of(source, PAGE, "Use the libraries"))
        project = folder / "project"
        project.mkdir()
        (project / "CMakeLists.txt").write_text(files["cmake"])
        (project / "main.cpp").write_text(files["cpp"])
        run([cmake, "-S", project, "-B", project / "build", f"-DCMAKE_PREFIX_PATH={prefix}",
             "-DCMAKE_BUILD_TYPE=Release"], env=environment)
        run([cmake, "--build", project / "build"], env=environment)
        same_output(files["text"], run([project / "build" / "mine"]), "the project")
        print("The guide's commands build, install and run in a fresh clone without test packages")


if __name__ == "__main__":
    main()
