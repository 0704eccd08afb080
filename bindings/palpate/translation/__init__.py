# SPDX-License-Identifier: BSD-3-Clause
"""Languages of the windows: reads Qt Linguist's .ts files as they are, with no step between.

A package that shows texts keeps translations/<anything>_<language>.ts beside its modules, but for
English, which is what the source says.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterable, Sequence
from importlib.resources import files

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QObject, QTranslator

LANGUAGES = {"en": "English", "tr": "Türkçe"}
"""Code -> what its speakers call it."""
SOURCE = "en"
PACKAGES = ("palpate.translation", "palpate.player", "palpate.device_window", "palpate_editor")

Translations = dict[tuple[str, str], str]
"""(context, source) -> translation."""


class TsTranslator(QTranslator):
    """Says what .ts files say."""

    def __init__(self, translations: Translations, parent: QObject | None = None):
        super().__init__(parent)
        self._translations = translations

    def translate(
        self, context: str, source: str, disambiguation: str | None = None, n: int = -1
    ) -> str | None:
        del disambiguation, n
        return self._translations.get((context, source))

    def isEmpty(self) -> bool:
        return not self._translations


def install(
    app: QCoreApplication, language: str | None = None, packages: Sequence[str] = PACKAGES
) -> str:
    """Shows an application in a language from now on; returns its code.

    Windows are told by LanguageChange. Without a language, that of the system, and English where
    that is not one of ours. What packages are not installed is left out. Raises KeyError for a
    language that is not one of LANGUAGES.
    """
    code = language or find_language(QLocale.system().uiLanguages())
    if code not in LANGUAGES:
        raise KeyError(f"language must be one of {', '.join(LANGUAGES)}, got {code!r}")
    for old in app.findChildren(QTranslator, "palpate"):
        app.removeTranslator(old)
        old.deleteLater()
    for translator in build_translators(app, code, packages):
        translator.setObjectName("palpate")
        app.installTranslator(translator)
    return code


def build_translators(
    app: QCoreApplication, code: str, packages: Sequence[str]
) -> Iterable[QTranslator]:
    """Qt's own translations, where they are installed, and those of the packages."""
    if code == SOURCE:
        return
    of_qt = QTranslator(app)
    folder = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)
    if of_qt.load(f"qtbase_{code}", folder):
        yield of_qt
    translations: Translations = {}
    for package in packages:
        translations |= read_translations(package, code)
    yield TsTranslator(translations, app)


def find_language(wanted: Iterable[str]) -> str:
    """The first of ours among codes such as tr-TR."""
    for name in wanted:
        code = name.replace("_", "-").split("-")[0].lower()
        if code in LANGUAGES:
            return code
    return SOURCE


def read_translations(package: str, code: str) -> Translations:
    """What a package says in a language; nothing where the package is not installed."""
    try:
        folder = files(package) / "translations"
    except ModuleNotFoundError:
        return {}
    translations: Translations = {}
    if folder.is_dir():
        for file in sorted(folder.iterdir(), key=lambda entry: entry.name):
            if file.name.endswith(f"_{code}.ts"):
                translations |= parse_ts(file.read_text(encoding="utf-8"))
    return translations


def parse_ts(text: str) -> Translations:
    """Finished translations of a .ts file [Qt Linguist, TS file format]."""
    translations: Translations = {}
    for context in ET.fromstring(text).iter("context"):
        name = context.findtext("name", "")
        for message in context.iter("message"):
            translation = message.find("translation")
            said = "" if translation is None else (translation.text or "")
            if said and translation is not None and translation.get("type") is None:
                translations[name, message.findtext("source", "")] = said
    return translations
