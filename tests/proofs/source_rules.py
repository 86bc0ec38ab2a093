"""Rules that the source text itself must keep: who may include whom, which standard headers, how long a file is.

Usage: source_rules.py arrows|headers|lanes|length REPOSITORY
"""
import re
import sys

import sources
from verdict import verdict

# Who may include whom:  numeric <- geometry <- shapes, optics <- scene <- render      numeric <- image <- render
#                        image, status <- platform         core, platform <- firmware, tools
# The image sees the numbers because the sRGB curve is a power, and every formula is written once.
CORE = ("core/numeric", "core/geometry", "core/shapes", "core/optics", "core/scene", "core/image", "core/render",
        "core/status.hpp")
ARROWS = {
    "core/status.hpp": (),
    "core/numeric": ("core/status.hpp",),
    "core/geometry": ("core/numeric", "core/status.hpp"),
    "core/shapes": ("core/numeric", "core/geometry", "core/status.hpp"),
    "core/optics": ("core/numeric", "core/geometry", "core/status.hpp"),
    "core/scene": ("core/numeric", "core/geometry", "core/shapes", "core/optics", "core/status.hpp"),
    "core/image": ("core/numeric", "core/status.hpp"),
    "core/render": CORE,
    "platform": ("core/image", "core/status.hpp"),
    "firmware": CORE + ("platform",),
    "tools": CORE + ("platform",),
    "tests": CORE + ("platform", "firmware", "tools"),
}

# Headers that bring no allocation, no locale, no libm and no thread with them.
PLAIN_HEADERS = {"array", "bit", "cfloat", "climits", "compare", "concepts", "cstddef", "cstdint", "cstring",
                 "initializer_list", "limits", "numbers", "span", "type_traits", "utility", "version"}
LANE_HEADERS = re.compile(r"^(xsimd/.*|[a-z0-9]*intrin\.h|arm_neon\.h)$")
CPU_HEADERS = {"cpuid.h"}
MAX_LINES = 300


def layer_of(path):
    """The layer that a path belongs to, or None."""
    return next((layer for layer in ARROWS if path == layer or path.startswith(layer + "/")), None)


def is_project_path(named):
    return named.split("/")[0] in sources.TOP_LEVEL


def arrow_violations(root):
    """Every include that runs against an arrow, is not written from the repository root, or names no file."""
    found = []
    files = sources.files_below(root, sources.TOP_LEVEL, sources.CODE_SUFFIXES)
    for path in files:
        layer = layer_of(str(path))
        if layer is None:
            found.append(f"{path}: belongs to no layer; known layers: {', '.join(ARROWS)}")
            continue
        for line, written, named in sources.includes_of(root, path):
            where = f"{path}:{line}"
            if named is None:
                found.append(f"{where}: #include {written} names its file by a macro; write the file's name")
            elif is_project_path(named):
                target = layer_of(named)
                if not (root / named).is_file():
                    found.append(f"{where}: {named} does not exist")
                elif target != layer and target not in ARROWS[layer]:
                    found.append(f"{where}: {layer} must not see {named}; it may see "
                                 f"{', '.join(ARROWS[layer]) or 'nothing'}")
            elif written.startswith('"'):
                found.append(f"{where}: \"{named}\" is not written from the repository root")
    return found, len(files)


def header_violations(root):
    """Every header of the core from outside the project that is not in the list of plain ones."""
    found = []
    files = sources.files_below(root, ("core",), sources.CODE_SUFFIXES)
    for path in files:
        for line, _, named in sources.includes_of(root, path):
            if named is None or is_project_path(named) or named in PLAIN_HEADERS:
                continue
            if LANE_HEADERS.match(named) and str(path).startswith("core/numeric/"):
                continue
            if named in CPU_HEADERS and str(path).startswith("core/render/"):
                continue
            found.append(f"{path}:{line}: the core must not include <{named}>; allowed: "
                         f"{', '.join(sorted(PLAIN_HEADERS))}; lanes in core/numeric, cpuid.h in core/render")
    return found, len(files)


def lane_violations(root):
    """Every file of the core beyond one in core/numeric that names xsimd outside a comment."""
    files = sources.files_below(root, ("core",), sources.CODE_SUFFIXES)
    users = [path for path in files if re.search(r"xsimd", sources.without_comments(sources.text_of(root, path)))]
    found = [f"{path}: names xsimd; only one file of core/numeric may" for path in users
             if not str(path).startswith("core/numeric/")]
    if len(users) - len(found) > 1:
        found.append("more than one file of core/numeric names xsimd: " + ", ".join(map(str, users)))
    return found, len(files)


def length_violations(root):
    """Every file of code, script or build description that is longer than MAX_LINES."""
    files = sources.files_below(root, sources.TOP_LEVEL, sources.TEXT_SUFFIXES)
    counted = [(path, len(sources.text_of(root, path).splitlines())) for path in files]
    return [f"{path}: {lines} lines, at most {MAX_LINES} are allowed" for path, lines in counted
            if lines > MAX_LINES], len(files)


RULES = {
    "arrows": ("the dependency arrows hold", arrow_violations),
    "headers": ("the core includes only plain standard headers", header_violations),
    "lanes": ("only one file of the core names xsimd", lane_violations),
    "length": (f"no file is above {MAX_LINES} lines", length_violations),
}


def main(arguments):
    if len(arguments) != 2 or arguments[0] not in RULES:
        raise SystemExit(__doc__)
    law, rule = RULES[arguments[0]]
    found, count = rule(sources.Path(arguments[1]))
    if count == 0:
        found.append(f"{arguments[1]}: no source file found; pass the repository's root")
    return verdict(law, found, f"{count} files")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
