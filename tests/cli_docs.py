#!/usr/bin/env python3
"""Every page of docs/ does and prints what stands there (TAP).

usage: cli_docs.py PATH_TO_SLIPWAY SOURCE_ROOT

How pages are read is in pages.py.  test_check.py runs the commands of
check.md, test_new_law.py those of new_law.md, new_number.md, new_command.md,
test_python_use.py python.md.
"""
import glob
import os
import re
import sys

from cli_room import expect, run_cases
from pages import Block, Reader, do_page, is_in, text_of

ELSEWHERE = ['check.md', 'new_command.md', 'new_law.md', 'new_number.md',
             'python.md']
SOURCE = os.path.realpath(sys.argv[2])


def pages():
    return sorted(glob.glob(os.path.join(SOURCE, 'docs', '*.md')))


# ---- the test itself ---------------------------------------------------------

def what_is_matched_is_what_is_meant(_):
    """A wrong digit, word or command is seen."""
    printed = ' v_plus   2832.22 +- 1e-9\n xi = 0.85   v_plus 2812.35, mu_s 1\n'
    for right in ('v_plus 2832.2...', 'v_plus 2832.22 +- 1e-9',
                  'xi = 0.85 ... 2812.35, mu_s 1', '2832...'):
        expect(is_in(right, printed), right)
    for wrong in ('v_plus 2832.3...', 'plus 2832.22', 'v_minus 2832.2...',
                  'v_plus 2832.22 ... mu_s', 'xi = 0.9 ... 2812.35', '32.22',
                  'v_plus 2832.2', 'v_plus 2832', 'xi = 0.8', 'mu'):
        expect(not is_in(wrong, printed), wrong)


def fails(room, text):
    try:
        Reader(room, 'page.md').run(Block(1, 'console', text))
    except AssertionError:
        return True
    return False


def a_page_that_lies_is_seen(room):
    """Commands share a shell; exit codes count."""
    room.make('a')
    for right in ('$ cd a\n$ pwd\n.../a\n', '$ cat /dev/null\n',
                  '$ false\n$ echo $?\n1\n', '$ slipway --version\nslipway ...',
                  '$ X=1; export X\n$ echo "$X"\n1\n', '$ echo "$X"\n1\n'):
        expect(not fails(room, right), right)
    for wrong in ('$ false\n', '$ echo 1\n2\n', '$ true\n$ echo $?\n1\n',
                  '$ slipway nonsense\n', 'words\n'):
        expect(fails(room, wrong), wrong)


# ---- pages -------------------------------------------------------------------

def case_of(path):
    def case(room):
        do_page(room, path)
    case.__name__ = os.path.basename(path)[:-3] + '_is_true'
    return case


# ---- all pages ---------------------------------------------------------------

def every_file_it_names_is_there(_):
    text = ''.join(map(text_of, pages()))
    names = set(re.findall(
        r'`((?:lib|manifold|portrait|apps|tests)/[\w./]+)`', text))
    names |= {'scenes/' + name for name in re.findall(r'`(fig\w+\.yaml)`', text)}
    names |= {'docs/' + name
              for name in re.findall(r'\]\(([\w./]+)\)', text)}
    expect(len(names) > 50, names)
    for name in sorted(names):
        expect(os.path.exists(os.path.join(SOURCE, name)), name)


def every_function_of_a_format_is_in_a_header(_):
    names = set(re.findall(r'`([a-z]+(?:_[a-z]+)+)`',
                           text_of(f'{SOURCE}/docs/new_format.md')))
    headers = ''.join(text_of(path) for room in ('lib/*', 'apps') for path in
                      glob.glob(f'{SOURCE}/{room}/*.h'))
    expect(len(names) > 12, names)
    for name in sorted(names):
        expect(re.search(rf'\b{name}\b', headers), name)


LITERAL = r'"(?:\\.|[^"\\\n])*"'
LITERALS = rf'{LITERAL}(?:\s*{LITERAL})*'
# Where the sources give a reason.
GIVEN = [r'\b(?:quantity_none|none|no_fit|no_material|nothing)\(([^;]*);',
         rf'\bconst char \w+\[\] =\s*({LITERALS})',
         r'\b(?:reason(?:\[\w+\])?|why) =([^;]*);', rf'return ({LITERALS});']


def joined(text):
    """The strings in C, those that stand one after another as one."""
    return {''.join(part[1:-1] for part in re.findall(LITERAL, one))
            for one in re.findall(LITERALS, text)}


def reasons_in(text):
    found = {one for pattern in GIVEN for given in re.findall(pattern, text)
             for one in joined(given)}
    return {one for one in found
            if one.count(' ') >= 2 and '%' not in one and '\\n' not in one}


def reasons_are_explained_and_none_is_invented(_):
    told = set(re.findall(r'^\| `([^`]+)` \|',
                          text_of(f'{SOURCE}/docs/reasons.md'), re.M))
    there, given = set(), set()
    rooms = ('friction', 'fit', 'numbers', 'motion', 'slow', 'basin', 'plane', 'proof',
             'study', 'sweep', 'check')
    for folder in [f'{room}/*.c' for room in rooms] + ['core/record.h',
                                                    'core/unit.c']:
        for path in glob.glob(f'{SOURCE}/lib/{folder}'):
            text = re.sub(r'/\*.*?\*/', '', text_of(path), flags=re.S)
            there |= joined(text)
            given |= reasons_in(text)
    expect(len(told) > 70 and told <= there, 'invented:', told - there)
    expect(given <= told, 'not explained:', given - told)


run_cases([
    what_is_matched_is_what_is_meant,
    a_page_that_lies_is_seen,
    *[case_of(path) for path in pages()
      if os.path.basename(path) not in ELSEWHERE],
    every_file_it_names_is_there,
    every_function_of_a_format_is_in_a_header,
    reasons_are_explained_and_none_is_invented,
])
