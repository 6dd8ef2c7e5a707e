#!/usr/bin/env python3
"""The units in which numbers are told (TAP): a scene and its twin beside
units: si, number by number.

usage: cli_units.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import math
import re

from cli_room import expect, run_cases, shown

V, L = 4e-7, 3e-6
MATERIAL = f'material: {{V_star: {V}, L: {L}}}\n'
FACTOR = {'V_star': ('m/s', V), 'L': ('m', L), 'L/V_star': ('s', L / V),
          'V_star/L': ('1/s', V / L)}
SHIFT = {'ln(V_star)': ('ln(m/s)', math.log(V)),
         'log10(V_star/L)': ('log10(1/s)', math.log10(V / L))}
# Of each law: phi of psi = 1, its unit, whether psi is a logarithm.
PHI = {'dieterich_gen': (L / V, 's', False),
       'spinodal_gen': (1 / 101, '1', False),
       'kato_tullis': (L / V, 's', False),
       'perrin': (2 * L / V, 's', True)}
STATES = {'psi', 'psi_at_v0', 'psi_sp0', 'psi_kick'}
PRODUCTS = ('products=[equilibria, folds, knees, estimates, sensitivities, '
            'taylor_series, friction_law, spring_block, bifurcation, '
            'fold_curves, chi, basins]')
SMALL = ['--set', 'basins.cells=[8, 8]', '--set', 'basins.audit=4']
COMMANDS = [
    ['knees'], ['study', '--set', PRODUCTS, *SMALL], ['basin', *SMALL],
    ['portrait', '--sensitivities'],
    ['push', '--v', '1000 V_star'], ['push', '--v', '1 V_star'],
    ['simulate', '--v', '1000 V_star'],
]


class Twins:
    """Two trees of JSON, their units beside them."""

    def __init__(self, law):
        self.law = law
        self.compared = 0
        self.told = 0

    def unit(self, name, unit):
        """Name, unit, and what makes the other number of one."""
        phi_1, s, is_log = PHI[self.law]
        if name in STATES:
            other = name.replace('psi', 'phi')
            if name == 'psi_kick':
                return other, None, math.exp if is_log else lambda x: x
            unit_told = None if s == '1' else s
            if is_log:
                return other, unit_told, lambda x: phi_1 * math.exp(x)
            return other, unit_told, lambda x: phi_1 * x
        if unit in FACTOR:
            told, factor = FACTOR[unit]
            return name, told, lambda x: x * factor
        if unit in SHIFT:
            told, shift = SHIFT[unit]
            return name, told, lambda x: x + shift
        return name, unit, lambda x: x

    def same(self, where, made, own, si, bars):
        if own is None or si is None:
            expect(own is None and si is None or own is not None
                   and not 1e-300 < abs(made(own)) < 1e300, where, own, si)
            return
        wanted = made(own)
        expect(abs(wanted - si) <= bars + 1e-13 * max(abs(wanted), abs(si))
               + 1e-15, where, own, wanted, si)
        self.compared += 1
        self.told += wanted != own

    def numbers(self, where, made, own, si):
        """A number, or one with its bar; a list of them; a word."""
        if isinstance(own, list):
            expect(len(own) == len(si), where)
            for a, b in zip(own, si):
                self.numbers(where, made, a, b)
        elif isinstance(own, dict):
            if own['value'] is None or si['value'] is None:
                expect(own.get('reason') == si.get('reason')
                       or 'largest double' in si['reason'], where, own, si)
                return
            width = own['error']
            both = abs(made(own['value'] + width) - made(own['value'] - width))
            self.same(where, made, own['value'], si['value'],
                      both + si['error'])
            expect(si['error'] >= 0.49 * both * (1 - 1e-6) - 1e-13 *
                   abs(si['value']), where, own, si)
        elif isinstance(own, (int, float)) and not isinstance(own, bool):
            self.same(where, made, own, si, 0)
        else:
            expect(own == si, where, own, si)

    def member(self, where, name, own, si, units, told):
        kind = units.get(name) if isinstance(units, dict) else None
        other, unit, made = self.unit(name, kind if isinstance(kind, str)
                                      else None)
        where = f'{where}.{name}'
        expect(other in si, where, 'is not', sorted(si))
        if name == 'level' and isinstance(kind, dict):
            return
        quantity = isinstance(own[name], dict) and 'value' in own[name]
        leaf = (quantity or not isinstance(own[name], (dict, list)) or
                isinstance(own[name], list) and
                not (own[name] and isinstance(own[name][0], dict)
                     and 'value' not in own[name][0]))
        if not leaf:
            self.walk(where, own[name], si[other], kind or {},
                      told.get(other) or {})
            return
        if own[name] != []:
            expect(told.get(other) == unit, where, unit, told)
        self.numbers(where, made, own[name], si[other])

    def walk(self, where, own, si, units, told):
        if isinstance(own, list):
            expect(len(own) == len(si), where, own, si)
            for a, b in zip(own, si):
                self.walk(where, a, b, units, told)
            return
        expect(len(own) == len(si), where, sorted(own), sorted(si))
        for name in own:
            if name not in ('units', 'cost'):
                self.member(where, name, own, si, units, told)
        for row in [own] if 'level' in own else []:
            level = units['level'].get(row['what'])
            if row['what'] == 'psi_level':
                return
            _, unit, made = self.unit('level', level)
            expect(told['level'].get(row['what']) == unit, where, told)
            self.numbers(where + '.level', made, own['level'], si['level'])


def scene(law, units=''):
    rate = V if 'si' in units else 1
    cut = f', V_c: {1e4 * rate}' if law == 'kato_tullis' else ''
    return (f'law: {{preset: {law}}}\nslope: {{alpha: 0.34}}\n'
            f'{MATERIAL[:-2]}{cut}}}\n{units}')


def pair(room, law, command, *more):
    """Both files, and the arguments for each."""
    room.write('own.yaml', scene(law))
    room.write('si.yaml', scene(law, 'units: si\n'))
    phi_1, _, is_log = PHI[law]
    psi = 1.5
    phi = phi_1 * (math.exp(psi) if is_log else psi)
    args = [command[0], *command[1:], *more]
    state = '--v' in command
    return ([args[0], 'own.yaml', *args[1:],
             *(['--psi', repr(psi)] if state else [])],
            [args[0], 'si.yaml', *args[1:],
             *(['--phi', repr(phi)] if state else [])])


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


NUMBER = re.compile(r'[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?')


def every_line_of_text_has_the_units_of_json(room):
    """Of lines NAME VALUE +- ERROR UNIT."""
    line = re.compile(r'^  (\w+) +\S+ +\+- \S+(?: ([^(\s]\S*))?', re.M)
    for law in PHI:
        for command in (COMMANDS[0], COMMANDS[5]):
            for args in pair(room, law, command):
                units = room.json(*args)['units']
                told = dict(line.findall(room.good(*args)))
                expect(len(told) > (6 if args[0] == 'knees' and law != 'kato_tullis'
                                    else 0), told)
                flat = {**units, **units.get('folds', {}),
                        **units.get('estimates', {})}
                for name, unit in told.items():
                    if not name.startswith('estimates_'):
                        expect(unit == flat.get(name, ''), args, name, unit,
                               flat)


def a_bare_number_of_a_scene_is_in_its_units(room):
    for key, own, si in [('window.v', '[1e-3, 1e3]', f'[{1e-3 * V}, {1e3 * V}]'),
                         ('trajectories.until.time', '5', repr(5 * L / V)),
                         ('trajectories.until.slip', '5', repr(5 * L))]:
        answer = []
        for units, value in (('dimensionless', own), ('si', si)):
            room.write('a.yaml', scene('spinodal_gen', f'units: {units}\n'))
            answer.append(room.json(
                'portrait', 'a.yaml', '--set', f'{key}={value}', '--set',
                'trajectories.starts=[{v: 100 V_star, phi: 0.1}]', '-o',
                f'{units}.h5'))
        expect(answer[0]['saddle']['v']['value'] * V / answer[1]['saddle']['v']
               ['value'] - 1 < 1e-14, answer)
        script = ('import h5py, sys\n'
                  'a, b = (h5py.File(f) for f in sys.argv[1:])\n'
                  't = [f["trajectory_0/time"][-1] for f in (a, b)]\n'
                  'assert abs(t[0] - t[1]) <= 1e-9 * t[0], t\n'
                  't = [f["nullcline/v_0/v"][:].max() for f in (a, b)]\n'
                  'assert abs(t[0] - t[1]) <= 1e-9 * t[0], t\n')
        room.write('same.py', script)
        done = room.shell('/usr/bin/python3 same.py dimensionless.h5 si.h5')
        expect(done.returncode == 0, key, done)


def figures_are_in_the_scene_s_units(room):
    """Their words, and the numbers that are drawn, point by point."""
    for law in PHI:
        drawn = {}
        for units in ('dimensionless', 'si'):
            room.write('a.yaml', scene(law, f'units: {units}\n'))
            phi_1, s, is_log = PHI[law]
            phi = phi_1 * (math.exp(1.5) if is_log else 1.5)
            room.good('simulate', 'a.yaml', '-q', '--v', '1000 V_star',
                      '--phi', repr(phi), '--figure', f'{units}.svg')
            room.good('basin', 'a.yaml', '-q', '--set', 'products=[basins, '
                      'slip, time, peak]', *SMALL, '--figure',
                      f'{units}_b.svg')
            drawn[units] = {name[len(units):]: shown(room.bytes(name))
                            for name in room.names()
                            if name.startswith(units) and
                            name.endswith('.svg')}
        expect(set(drawn['si']) == set(drawn['dimensionless']) and
               len(drawn['si']) > 6, drawn.keys())
        for panel, words in drawn['si'].items():
            own = drawn['dimensionless'][panel]
            for unit, letters in (('(m/s)', 'v = V/V'), ('(m)', 'x/L'),
                                  ('(s)', 'tV∗/L')):
                expect((unit in words) >= (letters in own), law, panel, words,
                       own)
            expect(re.search(r'\((m|s|m/s)\)', words) or 'friction' in words,
                   panel, words)
            expect('V∗' not in words and 'x/L' not in words, panel, words)


SWEEP = ('sweep={key: slope.alpha, from: 0.3, to: 0.36, points: 3}')


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


def state_of(law):
    """phi of psi."""
    phi_1, _, is_log = PHI[law]
    return lambda x: phi_1 * (math.exp(x) if is_log else x)


def sweep_member(twins, law, name, value, told, units, units_told):
    """A number over the points, or a map: its values and their bars."""
    state = re.search(r'(ln_)?psi(_kick|_at_v0|_sp0)?$', name)
    unit = units.get(name)
    phi_1, s, _ = PHI[law]
    if state and name not in told:
        other = name[:state.start()] + state.group().replace('psi', 'phi')
        expect(units_told.get(other, '1') == (
            ('ln(s)' if s == 's' else '1') if state.group(1) else s), other,
               units_told)

        made = state_of(law)
        if state.group(1):
            def made(x):
                return x + math.log(phi_1)
    else:
        other, unit_told, made = twins.unit(name, unit)
        expect(units_told.get(other) == unit_told, name, unit, units_told)
    own, si = value, told[other]
    if not isinstance(own, dict):
        twins.numbers(name, made, own, si)
        return
    for part in ('value', 'least', 'greatest'):
        if part in own:
            error = own.get('error', 0), si.get('error', 0)
            sweep_numbers(twins, name, made, own[part], si[part], *error)
    for part in own:
        if part == 'dims':
            expect(own[part] == [x.replace('phi', 'psi') for x in si[part]],
                   name)
        elif part not in ('value', 'error', 'least', 'greatest'):
            expect(own[part] == si[part], name, part)


def sweep_numbers(twins, where, made, own, si, error, error_told):
    if isinstance(own, list):
        expect(len(own) == len(si), where)
        for i, (a, b) in enumerate(zip(own, si)):
            bar = (e[i] if isinstance(e, list) else e
                   for e in (error, error_told))
            sweep_numbers(twins, where, made, a, b, *bar)
    elif isinstance(own, (int, float)):
        bars = (error or 0, error_told or 0)
        both = abs(made(own + bars[0]) - made(own - bars[0]))
        twins.same(where, made, own, si, both + bars[1])
    else:
        expect(own == si, where, own, si)


def a_bare_number_of_a_swept_key_is_in_the_scene_s_units(room):
    slip = []
    for units, scale in (('dimensionless', 1), ('si', L / V)):
        room.write('a.yaml', scene('spinodal_gen', f'units: {units}\n'))
        found = room.json(
            'sweep', 'a.yaml', '--set', 'products=[trajectories]', '--set',
            'trajectories.starts=[{v: 100 V_star, phi: 0.1}]', '--set',
            'sweep={key: trajectories.until.time, values: '
            f'[{scale}, {3 * scale}]}}')
        expect(found['keys'][0]['unit'] == ('s' if units == 'si' else
                                            'L/V_star'), found['keys'])
        slip.append([x[0] for x in found['numbers']['trajectory_slip']
                     ['value']])
    for own, si in zip(*slip):
        expect(abs(own * L - si) <= 1e-9 * si > 0, slip)


TICK = re.compile(r"'([^']*)' (\S+) 0")


def drawn_ticks(script):
    """Of x and y: ends, and the numbers that are written at their places."""
    found = []
    for axis in 'xy':
        ends = re.search(rf'^set {axis}range \[(.*):(.*)\]', script, re.M)
        ticks = re.search(rf'^set {axis}tics .*?\((.*)\)', script, re.M)
        found.append(([float(end) for end in ends.groups()],
                      TICK.findall(ticks.group(1))))
    return found


def written(text):
    """'2.5 × 10^{−8}' as a number."""
    text = text.replace('−', '-')
    power = re.search(r'10\^\{?(-?\d+)\}?', text)
    if power is None:
        return float(text)
    factor = text[:power.start()].strip(' ×·{}')
    return (float(factor) if factor else 1.0) * 10.0 ** int(power.group(1))


def points_drawn(data):
    """Of all lines, their points in turn."""
    data = re.sub(r'# block \d+: raster.*?\n\n\n', '', data, flags=re.S)
    return [tuple(map(float, line.split())) for line in data.split('\n')
            if re.fullmatch(r'[-\d.e+]+ [-\d.e+]+', line)]


# Law, figure, and what x and y are times in the SI.
FIGURES = [
    ('perrin', ['portrait'], (V, PHI['perrin'][0])),
    ('spinodal_gen', ['sweep', '--set', SWEEP], (1, V)),
    ('spinodal_gen', ['sweep', '--set', 'sweep={key: slope.alpha, from: 0.3, '
                      'to: 0.36, points: 9, show: persistence}'], (1, L)),
]


def axes_and_points_are_those_of_the_twin(room):
    for law, args, factors in FIGURES:
        seen = []
        for units in ('dimensionless', 'si'):
            room.write('a.yaml', scene(law, f'units: {units}\n'))
            room.good(args[0], 'a.yaml', *args[1:], '-q', '--figure',
                      'a.svg', '--keep-script')
            seen.append((drawn_ticks(room.read('a.gp')),
                         points_drawn(room.read('a.dat'))))
        (own, points), (si, points_si) = seen
        expect(len(points) == len(points_si) > 4, args, points, points_si)
        for axis, factor in enumerate(factors):
            for a, b in zip(own[axis][0], si[axis][0]):
                expect(abs(a * factor - b) <= 1e-9 * abs(b), args, own, si)
            expect(len(si[axis][1]) > 1, si)
            for text, place in own[axis][1] + si[axis][1]:
                expect(abs(written(text) - float(place)) <= 1e-9 * max(
                    abs(float(place)), 1e-9 * factor), text, place)
            for a, b in zip(points, points_si):
                expect(abs(a[axis] * factor - b[axis]) <= 1e-4 *
                       abs(b[axis]), args, axis, a, b)


def words_of_states_are_phi_in_the_si(room):
    """Margins' labels, and the note where there is no v_plus."""
    room.write('si.yaml', scene('perrin', 'units: si\n'))
    room.good('basin', 'si.yaml', '-q', '--set', 'products=[basins, margin]',
              *SMALL, '--figure', 'm.svg')
    words = shown(room.bytes('m_margin_psi.svg'))
    expect('factor on φ' in words and 'ψ' not in words, words)
    for units, name in (('dimensionless', 'psi'), ('si', 'phi')):
        room.write('a.yaml', scene('dieterich', f'units: {units}\n'))
        said = room.good('knees', 'a.yaml', '--set', 'slope.alpha=0.3')
        expect(re.search(r'^note: no v_plus.* v = 0 at ' + name + '_at_v0$',
                         said, re.M), said)


