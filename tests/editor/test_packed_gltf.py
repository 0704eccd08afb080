# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of a glTF that are packed: by Draco, as small integers, with their bytes beside them."""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from painted_files import build_ball, draw_halves, write_chunks, write_painted_glb, write_png
from palpate import FileError
from palpate_editor import formats
from palpate_editor.authoring import read_mesh
from palpate_editor.check import measure_surface
from palpate_editor.document import EMPTY
from palpate_editor.edits import import_file
from palpate_editor.formats_child.gltf_file import GltfFile
from palpate_editor.formats_child.scene import Refusal
from palpate_editor.formats_child.unpack_gltf import Move, unpack_gltf

RED, BLUE = (200, 30, 40), (40, 60, 190)
PICTURE = write_png(draw_halves(RED, BLUE))
DRACO, QUANTIZED = "KHR_draco_mesh_compression", "KHR_mesh_quantization"


def write_glb(
    path: Path, content: dict[str, Any], pieces: list[bytes], stride: int | None = None
) -> Path:
    """With a bufferView for each piece, the first with rows of so many bytes."""
    padded = [piece + b"\0" * (-len(piece) % 4) for piece in pieces]
    starts = np.cumsum([0, *map(len, padded)]).tolist()
    views = [{"buffer": 0, "byteOffset": a, "byteLength": len(p)}
             for a, p in zip(starts, pieces, strict=False)]  # fmt: skip
    if stride is not None:
        views[0]["byteStride"] = stride
    content = {"bufferViews": views, "buffers": [{"byteLength": starts[-1]}], **content}
    return write_chunks(path, content, b"".join(padded))


def build_scene(primitive: dict[str, Any], extension: str, **more: Any) -> dict[str, Any]:
    node = {"mesh": 0, "name": "ball"} | more.pop("node", {})
    return {
        "asset": {"version": "2.0"},
        "extensionsUsed": [extension],
        "extensionsRequired": [extension],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [node],
        "meshes": [{"primitives": [primitive]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}],
        **more,
    }


