#!/usr/bin/env python3
"""slipway ends when it is told to, and by itself (TAP).

usage: cli_signals.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import os
import queue
import random
import shutil
import signal
import subprocess
import time
from multiprocessing.pool import ThreadPool

from cli_room import LAWS, expect, run_cases

SEED = int(os.environ.get('CHECK_SEED', 20240229))
RUNS = int(os.environ.get('SIGNALS', 40))
TOGETHER = 2


def slope(draw):
    friction = draw.choice(['asinh', 'log'])
    return ['--law', draw.choice(LAWS), '--friction', friction,
            '--alpha', f'{draw.uniform(0.3, 0.38):.17g}',
            '--set', f'material.L={10 ** draw.uniform(-6, -2):.6g}',
            '--set', f'material.V_star={10 ** draw.uniform(-9, -6):.6g}']


def push(draw):
    return ['push', *slope(draw), '--states', 'states.csv']


def fields(draw):
    return ['study', *slope(draw), '-o', 'a.h5', '--figure', 'a.png', '--set',
            'products=[basins, slip, time, friction, peak]', '--set',
            'basins={cells: [500, 500], audit: 100}']


def exact(draw):
    return ['basin', *slope(draw), '--exact', '-o', 'a.h5']


def simulate(draw):
    starts = ', '.join(f'{{v: {10 ** draw.uniform(-3, 4):.6g}, '
                       f'psi: {10 ** draw.uniform(-3, 2):.6g}}}'
                       for _ in range(200))
    return ['simulate', *slope(draw), '-o', 'a.h5', '--set',
            f'trajectories.starts=[{starts}]']


def sweep(draw):
    return ['sweep', *slope(draw), '-o', 'a.h5', '--set', 'sweep={key: '
            'slope.alpha, from: 0.2, to: 0.5, points: 20000}']


def portrait(draw):
    return ['portrait', *slope(draw), '-o', 'a.h5', '--figure', 'a.pdf',
            '--set', 'trajectories.spread=2000']


def gallery(_):
    return ['gallery', '-o', 'gallery']


COMMANDS = [push, fields, exact, simulate, sweep, portrait, gallery]


def folder_of(room, number):
    """A folder to run in, with what commands read."""
    name = f'run{number}'
    room.make(name)
    for read in ('states.csv', 'scenes'):
        os.symlink(room.path(read), room.path(f'{name}/{read}'))
    return name


def interrupt(room, folder, run):
    """Exit code, seconds from the signal to the end, lines on stderr, and what
    was left that should not be."""
    command, delay, told = run
    job = subprocess.Popen([room.slipway, *command], cwd=room.path(folder),
                           env=room.environment(), stdout=subprocess.DEVNULL,
                           stderr=subprocess.PIPE, text=True)
    time.sleep(delay)
    sent = time.monotonic()
    job.send_signal(told)
    _, said = job.communicate(timeout=300)
    took = time.monotonic() - sent
    left = [name for _, folders, files in os.walk(room.path(folder))
            for name in folders + files
            if name.startswith(('.figure', '.slipway')) or
            name.endswith('.tmp')]
    for name in room.names(folder):
        if name.startswith('a.'):
            os.remove(room.path(f'{folder}/{name}'))
    shutil.rmtree(room.path(f'{folder}/gallery'), ignore_errors=True)
    return job.returncode, took, said.splitlines(), left


def a_signal_is_heard_within_a_second_and_nothing_is_left(room):
    """Two at a time, each in a folder of its own."""
    draw = random.Random(SEED)
    room.write('states.csv', 'v,psi\n' + ''.join(
        f'{10 ** draw.uniform(-3, 4):.6g},{10 ** draw.uniform(-3, 2):.6g}\n'
        for _ in range(100000)))
    room.bring('scenes')
    # soon, mostly: more happens in the first tenths than later
    runs = [(COMMANDS[k % len(COMMANDS)](draw), 0.05 * 30 ** draw.random(),
             draw.choice([signal.SIGINT, signal.SIGTERM]))
            for k in range(RUNS)]
    folders = queue.SimpleQueue()
    for number in range(TOGETHER):
        folders.put(folder_of(room, number))

    def one(run):
        folder = folders.get()
        try:
            return interrupt(room, folder, run)
        finally:
            folders.put(folder)

    with ThreadPool(TOGETHER) as pool:
        ended = pool.map(one, runs, chunksize=1)
    stopped, longest = 0, 0.0
    for run, (code, took, said, left) in zip(runs, ended):
        if code == 130:
            stopped += 1
            longest = max(longest, took)
            # its own 0.7 s and what a busy machine adds
            expect(took < 1.5 and len(said) == 1, took, said, run, SEED)
        else:  # done before, or not yet listening
            expect(code in (0, 2, 3, -signal.SIGINT, -signal.SIGTERM), code,
                   said, run, SEED)
        expect(left == [], left, run, SEED)
    print(f'# {stopped} of {RUNS} stopped, within {longest:.2f} s')
    expect(stopped > RUNS // 3, stopped, RUNS)


def a_slope_where_an_orbit_hugged_a_box_is_answered(room):
    said = room.json(
        'push', '--law', 'spinodal_gen', '--friction', 'log', '--set',
        'material.L=1e-2', '--set', 'material.V_star=1e-9', '--alpha',
        '0.3822033898305085', '--v', '1', '--psi', '1')
    expect(said['fate'] == 'sliding' and said['slip']['error'] < 1e-6, said)


run_cases([
    a_signal_is_heard_within_a_second_and_nothing_is_left,
    a_slope_where_an_orbit_hugged_a_box_is_answered,
])
