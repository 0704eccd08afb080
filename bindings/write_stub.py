# SPDX-License-Identifier: BSD-3-Clause
"""Writes palpate/_sim.pyi and palpate/scenario.pyi from what the compiled module says of itself.

    python bindings/write_stub.py        after every change of the bindings

tests/bindings/test_stub.py fails where the stub is not what this would write.
"""

from __future__ import annotations

import enum
import inspect
import re
import subprocess
import textwrap
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

from palpate.system.isolated import build_command

STUB = Path(__file__).with_name("palpate") / "_sim.pyi"
SCENARIO_STUB = STUB.with_name("scenario.pyi")
HEADER = '''# SPDX-License-Identifier: BSD-3-Clause
"""Written by bindings/write_stub.py from what the compiled module says of itself."""

import enum
import os
from collections.abc import Sequence
from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import csc_matrix

__version__: str
'''
SCENARIO_HEADER = '''# SPDX-License-Identifier: BSD-3-Clause
"""Written by bindings/write_stub.py from what the compiled module says of itself."""

import os
from typing import Any

from numpy.typing import NDArray

from palpate._sim import Scene
'''
SIMPLER = (
    (r"palpate\._sim\.(?:_scenario\.)?", ""),
    (r"typing\.SupportsFloat \| typing\.SupportsIndex", "float"),
    (r"typing\.SupportsInt \| typing\.SupportsIndex", "int"),
    (r"typing\.Annotated\[numpy\.typing\.ArrayLike, [\w.]+(?:, \"[^\"]*\")?\]", "ArrayLike"),
    (r"typing\.Annotated\[(numpy\.typing\.NDArray\[[\w.]+\]), \"[^\"]*\"\]", r"\1"),
    (r"typing\.Annotated\[((?:list|collections\.abc\.Sequence)\[[\w.]+\]), \"[^\"]*\"\]", r"\1"),
    (r"numpy\.typing\.NDArray\[numpy\.", "NDArray[np."),
    (r"numpy\.ndarray", "NDArray[Any]"),
    (r"scipy\.sparse\.csc_matrix\[numpy\.float64\]", "csc_matrix"),
    (r"collections\.abc\.", ""),
    (r"\bdict\[str, object\]", "dict[str, Any]"),
    (r"\bdict\b(?!\[)", "dict[int, object]"),
    (r"os\.PathLike\b", "os.PathLike[str]"),
)  # fmt: skip
"""What pybind11 says, in the words a reader of the stub would use."""


def simplify(text: str) -> str:
    for pattern, replacement in SIMPLER:
        text = re.sub(pattern, replacement, text)
    return text


def split_parameters(text: str) -> Iterator[str]:
    """The parameters between the parentheses of a signature."""
    depth, quoted, start = 0, "", 0
    for at, letter in enumerate(text):
        if quoted:
            quoted = "" if letter == quoted else quoted
        elif letter in "\"'":
            quoted = letter
        elif letter in "([{<":
            depth += 1
        elif letter in ")]}>":
            depth -= 1
        elif letter == "," and depth == 0:
            yield text[start:at].strip()
            start = at + 1
    if text[start:].strip():
        yield text[start:].strip()


def describe_parameter(text: str) -> str:
    """`name: type` with `= ...` for a default: what it is stands in the documentation."""
    if text in ("*", "/", "*args"):
        return "*args: object" if text == "*args" else text
    name, _, rest = text.partition(": ")
    if name == "self":
        return name
    kind, equals, default = rest.partition(" = ")
    kind = simplify(kind)
    if default == "None" and not kind.endswith("None"):
        kind += " | None"
    return f"{name}: {kind}" + (" = ..." if equals else "")


def read_signatures(function: object) -> list[tuple[str, str]]:
    """Parameters and result of every overload, as written in the first lines of the docstring."""
    doc = function.__doc__ or ""
    lines = doc.splitlines()
    if "Overloaded function." in doc:
        lines = [line for line in lines if re.match(r"\d+\. \w+\(", line)]
    else:
        lines = lines[:1]
    found = []
    for line in lines:
        match = re.match(r"(?:\d+\. )?\w*\((?P<parameters>.*)\) -> (?P<result>.*)$", line)
        assert match, line
        parameters = ", ".join(map(describe_parameter, split_parameters(match["parameters"])))
        found.append((parameters, simplify(match["result"])))
    return found


def read_words(member: object) -> str:
    """What a docstring says beside its signatures."""
    lines = (getattr(member, "__doc__", None) or "").splitlines()
    signature = re.compile(r"(?:\d+\. )?\w*\(.*\) -> |Overloaded function\.$")
    return re.sub(
        r"\n{3,}", "\n\n", "\n".join(li for li in lines if not signature.match(li))
    ).strip()


