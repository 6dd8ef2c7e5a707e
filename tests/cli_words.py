#!/usr/bin/env python3
"""What slipway's pages promise: help and README (TAP).

usage: cli_words.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import re
import subprocess

from cli_room import READER, SLOPE, expect, refused, run_cases

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
        expect(long == short and options_of(long), long)


# What takes half a minute is run, word for word, by a test of its own.
ELSEWHERE = {
    'slipway gallery -o outputs/gallery': ('cli_gallery.py', "'gallery'"),
    'slipway merge scenes/sweep.yaml -o outputs/sweep.h5':
        ('cli_ranks.py', "'merge', *sweep, '-o', 'a.h5'"),
    'slipway stress --quick': ('cli_stress.py', "'stress', '--quick', '--json'"),
}


def every_example_works(room):
    room.bring('scenes')
    room.make('outputs')
    examples = examples_of(room.good('help'))
    expect(set(ELSEWHERE) < set(examples), examples)
    for line in examples:
        if line in ELSEWHERE:
            script, words = ELSEWHERE[line]
            with open(room.script(script), encoding='utf-8') as file:
                expect(words in file.read(), line, script)
            continue
        done = room.shell(line)
        expect((done.returncode, done.stderr) == (0, ''), line, done)


def options_of(said):
    """(name, name of its value or '') of each."""
    return re.findall(r'^  (?:-\w, |    )(--[a-z-]+)(?:=(\S+))?', said, re.M)


def every_option_belongs_to_the_commands_that_tell_of_it(room):
    """The general page has them all; a command takes those of its own page and
    refuses the others, whatever else is right or wrong."""
    page = room.good('--help')
    known = set(options_of(page))
    expect(len(known) >= 25, known)
    told = set()
    for command in commands_of(page):
        own = options_of(room.good(command, '--help'))
        names = [name for name, _ in own]
        expect(len(names) == len(set(names)) and set(own) <= known, own)
        told |= set(own)
        for name, value in known:
            given = [name] + [VALUES.get(name, 'a.csv')] * (value != '')
            if name in names:
                done = room.run(command, 'none.yaml', *given, *['b'] * 70,
                                'c', 'd')
                expect('takes none' not in done.stderr, command, name, done)
                continue
            refused(room.run(command, *SLOPE * (command in WITH_SLOPE),
                             *given), 2, name, command)
            refused(room.run(*given, command), 2, name, command)
    expect(told == known and room.names() == [], known - told, room.names())


VALUES = {'--set': 'slope.alpha=0.3', '--threads': '1', '--progress': 'none',
          '--as': 'auto', '--form': 'time', '--law': 'ruina',
          '--alpha': '0.3', '--friction': 'log', '--rtol': '1e-9',
          '--seed': '1', '--v': '1', '--psi': '1'}
WITH_SLOPE = ('portrait', 'study', 'plan', 'knees', 'basin', 'push',
              'simulate', 'rabinowicz', 'export', 'workprec', 'stress')


def text_of_options_stands_in_a_column_of_its_own(room):
    for command in commands_of(room.good('--help')):
        said = room.good(command, '--help').split('Options:\n')[1]
        for line in said.split('\n'):
            name = re.match(r'  (?:-\w, |    )--[a-z-]+(?:=[A-Z:=/]+)?', line)
            if name:
                rest = line[name.end():]
                expect(rest == '' or len(line) - len(rest.lstrip()) == 26 and
                       rest[0] == ' ', line)
            expect(len(line) < 80, line)


def an_option_is_no_prefix_and_no_letter_of_another(room):
    for word in ('--sens', '--s', '--outputs=a.h5', '-x', '--', '-qx'):
        done = room.run('plan', *SLOPE, word)
        expect(done.returncode == (0 if word == '--' else 2), word, done)
    for words in (['-o', 'a.h5'], ['-oa.h5'], ['--output=a.h5'],
                  ['--output', 'a.h5']):
        expect('write         a.h5' in room.good('plan', *SLOPE, *words), words)
        expect(room.good('plan', *SLOPE, *words, '-q') == '', words)
        expect('write         a.h5' in room.good(*words, 'plan', *SLOPE), words)
    refused(room.run('plan', *SLOPE, '--', '-q'), 4, '-q')
    expect(room.names() == [], room.names())


def a_command_that_is_handed_a_scene_takes_its_own_options(room):
    """study hands sweeps, starts and experiments over."""
    room.bring('scenes')
    for scene, option in (('sweep', '--sensitivities'), ('fig14', '--exact'),
                          ('rabinowicz', '--exact'), ('sweep', '--resume')):
        refused(room.run('study', f'scenes/{scene}.yaml', option,
                         '--set', 'output={}'), 2, option, 'takes none')
    for command in ('push', 'export', 'gallery', 'check', 'info'):
        more = SLOPE if command in WITH_SLOPE else []
        done = room.run(command, *more, '--set', 'output.hdf5=a.h5')
        refused(done, 2, 'set')


def what_means_nothing_beside_another_is_refused(room):
    room.good('study', *SLOPE, '--set', 'products=[equilibria]', '-o', 'a.h5')
    for args in (['info', 'a.h5', '-q'], ['info', 'a.h5', '--threads', '1'],
                 ['info', 'a.h5', 'scene', '--json'],
                 ['info', 'a.h5', 'scene', '--rerun'],
                 ['check', '--record', *SLOPE, '--json'],
                 ['check', '--record', *SLOPE, '--tap'],
                 ['check', 'a.csv', '--json', '--tap'],
                 ['check', 'a.csv', '-o', 'b.csv'],
                 ['stress', '--json', '--tap', '--quick']):
        refused(room.run(*args), 2, args[0], '-')


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


def inputs_that_a_law_does_not_use_are_not_listed(room):
    """In JSON and, as numbers, in files."""
    inputs = {'mu_star', 'a', 'b', 'c', 'R', 'V_c', 'L', 'V_star', 'g'}
    for law in room.json('laws'):
        used = set(law['parameters']) | {'g'}
        more = ['--set', 'material.V_c=1e3'] if 'V_c' in used else []
        found = room.json('knees', '--law', law['name'], '--alpha', '0.34',
                          *more, '-o', 'a.h5')
        expect(set(found['parameters']) & inputs == used, law, found)
        listed = room.python("""import h5py, sys
