#!/usr/bin/env python3
"""slipway sweep as users call it (TAP).

usage: cli_sweep.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import json
import os
import random
import re
import signal
import subprocess
import time

from cli_room import expect, refused, run_cases, shown

SCENE = 'scenes/sweep.yaml'
KNEES = 'products=[equilibria, folds, knees, estimates]'


def line(points, more=''):
    return ['--law', 'spinodal_gen', '--set', 'sweep={key: slope.alpha, from: '
            f'0.28, to: 0.4, points: {points}{more}}}']


def read(room, name, *numbers):
    return json.loads(room.reads('read_sweep.py', name, *numbers))


# ---- results -----------------------------------------------------------------


def the_example_scene_gives_file_figure_and_table(room):
    room.bring('scenes')
    room.make('outputs')
    said = room.good('sweep', SCENE)
    for words in ('wrote outputs/sweep.h5', 'wrote outputs/sweep.svg',
                  'alpha          saddle_v', 'v_plus is missing at',
                  'there is no saddle at this slope'):
        expect(words in said, words, said)
    expect(room.names('outputs') == ['sweep.h5', 'sweep.svg'],
           room.names('outputs'))
    found = read(room, 'outputs/sweep.h5')
    alpha = found['axes']['alpha']
    expect(41 < len(alpha) < 400 and alpha[0] == 0.28 and alpha[-1] == 0.4,
           alpha)
    words = set(found['v_plus']['words'])
    expect(words == {'present', 'there_is_no_saddle_at_this_slope'}, words)
    first = room.bytes('outputs/sweep.h5')
    room.good('study', SCENE)  # the same, by its other name
    expect(room.bytes('outputs/sweep.h5') == first, 'study SCENE')


def each_point_is_what_knees_says(room):
    found = room.json('sweep', *line(7), '-o', 'a.h5')
    stored = read(room, 'a.h5')
    alphas = found['keys'][0]['values']
    expect(found['keys'][0]['key'] == 'slope.alpha' and found['points'] == 7
           and found['failed'] == 0 and stored['axes']['alpha'] == alphas,
           found['keys'], stored['axes'])
    for i, alpha in enumerate(alphas):
        knees = room.json('knees', '--law', 'spinodal_gen', '--alpha',
                          repr(alpha))
        for name in ('v_plus', 'v_minus', 'ln_v_plus', 'x_excess', 'mu_s_num'):
            swept = {key: values[i]
                     for key, values in found['numbers'][name].items()}
            expect(knees[name]['value'] == swept['value'], name, alpha)
            if swept['value'] is None:
                expect(knees[name]['reason'] == found['reasons'][
                    swept['reason']], name, alpha)
            else:
                expect(knees[name]['error'] == swept['error'], name, alpha)
        expect(stored['v_plus']['value'][i] == knees['v_plus']['value'], alpha)
        expect(found['numbers']['upper_end'][i] == knees.get('upper_end'),
               alpha)


def a_grid_is_a_cube_over_both_keys(room):
    grid = ('sweep=[{key: slope.tan_alpha, values: [0.3, 0.35, 0.4, 0.45]}, '
            '{key: material.c, from: 1e-4, to: 1e-2, points: 3, scale: log}]')
    room.good('sweep', '--law', 'spinodal_gen', '--set', grid, '--set',
              'products=[knees]', '-o', 'a.h5', '--figure', 'a.svg')
    room.reads('open_file.py', 'a.h5')
    found = read(room, 'a.h5')
    expect(found['keys'] == ['slope.tan_alpha', 'material.c']
           and found['axes']['c'][0] == 1e-4 and found['axes']['c'][2] == 1e-2
           and len(found['v_plus']['value']) == 12, found['axes'])
    one = room.json('knees', '--law', 'spinodal_gen', '--set',
                    'slope.tan_alpha=0.35', '--set',
                    f'material.c={found["axes"]["c"][1]!r}')
    expect(found['v_plus']['value'][4] == one['v_plus']['value'], one)
    expect('ln v+' in shown(room.read('a.svg')), 'the bar of the map')


def a_map_over_even_points_has_contours_with_labels(room):
    for last, even in ((0.36, True), (0.35, False)):
        room.good('sweep', '--law', 'spinodal_gen', '--set', 'sweep=[{key: '
                  'material.a, from: 0.01, to: 0.03, points: 5}, {key: '
                  f'slope.alpha, values: [0.30, 0.32, 0.34, {last}]}}]', '-q',
                  '--figure', 'a.svg', '--keep-script')
        data = room.read('a.dat')
        labels = re.findall(r'label of a contour\n\S+ \S+ "(.*)"', data)
        expect((': contour' in data) == even and bool(labels) == even, data)
        bar = re.search(r'set cbtics.*', room.read('a.gp')).group()
        expect(all(f"'{label}'" in bar for label in labels), labels, bar)


def a_figure_shows_both_critical_velocities(room):
    room.good('sweep', *line(9), '--figure', 'a.svg', '--keep-script')
    drawn = shown(room.read('a.svg'))
    for words in ('v+', 'v−', 'v at the saddle', 'slope angle α (rad)'):
        expect(words in drawn, words)


SHOWS = {
    'velocities': ['v+', 'v−', 'v at the saddle', 'upper knee'],
    'velocity_estimates': ['exact v+', 'exact v−', 'ξ = 0.85', 'ξ = 0.999'],
    'persistence': ['xk, (30)', 'xk, (31)', 'exact excess slip'],
    'static_friction': ['(41), exact v+', 'exact mean', 'ξ = 0.9'],
    'fracture_energy': ['fracture energy G', 'exact v+', 'ξ = 0.99'],
}


def a_figure_shows_what_is_asked_for(room):
    for show, entries in SHOWS.items():
        room.good('sweep', *line(9, f', show: {show}'), '--figure', 'a.svg')
        drawn = shown(room.read('a.svg'))
        for words in entries:
            expect(words in drawn, show, words)
    room.good('sweep', *line(9, ', show: persistence'), '--set',
              'products=[knees]', '--figure', 'a.svg')
    drawn = shown(room.read('a.svg'))
    expect('exact excess slip' in drawn and 'xk' not in drawn, 'no estimates')
    room.good('sweep', *line(9, ', show: static_friction'), '--set',
              'estimates.xi=[0.5]', '--figure', 'a.svg')
    drawn = shown(room.read('a.svg'))
    expect('ξ = 0.5' in drawn and 'ξ = 0.9' not in drawn, 'its own xi')


def shares_of_basins_are_drawn(room):
    room.good('sweep', *line(5, ', show: basins'), '--set', 'products=[basins]',
              '--set', CELLS, '--figure', 'a.svg')
    drawn = shown(room.read('a.svg'))
    expect('share of the window' in drawn and 'creeps' in drawn
           and 'slides' in drawn, 'entries')


def its_upward_axis_can_be_chosen(room):
    def drawn(more):
        room.good('sweep', *line(9, ', show: persistence' + more), '--figure',
                  'a.svg', '--keep-script')
        return room.read('a.gp')

    expect('set logscale y' not in drawn('')
           and 'set logscale y' in drawn(', y_scale: log'), 'the scale')
    expect('set yrange [0.25:2.5]' in drawn(', y_range: [0.25, 2.5]')
           and 'set yrange [0.25:2.5]' not in drawn(''), 'the range')


def a_grid_shows_the_table_s_exact_number(room):
    grid = ('sweep=[{key: slope.alpha, values: [0.3, 0.35]}, {key: material.c, '
            'values: [1e-4, 1e-3], show: %s}]')
    for show, words in (('persistence', 'excess slip'),
                        ('static_friction', 'mean static friction μs')):
        room.good('sweep', '--law', 'spinodal_gen', '--set', grid % show,
                  '--figure', 'a.svg')
        expect(words in shown(room.read('a.svg')), show)


def wrong_words_of_the_figure_are_refused(room):
    for more, words in (
            ('show: persistance', 'did you mean persistence?'),
            ('show: 3', 'velocities, velocity_estimates'),
            ('y_scale: cubic', 'expected auto, linear or log'),
            ('y_range: [2, 1]', 'expected lo < hi'),
            ('y_range: [0, 1]', 'on a log axis')):
        refused(room.run('sweep', *line(3, ', ' + more)), 2, words,
                'sweep.' + more.split(':')[0])
    refused(room.run('sweep', *line(3, ', show: persistence'), '--set',
                     'products=[folds]'), 2, 'neither knees nor estimates')
    expect(room.names() == [], room.names())


def threads_do_not_matter(room):
    refine = ', refine: 0.1'
    for threads in ('1', '2', '5'):
        room.good('sweep', *line(9, refine), '-o', f'{threads}.h5',
                  '--threads', threads)
        expect(room.bytes(f'{threads}.h5') == room.bytes('1.h5'), threads)


def plan_tells_of_the_points(room):
    room.bring('scenes')
    said = room.good('plan', SCENE)
    for words in ('41 points: slope.alpha at 41 values from 0.28 to 0.4, '
                  'refined to 0.01', 'estimates', 'outputs/sweep.h5'):
        expect(words in said, words, said)
    expect(room.json('plan', SCENE)[0]['points'] == 41, 'in JSON too')


# ---- products ----------------------------------------------------------------

CELLS = 'basins={cells: [5, 4], audit: 3, rtol: 1e-3}'
STARTS = 'trajectories.starts=[{v: 1e3, psi: 1}, {v: 0.01, psi: 10}]'
# Points, settings, and the axes of some of the data sets.
PRODUCTS = {
    'equilibria': (100, [], {'creep_ln_v': ['alpha'],
                             'sliding_lambda_plus': ['alpha'],
                             'equilibria_2_psi': ['alpha']}),
    'folds': (150, [], {'folds_alpha_cM': ['alpha']}),
    'knees': (60, [], {'knee_upper_v': ['alpha'], 'upper_end': ['alpha']}),
    'estimates': (60, [], {'estimates_chi_v_plus': ['alpha']}),
    'sensitivities': (5, [],
                      {'v_plus_conditioning': ['alpha']}),
    'taylor_series': (50, [], {'taylor_series_radius': ['alpha'],
                                'taylor_series_coefficient':
                                ['alpha', 'order']}),
    'trajectories': (7, [STARTS], {
        'trajectory_fate': ['alpha', 'start'],
        'trajectory_rest_time_exists': ['alpha', 'start'],
        'trajectory_phase_end_slip': ['alpha', 'start', 'phase'],
        'trajectory_mu_nears_time_error': ['alpha', 'start', 'level'],
        'start_v': ['start']}),
    'basins': (9, [CELLS], {'basin_fraction_linear_creep': ['alpha'],
                             'basin_audit_cells': ['alpha'],
                             'basin_label': ['alpha', 'psi', 'v']}),
    'margin': (9, [CELLS], {'basin_margin_psi': ['alpha', 'psi', 'v']}),
    'slip': (5, [CELLS], {'basin_slip': ['alpha', 'psi', 'v'],
                          'basin_slip_error': ['alpha', 'psi', 'v'],
                          'basin_exit_reason': ['alpha', 'psi', 'v']}),
    'time': (5, [CELLS], {'basin_time_error': ['alpha', 'psi', 'v']}),
    'friction': (5, [CELLS], {'basin_mu_mean': ['alpha', 'psi', 'v']}),
    'peak': (3, [CELLS], {'basin_v_peak': ['alpha', 'psi', 'v'],
                          'basin_mu_peak_error': ['alpha', 'psi', 'v']}),
    'field_arrows': (60, [], {'arrow_log10_speed':
                              ['alpha', 'arrow_psi', 'arrow_v']}),
    'chi': (60, [], {'chi_v_low': ['alpha', 'chi_alpha'],
                     'chi_ln_chi_error': ['alpha', 'chi_alpha', 'chi_v']}),
    'rabinowicz': (100, ['rabinowicz={block_mass: 0.1, ball_mass: 0.01, '
                         'restitution: 0.5}'],
                   {'rabinowicz_l_k': ['alpha']}),
}


def asking(product):
    points, sets, dims = PRODUCTS[product]
    names = 'folds' if product == 'rabinowicz' else product
    args = line(points) + ['--set', f'products=[{names}]']
    for item in sets:
        args += ['--set', item]
    return args, dims


def every_product_is_a_cube_at_any_number_of_threads(room):
    for product in PRODUCTS:
        args, _ = asking(product)
        for file, threads in (f'{product}.h5', '1'), ('2.h5', '2'):
            room.good('sweep', *args, '-o', file, '--threads', threads)
        expect(room.bytes(file) == room.bytes(f'{product}.h5'), product)
    several = [product for product in PRODUCTS
               if product not in ('folds', 'knees', 'estimates', 'slip', 'time')]
    found = read(room, *(f'{product}.h5' for product in several))
    for product in several:
        dims = found[f'{product}.h5']['dims']
        for name, axes in asking(product)[1].items():
            expect(dims.get(name) == axes, product, name, dims.get(name))


def every_product_goes_on_after_a_kill(room):
    part = room.path('a.h5.part')
    kills = 0
    for product in PRODUCTS:
        args, _ = asking(product)
        room.good('sweep', *args, '-o', 'whole.h5')
        process = start(room, *args, '-o', 'a.h5', '--threads', '2')
        kill_after_growth(room, process, part, 500)
        kills += process.returncode == -signal.SIGKILL
        room.good('sweep', *args, '-o', 'a.h5', '--resume')
        expect(room.bytes('a.h5') == room.bytes('whole.h5'), product)
        expect(not os.path.exists(part), product)
        os.remove(room.path('a.h5'))
    expect(kills >= len(PRODUCTS) // 2, kills, 'were killed')


def a_grid_has_maps_and_runs_along_four_axes(room):
    grid = ('sweep=[{key: slope.alpha, values: [0.34, 0.36]}, {key: material.c, '
            'values: [1e-4, 1e-3, 1e-2]}]')
    room.good('sweep', '--law', 'spinodal_gen', '--set', grid, '--set',
              'products=[basins, trajectories]', '--set', CELLS, '--set',
              STARTS, '-o', 'a.h5')
    names = ['basin_label', 'trajectory_phase_end_time']
    grid = read(room, 'a.h5', *names)
    expect(grid['dims'][names[0]] == ['alpha', 'c', 'psi', 'v']
           and grid['dims'][names[1]] == ['alpha', 'c', 'start', 'phase'],
           grid['dims'])
    room.good('sweep', '--law', 'spinodal_gen', '--set', 'material.c=1e-2',
              '--set', 'sweep={key: slope.alpha, values: [0.34]}', '--set',
              'products=[basins, trajectories]', '--set', CELLS, '--set',
              STARTS, '-o', 'b.h5')
    point = read(room, 'b.h5', *names)
    for name, size in zip(names, (20, 6)):  # the third of all six points
        expect(grid[name]['value'][2 * size:3 * size] == point[name]['value'],
               name)
    expect(len(set(point['basin_label']['value'])) == 2, 'two fates')


def text_and_json_sum_up_what_a_file_holds(room):
    args = line(3) + ['--set', 'products=[knees, slip, trajectories]', '--set',
                      CELLS, '--set', STARTS]
    said = room.good('sweep', *args, '-o', 'a.h5')
    for words in ('start 1: v = 0.01 V_star, psi = 10', 'arrest',
                  'basins: share of the window', '4 maps at each point',
                  'basin_slip', '100 % of the cells'):
        expect(words in said, words, said)
    expect('give -o FILE.h5' in room.good('sweep', *args), 'no file, no maps')
    found = room.json('sweep', *args, '-o', 'a.h5')
    stored = read(room, 'a.h5', 'trajectory_slip', 'basin_slip', 'basin_label')
    runs = found['numbers']['trajectory_slip']
    expect(runs['dims'] == ['start']
           and [x for point in runs['value'] for x in point]
           == stored['trajectory_slip']['value'], runs)
    fates = found['numbers']['trajectory_fate']['value']
    expect(len(fates) == 3 and set(fates[0]) <= {'creep', 'sliding'}, fates)
    label = found['maps']['basin_label']
    expect(label['shape'] == [4, 5] and all(
        sum(label['cells'][word][i] for word in label['cells']) == 20
        for i in range(3)), label)
    slip = found['maps']['basin_slip']
    expect(slip['present'] == [20, 20, 20] and all(
        0 <= low < high for low, high in zip(slip['least'], slip['greatest'])),
           slip)
    values = stored['basin_slip']['value']
    expect([min(values[20 * i:20 * i + 20]) for i in range(3)] == slip['least'],
           slip)
    labels = stored['basin_label']['value']
    expect([labels[20 * i:20 * i + 20].count(1) for i in range(3)]
           == label['cells']['sliding'], label)
    expect(found['starts'][1] == {'v': 0.01, 'psi': 10.0}
           and found['dims']['start']['values'] == [0, 1], found['dims'])
    expect(room.json('sweep', *args)['maps'] == {}, 'none without a file')


def a_sweep_needs_no_slope_that_nothing_takes(room):
    args = ['--law', 'spinodal_gen', '--set',
            'sweep={key: material.c, values: [1e-4, 1e-3]}']
    room.good('sweep', *args, '--set', 'products=[folds]', '-o', 'a.h5')
    expect('saddle_v' not in read(room, 'a.h5')['dims'], 'no saddle')
    refused(room.run('sweep', *args, '--set', 'products=[folds, slip]'), 2,
            'products: no slope for slip')
    refused(room.run('sweep', *args), 2, 'no slope, expected')


def what_is_not_of_one_shape_is_refused_with_another_way(room):
    for product in ('nullclines', 'manifolds', 'friction_law', 'spring_block',
                    'bifurcation', 'fold_curves'):
        refused(room.run('sweep', *line(3), '--set', f'products=[{product}]'),
                2, f'products: {product}: not in a sweep', 'slipway study --set '
                'sweep={} --set slope.alpha=VALUE')
    room.good('study', *line(3), '--set', 'products=[nullclines]', '--set',
              'sweep={}', '--set', 'slope.alpha=0.34')
    expect(room.names() == [], room.names())


def plan_tells_what_runs_at_a_point(room):
    args = line(3) + ['--set', 'products=[slip, trajectories]', '--set', STARTS]
    stages = [item['stage'] for item in room.json('plan', *args)]
    expect('fields' not in stages and 'basins' in stages
           and 'trajectories' not in stages and 'knees' in stages, stages)
    said = room.good('plan', *args, '-o', 'a.h5')
    expect('fields' in said and 'a run from each of 2 starts' in said, said)


# ---- interruptions -----------------------------------------------------------


def start(room, *args):
    return subprocess.Popen([room.slipway, 'sweep', *args], cwd=room.folder,
                            env=room.environment(), text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def kill_after_growth(room, process, part, growth):
    """Kills once the side file has so many bytes more, or it is done."""
    had = os.path.getsize(part) if os.path.exists(part) else 0
    while process.poll() is None:
        if os.path.exists(part) and os.path.getsize(part) > had + growth:
            process.send_signal(signal.SIGKILL)
            break
        time.sleep(0.002)
    process.communicate()


def killed_twenty_times_it_ends_in_the_same_bytes(room):
    sweep = line(250, ', refine: 0.02')
    room.good('sweep', *sweep, '-o', 'whole.h5')
    part = room.path('a.h5.part')
    seed = int(os.environ.get('CHECK_SEED', '20240229'))
    chance = random.Random(seed)
    kills = 0
    for _ in range(20):
        process = start(room, *sweep, '-o', 'a.h5', '--resume')
        kill_after_growth(room, process, part, chance.randrange(8000))
        kills += process.returncode == -signal.SIGKILL
    expect(kills >= 15, kills, 'of 20 runs were killed; seed', seed)
    expect(not os.path.exists(room.path('a.h5')), 'no file before the end')
    said = room.good('sweep', *sweep, '-o', 'a.h5', '--resume')
    expect('points were there already' in said, said)
    expect(room.bytes('a.h5') == room.bytes('whole.h5'), 'the same bytes')
    expect(not os.path.exists(part), 'nothing is left')


def ctrl_c_keeps_what_is_computed(room):
    """and says so, also where the work does not hear of it: SIGALRM is what
    its time is up by"""
    for told in (signal.SIGINT, signal.SIGALRM):
        process = start(room, *line(9000), '-o', 'a.h5')
        while not os.path.exists(room.path('a.h5.part')):
            time.sleep(0.002)
        time.sleep(0.1)
        process.send_signal(told)
        said, complaint = process.communicate(timeout=300)
        expect((process.returncode, said) == (130, '')
               and complaint == 'slipway: interrupted; what is computed stays '
               'in a.h5.part for --resume\n', process.returncode, complaint)
        expect(room.names() == ['a.h5.part'], room.names())
        os.remove(room.path('a.h5.part'))


def a_left_side_file_is_noted_or_refused(room):
    def leave():
        process = start(room, *line(300), '-o', 'a.h5')
        kill_after_growth(room, process, room.path('a.h5.part'), 4000)
        expect(room.names() == ['a.h5.part'], room.names())

    leave()
    refused(room.run('sweep', *line(3), '-o', 'a.h5', '--resume'), 2,
            'a.h5.part: of another scene or version', 'without --resume')
    expect(room.names() == ['a.h5.part'], room.names())
    said = room.good('sweep', *line(3), '-o', 'a.h5')
    expect('note: a.h5.part of an interrupted sweep was replaced' in said, said)
    expect(room.names() == ['a.h5'], room.names())
    room.write('a.h5.part', 'a letter to my mother')
    refused(room.run('sweep', *line(3), '-o', 'a.h5'), 2,
            'a.h5.part: not a side file of slipway')
    expect(room.read('a.h5.part') == 'a letter to my mother', 'untouched')


def a_finished_file_of_another_sweep_is_not_resumed(room):
    room.good('sweep', *line(3), '-o', 'a.h5', '-q')
    room.good('knees', '--law', 'ruina', '--alpha', '0.34', '-o', 'k.h5', '-q')
    room.write('letter', 'to my mother')
    for args, code, name, why in (
            (line(4), 2, 'a.h5', 'of another scene'),
            (line(3), 2, 'k.h5', 'made by study'),
            (line(3), 4, 'letter', '')):
        before = room.bytes(name)
        refused(room.run('sweep', *args, '-o', name, '--resume'), code, name,
                why)
        expect(room.bytes(name) == before, name)
    before = room.bytes('a.h5')
    room.good('sweep', *line(3), '-o', 'a.h5', '--resume', '-q')
    expect(room.bytes('a.h5') == before, 'its own')


# ---- what is wrong -----------------------------------------------------------


def a_wrong_sweep_costs_one_line(room):
    room.write('s.yaml', 'law: {preset: ruina}\nsweep: {key: slope.alfa}\n')
    refused(room.run('sweep', 's.yaml'), 2, 's.yaml:2:14: sweep.key:',
            'did you mean slope.alpha?')
    refused(room.run('sweep', '--law', 'ruina', '--alpha', '0.34'), 2,
            'sweep: the scene has none')
    refused(room.run('sweep', *line(3), '--resume'), 2, '--resume without')
    refused(room.run('sweep', *line(3), '-o', 'a.svg', '--figure', 'a.svg'), 2,
            'both the HDF5 file and the figure')
    refused(room.run('sweep', *line(3), '-o', '/dev/null/a.h5'), 4, '/dev/null')
    refused(room.run('sweep', 's.yaml', 't.yaml'), 2, 't.yaml: one argument')
    expect(room.names() == ['s.yaml'], room.names())


def what_is_overridden_stays_a_sweep(room):
    room.bring('scenes')
    found = room.json('sweep', SCENE, '--set', 'sweep.refine=1', '--set',
                      'sweep.points=4', '--set', 'products=[knees]', '-o',
                      'a.h5', '--set', 'output.figure=')
    expect(found['points'] < 41 and 'estimates_x_k' not in found['numbers']
           and 'knee_upper_v' in found['numbers'], found['points'])
    expect(KNEES not in room.good('info', 'a.h5', 'scene'), 'own products')
    room.good('sweep', *line(3), '-o', 'b.h5')
    expect('knees, estimates' in room.good('info', 'b.h5', 'scene').replace(
        '\n- ', ', ').replace('\n  - ', ', '), 'those that were added')


run_cases([
    the_example_scene_gives_file_figure_and_table,
    each_point_is_what_knees_says,
    a_grid_is_a_cube_over_both_keys,
    a_map_over_even_points_has_contours_with_labels,
    a_figure_shows_both_critical_velocities,
    a_figure_shows_what_is_asked_for,
    shares_of_basins_are_drawn,
    its_upward_axis_can_be_chosen,
    a_grid_shows_the_table_s_exact_number,
    wrong_words_of_the_figure_are_refused,
    threads_do_not_matter,
    plan_tells_of_the_points,
    every_product_is_a_cube_at_any_number_of_threads,
    every_product_goes_on_after_a_kill,
    a_grid_has_maps_and_runs_along_four_axes,
    text_and_json_sum_up_what_a_file_holds,
    a_sweep_needs_no_slope_that_nothing_takes,
    what_is_not_of_one_shape_is_refused_with_another_way,
    plan_tells_what_runs_at_a_point,
    killed_twenty_times_it_ends_in_the_same_bytes,
    ctrl_c_keeps_what_is_computed,
    a_left_side_file_is_noted_or_refused,
    a_finished_file_of_another_sweep_is_not_resumed,
    a_wrong_sweep_costs_one_line,
    what_is_overridden_stays_a_sweep,
])
