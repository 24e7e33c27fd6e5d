#!/usr/bin/env -S /usr/bin/python3
"""Fields of the schemas and operators of the program that the fuzzers' dictionaries and corpora
must contain. words_test.py fails if one is missing.

usage: tests/fuzz/words.py HAZUMI      adds the missing words to the dictionaries"""

import json
import pathlib
import re
import subprocess
import sys

FUZZ = pathlib.Path(__file__).resolve().parent
SCHEMAS = FUZZ.parents[1] / "assets/schema"
# Schemas whose words each dictionary contains.
DICTIONARIES = {"kfa": ["kfa", "figure"], "sweep": ["sweep"], "poses": ["poses"]}
CORPORA = ["kfa", "figure", "sweep", "poses"]  # names of corpora and of their schemas
CURVES = ("keys", "frequency_keys", "strength_keys")


def load(name):
    return json.loads((SCHEMAS / f"{name}.schema.json").read_text())


class Schema:
    """Schema whose fields are tuples: a definition, and the names from that definition to the
    field. The keys of all curves are one definition. An enumerated value is its field and the
    value."""

    def __init__(self, name):
        self.files = {name: load(name), "figure": load("figure")}
        self.name = name

    def resolved(self, schema, owner):
        """Schema behind a reference, and the definition that its fields belong to."""
        while "$ref" in schema:
            file, _, place = schema["$ref"].partition("#")
            if file:  # reference to another schema, which has its own corpus
                return {}, owner
            owner = (place.split("/")[-1],)
            schema = self.files[self.name]
            for part in place.strip("/").split("/"):
                schema = schema[part]
        return schema, owner

    @staticmethod
    def choices(schema):
        """Schema and its alternatives."""
        return [schema, *schema.get("oneOf", []), *schema.get("allOf", [])]

    def fields(self):
        """All fields and enumerated values."""
        found, done = set(), set()

        def walk(schema, owner):
            schema, owner = self.resolved(schema, owner)
            if (id(schema), owner) in done:
                return
            done.add((id(schema), owner))
            found.update(values_of(schema, owner))
            for choice in self.choices(schema)[1:]:
                walk(choice, owner)
            for name, field in schema.get("properties", {}).items():
                found.add(owner + (name,))
                walk(field, ("key",) if name in CURVES else owner + (name,))
            for part in ("items", "additionalProperties"):
                if isinstance(schema.get(part), dict):
                    walk(schema[part], owner)

        walk(self.files[self.name], ())
        return found

    def used(self, document):
        """Fields and enumerated values that a document uses."""
        found = set()

        def walk(schema, value, owner):
            schema, owner = self.resolved(schema, owner)
            found.update(v for v in values_of(schema, owner) if v[-1] == f"={value}")
            for choice in self.choices(schema)[1:]:
                if fits(self.resolved(choice, owner)[0], value):
                    walk(choice, value, owner)
            if isinstance(value, dict):
                fields = schema.get("properties", {})
                for name, part in value.items():
                    if name in fields:
                        found.add(owner + (name,))
                        walk(fields[name], part, ("key",) if name in CURVES else owner + (name,))
                    elif isinstance(schema.get("additionalProperties"), dict):
                        walk(schema["additionalProperties"], part, owner)
            elif isinstance(value, list) and isinstance(schema.get("items"), dict):
                for part in value:
                    walk(schema["items"], part, owner)

        walk(self.files[self.name], document, ())
        return found


def values_of(schema, owner):
    values = schema.get("enum", []) + ([schema["const"]] if "const" in schema else [])
    return {owner + (f"={value}",) for value in values}


def fits(choice, value):
    """Returns whether the names and kinds of a document's value fit this alternative."""
    if not isinstance(value, dict):
        return choice.get("type") in (None, {list: "array", str: "string"}.get(type(value)))
    if choice.get("type") not in (None, "object"):
        return False
    consts = {name: field["const"] for name, field in choice.get("properties", {}).items()
              if "const" in field}
    return all(name in value for name in choice.get("required", [])) and \
        all(value.get(name) == const for name, const in consts.items())


def schema_words(name):
    """Names of fields and enumerated texts as written in a file."""
    words = set()

    def walk(part):
        if isinstance(part, list):
            for each in part:
                walk(each)
        if not isinstance(part, dict):
            return
        words.update(part["properties"] if isinstance(part.get("properties"), dict) else ())
        words.update(v for v in part.get("enum", []) if isinstance(v, str))
        words.update([part["const"]] if isinstance(part.get("const"), str) else ())
        for each in part.values():
            walk(each)

    walk(load(name))
    return words


def operators(hazumi):
    """Parameters by operator. Excludes commands of the window, which are listed from app. on."""
    said = subprocess.run([hazumi, "--operators"], capture_output=True, text=True, check=True).stdout
    return parse_operators(said)


def parse_operators(said):
    found, parameters = {}, None
    for line in said.splitlines():
        if line.startswith("app."):
            break
        if operator := re.match(r"(\w+\.\w+)\b", line):
            parameters = found.setdefault(operator[1], set())
        elif (parameter := re.match(r"    (\w+)[ :]", line)) and parameters is not None:
            parameters.add(parameter[1])
    return found


def operator_words(hazumi):
    known = operators(hazumi)
    return set(known).union(*known.values())


def dictionary(name):
    return FUZZ / f"{name}.dict"


def words_in(name):
    """Quoted texts of a dictionary."""
    path = dictionary(name)
    return set(re.findall(r'^"\\"(.*)\\""$', path.read_text(), re.M)) if path.exists() else set()


def wanted(name, hazumi):
    if name == "script":
        return operator_words(hazumi)
    return set().union(*(schema_words(schema) for schema in DICTIONARIES[name]))


def missing_words(name, hazumi):
    return sorted(wanted(name, hazumi) - words_in(name))


def add_missing(name, hazumi):
    """Adds the missing words in sorted order. Lines that are no quoted words stay at the end."""
    lines = dictionary(name).read_text().splitlines() if dictionary(name).exists() else []
    is_word = re.compile(r'"\\".*\\""$').match
    words = {line for line in lines if is_word(line)}
    words.update(f'"\\"{word}\\""' for word in missing_words(name, hazumi))
    head = [line for line in lines if line.startswith("#")] or [f"# Words of {name} files."]
    tail = [line for line in lines if not line.startswith("#") and not is_word(line)]
    dictionary(name).write_text("\n".join([*head, *sorted(words), *tail]) + "\n")


def documents(corpus):
    """JSON files of a corpus, by name."""
    found = {}
    for path in sorted((FUZZ / "corpus" / corpus).iterdir()):
        try:
            found[path.name] = json.loads(path.read_bytes())
        except ValueError:
            pass
    return found


def unused_fields(corpus):
    schema = Schema(corpus)
    used = set()
    for document in documents(corpus).values():
        used |= schema.used(document)
    return sorted(".".join(field) for field in schema.fields() - used)


def unused_operators(hazumi):
    """Operators and parameters that no script of the corpus has. fuzz_script leaves files alone."""
    used = set()
    for script in documents("script").values():
        for step in script if isinstance(script, list) else []:
            if isinstance(step, dict) and isinstance(step.get("op"), str):
                used.update({(step["op"],), *((step["op"], name) for name in step)})
    tried = {op: names for op, names in operators(hazumi).items() if not op.startswith("file.")}
    known = {(op,) for op in tried} | {(op, name) for op, names in tried.items() for name in names}
    return sorted(" ".join(each) for each in known - used)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for each in (*DICTIONARIES, "script"):
        add_missing(each, sys.argv[1])
