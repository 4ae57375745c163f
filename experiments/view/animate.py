#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes an animation of a page of `kinex view`, drawn by a headless Chromium.

usage: animate.py PAGE.html OUTPUT [options]

OUTPUT.mp4 and OUTPUT.gif need ffmpeg; OUTPUT.png is an animated PNG, which needs nothing; OUTPUT.svg is one
picture, after the log record of --record; any other name is a folder for the frames (frame-0001.png, ..). Frames
are equally spaced in time, or one for each log record; if there are more records than --frames, a message says so.
With --force files are replaced, none is removed: a folder with more frames of an earlier animation is refused.
Standard library only. Exit codes: 2 bad input, 3 Chromium or ffmpeg is missing or fails.
"""
import argparse
import base64
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

from devtools import Browser, BrowserError

PAGE_MARK = "window.kinexFrame"  # what draws a frame of a page
PNG = b"\x89PNG\r\n\x1a\n"


def options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--frames", type=int, default=120, help="number of frames (120)")
    parser.add_argument("--fps", type=int, default=24, help="frames a second (24)")
    parser.add_argument("--records", action="store_true", help="a frame for each log record, at most --frames")
    parser.add_argument("--record", type=int, help="of an SVG: the log record after which it is drawn (the last one)")
    parser.add_argument("--from", dest="begin", type=float, default=0, help="part of the time shown, 0 to 1 (0)")
    parser.add_argument("--to", dest="end", type=float, default=1, help="likewise (1)")
    parser.add_argument("--size", default="640x480", help="of the picture in pixels (640x480)")
    parser.add_argument("--structure", help="label of the structure to show")
    parser.add_argument("--drawing", choices=["plane", "time", "axis", "tree"])
    parser.add_argument("--dark", action="store_true")
    parser.add_argument("--no-caption", action="store_true")
    parser.add_argument("--force", action="store_true", help="replace what exists")
    return parser.parse_args()


def bad_input(text):
    print(f"kinex: {text}", file=sys.stderr)
    sys.exit(2)


def checked(chosen):
    """Width and height; ends with a message where something is wrong."""
    if not chosen.page.is_file():
        bad_input(f"{chosen.page}: there is no such page; make one with kinex view SCENE -o {chosen.page}")
    if PAGE_MARK not in chosen.page.read_text(encoding="utf-8", errors="replace"):
        bad_input(f"{chosen.page}: it is no page of kinex view; make one with kinex view SCENE -o PAGE.html")
    if chosen.output.exists() and not chosen.force:
        bad_input(f"{chosen.output}: it exists already; give another name, or --force")
    width, _, height = chosen.size.partition("x")
    if not (width.isdigit() and height.isdigit() and 64 <= int(width) <= 4096 and 64 <= int(height) <= 4096):
        bad_input(f"--size: {chosen.size!r} is not WIDTHxHEIGHT from 64 to 4096; write 640x480")
    if chosen.frames < 1 or not 1 <= chosen.fps <= 120 or not 0 <= chosen.begin < chosen.end <= 1:
        bad_input("--frames, --fps, --from, --to: out of range; leave them out for the whole run")
    if chosen.output.suffix not in ("", ".svg", ".png", ".gif", ".mp4"):
        bad_input(f"{chosen.output}: {chosen.output.suffix} is no kind of picture; write .svg, .png, .gif or .mp4, or a "
                  "folder's name without a point")
    if chosen.output.is_dir() if chosen.output.suffix else chosen.output.is_file():
        bad_input(f"{chosen.output}: it is a {'folder' if chosen.output.suffix else 'file'}; give another name")
    if chosen.output.suffix and not chosen.output.parent.is_dir():
        bad_input(f"{chosen.output}: there is no folder {chosen.output.parent}; make it, or name another one")
    if chosen.record is not None and chosen.output.suffix != ".svg":
        bad_input("--record: it is for one picture; write OUTPUT.svg, or leave it out")
    return int(width), int(height)


def opened(chosen, browser):
    """Opens the page, with the structure and the drawing that are wanted."""
    browser.open(chosen.page.resolve().as_uri())
    browser.evaluate("new Promise(done => { const wait = setInterval(() => { if (window.kinexFrame) {"
                     " clearInterval(wait); done(); } }, 20); })")
    if chosen.structure:
        found = browser.evaluate(f"DATA.structures.findIndex(s => s.label === {chosen.structure!r})")
        if found < 0:
            bad_input(f"--structure: {chosen.structure!r} is not on the page")
        browser.evaluate(f"app.setStructure({found})")
    if chosen.drawing:
        browser.evaluate(f"app.setMode({chosen.drawing!r})")


def drawing(chosen, width, height):
    """One picture, as SVG."""
    with Browser(max(width, 1100), max(height, 800), chosen.dark) as browser:
        opened(chosen, browser)
        first, last = browser.evaluate("[eventsUntil(FIRST, 0), eventsUntil(FIRST, 1)]")
        record = last if chosen.record is None else chosen.record
        if not first <= record <= last:
            bad_input(f"--record: the page has no log record {record}; write a number from {first} to {last}")
        return browser.evaluate(f"(app.setEvent({record}), app.draw(), pictureAsSvg({width}, {height}))")


def check_stale(folder, count):
    """Ends with a message if frames of an earlier animation would stay behind those of this one."""
    new = {frame_name(number) for number in range(1, count + 1)}
    stale = sorted(file.name for file in folder.glob("frame-*.png") if file.name not in new)
    if stale:
        bad_input(f"{folder}: {stale[0]}{' to ' + stale[-1] if len(stale) > 1 else ''} would stay there, of an earlier "
                  f"animation, after the {count} frames of this one; remove {'them' if len(stale) > 1 else 'it'}, or name "
                  "another folder")


def frame_name(number):
    return f"frame-{number:04d}.png"


def frames(chosen, width, height, folder=None):
    """The frames' PNGs, one after the other; `folder`: where they will be."""
    with Browser(max(width, 1100), max(height, 800), chosen.dark) as browser:
        opened(chosen, browser)
        places = [f"u: {chosen.begin + (chosen.end - chosen.begin) * i / max(1, chosen.frames - 1)}"
                  for i in range(chosen.frames)]
        if chosen.records:
            first, last = browser.evaluate(f"[eventsUntil(FIRST, {chosen.begin}), eventsUntil(FIRST, {chosen.end})]")
            places = [f"event: {k}" for k in range(first, last + 1)][:chosen.frames]
            if len(places) < last + 1 - first:
                print(f"kinex: {last + 1 - first} frames for all log records, {len(places)} are drawn: those up to record "
                      f"{first + len(places) - 1}; give --frames {last + 1 - first} for all", file=sys.stderr)
        if folder is not None:
            check_stale(folder, len(places))
        for place in places:
            address = browser.evaluate(f"kinexFrame({{ {place}, width: {width}, height: {height}, "
                                       f"caption: {str(not chosen.no_caption).lower()} }})")
            yield base64.b64decode(address.split(",", 1)[1])


