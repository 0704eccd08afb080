# SPDX-License-Identifier: BSD-3-Clause
"""One object of every class the compiled module has, for tests that hold of all of them."""

from __future__ import annotations

import enum
from collections.abc import Callable, Iterator

import palpate
import palpate._sim
from stones import make_stone_scene
from surfaces import chain, organ_scene, sheet

SOLID = palpate.SolidMesh([(0, 0, 0), (0.01, 0, 0), (0, 0.01, 0), (0, 0, 0.01)], [(0, 1, 2, 3)])
ONE_VERTEX = ((0, 0, 0.02), (0, 0, 0.01))


def all_classes() -> Iterator[tuple[str, type]]:
    """Every class of palpate._sim and palpate.scenario that is no enum, with its full name."""
    for prefix, scope in (("", palpate._sim), ("scenario.", palpate.scenario)):
        for name, kind in vars(scope).items():
            if isinstance(kind, type) and not issubclass(kind, enum.Enum | Exception):
                yield prefix + name, kind
                for inner, nested in vars(kind).items():
                    if isinstance(nested, type):
                        yield f"{prefix}{name}.{inner}", nested


def full_state() -> palpate.State:
    state = palpate.State(chain(4))
    state.time = 0.25
    state.velocity[2] = (0.1, -0.2, 0.3)
    return state


def full_load() -> palpate.Load:
    load = palpate.Load(3)
    load.add(palpate.Push(0, (0.2, 0.3, 0.5), (1, 2, 3)))
    load.gravity = (0, 0, -9.8)
    return load


def full_record() -> palpate.Record:
    sample = palpate.HapticSample(time=0.001, position=(1, 2, 3), buttons=1)
    return palpate.Record(header='{"a": 1}', hand=[sample] * 2, felt=[palpate.Felt()] * 2)


def small_task() -> palpate.Task:
    places = [palpate.TaskPlace(kind=palpate.PlaceKind.region, vertices=[1, 2])]
    task = palpate.Task(
        places=places,
        steps=[palpate.TaskStep(place=0)],
        limits=[palpate.TaskLimit(bound=1.5)],
        time_limit=60.0,
    )
    return palpate.build_task(organ_scene(1), task)


def stone_of_task() -> palpate.TaskObject:
    task = palpate.Task(steps=[palpate.TaskStep(verb=palpate.TaskVerb.release)], time_limit=60.0)
    return palpate.build_task(make_stone_scene(), task).objects[1]


def held_solid() -> palpate.TissueModel:
    soft = palpate.Material(young_modulus=5e3, poisson_ratio=0.4)
    return palpate.build_linear_solid(SOLID, soft, palpate.SolidOptions(fixed=[0, 1, 2]))


def device() -> palpate.ScriptedDevice:
    return palpate.ScriptedDevice([palpate.KeyFrame(0.0, (0, 0, 0.05))])


def serial_device() -> palpate.SerialDevice:
    return palpate.SerialDevice(palpate.NativeCore())


def closest() -> palpate.SurfacePoint:
    mesh = sheet(3, 0.02)
    tree = palpate.AabbTree(mesh.vertices, mesh.triangles)
    found = palpate.find_closest_point(tree, mesh.vertices, (0.01, 0.012, 0.02))
    assert found
    return found


def checked() -> palpate.DeviceCheck:
    return palpate.check_conformance(device(), palpate.ConformanceOptions(duration=0.01))[0]


