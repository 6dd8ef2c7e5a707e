#!/usr/bin/env python3
"""Every command in docs/*.md prints what stands there (TAP).

usage: cli_docs.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import glob
import os
import re

from cli_room import expect, run_cases


def pages(room):
    found = sorted(glob.glob(os.path.join(room.source, 'docs', '*.md')))
    expect(len(found) >= 3, found)
    return found


def commands(path):
    """[line of text, command, what it must print] in order: lines indented by
    four blanks, from a `$` to the next that is not."""
    found, inside = [], False
    with open(path, encoding='utf-8') as file:
        for number, line in enumerate(file, 1):
            told = re.match(r' {4,}(\$ )?(.*)', line)
            inside = bool(told) and (inside or bool(told[1]))
            if inside and told[1]:
                found.append([number, told[2], []])
            elif inside:
                found[-1][2].append(told[2])
    return found


def in_one_line(expected, printed):
    """`...` stands for anything, blanks for any blanks."""
    parts = [r'\s+'.join(map(re.escape, part.split()))
             for part in expected.split('...')]
    pattern = ''
    for part, text in zip(parts, expected.split('...')):
        pattern += r'\s*' * text.startswith(' ') + part
        pattern += r'\s*' * text.endswith(' ') + '.*?'
    return re.search(r'(^|[^\w.])' + pattern, printed, re.M)


def what_is_matched_is_what_is_meant(_):
    """The test itself: a wrong digit, word or command is seen."""
    printed = ' v_plus   2832.22 +- 1e-9\n xi = 0.85   v_plus 2812.35, mu_s 1\n'
    for right in ('v_plus 2832.2...', 'v_plus 2832.22 +- 1e-9',
                  'xi = 0.85 ... 2812.35, mu_s 1', '2832'):
        expect(in_one_line(right, printed), right)
    for wrong in ('v_plus 2832.3...', 'plus 2832.22', 'v_minus 2832.2...',
                  'v_plus 2832.22 ... mu_s', 'xi = 0.9 ... 2812.35', '32.22'):
        expect(not in_one_line(wrong, printed), wrong)


def run_page(room, path, said):
    told, name = commands(path), os.path.basename(path)
    for number, command, lines in told:
        expect(command.startswith('slipway ') and lines, name, number, command)
        if command not in said:
            done = room.shell(command)
            expect((done.returncode, done.stderr) == (0, ''), name, number,
                   done)
            said[command] = done.stdout
        for line in lines:
            expect(in_one_line(line, said[command]),
                   f'{name}:{number}: {command}: {line!r} is not in\n'
                   + said[command])
    return len(told)


def every_command_prints_what_stands_there(room):
    room.bring('scenes')
    room.make('outputs')
    said = {}
    told = sum(run_page(room, path, said) for path in pages(room))
    expect(told > 40, told)


def every_file_it_names_is_there(room):
    text = ''
    for path in pages(room):
        with open(path, encoding='utf-8') as file:
            text += file.read()
    names = set(re.findall(
        r'`((?:lib|manifold|portrait|apps|tests)/[\w./]+)`', text))
    names |= {'scenes/' + name for name in re.findall(r'`(\w+\.yaml)`', text)}
    expect(len(names) > 50, names)
    for name in sorted(names):
        expect(os.path.exists(os.path.join(room.source, name)), name)


run_cases([
    what_is_matched_is_what_is_meant,
    every_command_prints_what_stands_there,
    every_file_it_names_is_there,
])
