"""Rules about the symbols of the core's objects: nothing needed from outside, no mutable state, nothing mergeable.

Usage: symbol_rules.py needs|state|merge BUILD --nm NM --objdump OBJDUMP
"""
import argparse
import re
import sys

import objects
from verdict import output_of, verdict

# What a compiler may call on its own for copies and comparisons; every runtime, however small, has them.
ALLOWED = {"memcpy", "memmove", "memset", "memcmp"}
# Names that the linker itself defines.
LINKER_MADE = {"_GLOBAL_OFFSET_TABLE_"}

REASONS = (
    (r"^_Z(nw|na|dl|da)|^(malloc|calloc|realloc|free|aligned_alloc)$", "heap"),
    (r"^__cxa_guard", "a local static with a guard"),
    (r"^__cxa_|^_Unwind_|^__gxx_personality|^_ZSt9terminate", "exceptions"),
    (r"^_ZTI|^_ZTVN10__cxxabiv1", "run-time type information"),
    (r"^__stack_chk", "stack protector"),
    (r"^__cpu_|^__(div|mod|mul|udiv|umod|float|fix|add|sub|extend|trunc|aarch64_).*", "a helper of the compiler's run-time"),
    (r"^(a?(sin|cos|tan)h?|sincos|atan2|exp2?|expm1|log(2|10|1p)?|pow|sqrt|cbrt|hypot|floor|ceil|trunc|l?l?rint|"
     r"l?l?round|nearbyint|fmod|fma|fmin|fmax|remainder|ldexp|frexp|scalbn|modf|copysign|fabs)[fl]?$", "libm"),
)


def reason_for(name):
    return next((reason for pattern, reason in REASONS if re.search(pattern, name)), "the standard library")


def users_of(objdump, an_object, name):
    """The functions of an object that refer to a symbol."""
    listing = output_of(objdump, "-dr", "--no-show-raw-insn", an_object.path)
    users, current = [], None
    for line in listing.splitlines():
        header = re.match(r"^[0-9a-f]+ <(.*)>:$", line)
        if header:
            current = header.group(1)
        elif re.search(rf"R_\S+\s+{re.escape(name)}(?![\w$])", line) and current not in users:
            users.append(current)
    return users or ["its data"]


def needs_violations(found, nm, objdump):
    """Symbols that no object of the core defines and that are not in ALLOWED: object, function, symbol, reason."""
    tables = [(an_object, objects.symbols_of(nm, an_object.path)) for an_object in found]
    defined = {symbol.name for _, table in tables for symbol in table if not symbol.undefined}
    violations = []
    for an_object, table in tables:
        for symbol in table:
            if symbol.undefined and symbol.name not in defined | ALLOWED | LINKER_MADE:
                users = ", ".join(users_of(objdump, an_object, symbol.name)[:3])
                violations.append(f"{an_object.label}: {users} needs {symbol.name} ({reason_for(symbol.name)})")
    return violations


def state_violations(found, nm, objdump):
    """Objects in writable or thread-local memory, and code that runs before main. Relocated constants are constant."""
    writable = re.compile(r"\s(\.(?:data|bss|tdata|tbss|init_array|ctors|fini_array)(?:\.\S*)?|\*COM\*)\s+([0-9a-f]+)\s+(\S.*)$")
    violations = []
    for an_object in found:
        for line in output_of(objdump, "-t", "-C", an_object.path).splitlines():
            match = writable.search(line)
            if not match or match.group(1).startswith(".data.rel.ro") or int(match.group(2), 16) == 0:
                continue
            violations.append(f"{an_object.label}: {match.group(3)} lives in {match.group(1)}, "
                              f"{int(match.group(2), 16)} bytes: the core keeps no state")
        for line in output_of(objdump, "-h", an_object.path).splitlines():
            words = line.split()
            if len(words) > 2 and words[1].startswith((".init_array", ".ctors", ".fini_array")) and int(words[2], 16):
                violations.append(f"{an_object.label}: has {words[1]}: code that runs before main")
    return violations


def instruction_set(kernel):
    """Kernels in float and in fixed point of one instruction set have the same flags; None is no kernel."""
    return kernel and kernel.removeprefix("fixed_").removesuffix("_general")


def merge_violations(found, nm, objdump):
    """Mergeable symbols that a kernel's object shares with any object built for another instruction set.

    The linker keeps one of the copies. If it keeps the wider one, a smaller CPU meets an instruction that it lacks.
    """
    owners = {}
    for an_object in found:
        for symbol in objects.symbols_of(nm, an_object.path):
            if symbol.kind in objects.WEAK:
                owners.setdefault(symbol.name, []).append(an_object)
    violations = [f"{name}: mergeable, defined in " + " and ".join(owner.label for owner in having)
                  for name, having in sorted(owners.items())
                  if len({instruction_set(owner.kernel) for owner in having}) > 1]
    if len({an_object.kernel for an_object in found} - {None}) == 0:
        violations.append("no object of a kernel found (a target or a source named kernel_<isa>)")
    return violations


RULES = {
    "needs": ("the core needs only " + ", ".join(sorted(ALLOWED)), needs_violations),
    "state": ("the core keeps no state and runs nothing before main", state_violations),
    "merge": ("kernels of different instruction sets share no mergeable symbol", merge_violations),
}


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rule", choices=RULES)
    parser.add_argument("build")
    parser.add_argument("--nm", default="nm")
    parser.add_argument("--objdump", default="objdump")
    given = parser.parse_args(arguments)
    law, rule = RULES[given.rule]
    found = objects.core_objects(given.build)
    members = output_of(given.nm, "--format=posix", objects.core_archive(given.build)).count(".o]:")
    violations = rule(found, given.nm, given.objdump)
    if members != len(found):
        violations.append(f"the archive has {members} members, the build directory {len(found)} objects of the core: "
                          "remove the build directory and build again")
    return verdict(law, violations, f"{len(found)} objects")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
