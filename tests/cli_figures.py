#!/usr/bin/env python3
"""Figures, gnuplot and the stages that run (TAP).

usage: cli_figures.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import json
import re
import xml.etree.ElementTree

from cli_room import SLOPE, expect, run_cases

# ---- only what a scene needs -------------------------------------------------


def all_products(room):
    """As the complaint about a wrong one lists them."""
    done = room.run('plan', *SLOPE, '--set', 'products=[all]')
    return re.findall(r'\w+', re.search(r'a list of (.*)', done.stderr)[1]
                      .replace(' or ', ' '))


def asking_for(products):
    return [*SLOPE, '--set', f'products=[{", ".join(products)}]', '--set',
            'trajectories.spread=2', '--set',
            'basins={cells: [32, 32], audit: 10}']


def stages_planned(room, *args):
    return [stage['stage'] for stage in room.json('plan', *args)]


def stages_run(room, *args):
    """The stages in the order they began, as --progress json tells, which
    also tells of the work inside them."""
    done = room.run(*args, '--progress', 'json', '--quiet')
    expect(done.returncode == 0, done)
    lines = [json.loads(line) for line in done.stderr.splitlines()]
    expect(all(set(line) == {'stage', 'done', 'total'} for line in lines),
           lines)
    every = stages_planned(room, *asking_for(all_products(room)))
    return list(dict.fromkeys(line['stage'] for line in lines
                              if line['stage'] in every))


def what_is_planned_is_what_runs(room):
    room.bring('scenes')
    every = all_products(room)
    expect(len(every) >= 8 and 'trajectories' in every, every)
    plans = set()
    for products in [[product] for product in every] + [
            ['equilibria', 'trajectories'], ['knees', 'nullclines'], every]:
        args = asking_for(products)
        plan = stages_planned(room, *args)
        expect(stages_run(room, 'study', *args) == plan, products, plan)
        plans.add(tuple(plan))
    expect(len(plans) > 8, plans)
    laws = [name for name in room.names('scenes') if name.startswith('fig')]
    for scene in laws[:4]:
        args = ['scenes/' + scene, '-o', 'a.h5', '--figure', 'a.svg']
        expect(stages_run(room, 'study', *args)
               == stages_planned(room, *args), scene)


def equilibria_alone_cost_no_manifold(room):
    args = [*SLOPE, '--set', 'products=[equilibria]']
    expect(stages_planned(room, *args) == ['steady'], 'plan')
    expect(stages_run(room, 'study', *args) == ['steady'], 'run')
    cost = room.json('study', *args)['cost']
    expect(cost['field_evaluations'] <= 8, cost)
    room.good('study', *args, '-o', 'a.h5')
    groups = [item['path'] for item in room.json('info', 'a.h5')
              if item['kind'] == 'group']
    expect(groups == ['/', '/provenance', '/equilibria', '/saddle'], groups)


def a_plan_runs_and_writes_nothing(room):
    room.fake('gnuplot', ': >marker')
    said = room.good('plan', *SLOPE, '-o', 'a.h5', '--figure', 'a.svg')
    expect('a.h5' in said and 'a.svg' in said, said)
    expect(stages_run(room, 'plan', *SLOPE) == [], 'it ran')
    expect(room.names() == [], room.names())


def without_a_figure_no_gnuplot_starts(room):
    room.fake('gnuplot', f': >{room.path("marker")}; exit 1')
    room.good('portrait', *SLOPE, '-o', 'a.h5')
    room.good('study', *SLOPE)
    room.good('knees', *SLOPE, '-o', 'b.h5')
    expect(room.names() == ['a.h5', 'b.h5'], room.names())
    done = room.run('portrait', *SLOPE)  # which draws: the marker is no dud
    expect(done.returncode == 4 and room.names()
           == ['a.h5', 'b.h5', 'marker'], done, room.names())


# ---- titles ------------------------------------------------------------------

HOSTILE = [
    'it\'s "quoted" `touch x` $(touch x)', 'system("touch x")',
    "'; system 'touch x' #", '"; system("touch x"); "', "' . system('touch x')",
    '`touch x`\\\n!touch x', 'a\nsystem("touch x")\n!touch x', '|touch x',
    '%s %d %n %1$s {/Symbol a} ^b _c @d &{e} ~f{.8-}', '\\n \\t \\ \\\\ \\q',
    '<script>alert(1)</script> & ]]> &amp;', '\x1b[31mred\x07',
    'α→β — 世界 \U0001f600 \u202etfel', 'é' * 3000, 'x ' * 5000, ' ', '"', "'",
    '\\', '@x', '!touch x', 'x" ; !touch x', '$0', '\u2028\u0085', '--', '# a',
]


def printable(text):
    return ''.join(c for c in text if c.isprintable() and not c.isspace())


def hostile_titles_are_drawn_and_never_run(room):
    for title in HOSTILE:
        quoted = json.dumps(title, ensure_ascii=False)
        room.write('a.yaml', f'title: {quoted}\nlaw: {{preset: ruina}}\n'
                   'slope: {alpha: 0.34}\nproducts: [nullclines]\n'
                   'output: {figure: a.svg}\n')
        room.good('study', 'a.yaml', '--keep-script')
        expect(room.names() == ['a.dat', 'a.gp', 'a.svg', 'a.yaml'],
               title[:99], room.names())
        svg = xml.etree.ElementTree.parse(room.path('a.svg'))
        shown = printable(''.join(svg.getroot().itertext()))
        expect(printable(title)[:50] in shown, title[:99], shown)


def hostile_file_names_are_only_names(room):
    for name in ("it's $(touch x).svg", '|touch x.svg', '`touch x`.svg',
                 '-x.svg', '<a.svg', 'a"; system("touch x").svg', '%s.svg',
                 '!touch x.svg', 'é.svg'):
        room.good('portrait', *SLOPE, '--figure', name, '--set',
                  'products=[equilibria]')
        expect(room.names() == [name], name, room.names())
        xml.etree.ElementTree.parse(room.path(name))
        room.shell('rm ./*.svg')


# ---- the power series ----------------------------------------------------

def the_power_series_is_drawn_told_and_stored(room):
    room.bring('scenes')
    found = room.json('study', 'scenes/taylor.yaml', '-o', 'a.h5', '--figure',
                      'a.svg')['taylor_series']
    expect([term['order'] for term in found['terms']] == list(range(32)),
           found)
    expect(0 < found['radius']['error'] < found['radius']['value'], found)
    for words in ('power series, order 14', 'the series converges'):
        expect(words in room.read('a.svg'), words)
    held = {item['path'] for item in room.json('info', 'a.h5')}
    expect({'/taylor_series/order', '/taylor_series/coefficient_error',
            '/taylor_series/radius'} <= held, held)
    flat = room.json('study', *SLOPE, '--set', 'law.preset=spinodal_gen',
                     '--set', 'slope.alpha=0.28', '--set',
                     'products=[taylor_series]')['taylor_series']
    expect(flat['terms'] == [] and 'saddle' in flat['radius']['reason'], flat)


# ---- scripts -----------------------------------------------------------------

def drawing(data):
    """A figure but for how large it is on paper."""
    if data.startswith(b'\x89PNG'):
        return data.replace(data[33:54], b'') if data[37:41] == b'pHYs' else data
    return data[data.index(b' xmlns='):]


def a_kept_script_draws_the_figure_again(room):
    room.make('figures')
    for ending in ('svg', 'png'):
        room.good('portrait', *SLOPE, '--figure', 'figures/a.' + ending,
                  '--keep-script')
        expect(room.names('figures') == sorted(['a.dat', 'a.gp',
                                                'a.' + ending]),
               room.names('figures'))
        before = room.bytes('figures/a.' + ending)
        moved = room.shell(f'mv figures moved; rm moved/a.{ending}; '
                           'cd moved && gnuplot -d a.gp')
        expect(moved.returncode == 0, moved)
        expect(drawing(room.bytes('moved/a.' + ending)) == drawing(before),
               ending)
        room.shell('rm -r moved; mkdir figures')


def every_format_is_what_its_name_says(room):
    for ending, start in (('svg', b'<?xml'), ('pdf', b'%PDF'),
                          ('png', b'\x89PNG')):
        room.good('portrait', *SLOPE, '--figure', 'a.' + ending)
        expect(room.bytes('a.' + ending).startswith(start), ending)
    expect(room.names() == ['a.pdf', 'a.png', 'a.svg'], room.names())


run_cases([
    what_is_planned_is_what_runs,
    equilibria_alone_cost_no_manifold,
    a_plan_runs_and_writes_nothing,
    without_a_figure_no_gnuplot_starts,
    hostile_titles_are_drawn_and_never_run,
    hostile_file_names_are_only_names,
    the_power_series_is_drawn_told_and_stored,
    a_kept_script_draws_the_figure_again,
    every_format_is_what_its_name_says,
])
