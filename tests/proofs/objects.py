"""Object files of a build of the core, and what binutils tells about them."""
import re
from pathlib import Path

from verdict import output_of

KERNEL = re.compile(r"kernels?_([a-z0-9_.]+?)\.(?:dir|cpp)")
WEAK = set("WVu")


class Object:
    """One object file. `kernel` is the ISA when it is a kernel's object, else None."""

    def __init__(self, path, root):
        self.path = path
        self.label = str(path.relative_to(root)).replace("CMakeFiles/", "")
        match = KERNEL.search(self.label)
        self.kernel = match.group(1) if match else None


class Symbol:
    """One line of nm: `kind` is its letter."""

    def __init__(self, name, kind):
        self.name, self.kind = name, kind
        self.undefined = kind in "Uwv"


def core_objects(build):
    """The objects of the core below a build directory, sorted by label. None found is an error."""
    folders = [path for path in Path(build).absolute().rglob("CMakeFiles") if path.parent.name == "core"]
    found = [Object(path, folder.parent) for folder in folders for path in folder.rglob("*.o")]
    if not found:
        raise SystemExit(f"{build}: holds no object of the core; build the target zerkalo_core there first")
    return sorted(found, key=lambda an_object: an_object.label)


def core_archive(build):
    """The one libzerkalo_core.a below a build directory."""
    found = list(Path(build).rglob("libzerkalo_core.a"))
    if len(found) != 1:
        raise SystemExit(f"{build}: holds {len(found)} files libzerkalo_core.a, expected one")
    return found[0]


def symbols_of(nm, path):
    """All symbols of an object except section and debug ones."""
    lines = output_of(nm, "--format=posix", path).splitlines()
    parsed = [line.split() for line in lines if line and not line.endswith(":")]
    return [Symbol(words[0], words[1]) for words in parsed if words[1] not in "Nn?"]


def demangled(tool, name):
    """The name as a person wrote it; unchanged when it is not a C++ name."""
    return output_of(tool, name).strip()


def functions_of(objdump, path):
    """(function, its instruction lines, relocations included) for each function of an object."""
    listing = output_of(objdump, "-dr", "--no-show-raw-insn", "-C", path)
    header = re.compile(r"^[0-9a-f]+ <(.*)>:$")
    name, lines = None, []
    for line in listing.splitlines():
        match = header.match(line)
        if match:
            if name is not None:
                yield name, lines
            name, lines = match.group(1), []
        elif name is not None and line.strip():
            lines.append(line)
    if name is not None:
        yield name, lines
