#!/usr/bin/env python3
"""slipway knees --json: its numbers and its shape (TAP).

usage: cli_numbers.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import math
import re
from decimal import Decimal

from cli_room import LAWS, SLOPE, expect, run_cases

# ---- what rounding the inputs costs ------------------------------------------

INPUTS = ['mu_star', 'a', 'b', 'c', 'R', 'alpha']
HALF_ULP = 2.0 ** -53


def psi_ss(law, R, x):
    """At v = e^x."""
    if law in ('ruina', 'perrin'):
        return -x
    if law.startswith('dieterich'):
        return math.exp(-x)
    top = 1 if law == 'spinodal_phi_gen' else 1 + R
    return top / (1 + R * math.exp(x))


def theta(law, c, R, psi):
    if law in ('ruina', 'perrin'):
        return psi
    if law.startswith('dieterich'):
        return math.log(psi)
    return math.log(c + (1 + R if law == 'spinodal_phi_gen' else 1) * psi)


def surplus(row, p, x):
    """mu_ss(v) - tan(alpha): zero at a steady state."""
    q = theta(row['law'], p['c'], p['R'], psi_ss(row['law'], p['R'], x))
    inner = x + (p['mu_star'] + p['b'] * q) / p['a']
    if row['form'] == 'log':
        mu = p['a'] * inner
    else:
        mu = p['a'] * math.asinh(math.exp(inner) / 2)
    return mu - math.tan(p['alpha'])


def slope_at(function, at, step):
    return (function(at + step) - function(at - step)) / (2 * step)


def rounding_costs(row):
    """Of ln v and of psi, absolute, to first order."""
    p = {name: float(row[name]) for name in INPUTS}
    x = math.log(float(row['v']))
    by_x = slope_at(lambda at: surplus(row, p, at), x, 1e-4)
    psi_by_x = slope_at(lambda at: psi_ss(row['law'], p['R'], at), x, 1e-4)
    cost_x = cost_psi = 0
    for name in INPUTS:
        if not 0 < p[name] < math.inf:
            continue
        step = 1e-5 * p[name]
        by_p = slope_at(lambda at: surplus(row, {**p, name: at}, x), p[name],
                        step)
        x_by_p = -by_p / by_x
        psi_by_p = slope_at(lambda at: psi_ss(row['law'], at, x), p['R'],
                            step) if name == 'R' else 0
        cost_x += abs(x_by_p * p[name]) * HALF_ULP
        cost_psi += abs((psi_by_p + psi_by_x * x_by_p) * p[name]) * HALF_ULP
    return cost_x, cost_psi


# ---- reference tables --------------------------------------------------------

def slope_of(row):
    """The options that make a row of a table."""
    keys = {'material.' + key: row[key]
            for key in ('mu_star', 'a', 'b', 'L', 'V_star')}
    if row['law'].startswith('spinodal'):
        keys.update({'material.c': row['c'], 'material.R': row['R']})
    keys['gravity'] = row['g']
    sets = [word for key, value in keys.items()
            for word in ('--set', f'{key}={value}')]
    return ['--law', row['law'], '--friction', row['form'], '--alpha',
            row['alpha'], *sets]


def off(quantity, text):
    """Of a value from a table's digits."""
    return abs(float(Decimal(quantity['value']) - Decimal(text)))


def check_state(found, row):
    cost_x, cost_psi = rounding_costs(row)
    v, psi = abs(float(row['v'])), abs(float(row['psi']))
    for name, bound in (('v', v * (1e-13 + cost_x)),
                        ('psi', 1e-13 * psi + cost_psi),
                        ('mu', 1e-13 * abs(float(row['mu']))),
                        ('lambda_minus', 1e-11 * abs(float(
                            row['lambda_minus']))),
                        ('lambda_plus', 1e-11 * abs(float(
                            row['lambda_plus'])))):
        expect(off(found[name], row[name]) <= bound, row['law'], row['form'],
               row['alpha'], name, found[name], 'is not', row[name],
               'within', bound)


