#!/usr/bin/env python3
"""slipway simulate as users call it (TAP).

usage: cli_simulate.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import json
import math
import os
import random
import re
import subprocess

from cli_room import (READER, SLOPE, expect, expect_number, refused,
                      run_cases, shown)

START = ['--v', '1258.9254117941673', '--psi', '100']
KEYS = ['v', 'psi', 'fate', 'end', 'time', 'slip', 'mu_mean', 'energy_defect',
        'steps', 'field_evaluations', 'reason', 'phases', 'events']
REST = 0.8417232056933424, 0.4942932325338876
SCENE = '''law: {preset: spinodal_gen}
slope: {alpha: 0.34}
trajectories:
  starts: [{v: 1258.9254117941673, psi: 100}, {v: 4e3, psi: 10}]
  %s
output: {hdf5: a.h5}
'''
READ = '''
import h5py, numpy
with h5py.File('a.h5') as f:
    for k in (0, 1):
        g = f[f'trajectory_{k}']
        assert abs(g.attrs['energy_defect']) < 1e-10, g.attrs['energy_defect']
        for name in ('v', 'psi', 'slip', 'mu'):
            assert g[name].dims[0][0].name == g['time'].name, name
        assert set(g['events']) >= {'what', 'time', 'slip', 'v', 'psi', 'mu'}
        assert len(g['phases/n']) == 3
        print(k, g.attrs['end'].decode() if isinstance(g.attrs['end'], bytes)
              else g.attrs['end'], *sorted(n for n in g
              if n in ('linear_slip', 'log_time')))
    for name, axis in (('linear_slip', 'slip'), ('log_time', 'time')):
        if name in f['trajectory_0']:
            t = f['trajectory_0'][name]
            assert t['v'].dims[0][0].name == t[axis].name
            x = t[axis][...]
            step = numpy.diff(x if axis == 'slip' else numpy.log(x))
            assert numpy.ptp(step) < 1e-6 * abs(step).max(), step
            print(name, len(x))
'''


# States leap before a time that doubles hold, and fall in none at a rest.
LEAPS = (('psi', 'spinodal', 'spinodal', 346065.81, 0.0353),
         ('ln_c_psi', 'spinodal', 'slip45', 352.7, 2215.26),
         ('ln_psi', 'inverse', 'slip', 1.71e-08, 6.3137))
GROWS = '''
import h5py
with h5py.File('a.h5') as f:
    t = f['trajectory_0/time'][...]
    assert len(t) > 1000 and t[0] == 0 and (t[1:] > t[:-1]).all(), t
    print(len(t))
'''


def one_run(room, *args):
    found = room.json('simulate', *args)
    expect(list(found) == ['trajectories', 'units'], found)
    return found['trajectories'][0]


def a_start_on_the_command_line_is_run_to_its_end(room):
    run = one_run(room, *SLOPE, *START)
    expect(list(run) == KEYS, list(run))
    expect((run['fate'], run['end'], run['reason']) ==
           ('rest_finite', 'rest', None), run)
    for name, expected in zip(('time', 'slip'), REST):
        found = run[name]
        expect(abs(found['value'] - expected) < min(1e-12, found['error']),
               name, found)
    expect(abs(run['energy_defect']) < 1e-12, run)
    expect(room.names() == [], room.names())


def events_come_in_the_order_of_time(room):
    events = one_run(room, *SLOPE, *START)['events']
    times = [event['time']['value'] for event in events]
    expect(times == sorted(times) and len(times) > 10, times)
    names = [event['what'] for event in events]
    for name in ('v_sp', 'psi_minimum', 'mu_minimum', 'v_minus', 'rest',
                 'mu_nears_tan_alpha', 'mu_leaves_tan_alpha'):
        expect(name in names, name, names)


def people_read_the_same_numbers(room):
    said = room.good('simulate', *SLOPE, *START)
    run = one_run(room, *SLOPE, *START)
    expect(re.search(r' fate +rest_finite\n +end +rest\n', said), said)
    for name in ('time', 'slip', 'mu_mean'):
        expect_number(said, name, run[name])
    expect(room.good('simulate', *SLOPE, *START, '--quiet') == '', 'quiet')


def read_back(room, script=READ):
    done = subprocess.run([READER, '-c', script], cwd=room.path('.'), text=True,
                          capture_output=True, check=False)
    expect(done.returncode == 0, done.stderr)
    return done.stdout.splitlines()


def a_scene_fills_a_file(room):
    room.write('a.yaml', SCENE % 'seed: 1')
    room.good('study', 'a.yaml')
    expect(read_back(room) == ['0 arrest linear_slip log_time',
                               '1 arrest linear_slip log_time',
                               'linear_slip 201', 'log_time 201'],
           read_back(room))
    one = room.bytes('a.h5')
    room.good('study', 'a.yaml', '--threads', '1')
    expect(room.bytes('a.h5') == one, 'threads change the file')
    room.good('simulate', 'a.yaml', '-o', 'b.h5')
    expect(len(room.bytes('b.h5')) > len(one) / 2, 'simulate writes the same')


def times_grow_from_row_to_row(room):
    for theta, psi_ss, timescale, v, psi in LEAPS:
        room.good('simulate', '--alpha', '0.346', f'--v={v}', f'--psi={psi}',
                  f'--set=law.theta={theta}', f'--set=law.psi_ss={psi_ss}',
                  f'--set=law.timescale={timescale}',
                  '--set=law.kinetics=sinh', '-o', 'a.h5', '--quiet')
        read_back(room, GROWS)
        os.remove(room.path('a.h5'))


def a_scene_chooses_samples_and_limits(room):
    room.write('a.yaml', SCENE % 'until: {time: 1e6}\n'
               '  sample: {log_time: 30}')
    room.good('study', 'a.yaml', '--quiet')
    expect(read_back(room) == ['0 until_time log_time',
                               '1 until_time log_time', 'log_time 30'],
           read_back(room))
    run = one_run(room, 'a.yaml')
    expect(run['time'] == {'value': 1e6, 'error': run['time']['error']}, run)
    expect('arrest' in [event['what'] for event in run['events']], run)


def figures_show_friction_and_slip_rate(room):
    room.good('simulate', *SLOPE, *START, '--figure', 'a.svg')
    for name, words in (('a', ['friction coefficient', 'slip', 'tan α']),
                        ('a_slip', ['slip rate v', 'state ψ', 'slip']),
                        ('a_time', ['slip rate v', 'state ψ', 'time']),
                        ('a_friction', ['friction coefficient', 'time']),
                        ('a_position', ['slip x/L', 'time'])):
        svg = shown(room.read(name + '.svg'))
        expect(all(word in svg for word in [*words, 'ends of phases']), name)
    expect(len(room.names()) == 5, room.names())


def the_state_of_a_runaway_stays_within_its_axis(room):
    """psi falls to 1e-10 while v grows to 1e10."""
    room.good('simulate', '--law', 'dieterich', '--alpha', '0.34', '--v', '1e4',
              '--psi', '1e-2', '--figure', 'a.svg', '--keep-script')
    for name in ('a_slip.gp', 'a_time.gp'):
        low, high = re.search(r'set yrange \[(.*):(.*)\]',
                              room.read(name)).groups()
        expect(float(low) < 1.01e-10 and float(high) > 0.99e10, name, low, high)


def figures_of_the_paper_have_scenes(room):
    room.bring('scenes')
    room.make('outputs')
    for name, end in (('fig14', 'rest'), ('fig15', 'arrest')):
        run = one_run(room, f'scenes/{name}.yaml')
        expect(run['end'] == end, name, run['end'])
        expect(all(phase['end_time']['value'] is not None
                   for phase in run['phases']), name, run['phases'])


def study_runs_a_scene_that_only_has_starts(room):
    room.write('a.yaml', SCENE % 'seed: 1')
    expect(room.json('study', 'a.yaml') == room.json('simulate', 'a.yaml'),
           'same')
    expect(room.good('plan', 'a.yaml').startswith('simulate '), 'plan')
    for more in ('trajectories.spread=2', 'products=[trajectories]'):
        expect('equilibria' in room.json('study', 'a.yaml', '--set', more),
               more)


def wrong_starts_are_refused(room):
    for args, words in (
            ([], ['no start', 'trajectories.starts']),
            (['--v', '1'], ['--psi']),
            (['--psi', '1'], ['--v']),
            (['--v', 'x', '--psi', '1'], ['--v', 'number']),
            (['--v', '-1', '--psi', '1'], ['number > 0']),
            (['--states', 'a.csv'], ['--states'])):
        refused(room.run('simulate', *SLOPE, *args), 2, *words)
    expect(room.names() == [], room.names())


def a_folder_that_cannot_be_made_costs_nothing(room):
    for option in ('-o', '--figure'):
        refused(room.run('simulate', *SLOPE, *START, option, '/dev/null/a.svg'), 4,
                '/dev/null/a')


def an_orbit_that_gets_lost_exits_3_and_says_so(room):
    """An answer stays: what was found until then is printed and written."""
    count = 0
    for law, v, psi in (('ruina', '1e300', '700'), ('dieterich', '1e200', '1'),
                        ('spinodal', '1', '1e300'), ('perrin', '1e200', '1'),
                        ('dieterich_gen', '1e3', '10')):
        args = ['--law', law, '--alpha', '0.34', '--v', v, '--psi', psi]
        done = room.run('simulate', *args, '-o', 'a.h5')
        lost = bool(re.search(r' end +lost\n', done.stdout))
        expect(done.returncode == (3 if lost else 0), done)
        expect(re.fullmatch('slipway: run 0: lost: (the orbit cannot be followed '
                            'further|the orbit leaves the plane|it takes '
                            'longer than any number holds)\n',
                            done.stderr) if lost else done.stderr == '', done)
        expect(room.names() == ['a.h5'], room.names())
        os.remove(room.path('a.h5'))
        expect(room.run('simulate', *args, '--json').returncode
               == done.returncode, 'JSON ends otherwise')
        count += lost
    expect(0 < count < 5, 'none of these gets lost, or all do:', count)


FINITE = '''
import h5py, numpy
def look(name, item):
    if name.endswith('_error'):
        there = numpy.isfinite(item.parent[name[name.rfind('/') + 1:-6]][()])
        assert numpy.isfinite(item[()])[there].all(), name
        assert not numpy.isinf(item[()]).any(), name
with h5py.File('a.h5') as f:
    f.visititems(look)
'''


def refuse(word):
    raise ValueError(word)


def bars_in(found):
    """Of all numbers; none may be a word."""
    if isinstance(found, dict):
        if 'error' in found:
            yield found['error']
        for key in found:
            yield from bars_in(found[key])
    elif isinstance(found, list):
        for item in found:
            yield from bars_in(item)
    else:
        expect(found not in ('inf', '-inf', 'nan'), found)


def a_number_without_a_finite_bar_is_missing(room):
    seed = int(os.environ.get('CHECK_SEED', '0')) or random.randrange(1 << 32)
    draw = random.Random(seed)
    print(f'# CHECK_SEED={seed}')
    for law in ('dieterich', 'ruina', 'perrin', 'spinodal', 'dieterich_gen'):
        for _ in range(3):
            v, psi = 10 ** draw.uniform(-3, 5), 10 ** draw.uniform(-1, 2)
            args = ['--law', law, '--alpha', f'{draw.uniform(0.28, 0.36)}',
                    '--v', f'{v}', '--psi', f'{psi}']
            done = room.run('simulate', *args, '-o', 'a.h5', '--json')
            expect(done.returncode in (0, 3), done)
            found = json.loads(done.stdout, parse_constant=refuse)
            expect(all(math.isfinite(bar) and bar >= 0
                       for bar in bars_in(found)), args, found)
            done = room.run('simulate', *args)
            expect('+- inf' not in done.stdout and 'nan' not in done.stdout,
                   args, done.stdout)
            read = subprocess.run([READER, '-c', FINITE], cwd=room.path('.'),
                                  text=True, capture_output=True, check=False)
            expect(read.returncode == 0, args, read.stderr)


def a_figure_of_nothing_is_refused_before_any_file(room):
    saddle = room.json('knees', *SLOPE)['saddle']
    state = [f'--{name}={saddle[name]["value"]!r}' for name in ('v', 'psi')]
    done = room.run('simulate', *SLOPE, *state, '--figure', 'a.svg', '-o',
                    'a.h5')
    refused(done, 2, 'a.svg', 'no run has a length')
    expect(os.listdir(room.folder) == ['.bin'], os.listdir(room.folder))
    room.good('simulate', *SLOPE, *state, '-o', 'a.h5')


if __name__ == '__main__':
    run_cases([
        a_start_on_the_command_line_is_run_to_its_end,
        events_come_in_the_order_of_time,
        people_read_the_same_numbers,
        a_scene_fills_a_file,
        times_grow_from_row_to_row,
        a_scene_chooses_samples_and_limits,
        figures_show_friction_and_slip_rate,
        the_state_of_a_runaway_stays_within_its_axis,
        figures_of_the_paper_have_scenes,
        study_runs_a_scene_that_only_has_starts,
        wrong_starts_are_refused,
        an_orbit_that_gets_lost_exits_3_and_says_so,
        a_number_without_a_finite_bar_is_missing,
        a_folder_that_cannot_be_made_costs_nothing,
        a_figure_of_nothing_is_refused_before_any_file,
    ])
