#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes srgb_basis_5nm.csv: three smooth spectra r, g, b >= 0 with r + g + b = 1 that turn a linear sRGB color into an
emission spectrum under D65, E = (R r + G g + B b) D65 (Mallett and Yuksel 2019, "Spectral primary decomposition").

They minimise the sum of squared steps between neighboring nodes, and give back the color exactly with the weights of
spectrum/color.h on two wavelength lists: 380:780:1 (the reference) and 380:780:20 (the color mode of the renderer).
Quadratic program, solved by a primal-dual interior point method (Nocedal and Wright, Numerical Optimization, 16.6).

    python3 make_rgb_basis.py > srgb_basis_5nm.csv        (about a second; needs nothing but Python)
"""
import csv
import os
import sys

FIRST, LAST, STEP = 380, 780, 5
NODES = list(range(FIRST, LAST + 1, STEP))
N = len(NODES)
HERE = os.path.dirname(os.path.abspath(__file__))


def table(name):
    with open(os.path.join(HERE, name)) as file:
        return [[float(x) for x in row] for row in list(csv.reader(file))[1:]]


OBSERVER = {int(row[0]): row[1:] for row in table("cie_1931_2deg_xyz_1nm.csv")}
D65 = {int(row[0]): row[1] for row in table("cie_d65_5nm.csv")}


def d65(nm):
    low = nm - nm % 5
    return D65[nm] if low == nm else D65[low] + (D65[low + 5] - D65[low]) * (nm - low) / 5


def solve(matrix, right):
    """Gauss with partial pivoting, several right sides (rows of `right` are rows of the system)."""
    n = len(matrix)
    a = [row[:] + extra[:] for row, extra in zip(matrix, right)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(a[r][i]))
        a[i], a[pivot] = a[pivot], a[i]
        for r in range(i + 1, n):
            if a[r][i] != 0.0:
                f = a[r][i] / a[i][i]
                row, top = a[r], a[i]
                for c in range(i, len(row)):
                    if top[c] != 0.0:
                        row[c] -= f * top[c]
    for i in reversed(range(n)):
        for c in range(n, len(a[i])):
            a[i][c] = (a[i][c] - sum(a[i][k] * a[k][c] for k in range(i + 1, n))) / a[i][i]
    return [row[n:] for row in a]


def srgb_to_xyz():
    """From the chromaticities of IEC 61966-2-1; columns are the primaries."""
    xy = [(0.64, 0.33), (0.30, 0.60), (0.15, 0.06)]
    columns = [[x / y, 1.0, (1.0 - x - y) / y] for x, y in xy]
    matrix = [[columns[c][r] for c in range(3)] for r in range(3)]
    white = [[0.3127 / 0.3290], [1.0], [(1.0 - 0.3127 - 0.3290) / 0.3290]]
    scale = solve(matrix, white)
    return [[matrix[r][c] * scale[c][0] for c in range(3)] for r in range(3)]


def channel_weights(step):
    """Share of each node in X, Y, Z of D65 times a spectrum that is linear between the nodes; rows sum to 1."""
    rows = []
    for channel in range(3):
        row = [0.0] * N
        for nm in range(FIRST, LAST + 1, step):
            w = OBSERVER[nm][channel] * d65(nm) * (0.5 if nm in (FIRST, LAST) else 1.0)
            node, rest = divmod(nm - FIRST, STEP)
            row[node] += w * (1.0 - rest / STEP)
            if rest:
                row[node + 1] += w * rest / STEP
        total = sum(row)
        rows.append([w / total for w in row])
    return rows


def program():
    """Unknowns r_i at 2i, g_i at 2i + 1: objective u'Qu/2, equalities A u = c, inequalities G u <= h (rows are sparse)."""
    q = [[0.0] * (2 * N) for _ in range(2 * N)]
    for i in range(N - 1):
        for sparse in ({2 * i: -1.0, 2 * i + 2: 1.0}, {2 * i + 1: -1.0, 2 * i + 3: 1.0},
                       {2 * i: -1.0, 2 * i + 1: -1.0, 2 * i + 2: 1.0, 2 * i + 3: 1.0}):
            for j, x in sparse.items():
                for k, y in sparse.items():
                    q[j][k] += x * y
    primaries = srgb_to_xyz()
    a, c = [], []
    for step in (1, 20):
        for channel, row in enumerate(channel_weights(step)):
            for primary in range(2):
                a.append([row[j // 2] if j % 2 == primary else 0.0 for j in range(2 * N)])
                c.append(primaries[channel][primary] / sum(primaries[channel]))
    g, h = [], []
    for i in range(N):
        g += [{2 * i: -1.0}, {2 * i + 1: -1.0}, {2 * i: 1.0, 2 * i + 1: 1.0}]
        h += [0.0, 0.0, 1.0]
    return q, a, c, g, h


def interior_point(q, a, c, g, h):
    n, m = len(q), len(g)
    u, y, s, z = [1.0 / 3.0] * n, [0.0] * len(a), [1.0] * m, [1.0] * m
    for iteration in range(60):
        gu = [sum(x * u[j] for j, x in row.items()) for row in g]
        r_dual = [sum(q[i][j] * u[j] for j in range(max(0, i - 4), min(n, i + 5))) for i in range(n)]
        for row, value in zip(a, y):
            for j in range(n):
                r_dual[j] += row[j] * value
        for row, value in zip(g, z):
            for j, x in row.items():
                r_dual[j] += x * value
        r_equal = [sum(x * v for x, v in zip(row, u)) - value for row, value in zip(a, c)]
        r_bound = [gu[k] + s[k] - h[k] for k in range(m)]
        gap = sum(s[k] * z[k] for k in range(m)) / m
        worst = max(max(map(abs, r_equal)), max(map(abs, r_bound)), max(map(abs, r_dual)))
        print(f"{iteration}: gap {gap:.1e}, residual {worst:.1e}", file=sys.stderr)
        if gap < 1e-14 and worst < 1e-13:
            break
        target = 0.1 * gap
        kkt = [q[i][:] for i in range(n)]
        right = [-x for x in r_dual]
        for k, row in enumerate(g):
            weight = z[k] / s[k]
            shift = weight * r_bound[k] + (target - s[k] * z[k]) / s[k]
            for i, x in row.items():
                right[i] -= x * shift
                for j, v in row.items():
                    kkt[i][j] += weight * x * v
        # kkt du + A' dy = right; A du = -r_equal: eliminate du.
        sides = solve(kkt, [[right[i]] + [row[i] for row in a] for i in range(n)])
        schur = [[sum(row[i] * sides[i][1 + k] for i in range(n)) for k in range(len(a))] for row in a]
        dy = solve(schur, [[sum(row[i] * sides[i][0] for i in range(n)) + r] for row, r in zip(a, r_equal)])
        du = [sides[i][0] - sum(sides[i][1 + k] * dy[k][0] for k in range(len(a))) for i in range(n)]
        ds = [-r_bound[k] - sum(x * du[j] for j, x in g[k].items()) for k in range(m)]
        dz = [(target - s[k] * z[k] - z[k] * ds[k]) / s[k] for k in range(m)]
        length = 1.0
        for value, step in list(zip(s, ds)) + list(zip(z, dz)):
            if step < 0.0:
                length = min(length, -0.99 * value / step)
        u = [x + length * d for x, d in zip(u, du)]
        y = [x + length * d[0] for x, d in zip(y, dy)]
        s = [x + length * d for x, d in zip(s, ds)]
        z = [x + length * d for x, d in zip(z, dz)]
    return u


def main():
    u = interior_point(*program())
    print("wavelength_nm,r,g,b")
    for i, nm in enumerate(NODES):
        r, g = round(u[2 * i], 15), round(u[2 * i + 1], 15)
        print(f"{nm},{r:.15f},{g:.15f},{1.0 - r - g:.15f}")


if __name__ == "__main__":
    main()
