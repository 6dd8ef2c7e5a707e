#!/usr/bin/env python3
"""slipway stress as users call it (TAP).

usage: cli_stress.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import json
import re
import subprocess

from cli_room import READER, SLOPE, expect, refused, run_cases

# What a case says of itself.
KEYS = ['name', 'law', 'form', 'parameters', 'outcome', 'digits', 'steps',
        'seconds', 'agree', 'reason']
OUTCOMES = ['exact', 'degraded', 'none', 'failed', 'lie']
FEW = ['--only', 'eps2/dieterich_gen/log/1e-09']
SCENE = 'title: my block\nlaw: {preset: spinodal_gen}\nslope: {alpha: 0.35}\n'


def the_quick_catalogue_has_no_lie(room):
    done = room.run('stress', '--quick', '--json', '-o', 'a.h5')
    expect((done.returncode, done.stderr) == (0, ''), done)
    found = json.loads(done.stdout)
    cases = found['cases']
    expect(20 <= len(cases) <= 80, len(cases))
    expect(sum(case['kind'] == 'field' for case in cases) >= 10, cases)
    for case in cases:
        expect(all(key in case for key in KEYS), case)
        expect(case['outcome'] in OUTCOMES and case['outcome'] != 'lie', case)
        expect((case['reason'] is None) == (case['outcome'] == 'exact'), case)
        if case['outcome'] == 'exact' and case['digits'] is not None:
            expect(case['bar'] <= 1 and case['missing'] <= 2, case)
        expect('alpha' in case['parameters'] and 'a' in case['parameters'],
               case)
    count = {word: sum(case['outcome'] == word for case in cases)
             for word in OUTCOMES}
    expect(all(found['outcomes'][word] == count[word] for word in OUTCOMES),
           found['outcomes'], count)
    expect(found['outcomes']['full'] >= 0.9 * found['outcomes']['counted'] > 9,
           found['outcomes'])
    script = (
        'import h5py, json\n'
        'f = h5py.File("a.h5")["stress"]\n'
        'print(json.dumps([[name.decode() for name in f["name"][()]],'
        ' f["steps"][()].tolist(), f["outcome"][()].tolist(),'
        ' int(f.attrs["lie"])]))\n')
    read = subprocess.run([READER, '-c', script], cwd=room.folder, text=True,
                          capture_output=True, check=False)
    expect(read.returncode == 0, read)
    expect(json.loads(read.stdout) ==
           [[case['name'] for case in cases], [case['steps'] for case in cases],
            [OUTCOMES.index(case['outcome']) for case in cases], 0], read)


def a_system_is_held_to_113_bits_with_its_and_other_parameters(room):
    ode = ['--ode', "x' = a*x*(3 - x - 2*y); y' = y*(2 - x - y); a = 1; b = 7; w = b*x",
           '--window', 'x=-1:4,y=-1:3']
    found = json.loads(room.good('stress', '--quick', *ode, '--json'))
    cases = found['cases']
    expect(len(cases) == 4 and
           all((case['kind'], case['law'], case['outcome'], case['reason']) ==
               ('system', 'system', 'exact', None) for case in cases), cases)
    expect(all(case['bar'] <= 1 and case['digits'] > 12 and case['steps'] > 20
               for case in cases), cases)
    expect(cases[0]['parameters'] == {'a': 1, 'b': 7}, cases[0])
    expect(all(2 / 3 < case['parameters']['a'] < 3 / 2 and
               case['parameters']['b'] == 7 for case in cases[1:]), cases)
    said = room.good('stress', '--quick', *ode).splitlines()[-1]
    expect(re.fullmatch(r'held to 113 bits: the worst error is [0-9.e-]+ of its bar',
                        said), said)


def a_pattern_picks_cases_and_the_table_says_how_to_repeat_them(room):
    said = room.good('stress', *FEW)
    names = re.findall(r'^eps2/dieterich_gen/log/1e-09/\S+', said, re.M)
    expect(len(names) == 3 and '3 cases:' in said and '3 of 3' in said, said)
    said = room.good('stress', '--only', 'far/dieterich_gen/asinh/1e-06/-300')
    options = re.search(r"^    (--set .*)$", said, re.M).group(1)
    done = room.shell('slipway knees ' + options)
    reason = 'no bound on its error could be found'
    expect(done.returncode == 0 and reason in done.stdout, done)
    expect('1 degraded' in said and reason in said, said)


def fields_are_looked_at_beside_the_saddle(room):
    said = room.good('stress', '--only', 'field/perrin/log/0,1e-08')
    expect('1 exact' in said and re.search(r' 4 +\S+ +\S+ - ', said), said)
    options = room.json('stress', '--only', 'field/perrin/log/0,1e-08')[
        'cases'][0]['settings']
    done = room.shell('slipway basin ' + options + ' -o a.h5')
    expect(done.returncode == 0 and 'slip time mu_mean v_peak' in done.stdout,
           done)
    room.write('field.yaml', SCENE + 'products: [time]\n'
               'basins: {cells: [4, 4]}\n')
    found = room.json('stress', 'field.yaml', '--only', 'my block')['cases'][0]
    expect(found['kind'] == 'field' and found['steps'] == 16 and
           found['outcome'] == 'exact' and found['bar'] <= 1, found)


def each_case_is_a_test_of_tap(room):
    said = room.good('stress', '--tap', *FEW).splitlines()
    expect(said[0] == '1..3', said)
    expect(sum(line.startswith('ok ') for line in said) == 3, said)


def a_scene_is_one_more_case(room):
    room.write('mine.yaml', SCENE)
    found = room.json('stress', 'mine.yaml', '--only', 'my block')['cases']
    expect([case['name'] for case in found] == ['my block'], found)
    expect(found[0]['law'] == 'spinodal_gen' and
           found[0]['parameters']['alpha'] == 0.35 and
           found[0]['outcome'] in ('exact', 'degraded'), found)
    room.write('start.yaml', SCENE +
               'trajectories: {starts: [{v: 1.0, psi: 1.0e6}]}\n')
    found = room.json('stress', 'start.yaml', '--only', 'my block')['cases']
    expect(found[0]['kind'] == 'start' and found[0]['outcome'] == 'exact',
           found)
    found = room.json('stress', *SLOPE, '--rtol', '1e-14', '--only',
                      'command line')['cases']
    expect(len(found) == 1 and found[0]['outcome'] == 'exact', found)


def wrong_uses_are_refused(room):
    room.write('mine.yaml', SCENE)
    refused(room.run('stress', '--only', 'no such case'), 2, '--only',
            'no such case')
    refused(room.run('stress', '--rtol', '1e-6'), 2, 'accuracy.rtol=1e-6')
    refused(room.run('stress', 'mine.yaml', '--figure', 'a.svg'), 2, 'figure')
    refused(room.run('stress', 'mine.yaml', 'mine.yaml'), 2, 'mine.yaml')
    refused(room.run('stress', 'none.yaml'), 4, 'none.yaml')
    refused(room.run('stress', '-o', '/dev/null/a.h5', *FEW), 4,
            '/dev/null/a.h5')


run_cases([
    the_quick_catalogue_has_no_lie,
    a_pattern_picks_cases_and_the_table_says_how_to_repeat_them,
    fields_are_looked_at_beside_the_saddle,
    each_case_is_a_test_of_tap,
    a_scene_is_one_more_case,
    a_system_is_held_to_113_bits_with_its_and_other_parameters,
    wrong_uses_are_refused,
])
