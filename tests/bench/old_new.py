#!/usr/bin/env python3
"""An old program against the new one, in turns: processor time, least of each.

usage: old_new.py OLD_SLIPWAY NEW_SLIPWAY SOURCE_ROOT [ROUNDS]

The program of any other commit will do:
    git worktree add ../old COMMIT && cd ../old
    meson setup -Dtests=disabled build && ninja -C build apps/slipway
"""
import os
import resource
import subprocess
import sys
import tempfile

SLOPE = ['--law', 'spinodal_gen', '--alpha', '0.34']
BASIN = ['basin', *SLOPE, '-o', 'a.h5', '--set', 'basins.cells=[256, 256]']
WORK = {
    'portrait': ['portrait', *SLOPE],
    'knees': ['knees', *SLOPE],
    'basin': BASIN,
    'fields': [*BASIN, '--set', 'products=[slip, time, friction]'],
    'sweep of 10,000 slopes': [
        'sweep', '--law', 'spinodal_gen', '-o', 'a.h5', '--set',
        'products=[knees]', '--set',
        'sweep={key: slope.alpha, from: 0.3, to: 0.38, points: 10000}'],
}
MOST = 1.05  # what the new one may take of the old one's time


def seconds(program, words, folder):
    """Of one processor: on one thread, so that others in the way tell little."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, *words], cwd=folder, check=False, text=True,
                          capture_output=True, stdin=subprocess.DEVNULL,
                          env={**os.environ, 'OMP_NUM_THREADS': '1'})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode:
        sys.exit(f'{program} {words}: {done.stderr}')
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def main():
    programs = [os.path.realpath(path) for path in sys.argv[1:3]]
    rounds = int(sys.argv[4]) if len(sys.argv) > 4 else 5
    with tempfile.TemporaryDirectory() as folder:
        for name, words in WORK.items():
            many = 10 * rounds if name in ('portrait', 'knees') else rounds
            took = [[], []]
            for _ in range(many):
                for program, list_ in zip(programs, took):
                    list_.append(seconds(program, words, folder))
            old, new = map(min, took)
            print(f'{name:24} old {old:8.3f} s  new {new:8.3f} s  '
                  f'{new / old:5.2f} times'
                  f'{"" if new <= MOST * old else f", above {MOST}"}', flush=True)


if __name__ == '__main__':
    main()
