#!/usr/bin/env python3
"""Certificates are the same bytes whatever compiled the program: those of RUNS by each
SLIPWAY, built with another compiler or -Doptimization=0, 2, 3; a number whose intervals
do not overlap is a lie.  Not in the suite: it takes half a minute each.

usage: proof_compilers.py SLIPWAY SLIPWAY...
Exit status 0: the same bytes; 1: not, and which intervals do not overlap.
"""
import json
import os
import subprocess
import sys
import tempfile

SOURCE = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
RUNS = [['knees', '--law', law, '--friction', form, '--alpha', alpha]
        for law in ('dieterich_gen', 'ruina', 'perrin', 'spinodal', 'spinodal_gen')
        for form in ('asinh', 'log') for alpha in ('0.33', '0.36')]
RUNS += [['knees', f'{SOURCE}/scenes/{name}.yaml']
         for name in ('n_shaped', 'bowden_tabor', 'okubo', 'prz', 'flash_heating')]
RUNS += [['study', '--ode', ode, '--window', 'x=-4:1,y=-3:3'] for ode in
         ("x' = y; y' = -sin(x)", "x' = y; y' = x - x^3 - y/2")]


def certificates(slipway):
    found = []
    with tempfile.TemporaryDirectory() as room:
        for run in RUNS:
            subprocess.run([slipway, *run, '--proved', '--certificate', 'c.json'],
                           cwd=room, check=True, stdout=subprocess.DEVNULL)
            with open(os.path.join(room, 'c.json'), encoding='utf-8') as file:
                found.append(file.read())
    return found


def meet(old, new):
    """Whether the numbers of two certificates do."""
    pairs = [(u, new['numbers'].get(k)) for k, u in old.get('numbers', {}).items()]
    return all(u == w or 'absent' not in (u, w) and u[0] <= w[1] and w[0] <= u[1]
               for u, w in pairs if w is not None)


def main(programs):
    first, failed = None, False
    for slipway in programs:
        found = certificates(os.path.realpath(slipway))
        first = first or found
        other = [i for i, pair in enumerate(zip(first, found)) if len(set(pair)) > 1]
        apart = [RUNS[i] for i in other if not meet(*map(json.loads, (first[i], found[i])))]
        print(f'{slipway}: {len(found)} certificates, {len(other)} of other bytes, '
              f'{len(apart)} of other numbers', *apart, flush=True)
        failed = failed or bool(other)
    return failed


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
