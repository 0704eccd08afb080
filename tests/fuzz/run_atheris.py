# SPDX-License-Identifier: BSD-3-Clause
"""Fuzzes a reader that is written in Python: Atheris, which is libFuzzer over Python's branches.

    run_atheris.py organ|scene_file|script [LIBFUZZER OPTIONS] FOUND CORPUS ...

Started by ./run fuzz in the environment of tests/fuzz/requirements.txt.
"""

from __future__ import annotations

import json
import random
import sys
from pathlib import Path
from typing import Any

import atheris

CHECKOUT = Path(__file__).resolve().parents[2]
READERS = {"organ": "fuzz_organ", "scene_file": "fuzz_json", "script": "fuzz_json"}
OURS = ["palpate", "palpate_editor"]


ODD = [
    None,
    True,
    False,
    0,
    -1,
    2**31,
    2**63,
    10**400,
    0.5,
    -0.0,
    1e-320,
    1e308,
    float("nan"),
    "",
    "\0",
    "x" * 300,
]
ODD += [[], {}, [[]], [0.0] * 3, ["a", "a"], {"": {}}, "\ud800", "dala\u011f\u0131"]


def list_places(value: Any) -> list[tuple[Any, Any]]:
    """Every place in a JSON value, as what holds it and its key or number there."""
    keys = value if isinstance(value, dict) else range(len(value)) if type(value) is list else ()
    places = [(value, key) for key in keys]
    return places + [place for key in keys for place in list_places(value[key])]


def change_json(text: bytes, seed: int) -> bytes | None:
    """The text with one value in it changed, left out, or under another name; none if not JSON."""
    choose = random.Random(seed)
    try:
        value = [json.loads(text)]
        places = list_places(value)
        holder, key = choose.choice(places)
        other, there = choose.choice(places)
        kind = choose.randrange(6)
        if kind == 0 and holder is not value:
            del holder[key]
        elif kind == 1 and isinstance(holder, dict):
            holder[choose.choice(["", "extra", str(there)])] = holder.pop(key)
        elif kind == 2:
            holder[key] = json.loads(json.dumps(other[there]))
        elif kind == 3 and isinstance(holder[key], int | float):
            holder[key] = holder[key] * choose.choice([-1, 0.1, 10, 1e30]) + choose.randrange(3)
        else:
            holder[key] = json.loads(json.dumps(choose.choice(ODD)))
        return json.dumps(value[0]).encode()
    except (ValueError, RecursionError, OverflowError):
        return None


def mutate(data: bytes, most: int, seed: int) -> bytes:
    """Of two changes one to the JSON that an input begins with; the others to its bytes."""
    text, zero, rest = data.partition(b"\0")
    changed = change_json(text, seed) if seed % 2 else None
    if changed is None or len(changed) + len(zero + rest) > most:
        return atheris.Mutate(data, most)
    return changed + zero + rest


def main() -> None:
    name = sys.argv.pop(1)
    # our sources themselves, and of the project's own environment what they import
    sys.path[:0] = [str(CHECKOUT / folder) for folder in ("bindings", "editor")]
    sys.path[:0] = [str(CHECKOUT / "tests" / folder) for folder in ("bindings", "editor")]
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    sys.path.append(str(CHECKOUT / ".venv/lib" / version / "site-packages"))
    with atheris.instrument_imports(include=OURS):
        harness = __import__(READERS[name])
    attempt = getattr(harness, f"try_{name}")

    def try_once(data: bytes) -> None:
        attempt(data)

    atheris.Setup(sys.argv, try_once, custom_mutator=mutate)
    atheris.Fuzz()


if __name__ == "__main__":
    main()
