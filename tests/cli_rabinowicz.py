#!/usr/bin/env python3
"""slipway rabinowicz as users call it (TAP).

usage: cli_rabinowicz.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import re

from cli_room import SLOPE, expect, refused, run_cases, shown

MASSES = ['--set', 'rabinowicz.block_mass=0.1', '--set',
          'rabinowicz.ball_mass=0.01', '--set', 'rabinowicz.restitution=0.5']
ROW = ['tan_alpha', 'alpha', 'v_k', 'l_k', 'l_k_G', 'l_k_33', 'mu_s', 's_k',
       's_k_30']
SCENE = 'scenes/rabinowicz.yaml'


def the_example_scene_gives_numbers_and_a_file(room):
    room.bring('scenes')
    room.make('outputs')
    said = room.good('study', SCENE)
    for word in ('fit of (33) to release distances', 'mu_s', 'mu_half',
                 'fit of (30)', 's_k (m)', 'wrote outputs/rabinowicz.h5'):
        expect(word in said, word, said)
    found = room.json('rabinowicz', SCENE)
    expect(list(found) == ['K', 'release', 'fit', 'slip', 'persistence', 'units'],
           list(found))
    expect(len(found['release']) == 7 and all(
        list(row) == ROW for row in found['release']), found['release'])
    fit = found['fit']
    for name, truth in (('mu_s', 0.62), ('mu_half', 0.378704),
                        ('L', 0.9e-6), ('mu_star', 0.369)):
        low, value, high = fit[name + '_low'], fit[name], fit[name + '_high']
        expect(low < truth < high and low < value['value'] < high, name, fit)
        expect(abs(max(value['value'] - low, high - value['value'])
                   - value['error']) < 1e-12 * high, name, fit)
    expect(fit['warning'] is None and len(found['slip']['points']) > 10, found)
    expect(abs(found['persistence']['L']['value'] / 0.9e-6 - 1) < 0.02, found)


def the_file_holds_what_the_json_says(room):
    room.bring('scenes')
    found = room.json('rabinowicz', SCENE, '-o', 'a.h5')
    script = (
        'import h5py, json\n'
        'f = h5py.File("a.h5")["rabinowicz"]\n'
        'print(json.dumps([f["release/l_k"][()].tolist(),'
        ' f["fit/mu_s"][()], f["fit/mu_s_low"][()], f["fit/L"][()],'
        ' f["slip/s_k"][()].tolist(), f["persistence/L"][()],'
        ' f["l_k/value"][()].tolist(), float(f["release"].attrs["K"])]))\n')
    read = room.reads(script)
    fit = found['fit']
    expect(read.startswith(
        '[' + repr([row['l_k']['value'] for row in found['release']])), read)
    for number in (fit['mu_s']['value'], fit['mu_s_low'], fit['L']['value'],
                   found['slip']['points'][7]['s_k']['value'],
                   found['persistence']['L']['value'], found['K']['value']):
        expect(repr(number) in read, number, read)
    first = room.bytes('a.h5')
    room.good('rabinowicz', SCENE, '-o', 'a.h5', '--threads', '1', '--quiet')
    expect(room.bytes('a.h5') != b'' and room.bytes('a.h5') == first,
           'the same bytes')


def without_data_release_distances_are_all(room):
    found = room.json('rabinowicz', *SLOPE, *MASSES)
    row = found['release'][0]
    expect(len(found['release']) == 1 and found['fit'] is None
           and found['slip'] is None and found['persistence'] is None, found)
    expect(abs(row['v_k']['value'] / 2832.2233588e-6 - 1) < 1e-9, row)
    expect(room.names() == [], room.names())


def without_masses_a_reason_takes_their_place(room):
    room.write('a.csv', 'tan_alpha,l_k\n' + ''.join(
        f'{t},{4e-3 * (0.6 - t) * (0.38 - t) / t * wobble}\n'
        for t, wobble in ((0.1, 1.01), (0.2, 0.99), (0.25, 1.0), (0.3, 1.01),
                          (0.33, 0.99), (0.36, 1.0))))
    found = room.json('rabinowicz', *SLOPE, '--data', 'a.csv')
    expect('block_mass' in found['K']['reason'], found['K'])
    expect(found['fit']['mu_s']['value'] > 0.4, found['fit'])
    expect(found['fit']['L']['value'] is None, found['fit'])
    point = found['slip']['points'][0]
    expect(point['s_k']['value'] is None and point['gradient'] > 0, point)
    said = room.good('rabinowicz', *SLOPE, '--data', 'a.csv')
    expect('gradient (m)' in said and ' scatter ' in said, said)


def roots_that_cannot_be_told_apart_cost_a_warning(room):
    room.write('a.csv', 'tan_alpha,l_k,l_k_error\n' + ''.join(
        f'{t},{(0.4 - t) ** 2 / t * (1 + wobble)},{(0.4 - t) ** 2 / t * 0.05}'
        '\n' for t, wobble in ((0.1, 0.02), (0.15, -0.03), (0.2, 0.01),
                               (0.25, 0.04), (0.3, -0.02), (0.35, 0.01))))
    said = room.good('rabinowicz', *SLOPE, '--data', 'a.csv')
    expect(re.search(' warning +the data cannot tell the two roots apart', said),
           said)
    found = room.json('rabinowicz', *SLOPE, '--data', 'a.csv')
    expect('apart' in found['fit']['warning'], found['fit'])


MALFORMED = {
    'tan_alpha,l_k\n0.1,2e-3\n0.2,1e-3x\n': ['a.csv:3:5', "'1e-3x'"],
    'tan_alpha;l_k\n0.1;2e-3\n': ['a.csv:1:1', 'tan_alpha;l_k', 'expected'],
    'tan_alpha,l_k\n0.1,2e-3\n0.2\n': ['a.csv:3:1', '1 cells'],
    'tan_alpha,l_k,l_k_eror\n0.1,1,1\n': ['a.csv:1:15', 'l_k_error?'],
    'tan_alpha,l_k\n-0.1,2e-3\n': ['a.csv:2:1', "'-0.1'", '> 0'],
    'tan_alpha,l_k\n': ['a.csv:2:1', 'no rows'],
    '': ['a.csv:1:1', 'no header'],
}


def malformed_tables_cost_one_line_and_write_nothing(room):
    for text, words in MALFORMED.items():
        room.write('a.csv', text)
        refused(room.run('rabinowicz', *SLOPE, '--data', 'a.csv', '-o',
                         'a.h5'), 2, *words)
    refused(room.run('rabinowicz', *SLOPE, '--data', 'none.csv'), 4,
            'none.csv')
    expect(room.names() == ['a.csv'], room.names())


def figures_show_the_fit_and_friction_over_slip(room):
    room.bring('scenes')
    said = room.good('rabinowicz', 'scenes/fig08.yaml', '-o', 'a.h5',
                     '--figure', 'a.svg')
    expect('wrote a.svg' in said and 'wrote a_friction.svg' in said, said)
    first, second = (shown(room.read(name)) for name in
                     ('a.svg', 'a_friction.svg'))
    for word in ('synthetic', 'lk tan α (mm)', 'parabola (33), fitted',
                 'static friction μs = 0.61', '95 % band', 'data'):
        expect(word in first, word)
    for word in ('synthetic', 'slip sk (μm)', 'smoothing spline (25)'):
        expect(word in second, word)
    # without masses K is not known; without errors there are no bars
    room.write('b.csv', 'tan_alpha,l_k\n' + ''.join(
        f'{t},{(0.6 - t) * (0.38 - t) / t * (1 + 0.01 * (-1) ** k)}\n'
        for k, t in enumerate((0.1, 0.15, 0.2, 0.25, 0.3, 0.35))))
    room.good('rabinowicz', *SLOPE, '--data', 'b.csv', '--figure', 'b.svg')
    expect('sk/K' in shown(room.read('b_friction.svg'))
           and '95 % bars' not in room.read('b.svg'), 'b.svg')
    # too few for a curve of friction over slip
    room.write('c.csv', 'tan_alpha,l_k\n0.1,1\n0.2,0.5\n')
    refused(room.run('rabinowicz', *SLOPE, '--data', 'c.csv', '--figure',
                     'c.svg'), 2, 'rabinowicz:')
    expect('c.svg' not in room.names(), room.names())


def study_runs_a_scene_that_is_for_rabinowicz(room):
    room.bring('scenes')
    room.make('outputs')
    expect(room.json('study', SCENE) == room.json('rabinowicz', SCENE), 'same')
    expect('wrote' not in room.good('rabinowicz', SCENE), 'a question')


def wrong_words_cost_one_line(room):
    refused(room.run('rabinowicz'), 2, 'law')
    refused(room.run('rabinowicz', *SLOPE, '--figure', 'a.svg'), 2, 'a.svg',
            '--data')
    refused(room.run('rabinowicz', 'a.yaml', 'b.yaml'), 2, 'b.yaml')
    refused(room.run('rabinowicz', *SLOPE, '--set',
                     'rabinowicz.restitution=2'), 2, 'restitution')
    refused(room.run('rabinowicz', *SLOPE, '-o', '/dev/null/a.h5'), 4, '/dev/null')
    for how in ('', '--json'):
        done = room.shell('slipway rabinowicz --law dieterich_gen --alpha '
                          f'0.34 {how} >/dev/full')
        refused(done, 4, 'standard output')
    expect(room.good('rabinowicz', *SLOPE, '--quiet') == '', 'quiet')


run_cases([
    the_example_scene_gives_numbers_and_a_file,
    the_file_holds_what_the_json_says,
    without_data_release_distances_are_all,
    without_masses_a_reason_takes_their_place,
    roots_that_cannot_be_told_apart_cost_a_warning,
    malformed_tables_cost_one_line_and_write_nothing,
    figures_show_the_fit_and_friction_over_slip,
    study_runs_a_scene_that_is_for_rabinowicz,
    wrong_words_cost_one_line,
])
