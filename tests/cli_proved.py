#!/usr/bin/env python3
"""slipway knees --proved (TAP).

usage: cli_proved.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import json
from decimal import Decimal

from cli_room import expect, refused, run_cases

COLUMNS = {'v_plus': 'v_plus', 'v_minus': 'v_minus', 'psi_at_v0': 'psi_at_v0',
           'x_excess': 'x_excess', 'x_deficit': 'x_deficit_lower',
           'mu_s_num': 'mu_s_num', 'fracture_energy': 'G_num'}


def rows(room):
    """One of each law and form, Table 2's material."""
    seen = set()
    for row in room.reference('manifold.csv'):
        key = row['law'], row['form']
        if row['tag'] == 'default' and row['alpha'] == '0.34' and key not in seen:
            seen.add(key)
            yield row


def in_bar(number, exact):
    off = abs(Decimal(number['value']) - exact)
    expect(off <= Decimal(number['error']), number, exact)


def the_reference_is_between_both_decimals(room):
    compared = 0
    for row in rows(room):
        found = room.json('knees', '--law', row['law'], '--friction',
                          row['form'], '--alpha', row['alpha'], '--proved')
        for name, column in COLUMNS.items():
            proved = found[name]['proved']
            if found[name]['value'] is None:
                expect(proved == {'absent': True}, row['law'], name, proved)
                continue
            lo, hi = Decimal(proved['lo']), Decimal(proved['hi'])
            expect(lo <= Decimal(row[column]) <= hi, row['law'], name, proved)
            in_bar(found[name], lo)
            in_bar(found[name], hi)
            expect(hi - lo <= Decimal('1e-11') * abs(hi), row['law'], name)
            compared += 1
        for side in ('up', 'lo'):
            compared += compare_knee(found, row, side)
    expect(compared > 60, compared)


def compare_knee(found, row, side):
    """How many numbers of it are proved."""
    name = {'up': 'upper', 'lo': 'lower'}[side]
    knee, listed = found[f'knee_{name}'], found[f'knees_{name}']
    if row[f'knee_{side}_v'] == 'none':
        for number in knee.values():
            expect(number['proved'] == {'absent': True}, row['law'], name, number)
        expect(listed == [], row['law'], listed)
        return 0
    expect(listed[0] == knee, row['law'], listed)
    for key, number in knee.items():
        lo, hi = (Decimal(number['proved'][end]) for end in ('lo', 'hi'))
        expect(lo <= Decimal(row[f'knee_{side}_{key}']) <= hi, row['law'], name, key, number)
        expect(hi - lo <= Decimal('1e-12') * abs(hi), row['law'], name, key)
    return len(knee)


def a_law_without_a_proof_says_why(room):
    room.bring('scenes')
    found = room.json('knees', 'scenes/nagata.yaml', '--proved', '-o', 'n.h5')
    expect(found['v_plus']['proved'] is None, found['v_plus'])
    expect(found['v_plus']['not_proved'], found['v_plus'])


def a_scene_asks_for_it_too(room):
    text = 'law: {preset: perrin}\nslope: {alpha: 0.34}\naccuracy: {proved: true}\n'
    room.write('p.yaml', text)
    expect('proved: 307.643622' in room.good('knees', 'p.yaml'))
    found = room.json('portrait', 'p.yaml')
    expect('lo' in found['saddle']['v']['proved'], found['saddle'])


READ = '''import h5py, json, sys
at = h5py.File(sys.argv[1])['critical']
print(json.dumps([[float(at[f'v_{end}_{what}'][()]) for what in
                   ('lo', 'hi', 'proved')] for end in ('plus', 'minus')]
                 + [at['v_plus_proved'].attrs.get('comment', b'').decode()]))'''


def files_hold_what_is_proved(room):
    slope = ['--alpha', '0.34', '--proved', '-o', 'p.h5']
    plus = room.json('knees', '--law', 'perrin', *slope)['v_plus']['proved']
    held, minus, why = json.loads(room.reads(READ, 'p.h5'))
    expect(all(abs(float(plus[end]) - had) <= 2e-16 * had and had > 307
               for end, had in zip(('lo', 'hi'), held)), plus, held)
    expect(held[2] == 1 and minus[2] == 2 and minus[0] != minus[0] and why == '',
           held, minus)
    room.bring('scenes')
    plus = room.json('knees', 'scenes/nagata.yaml', *slope[2:])['v_plus']
    held, _, why = json.loads(room.reads(READ, 'p.h5'))
    expect(held[2] == 0 and why == plus['not_proved'], plus, held, why)