def every_row_of_equilibria_is_found(room):
    slopes = {}
    for row in room.reference('equilibria.csv'):
        slopes.setdefault(tuple(slope_of(row)), []).append(row)
    states = 0
    for options, rows in slopes.items():
        rows.sort(key=lambda row: float(row['v']))
        found = room.json('knees', *options)['equilibria']
        expect([state['type'] for state in found]
               == [row['type'] for row in rows], options, found)
        for state, row in zip(found, rows):
            check_state(state, row)
            states += 1
    expect(states >= 180, states)


def critical_velocities_match_the_table(room):
    rows = 0
    for row in room.reference('manifold.csv'):
        if row['law'] not in ('dieterich_gen', 'spinodal_gen'):
            continue
        found = room.json('knees', *slope_of(row))
        for name, lost in (('v_plus', 'digits_lost_alpha_vplus'),
                           ('v_minus', 'digits_lost_alpha_lower')):
            if row[name]:
                bound = 1e-9 + 10 ** (float(row[lost] or 0) - 15)
                expect(off(found[name], row[name])
                       <= bound * abs(float(row[name])), name, row, found)
                rows += 1
            else:
                expect(found[name]['value'] is None, name, row, found[name])
    expect(rows >= 40, rows)


# ---- shape -------------------------------------------------------------------

QUANTITY = 'a number with its error, or the reason why there is none'
NUMBER = 'a plain number'
STATE = dict.fromkeys(['v', 'psi', 'lambda_minus', 'lambda_plus'], QUANTITY)
KNEE = {'v': QUANTITY, 'psi': QUANTITY}
SHAPE = {
    'law': str, 'form': str, 'alpha': NUMBER,
    'parameters': dict.fromkeys(['mu_star', 'a', 'b', 'L', 'V_star', 'g',
                                 'eps2', 'eta'], NUMBER),
    'equilibria': [{'type': str, 'mu': QUANTITY, **STATE}],
    'folds': dict.fromkeys(['alpha_cm', 'alpha_cM', 'v_m', 'v_M', 'mu_s',
                            'v_M_eq11', 'v_m_eq12', 'c_cusp', 'alpha_cusp'],
                           QUANTITY),
    'saddle': STATE,
    'upper_end': {'psi_inf', 'open', None},
    'lower_end': {'psi_0', 'v_0', 'truncated', None},
    **dict.fromkeys(['v_plus', 'ln_v_plus', 'v_minus', 'ln_v_minus',
                     'psi_at_v0', 'x_excess', 'x_deficit', 'mu_s_num',
                     'mu_s_mean', 'fracture_energy'], QUANTITY),
    'knee_upper': KNEE, 'knee_lower': KNEE,
    'knees_upper': [KNEE], 'knees_lower': [KNEE],
    'estimates': {
        **dict.fromkeys(['v_sp0', 'psi_sp0', 'x_k', 'x_k_small_psi',
                         'x_k_zero_slope', 'mu_s_exact_v_plus', 'alpha_f',
                         'tan_alpha_f'], QUANTITY),
        'chi': {'roots': [QUANTITY], 'v_minus': QUANTITY, 'v_plus': QUANTITY},
        'xi': [{'xi': NUMBER, 'v_minus': QUANTITY, 'v_plus': QUANTITY,
                'mu_s': QUANTITY, 'G': QUANTITY}],
    },
    'cost': {'field_evaluations': NUMBER, 'seconds': NUMBER},
    'units': dict,
}


def is_number(found):
    return (isinstance(found, (int, float)) and not isinstance(found, bool)
            and math.isfinite(found))


def is_quantity(found):
    if set(found) == {'value', 'reason'}:
        reason = found['reason']
        return found['value'] is None and len(reason.split()) >= 3
    return (set(found) - {'conditioning'} == {'value', 'error'}
            and all(is_number(item) for item in found.values())
            and found['error'] >= 0)


