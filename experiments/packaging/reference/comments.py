#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Doxygen's input filter: the comments of a header as the house writes them, `//`, become documentation.

usage: comments.py HEADER      (the filtered header on standard output, line by line what it was)

- The head of a file documents the file, and the class that it begins with ("Kernel: ..").
- A comment directly above a declaration documents it. A comment behind it (`// ..` after two spaces, with
  the lines below in the same column) does, too.
- A comment above a blank line, a heading (`// ---- .. ----`) and comments in bodies of functions document
  nothing.
- Text is text: a `<` or a `#` is no markup. Lines set in by two and more spaces are shown as they are.
"""
import re
import sys

ENTITIES = {"<": "&lt;", ">": "&gt;", "&": "&amp;"}
CODE = re.compile(r"`([^`]+)`")
SCOPE = re.compile(r"^\s*(?:template\s*<.*>\s*)?(?:inline\s+)?(namespace|class|struct|union|enum)\b(?!.*\()")
LITERALS = re.compile(r'"(?:\\.|[^"\\])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\])*\'')


def escaped(text):
    return re.sub(r"[\\@#%$]", lambda match: "\\" + match.group(),
                  re.sub(r"[<>&]", lambda match: ENTITIES[match.group()], text))


def words(text):
    return CODE.sub(r"<code>\1</code>", escaped(text.strip()))


def set_in(text):
    return text.startswith("   ")


def as_documentation(lines, indent=""):
    """Lines of text as Doxygen's comment, one line for each."""
    shown, listed = [set_in(text) for text in lines], False
    # A blank line between two lines that are set in belongs to the drawing.
    for i, text in enumerate(lines):
        if not text.strip() and i > 0 and shown[i - 1]:
            below = next((j for j in range(i, len(lines)) if lines[j].strip()), None)
            shown[i] = below is not None and shown[below]
    # A list that is set in is a list.
    for i, text in enumerate(lines):
        if shown[i] and (text.lstrip().startswith("- ") or (i > 0 and listed)):
            shown[i], listed = False, True
        else:
            listed = False
    out = []
    for i, text in enumerate(lines):
        if not shown[i] and set_in(text):
            out.append(f"{indent}///{escaped(text.rstrip())}")
            continue
        body = escaped(text) if shown[i] else words(text)
        if shown[i] and (i == 0 or not shown[i - 1]):
            body = "<pre>" + body
        if shown[i] and (i + 1 == len(lines) or not shown[i + 1]):
            body += "</pre>"
        out.append(f"{indent}/// {body}".rstrip())
    return out


class Scopes:
    """Whether a line stands among declarations, or in the body of a function or an initializer."""

    def __init__(self):
        self.stack = []
        self.statement = ""

    def among_declarations(self):
        return all(self.stack)

    def at_namespace(self):
        return all(kind == "namespace" for kind in self.stack)

    def read(self, line):
        code = re.sub(r"//.*", "", LITERALS.sub('""', line))
        if code.lstrip().startswith("#"):
            return
        for character in code:
            if character == "{":
                opened = SCOPE.match(self.statement)
                self.stack.append(opened.group(1) if opened else None)
                self.statement = ""
            elif character == "}":
                if self.stack:
                    self.stack.pop()
                self.statement = ""
            elif character == ";":
                self.statement = ""
            elif character == ":" and re.fullmatch(r"\s*(public|protected|private)\s*", self.statement):
                self.statement = ""
            else:
                self.statement += character
        self.statement += " "


def comment_text(line):
    """The text of a line that is a comment and nothing else, else None; what is behind `//`."""
    match = re.match(r"\s*//(?!/)(.*)$", line)
    return match.group(1) if match else None


def heading(text):
    return re.match(r"\s*----", text) is not None


def head_of(lines):
    """The lines of the head: [begin, end), behind the licence."""
    begin = 1 if lines and "SPDX" in lines[0] else 0
    end = begin
    while end < len(lines) and comment_text(lines[end]) is not None:
        end += 1
    return begin, end


def trailing(line):
    """(code, column, text) of a comment behind a declaration, else None."""
    blind = LITERALS.sub(lambda match: "x" * len(match.group()), line)
    at = blind.find("//")
    if at <= 0 or not line[:at].strip() or line.lstrip().startswith("#"):
        return None
    code = line[:at].rstrip()
    if re.search(r"[^\s{]\s*\{$", code) or re.match(r"\s*template\s*<.*>$", code):
        return code, None, line[at + 2:]
    if not re.search(r"[;,}]$|^[\sA-Za-z0-9_=]+$", code) or re.match(r"\s*}[;,]?$", code):
        return None
    return code, at, line[at + 2:]


