# SPDX-License-Identifier: BSD-3-Clause
"""The page of the protocol is enough: a host made of its tables, parsed, drives the firmware."""

from __future__ import annotations

import struct
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import palpate
import pytest
from protocol_page import Page, pack, unpack

PAGE = Page()
NUMBER = PAGE.numbers
LAW = 1 << 0
ZEROS = {"flags": 0, "torque": (0, 0, 0)}


def compute_crc(data: bytes) -> int:
    """By the polynomial of the page, lowest bit first."""
    reflected = int(f"{NUMBER['crc_polynomial']:016b}"[::-1], 2)
    crc = NUMBER["crc_start"]
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ reflected if crc & 1 else crc >> 1
    return crc


def encode(body: bytes) -> bytes:
    blocks = (body + struct.pack("<H", compute_crc(body))).split(b"\0")
    return b"".join(bytes([len(block) + 1]) + block for block in blocks) + b"\0"


def decode(wire: bytes) -> bytes:
    blocks = []
    while wire:
        blocks.append(wire[1 : wire[0]])
        wire = wire[wire[0] :]
    frame = b"\0".join(blocks)
    assert compute_crc(frame[:-2]) == struct.unpack("<H", frame[-2:])[0]
    return frame[:-2]


@dataclass
class Host:
    """Knows the page, and a wire."""

    wire: palpate.NativeCore
    time: float = 0.0
    seq: int = 0
    rest: bytes = b""
    heard: dict[str, dict[str, Any]] = field(default_factory=dict)
    """The last message of every kind."""
    states: int = 0

    def say(self, name: str, **values: Any) -> None:
        self.seq = (self.seq + 1) & 0xFF
        message = PAGE.messages[name]
        fields = message.fields + (message.more if values.get("flags", 0) & LAW else [])
        body = bytes([message.code, self.seq]) + pack(fields, values)
        assert len(body) <= NUMBER["body_most"]
        self.wire.write(self.time, encode(body))

    def wait(self, ms: float = 1.0) -> None:
        for step in [1.0] * int(ms) + [ms % 1]:
            self.listen(step)

    def listen(self, ms: float) -> None:
        self.time += 1e-3 * ms
        *frames, self.rest = (self.rest + self.wire.read(self.time)).split(b"\0")
        for body in map(decode, filter(None, frames)):
            names = [n for n, m in PAGE.messages.items() if m.code == body[0]]
            found = unpack(PAGE.messages[names[0]].fields, body[2:])
            self.heard[names[0]] = {"seq": body[1], **found}
            self.states += names[0] == "STATE"

    def ask(self, name: str, **values: Any) -> str:
        """What is answered, in the words of the page; empty for nothing."""
        self.heard.pop("ANSWER", None)
        self.say(name, **values)
        self.wait(3)
        answer = self.heard.get("ANSWER")
        if answer is None:
            return ""
        assert (answer["seq"], answer["type"]) == (self.seq, PAGE.messages[name].code)
        return next(words for words, n in PAGE.results.items() if n == answer["result"])

    def drive(self, ms: int, **values: Any) -> None:
        for _ in range(ms):
            self.say("COMMAND", **(ZEROS | values))
            self.wait()

    def session(self) -> int:
        return self.heard["INFO"]["session"]

    def mode(self) -> str:
        number = self.heard["STATE"]["mode + 16 buttons"] & 15
        return next(name for name, mode in PAGE.modes.items() if mode == number)

    def first_fault(self) -> str:
        number = (self.heard["STATE"]["faults"] >> 12) - 1
        return next((name for name, bit in PAGE.faults.items() if bit == number), "")

    def greet(self) -> None:
        self.say("HELLO", version=NUMBER["version"], nonce=77)
        self.wait(3)

    def power_up(self) -> None:
        """HELLO, CLEAR, the zeros, ENABLE, the ramp."""
        self.greet()
        assert self.ask("CLEAR", session=self.session()) == "done"
        self.drive(NUMBER["zeros"])
        assert self.ask("ENABLE", session=self.session()) == "done"
        assert self.mode() == "RAMP"
        self.drive(NUMBER["ramp"] + 2)
        assert self.mode() == "RUN"

    def read_pages(self) -> bytes:
        pages = b""
        for page in range(7):
            self.say("READ_PAGE", page=page)
            self.wait(3)
            assert self.heard["PAGE"]["page"] == page
            pages += bytes(self.heard["PAGE"]["bytes"])
        return pages


