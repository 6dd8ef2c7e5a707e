#!/usr/bin/env python3
"""docs/new_law.md, new_number.md and new_command.md, done as they say: change
the sources, compile, run (TAP).

usage: test_new_law.py PATH_TO_SLIPWAY SOURCE_ROOT BUILD_ROOT

The sources are a copy.  Only what the changes can matter to is compiled again,
with the build's own commands, and linked before its libraries.
"""
import json
import os
import re
import shlex
import shutil
import subprocess
import sys

from cli_room import expect, run_cases
from pages import Reader, blocks

SOURCE, BUILD = (os.path.realpath(path) for path in sys.argv[2:4])
PAGE = os.path.join(SOURCE, 'docs', 'new_law.md')
NUMBER = os.path.join(SOURCE, 'docs', 'new_number.md')
COMMAND = os.path.join(SOURCE, 'docs', 'new_command.md')
FOLDERS = ['lib', 'manifold', 'portrait']


def apply(room, block):
    """Lines with + are added, lines with - go; each place is found by its
    lines, and is the only one."""
    name, *hunks = re.split(r'^@@\n', block.text, flags=re.M)
    path = room.path(re.fullmatch(r'--- (\S+)\n', name)[1])
    with open(path, encoding='utf-8') as file:
        text = file.read()
    for hunk in hunks:
        lines = hunk.splitlines(True)
        expect(all(line[0] in ' +-' for line in lines), hunk)
        old = ''.join(line[1:] for line in lines if line[0] != '+')
        new = ''.join(line[1:] for line in lines if line[0] != '-')
        expect(text.count(old) == 1, f'{path}: not once:\n{old}')
        text = text.replace(old, new)
    with open(path, 'w', encoding='utf-8') as file:
        file.write(text)


def commands():
    """name -> command of every source."""
    with open(f'{BUILD}/compile_commands.json', encoding='utf-8') as file:
        found = json.load(file)
    for entry in found:
        path = os.path.normpath(os.path.join(BUILD, entry['file']))
        yield os.path.relpath(path, SOURCE), shlex.split(entry['command'])


def of_a_law():
    """(source, command) of lib/friction and whoever includes its formulas."""
    for name, command in commands():
        if name.split('/')[0] not in FOLDERS:
            continue
        with open(os.path.join(SOURCE, name), encoding='utf-8') as file:
            text = file.read()
        if name.startswith('lib/friction/') or re.search(
                r'#include "layer_lanes\w*\.', text):
            yield name, command


def of_a_number():
    """The list of tables, and the new file."""
    old, new = 'lib/study/study_results.c', 'lib/study/rise.c'
    command = dict(commands())[old]
    yield old, command
    yield new, [word.replace(old, new) for word in command]


def who_read(header):
    """The sources whose compilers read it, as ninja remembers."""
    for entry in ran(['ninja', '-t', 'deps']).split('\n\n'):
        read = [os.path.relpath(os.path.join(BUILD, line.strip()), SOURCE)
                for line in entry.splitlines()[1:]]
        if header in read:
            yield read[0]


def of_a_command():
    """All that knows the list of commands, and the new file."""
    old, new = 'apps/run_sweep.c', 'apps/run_rates.c'
    known, knows = dict(commands()), set(who_read('apps/catalogue.h'))
    yield from ((name, command) for name, command in known.items()
                if name in knows and name != 'apps/crew_mpi.c')
    yield new, [word.replace(old, new) for word in known[old]]


def compiled(room, name, command):
    """The object of the changed copy; quickly made."""
    out = os.path.basename(name) + '.o'
    kept, skip = [], False
    for word in command:
        if skip or word in ('-c', '-MD') or word.endswith('/' + name):
            skip = False
        elif word in ('-o', '-MF', '-MQ'):
            skip = True
        elif word.startswith('-I'):
            path = os.path.normpath(os.path.join(BUILD, word[2:]))
            kept.append('-I' + (path.replace(SOURCE, room.folder)
                                if path.startswith(SOURCE + '/') else path))
        else:
            kept.append(word)
    ran([*kept, '-O0', '-g0', '-c', room.path(name), '-o', room.path(out)])
    return room.path(out)


