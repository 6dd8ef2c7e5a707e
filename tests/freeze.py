#!/usr/bin/python3
"""What the program writes, kept and compared.

usage: freeze.py PATH_TO_SLIPWAY SOURCE_ROOT FOLDER [full]

Runs every scene and every command of README and docs in an empty folder and
puts what they print, their JSON and their HDF5 files as text (names in the
order of creation, every attribute, every value) into FOLDER.  Numbers that are
times are left out.  Before a change and after it, into two folders:

    diff -r before after

Scenes run on small grids; with `full` as they are.
"""
import glob
import hashlib
import os
import re
import sys
import tempfile

import h5py
import numpy as np

from cli_reference import DATA, MORE, settings, small_scene
from cli_room import Room
from pages import blocks

# Timings, and what would take minutes.
CLOCK = re.compile(r'"(?:seconds|own_seconds|foreign_seconds|clock_overhead|'
                   r'ratio_to_best_foreign)": [^,\n]+')
SKIP = re.compile(r'\b(tests|bench|slipway gallery|\./run gallery|stress|'
                  r'workprec)\b')
OURS = re.compile(r'^(?:\./run|slipway|build/apps/slipway) ')


def plain(text):
    text = text.decode() if isinstance(text, bytes) else str(text)
    return CLOCK.sub('"time"', text)


def value_text(data):
    """Small ones as they are, large ones by their bytes."""
    data = np.asarray(data)
    if data.dtype.kind in 'OS' or data.size <= 64:
        return repr(data.tolist())
    head = ' '.join(repr(x) for x in data.ravel()[:3].tolist())
    return f'{head} ... {hashlib.sha256(data.tobytes()).hexdigest()}'


def attributes(thing):
    for key, value in thing.attrs.items():
        if key in ('REFERENCE_LIST', 'DIMENSION_LIST', 'CLASS', 'NAME',
                   '_Netcdf4Coordinates', '_Netcdf4Dimid'):
            continue
        yield f'    {key} = {value_text(value)}'


def dump(group, lines):
    """A group, what it holds, in the order of creation."""
    lines.append(f'{group.name}/')
    lines.extend(attributes(group))
    for name in group:
        thing = group[name]
        if isinstance(thing, h5py.Group):
            dump(thing, lines)
            continue
        axes = [axis[0].name for axis in thing.dims if len(axis)]
        lines.append(f'{thing.name} {thing.dtype} {thing.shape} {axes} '
                     f'{thing.compression}')
        lines.extend(attributes(thing))
        lines.append(f'    {value_text(thing[()])}')
    return lines


class Freezer:
    def __init__(self, room, folder):
        self.room, self.folder, self.seen = room, folder, {}
        os.makedirs(folder, exist_ok=True)

    def put(self, name, text):
        name = re.sub(r'[^\w.=+-]+', '_', name)[:150]
        with open(os.path.join(self.folder, name), 'w',
                  encoding='utf-8') as file:
            file.write(text)

    def said(self, name, done):
        self.put(name, f'{done.returncode}\n{plain(done.stdout)}'
                 f'---\n{plain(done.stderr)}')

    def files(self):
        """Those that are new or have changed."""
        for path in sorted(glob.glob(self.room.path('**/*.h5'),
                                     recursive=True)):
            name = os.path.relpath(path, self.room.folder)
            stamp = os.stat(path).st_mtime_ns
            if self.seen.get(name) == stamp:
                continue
            self.seen[name] = stamp
            with h5py.File(path, 'r', track_order=True) as file:
                self.put(name + '.dump', '\n'.join(dump(file, [])) + '\n')

    def run(self, *args):
        done = self.room.run(*args)
        self.said(' '.join(args) + '.out', done)
        return done

    def shell(self, where, line):
        self.said(f'{where} {line}.out', self.room.shell(line))


def pages(source):
    yield os.path.join(source, 'README.md')
    yield from sorted(glob.glob(os.path.join(source, 'docs', '*.md')))


def commands(path):
    """The lines of a page that run the program."""
    with open(path, encoding='utf-8') as file:
        text = file.read()
    lines = re.findall(r'^    ((?:\./run|build/apps/slipway|slipway) .*)$',
                       text, re.M)
    for block in blocks(path):
        lines += [line.removeprefix('$ ') for line in block.text.splitlines()]
    for line in dict.fromkeys(lines):
        if OURS.match(line) and not SKIP.search(line):
            yield OURS.sub('slipway ', line)


def freeze(room, source, folder, full):
    f = Freezer(room, folder)
    room.bring('scenes')
    room.make('outputs/gallery')
    room.write('three.csv', DATA)
    for path in sorted(glob.glob(room.path('scenes/*.yaml'))):
        path = os.path.relpath(path, room.folder)
        small = small_scene(room, path)
        if full:
            small = small[:3]
        f.run('study', '--set', 'output.figure=', *small)
        f.run('study', '--json', '--set', 'output.figure=', *small)
        f.run('check', '--record', path)
    for i, (command, sets) in enumerate(MORE):
        if SKIP.search(command):
            continue
        words = [*command.split(), '-o', f'more{i}.h5', *settings(sets)]
        f.run(*words)
        f.run(*words, '--json')
    f.run('push', '--law', 'spinodal_gen', '--alpha', '0.34', '--v', '1',
          '--psi', '1', '--json')
    f.files()
    for name in sorted(room.names()):
        if name.endswith('.h5'):
            f.run('info', name)
    for format_ in ('scene', 'hdf5', 'words'):
        f.run('help', '--as', format_)
    for path in pages(source):
        for block in blocks(path):
            if block.name:
                room.write(block.name, block.text)
        for line in commands(path):
            f.shell(os.path.basename(path), line)
            f.files()


def main():
    slipway, source, folder = map(os.path.realpath, sys.argv[1:4])
    with tempfile.TemporaryDirectory() as place:
        room = Room(os.path.realpath(place), slipway, source)
        freeze(room, source, folder, sys.argv[4:] == ['full'])


if __name__ == '__main__':
    main()
