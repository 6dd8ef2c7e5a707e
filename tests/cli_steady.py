#!/usr/bin/env python3
"""Friction laws, stick-slip, bifurcation and fold curves as users call them
(TAP).

usage: cli_steady.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import json
import math

from cli_room import expect, refused, run_cases, shown

SCENES = {'fig01a': 'friction_law', 'fig01b': 'spring_block',
          'fig03': 'bifurcation', 'fig04': 'fold_curves', 'fig10': 'chi'}
LAW = ['study', '--law', 'spinodal_gen', '--alpha', '0.34']
V_M, V_m = 0.02493158, 405.1126
A_cM, A_cm = 0.38453358433302, 0.29321673817884
READ = '''
import h5py, json, sys
found = {}
def see(name, d):
    if isinstance(d, h5py.Dataset):
        axis = d.dims[0][0].name if d.ndim and len(d.dims[0]) else None
        text = d.attrs.get('long_name')
        found[d.name] = {'axis': axis, 'shape': d.shape, 'told': bool(text),
            'units': str(d.attrs.get('units', b''), 'utf-8', 'ignore')
                     if isinstance(d.attrs.get('units', b''), bytes)
                     else d.attrs['units'],
            'values': d[()].tolist() if d.dtype.kind in 'fi' else None}
with h5py.File('a.h5') as f:
    f.visititems(see)
    for name in 'sigma', 'mass':
        if 'spring_block' in f:
            found[name] = float(f['spring_block'].attrs[name])
json.dump(found, sys.stdout)
'''


def asking(*products):
    return ['--set', f'products=[{", ".join(products)}]']


def columns(room, group):
    """The data sets straight in a group of a.h5, each told of in full."""
    found = json.loads(room.reads(READ))
    for name, item in found.items():
        if name.startswith('/' + group):
            expect(item['told'], name, 'has no long_name')
    near = {name.rsplit('/', 1)[1]: item for name, item in found.items()
            if name.startswith('/') and name.rsplit('/', 1)[0] == '/' + group}
    return near, found


# ---- what runs and what is written -------------------------------------------

def a_scene_of_the_paper_runs_its_own_stage_only(room):
    room.bring('scenes')
    room.make('outputs')
    for scene, product in SCENES.items():
        args = [f'scenes/{scene}.yaml', '-o', 'a.h5', '--figure', 'a.svg']
        stages = [s['stage'] for s in room.json('plan', *args)]
        expect(stages == [product], scene, stages)
        found = room.json('study', *args)
        expect(found['cost']['field_evaluations'] <= 8, scene, found['cost'])
        expect(product in found and 'knees_upper' not in found, list(found))
        groups = [item['path'] for item in room.json('info', 'a.h5')
                  if item['kind'] == 'group']
        expect('/' + product in groups and '/saddle' not in groups, groups)
        expect('\nslope:' not in room.read(f'scenes/{scene}.yaml'), scene)
        others = set(SCENES.values()) - {product}
        expect(not others & {g[1:] for g in groups}, scene, groups)


def friction_laws_are_curves_over_v(room):
    room.good(*LAW, *asking('friction_law'), '-o', 'a.h5')
    for group in 'friction_law', 'friction_law/dieterich':
        near, _ = columns(room, group)
        for name in 'psi', 'mu', 'slope', 'mu_error', 'mu_exists':
            expect(near[name]['axis'] == f'/{group}/v', group, name,
                   near[name]['axis'])
        v, mu = near['v']['values'], near['mu']['values']
        expect(v == sorted(v) and len(v) > 400 and v[0] == 1e-6, v[:3])
        error = max(near['mu_error']['values'])
        expect(error < 1e-15, error)
    for at, expected in zip(v, mu):  # Dieterich's, by hand
        by_hand = 0.0349 * math.asinh(
            math.exp((0.369 - 0.014 * math.log(at)) / 0.0349) / 2)
        expect(abs(expected - by_hand) < 1e-14, at, expected, by_hand)
    near, _ = columns(room, 'friction_law/extrema')
    expect(near['kind']['values'] == [0, 1], near['kind'])
    expect([round(x, 8 - 6 * i) for i, x in enumerate(near['v']['values'])]
           == [0.02493158, 405.11], near['v']['values'])


def one_dieterich_is_enough(room):
    room.good('study', '--law', 'dieterich', '--alpha', '0.3',
              *asking('friction_law', 'spring_block'), '-o', 'a.h5')
    _, found = columns(room, 'friction_law')
    expect(not [name for name in found if 'dieterich' in name], list(found))
    room.good('study', '--alpha', '0.3', '--set', 'law={theta: ln_psi, '
              'psi_ss: inverse, timescale: spinodal, kinetics: linear}',
              *asking('friction_law', 'spring_block'), '-o', 'a.h5')
    _, found = columns(room, 'friction_law')  # alike as long as they do not move
    expect('/spring_block/dieterich/k' in found
           and '/friction_law/dieterich/mu' not in found, list(found))


def the_stick_slip_boundary_is_in_pascal_per_metre(room):
    room.good(*LAW, *asking('spring_block'), '-o', 'a.h5', '--set',
              'spring_block={sigma: 2000, mass: 50, v: [1e-3, 1e3]}')
    near, found = columns(room, 'spring_block')
    expect((found['sigma'], found['mass']) == (2000, 50), found['sigma'])
    expect(near['k']['units'] == 'Pa/m' and near['v']['units'] == '1', near)
    for v, k, light in zip(*(near[name]['values'] for name in
                             ('v', 'k', 'k_quasistatic'))):
        expect((not math.isnan(k)) == (V_M < v < V_m), v, k)
        expect(math.isnan(k) or 0 < light < k < 2000 * 0.014 / 0.9e-6 * 3, v)
    near, _ = columns(room, 'spring_block/dieterich')
    k = near['k_quasistatic']['values']
    textbook = 2000 * (0.0489 - 0.0349) / 0.9e-6
    expect(all(abs(x / textbook - 1) < 1e-3 for x in k), min(k), max(k))


def a_block_weighs_what_presses_it_unless_said(room):
    for gravity in '9.81', '1.62':
        found = room.json(*LAW, *asking('spring_block'), '--set',
                          'gravity=' + gravity)['spring_block']
        expect(found['sigma'] == 1000, found)
        expect(abs(found['mass'] - 1000 / float(gravity)) < 1e-12, found)


def the_bifurcation_diagram_has_its_equilibria_on_it(room):
    room.good(*LAW, *asking('bifurcation'), '-o', 'a.h5')
    near, _ = columns(room, 'bifurcation')
    expect(near['alpha']['units'] == 'rad', near['alpha']['units'])
    v, alpha, kind = (near[name]['values'] for name in ('v', 'alpha', 'type'))
    for i, at in enumerate(v):  # saddle 0, stable_node 1, saddle_node 2
        inside = V_M < at < V_m
        expect(kind[i] == 2 or kind[i] == (0 if inside else 1), at, kind[i])
    expect(kind.count(2) == 2, kind.count(2))
    steps = [i for i in range(1, len(v))
             if (alpha[i] - 0.34) * (alpha[i - 1] - 0.34) <= 0]
    states = room.json(*LAW, *asking('equilibria'))['equilibria']
    expect(len(steps) == len(states) == 3, steps)
    for i, state in zip(steps, states):
        expect(v[i - 1] <= state['v']['value'] <= v[i], v[i], state)
    near, _ = columns(room, 'bifurcation/folds')
    for found, expected in zip(near['alpha']['values'], (A_cM, A_cm)):
        expect(abs(found - expected) < 1e-13, found, expected)


def fold_curves_reach_the_cusp(room):
    room.good(*LAW, *asking('fold_curves'), '-o', 'a.h5')
    near, found = columns(room, 'fold_curves')
    c = near['c']['values']
    expect(near['alpha_cM']['axis'] == '/fold_curves/c', near['alpha_cM'])
    cusp = found['/fold_curves/cusp/c']['values']
    error = found['/fold_curves/cusp/c_error']['values']
    expect(abs(cusp - 2.899900973274503) < 1e-12 and 0 < error < 1e-14, cusp)
    expect(c == sorted(c) and c[0] == 1e-14 and cusp * 0.999 < c[-1] < cusp,
           c[0], c[-1])
    said = room.json(*LAW, *asking('fold_curves'))['fold_curves']['cusp']
    expect(said['c']['value'] == cusp and said['c']['error'] == error, said)
    for row in room.reference('folds.csv'):
        if (row['tag'], row['form']) != ('R100', 'asinh') or row['c'] == '0':
            continue
        one = ['--set', f'fold_curves.c=[{row["c"]}, 10]', '-o', 'a.h5']
        room.good(*LAW, *asking('fold_curves'), *one)
        near, _ = columns(room, 'fold_curves')
        for name in ('v_M', 'v_m', 'alpha_cM', 'alpha_cm') if row['v_M'] else ():
            expected = float(row[name])
            off = abs(near[name]['values'][0] / expected - 1)
            expect(off < 1e-12 / max(0.1, 1 - float(row['c']) / cusp), row,
                   name, off)


def chi_is_a_table_of_slopes_and_slip_rates(room):
    alphas = [0.34, 0.2, 0.38]
    args = [*LAW, *asking('chi'), '--set', f'chi.alpha={alphas}', '-o', 'a.h5']
    said = room.json(*args)['chi']
    near, _ = columns(room, 'chi')
    expect(near['alpha']['values'] == alphas, near['alpha'])
    v = near['v']['values']
    expect(v == sorted(v) and (v[0], v[-1]) == (1e-6, 1e6), v[0], v[-1])
    for name in 'v_sp0', 'v_low', 'v_high', 'v_low_error':
        expect(near[name]['axis'] == '/chi/alpha', name, near[name]['axis'])
    for i, row in enumerate(said):
        expect(row['alpha'] == alphas[i], row)
        ends = [near[name]['values'][i] for name in ('v_low', 'v_high')]
        expect([row['v_low']['value'], row['v_high']['value']] == ends, row)
        for at, ln_chi, error in zip(v, near['ln_chi']['values'][i],
                                     near['ln_chi_error']['values'][i]):
            expect((ln_chi < 0) == (ends[0] < at < ends[1]), at, ln_chi, ends)
            expect(0 < error < 1e-11 * (1 + 1 / at), at, error)
    expect(round(said[0]['v_low']['value'], 4) == 0.0503
           and round(said[0]['v_high']['value'], 1) == 1312.6, said[0])


# ---- what people see ---------------------------------------------------------

def people_read_extrema_and_cusp_with_their_errors(room):
    said = room.good(*LAW, *asking(*SCENES.values()))
    for words in ('extrema of mu_ss', 'maximum', 'minimum', '0.384533584333017',
                  '2.8999009732745', 'spring_block_stiffest_k ', '+- '):
        expect(words in said, words, said)


def figures_are_labelled_as_in_the_paper(room):
    room.bring('scenes')
    words = {
        'fig01a': ['friction coefficient μss', 'slip rate V (m/s)',
                   'Dieterich law', 'Generalised spinodal law',
                   'VM = 2.493×10−8 m/s',
                   'Vm = 4.051×10−4 m/s'],
        'fig01b': ['spring stiffness k (Pa/m)', 'stick-slip', 'no inertia',
                   'with inertia', 'VM = 2.493×10−8 m/s'],
        'fig03': ['slope angle α (rad)', 'stable (node)', 'unstable (saddle)',
                  'αcM = 0.384534', 'αcm = 0.293217'],
        'fig04': ['residual strength c', 'metastable domain', 'cusp',
                  'c = 2.8999'],
        'fig10': ['χ(v)', 'slip rate v = V/V∗', 'α = 0.2 rad',
                  'α = 0.38 rad', 'χ(v) = 1'],
    }
    for scene, wanted in words.items():
        room.good('study', f'scenes/{scene}.yaml', '-o', 'a.h5', '--figure',
                  'a.svg')
        found = shown(room.read('a.svg'))
        for text in wanted:
            expect(text in found, scene, text, found)
        expect('…' not in found, scene, 'a text is cut')


def units_of_the_scene_are_those_of_the_axes(room):
    for product in 'friction_law', 'spring_block', 'bifurcation', 'chi':
        room.good(*LAW, *asking(product), '--figure', 'a.svg')
        expect('v = V/V∗' in shown(room.read('a.svg')), product)
        room.good(*LAW, *asking(product), '--set', 'units=si', '--figure',
                  'b.svg')
        expect('V (m/s)' in shown(room.read('b.svg')), product)


def what_a_law_does_not_have_is_said_and_no_error(room):
    said = room.good('study', '--law', 'ruina', '--alpha', '0.3',
                     *asking(*SCENES.values()), '-o', 'a.h5')
    expect('note: the law does not use c' in said, said)
    expect('extrema of mu_ss\n  none\n' in said, said)
    expect('note: the estimate needs hyperbolic kinetics' in said, said)
    for product in SCENES.values():
        room.good('study', '--law', 'ruina', '--alpha', '0.3',
                  *asking(product), '--figure', 'a.svg')


def wrong_ranges_are_refused(room):
    for key, words in (('spring_block.sigma=0', 'number > 0'),
                       ('spring_block.mass=-1', 'number >= 0'),
                       ('spring_block.v=[2, 1]', 'lo < hi'),
                       ('fold_curves.c=[0, 1]', 'number from'),
                       ('fold_curves.alpha=1', 'expected c')):
        refused(room.run(*LAW, *asking('fold_curves'), '--set', key), 2,
                words)
    for alpha in '[0]', '[0.3, 2]', '0.3', '[]':
        refused(room.run(*LAW, *asking('chi'), '--set', 'chi.alpha=' + alpha),
                2, '1 to 64 angles in rad')


if __name__ == '__main__':
    run_cases([
        a_scene_of_the_paper_runs_its_own_stage_only,
        friction_laws_are_curves_over_v,
        one_dieterich_is_enough,
        the_stick_slip_boundary_is_in_pascal_per_metre,
        a_block_weighs_what_presses_it_unless_said,
        the_bifurcation_diagram_has_its_equilibria_on_it,
        fold_curves_reach_the_cusp,
        chi_is_a_table_of_slopes_and_slip_rates,
        people_read_extrema_and_cusp_with_their_errors,
        figures_are_labelled_as_in_the_paper,
        units_of_the_scene_are_those_of_the_axes,
        what_a_law_does_not_have_is_said_and_no_error,
        wrong_ranges_are_refused,
    ])