def check_shape(found, shape, where):
    if shape is QUANTITY:
        expect(is_quantity(found), where, found, 'is not', shape)
    elif shape is NUMBER:
        expect(is_number(found), where, found, 'is not', shape)
    elif shape is dict:
        expect(isinstance(found, dict) and found, where, found)
    elif shape is str:
        expect(isinstance(found, str) and found, where, found)
    elif isinstance(shape, set):
        expect(found in shape, where, found)
    elif isinstance(shape, list):
        expect(isinstance(found, list), where, found)
        for item in found:
            check_shape(item, shape[0], where + '[]')
    else:
        expect(set(found) == set(shape), where, 'has', sorted(found))
        for key, below in shape.items():
            check_shape(found[key], below, f'{where}.{key}')


def shape_of(uses):
    """With the parameters that the law uses."""
    return {**SHAPE, 'parameters': {**SHAPE['parameters'],
                                    **dict.fromkeys(uses, NUMBER)}}


def the_shape_is_that_of_the_page_with_and_without_a_saddle(room):
    saddles = 0
    uses = {law['name']: law['parameters'] for law in room.json('laws')}
    for law in LAWS:
        for form in ('asinh', 'log'):
            for alpha in ('0.2', '0.34', '0.45', '1.4'):
                found = room.json('knees', '--law', law, '--friction', form,
                                  '--alpha', alpha)
                check_shape(found, shape_of(uses[law]),
                            f'{law}, {form}, {alpha}: ')
                expect((found['law'], found['form'], found['alpha'])
                       == (law, form, float(alpha)), found)
                exists = found['saddle']['v']['value'] is not None
                expect(exists == any(state['type'] == 'saddle'
                                     for state in found['equilibria']), found)
                if found['upper_end'] is None and exists:
                    expect('further apart than doubles'
                           in found['v_plus']['reason'], found)
                expect(exists or found['upper_end'] is None, found)
                saddles += exists
    expect(10 < saddles < 56 - 10, saddles)


def composed_laws_have_the_same_shape(room):
    found = room.json('knees', '--set', 'law={theta: ln_psi, psi_ss: spinodal, '
                      'timescale: ageing44, kinetics: sinh}', '--alpha', '0.35')
    check_shape(found, shape_of(['R']), 'composed: ')
    expect(found['law'] == 'composed', found['law'])


def slopes_are_told_in_the_unit_they_were_given_in(room):
    law = ['--law', 'spinodal_gen']
    rad = room.json('knees', *law, '--set', 'slope.alpha_deg=19.5')
    for key, given, head, name, told in (
            ('alpha', '0.34', ', alpha = 0.34 rad', 'alpha_cM', lambda x: x),
            ('alpha_deg', '19.5', ', alpha = 19.5 degree', 'alpha_cM',
             math.degrees),
            ('tan_alpha', '0.354', ', tan_alpha = 0.354', 'tan_alpha_cM',
             math.tan)):
        said = room.good('knees', *law, '--set', f'slope.{key}={given}')
        expect(said.splitlines()[0].endswith(head), said)
        line = re.search(rf'^ +{name} +(\S+) +\+- (\S+)(.*)', said, re.M)
        wanted = told(rad['folds']['alpha_cM']['value'])
        expect(line and abs(float(line[1]) - wanted) <= float(line[2])
               + 1e-15 * wanted, name, said)
        expect(line[3] == {'alpha': ' rad', 'alpha_deg': ' degree',
                           'tan_alpha': ''}[key], line)
    expect(rad['units']['folds']['alpha_cM'] == 'rad', 'JSON is in rad')