def a_figure_s_title_has_the_slope_as_it_was_given(room):
    for key, value, told in (('alpha', 0.34, 'α = 0.34 rad'),
                             ('alpha_deg', 19.5, 'α = 19.5°'),
                             ('tan_alpha', 0.35, 'tan α = 0.35')):
        room.good('portrait', '--law', 'dieterich', '--set',
                  f'slope.{key}={value}', '-q', '--figure', 'a.svg')
        expect(f'dieterich, {told} ' in shown(room.bytes('a.svg')), told,
               shown(room.bytes('a.svg')))


def a_tangent_is_told_once(room):
    for units in ('dimensionless', 'si'):
        room.write('a.yaml', 'law: {preset: spinodal_gen}\n'
                   f'slope: {{tan_alpha: 0.35}}\n{MATERIAL}units: {units}\n')
        said = room.good('knees', 'a.yaml')
        names = re.findall(r'^  (\w+) ', said, re.M)
        expect(names.count('tan_alpha_f') == 1 and 'alpha_f' in names and
               'tan_alpha_cM' in names, said)
        expect(re.search(r'^  alpha_f .* rad$', said, re.M), said)


def files_hold_numbers_as_they_are_and_say_their_scale(room):
    for units in ('dimensionless', 'si'):
        room.write('a.yaml', scene('spinodal_gen', f'units: {units}\n'))
        room.good('knees', 'a.yaml', '-o', f'{units}.h5')
    room.write('look.py', '''
import h5py, sys
a, b = (h5py.File(f)["critical"] for f in sys.argv[1:])
assert len(a) > 10
for name in a:
    if isinstance(a[name], h5py.Dataset):
        assert str(a[name][()]) == str(b[name][()]), name
for name, scale in [("v_plus", "V_star"), ("x_excess", "L")]:
    assert a[name].attrs["scale"].decode() == scale, name
    assert a[name].attrs["units"].decode() == "1", name
    error = a[name + "_error"].attrs
    assert error["scale"].decode() == scale, error
assert "scale" not in a["mu_s_num"].attrs
''')
    done = room.shell('/usr/bin/python3 look.py dimensionless.h5 si.h5')
    expect(done.returncode == 0, done)


run_cases([
    every_number_of_json_is_that_of_the_twin,
    every_number_of_a_sweep_is_that_of_the_twin,
    a_bare_number_of_a_swept_key_is_in_the_scene_s_units,
    axes_and_points_are_those_of_the_twin,
    words_of_states_are_phi_in_the_si,
    a_figure_s_title_has_the_slope_as_it_was_given,
    a_tangent_is_told_once,
    every_line_of_text_has_the_units_of_json,
    a_bare_number_of_a_scene_is_in_its_units,
    figures_are_in_the_scene_s_units,
    files_hold_numbers_as_they_are_and_say_their_scale,
])
