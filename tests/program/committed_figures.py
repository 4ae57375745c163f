# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws figures in Chromium and looks at their texts, of moving ones at their beginning.

usage: committed_figures.py SOURCE_FOLDER [FIGURE.svg ..]
Without figures: all SVG files that are committed. No text may leave its picture or cover another, a
picture must have a size, and no two entries of a legend may look alike. Exit code 77 (skipped) where there is no Chromium.
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


def entries_of(svg):
    """Of gnuplot's legends: every entry's text, and colour, dashes and symbol of its sample."""
    for group in re.split(r'<g id="gnuplot_plot_\w+" >', svg)[1:]:
        title = re.match(r"<title>(.*?)</title>", group, re.S)
        words = re.search(r"<text>(.*?)</text>", group, re.S)
        text = re.sub("<.*?>", "", words.group(1)) if words else None
        if title is None or text is None or text != title.group(1).replace("^", ""):
            continue  # not in the legend
        found = [re.search(pattern, group[words.end():]) for pattern in (
            r"(?:stroke|color)=['\"](rgb\([^)]*\)|#\w+)", r"stroke-dasharray='([^']*)'", r"xlink:href='#(gpPt\d+)'")]
        yield text, tuple(one and one.group(1) for one in found)


def alike(svg):
    """Entries of a legend that look like an earlier one."""
    looks = {}
    for text, appearance in entries_of(svg):
        if appearance in looks:
            yield f"{text!r} looks like {looks[appearance]!r}"
        looks.setdefault(appearance, text)


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
    entry = '<g id="gnuplot_plot_{0}" ><title>{0}^2</title><text>{0}<tspan>2</tspan></text><path stroke=\'rgb({1})\'/>'
    assert not list(alike(entry.format(1, 0) + entry.format(2, 8))) and list(alike(entry.format(1, 8) + entry.format(2, 8)))


def drawn_by_older_code(file):
    """A figure of the paper whose experiments take hours, drawn before figures had widths; none when its page is made anew."""
    return (file.parent.name == "kds-report-1998"
            and not re.search(r'<svg[^>]*\swidth="', file.read_text(encoding="utf-8")))


def has_guides_of_older_code(svg):
    """Drawn when all guides but the first had one dash: none when all figures are drawn anew."""
    return len(re.findall(r"stroke-dasharray='4.8,2.4,1.2,2.4'", svg)) > 1


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
        text = file.read_text(encoding="utf-8")
        if not has_guides_of_older_code(text):
            faults += [f"{file}: {fault}" for fault in alike(text)]
        head = re.search(r"<svg.*?>", text, re.S).group(0)
        if not re.search(r'\swidth="', head):
            faults.append(f"{file}: it has no width: a page stretches it")
    if faults:
        sys.exit("\n".join(faults))
    print(f"{len(files)} figures, {texts} texts apart from one another")


if __name__ == "__main__":
    main()
