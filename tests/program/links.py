# SPDX-License-Identifier: GPL-3.0-or-later
"""Every relative link in the documents leads to a file that exists, and to a heading that it has; every
page of the guide can be reached from README.md; README.md is short.

usage: links.py SOURCE_FOLDER
"""
import pathlib
import re
import subprocess
import sys
import urllib.parse

README_LINES = 130
GUIDE = "experiments/guide"
FEWEST = 100  # links


def pages_of(source):
    listed = subprocess.run(["git", "-C", source, "ls-files", "-z", "--cached", "--others",
                             "--exclude-standard", "*.md"], stdout=subprocess.PIPE, check=False)
    if listed.returncode == 0:
        names = filter(None, listed.stdout.decode().split("\0"))
        return sorted(source / name for name in names if (source / name).is_file())
    return sorted(path for path in source.rglob("*.md") if not path.parts[len(source.parts)].startswith("build"))


def prose_of(text):
    """Without fenced blocks and code, in which brackets are no links."""
    text = re.sub(r"(?ms)^```.*?^```\s*?$", "", text)
    return re.sub(r"`[^`\n]*`", "`code`", text)


def anchors_of(text):
    """The names of the headings, as they are made by the hosts of repositories."""
    anchors, seen = set(), {}
    text = re.sub(r"(?ms)^```.*?^```\s*?$", "", text)
    for heading in re.findall(r"(?m)^#{1,6} +(.*?) *#*$", text):
        heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        name = re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")
        count = seen.get(name, 0)
        seen[name] = count + 1
        anchors.add(name if count == 0 else f"{name}-{count}")
    anchors.update(re.findall(r'<a (?:id|name)="([^"]+)"', text))
    return anchors


def links_of(text):
    prose = prose_of(text)
    yield from re.findall(r"\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)", prose)
    yield from re.findall(r"(?m)^\[[^\]]+\]:\s+(\S+)", prose)
    yield from re.findall(r'<(?:img|a)\b[^>]*\b(?:src|href)="([^"]+)"', prose)


def problem_of(page, link, source):
    if re.match(r"[a-z][a-z0-9+.-]*:", link):
        return None
    path, _, anchor = link.partition("#")
    target = page if not path else (page.parent / urllib.parse.unquote(path))
    if path.startswith("/"):
        return "an absolute path"
    if not target.exists():
        return "no such file"
    if source.resolve() not in [target.resolve(), *target.resolve().parents]:
        return "leaves the repository"
    if anchor and target.suffix == ".md" and anchor not in anchors_of(target.read_text()):
        return f"{target.name} has no heading {anchor!r}"
    return None


def main():
    source = pathlib.Path(sys.argv[1]).resolve()
    wrong, count, leads = [], 0, {}
    pages = pages_of(source)
    for page in pages:
        leads[page] = set()
        for link in links_of(page.read_text()):
            count += 1
            problem = problem_of(page, link, source)
            if problem:
                wrong.append(f"{page.relative_to(source)}: {link}: {problem}")
            elif not re.match(r"[a-z][a-z0-9+.-]*:", link) and link.partition("#")[0]:
                leads[page].add((page.parent / urllib.parse.unquote(link.partition("#")[0])).resolve())
    reached, todo = set(), [source / "README.md"]
    while todo:
        page = todo.pop()
        if page not in reached:
            reached.add(page)
            todo += [target for target in leads.get(page, ()) if target.suffix == ".md"]
    for page in pages:
        if source / GUIDE in page.parents and page not in reached:
            wrong.append(f"{page.relative_to(source)}: no link leads here from README.md")
    lines = (source / "README.md").read_text().count("\n")
    if lines > README_LINES:
        wrong.append(f"README.md has {lines} lines: {README_LINES} at most; the guide has room")
    if count < FEWEST:
        wrong.append(f"only {count} links were found")
    print("\n".join(wrong) or f"{count} links of {len(pages)} pages lead somewhere")
    return 1 if wrong else 0


sys.exit(main())
