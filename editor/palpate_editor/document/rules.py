# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules an organ is held to, stage by stage."""

from __future__ import annotations

from collections.abc import Iterator

from palpate.scenario import MOST_PARTICLES

from palpate_editor.document.cost_rules import (
    find_cost_problems,
    find_exchange_problems,
    find_late_problems,
    find_substep_problems,
    find_surface_cost_problems,
)
from palpate_editor.document.fill_rules import find_filling_problems
from palpate_editor.document.fit_rules import find_fit_problems
from palpate_editor.document.material_rules import find_material_problems
from palpate_editor.document.organ import Organ
from palpate_editor.document.organ_sizes import LEAST, find_range, find_word
from palpate_editor.document.phrase import Phrase, phrase
from palpate_editor.document.press_rules import find_press_problems
from palpate_editor.document.problems import Facts, Problem, SurfaceFacts
from palpate_editor.document.shape_rules import find_shape_problems

FAR_OFF = 2.5
"""[-] An organ so many times larger than any of its name, or smaller than any organ, cannot be
published: a unit is wrong by ten, or by two and a half where it is inches."""
MOST_CROSSING = 0.02
"""[-] of its triangles may cross others: small folds, which decimation and smoothing mostly take
out. More of them are parts that lie inside each other."""
FAR = 0.03
"""[-] Of the diagonal: how far a decimated surface may be from its source."""
ANGLE_LEAST = 15.0
"""[degree] Needles make a model stiff and its stretch-bend range collapse [laws: degenerate]."""


def find_problems(organ: Organ, facts: Facts) -> list[Problem]:
    """All problems, stage by stage."""
    found: list[Problem] = []
    for rules in (
        find_import_problems,
        find_repair_problems,
        find_shape_problems,
        find_decimate_problems,
        find_filling_problems,
        find_material_problems,
        find_press_problems,
        find_fit_problems,
        find_cost_problems,
        find_exchange_problems,
        find_substep_problems,
        find_test_problems,
        find_publish_problems,
        find_late_problems,
    ):
        found += rules(organ, facts)
    return found


def find_import_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    if organ.surface is None or facts.surface is None:
        yield Problem(
            "no_surface", "error", "import", "organ", phrase("no surface"), phrase("a mesh file")
        )
        return
    yield from find_size_problems(organ, facts.surface.diagonal)
    source = organ.source
    if source is not None and source.unit_guessed:
        yield Problem(
            "unit_guessed",
            "warning",
            "import",
            "unit",
            phrase("{unit}, guessed ({why})", unit=source.unit, why=source.unit_reason),
            phrase("a unit that you have confirmed"),
        )
    if source is not None and source.up_guessed:
        yield Problem(
            "up_guessed",
            "note",
            "import",
            "up",
            phrase("{up}, guessed ({why})", up=source.up, why=source.up_reason),
            phrase("an axis that you have confirmed"),
        )


def find_organ_word(organ: Organ) -> str | None:
    """What says which organ the whole of it is; None of some parts, which are of any size."""
    source = organ.source
    if source is None or source.parts == source.parts_available:
        return find_word((organ.name, source.file if source else ""))
    return None


def find_size_problems(organ: Organ, size: float) -> Iterator[Problem]:
    word = find_organ_word(organ)
    least, most = find_range(word)
    if least <= size <= most:
        return
    yield Problem(
        "size",
        "warning" if LEAST / FAR_OFF <= size <= most * FAR_OFF else "error",
        "import",
        "unit",
        phrase("an organ of {size:.4g} mm from corner to corner", size=1e3 * size)
        if word is None
        else phrase(
            "an organ of {size:.4g} mm from corner to corner, whose name says {word}",
            size=1e3 * size,
            word=word,
        ),
        phrase("{least:g} to {most:g} mm", least=1e3 * least, most=1e3 * most),
    )


def repair_problem(key: str, severity: str, found: Phrase, expected: Phrase) -> Problem:
    return Problem(key, severity, "repair", "surface", found, expected)


