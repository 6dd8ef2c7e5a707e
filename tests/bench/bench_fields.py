#!/usr/bin/env python3
"""What a cell of a grid and a state of a list cost, processor time on one
thread, files and bars included: by accuracy, by size, by law, peaks over slip.

usage: bench_fields.py SLIPWAY
"""
import os
import random
import resource
import subprocess
import sys
import tempfile

SLOPE = ['--alpha', '0.34', '--threads', '1', '-q']
FIELDS = 'slip, time, friction'
LAWS = ['dieterich', 'ruina', 'spinodal', 'perrin', 'dieterich_gen']


def seconds(words, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([os.path.realpath(sys.argv[1]), *words], cwd=folder,
                   check=True, stdin=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def grid(folder, side, rtol, law='spinodal_gen', products=FIELDS):
    """Microseconds a cell, the table of the slope included."""
    return 1e6 / side**2 * seconds(
        ['basin', '--law', law, *SLOPE, '-o', 'a.h5', '--set',
         f'products=[{products}]', '--set', f'basins.cells=[{side}, {side}]',
         '--set', f'basins.rtol={rtol}', '--set', 'basins.audit=0'], folder)


def states(folder, law, count):
    """Seconds of a list, ln v in -6 to 9 and ln psi in -6 to 6."""
    draw = random.Random(1)
    with open(os.path.join(folder, 'a.csv'), 'w', encoding='utf-8') as f:
        f.write('v,psi\n')
        for _ in range(count):
            x, y = draw.uniform(-6, 9), draw.uniform(-6, 6)
            f.write(f'{2.718281828459045**x!r},{2.718281828459045**y!r}\n')
    return seconds(['push', '--law', law, *SLOPE, '--states', 'a.csv', '-o',
                    'b.csv'], folder)


def tell(what, us, beside=None):
    ratio = f', {us / beside:.2f} times' if beside else ''
    print(f'{what:40} {us:10.3f} us{ratio}', flush=True)


def main():
    with tempfile.TemporaryDirectory() as folder:
        for rtol in ('1e-4', '1e-6', '1e-8', '1e-10'):
            tell(f'spinodal_gen, 300 x 300 at {rtol}', grid(folder, 300, rtol))
        for side in (64, 256, 1024, 4096):
            tell(f'spinodal_gen, {side} x {side} at 1e-6',
                 grid(folder, side, '1e-6'))
        one = grid(folder, 1000, '1e-6')
        tell('spinodal_gen, 1000 x 1000 at 1e-6', one)
        for law in LAWS:
            tell(f'{law}, 1000 x 1000 at 1e-6',
                 grid(folder, 1000, '1e-6', law), one)
        for law in ('spinodal_gen', 'dieterich_gen'):
            slip = grid(folder, 64, '1e-6', law, 'slip')
            tell(f'{law}, 64 x 64, slip', slip)
            tell(f'{law}, 64 x 64, peak',
                 grid(folder, 64, '1e-6', law, 'peak'), slip)
        for law in ('spinodal_gen', 'dieterich_gen', 'dieterich'):
            more = states(folder, law, 10000) - states(folder, law, 1000)
            tell(f'{law}, push --states, each', 1e6 * more / 9000)


if __name__ == '__main__':
    main()
