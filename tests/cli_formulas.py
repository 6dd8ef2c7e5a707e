#!/usr/bin/env python3
"""Systems of formulas as users call them (TAP).

usage: cli_formulas.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import os
import re

from cli_room import expect, refused, run_cases, shown

DUFFING = ['--ode', "x' = y; y' = x - x^3 - d*y; d = 0.1",
           '--window', 'x=-2:2,y=-2:2']
AUDIT = ['--set', 'basins.audit=20']


def is_near(found, value, most):
    return (set(found) == {'value', 'error'} and found['error'] <= most
            and abs(found['value'] - value) <= found['error'])


def json_is_as_the_interface_says(room):
    found = room.json('study', *DUFFING)
    expect(found['equilibria_complete'] is True, found)
    saddle = found['equilibria'][1]
    expect(saddle['type'] == 'saddle' and saddle['name'] == 'saddle_0', saddle)
    expect(is_near(saddle['state']['x'], 0, 1e-15), saddle)
    low, high = saddle['eigenvalues']
    root = 1.0012492197250393
    expect(is_near(low['re'], -0.05 - root, 1e-14), low)
    expect(is_near(high['re'], -0.05 + root, 1e-14), high)
    kinds = [(m['saddle'], m['kind'], m['branch'], m['end'], m['to'])
             for m in found['manifolds']]
    expect(kinds == [(0, 'stable', 0, 'infinity', None),
                     (0, 'stable', 1, 'infinity', None),
                     (0, 'unstable', 0, 'equilibrium', 2),
                     (0, 'unstable', 1, 'equilibrium', 0)], kinds)


def where_others_may_be_is_told(room):
    system = ['--ode', "x' = x^2 - y^2; y' = -2*x*y", '--window',
              'x=-1:1,y=-1:1']
    said = room.good('study', *system)
    box, = room.json('study', *system)['undecided']
    expect('1 box may hold some: x = ' in said, said)
    for name in 'xy':
        lo, hi = box[name]
        expect(lo < 0 < hi and f'{name} = {lo:.9g} .. {hi:.9g}' in said, said)


def shares_are_halves(room):
    found = room.json('basin', *DUFFING, *AUDIT)
    shares = {s['attractor']: s['fraction'] for s in found['shares']}
    for name in ('stable_focus_0', 'stable_focus_1'):
        expect(is_near(shares[name], 0.5, 1e-11), shares)
    expect([b['manifold'] for b in found['boundary']] == [0, 1], found)


def shares_beside_what_is_undecided_are_lower_bounds(room):
    half = ['--ode', "x' = x*(1 - y); y' = y*(x - 1)",
            '--window', 'x=-1:3,y=-1:2']
    for system, lower in ((DUFFING, False), (half, True)):
        found = room.json('basin', *system, *AUDIT)
        expect(found['shares_are_lower_bounds'] is lower, found['shares'])
        said = room.good('basin', *system, *AUDIT)
        expect(('up to 0.5 more' in said) is lower, said)


def spent_steps_are_a_reason_and_no_end(room):
    many = 'takes more steps than the bound allows'
    room.bring('scenes')
    found = room.json('knees', 'scenes/nagata.yaml')
    expect(found['v_minus']['reason'] == 'the lower branch ' + many, found['v_minus'])
    found = room.json('portrait', '--ode', "x' = y; y' = x - x^2 - 1e-5*y", '--window',
                      'x=-1:2,y=-2:2')
    expect('steps' in [one['end'] for one in found['manifolds']], found['manifolds'])
    found = room.json('basin', '--ode', "x' = y; y' = -x", '--window', 'x=-1:1,y=-1:1')
    expect(len(found['undecided_reasons']) == 1
           and 'closed orbits' in found['undecided_reasons'][0], found)


def parameters_are_set(room):
    found = room.json('study', *DUFFING, '--set', 'system.parameters.d=3')
    expect(found['equilibria'][0]['type'] == 'stable_node', found)


def one_state_or_many_are_pushed(room):
    found = room.json('push', *DUFFING, '--state', 'y=1,x=1')
    expect(found['attractor'] == 'stable_focus_0', found)
    room.write('states.csv', 'y,x\n1,1\n0,1.1\n0,0\n0,150\n')
    found = room.json('push', *DUFFING, '--states', 'states.csv')['states']
    names = [answer['attractor'] for answer in found]
    expect(names[:3] == ['stable_focus_0', 'stable_focus_1', 'undecided'],
           names)


def files_and_figures_have_the_names_of_states(room):
    room.write('a.yaml', '''system:
  state: {prey: positive, hunters: positive}
  parameters: {k: 2}
  rates: {prey: prey*(1 - prey/k - hunters/(1 + prey)),
          hunters: hunters*(prey/(1 + prey) - 0.4)}
window: {prey: [0.01, 5], hunters: [0.01, 5]}
products: [equilibria, nullclines, field_arrows, manifolds, trajectories, basins]
trajectories: {spread: 4}
basins: {cells: [16, 12], audit: 10}
output: {hdf5: a.h5, figure: a.svg}
''')
    room.good('study', 'a.yaml')
    expect(b'hunters' in room.bytes('a.svg'), 'no label')
    listed = room.good('info', 'a.h5')
    for name in ('/equilibria', '/nullcline/prey_0', '/trajectory_3',
                 '/basin', '/shares', 'hunters', 'direction_prey'):
        expect(name in listed, name, listed)
    room.good('study', 'a.yaml', '-o', 'b.h5', '--threads', '1')
    expect(room.bytes('a.h5') == room.bytes('b.h5'), 'other bytes')
    expect('same bytes' in room.good('info', '--rerun', 'a.h5'))


def tables_hold_systems(room):
    room.good('check', '--record', *DUFFING, '-o', 'a.csv')
    expect('all hold' in room.good('check', 'a.csv'), 'moved')
    text = room.read('a.csv')
    expect('manifolds_2_end' in text and 'equilibrium' in text, text)
    room.write('b.csv', text.replace('d = 0.1', 'd = 0.2'))
    done = room.run('check', 'b.csv')
    expect(done.returncode == 1
           and 'equilibria_1_eigenvalues_1_re' in done.stdout, done)
    room.write('c.csv', 'set,equilibria_0_state_z\n"system.ode=x\'=y;y\'=x",0')
    expect(room.run('check', 'c.csv').returncode == 2, 'unknown column')


def a_manifold_leaves_the_window_somewhere(room):
    found = room.json('study', '--ode', "x' = x; y' = -y", '--window',
                      'x=-2:3,y=-5:4')['manifolds']
    for branch, x, y in zip(found, (0, 0, 3, -2), (-5, 4, 0, 0)):
        at = branch['leaves_x'], branch['leaves_y']
        expect(is_near(at[0], x, 1e-13) or is_near(at[0], x, 1e-12), branch)
        expect(abs(at[1]['value'] - (y if x else at[1]['value'])) <= 1e-13,
               branch)
        expect(x or abs(at[1]['value']) in (4, 5), branch)


SYMMETRIC = """system:
  state: {x: positive, y: positive}
  rates: {x: "x*(%s)", y: "y*(%s)"}