@pytest.fixture
def host() -> Host:
    made = Host(palpate.NativeCore())
    made.wait(5)
    return made


def test_the_pages_crc_and_example_frame_are_right():
    assert compute_crc(b"123456789") == NUMBER["crc_check"]
    example = bytes.fromhex("02 07 03 b0 bd 00")
    assert f"`{example.hex(' ')}`" in PAGE.text
    assert encode(bytes([PAGE.messages["DISABLE"].code, 0])) == example
    assert NUMBER["rest_most"] == (2**10 - 1) * 2 ** NUMBER["fraction_bits"]


def test_a_host_of_the_page_hears_nothing_before_hello_but_may_read_pages(host):
    assert host.states == 0

    pages = host.read_pages()

    assert host.states == 0
    host.greet()
    assert host.states > 0
    assert host.mode() == "IDLE"
    assert host.heard["INFO"]["calibration_crc"] == compute_crc(pages)
    assert host.ask("HELLO", version=NUMBER["version"] + 1, nonce=1) == "wrong version"


def test_a_host_of_the_page_gets_the_torques_it_asks_for(host):
    host.power_up()
    torque = (6000, -6000, 2000)

    host.drive(10, torque=torque)

    full = NUMBER["torque_full"] + 1
    wanted = tuple(round(t * NUMBER["duty_full"] / full) for t in torque)
    assert host.heard["STATE"]["duty"] == wanted
    assert tuple(host.wire.drive().duty) == wanted
    host.drive(20, torque=(NUMBER["torque_full"],) * 3)
    assert host.heard["STATE"]["duty"] == (NUMBER["duty_most"],) * 3


def test_a_host_of_the_page_has_the_local_law_obeyed_and_its_ranges_kept(host):
    host.power_up()
    at = host.heard["STATE"]["position"][:3]
    one = 2 ** NUMBER["fraction_bits"]
    law = {"flags": LAW | 4 << 4, "torque": (0, 0, 0), "stiffness": (4000, 0, 0, 0, 0, 0)}
    law["rest"] = (one * at[0] + 24 * one, one * at[1], one * at[2])

    host.drive(10, **law)

    torque = 4000 * 24 * one >> 4 + 4
    full = NUMBER["torque_full"] + 1
    assert abs(host.heard["STATE"]["duty"][0] - torque * NUMBER["duty_full"] / full) <= 12
    assert host.heard["STATE"]["duty"][0] > 20
    least = {"rest": (NUMBER["rest_most"],) * 3}
    assert host.ask("COMMAND", **(law | least)) == ""
    most = {"rest": (NUMBER["rest_most"] + 1, 0, 0)}
    assert host.ask("COMMAND", **(law | most)) == "bad value"
    for flags in (NUMBER["shift_most"] + 1 << 4, *(1 << b for b in range(1, 4))):
        assert host.ask("COMMAND", **(ZEROS | {"flags": flags})) == "bad value"
        assert flags >> 4 or flags & NUMBER["flags_zero"] == flags


def test_a_host_of_the_page_that_falls_silent_loses_its_torque_when_the_page_says(host):
    host.power_up()
    host.drive(10, torque=(6000, 0, 0))
    before = host.heard["STATE"]["duty"][0]

    host.wait(NUMBER["hold"] - 1)
    assert host.heard["STATE"]["duty"][0] == before
    host.wait(NUMBER["silent"] - NUMBER["hold"] - 2)
    assert host.mode() == "RUN"
    assert 0 < host.heard["STATE"]["duty"][0] < before / 2
    host.wait(6)

    assert (host.mode(), host.first_fault()) == ("FAULTED", "host silent")


def test_a_host_of_the_page_sees_every_stop_of_the_shortest_length_and_clears_it(host):
    for phase in range(10):
        host.power_up()
        host.wait(0.1 * phase)
        host.wire.press_stop(True)
        host.wait(NUMBER["stop_pulse"])
        host.wire.press_stop(False)
        host.wait(2)
        assert (host.mode(), host.first_fault()) == ("FAULTED", "stop pressed")

    host.wire.press_stop(True)
    host.wait(3)
    assert host.ask("CLEAR", session=host.session()) == "the cause of the fault remains"


