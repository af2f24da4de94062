"""Drawing flags: polygons filled with smooth edges, saved as PNG. Only the standard library is used.

Edges are smoothed by coverage: exact along a line of pixels, by 16 samples across it.
"""

import math
import struct
import zlib

SAMPLES = 16  # lines sampled in each row of pixels


class Picture:
    def __init__(self, width, height, colour):
        self.width, self.height = width, height
        self.rows = [[list(colour) for _ in range(width)] for _ in range(height)]
        self.open = None  # the share of each pixel that is cut out; None: nothing is

    def coverage(self, outlines):
        """Yields (row, shares) of the rows that the area inside the outlines (even-odd, in pixels) touches."""
        edges = []
        for outline in outlines:
            for (x0, y0), (x1, y1) in zip(outline, outline[1:] + outline[:1]):
                if y0 != y1:
                    edges.append((x0, y0, x1, y1) if y0 < y1 else (x1, y1, x0, y0))
        edges.sort(key=lambda edge: edge[1])
        first = max(0, math.floor(min(edge[1] for edge in edges)))
        last = min(self.height - 1, math.ceil(max(edge[3] for edge in edges)))
        for row in range(first, last + 1):
            near = [edge for edge in edges if edge[1] <= row + 1 and edge[3] >= row]
            shares = [0.0] * (self.width + 1)
            touched = False
            for sample in range(SAMPLES):
                y = row + (sample + 0.5) / SAMPLES
                crossings = sorted(x0 + (y - y0) * (x1 - x0) / (y1 - y0)
                                   for x0, y0, x1, y1 in near if y0 <= y < y1)
                for left, right in zip(crossings[::2], crossings[1::2]):
                    left, right = max(left, 0.0), min(right, float(self.width))
                    if left < right:
                        touched = True
                        add_span(shares, left, right, 1.0 / SAMPLES)
            if touched:
                yield row, shares

    def fill(self, colour, *outlines, opacity=1.0):
        """colour: (red, green, blue) or a function of the pixel's column and row that gives one."""
        for row, shares in self.coverage(outlines):
            pixels = self.rows[row]
            for column in range(self.width):
                share = min(1.0, shares[column]) * opacity
                if share == 0.0:
                    continue
                ink = colour(column, row) if callable(colour) else colour
                if share == 1.0:
                    pixels[column] = list(ink)
                else:
                    pixels[column] = [below + (above - below) * share for below, above in zip(pixels[column], ink)]

    def cut(self, *outlines):
        """Leaves no cloth there: the file gets an alpha channel."""
        if self.open is None:
            self.open = [[0.0] * self.width for _ in range(self.height)]
        for row, shares in self.coverage(outlines):
            self.open[row] = [max(before, min(1.0, now)) for before, now in zip(self.open[row], shares)]

    def save(self, path):
        rows, channels = self.rows, 3
        if self.open is not None:
            rows = [[pixel + [255 * (1.0 - open)] for pixel, open in zip(*both)] for both in zip(rows, self.open)]
            channels = 4
        lines = [bytes(min(255, max(0, int(value + 0.5))) for pixel in row for value in pixel) for row in rows]
        # PNG lets each line be stored as it is, as differences from its left or from above: the smallest file wins.
        bodies, above = [bytearray(), bytearray(), bytearray()], bytes(channels * self.width)
        for line in lines:
            for kind, before in enumerate((bytes(len(line)), bytes(channels) + line[:-channels], above)):
                bodies[kind] += bytes([kind]) + bytes((a - b) & 255 for a, b in zip(line, before))
            above = line
        body = min((zlib.compress(bytes(body), 9) for body in bodies), key=len)
        header = struct.pack(">IIBBBBB", self.width, self.height, 8, 2 if channels == 3 else 6, 0, 0, 0)
        with open(path, "wb") as file:
            file.write(b"\x89PNG\r\n\x1a\n")
            for name, data in (b"IHDR", header), (b"sRGB", b"\0"), (b"IDAT", body), (b"IEND", b""):
                file.write(struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)))


def add_span(shares, left, right, weight):
    first, last = int(left), int(right)
    if first == last:
        shares[first] += (right - left) * weight
        return
    shares[first] += (first + 1 - left) * weight
    for column in range(first + 1, last):
        shares[column] += weight
    shares[last] += (right - last) * weight


def rgb(code):
    return tuple(int(code[i:i + 2], 16) for i in (0, 2, 4))


def rectangle(left, top, right, bottom):
    return [(left, top), (right, top), (right, bottom), (left, bottom)]


def disc(x, y, radius, corners=360):
    return [(x + radius * math.cos(2 * math.pi * i / corners), y + radius * math.sin(2 * math.pi * i / corners))
            for i in range(corners)]


def star(x, y, radius, points=5):
    """A regular star with one point upwards; the inner corners lie where the sides of a pentagram cross."""
    inner = radius * math.cos(2 * math.pi / points) / math.cos(math.pi / points)
    return [(x + (radius, inner)[i % 2] * math.sin(math.pi * i / points),
             y - (radius, inner)[i % 2] * math.cos(math.pi * i / points)) for i in range(2 * points)]


def scaled(outline, factor):
    return [(x * factor, y * factor) for x, y in outline]


def flag(width, height, field, *shapes):
    """shapes: (colour, outline...) in units of the height."""
    picture = Picture(width, height, rgb(field))
    for colour, *outlines in shapes:
        picture.fill(rgb(colour), *(scaled(outline, height) for outline in outlines))
    return picture