window: {x: [0.05, 8], y: [0.05, 8]}
basins: {cells: [32, 32], audit: 50}
"""


def a_straight_line_ends_where_it_comes_to_rest(room):
    """x = y, of which a step is so long that behind its end no digit is left."""
    room.write('a.yaml', SYMMETRIC % ('2*y/(1 + y) - 0.4*x - 0.3', '2*x/(1 + x) - 0.4*y - 0.3'))
    ends = [(m['end'], m['to']) for m in room.json('portrait', 'a.yaml')['manifolds']]
    expect(ends == [('infinity', None)] * 2 + [('equilibrium', 1), ('infinity', None)], ends)
    room.write('b.yaml', SYMMETRIC % ('5/(1 + y^2)/x - 1', '5/(1 + x^2)/y - 1'))
    found = room.json('basin', 'b.yaml')
    expect([m['end'] for m in found['manifolds']] == ['infinity', 'edge'] + ['equilibrium'] * 2,
           found['manifolds'])
    for share in found['shares'][:2]:
        expect(is_near(share['fraction'], 0.5, 1e-12), share)


EPIDEMIC = """system:
  state: {s: real, i: real}
  rates:
    s: "1-0.5*s*i-0.1*s"
    i: "0.5*s*i-i-2*i/(1+2*i)"
