#!/usr/bin/env python3
"""The pages that slipway writes of itself: scenes, files, words (TAP).

usage: cli_reference.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import glob
import os
import re

from cli_room import expect, run_cases

CURVES = ['nullclines', 'manifolds', 'friction_law', 'spring_block',
          'bifurcation', 'fold_curves']
MAPS = ['basins', 'margin', 'slip', 'time', 'friction', 'peak']
NUMBERS = ['equilibria', 'folds', 'field_arrows', 'knees', 'estimates',
           'taylor_series', 'sensitivities', 'trajectories', 'chi']


def products(*lists):
    return f'products=[{", ".join(sum(lists, []))}]'


SMALL = ['basins.cells=[7, 5]', 'basins.audit=3', 'trajectories.spread=2']
SAMPLES = 'id,material.a\nx,0.034\ny,0.035\n'
DATA = ('tan_alpha,l_k,x_k\n0.26,0.0063,1e-6\n0.3,0.0048,1e-6\n'
        '0.34,0.0035,1e-6\n')  # three slopes: no curve of friction over slip

# What no scene in scenes/ asks for: command, settings.
MORE = [
    ('study --law spinodal_gen --alpha 0.34',
     [products(CURVES, MAPS, NUMBERS), *SMALL]),
    ('study --law ruina --alpha 1.5', [products(CURVES, NUMBERS)]),
    ('simulate --law ruina --alpha 0.34 --v 1e300 --psi 700', []),
    ('simulate --law spinodal_gen --alpha 0.34 --v 1e-3 --psi 1e-3', []),
    ('sweep --law dieterich_gen',
     ['products=[knees, folds, estimates, sensitivities]', 'sweep.key=slope.alpha',
      'sweep.values=[0.3, 0.5]', 'sweep.refine=1']),
    ('sweep --law spinodal_gen --alpha 0.34',
     ['sweep=[{key: material.a, values: [0.03, 0.04]}, '
      '{key: gravity, values: [1, 2, 3]}]']),
    ('sweep --law spinodal_gen', [
        products(MAPS, NUMBERS), *SMALL[:2], 'trajectories.starts=[{v: 1e3, psi: 10}]',
        'rabinowicz={block_mass: 1, ball_mass: 0.1, restitution: 0.5}',
        'sweep={key: slope.alpha, values: [0.34]}']),
    ('rabinowicz --law dieterich_gen --alpha 0.34 --data three.csv', []),
    ('ensemble --law spinodal_gen --alpha 0.34',
     [products(NUMBERS), 'ensemble={samples: two.csv}']),
    ('ensemble --law spinodal_gen --alpha 0.34',
     ['products=[basins]', 'ensemble={samples: two.csv}', 'basins.cells=[8, 8]',
      'basins.audit=0']),
    ('knees --law kato_tullis --alpha 0.34', ['material.V_c=1e3']),
    ('basin --proved --law kato_tullis --alpha 0.34', ['material.V_c=1e3', *SMALL]),
    ('knees --proved --law dieterich --alpha 0.34', []),
    ('push --law spinodal_gen --alpha 0.34 --v 1e3 --psi 10', []),
    ('push --law spinodal_gen --alpha 0.34 --from creep --kick 10',
     ['material.a=0.0349 +- 0.0001']),
    ('workprec --quick --law ruina --alpha 0.34', []),
    ('stress --only laws/perrin/log/0.38', []),
]


def settings(sets):
    return [word for one in sets for word in ('--set', one)]


def small_scene(room, path):
    """How to make its file in no time; what it holds is the same."""
    text = room.read(path)
    sets = [one for one in SMALL if one.split('.')[0] + ':' in text]
    if re.search(r'^ensemble:', text, re.M):
        sets.append('ensemble.draws=100')
    if re.search(r'^sweep:', text, re.M):
        sets.append('sweep.points=3')
    return [path, '-o', os.path.basename(path)[:-5] + '.h5', *settings(sets)]


def make_files(room):
    room.bring('scenes')
    room.make('outputs')
    room.write('three.csv', DATA)
    room.write('two.csv', SAMPLES)
    for path in sorted(glob.glob(room.path('scenes/*.yaml'))):
        if 'system:' in room.read(os.path.relpath(path, room.folder)):
            continue  # its groups have the names of its own states
        room.good('study', '--set', 'output.figure=',
                  *small_scene(room, os.path.relpath(path, room.folder)))
    for i, (command, sets) in enumerate(MORE):
        done = room.run(*command.split(), '-o', f'more{i}.h5', *settings(sets))
        expect(done.returncode in (0, 3), done)  # 3: an orbit that gets lost
    return [name for name in room.names() if name.endswith('.h5')]


def read_layout(room, page, files):
    return room.python('read_layout.py', page, *files)


# Lies, and what must be said of them.
WRONG = [('| `psi_at_v0` | number |', '| `psi_at_v1` | number |'),
         ('| slip in units of L |', '| slip |'),
         ('`stable_node`', '`node`'),
         ('| `alpha_cM` | number | rad |', '| `alpha_cM` | number | 1 |'),
         ('| `margin` | real | 1 | psi, v |', '| `margin` | real | 1 | v |'),
         ('| `steps` | count |', '| `steps` | real |'),
         ('| `audit_cells` | count |', '| `audit_cell` | count |')]
COMPLAINTS = ['^psi_at_v1 of /critical is in no file',
              '^/critical/psi_at_v0 is not on the page',
              '^/critical/psi_at_v0_error is not on the page',
              '^/trajectory_0/slip means slip in units of L',
              '^/equilibria/type has the words .*stable_node',
              '^/folds/alpha_cM ', '^/folds/alpha_cM_error ', '^/basin/margin ',
              '^attribute audit_cells of /basin is not on the page']


def pages_and_files_hold_the_same(room):
    files = make_files(room)
    expect(len(files) >= 32 + len(MORE), files)
    page = room.good('help', '--as', 'hdf5')
    room.write('hdf5.md', page)

    done = read_layout(room, 'hdf5.md', files)
    expect((done.returncode, done.stderr) == (0, ''), done.stdout, done.stderr)
    for line, instead in WRONG:
        expect(line in page, line)
        page = page.replace(line, instead)
    room.write('hdf5.md', page)
    done = read_layout(room, 'hdf5.md', ['more0.h5'])
    for complaint in COMPLAINTS:
        expect(re.search(complaint, done.stdout, re.M), complaint, done)


def the_table(page, title):
    """Rows of cells of the table under a title."""
    part = re.search(rf'^## {title}\n(.*?)(?=^## |\Z)', page, re.M | re.S)[1]
    rows = re.findall(r'^\| (.*) \|$', part, re.M)[1:]
    return [re.split(r'(?<!\\) \| ', row) for row in rows]


def every_key_is_told_with_its_value_and_meaning(room):
    rows = the_table(room.good('help', '--as', 'scene'), 'Keys')
    expect(len(rows) >= 58, rows)
    for key, value, _, _, meaning in rows:
        expect(re.fullmatch(r'`[\w.]+`', key) and value and meaning, key)
        done = room.run('plan', '--law', 'spinodal_gen', '--alpha', '0.3',
                        '--set', key.strip('`') + '=[[nonsense]]')
        expect(done.returncode == 2 and 'unknown' not in done.stderr, done)
    told = {row[0].strip('`'): row for row in rows}
    expect(told['material.L'][2:4] == ['m', '`0.9e-6`'], told['material.L'])
    expect('`slope.alpha_deg`' in told['slope.alpha'][4], told['slope.alpha'])


def a_product_runs_the_stages_that_are_told(room):
    page = room.good('help', '--as', 'scene')
    rows = the_table(page, 'Products')
    known = {row[0] for row in the_table(page, 'Stages')}
    expect(len(rows) >= 21, rows)
    for product, computes, stages in rows:
        said = room.good('plan', '--law', 'spinodal_gen', '--alpha', '0.34',
                         '--set', f'products=[{product.strip("`")}]')
        planned = {f'`{line.split()[0]}`' for line in said.splitlines()}
        expect(planned - set(stages.split()) <= {'`steady`'}
               and set(stages.split()) <= planned and computes
               and set(stages.split()) <= known, product, said)


def every_word_has_a_meaning(room):
    page = room.good('help', '--as', 'words')
    rows = re.findall(r'^\| (\d+) \| `(\w+)` \| (.*) \|$', page, re.M)
    expect(len(rows) >= 50 and all(row[2] for row in rows), rows)
    listed = room.good('help', '--as', 'hdf5')
    for word in set(re.findall(r'`(\w+)`', ' '.join(re.findall(
            r'^\| `\w+` \| code \|.*: (.*) \|$', listed, re.M)))):
        if word not in ('no', 'yes', 'own', 'foreign', 'asinh', 'log', 'slope',
                        'start', 'window', 'field', 'system'):
            expect(f'| `{word}` |' in page, word)
    codes = dict(re.findall(r'^\| (\d+) \| (\w.*) \|$', page, re.M))
    expect(sorted(codes, key=int) == ['0', '1', '2', '3', '4', '130'], codes)


def only_known_formats_are_written(room):
    for format_ in ('scene', 'hdf5', 'words'):
        done = room.run('help', 'knees', '--as', format_)
        expect(done.returncode == 2 and 'knees' in done.stderr, done)
    done = room.run('help', '--as', 'yaml')
    expect(done.returncode == 2 and 'scene, hdf5' in done.stderr, done)


if __name__ == '__main__':
    run_cases([
        pages_and_files_hold_the_same,
        every_key_is_told_with_its_value_and_meaning,
        a_product_runs_the_stages_that_are_told,
        every_word_has_a_meaning,
        only_known_formats_are_written,
    ])
