"""The test machine's root file system: a newc cpio archive (Documentation/driver-api/early-userspace/buffer-format)."""

import os
import stat

REGULAR = stat.S_IFREG
DIRECTORY = stat.S_IFDIR


def padded(data):
    return data + b"\0" * (-len(data) % 4)


def entry(number, name, mode, data=b""):
    """One file: a header of 13 numbers in 8 hexadecimal digits, the name, the data; both end on a multiple of 4."""
    encoded = name.encode() + b"\0"
    fields = [number, mode, 0, 0, 1, 0, len(data), 0, 0, 0, 0, len(encoded), 0]
    header = b"070701" + b"".join(b"%08x" % field for field in fields)
    return padded(header + encoded) + padded(data)


def archive(files):
    """`files` maps a path without a leading slash to (bytes, permissions)."""
    folders = sorted({os.path.dirname(path) for path in files} - {""})
    entries = [(folder, DIRECTORY | 0o755, b"") for folder in folders]
    entries += [(path, REGULAR | mode, data) for path, (data, mode) in files.items()]
    parts = [entry(number, *rest) for number, rest in enumerate(entries, start=1)]
    return b"".join(parts) + entry(0, "TRAILER!!!", 0)


def build(init, program, scene, modules):
    """Bytes of the archive. `modules` are paths in the order of loading."""

    def content(path):
        with open(path, "rb") as file:
            return file.read()

    files = {
        "init": (content(init), 0o755),
        "zerkalo": (content(program), 0o755),
        "scene.toml": (content(scene), 0o644),
    }
    listed = []
    for path in modules:
        name = "modules/" + os.path.basename(path)
        files[name] = (content(path), 0o644)
        listed.append("/" + name + "\n")
    files["modules.list"] = ("".join(listed).encode(), 0o644)
    return archive(files)