def filtered(lines):
    out = list(lines)
    begin, end = head_of(lines)
    head = [comment_text(line) for line in lines[begin:end]]
    named = re.match(r"\s*([A-Z]\w+)(?: \([^)]*\))?: ", head[0]) if head else None
    named = named and named.group(1)
    if head:
        out[:end] = ["/// @file"] * begin + as_documentation(head)
    scopes = Scopes()
    shared = own = None  # the comment of a group of declarations without blank lines between them
    i = end
    while i < len(lines):
        line = lines[i]
        if not scopes.among_declarations():
            scopes.read(line)
            i += 1
            continue
        if not line.strip():
            shared = None
        if comment_text(line) is not None:
            j = i
            while j < len(lines) and comment_text(lines[j]) is not None:
                j += 1
            begin = i
            for k in range(i, j):
                if heading(comment_text(lines[k])):
                    begin = k + 1
            following = lines[j].strip() if j < len(lines) else ""
            if begin < j and following and not following.startswith(("}", "#", "public:", "private:", "protected:")):
                indent = re.match(r"\s*", line).group()
                texts = [comment_text(x) for x in lines[begin:j]]
                out[begin:j] = as_documentation(texts, indent)
                shared = None if any(map(set_in, texts)) else " ".join(map(words, texts))
                own = j
            i = j
            continue
        if re.match(r"\s*(extern template|using\b.*\brequires\b)", line):
            # Of no use to a reader, and beyond what Doxygen reads.
            if re.match(r"template\b", lines[i - 1]):
                out[i - 1] = ""
            depth = len(scopes.stack)
            ended = False
            while not ended:
                out[i] = ""
                scopes.read(lines[i])
                ended = lines[i].rstrip().endswith(";") and len(scopes.stack) == depth
                i += 1
            continue
        behind = trailing(line)
        if behind is not None and not scopes.statement.strip().startswith("enum"):
            code, column, text = behind
            if column is None:  # of something that goes on below
                out[i] = f"/** {words(text)} */ {code}" if not scopes.statement.strip() else code
                named = None if named_here(named, code) else named
                scopes.read(line)
                i += 1
                continue
            if re.match(r"\s*enum\b", code) and not scopes.statement.strip():
                out[i] = f"/** {words(text)} */ {code}"
                scopes.read(line)
                i += 1
                continue
            j = i + 1
            texts = [text]
            while j < len(lines) and lines[j].find("//") == column and not lines[j][:column].strip():
                texts.append(lines[j][column + 2:])
                j += 1
            out[i] = f"{code}  ///< {words(texts[0])}"
            for k in range(1, len(texts)):
                out[i + k] = " " * column + f"///< {words(texts[k])}"
            scopes.read(line)
            i = j
            continue
        if (shared and i != own and line.strip() and scopes.at_namespace() and not scopes.statement.strip()
                and not re.match(r"[}#]|namespace\b|static_assert", line)):
            out[i] = f"/** {shared} */ {line}"
        # The class that the head speaks of, which has no comment of its own.
        template = re.match(r"\s*template\s*<.*>\s*$", line) and i + 1 < len(lines)
        if named_here(named, lines[i + 1] if template else line) and not scopes.statement.strip():
            if not re.match(r"\s*///", out[i - 1]):
                out[i] = f"/** {words(first_sentence(head))} See the head of the file. */ {line}"
            named = None
        scopes.read(line)
        i += 1
    return out


def named_here(name, line):
    return name is not None and re.match(rf"\s*(class|struct)\s+{name}\b[^;]*$", line) is not None


def first_sentence(head):
    text = []
    for line in head:
        if not line.strip() or set_in(line):
            break
        text.append(line.strip())
    joined = " ".join(text).partition(": ")[2]
    sentence = re.match(r".*?[.:](?=\s|$)", joined + " ")
    said = (sentence.group() if sentence else joined).rstrip(":. ")
    return said[:1].upper() + said[1:] + "."


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        lines = file.read().split("\n")
    sys.stdout.write("\n".join(filtered(lines)))


if __name__ == "__main__":
    main()
