#!/usr/bin/env python3
"""Draws the flags of this folder: python3 assets/flags/draw_flags.py [FOLDER [NAME...]]

Only the standard library is used, and the same pictures come out every time. Every shape is a polygon in units of
the flag's height: x from the hoist, y down from the top. What each flag is drawn by is said beside it, and in
docs/flags.md.
"""

import math
import os
import sys

sys.dont_write_bytecode = True  # the folder is installed as it is

import nations
import signals
from drawing import Picture, disc, flag, rectangle, rgb, star


def france():  # 2:3, the colours in use since 2020
    return flag(1200, 800, "FFFFFF", ("000091", rectangle(0, 0, 0.5, 1)), ("E1000F", rectangle(1, 0, 1.5, 1)))


def italy():  # 2:3
    return flag(1200, 800, "F4F9FF", ("008C45", rectangle(0, 0, 0.5, 1)), ("CD212A", rectangle(1, 0, 1.5, 1)))


def germany():  # 3:5
    third = 1 / 3
    return flag(1200, 720, "DD0000", ("000000", rectangle(0, 0, 2, third)), ("FFCC00", rectangle(0, 2 * third, 2, 1)))


def japan():  # 2:3, the disc's diameter three fifths of the height
    return flag(1200, 800, "FFFFFF", ("BC002D", disc(0.75, 0.5, 0.3)))


def sweden():  # 5:8, divided 5:2:9 along the fly and 4:2:4 along the hoist
    return flag(1200, 750, "006AA7", ("FECC02", rectangle(0.5, 0, 0.7, 1)), ("FECC02", rectangle(0, 0.4, 1.6, 0.6)))


def switzerland():  # 1:1, the cross 20/32 of the side, its arms a sixth longer than wide
    arm, half = 3 / 32, 10 / 32
    return flag(800, 800, "DA291C", ("FFFFFF", rectangle(0.5 - half, 0.5 - arm, 0.5 + half, 0.5 + arm)),
                ("FFFFFF", rectangle(0.5 - arm, 0.5 - half, 0.5 + arm, 0.5 + half)))


def europe():  # 2:3, twelve upright stars of radius 1/18 on a circle of radius 1/3
    stars = [star(0.75 + math.sin(math.pi * hour / 6) / 3, 0.5 - math.cos(math.pi * hour / 6) / 3, 1 / 18)
             for hour in range(12)]
    return flag(1200, 800, "003399", *[("FFCC00", outline) for outline in stars])


def drapeau():
    """The project's own: three ribbons of wind that swell from the hoist, and the lattice of masses they move."""
    width, height = 1020, 680
    dusk, night = rgb("16305F"), rgb("081226")

    def sky(column, row):
        share = row / (height - 1)
        return tuple(a + (b - a) * share for a, b in zip(night, dusk))

    picture = Picture(width, height, night)
    picture.fill(sky, rectangle(0, 0, width, height))

    def sway(x):  # how far the wind has moved the cloth at x, in heights
        return 0.135 * min(1.0, max(0.0, x) / 1.5) ** 1.2 * math.sin(2 * math.pi * x / 1.02 - 0.35)

    def ribbon(middle):
        waves = [(1.5 * i / 240, middle + sway(1.5 * i / 240)) for i in range(241)]
        return ([(x * height, (y - 0.055) * height) for x, y in waves] +
                [(x * height, (y + 0.055) * height) for x, y in reversed(waves)])

    def shaded(code):  # lit where the cloth rises towards the light, darker where it falls
        base = rgb(code)

        def colour(column, row):
            x = column / height
            slope = (sway(x + 0.01) - sway(x - 0.01)) / 0.02
            light = 0.98 - 0.24 * slope
            return tuple(value * min(1.03, max(0.72, light)) for value in base)

        return colour

    picture.fill(shaded("F2B33D"), ribbon(0.335))
    picture.fill(shaded("F7EFE2"), ribbon(0.500))
    picture.fill(shaded("E4572E"), ribbon(0.665))

    # The lattice: springs as fine lines between masses that sway with the ribbons, fading towards the fly.
    spacing, columns, rows = 0.0825, 9, 12

    def mass(i, j):
        x = (i + 0.5) * spacing
        return x * height, (0.5 + (j - (rows - 1) / 2) * spacing + sway(x)) * height

    def strength(i):
        return max(0.0, 1.0 - i / 8.5) ** 1.5

    def line(start, end, thickness):
        (x0, y0), (x1, y1) = start, end
        length = math.hypot(x1 - x0, y1 - y0)
        nx, ny = (y0 - y1) / length * thickness / 2, (x1 - x0) / length * thickness / 2
        return [(x0 + nx, y0 + ny), (x1 + nx, y1 + ny), (x1 - nx, y1 - ny), (x0 - nx, y0 - ny)]

    ink = rgb("CFE3FF")
    for i in range(columns):
        for j in range(rows):
            for di, dj in (1, 0), (0, 1), (1, 1), (1, -1):
                if 0 <= j + dj < rows:
                    thickness = 1.6 if di == 0 or dj == 0 else 0.9
                    picture.fill(ink, line(mass(i, j), mass(i + di, j + dj), thickness),
                                 opacity=0.55 * strength(i + 0.5 * di))
    for i in range(columns):
        for j in range(rows):
            picture.fill(rgb("FFFFFF"), disc(*mass(i, j), 5.5 * (0.35 + 0.65 * strength(i)), 40), opacity=strength(i))
    return picture


