#!/usr/bin/python3
"""What the Python module tells is what the program tells (TAP)."""
import copy
import gc
import json
import math
import os
import pickle
import random

from cli_room import LAWS, expect, run_cases
from python_room import COMMAND, SLOPE, WELLS, WINDOW, prints

import h5py
import numpy
import slipway
from slipway import _c


def same(number, told):
    """A number of the module and one of JSON."""
    return (number.reason, told['value']) == (told['reason'], None) if (
        told['value'] is None) else (number.value, number.error) == (
            told['value'], told['error'])


def near(number, other):
    """Two ways to one number: within both bars, or neither has it and why."""
    return number.reason == other.reason and not (
        abs(number.value - other.value) > number.error + other.error)


def fails(kind, call):
    try:
        call()
    except slipway.Error as error:
        expect(type(error) is kind, type(error), error)
        return str(error)
    raise AssertionError(f'{kind} was expected')


# ---- what it tells -----------------------------------------------------------

def numbers_are_those_of_the_program(room):
    seed = random.randrange(1 << 32)
    print('# seed', seed)
    chance = random.Random(seed)
    for law in LAWS:
        alpha, a = chance.uniform(0.28, 0.4), chance.uniform(0.033, 0.037)
        told = room.json('knees', '--law', law, '--alpha', repr(alpha), '--set',
                         f'material.a={a!r}')
        s = slipway.Study(law, alpha, a=a)
        for name in ('v_plus', 'v_minus', 'x_excess', 'psi_at_v0', 'mu_s_num'):
            expect(same(getattr(s, name), told[name]), law, alpha, a, name)
        expect(same(s.folds_v_M, told['folds']['v_M']), law, alpha, a)
        for mine, theirs in zip(s.equilibria, told['equilibria'], strict=True):
            expect(mine.type == theirs['type'], law, alpha, a)
            expect(all(same(getattr(mine, name), theirs[name])
                       for name in ('v', 'psi', 'mu', 'lambda_plus')), law)


def a_scene_is_read_and_set(room):
    room.bring('scenes')
    told = room.json('knees', 'scenes/fig07b.yaml', '--set', 'material.a=0.034')
    s = slipway.Study.read(room.path('scenes/fig07b.yaml'), a=0.034)
    expect(abs(s.v_plus - told['v_plus']['value']) <= s.v_plus.error +
           told['v_plus']['error'] < 1e-9, s.v_plus, told['v_plus'])
    other = s.at(a=0.035, alpha_deg=19)
    again = other.at(alpha=0.34)
    expect(other.v_plus != s.v_plus and again.v_plus == slipway.Study.read(
        room.path('scenes/fig07b.yaml'), a=0.035, alpha=0.34).v_plus, again)
    expect(slipway.Study('dieterich_gen', numpy.array(0.34)).v_plus ==
           slipway.Study(**SLOPE).v_plus, 'an array of one')
    expect(same(slipway.Study(**SLOPE, mu_star=0.37, L=12e-6).v_plus,
                room.json('knees', *COMMAND, '--set', 'material.mu_star=0.37',
                          '--set', 'material.L=12e-6')['v_plus']), 'L')


def a_number_is_a_float_with_a_bar(_):
    s = slipway.Study(**SLOPE)
    v, none = s.v_plus, s.psi_at_v0
    expect(v == v.value == float(v) and abs(v - 2832.2233588540) < 1e-9, v)
    expect(0 < v.error < 1e-9 and v.reason is None and v.exists, v)
    expect(f'{v:.3f}' == '2832.223' and '+-' in f'{v}', v)
    expect(v / 2 == v.value / 2 and type(v / 2) is float, v)
    expect(math.isnan(none) and math.isnan(none.error) and not none.exists
           and 'never meets v = 0' in none.reason in repr(none), none)
    for one in (v, none, s.at(alpha=0.33).v_plus):
        again = pickle.loads(pickle.dumps(one))
        expect((repr(again), again.reason) == (repr(one), one.reason), again)
        expect(repr(copy.deepcopy(one)) == repr(one), one)


