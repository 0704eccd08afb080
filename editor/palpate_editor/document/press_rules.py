# SPDX-License-Identifier: GPL-3.0-or-later
"""The rules about what a press feels: what carries it, and what is too coarse for it."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot, sqrt

from palpate_editor.document.defaults import FILL
from palpate_editor.document.far_compliance import is_stale, wants_far_field
from palpate_editor.document.organ import Organ
from palpate_editor.document.phrase import phrase
from palpate_editor.document.problems import Facts, Problem, TissueFacts

MOST_HOME_SHARE = 0.5
"""[-] of the felt force. Beyond it a foundation of springs is felt, and not the tissue."""
EDGE_FACTOR = 0.85
"""[-] How much too stiff a contact of radius a is on edges h, over h/a where h is large [accuracy:
patch]."""
MOST_PATCH_FACTOR = 1.25
"""[-] of the tissue's force, up to which a filling is not warned of."""
LOCKING_POISSON, LOCKING_SHARE, LOCKED = 0.46, 0.7, 2.0
"""[-] Above this Poisson's ratio and below this nodal share volumes lock; how much stiffer than at
a share of 0.9, at most [accuracy: patch]."""


def compute_patch_factor(edge: float, contact_radius: float) -> float:
    """[-] How many times too large the force of a tip is on tetrahedra with edges [m] at the
    surface, about: sqrt(1 + (0.85 h/a)²), fitted to what the tick gives [accuracy: patch]."""
    return hypot(1.0, EDGE_FACTOR * edge / contact_radius)


def compute_contact_radius(radius: float, depth: float) -> float:
    """[m] a = sqrt(R d) of a tip pressed in by no more than its radius [Hertz82]."""
    return sqrt(radius * min(depth, radius))


def find_press_problems(organ: Organ, facts: Facts) -> Iterator[Problem]:
    """Of the Material stage."""
    if facts.tissue is None or facts.tissue.trial is None:
        return
    yield from find_home_problems(facts.tissue)
    yield from find_patch_problems(organ, facts.tissue)
    yield from find_far_field_problems(organ)
    yield from find_locking_problems(organ, facts.tissue)


def find_home_problems(tissue: TissueFacts) -> Iterator[Problem]:
    assert tissue.trial is not None
    shares = tissue.trial.home_shares
    if not shares or max(shares) <= MOST_HOME_SHARE:
        return
    yield Problem(
        "home_share",
        "warning",
        "material",
        "model.home_stiffness",
        phrase(
            "{least:.0%} to {most:.0%} of the felt force through home springs, by place ({count} "
            "pressed {depth:g} mm)",
            least=min(shares),
            most=max(shares),
            count=len(shares),
            depth=1e3 * tissue.trial.depth,
        ),
        phrase(
            "at most {most:.0%}: else a foundation of springs is felt, which Young's modulus does "
            "not set; a solid has none, nor has a wall that bends",
            most=MOST_HOME_SHARE,
        ),
    )


def find_patch_problems(organ: Organ, tissue: TissueFacts) -> Iterator[Problem]:
    """Whether the tetrahedra are too large for what the tip touches, where they are felt."""
    assert tissue.trial is not None
    edges, radius, depth = tissue.trial.edges, organ.tool.radius, tissue.trial.depth
    if not edges or not radius > 0.0 or organ.model.contact_law != "hard":
        return
    contact = compute_contact_radius(radius, depth)
    least, most = (compute_patch_factor(edge, contact) for edge in (min(edges), max(edges)))
    if most <= MOST_PATCH_FACTOR:
        return
    fine = contact * sqrt(MOST_PATCH_FACTOR**2 - 1.0) / EDGE_FACTOR
    yield Problem(
        "coarse_contact",
        "warning",
        "material",
        "model.contact_law",
        phrase(
            "edges of {low:.1f} to {high:.1f} mm at the surface under a contact radius of "
            "{contact:.1f} mm (a tip of {radius:g} mm pressed {depth:g} mm): by place the force is "
            "about {least:.1f} to {most:.1f} times that of the tissue",
            low=1e3 * min(edges),
            high=1e3 * max(edges),
            contact=1e3 * contact,
            radius=1e3 * radius,
            depth=1e3 * depth,
            least=least,
            most=most,
        ),
        phrase(
            "contact as on tissue, which is felt alike on any mesh; or edges of at most {edge:.1f} "
            "mm for {times:g} times: more tetrahedra or a larger tip",
            edge=1e3 * fine,
            times=MOST_PATCH_FACTOR,
        ),
    )


def find_far_field_problems(organ: Organ) -> Iterator[Problem]:
    """Whether what gives way beyond the ball is the organ, or its tetrahedra."""
    if not wants_far_field(organ):
        return
    stale = is_stale(organ)
    if organ.far_field is not None and not stale:
        return
    got = phrase("that of these tetrahedra, stiffer than tissue where they are large")
    if stale:
        got = phrase(
            "one that was solved before the surface, what is held or painted, or Poisson's ratio "
            "was changed: that of these tetrahedra is felt"
        )
    yield Problem(
        "far_field",
        "warning" if stale else "note",
        "material",
        "model.contact_law",
        got,
        phrase("one that was solved on a finer mesh, in seconds: it costs a tick nothing"),
    )


def find_locking_problems(organ: Organ, tissue: TissueFacts) -> Iterator[Problem]:
    """Whether a solid is nearly incompressible in each tetrahedron by itself."""
    nu, share = organ.material.poisson_ratio, organ.fill.nodal_share
    if not tissue.tetrahedra or nu <= LOCKING_POISSON or share >= LOCKING_SHARE:
        return
    yield Problem(
        "locking",
        "warning",
        "material",
        "fill.nodal_share",
        phrase(
            "{share:g} with a Poisson's ratio of {nu:g}: single tetrahedra that hardly change "
            "their volume lock, and the force is up to {times:g} times that at {usual:g}",
            share=share,
            nu=nu,
            times=LOCKED,
            usual=FILL.nodal_share,
        ),
        phrase("a nodal share of about {usual:g}", usual=FILL.nodal_share),
    )