def chunks(png):
    """(type, data) of a PNG's chunks."""
    at = len(PNG)
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        yield kind, png[at + 8:at + 8 + size]
        at += 12 + size


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def animated_png(pictures, fps):
    """The frames as one animated PNG, which repeats without end; browsers show it like any image."""
    head = next(data for kind, data in chunks(pictures[0]) if kind == b"IHDR")
    width, height = struct.unpack(">II", head[:8])
    result = PNG + chunk(b"IHDR", head) + chunk(b"acTL", struct.pack(">II", len(pictures), 0))
    number = 0
    for i, picture in enumerate(pictures):
        delay = fps if i + 1 < len(pictures) else 1  # the last one stays for a second
        control = struct.pack(">IIIIIHHBB", number, width, height, 0, 0, 1, delay, 0, 0)
        result += chunk(b"fcTL", control)
        number += 1
        data = b"".join(data for kind, data in chunks(picture) if kind == b"IDAT")
        if i == 0:
            result += chunk(b"IDAT", data)
        else:
            result += chunk(b"fdAT", struct.pack(">I", number) + data)
            number += 1
    return result + chunk(b"IEND", b"")


def by_ffmpeg(folder, chosen):
    program = shutil.which("ffmpeg")
    if program is None:
        print(f"kinex: ffmpeg is not installed; write {chosen.output.with_suffix('.png').name} (an animated PNG) or a "
              "folder instead", file=sys.stderr)
        sys.exit(3)
    how = (["-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse", "-loop", "0"] if chosen.output.suffix == ".gif"
           else ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"])
    subprocess.run([program, "-loglevel", "error", "-y", "-framerate", str(chosen.fps), "-i",
                    str(folder / "frame-%04d.png"), *how, str(chosen.output)], check=True)


def write(chosen, width, height):
    if chosen.output.suffix == ".svg":
        chosen.output.write_text(drawing(chosen, width, height) + "\n", encoding="utf-8")
        return
    if chosen.output.suffix == ".png":
        chosen.output.write_bytes(animated_png(list(frames(chosen, width, height)), chosen.fps))
        return
    video = chosen.output.suffix in (".mp4", ".gif")
    if video and shutil.which("ffmpeg") is None:
        by_ffmpeg(None, chosen)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) if video else chosen.output
        folder.mkdir(parents=True, exist_ok=True)
        for number, picture in enumerate(frames(chosen, width, height, folder), 1):
            (folder / frame_name(number)).write_bytes(picture)
        if video:
            by_ffmpeg(folder, chosen)


def main():
    chosen = options()
    width, height = checked(chosen)
    try:
        write(chosen, width, height)
    except OSError as failure:
        bad_input(f"{failure.filename or chosen.output}: {failure.strerror or failure}; name another place")
    except (BrowserError, subprocess.CalledProcessError) as failure:
        print(f"kinex: no animation: {failure}", file=sys.stderr)
        sys.exit(3)
    print(f"{chosen.output} is written")


if __name__ == "__main__":
    main()
