#!/usr/bin/env python3
"""What slipway's pages promise: help and README (TAP).

usage: cli_words.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import re
import subprocess

from cli_room import READER, expect, run_cases

# ---- help --------------------------------------------------------------------


def commands_of(said):
    block = re.search(r'^Commands:\n((?:  .*\n)+)', said, re.M)[1]
    return re.findall(r'^  (\w+)', block, re.M)


def examples_of(said):
    block = re.search(r'^Examples:\n((?:  .*\n)+)', said, re.M)[1]
    return [line.strip() for line in block.splitlines()]


def help_names_every_command_with_an_example(room):
    said = room.good('help')
    commands = commands_of(said)
    expect(len(commands) >= 7, commands)
    expect([line.split()[1] for line in examples_of(said)] == commands,
           'an example of each', said)
    for page in (room.good('--help'), room.good()):
        expect(commands_of(page) == commands, page)


def every_command_explains_itself(room):
    for command in commands_of(room.good('help')):
        short, long = room.good('help', command), room.good(command, '--help')
        expect(short.startswith(f'slipway {command} ')
               and f'Example:\n  slipway {command}' in short, short)
        expect(long.startswith(short) and '--alpha=' in long, long)


def every_example_works(room):
    room.bring('scenes')
    room.make('outputs')
    examples = examples_of(room.good('help'))
    for line in examples:
        if line.startswith('slipway gallery'):
            continue  # half a minute; cli_gallery.py runs it
        done = room.shell(line)
        expect((done.returncode, done.stderr) == (0, ''), line, done)


def options_are_explained_once_each(room):
    options = re.findall(r'^ +(?:-\w, )?(--[a-z-]+)', room.good('--help'), re.M)
    expect(len(options) == len(set(options)) >= 14, options)


def the_version_is_that_of_the_project(room):
    with open(f'{room.source}/meson.build', encoding='utf-8') as file:
        version = re.search(r"version: '([^']+)'", file.read())[1]
    expect(room.good('--version') == f'slipway {version}\n', version)


def every_law_of_the_list_is_a_law(room):
    listed = room.json('laws')
    expect(len(listed) >= 8, listed)
    for law in listed:
        expect(law['name'] in room.good('laws'), law)
        more = ['--set', 'material.V_c=1e3'] if 'V_c' in law['parameters'] \
            else []
        room.good('plan', '--law', law['name'], '--alpha', '0.34', *more)


# ---- README ------------------------------------------------------------------

def blocks(page):
    """(language, text) of fences; indented lines that ./run are sh."""
    for part in re.split(r'^(```\w*\n.*?^```\n)', page, flags=re.M | re.S):
        fence = re.match(r'```(\w*)\n(.*)^```\n', part, re.M | re.S)
        if fence:
            yield fence.groups()
        else:
            for line in re.findall(r'^    (\./run .*)\n', part, re.M):
                yield 'sh', line


def the_readme_does_what_it_says(room):
    """In its order; ./run with the program of this build."""
    room.bring('scenes')
    room.make('outputs/gallery')
    with open(f'{room.source}/README.md', encoding='utf-8') as file:
        page = file.read()
    ran = 0
    for language, text in blocks(page):
        if language == 'python':
            done = subprocess.run([READER, '-c', text], cwd=room.folder,
                                  text=True, capture_output=True, check=False)
            expect((done.returncode, done.stderr) == (0, ''), text, done)
            ran += 1
        for line in text.splitlines() if language == 'sh' else []:
            if re.match(r'\./run (tests|bench)\b', line) or not line.strip():
                continue
            expect(line.startswith(('./run ', 'slipway ')), 'unknown:', line)
            done = room.shell(re.sub(r'^\./run', 'slipway', line))
            expect((done.returncode, done.stderr) == (0, ''), line, done)
            ran += 1
    expect(ran >= 7, ran)
    expect({'outputs/fig07b.h5', 'outputs/fig07b.svg',
            'outputs/gallery/fig07b.svg'} <= {
                f'{folder}/{name}' for folder in ('outputs', 'outputs/gallery')
                for name in room.names(folder)}, room.names('outputs'))


run_cases([
    help_names_every_command_with_an_example,
    every_command_explains_itself,
    every_example_works,
    options_are_explained_once_each,
    the_version_is_that_of_the_project,
    every_law_of_the_list_is_a_law,
    the_readme_does_what_it_says,
])
