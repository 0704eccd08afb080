# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene as a tree: the organ, the tool, the hand and the task, each with its most telling
number; a click goes to the stage where it is made."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QHeaderView, QTreeWidget, QTreeWidgetItem, QWidget

from palpate_editor.document import Organ
from palpate_editor.views.context import Context
from palpate_editor.views.icons import plain_icon
from palpate_editor.views.translations import count, number, quantity, tr

STAGE = Qt.ItemDataRole.UserRole


class SceneTree(QTreeWidget):
    """Shows what the document is made of."""

    def __init__(self, context: Context, parent: QWidget | None = None):
        super().__init__(parent)
        self.context = context
        self.setObjectName("scene_tree")
        self.setColumnCount(2)
        self.setHeaderHidden(True)
        self.setIconSize(QSize(17, 17))
        self.setIndentation(15)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        header = self.header()
        header.setStretchLastSection(True)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        self.setMinimumWidth(230)
        self.itemClicked.connect(self.go)
        self.itemActivated.connect(self.go)
        context.session.changed.connect(self.on_changed)
        context.theme_changed.connect(self.on_theme)
        self.fill()

    def on_changed(self, before: Organ, after: Organ) -> None:
        del before, after
        self.fill()

    def on_theme(self, theme: str) -> None:
        del theme
        self.fill()

    def fill(self) -> None:
        organ = self.context.session.organ
        self.clear()
        top = self.add(None, organ.name or tr("No organ yet"), "", "organ", "import")
        if organ.surface is not None:
            self.fill_organ(top, organ)
        hand = self.add(None, tr("Tool and hand"), "", "tool", "material")
        self.add(hand, tr("Tip"), quantity(1e3 * organ.tool.radius, "mm"), "stop", "material")
        self.add(hand, tr("Hand"), quantity(organ.hand.coupling, "N/m"), "hand", "material")
        task = self.add(None, tr("Scenario"), "", "task", "publish")
        self.add(task, tr("Title"), organ.title or "–", "info", "publish")
        self.expandAll()

    def fill_organ(self, top: QTreeWidgetItem, organ: Organ) -> None:
        assert organ.surface is not None
        if organ.source is not None:
            self.add(top, tr("Source"), organ.source.file, "file", "import")
        if organ.imported is not None and organ.imported is not organ.surface:
            text = count(len(organ.imported.vertices))
            self.add(top, tr("Imported"), text, "mesh", "decimate")
        text = tr("{vertices} vertices").format(vertices=count(organ.vertex_count))
        self.add(top, tr("Surface"), text, "mesh", "decimate")
        kinds = {
            "mass_spring": "MSS",
            "molecular": "MMS",
            "shell": tr("Shell"),
            "solid": "MSS+V",
            "linear_solid": tr("Linear solid"),
            "corotated_solid": tr("Corotated solid"),
            "neo_hookean_solid": tr("Neo-Hookean solid"),
        }
        chosen = (
            organ.model.kind in ("mass_spring", "molecular") and organ.model.constants == "chosen"
        )
        stiffness = (
            quantity(organ.model.stiffness, "N/m")
            if chosen
            else quantity(1e-3 * organ.material.young_modulus, "kPa")
        )
        law = f"{kinds.get(organ.model.kind, '')}, {stiffness}"
        self.add(top, tr("Model"), law, "spring", "material")
        self.add(top, tr("Fixed"), count(int(organ.fixed.sum())), "fix", "material")
        scale = organ.stiffness_scale
        span = f"{number(scale.min(), 3)} – {number(scale.max(), 3)} ×"
        text = span if (scale != 1.0).any() else tr("uniform")
        self.add(top, tr("Stiffness map"), text, "stiffness", "material")

    def add(
        self, above: QTreeWidgetItem | None, name: str, value: str, sign: str, stage: str
    ) -> QTreeWidgetItem:
        item = QTreeWidgetItem([name, value])
        item.setIcon(0, plain_icon(sign, self.context.colours.faint))
        item.setData(0, STAGE, stage)
        item.setToolTip(1, value)
        item.setForeground(1, self.palette().placeholderText())
        if above is None:
            font = item.font(0)
            font.setWeight(font.Weight.DemiBold)
            item.setFont(0, font)
            self.addTopLevelItem(item)
        else:
            above.addChild(item)
        return item

    def go(self, item: QTreeWidgetItem) -> None:
        self.context.show_stage(item.data(0, STAGE))
