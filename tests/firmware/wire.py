# SPDX-License-Identifier: BSD-3-Clause
"""A host of the device written from firmware/protocol/PROTOCOL.md alone: no line of it is ours."""

from __future__ import annotations

import struct
from dataclasses import dataclass, field

HELLO, COMMAND, ENABLE, CLEAR = 0x01, 0x02, 0x03, 0x04
INFO, STATE, ANSWER = 0x81, 0x82, 0x83
IDLE, RAMP, RUN, FAULTED = 1, 2, 3, 4


def compute_crc(data: bytes) -> int:
    """CRC-16/MCRF4XX."""
    crc = 0xFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ 0x8408 if crc & 1 else crc >> 1
    return crc


def encode(body: bytes) -> bytes:
    """COBS(body crc) 0x00."""
    wire = b""
    for block in (body + struct.pack("<H", compute_crc(body))).split(b"\0"):
        wire += bytes([len(block) + 1]) + block
    return wire + b"\0"


def decode(wire: bytes) -> bytes | None:
    """The body of a frame without its delimiter; None for one that is damaged."""
    blocks = []
    while wire:
        code = wire[0]
        if code == 0 or code > len(wire):
            return None
        blocks.append(wire[1:code])
        wire = wire[code:]
    frame = b"\0".join(blocks)
    body = frame[:-2]
    return body if len(frame) > 3 and frame[-2:] == struct.pack("<H", compute_crc(body)) else None


@dataclass
class State:
    """What a STATE says."""

    ack: int
    mode: int
    tick: int
    faults: int
    first_fault: int | None
    position: tuple[int, ...]
    duty: tuple[int, ...]


def read_state(body: bytes) -> State:
    seq, ack, mode, tick, faults, *rest = struct.unpack("<xBBBHH6H3hxx", body)
    assert seq == tick & 0xFF
    first = (faults >> 12) - 1
    return State(ack, mode & 15, tick, faults & 0xFFF, first if first >= 0 else None,
                 tuple(rest[:6]), tuple(rest[6:]))  # fmt: skip


@dataclass
class Host:
    """Says what is needed to get to torque, and hears what comes back."""

    seq: int = 0
    session: int = 0
    damaged: int = 0
    states: list[State] = field(default_factory=list)
    answers: list[tuple[int, int]] = field(default_factory=list)
    rest: bytes = b""

    def next_seq(self) -> int:
        self.seq = (self.seq + 1) & 0xFF
        return self.seq

    def hello(self) -> bytes:
        return encode(struct.pack("<4B", HELLO, self.next_seq(), 1, 77))

    def order(self, kind: int) -> bytes:
        return encode(struct.pack("<BBH", kind, self.next_seq(), self.session))

    def command(self, torque: tuple[int, int, int] = (0, 0, 0)) -> bytes:
        return encode(struct.pack("<BBB3h", COMMAND, self.next_seq(), 0, *torque))

    def law(self, rest: tuple[int, int, int], stiffness: tuple[int, ...], shift: int) -> bytes:
        """No torque but stiffness (rest - position); rest [counts]."""
        head = struct.pack("<BBB3h", COMMAND, self.next_seq(), 1 | shift << 4, 0, 0, 0)
        return encode(head + struct.pack("<3H6h", *(16 * count for count in rest), *stiffness))

    def hear(self, wire: bytes) -> None:
        *frames, self.rest = (self.rest + wire).split(b"\0")
        for frame in frames:
            body = decode(frame)
            if body is None:
                self.damaged += 1
            elif body[0] == STATE:
                self.states.append(read_state(body))
            elif body[0] == ANSWER:
                self.answers.append((body[2], body[3]))
            elif body[0] == INFO:
                self.session = struct.unpack_from("<H", body, 18)[0]


def write_calibration() -> bytes:
    """112 bytes of a device whose joints turn 0.002 rad a count about 512."""
    joint = struct.pack("<HiHH", 512, 2_000_000, 16, 1007)
    rest = struct.pack("<II3i2i3B3BHI", 150_000, 150_000, 470_000, 470_000, 470_000, 28_700,
                       17_700, 0, 0, 0, 127, 127, 127, 105, 4711)  # fmt: skip
    return (bytes([1, 40]) + 6 * joint + rest).ljust(112, b"\0")


def write_eeprom() -> bytes:
    """An EEPROM that holds one copy: mark, sequence, crc of sequence and bytes, bytes."""
    counted = struct.pack("<H", 1) + write_calibration()
    copy = struct.pack("<H", 0x4350) + counted[:2] + struct.pack("<H", compute_crc(counted))
    return (copy + counted[2:]).ljust(1024, b"\xff")
