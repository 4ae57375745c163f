# SPDX-License-Identifier: GPL-3.0-or-later
"""The Debian packages: made of what is built, complete, and nothing is wrong with them for lintian.

usage: deb_packages.py SOURCE_FOLDER BUILD_FOLDER PACKAGES_FOLDER
They are left in the last folder. Exit code 77: dpkg-dev, lintian or help2man is not installed.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

PROGRAM = ["./usr/bin/kinex", "./usr/bin/kinex-logcheck", "./usr/share/man/man1/kinex.1.gz",
           "./usr/share/man/man1/kinex-run.1.gz", "./usr/share/bash-completion/completions/kinex",
           "./usr/share/zsh/vendor-completions/_kinex", "./usr/share/fish/vendor_completions.d/kinex.fish",
           "./usr/share/kinex/schemas/scene.schema.json", "./usr/share/kinex/logcheck/__main__.py",
           "./usr/share/doc/kinex/copyright", "./usr/share/doc/kinex/changelog.gz"]
LIBRARIES = [r"\./usr/include/kinex/core/engine/simulator\.h", r"\./usr/lib/.*/libkinex_core_numbers\.a|\./usr/lib/libkinex_core_numbers\.a",
             r"\./usr/lib/.*cmake/kinex/kinexConfig\.cmake", r"\./usr/share/doc/libkinex-dev/copyright"]


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"exit code {done.returncode}: {command}\n{done.stdout}")
    return done.stdout


def main():
    source, build, folder = map(pathlib.Path, sys.argv[1:4])
    for tool in ("dpkg-shlibdeps", "lintian", "help2man", "gzip"):
        if shutil.which(tool) is None:
            print(f"skipped: {tool} is not installed")
            return 77
    shutil.rmtree(folder, ignore_errors=True)
    # Nothing is installed by a test, and nothing built but what is missing.
    run("cmake", "--build", build, "--target", "kinex", "man", "completions")
    folder.mkdir(parents=True)
    run("cpack", "--config", build / "CPackConfig.cmake", "-G", "DEB", "-B", folder, cwd=folder)
    shutil.rmtree(folder / "_CPack_Packages")
    (program,), (libraries,) = folder.glob("kinex_*.deb"), folder.glob("libkinex-dev_*.deb")
    wrong = []

    def names(package):
        return [line.split()[-1] for line in run("dpkg-deb", "-c", package).splitlines()]

    held = names(program)
    wrong += [f"{name} is not in {program.name}" for name in PROGRAM if name not in held]
    wrong += [f"{name} is in {program.name}" for name in held if name.endswith((".h", ".a", "LICENSE"))]
    held = names(libraries)
    for pattern in LIBRARIES:
        if not any(re.fullmatch(pattern, name) for name in held):
            wrong.append(f"nothing like {pattern} is in {libraries.name}")
    # Every header of the libraries, and none of the program's.
    headers = {name.removeprefix("./usr/include/kinex/") for name in held if name.endswith(".h")}
    expected = {str(path.relative_to(source)) for room in ("core", "predicates", "structures")
                for path in (source / room).rglob("*.h")}
    if headers != expected:
        wrong.append(f"headers: {sorted(headers ^ expected)}")
    if any(name.startswith("./usr/bin") for name in held):
        wrong.append(f"{libraries.name} has a program")
    depends = run("dpkg-deb", "-f", program, "Depends")
    for library in ("libgmp10", "libmpfr6", "libgsl27", "libstdc++6", "python3"):
        if library not in depends:
            wrong.append(f"{program.name} does not depend on {library}: {depends}")
    done = subprocess.run(["lintian", *(["--allow-root"] if os.geteuid() == 0 else []), "--fail-on", "error,warning",
                           "--suppress-tags", "malformed-contact,bogus-mail-host-in-debian-changelog",
                           program, libraries], text=True, capture_output=True, check=False)
    if done.returncode != 0:
        wrong.append(done.stdout + done.stderr)
    print("\n".join(wrong) or f"{program.name}, {libraries.name}")
    return 1 if wrong else 0


sys.exit(main())
