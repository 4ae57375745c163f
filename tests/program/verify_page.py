# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the page of `kinex verify` in Chromium: verdict, filter, order, anchors, commands, pictures.

usage: verify_page.py PROGRAM
Exit code 77 (skipped) where there is no Chromium.
"""
import base64
import hashlib
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

from chromium import ask, browser
from committed_figures import alike, faults_of, look

PROBE = """
<pre id="probe"></pre><script>
addEventListener("load", () => {
  const table = document.querySelector("#cells").closest("section").querySelector("table.data");
  const shown = () => [...table.tBodies[0].rows].filter(r => !r.hidden && !r.classList.contains("more"));
  const column = i => shown().map(r => r.cells[i].textContent);
  const input = table.parentElement.previousElementSibling.querySelector("input");
  const filter = text => { input.value = text; input.dispatchEvent(new Event("input")); return shown().length; };
  const opened = [...document.querySelectorAll("tr.more")].filter(r => !r.hidden).map(r => r.innerText);
  const all = filter("");
  const heads = table.tHead.rows[0].cells;
  const n = [...heads].findIndex(head => head.textContent === "n");
  heads[n].querySelector("button").click();
  const up = column(n);
  heads[n].querySelector("button").click();
  const down = column(n);
  document.getElementById("probe").textContent = JSON.stringify({
    top: document.body.innerText.slice(0, 200), opened, all, some: filter("uniform-square -2d 16"), up, down,
    commands: [...document.querySelectorAll("tr.more")].slice(0, 3).map(r => [r.textContent.match(/SHA-256 (\\w+)/)[1],
      r.querySelector("pre").textContent.split("\\n")[0]]),
    images: [...document.images].map(i => i.complete && i.naturalWidth > 100),
    away: [...document.querySelectorAll("td .v")].filter(v => v.offsetParent !== null).map(v => v.closest("td").getBoundingClientRect())
      .filter(b => b.left < 0 || b.right > innerWidth).length,
    verdicts: document.querySelectorAll("td .v").length,
    width: document.documentElement.scrollWidth, window: innerWidth, back: getComputedStyle(document.body).backgroundColor,
    dead: [...document.querySelectorAll("nav a, td a, h2 a, h3 a")].map(a => a.getAttribute("href"))
      .filter(h => h.startsWith("#") && !document.getElementById(h.slice(1))),
    resources: performance.getEntriesByType("resource").map(e => e.name.slice(0, 20))});
});
</script>"""


def fail(text):
    sys.exit(f"verify_page: {text}")


def main():
    program, chromium = sys.argv[1], browser()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        done = subprocess.run([program, "verify", "sorted_list", "--quick", "-o", folder], stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, text=True, check=True)
        lines = done.stdout.splitlines()
        verdict = re.fullmatch(r"(\d+) of (\d+) hold; 0 fail; (\d+) agrees?, [a-z ]+; \d+ (s|min)", lines[0])
        if len(lines) != 3 or not verdict or int(verdict[1]) + int(verdict[3]) != int(verdict[2]):
            fail(f"the command ends with {done.stdout!r}")
        if len((folder / "verify.txt").read_text().splitlines()) < int(verdict.group(1)):
            fail("the long table is not in verify.txt")
        if "\nbound     the hard bound" not in (folder / "verify.txt").read_text():
            fail("verify.txt does not say what its columns are")
        html = (folder / "verify.html").read_text(encoding="utf-8")
        anchor = re.search(r'<tr id="([^"]*)"', html).group(1)
        seen = ask(chromium, html, PROBE, "#" + anchor)
        small = ask(chromium, html, PROBE, "", ["--window-size=420,900", "--force-dark-mode",
                                                "--blink-settings=preferredColorScheme=0"])
        if not seen["top"].startswith("kinex verify") or lines[0] not in seen["top"]:
            fail(f"the page begins with {seen['top']!r}")
        if len(seen["opened"]) != 1 or "kinex gen" not in seen["opened"][0]:
            fail(f"#{anchor} unfolds {seen['opened']}")
        if not 0 < seen["some"] < seen["all"]:
            fail(f"the filter leaves {seen['some']} of {seen['all']} rows")
        if [int(n) for n in seen["up"]] != sorted(map(int, seen["up"])) or int(seen["down"][0]) != max(map(int, seen["up"])):
            fail(f"sorted by n: {seen['up']}, then {seen['down']}")
        for page in (seen, small):
            if not page["images"] or not all(page["images"]) or page["dead"]:
                fail(f"pictures {page['images']}, dead links {page['dead']}")
            if page["width"] > page["window"] or any(not r.startswith("data:") for r in page["resources"]):
                fail(f"{page['width']} wide in {page['window']}, loads {page['resources']}")
        if small["away"] or small["verdicts"] < small["all"]:
            fail(f"in a window of {small['window']} pixels {small['away']} of {small['verdicts']} verdicts are out of sight")
        if small["back"] == seen["back"]:
            fail(f"the page is as light in the dark: {small['back']}")
        for digest, command in seen["commands"]:
            words = shlex.split(command)
            made = folder / "made.json"
            subprocess.run([program, *words[1:-1], made, "--force"], check=True)
            if hashlib.sha256(made.read_bytes()).hexdigest() != digest:
                fail(f"{command} makes another scene than {digest}")
        svgs = [base64.b64decode(svg).decode() for svg in re.findall(r'src="data:image/svg\+xml;base64,([^"]*)"', html)]
        drawings = [f"<div>{re.sub(r'<!DOCTYPE.*?>|<[?].*?[?]>', '', svg, flags=re.S)}</div>" for svg in svgs]
        pictures = look(chromium, drawings)
        faults = [fault for picture in pictures for fault in faults_of(picture)] + [fault for svg in svgs for fault in alike(svg)]
        if faults:
            fail("; ".join(faults))
        for svg in svgs:
            title = re.search(r"<title>(.*?)</title>", svg)[1]
            description = re.search(r"<desc>(.*?)</desc>", svg, re.S)[1]
            if not title.startswith("sorted_list: ") or len(description) < 40 or "gnuplot" in svg.split('id="gnuplot_canvas"')[0].lower():
                fail(f"a picture is called {title!r}, described as {description!r}")
        for picture in pictures:  # each says by itself what it shows
            words = " ".join(text for text, _ in picture["texts"])
            if "sorted_list: " not in words or "uniform-square" not in words:
                fail(f"a picture names no structure or no workload: {words}")
    print(json.dumps({"rows": seen["all"], "pictures": len(svgs), "dark": small["back"]}))


if __name__ == "__main__":
    main()
