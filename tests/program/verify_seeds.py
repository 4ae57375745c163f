# SPDX-License-Identifier: GPL-3.0-or-later
"""Few random scenes say that they are few: `kinex verify NAME --quick --seeds S`, for all structures together.

usage: verify_seeds.py PROGRAM SEEDS,.. [NAME,..]

No experiment may fail for want of scenes: the exit code is 0 or 3, nothing is FAIL, no number is inf or nan,
and exit code 3 comes with the number of scenes that would do.
"""
import re
import subprocess
import sys
import tempfile


def problems(program, name, seeds, folder):
    done = subprocess.run([program, "verify", name, "--quick", "--seeds", seeds, "-o", folder, "--force"],
                          capture_output=True, text=True)
    text = done.stdout + done.stderr
    if done.returncode not in (0, 3):
        yield f"exit code {done.returncode}"
    if re.search(r"\bFAIL\b", re.sub(r"\b0 FAIL\b", "", text)):
        yield "FAIL"
    yield from (f"the number {word}" for word in sorted(set(re.findall(r"\b(?:inf|nan)\b", text, re.IGNORECASE))))
    if done.returncode == 3 and not re.search(r"--seeds \d+ would do", text):
        yield "it does not say how many scenes would do"


def main():
    program, counts = sys.argv[1], sys.argv[2].split(",")
    names = sys.argv[3].split(",") if len(sys.argv) > 3 else ["all"]
    wrong = []
    for name in names:
        for seeds in counts:
            with tempfile.TemporaryDirectory() as folder:
                found = list(problems(program, name, seeds, folder))
            wrong += [f"verify {name} --quick --seeds {seeds}: {problem}" for problem in found]
            print(name, seeds, "; ".join(found) or "fine", flush=True)
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


main()