window: {s: [0, 12], i: [-0.2, 6]}
"""


def where_branches_end_does_not_hang_on_the_accuracy(room):
    for ode, window in (
            ("x' = y; y' = x - x^3 - 0.2*y + 0.1", 'x=-2:2,y=-2:2'),
            ("x' = 0.3*sin(3*y) + x - x^3; y' = 0.2*cos(2*x) - 0.2 + y - y^3", 'x=-2:2,y=-2:2'),
            ("x' = x*(1 - 2*y) - x^2 + 0.001; y' = 0.5*y*(1 - y)*(5*x - 0.6)", 'x=-0.1:1.2,y=-0.1:1.1')):
        ends = [[(m['end'], m['to']) for m in room.json(
            'portrait', '--ode', ode, '--window', window, '--rtol', rtol)['manifolds']]
            for rtol in ('1e-4', '1e-7', '1e-12', '1e-13')]
        expect(ends[0] == ends[1] == ends[2] == ends[3], ode, ends)
    straight = [end for end, to in ends[0] if to is None]
    expect(straight.count('equilibrium') == 2 and 'edge' not in straight, ends[0])
    room.write('a.yaml', EPIDEMIC)
    for rtol in ('1e-3', '1e-12'):
        ends = [(m['end'], m['to']) for m in room.json('portrait', 'a.yaml', '--rtol', rtol)['manifolds']]
        expect(ends[3] == ('cycle', 0), rtol, ends)


PHASES = """system:
  state: {a: angle, b: angle}
  rates: {a: "0.1 - 2*sin(a) - sin(b) + 0.5*sin(b - a)", b: "0.05 - 2*sin(b) - sin(a) + 0.5*sin(a - b)"}