# Letters of 5 by 7 squares, for the test pattern.
GLYPHS = {
    "A": "01110 10001 10001 11111 10001 10001 10001", "B": "11110 10001 10001 11110 10001 10001 11110",
    "C": "01110 10001 10000 10000 10000 10001 01110", "D": "11110 10001 10001 10001 10001 10001 11110",
    "E": "11111 10000 10000 11110 10000 10000 11111", "F": "11111 10000 10000 11110 10000 10000 10000",
    "G": "01110 10001 10000 10111 10001 10001 01111", "H": "10001 10001 10001 11111 10001 10001 10001",
    "I": "01110 00100 00100 00100 00100 00100 01110", "L": "10000 10000 10000 10000 10000 10000 11111",
    "M": "10001 11011 10101 10101 10001 10001 10001", "O": "01110 10001 10001 10001 10001 10001 01110",
    "P": "11110 10001 10001 11110 10000 10000 10000", "S": "01111 10000 10000 01110 00001 00001 11110",
    "T": "11111 00100 00100 00100 00100 00100 00100", "Y": "10001 10001 01010 00100 00100 00100 00100",
    "0": "01110 10001 10011 10101 11001 10001 01110", "1": "00100 01100 00100 00100 00100 00100 01110",
    "2": "01110 10001 00001 00110 01000 10000 11111", "3": "01110 10001 00001 00110 00001 10001 01110",
    "4": "00010 00110 01010 10010 11111 00010 00010", "5": "11111 10000 11110 00001 00001 10001 01110",
    "6": "01110 10000 10000 11110 10001 10001 01110", "7": "11111 00001 00010 00100 01000 01000 01000",
    "8": "01110 10001 10001 01110 10001 10001 01110", "9": "01110 10001 10001 01111 00001 00001 01110",
}


def write(picture, text, left, top, square, colour):
    for letter in text:
        for row, line in enumerate(GLYPHS[letter].split()):
            for column, bit in enumerate(line):
                if bit == "1":
                    x, y = left + column * square, top + row * square
                    picture.fill(colour, rectangle(x, y, x + square, y + square))
        left += 6 * square


