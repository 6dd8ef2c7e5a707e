#!/usr/bin/env python3
"""Every number of a scene and of its twin beside `units: si` (TAP): JSON,
sweeps, columns of CSV, data sets of files.

usage: cli_twins.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import csv
import io
import json
import math
import re

from cli_room import expect, run_cases
from twins import (COMMANDS, FACTOR, PHI, SMALL, SWEEP, Twins, pair, scene,
                   state_of, sweep_member)


def every_number_of_json_is_that_of_the_twin(room):
    for law in PHI:
        for command in COMMANDS:
            own, si = pair(room, law, command)
            twins = Twins(law)
            own, si = room.json(*own), room.json(*si)
            twins.walk(f'{law} {command[0]}', own, si, own['units'],
                       si['units'])
            expect(twins.told > 5 or command[0] == 'push', law, command,
                   twins.told, twins.compared)


def every_number_of_a_sweep_is_that_of_the_twin(room):
    more = ['--set', SWEEP, '--set', 'products=[equilibria, folds, knees, '
            'estimates, trajectories, basins, slip, chi]', '--set',
            'trajectories.starts=[{v: 1000 V_star, phi: 0.1}]',
            '--set', 'basins.cells=[4, 4]', '--set', 'basins.audit=0']
    for law, (_, s, _) in PHI.items():
        found, text = [], []
        for name, units in (('own', ''), ('si', 'units: si\n')):
            room.write(f'{name}.yaml', scene(law, units))
            found.append(room.json('sweep', f'{name}.yaml', *more, '-o',
                                   f'{name}.h5'))
            text.append(room.good('sweep', f'{name}.yaml', '--set', SWEEP,
                                  *more[4:6], '--set',
                                  'products=[trajectories]'))
        twins = Twins(law)
        own, si = found
        for part in ('numbers', 'starts', 'maps'):
            units = own['units'][part], si['units'][part]
            rows = zip(*([j[part]] if isinstance(j[part], dict) else j[part]
                         for j in found))
            for a, b in rows:
                expect(len(a) == len(b) > 1, law, part)
                for name, value in a.items():
                    sweep_member(twins, law, name, value, b, *units)
        for name, dim in own['dims'].items():
            unit = dim['unit']
            if name.endswith('psi'):
                unit = s
                made = state_of(law)
            else:
                _, unit, made = twins.unit(name, unit)
            told = si['dims'][name.replace('psi', 'phi')]
            expect(told['unit'] == (unit or '1'), name, dim, told)
            twins.numbers(name, made, dim['values'], told['values'])
        expect(own['keys'] == si['keys'], own['keys'], si['keys'])
        expect(twins.told > 60, law, twins.told, twins.compared)
        expect('time (s)' in text[1] and 'time (L/V_star)' in text[0] and
               'V_star' not in text[1], law, text)


HEAD = re.compile(r'(.*?)(?: \[(.*)\])?')


def cell(text):
    try:
        return float(text)
    except ValueError:
        return text or None


def table_of(text):
    """Of CSV: the parts of each number by its name, and its unit."""
    rows = list(csv.reader(io.StringIO(text)))
    table, units = {}, {}
    for k, head in enumerate(rows[0]):
        name, unit = HEAD.fullmatch(head).groups()
        base, _, part = name.rpartition('_')
        if part not in ('error', 'reason') or base not in table:
            base, part = name, 'value'
            units.update({name: unit} if unit else {})
        else:
            expect(part == 'reason' or unit == units.get(base), head, units)
        table.setdefault(base, {})[part] = [cell(row[k]) for row in rows[1:]]
    return table, units


def same_tables(law, own, si):
    """How many columns, and how many numbers are others in the SI."""
    twins = Twins(law)
    (own, units), (si, told) = table_of(own), table_of(si)
    expect(len(own) == len(si), sorted(own), sorted(si))
    for name, column in own.items():
        sweep_member(twins, law, name, column, si, units, told)
    return len(own), twins.told


def every_column_of_a_sweep_s_csv_is_that_of_the_twin(room):
    for law in PHI:
        for key in (SWEEP, 'sweep={key: material.a, values: [0.02, 0.03]}'):
            text = []
            for units in ('', 'units: si\n'):
                room.write('a.yaml', scene(law, units))
                text.append(room.good('sweep', 'a.yaml', '-q', '--set', key,
                                      '--set', 'products=[equilibria, folds, '
                                      'knees, estimates, sensitivities]',
                                      '-o', '-'))
            columns, told = same_tables(law, *text)
            expect(columns > 40 and told > 20, law, columns, told)


def every_column_of_a_table_of_pushes_is_that_of_the_twin(room):
    for law, (_, s, _) in PHI.items():
        text, made = [], state_of(law)
        for units in ('', 'units: si\n'):
            room.write('a.yaml', scene(law, units))
            head = 'psi' if not units else 'phi'
            room.write('s.csv', f'id,v [V_star],{head}\n' + ''.join(
                f'{k},{v},{made(psi) if units else psi!r}\n' for k, (v, psi)
                in enumerate([(1e3, 1.5), (1, 1.5), (1e5, 0.1)])))
            text.append(room.good('push', 'a.yaml', '--states', 's.csv', '-o',
                                  '-'))
        columns, told = same_tables(law, *text)
        expect(columns == 9 and told > 5, law, columns, told)


def slopes_of_a_sweep_s_csv_are_as_they_were_given(room):
    """In degrees, or their tangents, which have no unit; the key's, or those of
    the scene's slope."""
    how = {'alpha': ('rad', 1, 0.34),
           'alpha_deg': ('degree', 180 / math.pi, 19),
           'tan_alpha': (None, None, 0.35)}
    for key, (unit, factor, at) in how.items():
        swept = [f'{{key: slope.{key}, values: [{at}]}}',
                 '{key: material.a, values: [0.03]}']
        for sweep in swept:
            text = room.good('sweep', '--law', 'dieterich_gen', '--set',
                             f'slope.{key}={at}', '-q', '--set',
                             f'sweep={sweep}', '-o', '-', '--set',
                             'products=[folds, estimates, knees]')
            table, units = table_of(text)
            name = 'tan_alpha_f' if factor is None else 'alpha_f'
            tan = table['estimates_tan_alpha_f']['value'][0]
            given = table['estimates_' + name]['value'][0]
            expect(units.get('estimates_' + name) == unit, units)
            expect(abs(given - (math.atan(tan) * factor if factor else tan))
                   <= 1e-14 * given, given, tan)
            for fold in ('alpha_cm', 'alpha_cM', 'alpha_cusp'):
                fold = 'folds_' + ('' if factor else 'tan_') + fold
                expect(fold in table and units.get(fold) == unit, fold, units)