MADE: dict[str, Callable[[], object]] = {
    "SurfaceMesh": lambda: sheet(3, 0.02),
    "Scenery": lambda: palpate.Scenery(sheet(3, 0.02), [0], friction=0.1),
    "RigidBody": lambda: palpate.RigidBody(
        [(0, 0, 0), (1e-3, 0, 0)], [2e-3, 1e-3], mass=1e-3, inertia=(1e-9, 2e-9, 3e-9)
    ),
    "Topology": lambda: palpate.build_topology(sheet(3, 0.02).triangles),
    "SolidMesh": lambda: SOLID,
    "Links": lambda: chain(4).springs,
    "Angles": lambda: palpate.Angles([(0, 1, 2)], *[[(0.1, 0.2, 0.3)]] * 5),
    "Prisms": lambda: palpate.Prisms([(0, 1, 2, 3, 4, 5)], *[[(0.1, 0.2, 0.3)]] * 3),
    "Volumes": lambda: palpate.build_volumes(4, [(0, 1, 2, 3)], [1e-6], [5e3], 0.5),
    "Elastic": lambda: held_solid().elastic,
    "Hyperelastic": lambda: palpate.build_corotated_solid(SOLID, palpate.Material()).corotated,
    "Maxwell": lambda: palpate.Maxwell(0.5, 0.3),
    "Skin": lambda: palpate.Skin([(0, 1, 2, 3)], [(0.1, 0.2, 0.3, 0.4)]),
    "TissueModel": lambda: organ_scene(1).bodies[0].tissue,
    "SurfaceOptions": lambda: palpate.SurfaceOptions(
        stiffness_scale=[1.5] * 5000, fixed=[True] * 5000, home_stiffness=1e4
    ),
    "SolidOptions": lambda: palpate.SolidOptions(stiffness_scale=[2.0] * 500, fixed=[1, 2]),
    "CouplingRange": lambda: palpate.CouplingRange(-0.5, float("inf")),
    "NearField": lambda: palpate.build_near_field(held_solid(), 5e3, 3e-3),
    "Response": lambda: palpate.build_response(held_solid()),
    "State": full_state,
    "Load": full_load,
    "Guard": lambda: palpate.Guard(chain(4), (0, 0, -9.8), palpate.State(chain(4))),
    "AabbTree": lambda: palpate.AabbTree(sheet(3, 0.02).vertices, sheet(3, 0.02).triangles),
    "ToolState": lambda: palpate.ToolState(2, 3),
    "ToolState.Carrier": lambda: palpate.ToolState(1).carrier,
    "SurfacePoint": closest,
    "Candidates": lambda: palpate.Candidates(4),
    "HapticSample": lambda: palpate.HapticSample(
        time=1.5, position=(1, 2, 3), orientation=(0, 0.6, 0, 0.8), buttons=1, grip=0.2
    ),
    "Event": lambda: palpate.Event(tick=3, kind=palpate.EventKind.alarm, value=0.5),
    "StateHash": lambda: palpate.StateHash(tick=3, hash=(2**64 - 1, 5)),
    "Scene": lambda: organ_scene(1),
    "SoftBody": lambda: palpate.SoftBody(
        tissue=organ_scene(1).bodies[0].tissue, substeps=3, weightless=True
    ),  # fmt: skip
    "Instrument": lambda: palpate.Instrument(hold_stiffness=300.0),
    "World": lambda: palpate.World(organ_scene(1)),
    "SoftState": lambda: palpate.World(organ_scene(1)).bodies[0],
    "InstrumentState": lambda: palpate.World(organ_scene(1)).instruments[0],
    "BodyPair": lambda: palpate.BodyPair(
        0, 2, thickness=4e-4, stiffness=5e6, damping=0.2, friction=0.05
    ),
    "ContactPair": lambda: palpate.World(organ_scene(1)).pairs[0],
    "ScriptedDevice": device,
    "SurfacePointer": lambda: palpate.SurfacePointer(organ_scene(1)),
    "SceneSurfaces": lambda: palpate.SceneSurfaces(organ_scene(1)),
    "ScenePoint": lambda: palpate.SceneSurfaces(organ_scene(1)).find_closest_point((0, 0, 1)),
    "ReplayDevice": lambda: palpate.ReplayDevice([palpate.HapticSample()]),
    "Fulcrum": lambda: palpate.Fulcrum((0.0, 0.0, 0.2), 0.3),
    "FulcrumDevice": lambda: palpate.FulcrumDevice(device(), palpate.Fulcrum((0.0, 0.0, 0.2), 0.3)),
    "SafeDevice": lambda: palpate.SafeDevice(device()),
    "MailboxDevice": lambda: palpate.MailboxDevice("box"),
    "DeviceLoop": lambda: palpate.DeviceLoop(device()),
    "DeviceCheck": checked,
    "FaultyDevice": lambda: palpate.FaultyDevice(device(), palpate.Faults()),
    "FaultyTransport": lambda: palpate.FaultyTransport(palpate.NativeCore(), palpate.Faults()),
    "SimulatedArm": lambda: palpate.SimulatedArm(device()),
    "SerialDevice": serial_device,
    "DeviceStatus": lambda: serial_device().status(),
    "VelocityWindow": lambda: palpate.VelocityWindow(0.1),
    "PlantState": lambda: palpate.PlantState(palpate.Plant()),
    "Calibration": lambda: palpate.find_calibration(palpate.Plant()),
    "Loop": lambda: palpate.Loop(organ_scene(1), device()),
    "SlowTissue": lambda: palpate.SlowTissue(organ_scene(1), 1000.0, 10),
    "LocalModel": lambda: palpate.LocalModel(
        time=0.5, force=(0, 0, 0.1), normal=(0, 0, 1), stiffness=[[1, 0, 0], [0, 2, 0], [0, 0, 3]]
    ),
    "Snapshot": lambda: palpate.Loop(organ_scene(1), device()).snapshot(),
    "BodySnapshot": lambda: palpate.Loop(organ_scene(1), device()).snapshot().bodies[0],
    "RigidSnapshot": lambda: palpate.Loop(make_stone_scene(), device()).snapshot().rigid[0],
    "InstrumentSnapshot": lambda: palpate.Loop(organ_scene(1), device()).snapshot().instruments[0],
    "DeviceReport": lambda: palpate.Loop(organ_scene(1), device()).report().devices[0],
    "LoopReport": lambda: palpate.Loop(organ_scene(1), device()).report(),
    "Percentiles": lambda: palpate.Loop(organ_scene(1), device()).report().cost,
    "Record": full_record,
    "ReplayReport": lambda: palpate.replay(organ_scene(1), palpate.Record()),
    "TaskPlace": lambda: palpate.TaskPlace(points=[(1, 2, 3)], radius=0.01),
    "TaskStep": lambda: palpate.TaskStep(place=2, force=palpate.Band(0.1, 0.4), after=[0, 1]),
    "TaskLimit": lambda: palpate.TaskLimit(place=1, bound=1.5, during=[0]),
    "TaskCamera": lambda: palpate.TaskCamera(instrument=1, at=(0, 0, 0.01), field_of_view=1.0),
    "TaskObject": stone_of_task,
    "TaskSurface": lambda: small_task().surfaces[0],
    "Task": small_task,
    "StepState": lambda: palpate.Progress(small_task()).state.steps[0],
    "LimitState": lambda: palpate.Progress(small_task()).state.limits[0],
    "TaskState": lambda: palpate.Progress(small_task()).state,
    "Progress": lambda: palpate.Progress(small_task()),
    "ImplicitStepper": lambda: palpate.ImplicitStepper(chain(4), palpate.Integrator.implicit_euler),
    "scenario.Container": lambda: palpate.scenario.Container(
        format="organ", version=2, content='{"a": 1}', arrays={"x": [[1.0, 2.0]]}
    ),
    "scenario.Scenario": lambda: palpate.scenario.Scenario(
        scene=organ_scene(1), title="Liver", task="Press it.", authored_arrays={"x": [1, 2]}
    ),
}
"""What a class that has no use without arguments is made from."""

NOT_MADE = {
    "HapticDevice": "an interface",
    "Transport": "an interface",
    "SerialPort": "of what is plugged into this machine",
    "SerialTransport": "opens a real port",
    "Recorder": "writes a file",
    "BenchRow": "takes a measurement of some seconds",
}


def make(name: str) -> object:
    if name in MADE:
        return MADE[name]()
    return dict(all_classes())[name]()
