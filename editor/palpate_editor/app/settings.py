# SPDX-License-Identifier: GPL-3.0-or-later
"""What the editor remembers of its user between two starts."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QByteArray, QSettings, QSize

RECENT = 10
"""Files that are remembered."""
THEMES = ("system", "dark", "light")
LAYOUT_VERSION = 2
"""Of the docks: a layout of another version is not restored, or docks would be lost."""


@dataclass(frozen=True)
class RecentFile:
    """A file that was open."""

    path: Path
    exists: bool
    """Whether it is still there."""


class Settings:
    """A user's choices. Every write is kept at once, so that a crash forgets nothing."""

    def __init__(self, store: QSettings | None = None):
        self.store = store or QSettings(
            QSettings.Format.IniFormat, QSettings.Scope.UserScope, "palpate", "editor"
        )

    def recent_files(self) -> list[RecentFile]:
        """The newest first, those that are gone among them."""
        found = []
        for path in map(Path, self._recent_names()):
            try:
                found.append(RecentFile(path, path.is_file()))
            except (OSError, ValueError):  # a folder that may not be looked into, a name from afar
                found.append(RecentFile(path, False))
        return found

    def add_recent(self, path: Path) -> None:
        """Puts a file on top of the list."""
        name = str(path.absolute())
        names = [name, *(other for other in self._recent_names() if other != name)]
        self._keep("recent", names[:RECENT])

    def forget_recent(self, path: Path) -> None:
        self._keep("recent", [name for name in self._recent_names() if name != str(path)])

    def clear_recent(self) -> None:
        self._keep("recent", [])

    @property
    def theme(self) -> str:
        """One of THEMES."""
        return self._choice("theme", THEMES)

    @theme.setter
    def theme(self, theme: str) -> None:
        if theme not in THEMES:
            raise ValueError(f"theme: got {theme!r}, expected one of {', '.join(THEMES)}")
        self._keep("theme", theme)

    @property
    def language(self) -> str | None:
        """Its two letters, None for that of the system."""
        return str(self.store.value("language", "") or "") or None

    @language.setter
    def language(self, language: str | None) -> None:
        self._keep("language", language or "")

    @property
    def layout(self) -> tuple[QByteArray, QByteArray] | None:
        """Geometry and docks of the window as they were last, None where nothing fits."""
        geometry, docks = self.store.value("window/geometry"), self.store.value("window/docks")
        version = str(self.store.value("window/version", ""))
        if not isinstance(geometry, QByteArray) or not isinstance(docks, QByteArray):
            return None
        return (geometry, docks) if version == str(LAYOUT_VERSION) else None

    @layout.setter
    def layout(self, layout: tuple[QByteArray, QByteArray] | None) -> None:
        self.store.remove("window")
        if layout is not None:
            self.store.setValue("window/version", LAYOUT_VERSION)
            self.store.setValue("window/geometry", layout[0])
            self.store.setValue("window/docks", layout[1])
        self.store.sync()

    @property
    def dock_sizes(self) -> dict[str, QSize]:
        """[px] By name, what each dock of the layout was given last, whatever the screen had room
        for."""
        self.store.beginGroup("window/sizes")
        kept = {name: self.store.value(name) for name in self.store.childKeys()}
        self.store.endGroup()
        return {name: size for name, size in kept.items() if isinstance(size, QSize)}

    @dock_sizes.setter
    def dock_sizes(self, sizes: dict[str, QSize]) -> None:
        self.store.remove("window/sizes")
        for name, size in sizes.items():
            self.store.setValue(f"window/sizes/{name}", size)
        self.store.sync()

    @property
    def last_folder(self) -> Path | None:
        """Where a file was chosen last, while it is there."""
        name = str(self.store.value("folder", "") or "")
        return Path(name) if name and Path(name).is_dir() else None

    @last_folder.setter
    def last_folder(self, folder: Path) -> None:
        self._keep("folder", str(folder.absolute()))

    def choice(self, name: str, allowed: tuple[str, ...]) -> str:
        """A choice of some view, under `views/`; the first allowed where none was made."""
        return self._choice(f"views/{name}", allowed)

    def set_choice(self, name: str, value: str) -> None:
        self._keep(f"views/{name}", value)

    def _choice(self, name: str, allowed: tuple[str, ...]) -> str:
        value = self.store.value(name, allowed[0])
        return value if value in allowed else allowed[0]

    def _recent_names(self) -> list[str]:
        # a list of one comes back from an ini file as text
        names = self.store.value("recent", [])
        names = [names] if isinstance(names, str) else names
        return [name for name in names or [] if isinstance(name, str) and name][:RECENT]

    def _keep(self, name: str, value: object) -> None:
        self.store.setValue(name, value)
        self.store.sync()
