#!/usr/bin/env python3
"""The units in which numbers are told (TAP); cli_twins.py walks them all.

usage: cli_units.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import math
import re

from cli_room import expect, run_cases, shown
from twins import (COMMANDS, L, MATERIAL, PHI, SMALL, SWEEP, V, pair, scene)


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


def letters_of_curves_are_those_of_the_axes(room):
    """V and φ in the SI."""
    for units, v, psi in (('dimensionless', 'v', 'ψ'), ('si', 'V', 'φ')):
        room.write('a.yaml', scene('spinodal_gen', f'units: {units}\n'))
        room.good('portrait', 'a.yaml', '-q', '--figure', 'a.svg')
        room.good('sweep', 'a.yaml', '-q', '--set', SWEEP, '--figure', 'b.svg')
        words = shown(room.bytes('a.svg')), shown(room.bytes('b.svg'))
        expect(f'd{v}/dt = 0' in words[0] and f'd{psi}/dt = 0' in words[0] and
               f' {v} at the saddle' in words[1], units, words)


def a_figure_s_title_has_the_slope_as_it_was_given(room):
    for key, value, told in (('alpha', 0.34, 'α = 0.34 rad'),
                             ('alpha_deg', 19.5, 'α = 19.5°'),
                             ('tan_alpha', 0.35, 'tan α = 0.35')):
        room.good('portrait', '--law', 'dieterich', '--set',
                  f'slope.{key}={value}', '-q', '--figure', 'a.svg')
        expect(f'Dieterich law, {told} ' in shown(room.bytes('a.svg')), told,
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


def a_unit_is_written_in_one_way(room):
    """m/s, not m s-1: in what is printed, in files and in the references."""
    other = re.compile(r'\b(?:m|s|rad|Pa|kg|degree)(?: [a-z]+)?-\d')
    said = room.good('rabinowicz', f'{room.source}/scenes/rabinowicz.yaml',
                     '-o', 'r.h5')
    pages = [room.good('help', '--as', kind) for kind in ('scene', 'hdf5')]
    for text in (said, room.good('info', 'r.h5'), *pages):
        expect(not other.search(text), other.search(text))
    expect('v_k (m/s)' in said and '| m/s^2 |' in pages[0], said)


run_cases([
    a_bare_number_of_a_swept_key_is_in_the_scene_s_units,
    axes_and_points_are_those_of_the_twin,
    words_of_states_are_phi_in_the_si,
    letters_of_curves_are_those_of_the_axes,
    a_figure_s_title_has_the_slope_as_it_was_given,
    a_tangent_is_told_once,
    every_line_of_text_has_the_units_of_json,
    a_unit_is_written_in_one_way,
    a_bare_number_of_a_scene_is_in_its_units,
    figures_are_in_the_scene_s_units,
])
