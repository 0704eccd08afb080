# SPDX-License-Identifier: GPL-3.0-or-later
"""A glTF whose meshes are packed, as a plain one that every reader knows.

Packed by Draco [Khronos KHR_draco_mesh_compression], or of small integers that a node scales back
[Khronos KHR_mesh_quantization]. What places a picture on them [Khronos KHR_texture_transform] is
worked into its places. Skins, morphs and animations stay behind: an organ has none.
"""

from __future__ import annotations

import json
import struct
from pathlib import PurePosixPath
from typing import Any

import numpy as np

from palpate_editor.formats_child.gltf_file import BIN_CHUNK, GLB_MAGIC, JSON_CHUNK, GltfFile
from palpate_editor.formats_child.scene import Refusal

DRACO, QUANTIZED = "KHR_draco_mesh_compression", "KHR_mesh_quantization"
MESHOPT, MOVED, WEBP = "EXT_meshopt_compression", "KHR_texture_transform", "EXT_texture_webp"
TRIANGLES, STRIP, FAN = 4, 5, 6
KEPT = ("asset", "scene", "scenes", "materials", "samplers")
MIME = {".png": "image/png", ".jpg": "image/jpeg", ".jpeg": "image/jpeg", ".webp": "image/webp"}


def unpack_gltf(path: str) -> bytes:
    """The bytes of a .glb. Raises Refusal."""
    file = GltfFile(path)
    used = file.content.get("extensionsRequired", [])
    if isinstance(used, list) and MESHOPT in used:
        raise Refusal("extensionsRequired", MESHOPT, "Draco, or vertices as plain numbers")
    writer = Writer()
    content = {name: file.content[name] for name in KEPT if name in file.content}
    content["nodes"] = [strip_node(node) for node in file.rows("nodes")]
    plain = Plain(file, writer)
    content["meshes"] = [plain.copy_mesh(mesh) for mesh in file.rows("meshes")]
    content["images"] = [copy_image(file, image, writer) for image in file.rows("images")]
    content["textures"] = [copy_texture(texture) for texture in file.rows("textures")]
    content["materials"] = [drop_move(material) for material in file.rows("materials")]
    return writer.finish({name: rows for name, rows in content.items() if rows != []})


def strip_node(node: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in node.items() if key not in ("skin", "weights")}


class Writer:
    """Buffers of a .glb that is written."""

    def __init__(self) -> None:
        self.pieces: list[bytes] = []
        self.views: list[dict[str, int]] = []
        self.accessors: list[dict[str, Any]] = []
        self._size = 0

    def add_bytes(self, content: bytes) -> int:
        """Its bufferView."""
        padded = content + b"\0" * (-len(content) % 4)
        view = {"buffer": 0, "byteOffset": self._size, "byteLength": len(content)}
        self.views.append(view)
        self.pieces.append(padded)
        self._size += len(padded)
        return len(self.views) - 1

    def add_array(self, values: np.ndarray) -> int:
        """Its accessor: of float32, or of uint32 with one in a row."""
        is_index = values.ndim == 1
        kind = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}[1 if is_index else values.shape[1]]
        array = np.ascontiguousarray(values, "<u4" if is_index else "<f4")
        accessor: dict[str, Any] = {
            "bufferView": self.add_bytes(array.tobytes()),
            "componentType": 5125 if is_index else 5126,
            "count": len(array),
            "type": kind,
        }
        if kind == "VEC3" and len(array):
            low, high = array.min(axis=0), array.max(axis=0)
            if not np.isfinite([low, high]).all():
                raise Refusal("POSITION", "numbers that are not finite", "places")
            accessor.update(min=low.tolist(), max=high.tolist())
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def finish(self, content: dict[str, Any]) -> bytes:
        content |= {"bufferViews": self.views, "accessors": self.accessors}
        content["buffers"] = [{"byteLength": self._size}]
        text = json.dumps(content).encode()
        text += b" " * (-len(text) % 4)
        body = b"".join(self.pieces)
        size = 12 + 8 + len(text) + 8 + len(body)
        head = GLB_MAGIC + struct.pack("<4I", 2, size, len(text), JSON_CHUNK)
        return b"".join([head, text, struct.pack("<2I", len(body), BIN_CHUNK), body])


