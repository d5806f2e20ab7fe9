#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
# SPDX-License-Identifier: Apache-2.0
"""Checks that the desktop app can translate what the engine says: each sentence of an error, a warning or a rejected
line has a pattern in ui/engine_patterns.cpp. Looks at ui and at those files of the engine that ui includes, directly
or not. Prints one line per finding; exit code 1 if any.

usage: check_sentences.py [ROOT]
"""

import itertools
import re
import sys
from pathlib import Path
from typing import Iterator, NamedTuple

import lint_main

PATTERNS = "ui/engine_patterns.cpp"

# Who takes a sentence, or a part of one: number of that argument, negative from the end.
TAKERS = {
    "fail": 1,  # cad2slam/core/result.h
    "Error": 1,
    "unexpected": 0,  # tl::unexpected, and io/projector_header.cpp
    "YamlRefusal": -1,
    "expectedHere": 0,
    "malformed": -1,
    "malformedNode": -1,
    "refuse": -1,
    "refused": -1,
    "report": -1,
    "unwritable": -1,
    "rejected.push_back": 1,
    "warnings.emplace_back": 0,
    "warnings.push_back": 0,
}
# Those put other words before it, or none.
CONTINUED = {"malformedNode", "refuse", "report"}

# Functions that return such texts.
ANSWERING = {"ahead", "rangeComplaint", "semanticsName"}

# What else gives a text: variables whose text is looked at where it is made, pieces of files, words of other libraries.
KNOWN = {"complaint", "complaint_", "error", "excerpt", "message", "reason", "systemReason", "what"}

# (file, literal) pairs without a pattern of their own, each with its reason.
WITHOUT = {
    # Stands where others have the path of a value: the patterns begin with %1, and these two words are one, too.
    ("engine/cad2slam/io/json_reader.h", "the document"),
}

# (file, function) pairs that have nothing to do with sentences.
OTHERS = {
    # Counts pixels.
    ("engine/cad2slam/io/pixel_states.cpp", "report"),
}

# Files of which nothing is shown.
SILENT = {
    "engine/cad2slam/solver/thin_plate_fit.cpp": "where it fails, the solver does without it",
}

Shape = tuple  # of literals (str) and inserted values (None)


class Sentence(NamedTuple):
    file: str
    line: int
    taker: str
    shape: Shape


# --- C++ ---------------------------------------------------------------------------------------------------------------

_TOKEN = re.compile(r'''//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'|\d[\w.']*|\w+|\s+|->|::|.''', re.S)
_OPEN, _CLOSE = {"(", "[", "{"}, {")", "]", "}"}


class Token(NamedTuple):
    text: str
    line: int


def tokens_of(code: str) -> list[Token]:
    """Without blanks, comments and preprocessor lines."""
    code = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda match: "\n" * match.group().count("\n"), code, flags=re.M)
    tokens, line = [], 1
    for match in _TOKEN.finditer(code):
        text = match.group()
        if not text.isspace() and not text.startswith(("//", "/*")):
            tokens.append(Token(text, line))
        line += text.count("\n")
    return tokens


def closing(tokens: list[Token], opening: int) -> int:
    """Where the bracket at `opening` closes."""
    depth = 0
    for at in range(opening, len(tokens)):
        depth += (tokens[at].text in _OPEN) - (tokens[at].text in _CLOSE)
        if depth == 0:
            return at
    return len(tokens) - 1


def split(tokens: list[Token], separator: str) -> list[list[Token]]:
    """At each separator outside of brackets."""
    parts, depth = [[]], 0
    for token in tokens:
        depth += (token.text in _OPEN) - (token.text in _CLOSE)
        if depth == 0 and token.text == separator:
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


def text_of(literal: str) -> str:
    return re.sub(r"\\(.)", r"\1", literal[1:-1])


def constants_of(tokens: list[Token]) -> dict[str, str]:
    """`constexpr char kName[] = "text";`"""
    constants = {}
    for at, token in enumerate(tokens):
        if [t.text for t in tokens[at + 1:at + 4]] == ["[", "]", "="] and token.text.startswith("k"):
            literals = list(itertools.takewhile(lambda t: t.text.startswith('"'), tokens[at + 4:]))
            if literals:
                constants[token.text] = "".join(text_of(t.text) for t in literals)
    return constants


