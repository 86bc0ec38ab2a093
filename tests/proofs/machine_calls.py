"""Who calls whom, read from the machine code of an object: for compilers that write no call graph (clang).

A call, or a jump to another function, names its target in a relocation or, within one section, directly. Calls through
a register or memory lead to INDIRECT; a jump through a register does too, unless it takes its target from a table of
offsets, as a switch does. x86-64 as objdump prints it.
"""
import re
from pathlib import Path

from verdict import output_of

INDIRECT = "__indirect_call"
SECTION = re.compile(r"^Disassembly of section (\S+):$")
HEADER = re.compile(r"^([0-9a-f]+) <(.*)>:$")
TRANSFER = re.compile(r"\t(?:notrack |bnd )?(call|j[a-z]+) +(\*?)(?:[0-9a-f]+ <([^>+]*)>$)?")
RELOCATION = re.compile(r": R_X86_64_(?:PLT32|PC32|GOTPCRELX|REX_GOTPCRELX)\t(\S+?)([-+]0x[0-9a-f]+)?$")
TABLE_OFFSET = re.compile(r"\tmovslq +\(%\w+,%\w+,4\)")
RETURN_ADDRESS = 8  # which clang does not count and GCC does
NEAR = 6  # instructions between the load from a switch's table and its jump


class Instruction:
    """One line of a function; `symbol` and `addend` are its relocation's, if it has one."""

    def __init__(self, text):
        self.text, self.symbol, self.addend = text, None, 0


def functions_in(listing):
    """[(section, address, name, instructions)] of a listing of objdump -dr."""
    found, section = [], ""
    for line in listing.splitlines():
        if match := SECTION.match(line):
            section = match.group(1)
        elif match := HEADER.match(line):
            found.append((section, int(match.group(1), 16), match.group(2), []))
        elif match := RELOCATION.search(line):
            last = found[-1][3][-1]
            last.symbol, last.addend = match.group(1), int(match.group(2) or "0", 16)
        elif found and line.startswith(" "):
            found[-1][3].append(Instruction(line))
    return found


def targets_of(name, instructions, starts):
    """[(callee, where)] of one function. `starts`: the function at each (section, address)."""
    found = []
    for at, step in enumerate(instructions):
        match = TRANSFER.search(step.text)
        if not match:
            continue
        kind, pointer, direct = match.groups()
        where = f"{name}, {step.text.split(':')[0].strip()}"
        if pointer:
            from_table = any(TABLE_OFFSET.search(before.text) for before in instructions[max(at - NEAR, 0):at])
            if kind == "call" or not from_table:
                found.append((INDIRECT, where))
        elif step.symbol:
            # A relocation counts from the end of its four bytes.
            found.append((starts.get((step.symbol, step.addend + 4), step.symbol), where))
        elif direct and (kind == "call" or direct != name):
            found.append((direct, where))
    return found


def stacks_of(path):
    """{function: (bytes, static or dynamic)} of the file that clang's -fstack-usage writes, the return address added."""
    rows = [line.split("\t") for line in Path(path).read_text().splitlines()]
    return {row[0].rsplit(":", 1)[1]: (int(row[1]) + RETURN_ADDRESS, row[2]) for row in rows}


def calls_of(objdump, an_object, stack_file):
    """[(name, stack, kind, [(callee, where)])] of every function of an object; names as the linker knows them."""
    functions = functions_in(output_of(objdump, "-dr", "--no-show-raw-insn", an_object))
    starts = {(section, address): name for section, address, name, _ in functions}
    stacks = stacks_of(stack_file)
    names = {name for _, _, name, _ in functions}
    if names != stacks.keys():
        one = min(names ^ stacks.keys())
        raise SystemExit(f"{one}: only one of {stack_file} and the listing of {objdump} has it; is that GNU objdump?")
    return [(name, *stacks[name], targets_of(name, instructions, starts)) for _, _, name, instructions in functions]
