#!/usr/bin/env python3
"""The same bytes however many states a processor follows at once (TAP).

usage: cli_lanes.py SLIPWAY_WITH_FORCED_LANES SOURCE_ROOT
"""
import glob
import os
import re

from cli_reference import DATA, MORE, SAMPLES, settings, small_scene
from cli_room import LAWS, expect, run_cases

FIELDS = ['products=[slip, time, friction, peak]', 'basins={cells: [24, 18], audit: 3}']
WIDTHS = ['1', '2', '4', '8']


def outcome(room, args, lanes):
    """(what is printed, the file, lanes that were taken or None)"""
    done = room.run(*args, LANES=lanes)
    expect(done.returncode in (0, 3), done)
    told = re.match(r'(\d) lanes\n', done.stderr)
    name = args[args.index('-o') + 1]
    said = re.sub(r'"seconds": \S+|[0-9.]+ m?s\b', 'time', done.stdout)
    return said, room.bytes(name), told and told[1]


def commands(room):
    """Every scene, on a small grid, what no scene asks for, and all laws."""
    for path in sorted(glob.glob(room.path('scenes/*.yaml'))):
        path = os.path.relpath(path, room.folder)
        if 'system:' not in room.read(path):  # lanes follow blocks only
            yield ['study', '--set', 'output.figure=', *small_scene(room, path)]
    for i, (command, sets) in enumerate(MORE):
        if not re.match('workprec|stress', command):  # their files hold times
            yield [*command.split(), '-o', f'more{i}.h5', *settings(sets)]
    for law in LAWS:
        yield ['study', '--law', law, '--alpha', '0.34', '-o', law + '.h5',
               *settings(FIELDS)]


def no_byte_of_any_scene_depends_on_the_lanes(room):
    """A command that asks for no lanes at all is run once."""
    room.bring('scenes')
    room.make('outputs')
    room.write('three.csv', DATA)
    room.write('two.csv', SAMPLES)
    used = dict.fromkeys(WIDTHS, 0)
    for args in commands(room):
        first = outcome(room, args, WIDTHS[-1])
        if first[2] is None:
            continue
        used[first[2]] += 1
        for width in WIDTHS[:-1]:
            said, written, taken = outcome(room, args, width)
            expect(int(taken) <= int(width), args, width, taken)
            expect((said, written) == first[:2], args, width, 'lanes')
            used[taken] += 1
    print('# commands at 1, 2, 4, 8 lanes:', *used.values())
    expect(used['1'] >= 10 and used['2'] >= 10, used)


run_cases([no_byte_of_any_scene_depends_on_the_lanes])