SWEPT = '''import h5py, json, sys
at = h5py.File(sys.argv[1])['sweep']
print(json.dumps([at['v_plus_' + end][()].tolist() for end in ('lo', 'hi')]
                 + [at['v_plus_lo_exists'][()].tolist()]))'''


def sweeps_have_columns_for_what_is_proved(room):
    sweep = ['--law', 'spinodal_gen', '--proved', '--set', 'products=[knees]', '--set',
             'sweep={key: slope.alpha, values: [0.34, 0.5]}']
    found = room.json('sweep', *sweep, '-o', 's.h5')
    lo, hi, exists = json.loads(room.reads(SWEPT, 's.h5'))
    alone = room.json('knees', '--law', 'spinodal_gen', '--alpha', '0.34', '--proved')
    for number in ('v_plus', 'psi_at_v0', 'x_deficit', 'saddle_lambda_plus',
                   'knee_lower_psi'):
        at = (alone['saddle']['lambda_plus'] if 'saddle' in number else
              alone['knee_lower']['psi'] if 'knee' in number else alone[number])
        for end in ('lo', 'hi'):
            told = found['numbers'][f'{number}_{end}']
            if 'absent' in at['proved']:
                expect('none is proved' in found['reasons'][told['reason'][0]], told)
                continue
            had = float(at['proved'][end])
            expect(abs(told['value'][0] - had) <= 2e-16 * abs(had), number, told)
            expect('none is proved' in found['reasons'][told['reason'][1]], told)
    expect(found['numbers']['v_plus_lo']['value'][0] == lo[0] < hi[0], lo, hi)
    expect(exists[0] == 1 != exists[1], exists)
    table = room.good('sweep', *sweep, '--set', 'units=si', '-o', '-').splitlines()
    row = dict(zip(table[0].split(','), table[1].split(',')))
    for end, own, side in (('lo', lo[0], 1), ('hi', hi[0], -1)):
        beside = side * (Decimal(own) / 10**6 - Decimal(row[f'v_plus_{end} [m/s]']))
        expect(0 < beside < Decimal(own) / 10**21, end, beside)


def labels_are_proved_in_text_json_and_file(room):
    grid = ['--alpha', '0.34', '--set', 'basins={cells: [40, 30], audit: 0}',
            '--proved']
    scene = ['--law', 'spinodal_gen', *grid]
    found = room.json('basin', *scene, '-o', 'map.h5')
    expect(found['basin']['proved'] == {'fraction': 1, 'near': 0, 'beyond': 0},
           found['basin'])
    expect('proved_fraction  1\n' in room.good('basin', *scene))
    told = room.good('info', 'map.h5')
    expect('proved                 30 x 40' in told, told)
    found = room.json('basin', '--law', 'kato_tullis', '--set',
                      'material.V_c=100', *grid)
    expect(found['basin']['proved']['fraction'] == 0, found['basin'])
    expect(found['basin']['proved']['reason'], found['basin'])
    for alpha, fate in (('0.2', 'creep'), ('0.6', 'sliding')):
        found = room.json('basin', *scene, '--alpha', alpha)['basin']
        expect(found['proved']['fraction'] == 1 and fate in found['fractions'], found)
    room.good('basin', *scene, '--figure', 'map.svg')
    expect('not proved' not in room.read('map.svg'))


PLANE = '''import h5py, json, sys
at = h5py.File(sys.argv[1])
print(json.dumps([at['manifolds'][name][2].item() for name in
                  ('leaves_y_lo', 'leaves_y_hi', 'leaves_y_proved', 'end_proved')]
                 + [at['equilibria']['x_lo'][0].item()]))'''