def unwrapped(tokens: list[Token]) -> list[Token]:
    """Without brackets, std::string() and std::move() around the whole."""
    while True:
        texts = [t.text for t in tokens]
        opening = 3 if texts[:3] in (["std", "::", "string"], ["std", "::", "move"]) else 0
        if len(texts) < opening + 2 or texts[opening] not in "({" or closing(tokens, opening) != len(texts) - 1:
            return tokens
        tokens = tokens[opening + 1:-1]


def alternatives(tokens: list[Token]) -> list[list[Token]]:
    """What an expression may be, by its conditions."""
    tokens = unwrapped(tokens)
    condition = split(tokens, "?")[0]
    rest = tokens[len(condition) + 1:]
    depth, open_conditions = 0, 0
    for at, token in enumerate(rest):
        depth += (token.text in _OPEN) - (token.text in _CLOSE)
        open_conditions += depth == 0 and token.text == "?"
        if depth == 0 and token.text == ":":
            if open_conditions == 0:
                return alternatives(rest[:at]) + alternatives(rest[at + 1:])
            open_conditions -= 1
    return [tokens]


def shapes_of(tokens: list[Token], constants: dict[str, str]) -> list[Shape]:
    """The texts that an expression without conditions around it may give."""
    terms = split(tokens, "+")
    if len(terms) > 1:
        ways = [[shape for way in alternatives(term) for shape in shapes_of(way, constants)] for term in terms]
        return [tuple(itertools.chain(*way)) for way in itertools.product(*ways)]
    if tokens and all(t.text.startswith('"') for t in tokens):
        return [("".join(text_of(t.text) for t in tokens),)]
    if len(tokens) == 1 and tokens[0].text in constants:
        return [(constants[tokens[0].text],)]
    return [(None,)]


def last_name(tokens: list[Token]) -> str:
    """`b` of `a.b` and of `a->b(c)`."""
    texts = [t.text for t in tokens]
    while texts and texts[-1] in _CLOSE:
        depth = 0
        while texts:
            depth += (texts[-1] in _CLOSE) - (texts[-1] in _OPEN)
            texts.pop()
            if depth == 0:
                break
    return texts[-1] if texts else ""


# --- Sentences ---------------------------------------------------------------------------------------------------------

def expressions(tokens: list[Token]) -> Iterator[tuple[str, Token, list[Token]]]:
    """Where texts are made: who takes them, where, and the expression."""
    answering: list[tuple[int, str]] = []  # where a function ends that returns texts
    for at, token in enumerate(tokens):
        before = [t.text for t in tokens[max(0, at - 2):at]]
        after = [t.text for t in tokens[at + 1:at + 4]]
        while answering and at > answering[-1][0]:
            answering.pop()
        if token.text in ANSWERING and after[:1] == ["("]:
            body = closing(tokens, at + 1) + 1
            body += tokens[body].text == "const"
            if tokens[body].text == "{":
                answering.append((closing(tokens, body), token.text))
        if token.text == "return" and answering:
            yield answering[-1][1], token, split(tokens[at + 1:answering[-1][0]], ";")[0]
        if token.text in ("complaint", "complaint_") and after[:1] == ["="]:
            yield token.text, token, split(tokens[at + 2:], ";")[0]
        name = ".".join(([before[0]] if before[1:] == ["."] else []) + [token.text])
        opening = at + 1
        if after[:1] == ["<"] and token.text == "unexpected":
            opening = next(k for k in range(at, len(tokens)) if tokens[k].text == ">") + 1
        if token.text == "{" and after[:2] == ["ErrorCode", "::"] and before[-1:] != ["Error"]:
            name, opening = "Error", at
        name = name if name in TAKERS else token.text if token.text in TAKERS else name
        if name not in TAKERS or opening >= len(tokens) or tokens[opening].text not in "({":
            continue
        inside = tokens[opening + 1:closing(tokens, opening)]
        if inside and inside[0].text == "{" and closing(inside, 0) == len(inside) - 1:
            inside = inside[1:-1]
        arguments = split(inside, ",")
        number = TAKERS[name]
        if number < len(arguments) and not any(t.text == ";" for t in inside):
            yield name, token, arguments[number]


