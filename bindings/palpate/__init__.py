# SPDX-License-Identifier: BSD-3-Clause
"""Soft-tissue organ models that a surgeon in training can feel.

Everything C++ offers in palpate::sim stands here under the same name, with the same parameters in
the same order: arrays are views of the library's own memory, SI units throughout. What it offers in
palpate::scenario stands in palpate.scenario.
"""

from palpate import scenario as scenario
from palpate._sim import *  # noqa: F403
from palpate._sim import __version__ as __version__
from palpate.error import DeviceError as DeviceError
from palpate.error import FileError as FileError
from palpate.error import NotDurable as NotDurable
from palpate.mesh_files import read_mesh as read_mesh
from palpate.python_device import PythonDevice as PythonDevice