def systems_are_proved_in_text_json_file_and_sweep(room):
    """y = 2 cos(x/2) at x = 1, of a pendulum's separatrix from (-pi, 0)."""
    truth = Decimal('1.75516512378074543223256316520765930')
    pi = Decimal('3.14159265358979323846264338327950288')
    scene = ['--ode', "x' = y; y' = -k*sin(x); k = 1", '--window', 'x=-4:1,y=-3:3',
             '--proved']
    found = room.json('study', *scene, '-o', 'p.h5')
    branch = found['manifolds'][2]
    expect(branch['kind'] == 'unstable' and branch['end_proved'] == 'crosses' and
           branch['not_proved'] is None, branch)
    bounds = branch['leaves_y']['proved']
    expect(Decimal(bounds['lo']) <= truth <= Decimal(bounds['hi']), bounds)
    state = found['equilibria'][0]['state']['x']['proved']
    expect(Decimal(state['lo']) <= -pi <= Decimal(state['hi']), state)
    held = json.loads(room.reads(PLANE, 'p.h5'))
    expect(held == [float(bounds['lo']), float(bounds['hi']), 1, 1, float(state['lo'])],
           held, bounds, state)
    expect('crosses' in room.good('study', *scene), scene)
    swept = room.json('sweep', *scene, '--set',
                      'sweep={key: system.parameters.k, values: [1, 4]}')['numbers']
    for end in ('lo', 'hi'):
        expect(swept[f'manifolds_2_leaves_y_{end}']['value'][0] == float(bounds[end]),
               swept.keys())


def what_is_not_proved_is_refused(room):
    slope = ['--law', 'perrin', '--set', 'accuracy.proved=true']
    refused(room.run('ensemble', *slope, '--alpha', '0.34', '--set',
                     'ensemble={parameters: {material.a: {uniform: [0.03, '
                     '0.04]}}, draws: 8}'), 2, 'accuracy.proved', 'expected knees')


# In the SI, from reference numbers in units of V_star = 1e-6 m/s, L = 0.9e-6 m.
PER = {'dieterich_gen': lambda psi: Decimal('0.9') * psi,
       'perrin': lambda psi: 2 * Decimal('0.9') * psi.exp(),
       'spinodal_gen': lambda psi: psi / 101}


def no_end_is_open_where_psi_runs_away(room):
    """In a finite time: dpsi/dt = -d - d^2, by which v stays finite."""
    room.write('square.yaml', 'law: {mu: "mu_star + a*ln(v) + b*asinh(psi)", psi_ss: -ln(v), '
               'T: "1", K: d + d^2, state: real}\nslope: {tan_alpha: 0.3689}\n')
    found = room.json('knees', 'square.yaml', '--proved')
    expect(found['v_plus']['proved'] is None, found['v_plus'])
    expect(found['upper_end'] != 'open', found['upper_end'])


def in_si_units_the_reference_is_between_too(room):
    for row in rows(room):
        if row['law'] not in PER or row['form'] != 'asinh':
            continue
        found = room.json('knees', '--law', row['law'], '--alpha', '0.34',
                          '--set', 'units=si', '--proved')
        v_plus, psi = Decimal(row['v_plus']), Decimal(row['psi_sp'])
        for number, exact in [
                (found['v_plus'], v_plus / 10**6),
                (found['ln_v_plus'], (v_plus / 10**6).ln()),
                (found['x_excess'],
                 Decimal(row['x_excess']) * Decimal('0.9e-6')),
                (found['saddle']['lambda_plus'],
                 Decimal(row['lambda_plus']) / Decimal('0.9')),
                (found['mu_s_mean'], Decimal(row['mu_s_mean'])),
                (found['saddle']['phi'], PER[row['law']](psi))]:
            lo, hi = (Decimal(number['proved'][end]) for end in ('lo', 'hi'))
            expect(lo <= exact <= hi and hi - lo < abs(exact) / 10**11, row['law'],
                   exact, number)
            in_bar(number, exact)


def nothing_is_proved_where_nobody_asks(room):
    found = room.json('knees', '--law', 'perrin', '--alpha', '0.34')
    expect('proved' not in found['v_plus'], found['v_plus'])


run_cases([
    the_reference_is_between_both_decimals,
    a_law_without_a_proof_says_why,
    a_scene_asks_for_it_too,
    files_hold_what_is_proved,
    sweeps_have_columns_for_what_is_proved,
    labels_are_proved_in_text_json_and_file,
    systems_are_proved_in_text_json_file_and_sweep,
    what_is_not_proved_is_refused,
    no_end_is_open_where_psi_runs_away,
    in_si_units_the_reference_is_between_too,
    nothing_is_proved_where_nobody_asks,
])
