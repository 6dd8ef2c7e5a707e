#!/usr/bin/env python3
"""Every command in docs/paper.md prints what stands there (TAP).

usage: cli_paper.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import os
import re

from cli_room import expect, run_cases


def commands(room):
    """[line of text, command, what it must print] in order."""
    path = os.path.join(room.source, 'docs', 'paper.md')
    found = []
    with open(path, encoding='utf-8') as file:
        for number, line in enumerate(file, 1):
            told = re.match(r' {4,}(\$ )?(.*)', line)
            if told and told[1]:
                found.append([number, told[2], []])
            elif told:
                expect(found, number, line)
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


def every_command_prints_what_stands_there(room):
    room.bring('scenes')
    room.make('outputs')
    told, said = commands(room), {}
    expect(len(told) > 20, told)
    for number, command, lines in told:
        expect(command.startswith('slipway ') and lines, number, command)
        if command not in said:
            done = room.shell(command)
            expect((done.returncode, done.stderr) == (0, ''), number, done)
            said[command] = done.stdout
        for line in lines:
            expect(in_one_line(line, said[command]),
                   f'paper.md:{number}: {command}: {line!r} is not in\n'
                   + said[command])


def every_file_it_names_is_there(room):
    with open(os.path.join(room.source, 'docs', 'paper.md'),
              encoding='utf-8') as file:
        text = file.read()
    names = set(re.findall(r'`((?:lib|manifold|portrait|apps)/[\w./]+)`', text))
    names |= {'scenes/' + name for name in re.findall(r'`(\w+\.yaml)`', text)}
    expect(len(names) > 30, names)
    for name in sorted(names):
        expect(os.path.exists(os.path.join(room.source, name)), name)


run_cases([
    what_is_matched_is_what_is_meant,
    every_command_prints_what_stands_there,
    every_file_it_names_is_there,
])
