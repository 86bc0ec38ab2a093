"""The call graph of a build: who calls whom, and how much stack each function takes.

With -fcallgraph-info=su GCC writes one .ci file an object, in the VCG language: nodes with "N bytes (static)" for
functions defined there, without it for functions only declared; a call through a pointer goes to the node
__indirect_call. Clang writes the stack alone, by -fstack-usage in an .su file: who calls whom is read from the machine
code (machine_calls.py).
"""
import re

from machine_calls import INDIRECT, calls_of
from objects import core_objects
from verdict import output_of

NODE = re.compile(r'^node: \{ title: "([^"]*)" label: "([^"]*)"')
EDGE = re.compile(r'^edge: \{ sourcename: "([^"]*)" targetname: "([^"]*)"(?: label: "([^"]*)")?')
STACK = re.compile(r"(\d+) bytes \(([\w,]+)\)")


class Function:
    """A defined function: its stack in bytes, how that is known (static, dynamic, ...), and (callee title, where)."""

    def __init__(self, unit, title, name, stack, kind):
        self.unit, self.title, self.name, self.stack, self.kind = unit, title, name, stack, kind
        self.calls = []

    def __str__(self):
        return f"{self.name} [{self.unit}]"


class CallGraph:
    """All functions below a build directory. A title is looked up in its own unit first, then among all units."""

    def __init__(self, build, objdump="objdump"):
        self.by_unit, self.everywhere, self.units = {}, {}, 0
        for an_object in core_objects(build):
            graph, stack = (an_object.path.with_suffix(suffix) for suffix in (".ci", ".su"))
            unit = an_object.label[:-len(".o")]
            if graph.exists():
                self._read_graph(graph, unit)
            elif stack.exists():
                self._read_machine_code(objdump, an_object.path, stack, unit)
            else:
                raise SystemExit(f"{an_object.path}: no .ci or .su file beside it; build with -fstack-usage, by g++ "
                                 "with -fcallgraph-info=su too (a compiler cache keeps no .ci file)")
            self.units += 1

    def _add(self, function):
        self.by_unit[function.unit, function.title] = function
        self.everywhere.setdefault(function.title, []).append(function)

    def _read_graph(self, path, unit):
        lines = path.read_text(errors="replace").splitlines()
        for line in lines:
            node = NODE.match(line)
            if node and (stack := STACK.search(node.group(2))):
                name = node.group(2).split("\\n")[0]
                self._add(Function(unit, node.group(1), name, int(stack.group(1)), stack.group(2)))
        for line in lines:
            edge = EDGE.match(line)
            if edge and (unit, edge.group(1)) in self.by_unit:
                self.by_unit[unit, edge.group(1)].calls.append((edge.group(2), edge.group(3) or "unknown place"))

    def _read_machine_code(self, objdump, path, stack_file, unit):
        functions = calls_of(objdump, path, stack_file)
        names = output_of("c++filt", *[title for title, *_ in functions]).splitlines() if functions else []
        for (title, stack, kind, calls), name in zip(functions, names):
            function = Function(unit, title, name, stack, kind)
            function.calls = calls
            self._add(function)

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