def sentences_of(name: str, code: str) -> Iterator[Sentence]:
    """Everything that one file has to say. A text of unknown origin is an empty shape."""
    tokens = tokens_of(code)
    constants = constants_of(tokens)
    for taker, token, expression in expressions(tokens):
        for way in alternatives(expression):
            for shape in shapes_of(way, constants):
                if any(re.search(r"[A-Za-z]", part or "") for part in shape):
                    yield Sentence(name, token.line, taker, shape)
                elif way and None in shape and last_name(way) not in KNOWN | ANSWERING | TAKERS.keys():
                    yield Sentence(name, token.line, taker, ())


def patterns_in(code: str) -> list[str]:
    found = re.findall(r'QT_TRANSLATE_NOOP\(\s*"Engine",\s*((?:"(?:\\.|[^"\\])*"\s*)+)\)', code)
    return ["".join(text_of(literal) for literal in re.findall(r'"(?:\\.|[^"\\])*"', pattern)) for pattern in found]


def has_pattern(sentence: Sentence, patterns: list[str]) -> bool:
    """Whether a pattern recognises the sentence, or holds its literals in their order."""
    spoken = "".join("\0" if part is None else part for part in sentence.shape)
    wanted = "".join(".+" if part is None else re.escape(part) for part in sentence.shape)
    if sentence.taker in CONTINUED:
        wanted = f"(?:.+ )?{wanted}"
    for pattern in patterns:
        heard = "(.+)".join(re.escape(literal) for literal in re.split(r"%\d", pattern))
        if re.fullmatch(heard, spoken) or re.fullmatch(wanted, pattern):
            return True
    return False


# --- Files -------------------------------------------------------------------------------------------------------------

def includes_of(path: Path) -> list[str]:
    return re.findall(r'^\s*#\s*include\s*"(cad2slam/[^"]+)"', path.read_text(encoding="utf-8"), re.M)


def engine_files(root: Path) -> list[Path]:
    """What ui uses of the engine. A source belongs to its header; one without to each header of its folder that it
    includes."""
    engine = root / "engine"
    sources: dict[Path, set[Path]] = {}
    for source in engine.rglob("*.cpp"):
        headers = [source.with_suffix(".h")]
        if not headers[0].exists():
            headers = [engine / name for name in includes_of(source) if (engine / name).parent == source.parent]
        for header in headers:
            sources.setdefault(header, set()).add(source)
    used: set[Path] = set()
    waiting = {engine / name for path in ui_files(root) for name in includes_of(path)}
    while waiting:
        path = waiting.pop()
        if path not in used and path.exists():
            used.add(path)
            waiting |= {engine / name for name in includes_of(path)} | sources.get(path, set())
    return sorted(used)


def ui_files(root: Path) -> list[Path]:
    return sorted(path for path in (root / "ui").rglob("*") if path.suffix in (".h", ".cpp"))


def findings(root: Path) -> list[str]:
    """One sentence per text without a pattern."""
    patterns = patterns_in((root / PATTERNS).read_text(encoding="utf-8"))
    found = []
    for path in engine_files(root) + ui_files(root):
        name = path.relative_to(root).as_posix()
        if name in SILENT:
            continue
        for sentence in sentences_of(name, path.read_text(encoding="utf-8")):
            place = f"{name}:{sentence.line}"
            if (name, sentence.taker) in OTHERS:
                continue
            if not sentence.shape:
                found.append(f"{place}: the text for {sentence.taker} comes from elsewhere: name its source in "
                             "check_sentences.py")
            elif (name, sentence.shape[0]) not in WITHOUT and not has_pattern(sentence, patterns):
                shown = "".join("..." if part is None else part for part in sentence.shape)
                found.append(f'{place}: no pattern in {PATTERNS} for "{shown}"')
    return found


if __name__ == "__main__":
    sys.exit(lint_main.run(findings, "sentences: the app can translate each of the engine"))