window: {a: [-3, 3], b: [-3, 3]}
"""


def a_branch_that_is_lost_on_a_step_takes_shorter_ones(room):
    room.write('a.yaml', PHASES)
    for rtol in ('1e-6', '1e-8', '1e-13'):
        found = room.json('portrait', 'a.yaml', '--rtol', rtol)['manifolds']
        expect([m['end'] for m in found] == ['equilibrium'] * 8, rtol, found)


def pages_and_plans_tell_of_systems(room):
    page = room.good('help', '--as', 'hdf5')
    for group in ('/sensitivities/p', '/manifold/saddle_0/stable_0',
                  '/nullcline/x_K', '/shares'):
        expect(f'- `{group}`,' in page, group)
    expect('sensitivities' in room.good('plan', *DUFFING, '--sensitivities'),
           'plan')
    done = room.run('basin', *DUFFING, *AUDIT, '--progress', 'json', '--quiet')
    for stage in ('equilibria', 'saddles', 'regions', 'audit'):
        expect(f'"stage": "{stage}"' in done.stderr, done.stderr)


SWEEP = ['--set', 'sweep={key: system.parameters.d, values: [0.1, 0.3]}']


def margins_have_figures_where_there_are_two_fates(room):
    asked = ['--set', 'products=[basins, margin]', '--figure', 'a.svg', *AUDIT]
    said = room.good('basin', *DUFFING, *asked)
    for name in 'xy':
        drawn = shown(room.bytes(f'a_margin_{name}.svg'))
        expect(f'change of {name} to another fate' in drawn and
               f'wrote a_margin_{name}.svg' in said, drawn, said)
    expect('no margins' not in said, said)
    one = ['--ode', "x' = y; y' = -x - y", '--window', 'x=-2:2,y=-2:2']
    said = room.good('basin', *one, *asked[:2], '--figure', 'b.svg', *AUDIT)
    expect('note: no margins to draw: all states have the same fate' in said
           and [n for n in room.names() if n[0] == 'b'] == ['b.svg'], said)


def more_attractors_than_labels_are_refused(room):
    def push(x):
        return room.run('push', '--ode', "x' = -tan(x); y' = -y", '--window',
                        f'x=-1:{x},y=-1:1.1', '--state', f'x={x},y=0.3')
    expect('stable_node_124' in push(391).stdout, 'the last of 125')
    refused(push(403), 2, 'basins: more than 127 attractors')


def a_parameter_is_swept(room):
    found = room.json('sweep', *DUFFING, *SWEEP, '-o', 'a.h5', '--figure',
                      'a.svg')
    numbers = found['numbers']
    expect(found['keys'][0]['values'] == [0.1, 0.3], found['keys'])
    expect(numbers['count_equilibria']['value'] == [3, 3], numbers)
    expect(numbers['equilibria_1_type'] == ['saddle'] * 2, numbers)
    expect(numbers['manifolds_2_end'] == ['equilibrium'] * 2, numbers)
    for i, d in enumerate((0.1, 0.3)):
        high = numbers['equilibria_1_eigenvalues_1_re']
        root = (d * d / 4 + 1) ** 0.5
        expect(abs(high['value'][i] - (root - d / 2)) <= high['error'][i] + 1e-16,
               high)
    listed = room.good('info', 'a.h5')
    expect('equilibria_1_eigenvalues_1_re_error 2' in listed, listed)
    expect(b'saddle' in room.bytes('a.svg'), 'figure')
    many = room.json('study', *DUFFING, '--set', 'system.parameters.d=0.3')
    one = many['equilibria'][1]['eigenvalues'][1]['re']
    expect(one['value'] == high['value'][1], 'a point is a study')


def what_is_wrong_costs_one_line(room):
    for words, said in (
            (['study', '--ode', "x' = y; y' = sn(x)"], 'did you mean'),
            (['study', '--ode', "x' = y; y' = x"], 'window.x is missing'),
            (['study', '--ode', "x' = sqrt(x - 5) - y; y' = -y",
              *DUFFING[2:]], 'no finite value at x = 0, y = 0, nor at 19'),
            (['study', *DUFFING, '--window', 'x=2'], 'x=LO:HI'),
            (['study', *DUFFING, '--law', 'ruina'], 'not beside system'),
            (['push', *DUFFING], 'expected --state x=A,y=B'),
            (['push', *DUFFING, '--state', 'x=1,y=b'], 'a number'),
            (['push', *DUFFING, '--state', 'x=1,y=1,z=2'], 'expected --state'),
            (['push', *DUFFING, '--state', 'x=1,y=1,x=2'], 'expected --state'),
            (['push', '--law', 'ruina', '--alpha', '0.3', '--state', 'x=1'],
             '--state'),
            (['push', *DUFFING, '--v', '1', '--psi', '1'], '--state'),
            (['study', *DUFFING, '--set', 'products=[knees]'], 'knees'),
            (['study', *DUFFING, '--set', 'system.parameters.e=1'],
             'no formula has it'),
            (['study', '--ode', "x' = y; y' = -x*drag; drog = 1; drag = 2",
              *DUFFING[2:]], 'drog: no formula has it (did you mean drag?)'),
            (['sweep', *DUFFING], 'the scene has none'),
            (['sweep', *DUFFING, *SWEEP, '--set', 'sweep.key=slope.alpha'],
             'expected system.parameters.NAME'),
            (['sweep', *DUFFING, *SWEEP, '--set', 'products=[nullclines]'],
             'not in a sweep')):
        refused(room.run(*words), 2, said)
    room.write('a.yaml', 'system: {rates: {x: y, y: -x}}\n'
                         'window: {x: [-1, 1], y: [-1, 1]}\n')
    for command in ('knees', 'simulate', 'rabinowicz'):
        refused(room.run(command, 'a.yaml'), 2,
                f'{command}: not for a system of formulas')
    for words in (['basin', 'a.yaml', '--exact'],):
        refused(room.run(*words), 2, 'a law on a slope')
    refused(room.run('export', 'a.yaml', '--as', 'xppaut'), 2, 'export')
    expect(set(os.listdir(room.folder)) <= {'.bin', 'a.yaml'}, room.folder)


CUT = '''law: {theta: ln(psi), psi_ss: 1/v + 1/v_0, T: 1/v, K: sinh(d)}
material: {v_0: 50}
slope: {alpha: 0.34}
'''


def names_of_a_law_s_own_are_set_swept_exported_and_recorded(room):
    room.write('a.yaml', CUT)
    for v_0 in (100, 1000):
        one = room.json('knees', 'a.yaml', '--set', f'material.v_0={v_0}')
        room.good('check', '--record', 'a.yaml', '--set',
                  f'material.v_0={v_0}', '-o', f'{v_0}.csv')
        expect('all hold' in room.good('check', f'{v_0}.csv'), v_0)
        many = room.good('sweep', 'a.yaml', '--set', 'sweep.key=material.v_0',
                         '--set', 'sweep.values=[100, 1000]')
        expect(f"{one['v_plus']['value']:.10g}"[:10] in many, many)
    room.good('export', 'a.yaml', '--as', 'xppaut', '-o', 'a.ode')
    expect('par v_0=50' in room.read('a.ode'), room.read('a.ode'))
    for key, said in (('material.w', 'material.w is not there'),
                      ('material.c', 'not used by this law')):
        refused(room.run('sweep', 'a.yaml', '--set', f'sweep.key={key}',
                         '--set', 'sweep.values=[1, 2]'), 2, said)
    refused(room.run('sweep', 'a.yaml', '--set', 'sweep.key=material.v_0',
                     '--set', 'sweep.values=[-1, 2]'), 2, 'of the sign')


CUBE = '''law: {theta: ln(psi), psi_ss: 1/v, T: 1/v,
      mu: mu_star + a*ln(v) + b*theta + q*ln(v)^WHICH + q*(ln(v)/8)^(2*n - 1)}
material: {n: 3, q: 1e-6}
slope: {alpha: 0.4}
'''


def whole_parameters_are_exponents_of_what_is_negative(room):
    def numbers(*words):
        found = room.json('knees', *words)
        del found['cost']
        return found
    room.write('n.yaml', CUBE.replace('WHICH', 'n'))
    room.write('3.yaml', CUBE.replace('WHICH', '3').replace('2*n - 1', '5'))
    expect(numbers('n.yaml')['saddle']['v']['value'] < 1, 'v')
    expect(numbers('n.yaml') == numbers('3.yaml'), 'others')
    for n in (-2, 0, 1, 4):
        room.write('m.yaml', CUBE.replace('WHICH', f'({n})').replace('2*n - 1', f'{2*n - 1}'))
        expect(numbers('m.yaml') == numbers('n.yaml', '--set', f'material.n={n}'), n)
    swept = room.json('sweep', 'n.yaml', '--set', 'sweep={key: material.n, values: [1, 2, 2.5, 3]}')
    psi = swept['numbers']['saddle_psi']
    for i, n in enumerate((1, 2, 2.5, 3)):
        one = numbers('n.yaml', '--set', f'material.n={n}')
        here = one.get('saddle', {}).get('psi', {}).get('value')
        expect(psi['value'][i] == here and (here is None) == (n == 2.5), n, psi, one)


def names_that_other_programs_have_are_numbers_there(room):
    room.write('a.yaml', '''law: {theta: ln(psi), psi_ss: alpha/v + lnv/50, T: A/v}
material: {alpha: 2, lnv: 1, A: 3}
slope: {alpha: 0.4}
''')
    room.good('export', 'a.yaml', '--as', 'xppaut', '--form', 'time', '-o', 'a.ode')
    text = room.read('a.ode')
    names = [name.lower() for name in re.findall(r'^par (\w+)=', text, re.M)]
    expect(len(names) == len(set(names)) and 'lnv' not in names, names)
    expect('par alpha=0.4\n' in text, text)
    expect('!k1=1/v0\n!k2=1/50\n!psi0=2*k1+k2\n' in text, text)


def a_law_without_a_slope_at_its_steady_state_is_no_node(room):
    law = ['--set', 'law={theta: ln(psi), psi_ss: 1/v, '
           'rate: "1 - v*psi + 1e-4*ln(v)^n"}', '--set', 'material.n=2.5']
    for words in (['knees'], ['push', '--v', '1', '--psi', '1']):
        refused(room.run(*words, *law, '--alpha', '0.38'), 3,
                'no slope at its steady state v = 0.113911, psi = 8.77878')


run_cases([a_straight_line_ends_where_it_comes_to_rest,
           where_branches_end_does_not_hang_on_the_accuracy,
           a_branch_that_is_lost_on_a_step_takes_shorter_ones,
           whole_parameters_are_exponents_of_what_is_negative,
           names_that_other_programs_have_are_numbers_there,
           names_of_a_law_s_own_are_set_swept_exported_and_recorded,
           a_law_without_a_slope_at_its_steady_state_is_no_node,
           json_is_as_the_interface_says, shares_are_halves,
           where_others_may_be_is_told,
           shares_beside_what_is_undecided_are_lower_bounds,
           spent_steps_are_a_reason_and_no_end, parameters_are_set,
           one_state_or_many_are_pushed,
           files_and_figures_have_the_names_of_states,
           margins_have_figures_where_there_are_two_fates,
           more_attractors_than_labels_are_refused, a_parameter_is_swept,
           tables_hold_systems,
           a_manifold_leaves_the_window_somewhere,
           pages_and_plans_tell_of_systems, what_is_wrong_costs_one_line])
