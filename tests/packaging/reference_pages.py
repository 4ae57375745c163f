# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference of the libraries: comments become what is meant, missing ones are errors, and ours has no warning.

usage: reference_pages.py SOURCE_FOLDER BUILD_FOLDER
Exit code 77: Doxygen is not installed.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HEADER = """// SPDX-License-Identifier: GPL-3.0-or-later
// Thing: what a <thing> is, #1 of 2.
//
//   a drawing   \\ /
#ifndef THING_H
#define THING_H

namespace kinex {

class Thing {
 public:
  int size() const;  // its size @ all times
  int untold() const;
};

// The `first` of two.
int first(int a);
int second(int a);

%s
}  // namespace kinex

#endif
"""
LINES = {  # what the filter makes of lines of the header
    "// Thing: what a <thing> is, #1 of 2.": "/// Thing: what a &lt;thing&gt; is, \\#1 of 2.",
    "//   a drawing   \\ /": "/// <pre>   a drawing   \\\\ /</pre>",
    "class Thing {": "/** What a &lt;thing&gt; is, \\#1 of 2. See the head of the file. */ class Thing {",
    "  int size() const;  // its size @ all times": "  int size() const;  ///< its size \\@ all times",
    "  int untold() const;": "  int untold() const;",
    "// The `first` of two.": "/// The <code>first</code> of two.",
    "int second(int a);": "/** The <code>first</code> of two. */ int second(int a);",
}
BAD = {  # further declarations, what is found wrong with them
    "int third(int a);\n": "Member third(int a) (function) of namespace kinex is not documented.",
    "struct Untold {\n  int x;\n};\n": "Compound kinex::Untold is not documented.",
    "enum class Side { kLeft };\n": "Member Side (enumeration) of namespace kinex is not documented.",
}


def main():
    source, build = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    tools = source / "experiments/packaging/reference"
    doxygen, wrong = shutil.which("doxygen"), []
    if doxygen is None or not (build / "Doxyfile").is_file():
        print("skipped: doxygen is not installed")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def made(headers, settings):
            """The exit code and the words of a reference of these headers."""
            (folder / "Doxyfile").write_text(
                settings + f'\nOUTPUT_DIRECTORY = "{folder}/out"\nWARN_LOGFILE = "{folder}/out/warnings.txt"\n' + headers)
            done = subprocess.run([sys.executable, tools / "make.py", doxygen, folder / "Doxyfile", folder / "out"],
                                  capture_output=True, text=True, check=False)
            return done.returncode, done.stdout + done.stderr

        settings = (build / "Doxyfile").read_text()
        header = folder / "thing.h"
        header.write_text(HEADER % "")
        seen = subprocess.run([sys.executable, tools / "comments.py", header], capture_output=True, text=True, check=True)
        before, after = header.read_text().split("\n"), seen.stdout.split("\n")
        if len(before) != len(after):
            wrong.append("the filter changes the number of lines")
        for line, becomes in LINES.items():
            if after[before.index(line)] != becomes:
                wrong.append(f"{line!r} becomes {after[before.index(line)]!r}, not {becomes!r}")
        only = f'INPUT = "{header}" "{tools / "main.dox"}"\nSTRIP_FROM_PATH = "{folder}"\n'
        # The main page speaks of what this header does not have: Doxygen does not mind.
        code, text = made(only, settings)
        if code != 0:
            wrong.append(f"one good header: {text}")
        for more, complaint in BAD.items():
            header.write_text(HEADER % more)
            code, text = made(only, settings)
            if code != 1 or complaint not in text or (folder / "out/html").exists():
                wrong.append(f"{more!r}: exit code {code}, {text}")
        code, text = made("", settings)
        if code != 0:
            wrong.append(text)
        else:
            page = (folder / "out/html/classkinex_1_1Kernel.html").read_text()
            words = re.sub(r"<[^>]*>|\s+", " ", page)
            if "Withdraws a certificate" not in words:
                wrong.append("the reference does not tell what Kernel::retract does")
    print("\n".join(wrong) or "the reference has no warnings")
    return 1 if wrong else 0


sys.exit(main())