def without_v_plus_a_line_says_what_answers_instead(room):
    for law in LAWS:
        for alpha in ('0.3', '0.34'):
            found = room.json('knees', '--law', law, '--alpha', alpha)
            said = room.good('knees', '--law', law, '--alpha', alpha)
            notes = re.findall(r'^note: no v_plus: (.*)', said, re.M)
            expect(len(notes) == (found['upper_end'] == 'open'), law, notes)
            for note in notes:
                expect('push' in note and 'knees_upper' in note and
                       ('psi_at_v0' in note) ==
                       (found['psi_at_v0']['value'] is not None), note)
    expect('note: no v_plus' in room.good('knees', '--law', 'dieterich',
                                          '--alpha', '0.3'), 'dieterich')


def a_study_prints_only_what_was_asked_for(room):
    found = room.json('study', *SLOPE, '--set', 'products=[equilibria]')
    expect(set(found) == {'law', 'form', 'alpha', 'parameters', 'equilibria',
                          'saddle', 'cost', 'units'}, sorted(found))
    found = room.json('study', *SLOPE, '--set', 'products=[folds]')
    expect('folds' in found and 'v_plus' not in found, sorted(found))


# ---- what does not exist -----------------------------------------------------

NOTHING = {
    'no saddle': ['--law', 'spinodal_gen', '--alpha', '0.2'],
    'no steady state': ['--law', 'ruina', '--alpha', '1.5'],
    'inside the window': [*SLOPE, '--set', 'window.psi=[1e200, 1e300]'],
    'hence no separatrix': ['--law', 'dieterich', '--set', 'material.a=0.06',
                            '--alpha', '0.45'],
}


def what_does_not_exist_is_said_and_the_rest_is_written(room):
    for sentence, options in NOTHING.items():
        said = room.good('portrait', *options, '-o', 'a.h5', '--figure',
                         'a.svg')
        notes = [line for line in said.splitlines() if line[:6] == 'note: ']
        expect(any(sentence in note for note in notes), sentence, said)
        expect(room.names() == ['a.h5', 'a.svg'], room.names())
        expect(b'</svg>' in room.bytes('a.svg')[-20:], 'the figure')
        expect(len(room.good('info', 'a.h5')) > 200, 'the file')


def flattened(numbers, at=''):
    """Every {value, error} by its path; also what is missing."""
    if isinstance(numbers, dict) and 'value' in numbers:
        yield at, numbers
    elif isinstance(numbers, dict):
        for key, item in numbers.items():
            yield from flattened(item, f'{at}.{key}')
    elif isinstance(numbers, list):
        for i, item in enumerate(numbers):
            yield from flattened(item, f'{at}[{i}]')


def a_preset_written_as_formulas_gives_its_numbers(room):
    compared = 0
    for law in LAWS:
        room.write('f.yaml', room.good('laws', '--as', 'scene', law))
        slope = ['--alpha', '0.34', '--json']
        found = dict(flattened(room.json('knees', 'f.yaml', *slope)))
        wanted = dict(flattened(room.json('knees', '--law', law, *slope)))
        for path, one in wanted.items():
            if path.startswith(('.estimates', '.folds.v_M_eq', '.folds.v_m_eq',
                                '.folds.c_cusp', '.folds.alpha_cusp')):
                continue  # closed forms of components
            other = found[path]
            expect((one['value'] is None) == (other['value'] is None), law,
                   path, one, other)
            if one['value'] is None:
                continue
            off = abs(one['value'] - other['value'])
            expect(off <= one['error'] + other['error'], law, path, one, other)
            compared += 1
    expect(compared > 100, compared)


run_cases([
    a_preset_written_as_formulas_gives_its_numbers,
    every_row_of_equilibria_is_found,
    critical_velocities_match_the_table,
    the_shape_is_that_of_the_page_with_and_without_a_saddle,
    composed_laws_have_the_same_shape,
    slopes_are_told_in_the_unit_they_were_given_in,
    without_v_plus_a_line_says_what_answers_instead,
    a_study_prints_only_what_was_asked_for,
    what_does_not_exist_is_said_and_the_rest_is_written,
])
