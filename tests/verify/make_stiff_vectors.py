#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes data/stiff_vectors.jsonl: what tests/optics/oracle.py (110 digits) says at settings of the stiffness suite.

    polariscope check stiff --json | python3 make_stiff_vectors.py > data/stiff_vectors.jsonl

Reads the inputs of every interface case between dielectrics and keeps up to four settings of each. A line has the inputs as
the suite lists them (normal, wave normal, media) and, per incident wave (a pair's two modes summed), the power of each
outgoing wave as a double and what it lacks.
"""
import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / 'optics'))
import oracle  # noqa: E402

mp = oracle.mp
POINTS = 4


def media_of(x):
    """The two media behind normal and wave normal, or None: an axis is known by its length."""
    def crystal(v):
        return dict(type='uniaxial', no=v[0], ne=v[1], axis=v[2:5])

    def glass(v):
        return dict(type='isotropic', n=v[0])

    def is_axis(v):
        return len(v) == 3 and abs(sum(a * a for a in v) - 1) < 1e-12

    if len(x) == 2:
        return glass(x[:1]), glass(x[1:])
    if len(x) == 6 and is_axis(x[2:5]):
        return crystal(x[:5]), glass(x[5:])
    if len(x) == 6 and is_axis(x[3:6]):
        return glass(x[:1]), crystal(x[1:])
    if len(x) == 10 and is_axis(x[2:5]) and is_axis(x[7:10]):
        return crystal(x[:5]), crystal(x[5:])
    return None


def powers(inputs, media):
    """Incident wave -> outgoing wave ("R pair", "T o", ...) -> power, both in the order in which they come."""
    result = {}
    for r in oracle.solve(*map(oracle.build, media), inputs[0:3], inputs[3:6]):
        if r is None:
            continue
        waves = result.setdefault('pair' if r.inc.label in 'sp' else r.inc.label, {})
        for side, mode, _, power in r.out:
            if mode.real and power > mp.mpf('1e-60'):
                name = side + ' ' + ('pair' if mode.label in 'sp' else mode.label)
                waves[name] = waves.get(name, mp.mpf(0)) + power
    return result


def two_doubles(value):
    high = float(value)
    return [high, float(value - mp.mpf(high))]


def main():
    for case in json.load(sys.stdin)['cases']:
        points = case['points']
        if not any(word in case['compared'] for word in ('ray', 'powers', 'fields', 'unpolarized')):
            continue
        for i in range(POINTS):
            point = points[i * (len(points) - 1) // (POINTS - 1)]
            media = media_of(point['inputs'][6:])
            if media is None:
                continue
            waves = powers(point['inputs'], media)
            line = dict(case=case['case'], setting=point['setting'], inputs=point['inputs'], crystals=[m['type'] == 'uniaxial' for m in media],
                        powers={k: {w: two_doubles(p) for w, p in v.items()} for k, v in waves.items()})
            print(json.dumps(line, separators=(',', ':')))


if __name__ == '__main__':
    main()