def build_metres() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The ball as write_painted_glb() has it."""
    x, triangles, places = build_ball()
    metres = 1e-3 * np.stack([x[:, 0], x[:, 2], -x[:, 1]], axis=1)
    return metres, triangles, np.stack([places[:, 0], 1.0 - places[:, 1]], axis=1)


def write_draco(path: Path, spoil: Any = bytes, given: dict[str, int] | None = None) -> Path:
    DracoPy = pytest.importorskip("DracoPy")  # noqa: N806  # its name
    metres, triangles, places = build_metres()
    packed = DracoPy.encode(metres.astype(np.float32), triangles.astype(np.uint32),
                            tex_coord=places, quantization_bits=16)  # fmt: skip
    number = {one["name"] or one["data"].shape[1]: one["unique_id"]
              for one in DracoPy.decode(packed).attributes}  # fmt: skip
    numbers = {"POSITION": number[3], "TEXCOORD_0": number[2]} | (given or {})
    there = {"bufferView": 0, "attributes": numbers}
    primitive = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0,
                 "extensions": {DRACO: there}}  # fmt: skip
    count = len(metres)
    accessors = [
        {"componentType": 5126, "count": count, "type": "VEC3"},
        {"componentType": 5126, "count": count, "type": "VEC2"},
        {"componentType": 5125, "count": triangles.size, "type": "SCALAR"},
    ]
    images = [{"bufferView": 1, "mimeType": "image/png"}]
    content = build_scene(primitive, DRACO, accessors=accessors, images=images)
    return write_glb(path, content, [spoil(packed), PICTURE])


def write_quantized(path: Path) -> Path:
    """Places as 16 bits that a node scales back, those on the picture as parts of 1 that its
    material moves: half of them, and back to the whole."""
    metres, triangles, places = build_metres()
    scale = 0.031
    small = np.round(metres / scale * 32767).astype("<i2")
    rows = np.zeros((len(small), 4), "<i2")  # rows of 8 bytes, as vertices are to be aligned
    rows[:, :3] = small
    halves = np.round(0.5 * places * 65535).astype("<u2")
    primitive = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}
    accessors = [
        {"bufferView": 0, "componentType": 5122, "normalized": True, "count": len(small),
         "type": "VEC3"},
        {"bufferView": 1, "componentType": 5123, "normalized": True, "count": len(small),
         "type": "VEC2"},
        {"bufferView": 2, "componentType": 5123, "count": triangles.size, "type": "SCALAR"},
    ]  # fmt: skip
    moved = {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [2.0, 2.0]}}}
    content = build_scene(
        primitive, QUANTIZED, accessors=accessors, node={"scale": [scale] * 3},
        materials=[{"pbrMetallicRoughness": {"baseColorTexture": moved}}],
        images=[{"bufferView": 3, "mimeType": "image/png"}],
    )  # fmt: skip
    pieces = [rows.tobytes(), halves.tobytes(), triangles.astype("<u2").tobytes(), PICTURE]
    return write_glb(path, content, pieces, stride=8)


WRITERS = {"draco": write_draco, "quantized": write_quantized}


@pytest.mark.parametrize("kind", WRITERS)
def test_a_packed_ball_is_the_plain_one_with_its_picture(kind, tmp_path):
    plain = import_file(write_painted_glb(tmp_path / "plain.glb", PICTURE))(EMPTY).surface
    organ = import_file(WRITERS[kind](tmp_path / "packed.glb"))(EMPTY)

    surface = organ.surface
    assert surface.vertices.shape == plain.vertices.shape
    assert len(surface.triangles) == len(plain.triangles)
    away = np.linalg.norm(surface.vertices[:, None] - plain.vertices[None], axis=2).min(axis=1)
    assert away.max() < 3e-6  # of 16 bits
    height = surface.vertices[:, 2]
    assert (surface.colours[height < -2e-3] == RED).all()
    assert (surface.colours[height > 2e-3] == BLUE).all()
    assert measure_surface(surface)[1].is_manifold


def test_its_bytes_may_lie_beside_it_and_nowhere_else(tmp_path):
    glb = write_quantized(tmp_path / "a.glb").read_bytes()
    size = struct.unpack_from("<I", glb, 12)[0]
    text = json.loads(glb[20 : 20 + size])
    (tmp_path / "a b.bin").write_bytes(glb[28 + size :])
    text["buffers"][0]["uri"] = "a%20b.bin"
    path = tmp_path / "a.gltf"
    path.write_text(json.dumps(text), encoding="utf-8")

    assert len(read_mesh(path).parts) == 1

    text["buffers"][0]["uri"] = "../b.bin"
    (tmp_path.parent / "b.bin").write_bytes(glb[28 + size :])
    path.write_text(json.dumps(text), encoding="utf-8")
    with pytest.raises(FileError, match="a file beside it") as refused:
        read_mesh(path)
    assert refused.value.got == "../b.bin"
    (tmp_path.parent / "b.bin").unlink()


def test_rows_that_are_told_one_by_one_take_their_place(tmp_path):
    rows, at = np.arange(6, dtype="<f4"), np.array([1], "<u4")
    content = {
        "asset": {"version": "2.0"},
        "accessors": [{
            "bufferView": 0, "componentType": 5126, "count": 2, "type": "VEC3",
            "sparse": {"count": 1, "indices": {"bufferView": 1, "componentType": 5125},
                       "values": {"bufferView": 2}}}],
    }  # fmt: skip
    new = np.array([7, 8, 9], "<f4")
    pieces = [rows.tobytes(), at.tobytes(), new.tobytes()]

    file = GltfFile(str(write_glb(tmp_path / "a.glb", content, pieces)))

    assert file.read_accessor(0).tolist() == [[0, 1, 2], [7, 8, 9]]


def test_a_picture_is_moved_as_the_extension_says():
    """[KHR_texture_transform] Scaled, turned against the clock where v points down, shifted."""
    move = Move("TEXCOORD_0", {"offset": [0.1, 0.2], "scale": [2.0, 1.0], "rotation": np.pi / 2})

    moved = move.place(np.array([[1.0, 0.0], [0.0, 1.0]]))

    assert moved == pytest.approx(np.array([[0.1, -1.8], [1.1, 0.2]]))


@pytest.mark.parametrize("kind", WRITERS)
def test_one_that_ends_too_early_is_refused_with_its_own_name(kind, tmp_path):
    path = WRITERS[kind](tmp_path / "a.glb")
    path.write_bytes(path.read_bytes()[:-4000])

    with pytest.raises(FileError) as refused:
        read_mesh(path)

    assert refused.value.file == str(path)
    assert "chunk" in refused.value.got


def test_draco_that_is_spoiled_is_refused(tmp_path):
    path = write_draco(tmp_path / "a.glb", lambda packed: packed[: len(packed) // 2])

    with pytest.raises(FileError, match="a mesh packed by Draco") as refused:
        read_mesh(path)
    assert refused.value.where == "bufferView 0"


def test_numbers_that_are_no_places_are_refused(tmp_path):
    path = write_draco(tmp_path / "a.glb", given={"POSITION": 0, "TEXCOORD_0": 1})

    with pytest.raises(FileError, match="rows of 3") as refused:
        read_mesh(path)
    assert refused.value.where == "POSITION"


def test_spoiled_bytes_are_read_or_refused(tmp_path):
    path, random = write_draco(tmp_path / "a.glb"), np.random.default_rng(0)
    whole = path.read_bytes()
    for _ in range(6):
        spoiled = bytearray(whole)
        for at in random.integers(20, len(spoiled), 12):
            spoiled[at] = random.integers(0, 256)
        path.write_bytes(bytes(spoiled))
        try:
            read_mesh(path)
        except FileError as refusal:
            assert refusal.expected


def test_what_unpacks_it_is_named_where_it_is_missing(tmp_path, monkeypatch):
    path = write_draco(tmp_path / "a.glb")
    real = formats.find_spec
    monkeypatch.setattr(formats, "find_spec", lambda n: None if n == "DracoPy" else real(n))

    with pytest.raises(FileError, match=r"pip install palpate-editor\[formats\]"):
        read_mesh(path)


def test_meshopt_is_refused_with_the_way_out(tmp_path):
    path = write_quantized(tmp_path / "a.glb")
    head = GltfFile(str(path)).content
    head["extensionsRequired"] = [QUANTIZED, "EXT_meshopt_compression"]
    (tmp_path / "b.gltf").write_text(json.dumps(head), encoding="utf-8")

    with pytest.raises(Refusal, match="EXT_meshopt_compression"):
        unpack_gltf(str(tmp_path / "b.gltf"))
