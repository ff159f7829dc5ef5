#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes test-card.png: 8 x 8 colored squares, a white diagonal from bottom left to top right, and the letters A B C D in the
corners (A top left, B top right, C bottom left, D bottom right), so that a mirrored, turned or inverted picture shows.

Usage: make_test_card.py OUT.png
"""
import colorsys
import struct
import sys
import zlib

SIZE = 256
CELL = 32
LETTERS = {
    "A": ["01110", "10001", "10001", "11111", "10001", "10001", "10001"],
    "B": ["11110", "10001", "10001", "11110", "10001", "10001", "11110"],
    "C": ["01110", "10001", "10000", "10000", "10000", "10001", "01110"],
    "D": ["11110", "10001", "10001", "10001", "10001", "10001", "11110"],
}
CORNERS = {"A": (0, 0), "B": (7, 0), "C": (0, 7), "D": (7, 7)}  # cells (column, row), row 0 on top


def letter_at(x, y):
    """True on the ink of a corner letter, False on its paper, None elsewhere."""
    for letter, (column, row) in CORNERS.items():
        if (x // CELL, y // CELL) == (column, row):
            u = (x % CELL - 6) // 4
            v = (y % CELL - 2) // 4
            return 0 <= u < 5 and 0 <= v < 7 and LETTERS[letter][v][u] == "1"
    return None


def pixel(x, y):
    ink = letter_at(x, y)
    if ink is not None:
        return (20, 20, 20) if ink else (255, 255, 255)
    if abs(x + y - (SIZE - 1)) < 5:
        return (255, 255, 255)
    column, row = x // CELL, y // CELL
    hue = (column + 2 * row) % 16 / 16
    value = 1.0 if (column + row) % 2 == 0 else 0.45
    return tuple(round(255 * c) for c in colorsys.hsv_to_rgb(hue, 0.75, value))


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


rows = b"".join(b"\0" + bytes(c for x in range(SIZE) for c in pixel(x, y)) for y in range(SIZE))
header = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 2, 0, 0, 0)
with open(sys.argv[1], "wb") as out:
    out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"sRGB", b"\0"))
    out.write(chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))