# What a file of the SI holds: the same numbers, data set by data set, and by
# `scale` those that JSON tells.
FILES = """
import json, math, sys
import h5py

def items(file):
    found = {}
    file.visititems(lambda name, item: found.update({name: item}))
    return found

def plain(value):
    return value.tolist() if hasattr(value, 'tolist') else value

own, si = (items(h5py.File(name)) for name in sys.argv[1:3])
assert own.keys() == si.keys(), set(own) ^ set(si)
sets = 0
for name, item in own.items():
    for key in {*item.attrs} | {*si[name].attrs}:
        a, b = item.attrs.get(key), si[name].attrs.get(key)
        assert 'REFERENCE' in key or 'DIMENSION' in key or \
            name.startswith('provenance') or repr(a) == repr(b), (name, key)
    if isinstance(item, h5py.Dataset) and not name.startswith('provenance'):
        sets += 1
        assert repr(plain(item[()])) == repr(plain(si[name][()])), name
        assert item.dtype == si[name].dtype and item.shape == si[name].shape
told, compared = json.load(open(sys.argv[3])), 0
factor = dict(json.loads(sys.argv[4]))
for name, number in told.items():
    item = si.get('critical/' + name)
    if item is None or not isinstance(number, dict) or 'value' not in number:
        continue
    scale = item.attrs.get('scale')
    x = plain(item[()])
    if number['value'] is None or scale is None:
        continue
    f = factor[scale.decode()]
    assert si['critical/' + name + '_error'].attrs['scale'] == scale, name
    assert abs(f * x - number['value']) <= 1e-15 * abs(f * x), name
    compared += 1
print(sets, compared)
"""
STAGES = [
    ['study', '--set', 'products=[equilibria, folds, nullclines, field_arrows, '
     'manifolds, knees, estimates, sensitivities, trajectories, basins, margin, '
     'slip, time, friction, peak, taylor_series, friction_law, spring_block, '
     'bifurcation, fold_curves, chi]', *SMALL],
    ['sweep', '--set', SWEEP, '--set', 'products=[equilibria, folds, knees, '
     'estimates, trajectories, basins, slip]', *SMALL],
    ['simulate'],
]


def every_data_set_of_a_file_is_that_of_the_twin(room):
    factor = json.dumps({own: value for own, (_, value) in FACTOR.items()})
    for law, (_, _, is_log) in PHI.items():
        psi = 0 if is_log else 1.5  # read back as it is
        for args in STAGES:
            for name, units, state in (
                    ('own', '', f'psi: {psi}'), ('si', 'units: si\n',
                                                 f'phi: {state_of(law)(psi)}')):
                room.write('a.yaml', scene(law, units))
                told = room.json(args[0], 'a.yaml', *args[1:], '--set',
                                 'trajectories.starts=[{v: 100 V_star, '
                                 f'{state}}}]', '-o', f'{name}.h5')
            room.write('told.json', json.dumps(told))
            sets, compared = map(int, room.reads(
                FILES, room.path('own.h5'), room.path('si.h5'),
                room.path('told.json'), factor).split())
            expect(sets > 20 and (compared > 0) == (args[0] == 'study'), law,
                   args, sets, compared)


run_cases([
    every_number_of_json_is_that_of_the_twin,
    every_number_of_a_sweep_is_that_of_the_twin,
    every_column_of_a_sweep_s_csv_is_that_of_the_twin,
    every_column_of_a_table_of_pushes_is_that_of_the_twin,
    every_data_set_of_a_file_is_that_of_the_twin,
    slopes_of_a_sweep_s_csv_are_as_they_were_given,
])
