"""Plain PNG and PFM files, written and read with the standard library alone (ISO/IEC 15948; Debevec's PFM)."""
import struct
import zlib


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write_png(path, rows, depth=8):
    """rows: lists of (r, g, b) codes."""
    code = ">%dB" if depth == 8 else ">%dH"
    body = b""
    for row in rows:
        values = [value for pixel in row for value in pixel]
        body += b"\0" + struct.pack(code % len(values), *values)
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), depth, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(body)) +
                   chunk(b"IEND", b""))


def write_pfm(path, rows):
    """rows: lists of (r, g, b) numbers, top row first."""
    with open(path, "wb") as file:
        file.write(b"PF\n%d %d\n-1.0\n" % (len(rows[0]), len(rows)))
        for row in reversed(rows):
            values = [value for pixel in row for value in pixel]
            file.write(struct.pack("<%df" % len(values), *values))


def paeth(a, b, c):
    p = a + b - c
    return min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]


def unfiltered(filter_type, line, above, step):
    out = bytearray(line)
    for i, value in enumerate(line):
        left = out[i - step] if i >= step else 0
        corner = above[i - step] if i >= step else 0
        guess = (0, left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))[filter_type]
        out[i] = (value + guess) & 255
    return bytes(out)


def read_png(data):
    """bytes -> (width, height, depth, rows of (r, g, b)). RGB without interlace only; checks every CRC."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n", data[:8]
    at, body, kind = 8, b"", b""
    while kind != b"IEND":
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        content = data[at + 8:at + 8 + length]
        assert struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0] == zlib.crc32(kind + content), kind
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlace = struct.unpack(">IIBBBBB", content)
        body += content if kind == b"IDAT" else b""
        at += 12 + length
    assert at == len(data), "bytes after the end"
    assert (color, interlace) == (2, 0), (color, interlace)
    step = 3 * depth // 8
    stride, above, rows, body = width * step, bytes(width * step), [], zlib.decompress(body)
    assert len(body) == height * (stride + 1), len(body)
    for y in range(height):
        line = body[y * (stride + 1):(y + 1) * (stride + 1)]
        above = unfiltered(line[0], line[1:], above, step)
        values = struct.unpack((">%dB" if depth == 8 else ">%dH") % (3 * width), above)
        rows.append([values[i:i + 3] for i in range(0, 3 * width, 3)])
    return width, height, depth, rows


def read_pfm(data):
    """bytes -> (width, height, rows of (r, g, b)), top row first."""
    magic, size, scale, body = data.split(b"\n", 3)
    assert magic == b"PF" and float(scale) < 0, (magic, scale)
    width, height = map(int, size.split())
    assert len(body) == 12 * width * height, len(body)
    values = struct.unpack("<%df" % (3 * width * height), body)
    pixels = [values[i:i + 3] for i in range(0, len(values), 3)]
    return width, height, [pixels[y * width:(y + 1) * width] for y in reversed(range(height))]
