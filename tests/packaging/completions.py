# SPDX-License-Identifier: GPL-3.0-or-later
"""Completion as the shells do it: bash, zsh and fish complete words of command lines of kinex.

usage: completions.py PROGRAM
Exit code 77: none of the three shells is installed beside sh.
"""
import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time

# The words so far, the word to complete, what is offered (exactly one: it is put in).
CASES = [
    (["run"], "--arith", {"--arithmetic"}),
    (["run", "--arithmetic"], "st", {"sturm"}),
    (["run", "scene.json", "--maintain"], "separation_mi", {"separation_minkowski", "separation_mixed"}),
    ([], "rep", {"reproduce"}),
    (["sweep"], "mer", {"merge"}),
    (["sweep", "run"], "--fre", {"--fresh"}),
    (["gen"], "uniform-sq", {"uniform-square"}),
    (["gen", "--n", "5"], "uniform-sq", {"uniform-square"}),
    (["reproduce"], "kds", {"kds-report-1998"}),
    (["list"], "st", {"structures"}),
    (["list"], "pa", {"papers"}),
    (["list", "--family"], "prox", {"proximity"}),
    (["explain"], "delaunay_3", {"delaunay_3"}),
    (["explain"], "uniform-sq", {"uniform-square"}),
    (["explain"], "kds", {"kds-report-1998"}),
    (["help"], "swe", {"sweep"}),
    (["help", "sweep"], "mer", {"merge"}),
    (["import", "--separator"], "semi", {"semicolon"}),
    (["import", "--overlapping-starts"], "con", {"contact"}),
    (["run", "--maintain"], "sorted_list,delaunay_2", {"sorted_list,delaunay_2"}),
    (["run", "--maintain"], "sorted_list,separation_mi",
     {"sorted_list,separation_minkowski", "sorted_list,separation_mixed"}),
    (["reproduce", "kds-report-1998"], "figure", {"figure-3"}),
    (["reproduce", "separation-sensitive-1999"], "transl", {"translation"}),
    (["reproduce", "separation-sensitive-1999"], "figure", set()),
    (["run", "--events"], "some-f", {"some-file.jsonl"}),
    (["check"], "some-f", {"some-file.jsonl"}),
]


def bash(script, words, word, folder):
    line = ["kinex", *words, word]
    code = ('source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _kinex 2>/dev/null; '
            'printf "%s\\n" "${COMPREPLY[@]}"')
    done = subprocess.run(["bash", "--norc", "-c", code, "bash", script, *line], capture_output=True, text=True,
                          cwd=folder, check=False)
    return set(filter(None, done.stdout.split("\n"))), done.stderr


def fish(script, words, word, folder):
    line = " ".join(["kinex", *words, word])
    done = subprocess.run(["fish", "--no-config", "-c", f"source {script}; complete -C '{line}'"],
                          capture_output=True, text=True, cwd=folder, check=False)
    return {offer.split("\t")[0] for offer in done.stdout.split("\n") if offer}, done.stderr


class Zsh:
    """An interactive zsh: the Tab key."""

    def __init__(self, script, folder):
        child, self.terminal = pty.fork()
        if child == 0:
            os.chdir(folder)
            os.environ.update(TERM="dumb", HOME=folder, PS1="", COLUMNS="200")
            os.execvp("zsh", ["zsh", "-f", "-i"])
        self.child = child
        self.send("unsetopt zle_bracketed_paste prompt_cr; autoload -Uz compinit && compinit -u -D; "
                  f"source {script}; setopt no_list_beep no_auto_menu; print READY:$((6 * 7))\n")
        self.wait("READY:42")

    def send(self, text):
        os.write(self.terminal, text.encode())

    def wait(self, pattern):
        text, end = "", time.monotonic() + 30
        while time.monotonic() < end:
            if select.select([self.terminal], [], [], 0.2)[0]:
                try:
                    text += os.read(self.terminal, 65536).decode(errors="replace")
                except OSError:
                    break
                if re.search(pattern, text):
                    return text
        sys.exit(f"zsh does not answer: {text[-500:]}")

    def completed(self, line):
        """The line as it is after Tab."""
        self.send(line + "\t")
        time.sleep(0.4)
        self.send("\x01print -r -- OUT: \x05 :END\n")
        text = self.wait(r"\nOUT: .* :END")
        return re.search(r"\nOUT: (.*?) *:END", text).group(1)

    def close(self):
        self.send("\x03exit\n")
        os.close(self.terminal)
        os.waitpid(self.child, 0)


def main():
    program, wrong, tried = sys.argv[1], [], []
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "some-file.jsonl").write_text("")
        for shell in ("bash", "zsh", "fish"):
            script = str(pathlib.Path(folder, "kinex." + shell))
            made = subprocess.run([program, "completion", shell], capture_output=True, text=True, check=True)
            pathlib.Path(script).write_text(made.stdout)
            if shutil.which(shell) is None:
                print(f"{shell} is not installed")
                continue
            tried.append(shell)
            syntax = subprocess.run([shell, "-n", script], capture_output=True, text=True, check=False)
            if syntax.returncode != 0 or syntax.stderr:
                wrong.append(f"{shell} -n: {syntax.stderr}")
                continue
            zsh = Zsh(script, folder) if shell == "zsh" else None
            for words, word, offers in CASES:
                line = " ".join(["kinex", *words, word])
                if zsh is not None:
                    if len(offers) > 1:
                        continue
                    expected = " ".join(["kinex", *words, *(offers or [word])])
                    found = zsh.completed(line)
                    if found != expected:
                        wrong.append(f"zsh: {line!r} becomes {found!r}, not {expected!r}")
                    continue
                found, said = (bash if shell == "bash" else fish)(script, words, word, folder)
                if found != offers or said:
                    wrong.append(f"{shell}: {line!r} offers {sorted(found)}, not {sorted(offers)}; {said}")
            if zsh is not None:
                zsh.close()
        # Every verb that the help lists is completed, and no hidden one.
        text = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
        listed = re.findall(r"^  ([a-z]+) ", text[text.index("Subcommands:"):].split("\n\n")[0], re.MULTILINE)
        verbs = subprocess.run([program, "completion", "verbs"], capture_output=True, text=True, check=True)
        if [verb for verb in verbs.stdout.split("\n") if verb and " " not in verb] != listed:
            wrong.append(f"the help lists {listed}, completion {verbs.stdout.split()}")
    refused = subprocess.run([program, "completion", "csh"], capture_output=True, text=True, check=False)
    if refused.returncode != 2 or not refused.stderr.startswith("kinex: completion: ") or "zsh" not in refused.stderr:
        wrong.append(f"completion csh: {refused}")
    print("\n".join(wrong) or f"{', '.join(tried)} complete {len(CASES)} lines as they should")
    if not wrong and not tried:
        return 77
    return 1 if wrong else 0


sys.exit(main())
