# SPDX-License-Identifier: BSD-3-Clause
"""What the device window says of joints, poses and devices."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication, QLocale

from palpate.command.sentence import Sentence, fill
from palpate.device.names import NATIVE, PLANT, find_port
from palpate.device.poses import HOME, Pose

translate = QCoreApplication.translate
CONTEXT = "Device"


def say(text: Sentence) -> str:
    """A sentence of another module in the language of the window, its values too."""
    values = tuple(translate(CONTEXT, value) for value in text.values)
    return fill(translate(CONTEXT, text.template), values)


def number(value: float, decimals: int) -> str:
    """As the language of the window writes it, with a true minus sign."""
    locale = QLocale()
    locale.setNumberOptions(QLocale.NumberOption.OmitGroupSeparator)
    # what is rounded away has no sign: adding nothing makes -0.0 to 0.0
    shown = round(value, decimals) + 0.0
    return locale.toString(shown, "f", decimals).replace("-", "\N{MINUS SIGN}")


def say_joint(name: str) -> str:
    """yaw, elevation, forearm or one of the gimbal's."""
    return {
        "yaw": translate("Device", "yaw"),
        "elevation": translate("Device", "elevation"),
        "forearm": translate("Device", "forearm"),
        "gimbal yaw": translate("Device", "gimbal yaw"),
        "gimbal pitch": translate("Device", "gimbal pitch"),
        "gimbal roll": translate("Device", "gimbal roll"),
    }[name]


def say_pose(pose: Pose) -> tuple[str, str]:
    """A title, and how the arm is brought there."""
    if pose.name == HOME:
        return translate("Device", "Home pose"), translate(
            "Device",
            "Straight ahead, the upper link 30° above level, the forearm at a right angle to it, "
            "the stylus in line with the forearm. A set square of 30° holds it so.",
        )
    joint = say_joint(pose.name.rsplit(" ", 1)[0])
    title = (
        translate("Device", "Upper stop: %1")
        if pose.upper
        else translate("Device", "Lower stop: %1")
    )
    return title.replace("%1", joint), translate(
        "Device",
        "Turn this joint until it meets its stop and keep it there. The others stand about as the "
        "thin arm in the picture.",
    )


def say_axes() -> tuple[str, str, str]:
    """What the directions of the arm's frame are called."""
    return translate("Device", "right"), translate("Device", "away"), translate("Device", "up")


def say_direction(name: str) -> str:
    return {
        "right": translate("Device", "to the right"),
        "away": translate("Device", "away from you"),
        "up": translate("Device", "upwards"),
    }[name]


def say_device(name: str, product: str) -> str:
    """An entry of the list of devices."""
    if name == PLANT:
        return translate("Device", "Simulated arm, moved by the mouse")
    if name == NATIVE:
        return translate("Device", "Firmware's code behind a pseudo terminal")
    return f"{product or name} ({find_port(name) or name})"
