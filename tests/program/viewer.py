# SPDX-License-Identifier: GPL-3.0-or-later
"""A page of `kinex view` in a browser, as the tests of pages drive it."""
import json
import pathlib
import subprocess

READY = "new Promise(done => { const wait = setInterval(() => { if (window.kinexState) { clearInterval(wait); done(); } }, 20); })"
# What a page draws it draws in its next frame, which comes late on a busy machine: the second frame from here comes after it.
SETTLE = "new Promise(done => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(() => done())), 80))"


class Viewer:
    """A page in a browser."""

    def __init__(self, program, folder, window):
        self.program, self.folder, self.window = program, pathlib.Path(folder), window

    def kinex(self, *arguments):
        subprocess.run([self.program, *arguments], cwd=self.folder, check=True, stdout=subprocess.DEVNULL)

    def open(self, name):
        self.window.open((self.folder / name).as_uri())
        self.ask(READY)

    def look(self, name, scene):
        """Opens the page of a scene, or of what `gen` makes."""
        if isinstance(scene, dict):
            (self.folder / f"{name}.json").write_text(json.dumps(scene))
        else:
            self.kinex("gen", *scene, "-o", f"{name}.json")
        self.kinex("view", f"{name}.json", "-o", f"{name}.html")
        self.open(f"{name}.html")

    def ask(self, expression):
        return self.window.evaluate(expression)

    def say(self, statement):
        self.ask(f"(() => {{ {statement} }})()")
        self.ask(SETTLE)