def test_what_a_host_of_the_page_says_twice_does_what_the_page_says(host):
    host.greet()
    assert host.ask("CLEAR", session=host.session()) == "done"
    assert host.ask("CLEAR", session=host.session()) == "done"
    first = host.session()
    host.greet()
    assert host.ask("ENABLE", session=first) == "wrong session"
    words = host.ask("ENABLE", session=host.session())
    assert words == "the commands before it were not zero"
    host.drive(NUMBER["zeros"])
    assert host.ask("ENABLE", session=host.session()) == "done"
    assert host.ask("ENABLE", session=host.session()) == "wrong mode"
    assert host.mode() == "RAMP"
    assert host.ask("DISABLE") == host.ask("DISABLE") == "done"
    assert host.mode() == "IDLE"


def test_a_host_of_the_page_stores_a_calibration_and_finds_it_after_a_reset(host):
    host.greet()
    pages = bytearray(host.read_pages())
    offset, fields, _ = PAGE.calibration["serial_number"]
    pages[offset : offset + fields[0].size()] = struct.pack("<I", 4711)
    for page in range(7):
        part = pages[16 * page : 16 * page + 16]
        assert host.ask("WRITE_PAGE", page=page, bytes=part) == "done"
    assert host.ask("STORE", crc=compute_crc(pages) ^ 1) == "bad calibration"
    assert host.ask("STORE", crc=compute_crc(pages)) == ""
    stored = host.seq
    assert host.ask("STORE", crc=compute_crc(pages)) == "busy"

    host.wait(NUMBER["store"])

    answer = host.heard["ANSWER"]
    assert (answer["seq"], answer["result"]) == (stored, PAGE.results["done"])
    host.wire.reset()
    host.wait(5)
    host.greet()
    assert host.read_pages() == pages
    assert host.heard["INFO"]["serial_number"] == 4711
    assert host.heard["INFO"]["calibration_crc"] == compute_crc(pages)


def find_angles(host: Host, calibration: dict[str, Any]) -> list[float]:
    counts = host.heard["STATE"]["position"]
    joints = calibration["joints"]
    rows = {name: [joint[name] for joint in joints] for name in ("zero", "scale")}
    return [PAGE.formula("angle[j]", rows | {"j": j, "position": counts}) for j in range(6)]


def find_tip(calibration: dict[str, Any], angles: list[float]) -> np.ndarray:
    names = dict(zip(("q0", "q1", "q2"), angles, strict=False))
    names |= {f"L{k + 1}": 1e-6 * length for k, length in enumerate(calibration["link"])}
    names |= {name: PAGE.formula(name, names) for name in ("r", "h")}
    return np.array(PAGE.formula("tip", names))


def test_a_host_of_the_page_knows_where_the_stylus_is_and_pushes_it_as_it_means_to():
    core = palpate.NativeCore()
    at = np.array([0.03, -0.15, -0.08])
    core.hold(palpate.HandTarget(position=at, holding=True))
    host = Host(core)
    host.wait(5)
    calibration = PAGE.read_calibration(host.read_pages())
    host.power_up()
    force = np.array([0.3, -0.4, 0.5])

    for _ in range(300):
        angles = find_angles(host, calibration)
        steps = 1e-6 * np.eye(3)
        lean = [find_tip(calibration, list(angles[:3] + step)) for step in steps]
        jacobian = (np.array(lean) - find_tip(calibration, angles)).T / 1e-6
        gravity = [1e-6 * weight for weight in calibration["gravity"]]
        names = {"gravity": gravity, "q1": angles[1], "q2": angles[2]}
        torque = jacobian.T @ force + np.array(PAGE.formula("G", names))
        full = 1e-6 * np.array(calibration["torque"])
        host.drive(1, torque=np.round(NUMBER["torque_full"] * torque / full).astype(int).tolist())

    tip = palpate.find_tip(core.plant(), core.state())
    assert find_tip(calibration, find_angles(host, calibration)) == pytest.approx(tip, abs=7e-4)
    weight = np.linalg.solve(jacobian.T, np.array(PAGE.formula("G", names)))
    assert core.motor_force() - weight == pytest.approx(force, abs=0.03)
    applied = full * host.heard["STATE"]["duty"] / NUMBER["duty_full"]
    assert np.linalg.solve(jacobian.T, applied) - weight == pytest.approx(force, abs=0.03)
