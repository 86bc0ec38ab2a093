"""The lists of mutants: reading them, and replacing text in a tree of sources."""
import dataclasses
import pathlib


class BadList(Exception):
    """A mutant that cannot be read or applied; the message says which and why."""


@dataclasses.dataclass
class Replacement:
    path: str
    old: str = ""
    new: str = ""


@dataclasses.dataclass
class Mutant:
    name: str
    fault: str
    replacements: list


def add_line(mutants, line):
    """Takes in one line of a list: README.md says what it may be."""
    word, _, rest = line.partition(" ")
    if word == "mutant":
        name, colon, fault = rest.partition(": ")
        if not colon or any(m.name == name for m in mutants):
            raise BadList(f'"{line}": a name of its own, a colon and the fault are wanted')
        mutants.append(Mutant(name, fault, []))
    elif word == "in" and mutants:
        mutants[-1].replacements.append(Replacement(rest))
    elif word in ("-", "+") and mutants and mutants[-1].replacements:
        target = mutants[-1].replacements[-1]
        if word == "-":
            target.old += ("\n" if target.old else "") + rest
        else:
            target.new += ("\n" if target.new else "") + rest
    else:
        raise BadList(f'"{line}": neither mutant, in, - nor +, or out of order')


def read(paths):
    """All mutants of several lists, in order."""
    mutants = []
    for path in paths:
        for line in pathlib.Path(path).read_text(encoding="utf-8").splitlines():
            if line.strip() and not line.startswith("#"):
                add_line(mutants, line)
    for mutant in mutants:
        if not mutant.replacements or not all(r.old for r in mutant.replacements):
            raise BadList(f"{mutant.name}: nothing to replace")
    return mutants


def mutated(text, replacement, name):
    count = text.count(replacement.old)
    if count != 1:
        raise BadList(f"{name}: the text occurs {count} times, not once, in {replacement.path}:\n{replacement.old}")
    if replacement.old == replacement.new:
        raise BadList(f"{name}: replaces a text by itself in {replacement.path}")
    return text.replace(replacement.old, replacement.new)


def mutated_files(root, mutant):
    """The files that the mutant changes, as {path: new text}; a later replacement sees the earlier ones."""
    texts = {}
    for replacement in mutant.replacements:
        path = pathlib.Path(root) / replacement.path
        if not path.is_file():
            raise BadList(f"{mutant.name}: there is no {replacement.path}")
        before = texts.get(replacement.path, path.read_text(encoding="utf-8"))
        texts[replacement.path] = mutated(before, replacement, mutant.name)
    return texts


def check(root, mutants):
    """Raises BadList, with a line or two for every mutant that does not apply."""
    problems = []
    for mutant in mutants:
        try:
            mutated_files(root, mutant)
        except BadList as problem:
            problems.append(str(problem))
    if problems:
        raise BadList("\n".join(problems))
