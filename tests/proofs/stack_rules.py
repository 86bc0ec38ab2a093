"""Rules about the call graph of the core: no recursion, and a bound on the stack of every entry point.

Usage: stack_rules.py recursion|depth BUILD [--limit BYTES] [--entries kernels|fixed|others] [--objdump FILE]
"""
import argparse
import sys

import objects
from call_graph import INDIRECT, CallGraph
from verdict import verdict

# memcpy, memmove, memset, memcmp: leaves of the C library (or of the firmware), with room to spare.
OUTSIDE_STACK = 256
# Below its stack pointer a leaf may use this much more, which the compiler does not count (x86-64 ABI, 3.2.2).
RED_ZONE = 128
SHOWN = 12


def recursion_violations(graph, _limit, _entries):
    """Every cycle of the call graph; calls through pointers, since nobody knows where they lead."""
    cycles, _ = graph.walk()
    found = ["recursion: " + " -> ".join(map(str, cycle)) for cycle in cycles]
    for function in graph.functions():
        found += [f"{function}: a call through a pointer at {where}"
                  for title, where in graph.outside_calls(function) if title == INDIRECT]
    return found, []


def deepest_paths(graph):
    """{id of function: (bytes, path as a list of functions)}, callees included. The graph must have no cycle."""
    _, order = graph.walk()
    deepest = {}
    for function in order:
        below = max((deepest[id(callee)] for callee in graph.callees(function)), default=(RED_ZONE, []),
                    key=lambda pair: pair[0])
        outside = OUTSIDE_STACK if graph.outside_calls(function) else 0
        path = below[1] if below[0] >= outside else []
        deepest[id(function)] = (function.stack + max(below[0], outside), [function] + path)
    return deepest


def is_kernel(function):
    return objects.KERNEL.search(function.unit) is not None


def kind_of(entry):
    """Which of the three an entry point is."""
    if not is_kernel(entry):
        return "others"
    return "fixed" if "kernel_fixed" in entry.unit else "kernels"


def depth_violations(graph, limit, entries):
    """Every entry point whose deepest path needs more than `limit` bytes, and every stack of unknown size.

    `entries`: "kernels" are what nothing calls in the units of the kernels of floating point, "fixed" in those of fixed
    point, "others" the rest of the core, None is all.
    """
    cycles, _ = graph.walk()
    if cycles:
        return ["recursion: no bound exists: " + " -> ".join(map(str, cycle)) for cycle in cycles], []
    found = [f"{function}: stack of unknown size ({function.kind})" for function in graph.functions()
             if function.kind == "dynamic"]
    deepest = deepest_paths(graph)
    chosen = [entry for entry in graph.entries() if entries in (None, kind_of(entry))]
    if not chosen:
        found.append(f"no entry point among the {entries}")
    ranked = sorted((deepest[id(entry)] for entry in chosen), key=lambda pair: -pair[0])
    for size, path in ranked:
        if size > limit:
            steps = " -> ".join(f"{step.name} ({step.stack})" for step in path)
            found.append(f"{path[0]}: {size} bytes of stack, at most {limit} are allowed: {steps}")
    return found, [f"{size:8} bytes  {path[0]}" for size, path in ranked[:SHOWN]]


RULES = {
    "recursion": ("the core neither recurses nor calls through pointers", recursion_violations),
    "depth": ("every entry point of the core keeps within its stack", depth_violations),
}


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rule", choices=RULES)
    parser.add_argument("build")
    parser.add_argument("--limit", type=int, default=24 * 1024)
    parser.add_argument("--entries", choices=("kernels", "fixed", "others"))
    parser.add_argument("--objdump", default="objdump")
    given = parser.parse_args(arguments)
    graph = CallGraph(given.build, given.objdump)
    law, rule = RULES[given.rule]
    found, table = rule(graph, given.limit, given.entries)
    print("\n".join(table))
    return verdict(law, found, f"{len(graph.functions())} functions of {graph.units} units")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
