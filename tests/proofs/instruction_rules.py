"""The float contract read from the machine code: no fused, no estimated and no x87 arithmetic anywhere in the core.

A fused multiply-add rounds once where the formula rounds twice, an estimate differs from CPU to CPU, x87 keeps 80 bits,
and the minimum of NEON treats NaN otherwise than that of SSE: each of them would make pictures differ between machines.

Usage: instruction_rules.py BUILD --objdump OBJDUMP
"""
import argparse
import re
import sys

import objects
from verdict import output_of, verdict

FORBIDDEN = {
    "x86-64": (
        (r"vfn?m(add|sub)\w*", "fused multiply-add"),
        (r"v?rcp(ps|ss|14\w*|28\w*|ph|sh)|v?rsqrt(ps|ss|14\w*|28\w*|ph|sh)|vexp2\w+", "estimate"),
        (r"f\w+", "x87"),
    ),
    "aarch64": (
        (r"fn?m(add|sub)|fml[as]\w*|bfml\w*|fcmla", "fused multiply-add"),
        (r"frecp\w+|frsqrt\w+|urecpe|ursqrte", "estimate"),
        (r"f(min|max)(nm)?[pv]?|f(min|max)nm[pv]", "minimum or maximum with NEON's NaN rule"),
    ),
}
MNEMONIC = re.compile(r"^\s*[0-9a-f]+:\s+(?:(?:lock|rep[nz]*|data16|notrack|bnd|\{\w+\}) )*([a-z][\w.]*)")


def architecture_of(objdump, path):
    """"x86-64" or "aarch64"."""
    header = output_of(objdump, "-f", path)
    match = re.search(r"architecture: ([\w:-]+)", header)
    name = match.group(1) if match else "unknown"
    if name.startswith("i386:x86-64"):
        return "x86-64"
    if name.startswith("aarch64"):
        return "aarch64"
    raise SystemExit(f"{path}: no rules for the architecture {name}; known: {', '.join(FORBIDDEN)}")


def instruction_violations(found, objdump):
    """(violations, instructions read). One violation a function and kind, with its first instruction."""
    violations, count = [], 0
    for an_object in found:
        rules = [(re.compile(pattern), what) for pattern, what in FORBIDDEN[architecture_of(objdump, an_object.path)]]
        for function, lines in objects.functions_of(objdump, an_object.path):
            seen = set()
            for line in lines:
                match = MNEMONIC.match(line)
                if not match:
                    continue
                count += 1
                for rule, what in rules:
                    if what not in seen and rule.fullmatch(match.group(1)):
                        seen.add(what)
                        violations.append(f"{an_object.label}: {function}: {what}: {' '.join(line.split()[1:])}")
    return violations, count


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build")
    parser.add_argument("--objdump", default="objdump")
    given = parser.parse_args(arguments)
    found = objects.core_objects(given.build)
    violations, count = instruction_violations(found, given.objdump)
    kernels = sorted({an_object.kernel for an_object in found if an_object.kernel})
    if not kernels:
        violations.append("no object of a kernel found (a target or a source named kernel_<isa>)")
    return verdict("the machine code keeps the float contract", violations,
                   f"{count} instructions, kernels: {', '.join(kernels)}")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
