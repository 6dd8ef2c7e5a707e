#!/usr/bin/env python3
"""slipway ends when it is told to, and by itself (TAP).

usage: cli_signals.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import os
import random
import shutil
import signal
import subprocess
import time

from cli_room import LAWS, expect, run_cases

SEED = int(os.environ.get('CHECK_SEED', 20240229))
RUNS = int(os.environ.get('SIGNALS', 40))


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


def interrupt(room, draw, command):
    """Exit code, seconds from the signal to the end, lines on stderr."""
    job = subprocess.Popen([room.slipway, *command], cwd=room.folder,
                           env=room.environment(), stdout=subprocess.DEVNULL,
                           stderr=subprocess.PIPE, text=True)
    time.sleep(draw.uniform(0.1, 1.5))
    sent = time.monotonic()
    job.send_signal(draw.choice([signal.SIGINT, signal.SIGTERM]))
    _, said = job.communicate(timeout=300)
    return job.returncode, time.monotonic() - sent, said.splitlines()


def a_signal_is_heard_within_a_second_and_nothing_is_left(room):
    draw = random.Random(SEED)
    room.write('states.csv', 'v,psi\n' + ''.join(
        f'{10 ** draw.uniform(-3, 4):.6g},{10 ** draw.uniform(-3, 2):.6g}\n'
        for _ in range(100000)))
    room.bring('scenes')
    stopped, longest = 0, 0.0
    for k in range(RUNS):
        command = COMMANDS[k % len(COMMANDS)](draw)
        code, took, said = interrupt(room, draw, command)
        if code == 130:
            stopped += 1
            longest = max(longest, took)
            # its own 0.7 s and what a busy machine adds
            expect(took < 1.5 and len(said) == 1, took, said, command, SEED)
        else:  # done before, or not yet listening
            expect(code in (0, 2, 3, -signal.SIGINT, -signal.SIGTERM), code,
                   said, command, SEED)
        left = [name for _, folders, files in os.walk(room.folder)
                for name in folders + files
                if name.startswith(('.figure', '.slipway')) or
                name.endswith('.tmp')]
        expect(left == [], left, command, SEED)
        for name in room.names():
            if name.startswith('a.'):
                os.remove(room.path(name))
        shutil.rmtree(room.path('gallery'), ignore_errors=True)
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
