"""The call graph of a build with -fcallgraph-info=su: who calls whom, and how much stack each function takes.

The compiler writes one .ci file an object, in the VCG language: nodes with "N bytes (static)" for functions defined
there, without it for functions only declared; a call through a pointer goes to the node __indirect_call.
"""
import re
from pathlib import Path

from objects import core_objects

NODE = re.compile(r'^node: \{ title: "([^"]*)" label: "([^"]*)"')
EDGE = re.compile(r'^edge: \{ sourcename: "([^"]*)" targetname: "([^"]*)"(?: label: "([^"]*)")?')
STACK = re.compile(r"(\d+) bytes \(([\w,]+)\)")
INDIRECT = "__indirect_call"


class Function:
    """A defined function: its stack in bytes, how that is known (static, dynamic, ...), and (callee title, where)."""

    def __init__(self, unit, title, name, stack, kind):
        self.unit, self.title, self.name, self.stack, self.kind = unit, title, name, stack, kind
        self.calls = []

    def __str__(self):
        return f"{self.name} [{self.unit}]"


class CallGraph:
    """All functions below a build directory. A title is looked up in its own unit first, then among all units."""

    def __init__(self, build, folder="core/CMakeFiles"):
        self.by_unit, self.everywhere, self.units = {}, {}, 0
        for path in sorted(Path(build).rglob("*.ci")):
            if folder in str(path):
                self._read(path, str(path).split(folder + "/", 1)[1][:-len(".ci")])
        if not self.units:
            raise SystemExit(f"{build}: holds no .ci file of the core; build it with g++ -fcallgraph-info=su")
        compiled = len(core_objects(build))
        if self.units != compiled:
            raise SystemExit(f"{build}: {compiled} objects of the core, {self.units} .ci files; a compiler cache?")

    def _read(self, path, unit):
        self.units += 1
        for line in path.read_text(errors="replace").splitlines():
            node = NODE.match(line)
            if node and (stack := STACK.search(node.group(2))):
                name = node.group(2).split("\\n")[0]
                function = Function(unit, node.group(1), name, int(stack.group(1)), stack.group(2))
                self.by_unit[unit, function.title] = function
                self.everywhere.setdefault(function.title, []).append(function)
        for line in path.read_text(errors="replace").splitlines():
            edge = EDGE.match(line)
            if edge and (unit, edge.group(1)) in self.by_unit:
                self.by_unit[unit, edge.group(1)].calls.append((edge.group(2), edge.group(3) or "unknown place"))

    def functions(self):
        return list(self.by_unit.values())

    def callees(self, function):
        """The defined functions that a function may reach by one call: of several namesakes, all."""
        reached = []
        for title, _ in function.calls:
            own = self.by_unit.get((function.unit, title))
            reached += [own] if own else self.everywhere.get(title, [])
        return reached

    def outside_calls(self, function):
        """Titles that a function calls and that no unit defines, with the place."""
        return [(title, where) for title, where in function.calls
                if (function.unit, title) not in self.by_unit and title not in self.everywhere]

    def entries(self):
        """Functions that nothing in the graph calls."""
        called = {id(callee) for function in self.functions() for callee in self.callees(function)}
        return [function for function in self.functions() if id(function) not in called]

    def walk(self):
        """(cycles, callees before callers). Iterative depth-first search; a cycle is a list of functions."""
        cycles, order, state = [], [], {}
        for root in self.functions():
            if id(root) in state:
                continue
            state[id(root)] = "open"
            path = [(root, iter(self.callees(root)))]
            while path:
                function, rest = path[-1]
                callee = next(rest, None)
                if callee is None:
                    state[id(function)] = "done"
                    order.append(path.pop()[0])
                elif id(callee) not in state:
                    state[id(callee)] = "open"
                    path.append((callee, iter(self.callees(callee))))
                elif state[id(callee)] == "open":
                    open_now = [step for step, _ in path]
                    cycles.append(open_now[open_now.index(callee):] + [callee])
        return cycles, order
