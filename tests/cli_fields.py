#!/usr/bin/env python3
"""Slip, time, friction and peaks of a grid from the command line (TAP).

usage: cli_fields.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import json
import math
import os
import re
import signal
import subprocess

from cli_room import expect, refused, run_cases, shown

SADDLE = ['basin', '--law', 'spinodal_gen', '--alpha', '0.34']
ALL = {'slip': ['slip'], 'time': ['time'], 'friction': ['mu_mean'],
       'peak': ['v_peak', 'mu_peak']}
REST = ['basin', '--law', 'dieterich_gen', '--alpha', '0.34', '--set',
        'window={v: [1e-3, 1e5], psi: [0.01, 100]}']


def grid(products, nv=24, npsi=18, more=''):
    return ['--set', f'basins={{cells: [{nv}, {npsi}], audit: 20{more}}}',
            '--set', 'products=[' + ', '.join(products) + ']']


def fields(room, *names):
    return json.loads(room.reads('read_fields.py', *names))


# ---- what the files hold -----------------------------------------------------

def each_product_writes_its_fields_and_no_other(room):
    for product in ALL:
        room.good(*SADDLE, *grid([product], 8, 6), '-o', product + '.h5')
    room.good(*SADDLE, *grid(['basins'], 8, 6), '-o', 'basins.h5')
    found = fields(room, 'basins.h5', *(p + '.h5' for p in ALL))
    expect(found['basins.h5']['holds'] == [], found['basins.h5'])
    for product, names in ALL.items():
        holds = ['exit_reason', *names, *(n + '_error' for n in names)]
        expect(found[product + '.h5']['holds'] == sorted(holds), product,
               found[product + '.h5'])


def every_cell_of_a_bistable_slope_has_every_number(room):
    room.good(*SADDLE, *grid(ALL, 16, 12), '-o', 'a.h5')
    found = fields(room, 'a.h5')['a.h5']
    expect(set(found['exits']) == {'creep', 'sliding'}
           and found['differ'] == 0 and found['rtol'] == 1e-6, found)
    for name in sum(ALL.values(), []):
        expect(found['missing'][name] == 0
               and found['worst'][name] <= 1e-6, name, found)


def what_does_not_exist_is_missing_from_the_file(room):
    room.good(*REST, *grid(ALL, 12, 9), '-o', 'a.h5')
    found = fields(room, 'a.h5')['a.h5']
    gone = found['exits']['runaway']
    expect(gone > 5 and found['exits']['rest_finite'] > 5
           and found['differ'] == 0, found)
    for name in ('slip', 'time', 'mu_mean', 'v_peak'):
        expect(found['missing'][name] == gone, name, found)
    expect(found['missing']['mu_peak'] == 12 * 9, found)


def a_cell_is_what_push_says(room):
    room.good(*SADDLE, *grid(ALL, 5, 4), '-o', 'a.h5')
    for cell in fields(room, 'a.h5')['a.h5']['some']:
        told = room.json('push', '--law', 'spinodal_gen', '--alpha', '0.34',
                         '--v', repr(cell['v']), '--psi', repr(cell['psi']))
        expect(told['fate'] == cell['exit_reason'], told, cell)
        for name in ('slip', 'time', 'mu_mean'):
            apart = abs(told[name]['value'] - cell[name])
            expect(apart <= told[name]['error'] + cell[name + '_error'],
                   name, told, cell)


def the_accuracy_asked_for_is_that_of_the_file(room):
    for rtol in (1e-4, 1e-8):
        room.good(*SADDLE, *grid(['slip', 'time'], 6, 5, f', rtol: {rtol}'),
                  '-o', 'a.h5')
        found = fields(room, 'a.h5')['a.h5']
        expect(found['rtol'] == rtol and found['worst']['slip'] <= rtol
               and found['worst']['time'] <= rtol, rtol, found)


def the_scene_of_figure_7_is_computed_as_it_stands(room):
    room.bring('scenes')
    room.make('outputs')
    room.good('study', 'scenes/fig07b_slip.yaml', '--set',
              'basins.cells=[16, 12]')
    found = fields(room, 'outputs/fig07b_slip.h5')['outputs/fig07b_slip.h5']
    expect({'slip', 'time', 'mu_mean'} < set(found['holds'])
           and found['differ'] == 0, found)
    expect(os.path.getsize(room.path('outputs/fig07b_slip.svg')) > 1e4,
           'no figure')


# ---- the same file, figures --------------------------------------------------

def the_same_bytes_at_any_thread_count(room):
    for threads in ('1', '3'):
        room.good(*SADDLE, *grid(ALL, 16, 12, ', rtol: 1e-4'), '--threads',
                  threads, '-o', threads + '.h5', '--figure', threads + '.svg')
    for ending in ('.h5', '.svg'):
        expect(room.bytes('1' + ending) == room.bytes('3' + ending), ending)


def each_field_has_its_figure_under_the_separatrix(room):
    for products, files in (
            (['time', 'slip'], {'a.svg': 'slip to arrest',
                                'a_time.svg': 'time to arrest'}),
            (['peak'], {'a.svg': 'largest slip rate',
                        'a_mu_peak.svg': 'largest friction'}),
            (['friction', 'basins'], {'a.svg': 'mean friction'})):
        done = room.good(*SADDLE, *grid(products, 6, 5), '--figure', 'a.svg')
        for name, label in files.items():
            drawn = shown(room.read(name))
            expect(label in drawn and 'stable manifold' in drawn
                   and 'creeps' not in drawn, name)
            # what slides does not arrest: grey, and in the legend
            expect(('does not come to rest' in drawn)
                   == ('arrest' in label or 'mean' in label), name)
            expect('wrote ' + name in done, done)
    room.good(*SADDLE, *grid(['basins'], 6, 5), '--figure', 'a.svg')
    expect('creeps' in room.read('a.svg'), 'no basins')


def labels_of_contours(room, name):
    return re.findall(r'label of a contour\n\S+ \S+ "(.*)"', room.read(name))


def the_map_and_margins_have_figures_beside_the_fields(room):
    room.good(*SADDLE, *grid(['slip', 'margin', 'basins'], 6, 5), '--figure',
              'a.svg', '--keep-script')
    for name, label in (('a', 'slip to arrest'), ('a_basins', 'creeps'),
                        ('a_margin_v', 'factor on v to another fate'),
                        ('a_margin_psi', 'factor on ψ to another fate')):
        expect(label in shown(room.read(name + '.svg')), name)
    for name in ('a_margin_v', 'a_margin_psi'):
        expect(len(labels_of_contours(room, name + '.dat')) >= 2, name)
    room.good(*SADDLE, *grid(['margin'], 6, 5), '--figure', 'b.svg')
    expect('creeps' in room.read('b.svg'), 'the map comes first')
    expect('b_margin_v.svg' in room.names(), room.names())


def a_margin_that_no_state_has_is_not_drawn(room):
    for alpha, drawn in (('0.28', False), ('0.34', True), ('0.4', False)):
        said = room.good('basin', '--law', 'spinodal_gen', '--alpha', alpha,
                         *grid(['basins', 'margin'], 6, 5), '--figure',
                         f'{alpha}.svg')
        expect((f'{alpha}_margin_v.svg' in room.names()) == drawn and
               ('note: no margins to draw: all states have the same fate'
                in said) != drawn, alpha, said, room.names())


def eigen_axes_show_the_basins(room):
    room.good(*SADDLE, *grid(['basins'], 6, 5), '--set', 'window.axes=eigen',
              '--figure', 'a.svg')
    drawn = shown(room.read('a.svg'))
    expect('stable coordinate' in drawn and 'creeps' in drawn
           and 'slides' in drawn and '<image' in room.read('a.svg'), drawn)


def raster(room, name):
    """The map of a picture, from below."""
    rows = re.search(r'^# block \d+: raster.*\n((?:.+\n)*)', room.read(name),
                     re.M)[1].splitlines()
    return [[float(cell) for cell in row.split()] for row in rows]


SLOPES = """import h5py
of = h5py.File('slopes.h5')['manifold']
print(*(of[name + '/slope'][0] for name in ('stable_upper', 'unstable_upper')))
"""


def eigen_axes_show_fields_and_margins(room):
    """In cells along the eigenvectors, each as push answers for its state."""
    room.good(*SADDLE, *grid(['basins', 'margin', 'slip'], 12, 10), '--set',
              'window.axes=eigen', '--figure', 'a.svg', '--keep-script')
    expect({'a.svg', 'a_basins.svg', 'a_margin_v.svg', 'a_margin_psi.svg'} <=
           set(room.names()), room.names())
    room.good('portrait', *SADDLE[1:], '-q', '-o', 'slopes.h5')
    slope = [float(s) for s in room.reads(SLOPES).split()]
    saddle = room.json('knees', *SADDLE[1:])['saddle']
    reach = float(re.search(r'set xrange \[.*:(.*)\]', room.read('a.gp'))[1])
    for name, told in (('a', 'slip'), ('a_margin_v', 'v_kick'),
                       ('a_margin_psi', 'psi_kick')):
        cells = raster(room, name + '.dat')
        size = len(cells[0]), len(cells)
        for place in ((0.3, 0.2), (0.6, 0.5), (0.4, 0.8), (0.3, 0.6)):
            at = [int(part * n) for part, n in zip(place, size)]
            X, Y = (reach * (2 * (k + 0.5) / n - 1) for k, n in zip(at, size))
            v = saddle['v']['value'] * math.exp(X + Y)
            psi = saddle['psi']['value'] * math.exp(slope[0] * X + slope[1] * Y)
            answer = room.json('push', *SADDLE[1:], '--v', repr(v), '--psi',
                               repr(psi))
            stops, answer = answer['fate'] == 'creep', answer[told]['value']
            if told != 'slip' and answer:
                answer = max(answer, 1 / answer)
            elif not stops:
                answer = None
            cell = 10 ** cells[at[1]][at[0]]
            expect(math.isnan(cell) if answer is None else
                   abs(math.log(cell / answer)) < 6 * reach / size[0], name,
                   X, Y, cell, answer)  # a cell of the image is a part of one


# ---- told --------------------------------------------------------------------

def fields_are_told_with_the_numbers(room):
    done = room.good(*SADDLE, *grid(['slip', 'peak'], 4, 3))
    expect(re.search(r' fields +slip v_peak mu_peak\n +cell_rtol +1e-06\n', done)
           and '-o FILE.h5' in done, done)
    expect('-o FILE.h5' not in room.good(*SADDLE, *grid(['slip'], 4, 3), '-o',
                                         'a.h5'), 'told too much')
    told = room.json(*SADDLE, *grid(['time'], 4, 3))
    expect(told['basin']['fields'] == ['time'], told['basin'])


def the_plan_names_the_fields_where_they_are_asked_for(room):
    for products, there in ((['slip'], True), (['peak'], True),
                            (['basins', 'margin'], False)):
        plan = room.json('plan', *SADDLE[1:], *grid(products))
        stages = [item['stage'] for item in plan]
        expect(('fields' in stages) == there and 'basins' in stages, plan)


def progress_counts_cells(room):
    done = room.run(*SADDLE, *grid(['slip'], 64, 9), '--progress', 'json',
                    '-o', 'a.h5')
    lines = [json.loads(line) for line in done.stderr.splitlines()]
    cells = [line for line in lines if line['stage'] == 'cells']
    expect(done.returncode == 0 and cells[-1]['done'] == 64 * 9
           and all(line['total'] == 64 * 9 for line in cells), lines)
    expect([line['done'] for line in cells]
           == sorted(line['done'] for line in cells), cells)


def an_interrupt_leaves_nothing(room):
    """Where fields are made ready, and where cells take their values."""
    for stage, products in ('patches', ALL), ('cells', ['slip']):
        job = subprocess.Popen(
            [room.slipway, *SADDLE, *grid(products, 160, 160, ', rtol: 1e-3'),
             '-o', 'a.h5', '--progress', 'json'], cwd=room.folder, text=True,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, env=room.environment())
        try:
            while json.loads(job.stderr.readline())['stage'] != stage:
                pass
            job.send_signal(signal.SIGINT)
            job.communicate(timeout=300)
        finally:
            job.kill()
        expect(job.returncode == 130 and room.names() == [], stage,
               job.returncode, room.names())


def wrong_fields_are_refused_in_one_line(room):
    for override, *words in (('products=[slips]', 'products', 'slip?'),
                             ('products=[mu_mean]', 'friction'),
                             ('basins.rtol=0', 'basins.rtol', '1e-11 to 0.1'),
                             ('basins.rtol=no', 'basins.rtol')):
        refused(room.run(*SADDLE, '--set', override), 2, override, *words)


run_cases([
    each_product_writes_its_fields_and_no_other,
    every_cell_of_a_bistable_slope_has_every_number,
    what_does_not_exist_is_missing_from_the_file,
    a_cell_is_what_push_says,
    the_accuracy_asked_for_is_that_of_the_file,
    the_scene_of_figure_7_is_computed_as_it_stands,
    the_same_bytes_at_any_thread_count,
    each_field_has_its_figure_under_the_separatrix,
    a_margin_that_no_state_has_is_not_drawn,
    the_map_and_margins_have_figures_beside_the_fields,
    eigen_axes_show_the_basins,
    eigen_axes_show_fields_and_margins,
    fields_are_told_with_the_numbers,
    the_plan_names_the_fields_where_they_are_asked_for,
    progress_counts_cells,
    an_interrupt_leaves_nothing,
    wrong_fields_are_refused_in_one_line,
])
