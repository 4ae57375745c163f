# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens a page in headless Chromium and returns what a probe in it has found."""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

# No network, no profile of an earlier start: either can keep a start waiting for minutes.
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--disable-dev-shm-usage", "--window-size=1400,1000", "--virtual-time-budget=5000"]
STARTS = 4
SECONDS = 120  # one start; a page here takes a few


def browser():
    """The browser's name; ends the program as a skipped test (77) where there is none."""
    for name in ("chromium", "chromium-browser", "google-chrome"):
        if shutil.which(name):
            return name
    print("skipped: there is no chromium; install the package chromium")
    sys.exit(77)


def dump(chromium, address, flags=()):
    """The page's document after its scripts have run. A browser that hangs is started again."""
    for start in range(STARTS):
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
            try:
                return subprocess.run(
                    [chromium, *FLAGS, *flags, f"--user-data-dir={profile}", "--dump-dom", address],
                    stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                    text=True, timeout=SECONDS, check=True).stdout
            except (subprocess.TimeoutExpired, subprocess.CalledProcessError) as failure:
                print(f"start {start + 1} of {chromium}: {failure}", file=sys.stderr)
    sys.exit(f"{chromium} does not work: {STARTS} starts have failed")


def ask(chromium, html, probe, fragment="", flags=()):
    """`probe` is put at the end of the page's body; it leaves JSON in <pre id="probe">."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "probe.html"
        path.write_text(html.replace("</body>", probe + "</body>"), encoding="utf-8")
        document = dump(chromium, path.as_uri() + fragment, flags)
    found = re.search(r'<pre id="probe">(.*?)</pre>', document, re.S)
    if found is None:
        sys.exit("the probe has left nothing in the page")
    answer = found.group(1)
    for entity, sign in (("&lt;", "<"), ("&gt;", ">"), ("&amp;", "&")):
        answer = answer.replace(entity, sign)
    return json.loads(answer)
