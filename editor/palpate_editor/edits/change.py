# SPDX-License-Identifier: GPL-3.0-or-later
"""What an edit has made of a surface, in numbers and in words."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from palpate_editor import authoring
from palpate_editor.document import Organ, Phrase, Surface, phrase
from palpate_editor.edits.edit import Edit
from palpate_editor.edits.inspected import inspect_surface, mesh_of


@dataclass(frozen=True)
class SurfaceChange:
    """A surface before an edit and after it."""

    before: authoring.MeshReport
    after: authoring.MeshReport
    from_before: float
    """[m] No point of the surface before is further from the one after; where `seen`, none that was
    seen from outside."""
    to_before: float
    """[m] No point of the surface after is further from the one before."""
    seen: bool = False
    """What lay inside counts for nothing."""


def measure_change(before: Surface, after: Surface, *, seen: bool = False) -> SurfaceChange:
    """Both surfaces, and how far they are from each other: a part of a second for a large one."""
    old, new = mesh_of(before), mesh_of(after)
    measure = authoring.measure_seen_distance if seen else authoring.measure_distance
    return SurfaceChange(
        inspect_surface(before),
        inspect_surface(after),
        measure(old, new).most,
        authoring.measure_distance(new, old).most,
        seen,
    )


def find_change(edit: Edit, before: Organ, after: Organ) -> SurfaceChange | None:
    """What the edit has changed. None where the surface is the same, or where there was none."""
    if before.surface is None or after.surface is None or before.surface is after.surface:
        return None
    seen = getattr(edit, "drops_inside", False)
    return measure_change(before.surface, after.surface, seen=seen)


def say_change(change: SurfaceChange) -> list[Phrase]:
    """What is different now, and the price of it."""
    old, new = change.before, change.after
    said = list(say_counts(old, new))
    if old.volume_ml and new.volume_ml:
        said.append(
            phrase(
                "volume {old:.4g} to {new:.4g} ml ({share:+.2f} %)",
                old=old.volume_ml,
                new=new.volume_ml,
                share=100.0 * (new.volume_ml / old.volume_ml - 1.0),
            )
        )
    elif new.volume_ml:
        said.append(phrase("closed now, volume {new:.4g} ml", new=new.volume_ml))
    said.append(say_distances(change))
    return said


def say_distances(change: SurfaceChange) -> Phrase:
    to, back = (round(1e3 * away, 6) for away in (change.to_before, change.from_before))
    if change.seen:
        return phrase(
            "no point further than {to:.3g} mm from the surface before, and nothing that was seen "
            "of that from outside further than {back:.3g} mm from the new one; what lay inside is "
            "gone",
            to=to,
            back=back,
        )
    return phrase(
        "no point further than {to:.3g} mm from the surface before, nor it than {back:.3g} mm "
        "from the new one",
        to=to,
        back=back,
    )


def say_counts(old: authoring.MeshReport, new: authoring.MeshReport) -> Iterator[Phrase]:
    """Those that are others than before."""
    if new.triangles != old.triangles:
        yield phrase("{old} triangles, now {new}", old=old.triangles, new=new.triangles)
    if new.shells != old.shells:
        yield phrase("{old} pieces, now {new}", old=old.shells, new=new.shells)
    if len(new.border_loops) != len(old.border_loops):
        yield phrase("{old} holes, now {new}", old=len(old.border_loops), new=len(new.border_loops))
    if new.non_manifold_edges != old.non_manifold_edges:
        yield phrase(
            "{old} edges with more than two triangles, now {new}",
            old=old.non_manifold_edges,
            new=new.non_manifold_edges,
        )
    crossing, crosses = old.self_intersecting_faces, new.self_intersecting_faces
    if crossing != crosses and crossing is not None and crosses is not None:
        yield phrase("{old} triangles that cross others, now {new}", old=crossing, new=crosses)
    elif crossing is None and crosses is not None:
        yield phrase("{new} triangles that cross others, too many to count before", new=crosses)