def test_pattern():
    """Shows which way up, which way round and how finely a texture is drawn. Twelve by eight cells of 100 pixels.

    Cells are named A1 (top, hoist) to H12 (bottom, fly), their hue by column and lightness by row. Every second
    one carries lines, or checks, of 1, 2 and 4 pixels. The corners are red (top, hoist), green (top, fly),
    blue (bottom, hoist) and yellow (bottom, fly).
    """
    cell, columns, rows = 100, 12, 8
    width, height = columns * cell, rows * cell
    black, white = (0, 0, 0), (255, 255, 255)
    picture = Picture(width, height, white)

    def hue(share):
        return tuple(255 * min(1.0, max(0.0, abs((6 * share + shift) % 6 - 3) - 1)) for shift in (0, 4, 2))

    for row in range(rows):
        for column in range(columns):
            left, top = column * cell, row * cell
            mix = 0.30 + 0.45 * row / (rows - 1)
            colour = tuple(255 + (value * 0.85 - 255) * mix for value in hue(column / columns))
            picture.fill(colour, rectangle(left, top, left + cell, top + cell))
            if (row + column) % 2 == 1:
                for band, period in enumerate((1, 2, 4)):
                    for y in range(28):
                        for x in range(80):
                            if (row + column) % 4 == 1:  # upright lines
                                dark = x // period % 2 == 0
                            else:
                                dark = (x // period + y // period) % 2 == 0
                            picture.rows[top + 8 + 29 * band + y][left + 10 + x] = list(black if dark else white)
            else:
                name = "ABCDEFGH"[row] + str(column + 1)
                square = 6 if len(name) < 3 else 5
                write(picture, name, left + (cell - (6 * len(name) - 1) * square) / 2, top + (cell - 7 * square) / 2, square, black)

    # Cells' borders, one pixel on each side of the line, and the flag's own border.
    for column in range(columns + 1):
        x = column * cell
        picture.fill(black, rectangle(x - 1, 0, x + 1, height))
    for row in range(rows + 1):
        y = row * cell
        picture.fill(black, rectangle(0, y - 1, width, y + 1))
    picture.fill((255, 0, 255), rectangle(0, 0, width, height), rectangle(4, 4, width - 4, height - 4))

    for (column, row), colour in {(0, 0): "FF0000", (columns - 1, 0): "00C000", (0, rows - 1): "0000FF",
                                  (columns - 1, rows - 1): "FFD000"}.items():
        left, top = column * cell, row * cell
        picture.fill(rgb(colour), rectangle(left + 4, top + 4, left + cell - 4, top + cell - 4))
        name = "ABCDEFGH"[row] + str(column + 1)
        square = 6 if len(name) < 3 else 5
        write(picture, name, left + (cell - (6 * len(name) - 1) * square) / 2, top + (cell - 7 * square) / 2, square, white)

    # The middle: a circle (is it round?), an arrow up and one towards the fly, and the words that say so.
    middle_x, middle_y = width / 2, height / 2
    picture.fill(white, disc(middle_x, middle_y, 198))
    picture.fill(black, disc(middle_x, middle_y, 198), disc(middle_x, middle_y, 192))
    picture.fill(black, [(middle_x - 9, middle_y + 70), (middle_x - 9, middle_y - 70), (middle_x - 32, middle_y - 70),
                         (middle_x, middle_y - 120), (middle_x + 32, middle_y - 70), (middle_x + 9, middle_y - 70),
                         (middle_x + 9, middle_y + 70)])
    picture.fill(rgb("D00000"), [(middle_x - 70, middle_y - 9), (middle_x + 70, middle_y - 9), (middle_x + 70, middle_y - 32),
                                 (middle_x + 120, middle_y), (middle_x + 70, middle_y + 32), (middle_x + 70, middle_y + 9),
                                 (middle_x - 70, middle_y + 9)])
    write(picture, "TOP", middle_x - 8.5 * 6, middle_y - 172, 6, black)
    write(picture, "BOTTOM", middle_x - 17.5 * 5, middle_y + 130, 5, black)
    write(picture, "FLY", middle_x + 126, middle_y - 10.5, 3, rgb("D00000"))
    write(picture, "HOIST", middle_x - 180, middle_y - 10.5, 3, rgb("D00000"))
    return picture


def uv_grid():
    """Texture coordinates as colours: red grows with u towards the fly, green with v upwards, a line every tenth.

    The lines are numbered in tenths along the upper edge (u) and along the hoist (v).
    """
    width, height = 1200, 800
    white = (255, 255, 255)
    picture = Picture(width, height, white)

    def place(column, row):
        return (int(256 * column / width), int(256 * (height - 1 - row) / height), 96)

    picture.fill(place, rectangle(0, 0, width, height))
    for tenth in range(1, 10):
        half = 2 if tenth == 5 else 1
        x, y = width * tenth / 10, height * tenth / 10
        picture.fill(white, rectangle(x - half, 0, x + half, height))
        picture.fill(white, rectangle(0, y - half, width, y + half))
        write(picture, str(tenth), x + 9, 10, 4, (0, 0, 0))
        write(picture, str(10 - tenth), 10, y - 37, 4, white)
    for radius in 0.1, 0.3:
        picture.fill(white, disc(width / 2, height / 2, radius * height + 1),
                     disc(width / 2, height / 2, radius * height - 1))
    return picture


DRAWN = (france, italy, germany, japan, sweden, switzerland, europe, drapeau, test_pattern, uv_grid,
         *nations.DRAWN, *signals.DRAWN)


if __name__ == "__main__":
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    for draw in DRAWN:
        name = draw.__name__.replace("_", "-")
        if sys.argv[2:] and name not in sys.argv[2:]:
            continue
        path = os.path.join(folder, name + ".png")
        draw().save(path)
        print(path, os.path.getsize(path), "bytes")