def write_words(words: str, indent: str) -> Iterator[str]:
    """The words as a docstring, wrapped to the width of the stub."""
    if not words:
        return
    lines: list[str] = []
    for line in words.splitlines():
        deeper = " " * (len(line) - len(line.lstrip()))
        wrapper = textwrap.TextWrapper(
            width=93 - len(indent),
            subsequent_indent=2 * deeper,
            break_long_words=False,
            break_on_hyphens=False,
        )
        lines += wrapper.wrap(line) or [""]
    text = "\n".join(indent + line if line else "" for line in lines).strip()
    yield f'{indent}"""{text}' + ("\n" + indent + '"""' if "\n" in text else '"""')


def write_function(name: str, function: object, indent: str = "") -> Iterator[str]:
    signatures = read_signatures(function)
    for number, (parameters, result) in enumerate(signatures):
        if len(signatures) > 1:
            yield f"{indent}@overload"
        words = "" if number else read_words(function)
        yield f"{indent}def {name}({parameters}) -> {result}:" + ("" if words else " ...")
        yield from write_words(words, indent + "    ")


def write_property(name: str, member: property, indent: str) -> Iterator[str]:
    (_, kind), *_ = read_signatures(member.fget)
    taken = None
    if member.fset:
        (parameters, _), *_ = read_signatures(member.fset)
        taken = parameters.rpartition(": ")[2]
    words = read_words(member)
    if taken == kind:
        yield f"{indent}{name}: {kind}"
        yield from write_words(words, indent)
        return
    yield f"{indent}@property"
    yield f"{indent}def {name}(self) -> {kind}:" + ("" if words else " ...")
    yield from write_words(words, indent + "    ")
    if taken:
        yield f"{indent}@{name}.setter"
        yield f"{indent}def {name}(self, value: {taken}) -> None: ..."


def write_class(name: str, kind: type, indent: str = "") -> Iterator[str]:
    inner = indent + "    "
    if issubclass(kind, enum.Enum):
        yield f"{indent}class {name}(enum.{kind.__base__.__name__}):"
        yield from write_words(read_words(kind), inner)
        for member in kind:
            yield f"{inner}{member.name} = {member.value!r}"
        return
    bases = [b.__name__ for b in kind.__bases__ if b.__module__ == kind.__module__]
    yield f"{indent}class {name}{'(' + ', '.join(bases) + ')' if bases else ''}:"
    yield from write_words(read_words(kind), inner)
    for key, member in vars(kind).items():
        if key in ("__doc__", "__module__", "_pybind11_conduit_v1_", "__init_subclass__"):
            continue
        if key == "__init__" and not (member.__doc__ or "").startswith("__init__("):
            continue  # only made by the library
        if isinstance(member, type):
            yield from write_class(key, member, inner)
        elif isinstance(member, property):
            yield from write_property(key, member, inner)
        elif inspect.isroutine(member):
            yield from write_function(key, member, inner)
        else:
            yield f"{inner}{key}: {name_type(member)}"


def name_type(value: object) -> str:
    """Of a constant: a number, or the dtype of the rows of a table."""
    return type(value).__name__ if isinstance(value, int | float) else "np.dtype[np.void]"


def render_stub(module: ModuleType, header: str = HEADER) -> str:
    """The whole stub, in the order in which the module defines its names."""
    lines = [header]
    for name, member in vars(module).items():
        if name.startswith("_"):
            continue
        if isinstance(member, type):
            lines += ["", *write_class(name, member)]
        elif inspect.isroutine(member):
            lines += write_function(name, member)
        else:
            lines.append(f"{name}: {name_type(member)}")
    text = "\n".join(lines) + "\n"
    # an empty class needs a body
    text = re.sub(r"^( *)(class .*:)\n(?!\1 )", r"\1\2 ...\n", text, flags=re.MULTILINE)
    formatter = build_command("-m", "ruff", "format", "--line-length", "100")
    return subprocess.run(
        [*formatter, "--stdin-filename", "_sim.pyi", "-"],
        input=text,
        capture_output=True,
        encoding="utf-8",
        check=True,
    ).stdout


if __name__ == "__main__":
    import palpate._sim

    STUB.write_text(render_stub(palpate._sim), encoding="utf-8")
    SCENARIO_STUB.write_text(render_stub(palpate._sim._scenario, SCENARIO_HEADER), encoding="utf-8")
