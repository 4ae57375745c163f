# SPDX-License-Identifier: GPL-3.0-or-later
"""The container file does what the two commands do: the same packages, configuration, target and arguments.

usage: container_file.py SOURCE_FOLDER
Nothing is built: its instructions are read, and held to experiments/run, tests/run and the README of packaging.
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

HERE = "experiments/packaging"
IMAGE_ROOT = "/kinex"


def instructions(text):
    """Pairs of an instruction and what follows it, with continued lines joined."""
    lines = [line for line in text.splitlines() if not line.lstrip().startswith("#")]
    joined = re.sub(r"\\\n\s*", " ", "\n".join(lines))
    return [tuple(line.split(maxsplit=1)) for line in joined.splitlines() if line.strip()]


def steps(command):
    return [step.strip() for step in command.split("&&")]


def package_lists(command):
    return set(re.findall(r"packages-\w+\.txt", command))


def configuration(command):
    """The definitions of the step that configures, in a command or a script."""
    found = re.search(r"cmake -S (?:(?!&&|>|\|\|).)*", command.replace("\\\n", " "))
    return set(re.findall(r"-D\S+", found.group(0))) if found else set()


def default_arguments(script):
    return re.search(r"\|\| set -- (.*)", script).group(1).split()


def check(source):
    """What is wrong, in words."""
    text = (source / HERE / "Containerfile").read_text(encoding="utf-8")
    main = (source / "experiments/run").read_text(encoding="utf-8")
    tests = (source / "tests/run").read_text(encoding="utf-8")
    page = (source / HERE / "README.md").read_text(encoding="utf-8")
    all_of = instructions(text)
    runs = [rest for word, rest in all_of if word == "RUN"]
    wrong = []

    def hold(is_so, words):
        if not is_so:
            wrong.append(words)

    hold(all_of[0] == ("FROM", "debian:bookworm"), f"it begins with {all_of[0]}, not with Debian 12")
    # Files that it names are there, in the image and here.
    for word, rest in all_of:
        if word == "COPY":
            *froms, _ = rest.split()
            hold(all((source / name).exists() for name in froms), f"COPY {rest}: there is no such file")
    for name in re.findall(rf"{IMAGE_ROOT}/([\w./-]+)", text):
        if not name.startswith("build"):
            hold((source / name).exists(), f"{IMAGE_ROOT}/{name} is not in the sources")
    # Both commands find their packages installed.
    setup = next((run for run in runs if f"{HERE}/setup" in run), "")
    needed = package_lists(main) | package_lists(tests)
    hold(package_lists(setup) == needed, f"it installs {sorted(package_lists(setup))}, the commands need {sorted(needed)}")
    # The main job finds the program built, as it builds it itself.
    build = next((run for run in runs if "cmake --build" in run), "")
    hold(configuration(build) == configuration(main) and configuration(main),
         f"it configures {sorted(configuration(build))}, experiments/run {sorted(configuration(main))}")
    built = next((step for step in steps(build) if step.startswith("cmake --build")), "")
    hold(f"--build {IMAGE_ROOT}/build " in built and "--target kinex" in built and "--target kinex" in main,
         f"the program is built by {built!r}")
    folder = re.search(r"KINEX_BUILD:-\$root/(\w+)", main).group(1)
    hold(folder == "build", f"experiments/run builds in {folder}")
    # What it starts.
    words = dict(all_of)
    hold(words.get("ENTRYPOINT") == f'["sh", "{IMAGE_ROOT}/experiments/run"]', f"it starts {words.get('ENTRYPOINT')}")
    arguments = re.findall(r'"([^"]*)"', words.get("CMD", ""))
    hold(arguments == default_arguments(main), f"it gives {arguments}, experiments/run takes {default_arguments(main)}")
    hold(words.get("WORKDIR") == "/results", f"results are written to {words.get('WORKDIR')}")
    # What it tells of itself, before anything is installed or built.
    with tempfile.TemporaryDirectory() as scratch:
        for tool in ("cmake", "dpkg-query", "apt-get"):  # where they are asked for, it fails
            (pathlib.Path(scratch) / tool).write_text("#!/bin/sh\nexit 9\n")
            (pathlib.Path(scratch) / tool).chmod(0o755)
        for option in ("--help", "-h"):
            told = subprocess.run(["/bin/sh", source.resolve() / "experiments/run", option], cwd=scratch, text=True,
                                  capture_output=True, check=False, env={"PATH": f"{scratch}:/bin:/usr/bin", "KINEX_BUILD": f"{scratch}/build"})
            hold(told.returncode == 0 and "Usage: sh experiments/run [ARGUMENTS OF kinex verify]" in told.stdout
                 and " ".join(default_arguments(main)) in told.stdout and not told.stderr,
                 f"sh experiments/run {option} says {told.stdout!r} and {told.stderr!r}")
        hold(len(list(pathlib.Path(scratch).iterdir())) == 3, "sh experiments/run --help makes files")
    # What the page says: commands of the file's first lines, with what each of them runs.
    block = re.search(r"## A container\n\n((?:    .*\n)+)", page).group(1)
    said = [shlex.split(line, comments=True) for line in block.splitlines()]
    named = [shlex.split(re.sub(r"\s{2,}.*", "", line.strip("# ").strip())) for line in text.splitlines()
             if re.match(r"#\s+podman", line)]
    for command in said:
        hold(command in named, f"the page says {' '.join(command)}, the file does not")
    for command in said + named:
        if "--entrypoint" in command:
            script = command[-1].removeprefix(IMAGE_ROOT + "/")
            hold((source / script).exists(), f"{' '.join(command)}: there is no {script}")
        if "-f" in command:
            hold((source / command[command.index("-f") + 1]).exists(), f"{' '.join(command)}: there is no such file")
    # The commit is in the image: --version names it.
    ignored = (source / HERE / "Containerfile.dockerignore").read_text(encoding="utf-8").split()
    hold(".git" not in ignored and ".git/" not in ignored, "the image has no .git, and the program no commit")
    hold("build*/" in ignored, "the build folders are copied into the image")
    return wrong


def main():
    wrong = check(pathlib.Path(sys.argv[1]))
    print("\n".join(wrong) or "the container file does what the two commands do")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