def curves_are_those_of_the_file(room):
    room.good('portrait', *COMMAND, '-o', 'p.h5')
    s = slipway.Study(**SLOPE)
    with h5py.File(room.path('p.h5')) as file:
        for name, branch in s.manifold.items():
            expect(len(branch.v) > 10, name)
            for column in branch._fields:
                if column in file['manifold'][name]:
                    expect(numpy.array_equal(getattr(branch, column),
                                             file['manifold'][name][column][:],
                                             equal_nan=True), name, column)


def curves_are_lent_and_outlive_the_study(_):
    s = slipway.Study(**SLOPE)
    branch = s.manifold['stable_upper']
    kept, copied = branch.v[3:9], branch.v[3:9].copy()
    expect(branch.v.base is not None and numpy.may_share_memory(
        branch.v, branch.psi) and not branch.v.flags.writeable, branch.v.flags)
    del s, branch
    gc.collect()
    [slipway.Study(**SLOPE).manifold for _ in range(20)]
    expect(numpy.array_equal(kept, copied), kept, copied)


def units(data):
    told = [data.attrs[name] for name in ('units', 'scale')
            if name in data.attrs]
    return [one.decode() if isinstance(one, bytes) else one for one in told]


def basins_are_those_of_the_file(room):
    products = ['margin', 'slip', 'time', 'friction', 'peak']
    room.good('basin', *COMMAND, '--set', 'basins.cells=[24,16]', '--set',
              f'products=[basins,{",".join(products)}]', '-o', 'b.h5')
    found = slipway.Study(**SLOPE).basin((24, 16), products)
    with h5py.File(room.path('b.h5')) as file:
        group = file['basin']
        for name in ('v', 'psi', *found.data_vars):
            expect(numpy.array_equal(found[name].values, group[name][:],
                                     equal_nan=True), name)
            expect(units(found[name]) == units(group[name]), name)
        expect(found.attrs['fraction_log_runaway'] ==
               group.attrs['fraction_log_runaway'], found.attrs)
        expect(found.label.attrs['flag_meanings'] ==
               group['label'].attrs['flag_meanings'].decode(), found.label)
    expect((found.label.dims, found.label.dtype) == (('psi', 'v'), 'i1'), found)


def pushes_are_those_of_the_program(room):
    states = [(100.0, 1.0), (1e4, 10.0), (3e3, 50.0), (1e-3, 0.01)]
    room.write('s.csv', 'v,psi\n' + ''.join(f'{v},{p}\n' for v, p in states))
    told = room.json('push', *COMMAND, '--states', 's.csv')['states']
    s = slipway.Study(**SLOPE)
    v, psi = numpy.array(states).T
    found = s.push(v.reshape(2, 2), psi.reshape(2, 2))
    expect(found.fate.shape == found.slip.shape == (2, 2), found)
    for k, (state, theirs) in enumerate(zip(states, told)):
        one = s.push(*state)
        expect(one.fate == theirs['fate'] == found.fate.flat[k], one, theirs)
        for name in ('slip', 'time', 'mu_mean', 'v_kick', 'psi_kick'):
            mine = getattr(found, name)[divmod(k, 2)]
            expect(same(mine, theirs[name]), name, mine, theirs)
            expect(repr(mine) == repr(getattr(one, name)), mine)
    expect(s.push(v[:0], 1.0).fate.shape == (0,), 'no states')


