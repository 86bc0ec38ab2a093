"""Just enough of PPM and PNG to compare 8-bit RGB pictures byte for byte. A picture is (width, height, bytes)."""

import re
import struct
import zlib


class PictureError(Exception):
    pass


def read_ppm(data):
    """A binary PPM. Rows may be padded: their stride follows from the file's size."""
    header = re.match(rb"P6\s(?:#.*\n)?(\d+)\s(\d+)\s255\s", data)
    if not header:
        raise PictureError("the screen dump is not a PPM file")
    width, height = int(header.group(1)), int(header.group(2))
    rows = data[header.end() :]
    stride = len(rows) // height
    if stride < 3 * width or len(rows) != stride * height:
        raise PictureError(f"the screen dump has {len(rows)} bytes for {width}x{height} pixels")
    return width, height, b"".join(rows[y * stride : y * stride + 3 * width] for y in range(height))


def chunks(data):
    position = 8
    while position < len(data):
        length, kind = struct.unpack_from(">I4s", data, position)
        yield kind, data[position + 8 : position + 8 + length]
        position += 12 + length


def paeth(left, up, corner):
    estimate = left + up - corner
    distances = (abs(estimate - left), abs(estimate - up), abs(estimate - corner))
    return (left, up, corner)[distances.index(min(distances))]


def unfiltered(filter_type, row, above):
    """One row of 3-byte pixels, by ISO/IEC 15948 section 9."""
    row = bytearray(row)
    for i in range(len(row)):
        left = row[i - 3] if i >= 3 else 0
        corner = above[i - 3] if i >= 3 else 0
        guess = (0, left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))[filter_type]
        row[i] = (row[i] + guess) & 255
    return bytes(row)


def read_png(data):
    """An 8-bit RGB PNG without interlace."""
    parts = list(chunks(data))
    width, height, depth, color, _, _, interlace = struct.unpack(">IIBBBBB", dict(parts)[b"IHDR"])
    if (depth, color, interlace) != (8, 2, 0):
        raise PictureError("the expected picture is not an 8-bit RGB PNG")
    raw = zlib.decompress(b"".join(content for kind, content in parts if kind == b"IDAT"))
    stride = 3 * width + 1
    rows, above = [], bytes(3 * width)
    for y in range(height):
        row = raw[y * stride : (y + 1) * stride]
        above = unfiltered(row[0], row[1:], above)
        rows.append(above)
    return width, height, b"".join(rows)


def threshold(x, y):
    """The 8x8 ordered dither's threshold, 0..254: rank of the pixel in Bayer's matrix, built by doubling."""
    matrix = [[0]]
    while len(matrix) < 8:
        upper = [[4 * v for v in row] + [4 * v + 2 for v in row] for row in matrix]
        lower = [[4 * v + 3 for v in row] + [4 * v + 1 for v in row] for row in matrix]
        matrix = upper + lower
    return 255 * (2 * matrix[y % 8][x % 8] + 1) // 128


def on_rgb565(picture):
    """What a 16-bit screen shows: 5 or 6 bits, dithered, widened to 8 by repeating the highest bits."""
    width, height, codes = picture
    tables = {}
    for bits in (5, 6):
        for y in range(8):
            for x in range(8):
                levels = [(code * (2**bits - 1) + threshold(x, y)) // 255 for code in range(256)]
                tables[bits, x, y] = bytes(level << (8 - bits) | level >> (2 * bits - 8) for level in levels)
    shown = bytearray(len(codes))
    for i in range(0, len(codes), 3):
        x, y = i // 3 % width % 8, i // 3 // width % 8
        for channel, bits in enumerate((5, 6, 5)):
            shown[i + channel] = tables[bits, x, y][codes[i + channel]]
    return width, height, bytes(shown)


def difference(actual, expected):
    """None when equal, else one line about the first pixel that differs."""
    if actual[:2] != expected[:2]:
        return f"the screen is {actual[0]}x{actual[1]}, the picture {expected[0]}x{expected[1]}"
    if actual[2] == expected[2]:
        return None
    width = actual[0]
    pixels = range(0, len(actual[2]), 3)
    differing = [i for i in pixels if actual[2][i : i + 3] != expected[2][i : i + 3]]
    first = differing[0]
    x, y = first // 3 % width, first // 3 // width
    return (
        f"{len(differing)} of {len(pixels)} pixels differ; the first at ({x}, {y}): "
        f"{tuple(actual[2][first : first + 3])} on the screen, {tuple(expected[2][first : first + 3])} expected"
    )
