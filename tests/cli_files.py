#!/usr/bin/env python3
"""The HDF5 files that slipway writes, and slipway info (TAP).

usage: cli_files.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import csv
import glob
import io
import os
import re
import socket
import time

from cli_room import LAWS, READER, SLOPE, expect, refused, run_cases

SCENE = '''# a comment, and an odd   blank
title: "b \\"q\\" \\u03b1"
law: {preset: spinodal_gen}
slope: {alpha: 0.34}
products: [equilibria, nullclines, manifolds, trajectories, knees, estimates]
trajectories: {starts: [{v: 1258.9, psi: 100}], spread: 6, seed: 1}
output: {hdf5: out.h5, figure: out.svg}
'''


# ---- readers -----------------------------------------------------------------

def every_reader_opens_a_portrait(room):
    room.write('a.yaml', SCENE)
    room.good('portrait', 'a.yaml')
    room.reads('open_file.py', 'out.h5')
    room.reads('read_file.py', 'layout', 'out.h5')


def every_reader_opens_a_portrait_without_a_saddle(room):
    room.good('portrait', '--law', 'ruina', '--alpha', '1.5', '-o', 'a.h5',
              '--set', 'products=[equilibria, knees, estimates, nullclines, '
              'manifolds, field_arrows]')
    room.reads('open_file.py', 'a.h5')


def exact_points_lie_on_the_stored_curve(room):
    """By cubic interpolation with the stored slopes, to a millionth."""
    slopes = {}
    for row in room.reference('manifold_points.csv'):
        slopes.setdefault((row['law'], row['alpha']), []).append(row)
    met = listed = 0
    for (law, alpha), rows in slopes.items():
        room.write('points.csv', 'branch,v,psi\n' + ''.join(
            f'{row["branch"]},{row["v"]},{row["psi"]}\n' for row in rows))
        room.good('study', '--law', law, '--alpha', alpha, '-o', 'a.h5',
                  '--set', 'products=[manifolds]', '--set',
                  'window={v: [1e-4, 1e6], psi: [1e-18, 1e6]}')
        met += int(room.reads('read_file.py', 'curve', 'a.h5', 'points.csv'))
        listed += len(rows)
    expect(met == listed == 280, met, 'of', listed)


# ---- the same bytes ----------------------------------------------------------

def the_same_bytes_from_anywhere_at_any_time(room):
    room.write('a.yaml', SCENE)
    room.good('portrait', 'a.yaml')
    wanted = room.bytes('out.h5'), room.bytes('out.svg')
    time.sleep(1.1)  # HDF5 counts in seconds
    for folder, args, changes in (
            ('b', [], {}),
            ('c/d e', ['--threads', '1'], {'TZ': 'Asia/Tokyo'}),
            ('f', ['--threads', '2'], {'LC_ALL': 'C', 'HOME': '/nonexistent'}),
            ('g', ['--quiet'], {'OMP_NUM_THREADS': '3', 'TZ': 'UTC+11'}),
            ('h', ['--json', '--progress', 'none'], {'LANG': 'de_DE.UTF-8'})):
        room.make(folder)
        name = os.path.join(folder, 'a.yaml')
        room.write(name, SCENE)
        os.utime(room.path(name), (1e9, 1e9))
        room.good('portrait', 'a.yaml', *args, cwd=folder, **changes)
        expect(room.bytes(folder + '/out.h5') == wanted[0], folder, 'HDF5')
        expect(room.bytes(folder + '/out.svg') == wanted[1], folder, 'figure')
    room.make('away')
    room.good('study', room.path('a.yaml'), '-o', room.path('away/other.h5'),
              '--figure', 'other.svg', cwd='b')
    expect(room.bytes('away/other.h5') == wanted[0], 'another name')


def the_file_tells_nothing_of_where_it_was_made(room):
    room.write('a.yaml', SCENE)
    room.good('study', 'a.yaml', '-o', room.path('there.h5'), '--set',
              'slope.alpha=0.35', '--threads', '2')
    found = room.bytes('there.h5')
    expect(SCENE.encode() in found and b'slope.alpha=0.35\n' in found, 'scene')
    for secret in (room.folder, room.source, 'there.h5', 'threads',
                   socket.gethostname(), time.strftime('%Y-%m')):
        expect(len(secret) < 4 or secret.encode() not in found, secret)


# ---- info --------------------------------------------------------------------

def info_says_what_the_file_holds(room):
    room.write('a.yaml', SCENE)
    room.good('portrait', 'a.yaml')
    lines = room.good('info', 'out.h5').splitlines()
    for group in ('/', '/provenance', '/equilibria', '/saddle',
                  '/manifold/stable_upper', '/manifold/unstable_lower',
                  '/critical', '/estimates', '/nullcline/v_0', '/trajectory_0'):
        expect(group in lines, group, lines)
    expect(any(line.split()[:3] == ['v', '3', '1'] and 'V_star' in line
               for line in lines), lines)
    expect('  law                    spinodal_gen' in lines, lines)
    items = {item['path']: item for item in room.json('info', 'out.h5')}
    expect(items['/equilibria/v']['shape'] == [3]
           and items['/equilibria/v']['kind'] == 'dataset'
           and items['/provenance']['texts']['scene'] == SCENE
           and items['/']['texts']['title'] == 'b "q" α', items['/'])


def info_says_why_a_number_is_missing(room):
    room.good('knees', '--law', 'ruina', '--alpha', '0.34', '-o', 'a.h5')
    expect('upper branch is open' in room.good('info', 'a.h5'), 'no reason')


def the_printed_scene_gives_the_same_bytes(room):
    room.write('a.yaml', SCENE)
    room.good('portrait', 'a.yaml')
    expect(room.good('info', 'out.h5', 'scene') == SCENE, 'another scene')
    room.make('again')
    room.write('again/a.yaml', room.good('info', 'out.h5', 'scene'))
    room.good('study', 'a.yaml', cwd='again')
    expect(room.bytes('again/out.h5') == room.bytes('out.h5'), 'other bytes')


TITLE = 'T: #1 \'q\' "r" % {s} [t] \\n \u00e9\u4e16\U0001f600 - ? ! & *'


def overrides_and_shortcuts_are_part_of_the_printed_scene(room):
    room.write('a.yaml', SCENE)
    quoted = TITLE.replace("'", "''")
    for command, args in (
            ('portrait', ['a.yaml', '--alpha', '0.35', '--set',
                          f"title='{quoted}'", '--set', 'material.a=0.03',
                          '--set', 'products=[manifolds]']),
            ('portrait', [*SLOPE]),
            ('portrait', ['--law', 'ruina', '--set', 'slope.alpha_deg=19.5',
                          '--seed', '7', '--set',
                          'trajectories.starts=[{v: 2, psi: -3}]']),
            ('knees', ['--set', 'law={theta: psi, psi_ss: minus_log, '
                       'timescale: slip45, kinetics: sinh, friction: log}',
                       '--set', 'slope.tan_alpha=0.36', '--rtol', '1e-9'])):
        room.good(command, *args, '-o', 'a.h5', '--figure', 'a.svg')
        scene = room.good('info', 'a.h5', 'scene')
        room.write('b.yaml', scene)
        expect('a.h5' not in scene and 'a.svg' not in scene, scene)
        room.good('study', 'b.yaml', '-o', 'b.h5', '--figure', 'b.svg')
        room.reads('read_file.py', 'same', 'a.h5', 'b.h5')
        expect(room.bytes('a.svg') == room.bytes('b.svg'), args, 'figure')
        expect(room.good('info', 'b.h5', 'scene') == scene, scene)
        if TITLE[:3] in str(args):
            texts = room.json('info', 'b.h5')[0]['texts']
            expect(texts['title'] == TITLE, texts)


def every_law_is_written_and_read(room):
    for law in LAWS + ['kato_tullis']:
        more = ['--set', 'material.V_c=1e3'] if law == 'kato_tullis' else []
        room.good('study', '--law', law, '--alpha', '0.34', *more, '-o',
                  'a.h5')
        expect('  law                    ' + law
               in room.good('info', 'a.h5').splitlines(), law)


QUESTIONS = {
    'knees': [], 'plan': [], 'push': ['--v', '1e3', '--psi', '10'],
    'simulate': [], 'rabinowicz': [], 'workprec': ['--quick'],
    'check': ['--record'], 'export': ['--as', 'xppaut', '-o', 'a.ode']}


COMMANDS = {'fig08': 'rabinowicz', 'rabinowicz': 'rabinowicz',
            'fig14': 'simulate', 'fig15': 'simulate'}


# Where e^x of an offset from the anchor, a ratio of times, or a slope is no
# double.
FAR = {
    'far_state': ['study', '--law', 'kato_tullis', '--friction', 'log',
                  '--alpha', '0.31', '--set', 'material.V_c=78', '--set',
                  'material.mu_star=0.596', '--set',
                  'products=[manifolds]'],
    'far_times': ['simulate', '--law', 'spinodal_gen', '--friction', 'log',
                  '--set', 'slope.tan_alpha=2.11', '--set', 'gravity=0.0302',
                  '--set', 'material.b=0.0389', '--v', '5.8e-8', '--psi',
                  '840'],
    'vertical': ['study', '--ode', "u' = u - u^2; w' = atan(u - w)",
                 '--window', 'u=-0.5:7,w=-2:2.5']}


def numbers_are_finite_or_declared_missing(room):
    made = []
    for name, args in FAR.items():
        room.good(*args, '-o', name + '.h5')
        made.append(name + '.h5')
    os.mkdir(room.path('outputs'))
    os.symlink(room.source + '/scenes', room.path('scenes'))
    for path in sorted(glob.glob(room.source + '/scenes/*.yaml')):
        name = os.path.basename(path)[:-5]
        with open(path, encoding='utf-8') as file:
            text = file.read()
        swept = re.search('^sweep:', text, re.M)
        small = ['--set', 'basins.cells=[40, 30]', '--set', 'basins.audit=0']
        room.good(COMMANDS.get(name, 'sweep' if swept else 'study'), path,
                  '-q', '-o', name + '.h5',
                  *(small if re.search('^basins:', text, re.M) else []))
        made.append(name + '.h5')
    expect(len(made) > 25, made)
    expect(int(room.reads('walk_floats.py', *made)) > 500, made)


def names_of_many_runs_sort_as_their_numbers(room):
    room.good('portrait', *SLOPE, '-q', '-o', 'a.h5', '--set',
              'products=[trajectories]', '--set', 'trajectories.starts=[' +
              ', '.join(f'{{v: {v}, psi: 10}}' for v in range(1, 13)) + ']')
    done = room.shell(f'{READER} -c "import h5py; '
                      'f = h5py.File(\'a.h5\'); '
                      'print(*[n for n in sorted(f) if \'traj\' in n])"')
    expect(done.stdout.split() == [f'trajectory_{k:02}' for k in range(12)],
           done)


def a_question_writes_only_what_it_is_told_to(room):
    """The scene's output is for portrait, study, basin and sweep."""
    room.write('a.yaml', '''law: {preset: dieterich_gen}
slope: {alpha: 0.34}
products: [equilibria, basins]
basins: {cells: [8, 8], audit: 4}
trajectories: {starts: [{v: 1e3, psi: 10}]}
rabinowicz: {block_mass: 0.3, ball_mass: 0.1, restitution: 0.5}
output: {hdf5: a.h5, figure: a.svg}
''')
    for name in ('a.h5', 'a.svg'):
        room.write(name, 'precious')
    for command, more in QUESTIONS.items():
        said = room.good(command, 'a.yaml', *more)
        expect(command == 'export' or 'wrote' not in said, command, said)
        made = ['a.ode'] if command == 'export' else []
        expect(room.names() == sorted(['a.h5', 'a.svg', 'a.yaml', *made])
               and room.read('a.h5') == room.read('a.svg') == 'precious',
               command, room.names())
    os.remove(room.path('a.ode'))
    for command in ('knees', 'simulate', 'rabinowicz'):
        for option in (['-o', 'b.h5'], ['--set', 'output.hdf5=b.h5'],
                       ['--set', 'output={hdf5: b.h5}']):
            room.good(command, 'a.yaml', *option)
            expect(room.names() == ['a.h5', 'a.svg', 'a.yaml', 'b.h5'],
                   command, option, room.names())
            os.remove(room.path('b.h5'))
    room.good('knees', 'a.yaml', '--figure', 'b.svg')
    expect(room.names() == ['a.h5', 'a.svg', 'a.yaml', 'b.svg'], room.names())
    expect(room.read('a.h5') == room.read('a.svg') == 'precious', 'written')
    for command in ('portrait', 'study', 'basin'):
        room.good(command, 'a.yaml')
        expect(room.read('a.svg') != 'precious' != room.bytes('a.h5')[:8],
               command)
        room.write('a.svg', 'precious')


