# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the page of `kinex trade` in Chromium and looks at what is drawn there.

usage: trade_page.py PROGRAM
Every picture must be decoded and have a size, nothing may stick out of the window, every text of
the pictures must be inside of it and none may cover another, and the page must ask for nothing from
outside. Exit code 77 (skipped) where there is no Chromium.
"""
import base64
import pathlib
import re
import subprocess
import sys
import tempfile

from chromium import ask, browser

# What the browser is asked; the answer becomes the text of one element.
PROBE = """
<pre id="probe"></pre><script>
addEventListener("load", () => {
  const images = [...document.images].map(i => i.complete && i.naturalWidth > 100);
  document.getElementById("probe").textContent = JSON.stringify({
    images: images, width: document.documentElement.scrollWidth, window: innerWidth,
    cut: [...document.querySelectorAll(".wide")].filter(d => d.scrollWidth > d.clientWidth).map(d => d.innerText.slice(0, 60)),
    tables: document.querySelectorAll("table").length, text: document.body.innerText,
    resources: performance.getEntriesByType("resource").map(e => e.name.slice(0, 20))});
});
</script>"""
LABELS = """
<pre id="probe"></pre><script>
addEventListener("load", () => {
  document.getElementById("probe").textContent = JSON.stringify(
    [...document.querySelectorAll("svg")].map(svg => {
      const all = svg.getBoundingClientRect();
      return [...svg.querySelectorAll("text")].filter(t => t.textContent.trim()).map(t => {
        const b = t.getBoundingClientRect();
        return [t.textContent, b.left - all.left, b.top - all.top, b.right - all.left,
                b.bottom - all.top, all.width, all.height];
      });
    }));
});
</script>"""
SLACK = 2.5  # pixels: boxes of texts are higher than what is drawn


def check_labels(pictures):
    labels = 0
    for texts in pictures:
        for i, (text, left, top, right, bottom, width, height) in enumerate(texts):
            labels += 1
            if left < -SLACK or top < -SLACK or right > width + SLACK or bottom > height + SLACK:
                sys.exit(f"{text!r} sticks out of its picture")
            for other in texts[:i]:
                apart = (right - SLACK <= other[1] or other[3] <= left + SLACK
                         or bottom - SLACK <= other[2] or other[4] <= top + SLACK)
                if not apart:
                    sys.exit(f"{text!r} covers {other[0]!r}")
    return labels


def main():
    chromium = browser()
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.argv[1], "trade", "sorted_list", "delaunay_2", "--quick", "-o", folder,
                        "--arithmetic", "gsl,mpfr:24,mpfr:53,mpfr:64,mpfr:100,mpfr:200"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        html = (pathlib.Path(folder) / "trade.html").read_text(encoding="utf-8")
        seen = ask(chromium, html, PROBE)
        if len(seen["images"]) != 4 or not all(seen["images"]):
            sys.exit(f"pictures: {seen['images']}")
        if seen["width"] > seen["window"]:
            sys.exit(f"the page is {seen['width']} wide in a window of {seen['window']}")
        if any(not name.startswith("data:") for name in seen["resources"]):
            sys.exit(f"it loads {seen['resources']}")
        narrow = ask(chromium, html, PROBE, flags=["--window-size=1200,1000"])
        if narrow["window"] != 1200 or narrow["cut"]:
            sys.exit(f"in a window of {narrow['window']} pixels these tables are cut off: {narrow['cut']}")
        for text in ("delaunay_2: speed and accuracy", "near-one-point", "mpfr:200", "needs"):
            if text not in seen["text"]:
                sys.exit(f"{text!r} is not to be seen")
        svgs = re.findall(r'src="data:image/svg\+xml;base64,([^"]*)"', html)
        drawn = "".join(base64.b64decode(svg).decode().split("?>", 1)[1] for svg in svgs)
        drawn = re.sub(r"<!DOCTYPE.*?>", "", drawn, flags=re.S)
        labels = check_labels(
            ask(chromium, f"<!DOCTYPE html><html><body>{drawn}</body></html>", LABELS))
        if labels < 40:
            sys.exit(f"only {labels} texts are in the pictures")
    print(f"{len(seen['images'])} pictures, {labels} texts apart from one another, "
          f"{seen['tables']} tables")


main()
