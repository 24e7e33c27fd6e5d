"""Every [METHOD section] cited anywhere exists in engine/METHOD.md, every other bracketed source in
engine/REFERENCES.md, and every source there is cited. Every source file that a README names is there.

usage: citations_test.py"""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ["engine", "render", "ui", "app", "tests", "scripts"]
SUFFIXES = {"", ".h", ".cpp", ".inc", ".py", ".md", ".txt", ".cmake"}
# A name or several, then a place or a year: [Arai 2.4], [Hairer, Wanner 1996, IV.2], [METHOD 2.3].
CITATION = re.compile(r"(?<![\w\])])\[([A-Z][\w-]+(?:, [A-Z][\w-]+)* [(\d][^\[\]]*)\](?!\()")
# A source file in a README: `bake/baker.cpp`. Capitals are to be filled in: `NAME.h`.
FILE_NAME = re.compile(r"`([a-z0-9_./-]+\.(?:h|cpp|py|inc))`")
NEXT_SOURCE = re.compile(r", (?=[A-Z][a-z]{2,}|[A-Z]{3,} )")
LINE_BREAK = re.compile(r"\s*\n\s*(?://|#)?\s*")


def sections(text):
    """Of METHOD.md: {"2", "2.1", ...}."""
    return set(re.findall(r"^##+ (\d+(?:\.\d+)?)", text, re.M))


def keys(text):
    """Of REFERENCES.md, longest first."""
    return sorted(re.findall(r"^- \*\*\[([^\]]+)\]\*\*", text, re.M), key=len, reverse=True)


def is_method_place(place, known):
    ends = [end for part in place.split(", ") for end in part.split("-")]
    return all(end in known for end in ends)


def check(text, known_keys, known_sections):
    """(keys that the text cites, what is wrong with its citations)."""
    cited, wrong = set(), []
    text = LINE_BREAK.sub(" ", text)
    for found in CITATION.finditer(text):
        rest = found[1]
        while rest:
            key = next((k for k in known_keys if re.match(re.escape(k) + r"(?![\w.])", rest)), None)
            if key is None:
                wrong.append(f"[{found[1]}]: no such source in engine/REFERENCES.md")
                break
            cited.add(key)
            place, *more = NEXT_SOURCE.split(rest[len(key):], maxsplit=1)
            if key == "METHOD" and not is_method_place(place.strip(" ,"), known_sections):
                wrong.append(f"[{found[1]}]: no such section in engine/METHOD.md")
            rest = more[0] if more else ""
    for found in re.finditer(r"METHOD[ ,]+\d[\d.]*", CITATION.sub("", text)):
        wrong.append(f"{found[0]}: write [{found[0]}]")
    return cited, wrong


def sources():
    """Text files of the tree."""
    files = [ROOT / "README.md", ROOT / "CHANGELOG.md"]
    for folder in FOLDERS:
        files += [f for f in sorted((ROOT / folder).rglob("*")) if f.is_file()]
    not_asked = {pathlib.Path(__file__).resolve(), ROOT / "engine/REFERENCES.md"}
    return [f for f in files if f.suffix in SUFFIXES and f not in not_asked
            and not {"corpus", "__pycache__"} & set(f.parts)]


def missing_files(text, files):
    """Source files that the text names and that end none of these paths."""
    names = [name.removeprefix("../") for name in FILE_NAME.findall(text)]
    return [name for name in names if not any(("/" + file).endswith("/" + name) for file in files)]


class FilesOfReadmes(unittest.TestCase):
    def test_every_source_file_that_a_readme_names_is_there(self):
        own = pathlib.Path(__file__).resolve()
        files = [str(file.relative_to(ROOT)) for file in [*sources(), own]]
        readmes = [ROOT / file for file in files if file.endswith(".md")]
        named = sum(len(FILE_NAME.findall(file.read_text())) for file in readmes)
        self.assertGreater(named, 100)
        wrong = [f"{file.relative_to(ROOT)}: {name}" for file in readmes
                 for name in missing_files(file.read_text(), files)]
        self.assertEqual(wrong, [])

    def test_a_file_that_is_not_there_is_missing(self):
        files = ["engine/bake/baker.cpp", "engine/base/text.h"]
        self.assertEqual(missing_files("`bake/baker.cpp`, `text.h`, `../base/text.h`, `NAME.h`", files), [])
        self.assertEqual(missing_files("`baker.h`, `dynamics/baker.cpp`", files),
                         ["baker.h", "dynamics/baker.cpp"])


class Citations(unittest.TestCase):
    KEYS = ["Hairer, Wanner 1996", "METHOD", "Arai"]
    SECTIONS = {"2", "2.1", "2.3"}

    def wrong(self, text):
        return check(text, self.KEYS, self.SECTIONS)[1]

    def test_every_citation_of_the_tree_leads_somewhere_and_every_source_is_cited(self):
        known_keys = keys((ROOT / "engine/REFERENCES.md").read_text())
        known_sections = sections((ROOT / "engine/METHOD.md").read_text())
        self.assertGreater(len(known_sections), 20)
        cited, wrong = set(), []
        for file in sources():
            more, faults = check(file.read_text(errors="replace"), known_keys, known_sections)
            wrong += [f"{file.relative_to(ROOT)}: {fault}" for fault in faults]
            cited |= more
        self.assertEqual(wrong, [])
        self.assertEqual(set(known_keys) - cited, set(), "sources that nothing cites")

    def test_what_exists_is_right(self):
        text = ("// [METHOD 2.3] [METHOD 2.1-2.3] [METHOD 2.1, Arai 3] [Arai (3), (4)]\n"
                "// [Hairer, Wanner 1996, IV.2] [Hairer,\n//   Wanner 1996] x[Foo 1] [m s]\n")
        self.assertEqual(check(text, self.KEYS, self.SECTIONS), ({*self.KEYS}, []))

    def test_a_section_that_is_not_there_is_wrong(self):
        for text in ["[METHOD 2.4]", "[METHOD 2.1, 9]", "[METHOD 2.1-2.9]", "[METHOD 2, kicks]",
                     "[Arai 3, METHOD 7]", "[METHOD\n// 2.4]"]:
            self.assertEqual(len(self.wrong(text)), 1, text)

    def test_a_source_that_is_not_there_is_wrong(self):
        for text in ["[Wanner 1996]", "[Hairer, Wanner 1993]", "[Araj 2.4]", "[METHOD 2, Araj 3]",
                     "// [Hairer,\n// Warner 1996]"]:
            self.assertEqual(len(self.wrong(text)), 1, text)

    def test_a_section_without_brackets_is_wrong(self):
        self.assertEqual(self.wrong("the swings of METHOD 2.3"), ["METHOD 2.3: write [METHOD 2.3]"])


if __name__ == "__main__":
    unittest.main()
