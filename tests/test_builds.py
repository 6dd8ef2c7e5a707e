#!/usr/bin/env python3
"""Proofs are the same bytes whoever compiles them: gcc without optimisation and
clang with it, beside the build's own (TAP).

usage: test_builds.py PATH_TO_SLIPWAY SOURCE_ROOT BUILD_ROOT

What computes them, lib/proof and the intervals of lib/formula, is compiled again
and linked before the build's libraries.
"""
import json
import os
import re
import shlex
import shutil
import subprocess
import sys

from cli_room import expect, run_cases

BUILD = os.path.realpath(sys.argv[3])
AGAIN = re.compile(r'\.\./lib/(proof/\w+|formula/interval\w*)\.c')
SLOPES = [['--law', 'spinodal_gen', '--alpha', '0.38'],
          ['--law', 'perrin', '--friction', 'log', '--alpha', '0.3']]


def ran(*command):
    done = subprocess.run(command, cwd=BUILD, text=True, capture_output=True,
                          timeout=300, check=False)
    expect(done.returncode == 0, command, done.stdout, done.stderr)
    return done.stdout


def objects(room, compiler, level):
    with open(f'{BUILD}/compile_commands.json', encoding='utf-8') as file:
        entries = [e for e in json.load(file) if AGAIN.fullmatch(e['file'])]
    for i, entry in enumerate(entries):
        out = room.path(f'{i}.o')
        flags = [word for word in shlex.split(entry['command'])
                 if re.match('-I|-D|-std|-f(fp-contract|no-math-errno)', word)]
        ran(compiler, *flags, level, '-w', '-c', entry['file'], '-o', out)
        yield out


def check(room, compiler, level):
    if shutil.which(compiler) is None:
        print(f'# there is no {compiler}')
        return
    link = shlex.split(ran('ninja', '-t', 'commands', '-s',
                           'apps/slipway').splitlines()[-1])
    at = link.index('-o') + 1
    made = list(objects(room, compiler, level))
    expect(len(made) > 12, made)
    link[at:at + 1] = [room.path('other'), *made]
    ran(*link)
    for slope in SLOPES:
        room.good('knees', *slope, '--proved', '--certificate', 'own.json')
        ran(room.path('other'), 'knees', *slope, '--proved', '-q',
            '--certificate', room.path('other.json'))
        expect(room.bytes('own.json') == room.bytes('other.json'), compiler,
               level, slope)


def gcc_without_optimisation_proves_the_same(room):
    check(room, 'gcc', '-O0')


def clang_with_optimisation_proves_the_same(room):
    check(room, 'clang', '-O2')


run_cases([
    gcc_without_optimisation_proves_the_same,
    clang_with_optimisation_proves_the_same,
])