def pushes_of_an_uncertain_material_have_a_spread(room):
    scatter = '0.0349 +- 0.0005'
    told = room.json('push', *COMMAND, '--set', 'material.a=' + scatter,
                     '--v', '100', '--psi', '1')
    s = slipway.Study(**SLOPE, a=scatter)
    one, two = s.push(100, 1), s.push([100, 1000], 1)
    for name in ('slip', 'time', 'mu_mean', 'v_kick', 'psi_kick'):
        mine = getattr(one, name)
        expect(same(mine, told[name]), mine, told)
        expect(mine.spread == told[name]['spread'], mine, told)
        # several states are followed by tables, to what a difference bears
        expect(math.isclose(mine.spread, getattr(two, name)[0].spread,
                            rel_tol=1e-6), mine, two)
    expect(one.v_kick.spread > 0 and two.v_kick.spread[1] > 0, one, two)
    expect(numpy.isnan(slipway.Study(**SLOPE).push([100], 1).v_kick.spread))


def sweeps_are_those_of_the_file(room):
    grid = [{'key': 'slope.alpha', 'from': 0.28, 'to': 0.4, 'points': 4},
            {'key': 'material.a', 'values': [0.034, 0.035]}]
    room.good('sweep', '--law', 'dieterich_gen', '--set', 'sweep=' + json.dumps(
        grid).replace('"', ''), '-o', 's.h5')
    found = slipway.Study(**SLOPE).at(sweep=grid)
    found = slipway.sweep(found)
    with h5py.File(room.path('s.h5')) as file:
        group = file['sweep']
        for name in ('alpha', 'a', 'v_plus', 'v_plus_error', 'psi_at_v0',
                     'saddle_lambda_plus', 'mu_s_num_error'):
            expect(numpy.array_equal(found[name].values, group[name][:],
                                     equal_nan=True), name)
            expect(units(found[name]) == units(group[name]), name)
        missing = group['v_plus_exists'][:] != 1
    expect(found.v_plus.dims == ('alpha', 'a'), found.v_plus)
    expect((found.psi_at_v0_reason.values != None).sum() ==
           numpy.isnan(found.psi_at_v0).sum() > 0, found)
    expect(numpy.array_equal(missing, numpy.isnan(found.v_plus)), missing)
    line = slipway.Study(**SLOPE).sweep(alpha=found.alpha.values)
    alone = slipway.v_plus(**{**SLOPE, 'alpha': line.alpha})
    off = abs(line.v_plus.values - alone.value)
    expect(numpy.array_equal(numpy.isnan(off), ~alone.exists) and not (
        off > alone.error + line.v_plus_error.values).any(), line)


def arrays_of_materials_are_those_of_single_studies(_):
    seed = random.randrange(1 << 32)
    print('# seed', seed)
    chance = numpy.random.default_rng(seed)
    alpha = chance.uniform(0.28, 0.4, (4, 5))
    a = chance.normal(0.035, 0.001, 5)
    for law in ('spinodal_gen', 'dieterich_gen'):
        found = slipway.numbers(['v_plus', 'v_minus', 'x_excess'], law=law,
                                alpha=alpha, a=a, b=0.055)
        for at in numpy.ndindex(4, 5):
            one = slipway.Study(law, alpha[at], a=a[at[1]], b=0.055)
            for name, numbers in found.items():
                expect(near(numbers[at], getattr(one, name)), law, at)
    s = slipway.Study('dieterich_gen', 0.34)
    one = s.batch('v_plus', alpha=[0.34])['v_plus'][0]
    expect(near(one, s.v_plus) and
           one == slipway.v_plus('dieterich_gen', 0.34), s)
    expect(list(found.frame()) == ['v_plus', 'v_plus_error', 'v_minus',
                                   'v_minus_error', 'x_excess',
                                   'x_excess_error'], found.frame())
    v = found['v_plus']
    expect((numpy.log(v)[0] == numpy.log(v.value)[0]).all() and
           ((2 * v > 3) == (2 * v.value > 3)).all(), v)
    bad = slipway.v_plus(**{**SLOPE, 'alpha': [0.34, -1, math.nan]})
    expect(near(bad[0], s.v_plus) and not bad.exists[1:].any()
           and 'slope.alpha' in bad[1].reason, bad.reason)


