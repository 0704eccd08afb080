# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands in a file of VRML 1 or 2 or Open Inventor, as text: nodes with fields and children
[ISO/IEC 14772-1; Wernecke, "The Inventor Mentor"]."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from palpate_editor.formats_child.packed import unpack
from palpate_editor.formats_child.scene import Refusal

TOKEN = re.compile(r'\s*("(?:\\.|[^"\\])*"|[\[\]{}()|]|[^\s\[\]{}()|,"]+)[\s,]*', re.DOTALL)
NUMBERS = re.compile(r"\[([-+.,\deE\s]*)\]")
REMARK = re.compile(r'"(?:\\.|[^"\\])*"|#[^\n\r]*', re.DOTALL)
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|0[xX][0-9a-fA-F]+")
DEEPEST = 200
"""Nodes within each other; deeper files do not come from people."""
HEADS = ("#VRML V1.0 ascii", "#VRML V2.0 utf8", "#X3D V", "#Inventor V")


@dataclass(eq=False)
class Node:
    type: str
    name: str = ""
    """That DEF gave it."""
    fields: dict[str, Value] = field(default_factory=dict)
    children: list[Node] = field(default_factory=list)
    """Nodes that stand in it without a field, as VRML 1 has them."""


Value = "np.ndarray | Node | list[Node] | str"


def open_vrml(path: str) -> tuple[str, list[Node]]:
    """The first line and the nodes. Raises Refusal."""
    with open(path, "rb") as file:
        content = unpack(file.read())
    text = content.decode("utf-8", errors="replace").lstrip("\ufeff")
    head = text[:80].split("\n")[0].strip()
    if not head.startswith(HEADS):
        shown = "".join(letter if letter.isprintable() else "?" for letter in head[:40])
        raise Refusal("header", f"'{shown}'", "#VRML V1.0 ascii, #VRML V2.0 utf8 or #Inventor V2.1")
    if "binary" in head:
        raise Refusal("header", "Open Inventor as binary", "its text (ivcat writes it)")
    plain = REMARK.sub(lambda mark: mark[0] if mark[0][0] == '"' else "", text)
    return head, Parser(plain).take_file()


class Parser:
    def __init__(self, text: str):
        self.text, self.at = text, 0
        self.named: dict[str, Node] = {}

    def take_file(self) -> list[Node]:
        nodes = []
        while (word := self.peek()) is not None:
            node = self.take_statement(word, 0)
            if node is not None:
                nodes.append(node)
        return nodes

    def peek(self) -> str | None:
        found = TOKEN.match(self.text, self.at)
        return None if found is None else found.group(1)

    def take(self) -> str:
        found = TOKEN.match(self.text, self.at)
        if found is None:
            self.refuse("its end", "the rest of a node")
        assert found is not None
        self.at = found.end()
        return found.group(1)

    def refuse(self, got: str, expected: str) -> None:
        line = self.text.count("\n", 0, self.at) + 1
        raise Refusal(f"line {line}", got, expected)

    def take_statement(self, word: str, depth: int) -> Node | None:
        """A node; None of what is none."""
        if word in ("PROTO", "EXTERNPROTO"):
            self.refuse(f"a {word}", "nodes of VRML itself")
        if word == "ROUTE":
            for _ in range(4):
                self.take()
            return None
        return self.take_node(depth)

    def take_node(self, depth: int) -> Node:
        if depth > DEEPEST:
            self.refuse(f"more than {DEEPEST} nodes within each other", "fewer")
        name, word = "", self.take()
        if word == "USE":
            used = self.take()
            if used not in self.named:
                self.refuse(f"USE {used[:40]}", "a name that DEF gave before")
            return self.named[used]
        if word == "DEF":
            name, word = self.take(), self.take()
        if word == "NULL":
            return Node("NULL")
        if not re.match(r"[A-Za-z_]", word) or self.peek() != "{":
            self.refuse(f"'{word[:40]}'", "a node: its type and {")
        self.take()
        node = Node(word, name)
        if name:
            self.named[name] = node
        self.take_body(node, depth)
        return node

    def take_body(self, node: Node, depth: int) -> None:
        while (word := self.peek()) != "}":
            if word is None:
                self.refuse("its end", f"the end of {node.type}")
            assert word is not None
            before = self.at
            self.take()
            follows = self.peek()
            if word in ("DEF", "USE", "ROUTE", "PROTO", "EXTERNPROTO") or follows == "{":
                self.at = before
                child = self.take_statement(word, depth + 1)
                if child is not None:
                    node.children.append(child)
            else:
                node.fields[word] = self.take_value(depth)
        self.take()

    def take_value(self, depth: int) -> np.ndarray | Node | list[Node] | str:
        numbers = NUMBERS.match(self.text, self.at)
        if numbers is not None:
            self.at = numbers.end()
            return self.parse(numbers.group(1))
        word = self.peek() or ""
        if word == "[":
            return self.take_list(depth)
        if NUMBER.fullmatch(word):
            return self.take_numbers()
        if word in ("DEF", "USE", "NULL"):
            return self.take_node(depth + 1)
        before = self.at
        self.take()
        if self.peek() == "{":
            self.at = before
            return self.take_node(depth + 1)
        if word == "(":
            while self.take() != ")":
                pass
        return word

    def parse(self, text: str) -> np.ndarray:
        words = text.replace(",", " ").split()
        try:
            return np.array(words, float)
        except ValueError:
            wrong = next(word for word in words if not NUMBER.fullmatch(word))
            self.refuse(f"'{wrong[:40]}'", "a number")
            raise

    def take_numbers(self) -> np.ndarray:
        values = []
        while NUMBER.fullmatch(word := self.peek() or ""):
            values.append(float(int(word, 16)) if word[:2].lower() == "0x" else float(word))
            self.take()
        return np.array(values)

    def take_list(self, depth: int) -> list[Node]:
        """The nodes in it; strings and words are passed over."""
        self.take()
        nodes = []
        while (word := self.peek()) != "]":
            if word is None:
                self.refuse("its end", "]")
            assert word is not None
            if word[0] in '"{}[()|' or NUMBER.fullmatch(word) or word in ("TRUE", "FALSE"):
                self.take()
            elif word[0] in "+-.0123456789":
                self.refuse(f"'{word[:40]}'", "a number")
            else:
                node = self.take_statement(word, depth + 1)
                if node is not None:
                    nodes.append(node)
        self.take()
        return nodes
