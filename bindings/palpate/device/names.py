# SPDX-License-Identifier: BSD-3-Clause
"""The grammar of device names: how commands and windows call a device, and the hand of a play."""

from __future__ import annotations

from palpate.command.verb import WrongCall

POINTER = "pointer"
PARKED = "parked"
PLANT = "plant"
NATIVE = "native"
SERIAL = "serial:"
SCRIPT = "script:"
DEVICES = f"{PLANT}, {NATIVE} or {SERIAL}PATH"
"""What a link can be built to."""
HANDS = (
    f"{POINTER}, {SCRIPT}FILE, {PLANT}, {PLANT}:{SCRIPT}FILE, {SERIAL}PATH, or, for a task, "
    f"{SCRIPT}careful, {SCRIPT}idle, {SCRIPT}jab or {SCRIPT}clumsy"
)
"""What a scenario can be played with."""


def find_port(name: str) -> str:
    """The path of a serial device, /dev/ttyUSB0 of serial:/dev/ttyUSB0; "" for another name."""
    return name.removeprefix(SERIAL) if name.startswith(SERIAL) else ""


def name_port(port: str) -> str:
    """The device at a port."""
    return f"{SERIAL}{port}"


def read_device(text: str) -> str:
    """A device as a person types it: by its name, or a port alone."""
    return text if text in (PLANT, NATIVE) or text.startswith(SERIAL) else name_port(text)


def is_device(name: str) -> bool:
    """Whether it is one of DEVICES; not whether there is one."""
    return name in (PLANT, NATIVE) or bool(find_port(name))


def require_device(name: str) -> None:
    """Raises WrongCall for what is none of DEVICES."""
    if not is_device(name):
        raise WrongCall(f"device: got {name!r}, expected {DEVICES}")


def split_hand(name: str) -> tuple[str, str]:
    """One of HANDS as what the hand holds, PLANT, a serial device or "", and the file of the script
    that moves it or "". Raises WrongCall.
    """
    if find_port(name):
        return name, ""
    arm, _, rest = name.partition(":") if name.split(":")[0] == PLANT else ("", "", name)
    if rest.startswith(SCRIPT):
        return arm, rest.removeprefix(SCRIPT)
    if (arm and name == PLANT) or name == POINTER:
        return arm, ""
    raise WrongCall(f"--device: got {name!r}, expected {HANDS}")
