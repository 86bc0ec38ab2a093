"""Scenes of any number of small solids before the gold mirror that together cover the same share of the picture.

figures_scenes.py COUNT [FIRST]    prints one; FIRST 0..4 is the kind that takes the first place.
"""
import math
import sys

KINDS = ("pyramid", "prism", "sphere", "cylinder", "cone")
# Of all solids together, seen from the front.
AREA = 1.6
# Of the upright rectangle over which they are spread, somewhat smaller than the mirror, and its middle.
WIDTH, HEIGHT = 3.6, 1.9
MIDDLE_X, MIDDLE_Y = 0.25, 1.35

FRAME = """version = 1
background = {background}
ambient = {ambient}

[image]
width = 640
height = 480

[camera]
position = [1.2, 2.3, 5.2]
look_at = [0.0, 0.8, -0.6]
horizontal_fov_deg = 42.0
"""

LIGHT = """
[[light]]
position = [-3.0, 4.0, 0.8]
"""

MIRROR = """
[[mirror]]
position = [0.0, 1.25, -1.6]
normal = [0.0, 0.0, 1.0]
boundary = {{ shape = "rectangle", width = 4.0, height = 2.5 }}
{lobe}color = [0.95, 0.80, 0.45]
shininess = 200.0
"""

LOBE = """lobe = "phong"
lobe_exponent = 200.0
"""


def solid(kind, area, x, y):
    """One solid around (x, y) that shows about `area` from the front: as high as it is wide."""
    # The silhouettes for radius 1 and height 2; prism and pyramid have their mean width.
    for_radius_1 = {"pyramid": 4 * math.sqrt(2) / math.pi, "prism": 12 / math.pi, "sphere": math.pi, "cylinder": 4,
                    "cone": 2}
    radius = math.sqrt(area / for_radius_1[kind])
    lines = ["", "[[solid]]", f'kind = "{kind}"', f"radius = {radius:.6f}"]
    if kind == "sphere":
        lines.append(f"position = [{x:.6f}, {y:.6f}, -0.3]")
    else:
        lines += [f"position = [{x:.6f}, {y - radius:.6f}, -0.3]", f"height = {2 * radius:.6f}"]
    if kind in ("pyramid", "prism"):
        lines += [f"sides = {4 if kind == 'pyramid' else 6}", "rotate_deg = [0.0, 20.0, 0.0]"]
    return "\n".join(lines) + "\n"


def solids(count, first):
    columns = math.ceil(math.sqrt(2 * count)) if count > 1 else 1
    rows = math.ceil(count / columns)
    text = ""
    for place in range(count):
        x = ((place % columns + 0.5) / columns - 0.5) * WIDTH + MIDDLE_X
        y = ((place // columns + 0.5) / rows - 0.5) * HEIGHT + MIDDLE_Y
        text += solid(KINDS[(first + place) % len(KINDS)], AREA / count, x, y)
    return text


def scene(count, first=0, sharp=False):
    frame = FRAME.format(background=[0.02, 0.03, 0.12], ambient=[1.0, 1.0, 1.0])
    return frame + LIGHT + solids(count, first) + MIRROR.format(lobe="" if sharp else LOBE)


def silhouettes(count, first=0):
    """The same solids, black before white: what they cover can be counted."""
    return FRAME.format(background=[1.0, 1.0, 1.0], ambient=[0.0, 0.0, 0.0]) + solids(count, first)


if __name__ == "__main__":
    numbers = [int(argument) for argument in sys.argv[1:] if argument.isdecimal()]
    if len(numbers) != len(sys.argv) - 1 or len(numbers) not in (1, 2) or numbers[0] < 1:
        sys.exit("Usage: figures_scenes.py COUNT [FIRST]")
    sys.stdout.write(scene(*numbers))
