# SPDX-License-Identifier: GPL-3.0-or-later
"""experiments/view/animate.py says what is wrong before it asks for a browser: it waits for no page that cannot be
drawn, and leaves no traceback.

usage: animation_errors.py PROGRAM SOURCE_FOLDER
"""
import pathlib
import subprocess
import sys
import tempfile


def main():
    program, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for words in (("gen", "uniform-square", "--n", "4", "-o", "square.json"),
                      ("view", "square.json", "-o", "square.html")):
            subprocess.run([program, *words], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        (folder / "other.html").write_text("<html><body>A page</body></html>", encoding="utf-8")
        (folder / "frames").write_text("a file", encoding="utf-8")
        (folder / "folder.png").mkdir()
        for words, message in (
                (("none.html", "run.png"), "none.html: there is no such page; make one with kinex view SCENE -o none.html"),
                (("other.html", "run.png"), "other.html: it is no page of kinex view; make one with kinex view SCENE -o"),
                (("square.html", "nowhere/run.png"), "nowhere/run.png: there is no folder nowhere; make it, or name another"),
                (("square.html", "frames", "--force"), "frames: it is a file; give another name"),
                (("square.html", "folder.png", "--force"), "folder.png: it is a folder; give another name"),
                (("square.html", "run.avi"), "run.avi: .avi is no kind of picture; write .svg, .png, .gif or .mp4")):
            done = subprocess.run([sys.executable, "-B", source / "experiments" / "view" / "animate.py", *words], cwd=folder,
                                  text=True, capture_output=True, timeout=30, check=False)
            assert done.returncode == 2 and done.stderr.startswith("kinex: " + message), (words, done)
            assert done.stderr.count("\n") == 1, done.stderr
        assert (folder / "frames").read_text(encoding="utf-8") == "a file"


if __name__ == "__main__":
    main()
