# SPDX-License-Identifier: GPL-3.0-or-later
"""kinex-logcheck: checks an event log of kinex; a program that shares no line of code with kinex."""

import argparse
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from checker import Checker  # noqa: E402
from log import Log, Wrong  # noqa: E402
from progress import Progress  # noqa: E402
from roots import GaveUp  # noqa: E402
from scene import LOG_REMEDY, SCENE_REMEDY, BadInput, Scene  # noqa: E402

LEVELS = {
    0: "format, sequence, digest, seal, counts; the scene's hash",
    1: "every instant's name, and their order",
    2: "every certificate, made anew: zero at its instant and negative right after it",
    3: "replay: every event is legal where it stands",
    4: "completeness: the checker's own proof, in which every failure has its event",
    5: "small scenes: the attribute from scratch between all instants at which it could change",
}


REMEDIES = {
    "wrong": "run the scene again (kinex run SCENE --events LOG); a new log that is refused, too, is a defect of kinex "
             "or of this program: report it with the scene",
    "gave up": "ask for fewer levels (--levels 0-2), or give a log of fewer objects or of a shorter time (kinex run "
               "--until T)",
}


def levels_of(text):
    levels = set()
    for part in text.split(","):
        first, _, last = part.partition("-")
        if not first.isdigit() or (last and not last.isdigit()):
            raise argparse.ArgumentTypeError("levels are written 0-5, 3 or 0,2-4")
        if int(last or first) < int(first):
            raise argparse.ArgumentTypeError("%s holds no level; write %s-%s" % (part, last, first))
        if int(last or first) > max(LEVELS):
            raise argparse.ArgumentTypeError("%s: the levels are 0 to %d" % (part, max(LEVELS)))
        levels.update(range(int(first), int(last or first) + 1))
    return levels


def arguments():
    parser = argparse.ArgumentParser(
        prog="kinex-logcheck", description="Checks an event log of kinex (version 2) with exact arithmetic of its own.",
        epilog="levels:\n" + "\n".join("  %d  %s" % item for item in LEVELS.items())
        + "\n\nexit codes: 0 fine, 1 the log is wrong, 2 bad input or usage, 3 gave up at a limit"
        "\n\nexample:\n  kinex run scene.json --events run.jsonl\n  kinex-logcheck run.jsonl --scene scene.json",
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("log", metavar="LOG", help="the event log, - reads standard input")
    parser.add_argument("--scene", metavar="SCENE",
                        help="the scene that was run, - reads standard input; without it levels 0 and 1 only")
    parser.add_argument("--levels", type=levels_of, default=set(LEVELS), metavar="L",
                        help="which levels, as 0-4 or 1,3 (default: all that the input allows)")
    parser.add_argument("--json", action="store_true", help="a report as one JSON object")
    parser.add_argument("-v", "--verbose", action="store_true",
                        help="say on standard error how far it is, every few seconds; on a terminal it always does")
    options = parser.parse_args()
    if options.log == "-" == options.scene:
        parser.error("--scene: standard input is the log already; give the scene's file")
    return options


def read(path, remedy, binary=False):
    try:
        if path == "-":
            data = sys.stdin.buffer.read()
        else:
            with open(path, "rb") as file:
                data = file.read()
        return data if binary else data.decode("utf-8-sig")
    except OSError as error:
        raise BadInput("%s: %s; %s" % (path, error.strerror, remedy)) from None
    except UnicodeDecodeError as error:
        raise BadInput("%s: not UTF-8 (byte %d); %s" % (path, error.start, remedy)) from None


def levels_text(levels):
    """"level 0", "levels 0 and 1", "levels 1 to 5", "levels 0, 2 and 4"."""
    levels = sorted(levels)
    if len(levels) > 2 and levels[-1] - levels[0] == len(levels) - 1:
        return "levels %d to %d" % (levels[0], levels[-1])
    words = ", ".join(map(str, levels[:-1])) + " and " * (len(levels) > 1) + str(levels[-1])
    return ("level" if len(levels) == 1 else "levels") + " " + words


def verdict(checker):
    """Of a log without a fault. Where the input does not allow all levels: which were done, which were not, and why."""
    undone = [k for k, reason in checker.undone.items() if reason == checker.wanting]
    if not undone:
        return "nothing wrong"
    done = levels_text(checker.done) + (" (format)" if set(checker.done) == {0} else "")
    return "%s: nothing wrong; %s %s not done: %s" % (
        done, levels_text(undone), "was" if len(undone) == 1 else "were", checker.wanting)


def plain(text):
    """Names in a message may hold what a terminal obeys: control characters are written out."""
    return "".join(json.dumps(c)[1:-1] if c < " " else "\\u%04x" % ord(c) if "\x7f" <= c <= "\x9f" else c for c in text)


def report(options, status, message, line, checker, remedy):
    done = checker.done if checker else {}
    undone = checker.undone if checker else {}
    if options.json:
        tree = {"log": options.log, "scene": options.scene, "status": status, "message": message, "line": line,
                "levels": [{"level": k, "what": LEVELS[k], "done": k in done,
                            "detail": done.get(k, undone.get(k))} for k in sorted(options.levels)],
                "not_followed": checker.missing if checker else [],
                "partly": checker.partly if checker else {}}
        print(json.dumps(tree, ensure_ascii=False))
        return
    if status != "fine":
        where = options.log + (":%d" % line if line else "")
        text = message if status == "bad input" else "%s: %s; %s" % (where, message, remedy)
        print("kinex-logcheck: %s" % plain(text), file=sys.stderr)
        return
    for k in sorted(options.levels):
        if k in done:
            print("level %d  done      %s: %s" % (k, LEVELS[k], done[k]))
        else:
            print("level %d  not done  %s" % (k, undone.get(k, "not asked for")))
    for label in checker.missing:
        print("structure %s has no replay: it was not followed" % plain(label))
    for label, what in checker.partly.items():
        print("structure %s was followed but for its %s" % (plain(label), what))
    print("%s: %s" % (options.log, verdict(checker)))


def check(options):
    checker, progress, remedy = None, Progress(options.verbose), None
    try:
        log = Log(options.log, read(options.log, LOG_REMEDY, binary=True))
        scene = Scene(options.scene, read(options.scene, SCENE_REMEDY)) if options.scene else None
        checker = Checker(log, scene, options.levels, progress)
        checker.run()
        status, message, line = "fine", None, None
    except Wrong as error:
        status, message, line, remedy = "wrong", str(error), error.line, error.remedy
    except BadInput as error:
        status, message, line = "bad input", str(error), None
    except (GaveUp, MemoryError, RecursionError) as error:
        status, message, line = "gave up", "%s" % (error or type(error).__name__), None
    progress.wipe()
    report(options, status, message, line, checker, remedy or REMEDIES.get(status))
    return {"fine": 0, "wrong": 1, "bad input": 2, "gave up": 3}[status]


def main():
    sys.set_int_max_str_digits(0)
    sys.setrecursionlimit(20000)
    return check(arguments())


if __name__ == "__main__":
    sys.exit(main())
