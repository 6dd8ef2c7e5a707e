#!/usr/bin/env python3
"""The same bytes on every processor: files and text (TAP).

usage: cli_bits.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import hashlib
import re

from cli_room import expect, run_cases

# The C library then chooses as on a processor without fused products.
PLAIN = 'glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX2_Usable,-FMA_Usable'
START = ['--v', '1.7', '--psi', '0.6']
COMMANDS = [
    ['knees', '--alpha', '0.34', '--json'],
    ['push', '--alpha', '0.34', *START, '--json'],
    ['simulate', '--alpha', '0.33', *START, '--json'],
    ['portrait', '--alpha', '0.34', '-o', 'p.h5'],
    ['basin', '--alpha', '0.33', '-o', 'b.h5', '--set',
     'basins.cells=[20, 15]', '--set', 'products=[margin, slip, peak]'],
]


def outcome(room, args, **how):
    """What is printed and a sum of what is written."""
    done = room.run(*args, **how)
    name = args[args.index('-o') + 1] if '-o' in args else ''
    written = hashlib.sha256(room.bytes(name)).hexdigest() if name else ''
    said = re.sub(r'"seconds": \S+|[0-9.]+ m?s\b', 'time', done.stdout)
    return done.returncode, said, done.stderr, written


def fused_products_change_no_byte(room):
    for law in ['dieterich_gen', 'ruina', 'spinodal_gen']:
        for command in COMMANDS:
            args = [*command, '--law', law]
            here = outcome(room, args)
            there = outcome(room, args, GLIBC_TUNABLES=PLAIN)
            expect(here[3] == there[3], args, 'the file')
            for one, two in zip(here[1].splitlines(), there[1].splitlines()):
                expect(one == two, args, one, two)
            expect(here == there, args)
            expect(here[0] == 0, args, here[2])


run_cases([fused_products_change_no_byte])
