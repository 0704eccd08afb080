# SPDX-License-Identifier: GPL-3.0-or-later
"""How organs look: the styles that ship, another colour for one of them, and the fitting one."""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cache
from typing import TypeVar

from palpate.scene.scene_parts import AppearancePart
from palpate_meshes.catalogue import read_tissues

Named = TypeVar("Named")
Colour = tuple[float, ...]
"""sRGB, 0 to 1."""

USUAL = "soft_patch"
"""Of an organ whose name tells nothing."""
SHORTEST = 5
"""[letters] A word so long is found inside others too, as liver is in OpenHELPliver."""
COLOURS = ("colour", "pattern_colour", "vein_colour")
"""Fields of an appearance that another colour shifts."""


@dataclass(frozen=True)
class Style:
    """An appearance that ships."""

    name: str
    title: str
    appearance: AppearancePart
    names: tuple[str, ...]
    """Folded words of what looks like it."""


@cache
def read_styles() -> dict[str, Style]:
    """Every style by its name, in the order of meshes/tissues.toml."""
    return {
        tissue.name: Style(
            tissue.name, tissue.title, tissue.appearance, tuple(map(fold, tissue.names))
        )
        for tissue in read_tissues().values()
    }


def make_appearance(style: str, colour: Colour | None = None) -> AppearancePart:
    """The appearance of a style, in another colour where one is given. Raises KeyError for another
    style."""
    appearance = read_styles()[style].appearance
    return appearance if colour is None else recolour(appearance, colour)


def recolour(appearance: AppearancePart, colour: Colour) -> AppearancePart:
    """The appearance in another colour; spots and vessels stand out from it as they did before."""
    shifted = {
        name: tuple(
            min(1.0, max(0.0, new + own - old))
            for own, old, new in zip(
                getattr(appearance, name), appearance.colour, colour, strict=True
            )
        )
        for name in COLOURS
    }
    return replace(appearance, **shifted)


def find_style(appearance: AppearancePart | None) -> Style | None:
    """The style that an appearance is of, whatever its colour; None for plain tissue and for
    appearances of no style."""
    if appearance is None:
        return None
    for style in read_styles().values():
        if (
            replace(appearance, **{name: getattr(style.appearance, name) for name in COLOURS})
            == style.appearance
        ):
            return style
    return None


def fold(text: str) -> str:
    """Words in small letters without accents, one space before each: `KidneyLeft_1` becomes
    ` kidney left`."""
    apart = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text)
    plain = unicodedata.normalize("NFKD", apart.replace("ı", "i").replace("İ", "I").lower())
    return "".join(f" {word}" for word in re.findall(r"[a-z]+", strip_accents(plain)))


def strip_accents(text: str) -> str:
    return "".join(letter for letter in text if not unicodedata.combining(letter))


def find_longest_word(
    words: Iterable[tuple[str, Named]], is_in: Callable[[str], bool]
) -> Named | None:
    """What the longest of the folded words stands for that `is_in` finds in a name: of kidney stone
    and kidney, the stone. None where there is none; of equals, the first."""
    best, length = None, 0
    for word, named in words:
        if len(word) > length and is_in(word):
            best, length = named, len(word)
    return best


def find_named_style(name: str) -> str | None:
    """The style of which a name has a word; long ones are found inside others too."""
    folded = fold(name)
    words = ((word, style.name) for style in read_styles().values() for word in style.names)
    return find_longest_word(
        words,
        lambda word: word in folded or (len(word) > SHORTEST and word[1:] in folded),
    )


def choose_appearance(name: str, parts: Iterable[str] = ()) -> AppearancePart:
    """The appearance that fits an organ by its name or, where that tells nothing, by those of most
    of its parts."""
    style = find_named_style(name)
    if style is None:
        told = Counter(found for part in parts if (found := find_named_style(part)) is not None)
        style = told.most_common(1)[0][0] if told else USUAL
    return read_styles()[style].appearance


def write_colour(colour: Colour) -> str:
    """#rrggbb, as read_colour takes it."""
    return "#" + "".join(f"{round(255 * part):02x}" for part in colour)


def read_colour(text: str) -> Colour:
    """A colour written as #rrggbb. Raises ValueError."""
    if not re.fullmatch(r"#?[0-9a-fA-F]{6}", text):
        raise ValueError(f"got {text!r}, expected #rrggbb, as in #7a2d25")
    digits = text.removeprefix("#")
    return tuple(int(digits[i : i + 2], 16) / 255.0 for i in (0, 2, 4))
