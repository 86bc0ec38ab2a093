"""A stock Debian kernel, unpacked and never installed: the uncompressed vmlinux and the modules of one driver."""

import json
import lzma
import os
import re
import shutil
import struct
import subprocess
import tarfile
import zlib

META_PACKAGE = "linux-image-amd64"


class KernelError(Exception):
    pass


def run(arguments, **options):
    try:
        return subprocess.run(arguments, check=True, capture_output=True, **options).stdout
    except FileNotFoundError:
        raise KernelError(f"{arguments[0]} is not installed: a Debian machine is needed") from None
    except subprocess.CalledProcessError as error:
        raise KernelError(f"{' '.join(arguments)}: {error.stderr.decode(errors='replace').strip()}") from None


def package_name():
    """What the meta package depends on; the name changes with every security update."""
    text = run(["apt-cache", "depends", META_PACKAGE]).decode()
    names = re.findall(r"Depends: (linux-image-\S+)", text)
    if not names:
        raise KernelError(f"apt knows no {META_PACKAGE}: run apt-get update")
    return names[0]


def fetch(cache):
    """The kernel's package, downloaded once. Without a network an older download serves."""
    os.makedirs(cache, exist_ok=True)
    kept = sorted(name for name in os.listdir(cache) if name.endswith(".deb"))
    try:
        name = package_name()
        if not any(deb.startswith(name + "_") for deb in kept):
            download(name, cache)
            kept = sorted(deb for deb in os.listdir(cache) if deb.startswith(name + "_"))
    except KernelError as error:
        if not kept:
            raise KernelError(f"no kernel to boot: {error}") from None
    return os.path.join(cache, kept[-1])


def download(name, cache):
    """Into a folder of its own first: an interrupted download is never taken for a package."""
    part = os.path.join(cache, "part")
    shutil.rmtree(part, ignore_errors=True)
    os.makedirs(part)
    run(["apt-get", "download", "-q", name], cwd=part)
    for deb in os.listdir(part):
        os.replace(os.path.join(part, deb), os.path.join(cache, deb))


def files_of(deb):
    """Every regular file of the package, as (path, open file), in one pass."""
    with subprocess.Popen(["dpkg-deb", "--fsys-tarfile", deb], stdout=subprocess.PIPE) as unpacker:
        with tarfile.open(fileobj=unpacker.stdout, mode="r|") as archive:
            for member in archive:
                if member.isfile():
                    yield member.name, archive.extractfile(member)


def decompressed(data):
    if data[:6] == b"\xfd7zXZ\0":
        return lzma.LZMADecompressor(lzma.FORMAT_XZ).decompress(data)
    if data[:2] == b"\x1f\x8b":
        return zlib.decompressobj(31).decompress(data)
    raise KernelError(f"the kernel is compressed in an unknown way (it begins with {data[:4].hex()})")


def vmlinux_of(bzimage):
    """The payload of a bzImage (Documentation/x86/boot.rst: setup_sects, payload_offset, payload_length). As an ELF
    file it boots directly (PVH), which saves the emulator the decompression: most of the time to the first process."""
    if bzimage[0x202:0x206] != b"HdrS":
        raise KernelError("the kernel is not a bzImage")
    start = (bzimage[0x1F1] + 1) * 512 + struct.unpack_from("<I", bzimage, 0x248)[0]
    length = struct.unpack_from("<I", bzimage, 0x24C)[0]
    vmlinux = decompressed(bzimage[start : start + length])
    if vmlinux[:4] != b"\x7fELF":
        raise KernelError("the kernel's payload is not an ELF file")
    return vmlinux


def module_name(path):
    """drivers/gpu/drm/ttm/ttm.ko -> ttm; the kernel takes - and _ for the same."""
    name = os.path.basename(path)
    return name[: name.index(".ko")].replace("-", "_")


def module_bytes(path, file):
    data = file.read()
    return decompressed(data) if path.endswith((".xz", ".gz")) else data


def depends_of(module):
    """The names in the depends= entry of .modinfo: a NUL before it, a NUL after it."""
    match = re.search(rb"\0depends=([^\0]*)\0", module)
    names = match.group(1).decode() if match else ""
    return [name.replace("-", "_") for name in names.split(",") if name]


def load_order(wanted, depends):
    """Dependencies first, each module once."""
    order = []

    def visit(name):
        if name in order:
            return
        if name not in depends:
            raise KernelError(f"the kernel has no module {name}")
        for needed in depends[name]:
            visit(needed)
        order.append(name)

    visit(wanted)
    return order


def prepare(cache, drivers):
    """(vmlinux's path, {driver: module paths in the order of loading}), unpacked into the cache once."""
    deb = fetch(cache)
    folder = os.path.join(cache, os.path.basename(deb)[: -len(".deb")])
    stamp = os.path.join(folder, "order.json")
    orders = {}
    if os.path.exists(stamp):
        with open(stamp, encoding="utf-8") as file:
            orders = json.load(file)
    if not set(drivers) <= set(orders):
        orders = unpack(deb, drivers, folder)
        # Written last: an interrupted unpacking is done again.
        with open(stamp + ".part", "w", encoding="utf-8") as file:
            json.dump(orders, file)
        os.replace(stamp + ".part", stamp)
    paths = {driver: [os.path.join(folder, name + ".ko") for name in order] for driver, order in orders.items()}
    return os.path.join(folder, "vmlinux"), paths


def unpack(deb, drivers, folder):
    """Two passes over the package: who needs whom, then the few modules that are needed (all would be 300 MB)."""
    os.makedirs(folder, exist_ok=True)
    depends = {}
    for path, file in files_of(deb):
        if ".ko" in os.path.basename(path):
            depends[module_name(path)] = depends_of(module_bytes(path, file))
        elif "/boot/vmlinuz-" in path:
            with open(os.path.join(folder, "vmlinux"), "wb") as vmlinux:
                vmlinux.write(vmlinux_of(file.read()))
    orders = {driver: load_order(driver, depends) for driver in drivers}
    needed = set().union(*orders.values())
    for path, file in files_of(deb):
        if ".ko" in os.path.basename(path) and module_name(path) in needed:
            with open(os.path.join(folder, module_name(path) + ".ko"), "wb") as module:
                module.write(module_bytes(path, file))
    return orders
