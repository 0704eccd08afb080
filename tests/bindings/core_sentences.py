# SPDX-License-Identifier: BSD-3-Clause
"""Sentences that the C++ core refuses with, found in its sources as templates with %1 to %9."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

CORE = Path(__file__).resolve().parents[2] / "core"
FILES = (
    *("authoring/*.cpp", "authoring/cgal/*.cpp", "authoring/read_mesh_child/*.cpp"),
    "authoring/read_mesh_child/mean_colour.h",
    "authoring/cgal/private/*.h",
    *("sim/base/private/whole_file.cpp", "sim/arm/serial_transport.cpp"),
    *("sim/arm/serial_device.cpp", "sim/arm/private/serial_link_status.cpp"),
    *("sim/arm/pty_device.cpp", "sim/arm/calibration.cpp", "sim/tick/scene.cpp"),
    *(
        "sim/tick/world.cpp",
        "sim/tick/private/touch_bodies.cpp",
        "sim/tick/private/check_scenery.cpp",
        "sim/tick/private/build_rigid.cpp",
        "sim/collision/choose_barrier.cpp",
        "sim/packed/private/active_rule.cpp",
        "sim/implicit/implicit_stepper.cpp",
        "sim/response/build_response.cpp",
        "sim/contact/near_field.cpp",
    ),
    *(
        "sim/session/record.cpp",
        "sim/session/count_ticks.cpp",
        "sim/session/private/record_file.cpp",
        "sim/session/private/record_writer.cpp",
    ),
    *("scenario/*.cpp", "sim/mesh/*.cpp", "sim/model/*.cpp"),
    *("sim/model/private/*.cpp", "sim/model/private/*.h"),
)
"""Where what a window opens is read and built: meshes, organs, published files, devices."""
CALL = re.compile(
    r"\b(?:throw FileError|throw NotDurable|throw DeviceError|throw std::invalid_argument"
    r"|(?<!void )(?:refuse|refuse_beside|require))\("
)
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')
TOLD = re.compile(
    r"(?:std::string|std::optional<std::string>) (?:SerialLink::explain_silence\(\) const"
    r"|name_end\(int status\)|find_\w+_problem\([^)]*\)|describe\([^)]*\)) \{(.*?)\n\}",
    re.DOTALL,
)
"""Functions that give what was found, or what is wrong with it."""
LIMITS = re.compile(r"const char\* describe\(Limit limit\) noexcept \{(.*?)\n\}", re.DOTALL)
"""What a number of a law may be."""
COUNTS = re.compile(r"std::array kExpected = \{(.*?)\};", re.DOTALL)
"""What a row of a law joins, before a number."""
WHOLE_TISSUE = re.compile(r'\{("a [^"]*"),\s*((?:"[^"]*"\s*)+)\},')
"""Why no part of a tissue with a law may sleep."""
LAW = re.compile(r'make_(?:table|links|hyperelastic)\(\s*(?://[^\n]*\s*)?\{"(\w+)"')
"""A law that a linear solid refuses beside it."""
CHOSEN = re.compile(r"return \{[^{};]*, (?:true|false), (.*?)\};")
"""A unit or an axis, whether it is guessed, and why."""
PRINTED = re.compile(r'snprintf\(\w+, sizeof \w+, ("[^"]*")')
NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
RANGE = re.compile(
    rf"{NUMBER} (?:to|or) {NUMBER}|{NUMBER} or more|(?:at most|at least|less than) {NUMBER}"
    rf"|between {NUMBER} and {NUMBER}|a size of {NUMBER} to {NUMBER}"
)
"""What is said of many fields, each with numbers of its own."""
WHOLE = re.compile(r"(?:^|.*?[: ])got (.*), expected (.*)", re.DOTALL)
"""A sentence that says both."""
NOTED = re.compile(r"std::string ask_for_low_latency\([^)]*\) \{(.*?)\n\}", re.DOTALL)
"""What came of a wish that may fail."""
NOTE = re.compile(r"\bnotes\.(?:push_back|emplace_back)\(")
COUNTED = re.compile(r'\bnote\(\w[^,"]*, ("[^"]*")\)')
"""A number before words."""
CONSTANT = re.compile(r'constexpr const char\* k\w+ =\s*((?:"[^"]*"\s*)+);')
ADVICE = re.compile(r'\? "(; [^"]*)"')


def find_sentences() -> set[str]:
    """Of all FILES, where they have words of their own."""
    found = {text for name in FILES for file in CORE.glob(name) for text in read_file(file)}
    return {text for text in found if has_words(text)}


def has_words(template: str) -> bool:
    """Whether there is anything to translate: units and names of fields are not."""
    bare = re.sub(r"%\d|\[[^]]*\]|\bkg\b|\bPa\b|\bmm\b|\bSHA\b|\w+[_.]\w+", "", template)
    return re.search(r"[a-z]{2}", bare) is not None


def read_file(path: Path) -> Iterator[str]:
    source = re.sub(r"//[^\n]*", "", path.read_text(encoding="utf-8"))
    for call in CALL.finditer(source):
        arguments = split(close(source[call.end() :]), ",")
        # of (file, where, found, expected) and (where, found, expected) the last two are words
        for argument in arguments[-2:] if len(arguments) > 1 else arguments:
            for template in build_templates(argument):
                yield from divide(template)
    for body in TOLD.findall(source):
        for told in re.findall(r"return (.*?);", body, re.DOTALL):
            yield from build_templates(told)
    for body in NOTED.findall(source):
        for told in re.findall(r"(?:note \+?=|return) (.*?);\n", body, re.DOTALL):
            yield from build_templates(told)
    for body in LIMITS.findall(source):
        yield from (count_places(told) for told in LITERAL.findall(body))
    for body in COUNTS.findall(source):
        yield from (f"{told}%1" for told in LITERAL.findall(body) if told)
    yield from (law for law in LAW.findall(source) if law not in ("elastic", "skin"))
    for reason in WHOLE_TISSUE.findall(source):
        yield from ("".join(LITERAL.findall(part)) for part in reason)
    yield from ADVICE.findall(source)
    if "authoring" in path.parts:
        for call in NOTE.finditer(source):
            yield from build_templates(close(source[call.end() :]))
        yield from (f"%1{LITERAL.findall(text)[0]}" for text in COUNTED.findall(source))
        yield from ("".join(LITERAL.findall(text)) for text in CONSTANT.findall(source))
    if path.stem == "units":
        told = [*CHOSEN.findall(source), *PRINTED.findall(re.sub(r"%[.\d]*[a-z]", "%1", source))]
        yield from (text for reason in told for text in build_templates(reason))


def divide(template: str) -> Iterator[str]:
    """A sentence that says what was found and what was expected is known by these two."""
    whole = WHOLE.fullmatch(template)
    yield from map(count_places, whole.groups() if whole else [template])


def count_places(template: str) -> str:
    """The places numbered from 1; a range that stands in the source is one of two places."""
    places = iter(range(1, 10))
    bare = template if not RANGE.fullmatch(template) else re.sub(NUMBER, "%1", template)
    return re.sub(r"%\d", lambda _: f"%{next(places)}", bare)


def close(text: str) -> str:
    """Up to the bracket that closes what is open."""
    depth = 1
    for place, _ in outside_literals(text):
        depth += {"(": 1, "{": 1, ")": -1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return text[:place]
    raise AssertionError(f"no end of {text[:60]!r}")


def split(text: str, mark: str) -> list[str]:
    """At the marks that stand in no bracket."""
    parts, start, depth = [], 0, 0
    for place, letter in outside_literals(text):
        depth += {"(": 1, "{": 1, "[": 1, ")": -1, "}": -1, "]": -1}.get(letter, 0)
        if letter == mark and depth == 0:
            parts.append(text[start:place])
            start = place + 1
    return [*parts, text[start:]]


def outside_literals(text: str) -> Iterator[tuple[int, str]]:
    inside = [False] * len(text)
    for literal in re.finditer(r"\"(?:[^\"\\]|\\.)*\"|'(?:[^'\\]|\\.)+'", text):
        inside[literal.start() : literal.end()] = [True] * len(literal.group())
    return ((k, letter) for k, letter in enumerate(text) if not inside[k])


def build_templates(expression: str) -> Iterator[str]:
    """What an expression may say: "5 bytes" comes of `std::to_string(n) + " bytes"` as %1 bytes."""
    for branch in split_branches(expression):
        text, place = "", 0
        for part in list_parts(branch):
            bare = re.sub(r"^std::string\((.*)\)$", r"\1", part.strip(), flags=re.DOTALL)
            said = "".join(LITERAL.findall(bare))
            if re.sub(LITERAL, "", bare).strip() == "":
                text += said.replace('\\"', '"')
            else:
                place += 1
                text += f"%{place}"
        yield text


def list_parts(expression: str) -> list[str]:
    """What is written one after the other: a + b, or write_text(a, b)."""
    parts = []
    for part in split(expression, "+"):
        written = re.fullmatch(r"\s*write_text\((.*)\)\s*", part, re.DOTALL)
        parts += split(written.group(1), ",") if written else [part]
    return parts


def split_branches(expression: str) -> list[str]:
    """Both answers of a question."""
    asked = split(expression, "?")
    if len(asked) == 1:
        return [expression]
    answers = "?".join(asked[1:])
    # the mark of a scope is no colon of a question
    parts = split(answers.replace("::", "\0\0"), ":")
    return [part.replace("\0\0", "::") for part in parts]
