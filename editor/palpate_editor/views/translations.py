# SPDX-License-Identifier: GPL-3.0-or-later
"""Text for people: translation, and numbers with their unit."""

from __future__ import annotations

import math

import palpate
from palpate.translation.numbers import say_digits
from PySide6.QtCore import QCoreApplication

from palpate_editor.app.spoken import fill, say, say_title
from palpate_editor.document.constants import CONSTANTS
from palpate_editor.document.problems import Problem

__all__ = [
    "count",
    "fill",
    "number",
    "quantity",
    "say",
    "say_got",
    "say_memory",
    "say_problems",
    "say_title",
    "tr",
]

CONTEXT = "Editor"
THIN_SPACE = "\N{NARROW NO-BREAK SPACE}"


def tr(text: str) -> str:
    """The text in the language of the window."""
    return QCoreApplication.translate(CONTEXT, text)


def say_problems(errors: int, warnings: int) -> str:
    """2 errors to fix, 1 warning; what there is none of is left out."""
    parts = []
    if errors:
        several = tr("{count} errors to fix").format(count=errors)
        parts.append(tr("1 error to fix") if errors == 1 else several)
    if warnings:
        several = tr("{count} warnings").format(count=warnings)
        parts.append(tr("1 warning") if warnings == 1 else several)
    return ", ".join(parts)


def say_got(problem: Problem) -> str:
    """What was found, and of what where a number alone would not tell."""
    found = say(problem.got)
    constant = next((c for c in CONSTANTS if c.key == problem.where), None)
    text = found if constant is None else f"{say(constant.label)}: {found}"
    return text[:1].upper() + text[1:]


def number(value: float, digits: int = 4) -> str:
    """At most `digits` that count, thousands apart, a true minus sign and no e+07."""
    if value is None or not math.isfinite(value):
        return "\N{EN DASH}"
    if value == 0.0:
        return "0"
    power = math.floor(math.log10(abs(value)))
    if power >= 6 or power < -4:
        power = math.floor(math.log10(float(f"{abs(value):.{digits - 1}e}")))
        mantissa = f"{value / 10.0**power:.{digits - 1}f}"
        mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
        return (say_digits(mantissa) + "\N{MULTIPLICATION SIGN}10" + superscript(power)).replace(
            "-", "−"
        )
    decimals = max(0, digits - 1 - power)
    text = f"{value:,.{decimals}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    return say_digits(text.replace(",", THIN_SPACE)).replace("-", "−")


def superscript(power: int) -> str:
    return str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def count(value: int) -> str:
    """A whole number with its thousands apart."""
    return f"{value:,}".replace(",", THIN_SPACE)


def quantity(value: float | None, unit: str, digits: int = 4) -> str:
    """A number and its unit, held together; a dash where there is none."""
    if value is None or not math.isfinite(value):
        return "\N{EN DASH}"
    # a degree sign stands at its number
    space = "" if unit in ("", "°") else "\N{NO-BREAK SPACE}"
    return f"{number(value, digits)}{space}{unit}"


def say_memory(size: palpate.ResponseSize) -> str:
    """What a response takes, and for how many particles."""
    memory = quantity(1e-6 * size.bytes, "MB", 3)
    return tr("{memory} for {pushed} of {moved} particles").format(
        memory=memory, pushed=count(size.pushed), moved=count(size.moved)
    )
