# SPDX-License-Identifier: GPL-3.0-or-later
"""Structures are combinatorics: they ask the kernel, and see no numbers.

usage: pure_structures.py SOURCE_FOLDER

No file in structures/ reaches through the kernel to an arithmetic, a queue or a motion, and none names a number or
a time. Exempt are
- audits (_audit), which compute from positions;
- of whole numbers, bounds (_bounds) and functions that return a bound: of a name as below, or of BoundChecks;
- the words of a file in MAY_NAME: the parameters of a request are rational, and the plan, which is no structure,
  makes the arithmetic for what the structures declare. An exemption that no longer serves is a fault.
The geometry of bodies and grids is below the structures, in predicates/. The kernel itself returns no number.

No file outside parts/ creates, replaces or retracts a certificate but through parts/slots.h, which counts it in the
ledger line of its part.
"""
import pathlib
import re
import sys

REACHING = re.compile(r"\b(Arithmetic|EventQueue|Scheduler|SignNow|arithmetic\(\)|queue\(\))")
# What leads from a kernel to numbers; an audit looks at motions.
MOTIONS = re.compile(r"\b(Trajectory\b|MotionPiece\b|CoarseTime\b|coarse_now\b|derived\(\)|trajectory\()")
NUMBERS = re.compile(r"\b(Polynomial|RationalPolynomial|Rational|RealRoot|Ball|MpFloat|double|float"
                     r"|InstantName|Dyadic\w*|ShortRational"
                     r"|FramePoint|FrameLine|Vertex2|RoughPose|RoughPolygon)\b")
WHOLE = re.compile(r"\b(Integer|Int128)\b")
# Kernel::create and retract have no namesakes in structures/; Kernel::replace has.
CERTIFYING = re.compile(r"(?:\.|->)\s*(create|retract)\s*\(|kernel_?(?:\(\))?\s*(?:\.|->)\s*(replace)\s*\(")
AUDIT = re.compile(r"_audit$")
BOUNDS = re.compile(r"_bounds$")
# File, without its ending: the words that it may name.
MAY_NAME = {
    "parts/descriptor": {"Rational"},  # parameters of a request
    "registry": {"Rational"},
    "range/family": {"Rational"},
    "arrangement/family": {"Integer"},
    "plan": {"Rational", "Arithmetic"},
    "parts/key_value": {"Rational"},  # exact values of keys, for audits
    "collision/hierarchy_bounds": {"Rational", "FramePoint", "double"},  # the shapes of the polygons
}
# The head of a function that returns a bound, or adds bounds to a list.
BOUND = re.compile(r"(?:\bBoundCheck>?\s+[\w:]+|\bInteger\s+(?:\w+::)*(?:most_\w+|binomial)"
                   r"|\bvoid\s+(?:\w+::)*add_bounds)\(")
NOISE = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*')
# A function of the kernel that returns a number, or a type that cannot be seen from here (auto).
RETURNS = re.compile(r"^  (?:(?:static|virtual|constexpr|const|inline)\s+)*(?:std::optional<)?"
                     r"(auto|double|float|Rational|Integer|Polynomial|Trajectory|Ball)\b[\w<>&*:, ]*\(", re.M)


def end_of_function(text, at):
    """The place after the body, or the semicolon, of the function whose parameters begin at text[at]."""
    depth = 0
    for i in range(at, len(text)):
        if text[i] in "({":
            depth += 1
        elif text[i] in ")}":
            depth -= 1
            if depth == 0 and text[i] == "}":
                return i + 1
        elif text[i] == ";" and depth == 0:
            return i + 1
    return len(text)


def without_bounds(text):
    """The same lines without the functions that return bounds."""
    kept, at = [], 0
    for head in BOUND.finditer(text):
        if head.start() < at:
            continue
        end = end_of_function(text, head.end() - 1)
        kept += [text[at:head.start()], "\n" * text.count("\n", head.start(), end)]
        at = end
    return "".join(kept + [text[at:]])


def named_in(name, text):
    """The number of the line and the word, of all that structures do not name; `name` is the file's in structures/,
    without its ending."""
    text = NOISE.sub(lambda m: '""' if m[0][0] == '"' else "", text)
    words = [(REACHING, text)]
    if not AUDIT.search(name):
        words += [(MOTIONS, text), (NUMBERS, text)]
        if not BOUNDS.search(name):
            words.append((WHOLE, without_bounds(text)))
    for pattern, lines in words:
        for number, line in enumerate(lines.split("\n"), 1):
            for word in pattern.findall(line):
                yield number, word