def systems_are_those_of_the_program(room):
    told = room.json('basin', '--ode', WELLS, '--window', 'x=-2:2,y=-2:2',
                     '--set', 'system.parameters.d=0.1')
    s = slipway.System(WELLS, window=WINDOW, d=0.1)
    expect(s.complete is told['equilibria_complete'] is True, told)
    expect(s.states == ('x', 'y'), s.states)
    for mine, theirs in zip(s.equilibria, told['equilibria'], strict=True):
        expect((mine.name, mine.type) == (theirs['name'], theirs['type']), mine)
        for k, name in enumerate('xy'):
            expect(same(mine.state[k], theirs['state'][name]), mine, theirs)
            expect(same(mine.re[k], theirs['eigenvalues'][k]['re']), mine)
    for share in told['shares']:
        expect(same(s.shares[share['attractor']], share['fraction']), share)
    for mine, theirs in zip(s.manifolds, told['manifolds'], strict=True):
        expect((mine.kind, mine.branch, mine.end) == (
            theirs['kind'], theirs['branch'], theirs['end']), mine, theirs)
        expect(len(mine.arc) == len(mine.state[1]) > 10, mine)
        expect(abs(mine.state[0][0]) + abs(mine.state[1][0]) < 1e-9, mine)
    goals = s.goal([1.0, -1.0], 1.0)
    one = s.goal(1.0, 1.0)
    expect(list(goals.attractor) == ['stable_focus_0', 'stable_focus_0'] or
           goals.attractor[0] == one.attractor, goals)
    expect(repr(goals.kick[0][0]) == repr(one.kick[0]), goals)
    room.write('m.ode', 'dx/dt = y\ndy/dt = x - x^3 - d*y\nparam d=0.1\n'
                        '@ xlo=-2 xhi=2 ylo=-2 yhi=2\ndone\n')
    expect(slipway.System.read(room.path('m.ode')).shares == s.shares, 'XPPAUT')
    genes = slipway.System("u' = a/(1 + v^2) - u\nv' = a/(1 + u^2) - v", a=3,
                           state={'u': 'positive', 'v': 'positive'},
                           window={'u': [0.05, 5], 'v': [0.05, 5]})
    expect(genes.goal(0.5, 2.0).attractor == 'stable_node_0', genes.equilibria)


# ---- what fails --------------------------------------------------------------

def failures_have_the_line_of_the_program(room):
    """But for its name, which stands first there."""
    room.write('w.yaml', 'law: {preset: ruina}\nslope: {alpha: 0.34}\n'
                         'window: {v: [2, 1]}\n')
    room.write('o.ode', 'dx/dt = y\ndy/dt = sine(x)\ndone\n')
    os.chdir(room.folder)
    S, D = slipway.Study, slipway.System
    for args, call in (
            (['knees', '--law', 'ruine', '--alpha', '0.34'],
             lambda: S('ruine', 0.34)),
            (['knees', '--set', 'law.preset=ruina', '--set', 'slope.alpha=7'],
             lambda: S('ruina', 7)),
            (['knees', '--law', 'ruina', '--set', 'slope.alpha=0.34', '--set',
              'material.b=nan'], lambda: S('ruina', 0.34, b=math.nan)),
            (['knees', '--set', 'aplha=0.34'], lambda: S(aplha=0.34)),
            (['knees', 'w.yaml'], lambda: S.read('w.yaml')),
            (['knees', '--set', 'law.preset=ruina'], lambda: S('ruina')),
            (['portrait', 'o.ode'], lambda: D.read('o.ode')),
            (['sweep', '--law', 'ruina', '--set', 'sweep.key=slope.beta'],
             lambda: S('ruina', 0.34).sweep(**{'slope.beta': [1]}))):
        done = room.run(*args)
        expect(done.returncode == 2, done)
        said, line = fails(slipway.BadScene, call), done.stderr
        last = line.rstrip('\n').removeprefix('slipway: ').split(': ')[-1]
        expect(said.endswith(last), said, line)
    line = room.run('knees', 'w.yaml').stderr.rstrip('\n')
    expect('slipway: ' + fails(slipway.BadScene, lambda: S.read('w.yaml'))
           == line, line)


