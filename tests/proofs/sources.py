"""The project's source files and what they include."""
import re
from pathlib import Path

TOP_LEVEL = ("core", "platform", "firmware", "tools", "tests")
CODE_SUFFIXES = (".hpp", ".cpp", ".h", ".c", ".cc", ".inc", ".ipp")
TEXT_SUFFIXES = CODE_SUFFIXES + (".py", ".sh", ".cmake", ".in")

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include\b[ \t]*(.*)$', re.MULTILINE)
NAMED = re.compile(r'["<]([^">]+)[">]')
COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)


def files_below(root, folders, suffixes):
    """Files with one of the suffixes, as paths relative to `root`, sorted."""
    found = []
    for folder in folders:
        for path in (Path(root) / folder).rglob("*"):
            if path.is_file() and (path.suffix in suffixes or path.name == "CMakeLists.txt" and ".cmake" in suffixes):
                found.append(path.relative_to(root))
    return sorted(found)


def text_of(root, path):
    return (Path(root) / path).read_text(encoding="utf-8")


def without_comments(text):
    """The text with comments blanked; line breaks stay, so line numbers hold. Strings are kept."""
    def blank(match):
        token = match.group(0)
        return token if token.startswith('"') else re.sub(r"[^\n]", " ", token)
    return COMMENT_OR_STRING.sub(blank, text)


def includes_of(root, path):
    """(line number, what is written after #include, the named file or None) for each include of a file."""
    text = without_comments(text_of(root, path))
    result = []
    for match in INCLUDE.finditer(text):
        named = NAMED.match(match.group(1).strip())
        line = text.count("\n", 0, match.start()) + 1
        result.append((line, match.group(1).strip(), named.group(1) if named else None))
    return result