def find_repair_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    found = facts.surface
    if found is None:
        return

    if found.non_manifold_edges:
        yield repair_problem(
            "non_manifold",
            "error",
            phrase("{count} edges with more than two triangles", count=found.non_manifold_edges),
            phrase("at most two triangles at every edge: cut along those, or choose fewer parts"),
        )
    if not found.orientable:
        yield repair_problem(
            "one_sided",
            "error",
            phrase("a surface with one side only, like a Moebius band"),
            phrase("one with an inside and an outside: cut where neighbours disagree"),
        )
    if found.outward is False:
        yield repair_problem(
            "inward", "error", phrase("triangles that face inwards"), phrase("outwards")
        )
    if found.shells > 1:
        yield repair_problem(
            "shells",
            "warning",
            phrase("{count} pieces that nothing holds together", count=found.shells),
            phrase("one piece"),
        )
    if found.inner_shells:
        yield repair_problem(
            "inner",
            "warning",
            phrase(
                "{count} pieces inside others, not seen from outside; {doubled} of them face "
                "outwards too: they count twice in the volume and are filled hollow",
                count=found.inner_shells,
                doubled=found.doubled_shells,
            )
            if found.doubled_shells
            else phrase(
                "{count} pieces inside others, not seen from outside", count=found.inner_shells
            ),
            phrase("the outer surface alone, which is what is touched"),
        )
    yield from find_hole_problems(organ, found)


def find_hole_problems(organ: Organ, found: SurfaceFacts) -> Iterator[Problem]:
    """Where a surface ends, and where it runs through itself."""
    if found.border_loops:
        least, most = min(found.border_loops), max(found.border_loops)
        count = len(found.border_loops)
        yield repair_problem(
            "holes",
            "note",
            phrase("a hole of {edges} edges", edges=most)
            if count == 1
            else phrase("{count} holes of {edges} edges each", count=count, edges=most)
            if least == most
            else phrase(
                "{count} holes of {least} to {most} edges", count=count, least=least, most=most
            ),
            phrase("a closed surface, or a hollow organ or sheet that has them")
            if organ.material.wall_thickness is None
            else phrase(
                "a closed surface, or the wall of {wall:g} mm that it has now (Material)",
                wall=1e3 * organ.material.wall_thickness,
            ),
        )
    if found.self_intersecting_faces is None:
        yield repair_problem(
            "self_intersections",
            "error",
            phrase("so many triangles on top of each other that counting was given up"),
            phrase("a surface that does not cross itself"),
        )
    elif found.self_intersecting_faces > MOST_CROSSING * found.triangles:
        yield repair_problem(
            "crossing",
            "error",
            phrase(
                "{count} of {all} triangles that cross others, as of parts inside each other",
                count=found.self_intersecting_faces,
                all=found.triangles,
            ),
            phrase(
                "at most {most:g} %: choose fewer parts, unite them, or keep the largest piece",
                most=100.0 * MOST_CROSSING,
            ),
        )
    elif found.self_intersecting_faces:
        yield repair_problem(
            "self_intersections",
            "warning",
            phrase("{count} triangles that cross others", count=found.self_intersecting_faces),
            phrase("none"),
        )


def find_distance_problems(organ: Organ, diagonal: float) -> Iterator[Problem]:
    """Whether a decimated surface is still that of the organ."""
    done = organ.decimation
    if done is None or done.max_distance <= FAR * diagonal:
        return
    yield Problem(
        "far",
        "warning",
        "decimate",
        "surface",
        phrase("{distance:.2f} mm from the source", distance=1e3 * done.max_distance),
        phrase(
            "at most {most:.2f} mm, {share:.0%} of its size: keep more vertices",
            most=1e3 * FAR * diagonal,
            share=FAR,
        ),
    )


def find_decimate_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    if facts.surface is None:
        return
    angle = facts.surface.smallest_angle_deg
    if angle is not None and angle < ANGLE_LEAST:
        yield Problem(
            "angles",
            "warning",
            "decimate",
            "surface",
            phrase("a smallest angle of {angle:.1f} degrees", angle=angle),
            phrase("at least {least:g}: decimate it", least=ANGLE_LEAST)
            if organ.decimation is None
            else phrase("at least {least:g}: keep more vertices", least=ANGLE_LEAST),
        )
    yield from find_distance_problems(organ, facts.surface.diagonal)
    if organ.vertex_count > MOST_PARTICLES:
        yield Problem(
            "too_many",
            "error",
            "decimate",
            "vertices",
            phrase("{count} vertices", count=organ.vertex_count),
            phrase("at most {most}: decimate", most=MOST_PARTICLES),
        )
    yield from find_surface_cost_problems(organ, facts)


def find_test_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    if organ.surface is not None and facts.tested is False:
        yield Problem(
            "untested",
            "note",
            "test",
            "organ",
            phrase("never felt as it is now"),
            phrase("a test, so that you know what the trainee will feel"),
        )


def find_publish_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    if not organ.title.strip():
        yield Problem(
            "no_title",
            "error",
            "publish",
            "title",
            phrase("no title"),
            phrase("what the trainee chooses it by"),
        )
    if not organ.task.strip():
        yield Problem(
            "no_task",
            "note",
            "publish",
            "task",
            phrase("no task"),
            phrase("what the trainee is asked to do"),
        )