class Plain:
    """Meshes of a file with all numbers as float32."""

    def __init__(self, file: GltfFile, writer: Writer):
        self.file, self.writer = file, writer
        self.written: dict[tuple[object, ...], int] = {}
        """By accessor, and by what moves it: several meshes may have the same."""

    def copy_mesh(self, mesh: dict[str, Any]) -> dict[str, Any]:
        primitives = mesh.get("primitives", [])
        copied = {"primitives": [self.copy_primitive(p) for p in primitives]}
        return copied | ({"name": mesh["name"]} if "name" in mesh else {})

    def copy_primitive(self, primitive: dict[str, Any]) -> dict[str, Any]:
        packed = primitive.get("extensions", {}).get(DRACO)
        made = {key: primitive[key] for key in ("mode", "material") if key in primitive}
        found = self.take_plain(primitive) if packed is None else self.take_draco(packed)
        attributes, indices = found
        check_widths({name: values for name, (_, values) in attributes.items()})
        move = find_move(self.file, primitive)
        made["attributes"] = {
            name: self.write(key, values, move if name == move.name else NO_MOVE)
            for name, (key, values) in attributes.items()
        }
        if indices is not None:
            key, values = indices
            check_indices(values, len(attributes["POSITION"][1]))
            made["indices"] = self.write(key, values.ravel(), NO_MOVE)
        return made

    def write(self, key: object, values: np.ndarray, move: Move) -> int:
        whole = (key, move)
        if whole not in self.written:
            self.written[whole] = self.writer.add_array(move.place(values))
        return self.written[whole]

    def take_plain(self, primitive: dict[str, Any]) -> Taken:
        attributes = {
            name: (("accessor", index), self.file.read_accessor(index))
            for name, index in primitive.get("attributes", {}).items()
            if is_wanted(name)
        }
        index = primitive.get("indices")
        if index is None:
            return attributes, None
        return attributes, (("accessor", index), self.file.read_accessor(index))

    def take_draco(self, packed: dict[str, Any]) -> Taken:
        import DracoPy

        view = packed.get("bufferView")
        content = self.file.read_view(view)[0]
        try:
            mesh = DracoPy.decode(bytes(content))
        except Exception as problem:
            said = " ".join(str(problem).split())[:120]
            raise Refusal(f"bufferView {view}", f"{said}", "a mesh packed by Draco") from None
        by_id = {one["unique_id"]: np.asarray(one["data"]) for one in mesh.attributes}
        attributes = {}
        for name, number in packed.get("attributes", {}).items():
            if not is_wanted(name):
                continue
            if number not in by_id:
                raise Refusal(f"bufferView {view}", f"no {name} ({number})", "what it says it has")
            values = by_id[number]
            values = spread_colours(values) if name.startswith("COLOR_") else values
            attributes[name] = (("draco", view, number), values)
        faces = getattr(mesh, "faces", None)
        if faces is None:
            raise Refusal(f"bufferView {view}", "a cloud of points", "a mesh")
        return attributes, (("draco", view, "faces"), np.asarray(faces))


Taken = tuple[dict[str, tuple[object, np.ndarray]], tuple[object, np.ndarray] | None]
"""Arrays of a primitive, each behind a key that it alone has, and its corners."""


def is_wanted(name: str) -> bool:
    return name == "POSITION" or name.startswith(("TEXCOORD_", "COLOR_"))


def check_widths(attributes: dict[str, np.ndarray]) -> None:
    """Raises Refusal."""
    if "POSITION" not in attributes:
        raise Refusal("primitive", "no POSITION", "places of vertices")
    for name, values in attributes.items():
        wanted = 3 if name == "POSITION" else 2 if name.startswith("TEXCOORD") else (3, 4)
        if values.ndim != 2 or values.shape[1] not in np.atleast_1d(wanted):
            got = f"rows of {values.shape[-1]} numbers"
            raise Refusal(name, got, "rows of " + " or ".join(map(str, np.atleast_1d(wanted))))
        if len(values) != len(attributes["POSITION"]):
            raise Refusal(name, f"{len(values)} rows", f"{len(attributes['POSITION'])}, as places")


def spread_colours(values: np.ndarray) -> np.ndarray:
    """Integers of a colour are parts of 1."""
    return values if values.dtype.kind == "f" else values / np.iinfo(values.dtype).max


def check_indices(indices: np.ndarray, count: int) -> None:
    if indices.size and int(indices.max()) >= count:
        raise Refusal("indices", f"vertex {indices.max()}", f"an index below {count}")


class Move:
    """How a material moves the places of its picture; of none, not at all."""

    def __init__(self, name: str = "", told: dict[str, Any] | None = None):
        told = told or {}
        self.name = name
        self.offset = tuple(map(float, told.get("offset", (0.0, 0.0))))
        self.scale = tuple(map(float, told.get("scale", (1.0, 1.0))))
        self.angle = float(told.get("rotation", 0.0))

    def key(self) -> tuple[object, ...]:
        return self.name, self.offset, self.scale, self.angle

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Move) and self.key() == other.key()

    def __hash__(self) -> int:
        return hash(self.key())

    def place(self, values: np.ndarray) -> np.ndarray:
        if not self.name:
            return values
        c, s = np.cos(self.angle), np.sin(self.angle)
        u, v = (np.asarray(values, float) * self.scale).T
        return np.stack([c * u + s * v, c * v - s * u], axis=1) + self.offset


NO_MOVE = Move()


def find_move(file: GltfFile, primitive: dict[str, Any]) -> Move:
    if "material" not in primitive:
        return NO_MOVE
    material = file.row("materials", primitive["material"])
    picture = material.get("pbrMetallicRoughness", {}).get("baseColorTexture", {})
    told = picture.get("extensions", {}).get(MOVED)
    if told is None:
        return NO_MOVE
    return Move(f"TEXCOORD_{told.get('texCoord', picture.get('texCoord', 0))}", told)


def drop_move(material: dict[str, Any]) -> dict[str, Any]:
    """Without what its places have already."""
    made = json.loads(json.dumps(material))
    picture = made.get("pbrMetallicRoughness", {}).get("baseColorTexture", {})
    told = picture.get("extensions", {}).pop(MOVED, None)
    if told is not None and "texCoord" in told:
        picture["texCoord"] = told["texCoord"]
    return dict(made)


def copy_image(file: GltfFile, image: dict[str, Any], writer: Writer) -> dict[str, Any]:
    """With its bytes inside; a picture that is not there stays a name that nothing is at."""
    if "bufferView" in image:
        content = file.read_view(image["bufferView"])[0]
    else:
        try:
            content = file.read_uri(str(image.get("uri", "")))
        except Refusal:
            return {"uri": str(image.get("uri", ""))[:200]}
    kind = image.get("mimeType") or MIME.get(PurePosixPath(str(image.get("uri"))).suffix.lower())
    return {"bufferView": writer.add_bytes(content), "mimeType": kind or "image/png"}


def copy_texture(texture: dict[str, Any]) -> dict[str, Any]:
    other = texture.get("extensions", {}).get(WEBP, {}).get("source")
    return {"source": other} | texture if other is not None else texture