def faults_in(name, text):
    return [(number, word) for number, word in named_in(name, text) if word not in MAY_NAME.get(name, ())]


def returned_numbers(kernel):
    """The types of numbers that public functions of the kernel return."""
    public = kernel[kernel.index(" public:"):kernel.index(" protected:")]
    return RETURNS.findall(NOISE.sub("", public))


def check_this():
    assert list(faults_in("list", "int a;\nkernel_->queue().top();")) == [(2, "queue()")]
    assert list(faults_in("list", 'x(); // a double\ndouble y = 1;')) == [(2, "double")]
    assert list(faults_in("list", "auto t = kernel_.coarse_now();")) == [(1, "coarse_now")]
    assert list(faults_in("list", "Integer f() { return 1; }")) == [(1, "Integer")]
    bounds = "std::vector<BoundCheck> A::bounds() const {\n  if (x) { Integer n; }\n}\n"
    assert not list(faults_in("list", bounds + "Integer most_certificates(const Integer& n) const;"))
    assert list(faults_in("list", bounds + "Integer n;")) == [(4, "Integer")]
    assert not list(faults_in("list_audit", "Rational x;"))
    assert list(faults_in("list_audit", "arithmetic();")) == [(1, "arithmetic()")]
    assert not list(faults_in("list_bounds", "Integer n;"))
    assert list(faults_in("list_bounds", "double x;")) == [(1, "double")]
    assert list(faults_in("list", "DyadicPolynomial p;\nInstantName i;\nShortRational r;\nDyadic d;")) == [
        (1, "DyadicPolynomial"), (2, "InstantName"), (3, "ShortRational"), (4, "Dyadic")]
    assert list(faults_in("registry", "Rational x;\ndouble y;")) == [(2, "double")]
    assert list(faults_in("range/registry", "Rational x;")) == [(1, "Rational")]
    assert returned_numbers(" public:\n  int f();\n  auto g() { }\n  const double& h() const;\n"
                            "  void set(Rational x);\n protected:\n  double k();\n") == ["auto", "double"]


def certifying_in(text):
    """The calls of the kernel that make or withdraw certificates, whatever the line breaks."""
    text = NOISE.sub(lambda m: '""' if m[0][0] == '"' else "", text)
    for call in CERTIFYING.finditer(text):
        yield text.count("\n", 0, call.start()) + 1, call[1] or call[2]


def main():
    check_this()
    assert list(certifying_in("int a;\nslot =\n    kernel_\n->create(id, q, 0);")) == [(4, "create")]
    assert list(certifying_in("slots.kernel().replace(c, q, 0);")) == [(1, "replace")]
    assert not list(certifying_in("slots_.set(c, q, 0); store_.replace(a, b); // kernel_->retract(c)"))
    source = pathlib.Path(sys.argv[1])
    root = source / "structures"
    files = [f for f in sorted(root.rglob("*")) if f.suffix in (".h", ".cpp")]
    if len(files) < 50:
        sys.exit(f"only {len(files)} files in {root}: the check does not see the sources")
    names = {file: file.relative_to(root).with_suffix("").as_posix() for file in files}
    faults = [f"{file}:{number}: {word}" for file in files
              for number, word in faults_in(names[file], file.read_text())]
    needed = {(names[file], word) for file in files for _, word in named_in(names[file], file.read_text())}
    for name, word in sorted((name, word) for name, words in MAY_NAME.items() for word in words):
        if (name, word) not in needed:
            faults.append(f"structures/{name} may name {word}, and does not: take it from MAY_NAME")
    faults += [f"core/engine/kernel.h: a function returns {word}"
               for word in returned_numbers((source / "core/engine/kernel.h").read_text())]
    if faults:
        sys.exit("\n".join(faults) + "\nremedy: ask the kernel, or put it into a predicate")
    calls = [(file.relative_to(root).parts[0], f"{file}:{number}: {word}") for file in files
             for number, word in certifying_in(file.read_text())]
    by_hand = [where for family, where in calls if family != "parts"]
    if by_hand:
        sys.exit("\n".join(by_hand) + "\nremedy: keep the certificate in a slot: structures/parts/slots.h")
    if not calls:
        sys.exit("structures/parts/ makes no certificate: the check does not see the calls")
    print(f"{len(files)} files of structures, no arithmetic, no queue, no number, no certificate but in a slot")


main()
