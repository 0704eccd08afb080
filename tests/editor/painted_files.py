# SPDX-License-Identifier: GPL-3.0-or-later
"""Balls that are painted with a picture, and pictures."""

from __future__ import annotations

import base64
import json
import struct
import zlib
from pathlib import Path

import numpy as np
from foreign_files import numbers


def write_png(pixels: np.ndarray) -> bytes:
    """[W3C PNG] Of (h, w, 3) uint8, the top row first."""

    def chunk(name: bytes, body: bytes) -> bytes:
        return (
            struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
        )

    height, width = pixels.shape[:2]
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    head = chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0))
    return b"\x89PNG\r\n\x1a\n" + head + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def draw_halves(low: tuple[int, ...], high: tuple[int, ...], size: int = 64) -> np.ndarray:
    """The lower half of one colour, the upper half of another."""
    picture = np.empty((size, size, 3), np.uint8)
    picture[: size // 2], picture[size // 2 :] = high, low
    return picture


def build_ball(count: int = 24, radius: float = 30.0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points [mm], triangles and places on a picture (n, 2), 0 to 1 from its lower left: u around,
    v from the lower to the upper pole. Points on the seam are there twice, as they are in files."""
    u, v = np.meshgrid(np.linspace(0, 1, count + 1), np.linspace(0, 1, count // 2 + 1))
    around, up = 2 * np.pi * u.ravel(), np.pi * (v.ravel() - 0.5)
    around[np.isclose(u.ravel(), 1.0)] = 0.0
    flat = np.where(np.isclose(abs(up), np.pi / 2), 0.0, np.cos(up))
    x = radius * np.stack([flat * np.cos(around), flat * np.sin(around), np.sin(up)], axis=1)
    ids = np.arange(len(x)).reshape(count // 2 + 1, count + 1)
    a, b, c, d = ids[:-1, :-1], ids[:-1, 1:], ids[1:, 1:], ids[1:, :-1]
    triangles = np.concatenate([
        np.stack([a[1:], b[1:], c[1:]], -1).reshape(-1, 3),
        np.stack([a[:-1], c[:-1], d[:-1]], -1).reshape(-1, 3),
    ])  # fmt: skip
    return x, triangles, np.stack([u.ravel(), v.ravel()], axis=1)


def write_painted_obj(path: Path, picture: bytes | None, options: str = "") -> Path:
    x, triangles, places = build_ball()
    lines = ["mtllib skin.mtl", *(f"v {numbers(p)}" for p in x)]
    lines += [f"vt {numbers(p)}" for p in places]
    lines += ["usemtl skin", *(f"f {a}/{a} {b}/{b} {c}/{c}" for a, b, c in triangles + 1)]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    material = f"newmtl skin\nKd 0.8 0.8 0.8\nmap_Kd {options}skin of it.png\n"
    (path.parent / "skin.mtl").write_text(material, encoding="utf-8")
    if picture is not None:
        (path.parent / "skin of it.png").write_bytes(picture)
    return path


def write_chunks(path: Path, content: dict, body: bytes) -> Path:
    """[Khronos glTF 2.0] A .glb of its JSON and its bytes, which are padded to 4."""
    text = json.dumps(content).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(body), b"BIN\0") + body
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
    return path


def write_painted_glb(path: Path, picture: bytes, factor: tuple[float, ...] = (1, 1, 1)) -> Path:
    """With the picture inside; places on it are from the upper left, as glTF has them."""
    x, triangles, places = build_ball()
    metres = 1e-3 * np.stack([x[:, 0], x[:, 2], -x[:, 1]], axis=1)
    places = np.stack([places[:, 0], 1.0 - places[:, 1]], axis=1)
    pieces = [metres.astype("<f4").tobytes(), places.astype("<f4").tobytes(),
              triangles.astype("<u4").tobytes(), picture + b"\0" * (-len(picture) % 4)]  # fmt: skip
    starts = np.cumsum([0, *map(len, pieces)]).tolist()
    sizes = [*map(len, pieces[:3]), len(picture)]
    count = len(x)
    content = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "ball"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1},
                                    "indices": 2, "material": 0}]}],
        "materials": [{"name": "skin", "pbrMetallicRoughness": {
            "baseColorTexture": {"index": 0}, "baseColorFactor": [*factor, 1.0]}}],
        "textures": [{"source": 0}],
        "images": [{"bufferView": 3, "mimeType": "image/png"}],
        "buffers": [{"byteLength": sum(map(len, pieces))}],
        "bufferViews": [{"buffer": 0, "byteOffset": start, "byteLength": size}
                        for start, size in zip(starts, sizes, strict=False)],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3",
             "min": metres.min(axis=0).tolist(), "max": metres.max(axis=0).tolist()},
            {"bufferView": 1, "componentType": 5126, "count": count, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5125, "count": triangles.size, "type": "SCALAR"},
        ],
    }  # fmt: skip
    return write_chunks(path, content, b"".join(pieces))


JPEG = base64.b64decode(
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAgGBgcGBQgHBwcJCQgKDBQNDAsLDBkSEw8UHRofHh0aHBwgJC4nICIsIxwc"
)
"""The beginning of one, which ends too early."""
