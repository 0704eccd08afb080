# SPDX-License-Identifier: BSD-3-Clause
"""Charts made up for tests of what reads, keeps and draws them."""

from __future__ import annotations

from palpate.study.scene_chart import (
    Chart,
    Configuration,
    Cost,
    Counts,
    Errors,
    Held,
    Machine,
    Row,
    Way,
)

SOLID = Configuration(
    kind="solid",
    constants="tissue",
    spring_rule="van_gelder",
    angle_law="gradient",
    stiffness=150.0,
    bend_stiffness=1e-3,
    stretch_coupling=0.1,
    home_stiffness=None,
    contact_law="near_field",
    integrator="symplectic_euler",
    substeps=0,
    vertices=0,
    tetrahedra=3000,
)


def make_row(
    number: int, *, cost: float = 1e-4, error: float = 0.1, reason: str = "", own: bool = False
) -> Row:
    """A row whose cost [s] is known to 10 %; one that an alarm ended where a reason is given."""
    ran = not reason
    return Row(
        number=number,
        name=f"solid, near field, row {number}",
        own=own,
        configuration=SOLID,
        provenance="from E 5 kPa, nu 0.45",
        outcome="ran" if ran else "alarm",
        reason=reason,
        kernel="packed",
        force=0.1,
        jump=1e-3,
        total=Errors(error, 2.0 * error, 0.5 * error) if ran else None,
        model=Errors(0.9 * error, 1.8 * error, 0.5 * error) if ran else None,
        time=Errors(0.1 * error, 0.2 * error, None) if ran else None,
        reference_limited=ran and error < 0.02,
        counts=Counts(800, 3000, 12, None, 12.0) if ran else None,
        cost=Cost(cost, 0.9 * cost, 1.1 * cost, 1.5 * cost, 0.0, 1000) if ran else None,
    )


def make_chart() -> Chart:
    rows = (
        make_row(0, own=True),
        make_row(1, cost=1e-3, error=0.01),
        make_row(2, reason="tetrahedron 7 turned inside out"),
    )
    return Chart(
        organ="Spleen",
        key="0" * 64,
        command="palpate chart spleen.palpate",
        young_modulus=5e3,
        poisson_ratio=0.45,
        wall_thickness=None,
        tool_radius=4e-3,
        rate=1000.0,
        force_target=0.10,
        displacement_target=0.05,
        complete=True,
        way=Way("press", "", 0.03, 3e-3, 1, 500),
        truth=Held("1" * 64, "linear", 0.12, 0.02, 0.01),
        machine=Machine("a processor", "AVX2", "one after the other"),
        rows=rows,
    )