def what_is_read_is_not_written_over(room):
    files = {'a.yaml': 'law: {preset: dieterich_gen}\nslope: {alpha: 0.34}\n',
             's.csv': 'v,psi\n1,2\n', 'd.csv': 'tan_alpha,l_k\n0.7,1e-3\n',
             'm.ode': "x'=-x\ny'=-y\ndone\n"}
    for name, text in files.items():
        room.write(name, text)
    os.symlink('a.yaml', room.path('b.h5'))
    for args in (['knees', 'a.yaml', '-o', 'a.yaml'],
                 ['portrait', 'a.yaml', '-o', './a.yaml'],
                 ['knees', 'a.yaml', '-o', 'b.h5'],
                 ['check', '--record', 'a.yaml', '-o', 'a.yaml'],
                 ['push', 'a.yaml', '--states', 's.csv', '-o', 's.csv'],
                 ['rabinowicz', 'a.yaml', '--data', 'd.csv', '-o', 'd.csv'],
                 ['import', 'm.ode', '-o', 'm.ode']):
        refused(room.run(*args), 2, args[-1], 'is read')
    expect(all(room.read(name) == text for name, text in files.items()),
           room.names())


def a_sweep_is_csv_on_standard_output(room):
    """The numbers of its JSON, named and with their units."""
    for units in ('dimensionless', 'si'):
        args = ['sweep', '--law', 'spinodal_gen', '--set', f'units={units}',
                '--set', 'sweep={key: slope.alpha, from: '
                '0.28, to: 0.36, points: 3}', '--set', 'products=[knees, '
                'trajectories]', '--set',
                'trajectories.starts=[{v: 1000 V_star, phi: 0.1}, {v: '
                '1 V_star, phi: 0.1}]']
        found = room.json(*args)
        rows = list(csv.DictReader(io.StringIO(room.good(*args, '-o', '-'))))
        expect(len(rows) == 3 and room.names() == [], room.names())
        expect([float(row['alpha [rad]']) for row in rows] ==
               found['keys'][0]['values'], rows)
        for name, start in (('v_plus', None), ('saddle_phi' if units == 'si'
                                               else 'saddle_psi', None),
                            ('trajectory_time', 0), ('trajectory_time', 1)):
            told = name if start is None else f'{name}_{start}'
            unit = found['units']['numbers'].get(name)
            behind = f' [{unit}]' if unit else ''
            for i, row in enumerate(rows):
                for part, of in (('', 'value'), ('_error', 'error')):
                    x = found['numbers'][name][of][i]
                    x = x if start is None else x[start]
                    text = row[told + part + behind]
                    expect((float(text) if text else None) == x, name, row)
        expect([row['trajectory_fate_1'] for row in rows] == [
            x[1] for x in found['numbers']['trajectory_fate']['value']], rows)
        expect('no saddle' in rows[0]['v_plus_reason'] and
               rows[1]['v_plus_reason'] == '', rows)


run_cases([
    a_sweep_is_csv_on_standard_output,
    numbers_are_finite_or_declared_missing,
    names_of_many_runs_sort_as_their_numbers,
    a_question_writes_only_what_it_is_told_to,
    what_is_read_is_not_written_over,
    every_reader_opens_a_portrait,
    every_reader_opens_a_portrait_without_a_saddle,
    exact_points_lie_on_the_stored_curve,
    the_same_bytes_from_anywhere_at_any_time,
    the_file_tells_nothing_of_where_it_was_made,
    info_says_what_the_file_holds,
    info_says_why_a_number_is_missing,
    the_printed_scene_gives_the_same_bytes,
    overrides_and_shortcuts_are_part_of_the_printed_scene,
    every_law_is_written_and_read,
])
