# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws figures in Chromium and looks at their texts, of moving ones at their beginning.

usage: committed_figures.py SOURCE_FOLDER [FIGURE.svg ..]
Without figures: all SVG files that are committed. No text may leave its picture or cover another, and a
picture must have a size. Exit code 77 (skipped) where there is no Chromium.
"""
import pathlib
import re
import subprocess
import sys

from chromium import ask, browser

# The boxes of all texts of every picture, in its own pixels. A text that is turned is as wide as it is high.
PROBE = """
<pre id="probe"></pre><script>
addEventListener("load", () => {
  document.getElementById("probe").textContent = JSON.stringify(
    [...document.querySelectorAll("div > svg")].map(svg => {
      const all = svg.getBoundingClientRect();
      const box = element => {
        const b = element.getBoundingClientRect();
        return [b.left - all.left, b.top - all.top, b.right - all.left, b.bottom - all.top];
      };
      return { size: [all.width, all.height], texts: [...svg.querySelectorAll("text")]
        .filter(t => t.textContent.trim() && t.checkVisibility({ opacityProperty: true, visibilityProperty: true })).map(t => [t.textContent.trim().replace(/\\s+/g, " "), box(t)]) };
    }));
});
</script>"""
SLACK = 2.5  # pixels: boxes of texts are higher than what is drawn


def faults_of(picture):
    """What is wrong with the texts of one picture."""
    (width, height), texts = picture["size"], picture["texts"]
    for i, (text, (left, top, right, bottom)) in enumerate(texts):
        if left < -SLACK or top < -SLACK or right > width + SLACK or bottom > height + SLACK:
            yield f"{text!r} leaves the picture"
        for other, (a, b, c, d) in texts[:i]:
            if right - SLACK > a and c > left + SLACK and bottom - SLACK > b and d > top + SLACK:
                yield f"{text!r} covers {other!r}"


def inline(file):
    """The SVG element of a file, without what only a file of its own may have."""
    text = file.read_text(encoding="utf-8")
    text = re.sub(r"<!DOCTYPE.*?>|<\?.*?\?>", "", text, flags=re.S)
    return f"<div>{text[text.index('<svg'):]}</div>"


def look(chromium, drawings):
    return ask(chromium, "<!DOCTYPE html><html><body>" + "".join(drawings) + "</body></html>", PROBE)


def committed(root):
    listed = subprocess.run(["git", "-C", root, "ls-files", "*.svg"], stdout=subprocess.PIPE, text=True,
                            check=False).stdout.split()
    return [root / name for name in listed] or sorted(
        file for folder in ("papers", "experiments") for file in (root / folder).rglob("*.svg"))


def self_test(chromium):
    """The look sees a text outside and one over another."""
    svg = '<div><svg width="200" height="100"><text x="{}" y="50">first</text><text x="80" y="{}">second</text></svg></div>'
    apart, covered, outside = look(chromium, [svg.format(10, 90), svg.format(70, 52), svg.format(190, 90)])
    assert not list(faults_of(apart)), list(faults_of(apart))
    assert "covers" in next(faults_of(covered)) and "leaves" in next(faults_of(outside))


def drawn_by_older_code(file):
    """A figure of the paper whose experiments take hours, drawn before figures had widths; none when its page is made anew."""
    return (file.parent.name == "kds-report-1998"
            and not re.search(r'<svg[^>]*\swidth="', file.read_text(encoding="utf-8")))


def main():
    chromium = browser()
    self_test(chromium)
    root = pathlib.Path(sys.argv[1])
    files = [pathlib.Path(name) for name in sys.argv[2:]] or [
        file for file in committed(root) if not drawn_by_older_code(file)]
    if not files:
        sys.exit("there are no figures")
    faults, texts = [], 0
    for file, picture in zip(files, look(chromium, [inline(file) for file in files])):
        texts += len(picture["texts"])
        faults += [f"{file}: {fault}" for fault in faults_of(picture)]
        head = re.search(r"<svg.*?>", file.read_text(encoding="utf-8"), re.S).group(0)
        if not re.search(r'\swidth="', head):
            faults.append(f"{file}: it has no width: a page stretches it")
    if faults:
        sys.exit("\n".join(faults))
    print(f"{len(files)} figures, {texts} texts apart from one another")


if __name__ == "__main__":
    main()