def ran(command):
    done = subprocess.run(command, cwd=BUILD, text=True, capture_output=True,
                          timeout=300, check=False)
    expect(done.returncode == 0, command, done.stdout, done.stderr)
    return done.stdout


def build(room, sources, least):
    """room/slipway, which becomes the slipway of this room."""
    objects = {name: compiled(room, name, command)
               for name, command in sources()}
    expect(len(objects) >= least, objects)
    link = shlex.split(ran(['ninja', '-t', 'commands', '-s',
                            'apps/slipway']).splitlines()[-1])
    own = [f'apps/slipway.p/{os.path.basename(name)}.o' for name in objects
           if name.startswith('apps/')]
    link = [word for word in link if word not in own]
    at = link.index('-o') + 1
    link[at:at + 1] = [room.path('slipway'), *objects.values()]
    ran(link)
    os.remove(os.path.join(room.bin, 'slipway'))
    os.symlink(room.path('slipway'), os.path.join(room.bin, 'slipway'))


def the_page_does_what_it_says(room):
    for folder in FOLDERS:
        shutil.copytree(os.path.join(SOURCE, folder), room.path(folder))
    reader, stale, builds = Reader(room, PAGE), False, 0
    for block in blocks(PAGE):
        if block.language == 'diff':
            apply(room, block)
            stale = True
        elif block.name:
            reader.write(block)
        elif block.language == 'console':
            if stale:
                build(room, of_a_law, 13)
                stale, builds = False, builds + 1
            reader.run(block)
        else:
            expect(False, block.line, 'is not tried')
    expect(builds == 2 and reader.did >= 6, builds, reader.did)


def a_number_is_one_file_and_two_lines(room):
    for folder in FOLDERS:
        shutil.copytree(os.path.join(SOURCE, folder), room.path(folder))
    reader, files, lines = Reader(room, NUMBER), 0, 0
    for block in blocks(NUMBER):
        if block.language == 'diff':
            apply(room, block)
            lines += len(re.findall(r'^[+-](?!-- )', block.text, re.M))
        elif block.name:
            room.write(f'lib/study/{block.name}', block.text)
            files += 1
        elif block.language == 'console':
            if reader.did == 0:
                build(room, of_a_number, 2)
            reader.run(block)
    expect((files, lines) == (1, 2) and reader.did >= 11, files, lines)


def a_command_is_one_file_and_two_rows(room):
    for folder in [*FOLDERS, 'apps']:
        shutil.copytree(os.path.join(SOURCE, folder), room.path(folder))
    reader, files, rows = Reader(room, COMMAND), 0, 0
    for block in blocks(COMMAND):
        if block.language == 'diff':
            apply(room, block)
            rows += 1
        elif block.name:
            room.write(f'apps/{block.name}', block.text)
            files += 1
        elif block.language == 'console':
            build(room, of_a_command, 30)
            reader.run(block)
    expect((files, rows) == (1, 2) and reader.did >= 5, files, rows)


def a_change_that_does_not_fit_is_seen(room):
    shutil.copytree(os.path.join(SOURCE, 'lib'), room.path('lib'))
    block = [b for b in blocks(PAGE) if b.language == 'diff'][0]
    apply(room, block)
    block.text = block.text.replace(' ' * 8, ' ' * 9)
    try:
        apply(room, block)
    except AssertionError:
        return
    expect(False, 'not seen')


run_cases([
    the_page_does_what_it_says,
    a_number_is_one_file_and_two_lines,
    a_command_is_one_file_and_two_rows,
    a_change_that_does_not_fit_is_seen,
])