print(*h5py.File("a.h5")["provenance"].attrs)""").stdout.split()
        expect(set(listed) & inputs == used, law, listed)


def no_decimal_is_longer_than_it_must_be(room):
    """Of all commands that tell numbers: 0.34, not 0.34000000000000002."""
    slope = ['--law', 'spinodal_gen', '--alpha', '0.34', '--set',
             'material.V_star=3e-7']
    state = ['--v', '1e3', '--psi', '0.3']
    sweep = 'sweep={key: slope.alpha, from: 0.3, to: 0.36, points: 5}'
    seen = 0
    for args in (['knees', *slope], ['knees', *slope, '--json'],
                 ['knees', *slope, '--json', '--set', 'units=si'],
                 ['push', *slope, *state, '--json'],
                 ['simulate', *slope, *state, '--json'],
                 ['sweep', *slope, '--set', sweep, '-o', '-'],
                 ['stress', '--only', 'field/perrin/log/0,1e-11'],
                 ['stress', '--only', 'field/perrin/log/0,1e-11', '--json'],
                 ['check', '--record', *slope],
                 ['export', *slope, '--as', 'xppaut', '-o', '-'],
                 ['workprec', '--quick', *slope, '--json']):
        said = room.run(*args).stdout
        for text in re.findall(r'(?<![\w.])\d+\.\d+(?:e[-+]?\d+)?', said):
            seen += 1
            digits = re.sub(r'e.*|\.', '', text).strip('0')
            least = re.sub(r'e.*|\.', '', repr(float(text))).strip('0')
            expect(len(digits) <= len(least), args, text)
    expect(seen > 500, seen)


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
    every_option_belongs_to_the_commands_that_tell_of_it,
    text_of_options_stands_in_a_column_of_its_own,
    an_option_is_no_prefix_and_no_letter_of_another,
    a_command_that_is_handed_a_scene_takes_its_own_options,
    what_means_nothing_beside_another_is_refused,
    the_version_is_that_of_the_project,
    every_law_of_the_list_is_a_law,
    inputs_that_a_law_does_not_use_are_not_listed,
    no_decimal_is_longer_than_it_must_be,
    the_readme_does_what_it_says,
])