def each_kind_of_failure_has_its_class(room):
    S = slipway.Study
    said = fails(slipway.FileTrouble, lambda: S.read('/nowhere/a.yaml'))
    expect(said == '/nowhere/a.yaml: cannot read: No such file or directory',
           said)
    s = S(**SLOPE)
    for state in ((-1, 1), (math.nan, 1), (1, math.inf)):
        expect('state 0' in fails(slipway.BadArgument, lambda: s.push(*state)),
               state)
    expect('state 1' in fails(slipway.BadArgument,
                              lambda: s.push([1, -1], 1)), 'array')
    said = fails(slipway.BadArgument,
                 lambda: slipway.numbers(['v_plsu'], **SLOPE))
    expect('v_plsu' in said, said)
    said = fails(slipway.BadArgument, lambda: slipway.v_plus(
        **SLOPE, **{'material.z': [1]}))
    expect('material.z' in said, said)
    fails(slipway.BadArgument, lambda: slipway.System(
        WELLS, window=WINDOW, d=0.1).goal(math.nan, 0))
    text = {kind: _c.library.status_text(k).decode()
            for k, kind in enumerate(_c.ERRORS)}
    for kind in _c.ERRORS[1:]:
        expect(fails(kind, lambda: _c.check(_c.ERRORS.index(kind))) ==
               text[kind] != text[None], kind)
        expect(issubclass(kind, slipway.Error), kind)
    for kind, builtin in ((slipway.BadScene, ValueError),
                          (slipway.FileTrouble, OSError),
                          (slipway.OutOfMemory, MemoryError)):
        expect(issubclass(kind, builtin), kind)
    code = ('import resource, slipway\n'
            'kept = [slipway.Study("dieterich_gen", 0.34)]\n'
            'size = 4096 * int(open("/proc/self/statm").read().split()[0])\n'
            'resource.setrlimit(resource.RLIMIT_AS, (size + (1 << 20),) * 2)\n'
            'try:\n    while True:\n'
            '        kept.append(slipway.Study("dieterich_gen", 0.34))\n'
            'except slipway.OutOfMemory as why:\n    kept.clear(), print(why)')
    expect(prints(room, code) == 'out of memory\n', 'memory')


def what_is_not_there_is_an_attribute_error(_):
    s = slipway.Study(**SLOPE)
    for name in ('v_plsu', '_repr_png_', '__array_interface__'):
        expect(not hasattr(s, name), name)
    for call, kind in ((lambda: slipway.Study(**SLOPE, a=object()), TypeError),
                       (lambda: s.push('fast', 1), TypeError),
                       (lambda: slipway.v_plus(**{**SLOPE, 'alpha': ['x']}),
                        TypeError),
                       (lambda: slipway.v_plus('ruina', [0.3], threads='2'),
                        TypeError),
                       (lambda: s.push([1j], 1), TypeError),
                       (lambda: setattr(s, 'alpha', 0.33), AttributeError),
                       (lambda: slipway.v_plus(**{**SLOPE, 'alpha': [1, 2]},
                                               a=[1, 2, 3]), ValueError),
                       (lambda: s.push([1, 2], [1, 2, 3]), ValueError)):
        try:
            call()
        except kind:
            continue
        raise AssertionError(kind)


run_cases([
    numbers_are_those_of_the_program,
    a_scene_is_read_and_set,
    a_number_is_a_float_with_a_bar,
    curves_are_those_of_the_file,
    curves_are_lent_and_outlive_the_study,
    basins_are_those_of_the_file,
    pushes_are_those_of_the_program,
    pushes_of_an_uncertain_material_have_a_spread,
    sweeps_are_those_of_the_file,
    arrays_of_materials_are_those_of_single_studies,
    systems_are_those_of_the_program,
    failures_have_the_line_of_the_program,
    each_kind_of_failure_has_its_class,
    what_is_not_there_is_an_attribute_error,
])
