"""A tiny build directory of a made-up core, compiled from given sources, for the tests of the proofs."""
import shutil
from pathlib import Path

from verdict import output_of


def fake_build(folder, compiler, sources, flags=()):
    """Compiles {"<target>/<file>.cpp": text} into <folder>/core/CMakeFiles/<target>.dir and an archive of it all."""
    shutil.rmtree(folder, ignore_errors=True)
    built = []
    for name, text in sources.items():
        target, file = name.split("/")
        place = Path(folder) / "core" / "CMakeFiles" / f"{target}.dir"
        place.mkdir(parents=True, exist_ok=True)
        (place / file).write_text(text)
        built.append(place / f"{file}.o")
        output_of(compiler, "-std=c++20", "-O2", "-fno-exceptions", "-ffp-contract=off",
                  *flags, "-c", place / file, "-o", built[-1])
    output_of("ar", "qc", Path(folder) / "core" / "libzerkalo_core.a", *built)
    return folder
