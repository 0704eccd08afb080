# SPDX-License-Identifier: BSD-3-Clause
"""What a new step or limit says until its author replaces it, in English and Turkish."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

Row = Mapping[str, Any]

STEPS = {
    "en": {
        "touch": "Touch: {at}", "hold": "Press and hold: {at}", "push": "Push in: {at}",
        "pull": "Take hold and pull out: {at}", "grasp": "Grasp: {at}", "release": "Let it go",
        "trace": "Follow the line: {at}", "find": "Find, and click while pressing: {at}",
        "look": "Bring it into the middle of the picture: {at}",
        "remove": "Take it out: {at}", "carry": "Bring it there: {at}",
    },
    "tr": {
        "touch": "Dokunun: {at}", "hold": "Bastırıp tutun: {at}", "push": "İçeri itin: {at}",
        "pull": "Tutup dışarı çekin: {at}", "grasp": "Kavrayın: {at}", "release": "Bırakın",
        "trace": "Çizgiyi izleyin: {at}", "find": "Bulun ve bastırırken tıklayın: {at}",
        "look": "Görüntünün ortasına getirin: {at}",
        "remove": "Dışarı çıkarın: {at}", "carry": "Yerine götürün: {at}",
    },
}  # fmt: skip
LIMITS = {
    "en": {
        "force": "Too hard", "force_rate": "Too sudden", "contact": "Keep off: {place}",
        "depth": "Too deep", "distance": "Pulled too far", "speed": "Too fast",
        "clearance": "Too near: {place}", "path.off": "Off the line",
        "strain": "Stretched too far", "loose": "Dropped: {place}",
        "out_of_view": "The tip is out of view", "object_force": "Pressed too hard: {place}",
        "pad_pressure": "Squeezed too hard", "torn": "The tissue has torn",
    },
    "tr": {
        "force": "Çok sert", "force_rate": "Çok ani", "contact": "Değmeyin: {place}",
        "depth": "Çok derin", "distance": "Fazla çekildi", "speed": "Çok hızlı",
        "clearance": "Çok yakın: {place}", "path.off": "Çizgiden çıktınız",
        "strain": "Fazla gerildi", "loose": "Düşürüldü: {place}",
        "out_of_view": "Uç görüş dışında", "object_force": "Çok sert bastırıldı: {place}",
        "pad_pressure": "Çok sert sıkıldı", "torn": "Doku yırtıldı",
    },
}  # fmt: skip
BANDS = (("force_N", "N", 1.0), ("depth_m", "mm", 1e3), ("distance_m", "mm", 1e3))
BETWEEN = {"en": "{a} to {b} {unit}", "tr": "{a} ile {b} {unit} arası"}
LEAST = {"en": "at least {a} {unit}", "tr": "en az {a} {unit}"}
MOST = {"en": "at most {b} {unit}", "tr": "en çok {b} {unit}"}
LASTING = {"en": "for {s} s", "tr": "{s} s boyunca"}


def say_step(step: Row, language: str) -> str:
    """A sentence with its bands, as far as they are numbers."""
    at = str(step.get("at", "")).lstrip("$").replace("-", " ")
    sentence = STEPS[language].get(str(step["do"]), str(step["do"])).format(at=at)
    parts = [say_band(step[key], unit, scale, language)
             for key, unit, scale in BANDS if key in step]  # fmt: skip
    lasting = step.get("for_s", 0)
    if isinstance(lasting, (int, float)) and lasting > 0:
        parts.append(LASTING[language].format(s=show(lasting, 1.0, language)))
    return ", ".join([sentence, *filter(None, parts)])


def say_band(band: Any, unit: str, scale: float, language: str) -> str:
    """Empty for one whose ends are parameters."""
    least, most = band
    if isinstance(least, str) or isinstance(most, str):
        return ""
    form = BETWEEN if None not in (least, most) else MOST if least is None else LEAST
    a = "" if least is None else show(least, scale, language)
    b = "" if most is None else show(most, scale, language)
    return form[language].format(a=a, b=b, unit=unit)


def show(value: float, scale: float, language: str) -> str:
    text = f"{value * scale:.3g}"
    return text.replace(".", ",") if language == "tr" else text


def say_limit(limit: Row, language: str) -> str:
    when = limit["when"]
    place = str(when.get("place", "")).lstrip("$").replace("-", " ")
    said = LIMITS[language].get(str(when["measure"]), str(when["measure"]))
    return said.format(place=place).rstrip(": ")
