#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes data/oracle_vectors.jsonl: what oracle.py says about interfaces of isotropic and uniaxial media.

    python3 make_oracle_vectors.py [--per-category 100] [--seed 20240] > data/oracle_vectors.jsonl

Takes about six minutes, so the file is kept. Each line has the inputs as oracle.py prints them and, per incident mode,
its outgoing modes, 17 digits. To keep the file small, what follows from the rest is left out: `ray` where it is k/|k|
(isotropic medium), k of an incident wave in an isotropic medium, k of the p mode of a pair (that of s), k and ray of the
outgoing modes of the second mode of an incident pair (those of the first), `kind` unless evanescent, `power` if
evanescent (0). Powers below 1e-40 are rounding of the oracle and written as 0. Labels s and p mean a pair. Every tenth case
keeps E and amp as well.
Categories that draw biaxial media are left out; those that may draw one draw a uniaxial one instead.
"""
import argparse
import random

import oracle

LEFT_OUT = {'iso-bi', 'bi-iso', 'bi-bi', 'uni-bi', 'bi-uni', 'near-uni-bi', 'bi-near-conical'}


def shortened(record, with_fields):
    kinds = {'R': record['medium1']['type'], 'T': record['medium2']['type'], None: record['medium1']['type']}
    pair_is_known = False
    for incident in record['incident']:
        modes = [incident] + incident.get('out', [])
        pair_in = incident['label'] == 's' or incident['label'] == 'p'
        for place, mode in enumerate(modes):
            evanescent = mode['kind'] == 'evanescent'
            if not with_fields:
                for key in ('E', 'E_im', 'amp'):
                    mode.pop(key, None)
            if kinds[mode.get('side')] == 'isotropic':
                mode.pop('ray', None)
            mode.pop('degenerate')
            second = mode['label'] == 'p'
            if second or (pair_in and pair_is_known and place > 0):
                for key in ('k', 'ray', 'k_im'):
                    mode.pop(key, None)
            if evanescent:
                mode.pop('power')
            else:
                mode.pop('kind')
                if 0 < mode.get('power', 1) < 1e-40:
                    mode['power'] = oracle.mp.mpf(0)
            if place == 0 and kinds[None] == 'isotropic':
                mode.pop('k', None)
        pair_is_known |= pair_in and 'out' in incident
    for key in ('max_residual', 'ulp_sensitivity_side'):
        record.pop(key)
    record['ulp_sensitivity_mode'] = float(oracle.mp.nstr(record['ulp_sensitivity_mode'], 3))
    return record


def case_record(number, case):
    """oracle.case_record, its one-ulp sensitivity taken over twelve random nudges instead of two."""
    record = oracle.case_record(number, case)
    record['ulp_sensitivity_mode'] = max(oracle.sensitivity(case, seed)[0] for seed in range(6))
    return record


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--per-category', type=int, default=100)
    parser.add_argument('--seed', type=int, default=20240)
    arguments = parser.parse_args()
    oracle.rnd_bi = oracle.rnd_uni
    number = 0
    for category in oracle.CATEGORIES:
        if category in LEFT_OUT:
            continue
        rg = random.Random('%d %s' % (arguments.seed, category))
        for _ in range(arguments.per_category):
            record = case_record(number, oracle.make_case(category, rg))
            print(oracle.dump(shortened(record, number % 10 == 0), 17).replace(', ', ',').replace(': ', ':'))
            number += 1


if __name__ == '__main__':
    main()
