#!/usr/bin/env python3
"""Figures, gnuplot and the stages that run (TAP).

usage: cli_figures.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import json
import math
import re
import xml.etree.ElementTree

from cli_room import SLOPE, expect, run_cases, shown

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
        expect(svg.getroot().get('{http://www.w3.org/XML/1998/namespace}space')
               == 'preserve', 'spaces beside italics')
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


# ---- orbits ------------------------------------------------------------------

NEAR = 1 / 160  # of the plot's sides


def pieces(room, name):
    """Of a figure's curves: (entry, points in sides of the plot, points of a
    piece not further apart than NEAR/2)."""
    script = room.read(name + '.gp')
    sides = []
    for axis in 'xy':
        lo, hi = map(float, re.search(rf'set {axis}range \[(.*):(.*)\]',
                                      script).groups())
        is_log = f'set logscale {axis}' in script
        sides.append((math.log if is_log else float, lo, hi))

    def place(row):
        return tuple((f(x) - f(lo)) / (f(hi) - f(lo))
                     for x, (f, lo, hi) in zip(row, sides))
    what, found = '', []
    for line in room.read(name + '.dat').splitlines():
        if line.startswith('# block'):
            what = line.split(': ', 1)[1]
        row = line.split() if line[:1] not in ('#', '') else []
        if not row:
            found.append((what, []))
            continue
        b = place(map(float, row))
        points = found[-1][1]
        a = points[-1] if points else b
        n = int(math.dist(a, b) / (NEAR / 2)) + 1
        points += [tuple(p + k / n * (q - p) for p, q in zip(a, b))
                   for k in range(1, n + 1)]
    return [(what[7:], points) for what, points in found
            if points and what.startswith('curves')]


def largest_empty_disc(lines):
    worst, near = 0, {}
    for _, line in lines:
        for x, y in line:
            near.setdefault((int(20 * x), int(20 * y)), []).append((x, y))
    for i in range(40):
        for k in range(40):
            at = (i + 0.5) / 40, (k + 0.5) / 40
            for ring in range(20):
                here = [p for a in range(-ring, ring + 1)
                        for b in range(-ring, ring + 1)
                        for p in near.get((i // 2 + a, k // 2 + b), [])]
                gap = min((math.dist(at, p) for p in here), default=9)
                if gap <= ring / 20:
                    break
            worst = max(worst, min(gap, *at, 1 - at[0], 1 - at[1]))
    return worst


def longest_side_by_side(orbits):
    """How far one runs nearer than NEAR to another, in sides of the plot."""
    held = {}
    for k, line in enumerate(orbits):
        for x, y in line:
            held.setdefault((int(x / NEAR), int(y / NEAR)), []).append((k, x, y))
    worst = 0
    for k, line in enumerate(orbits):
        gone = 0
        for a, b in zip(line, line[1:]):
            i, j = int(b[0] / NEAR), int(b[1] / NEAR)
            beside = any(n != k and math.dist(b, (x, y)) < NEAR
                         for u in (i - 1, i, i + 1) for v in (j - 1, j, j + 1)
                         for n, x, y in held.get((u, v), []))
            gone = gone + math.dist(a, b) if beside else 0
            worst = max(worst, gone)
    return worst


SYSTEMS = {
    'a damped pendulum': ("x' = y; y' = -sin(x) - 0.2*y", 'x=-6:6,y=-3:3'),
    'competing species': ("x' = x*(3-x-2*y); y' = y*(2-x-y)", 'x=0:4,y=0:3'),
    'van der Pol': ("x' = y; y' = (1-x^2)*y - x", 'x=-4:4,y=-4:4'),
    'a stiff node': ("x' = -x; y' = -40*(y - x^2)", 'x=-2:2,y=-1:3'),
}


def orbits_leave_no_hole_and_are_no_bunch(room):
    laws = [law['name'] for law in room.json('laws')]
    expect(len(laws) > 5, laws)
    asked = {law: ['--law', law, '--alpha', '0.34'] for law in laws}
    asked['kato_tullis'] += ['--set', 'material.V_c=1']
    for name, (text, window) in SYSTEMS.items():
        asked[name] = ['--ode', text, '--window', window]
    for name, args in asked.items():
        room.good('portrait', *args, '--figure', 'a.svg', '--keep-script')
        lines = [line for line in pieces(room, 'a') if ' = 0' not in line[0]]
        orbits = [line for what, line in lines if what == 'trajectories']
        hole, bunch = largest_empty_disc(lines), longest_side_by_side(orbits)
        expect(hole < 0.085 and bunch < 8 * NEAR, name,
               len(orbits), hole, bunch)


def a_title_is_the_scene_s_or_the_law_in_words(room):
    """With the slope; no figure shows the name of a preset."""
    law, products = ['--law', 'spinodal_gen'], 'products=[friction_law]'
    for title, words in (('', 'Generalised spinodal law'), ('Mine', 'Mine')):
        room.good('portrait', *law, '--alpha', '0.34', '-q', '--set',
                  f'title={title}', '--figure', 'a.svg')
        room.good('study', *law, '-q', '--set', products, '--set',
                  f'title={title}', '--figure', 'b.svg')
        portrait, curves = (shown(room.bytes(name + '.svg')) for name in 'ab')
        expect(portrait.startswith(f'{words}, α = 0.34 rad '), portrait)
        expect(curves.startswith(words + ' '), curves)
        expect('Dieterich law Generalised spinodal law' in curves, curves)
        expect('spinodal_gen' not in portrait + curves, portrait, curves)


def a_single_value_has_an_axis_and_a_mark_of_its_own(room):
    """Within a tenth of it; its marks differ by more than their colours."""
    sweep = ['sweep', '--law', 'spinodal_gen', '--alpha', '0.34', '-q', '--set']
    room.good(*sweep, 'sweep={key: slope.alpha, values: [0.34]}', '--figure',
              'a.svg', '--keep-script')
    script = room.read('a.gp')
    ends = re.search(r'set xrange \[(.*):(.*)\]', script).groups()
    expect([round(float(end), 9) for end in ends] == [0.306, 0.374], ends)
    marks = {(number, colour) for number, colour in re.findall(
        r"with points pt (\d+) ps \S+ lw \S+ lc rgb '(#\w+)'", script)}
    expect(len(marks) == 5 == len({number for number, _ in marks}), marks)


def a_map_has_a_tint_at_any_size_of_its_values(room):
    """gnuplot keeps cells in single precision."""
    room.good('basin', '--law', 'dieterich_gen', '--alpha', '0.34', '-q',
              '--set', 'window={v: [1e-300, 1e300], psi: [1e-300, 1e300]}',
              '--set', 'products=[basins, margin]', '--set',
              'basins={cells: [40, 30], audit: 0}', '--figure', 'a.svg',
              '--keep-script')
    raster = re.search(r'^# block \d+: raster.*\n((?:.+\n)*)',
                       room.read('a_margin_v.dat'), re.M)[1]
    cells = [float(cell) for cell in raster.split()]
    expect(0 < max(cells) < 310 and len(set(cells)) > 100, max(cells))


def manifolds_have_arrows_along_the_flow(room):
    """Two each, on all lines; the stable ones' point to the saddle."""
    room.good('portrait', '--law', 'spinodal_gen', '--alpha', '0.34',
              '--figure', 'a.svg', '--keep-script')
    saddle = None
    heads = {}
    drawn = blocks(room, 'a.dat')
    kinds = [what.split()[0] for what, _ in drawn]
    expect(max(k for k, kind in enumerate(kinds) if kind == 'curves')
           < kinds.index('arrowheads'), kinds)
    for what, rows in drawn:
        place = [(math.log(x), math.log(y)) for x, y in rows]
        if what == 'points saddle':
            saddle = place[0]
        if what.startswith('arrowheads'):
            heads[what[11:]] = [place[k:k + 3] for k in range(0, len(place), 3)]
    for kind, way in (('stable', 1), ('unstable', -1)):
        found = heads[kind + ' manifold']
        expect(len(found) == 2, kind, found)
        for base, tip, other in found:
            tail = [(p + q) / 2 for p, q in zip(base, other)]
            expect((math.dist(tail, saddle) - math.dist(tip, saddle)) * way > 0,
                   kind, tail, tip)
    expect(len(heads['trajectories']) > 10, heads)


# ---- over a key --------------------------------------------------------------

def blocks(room, name):
    """Of a figure's data: (what it is, its rows), in drawing order."""
    found = []
    for line in room.read(name).splitlines():
        if line.startswith('# block'):
            found.append((line.split(': ', 1)[1], []))
        elif line:
            found[-1][1].append(tuple(float(x) for x in line.split()))
    return found


def sweep(room, values, show, products):
    room.good('sweep', '--law', 'spinodal_gen', '--set',
              f'sweep={{key: slope.alpha, values: {values}, show: {show}}}',
              '--set', 'basins={cells: [8, 8], audit: 0}', '--set',
              f'products=[{products}]', '-o', 'a.h5',
              '--figure', 'a.svg', '--keep-script')
    return blocks(room, 'a.dat')


def what_jumps_at_a_fold_is_drawn_as_a_jump(room):
    drawn = [rows for what, rows in sweep(room, [0.28, 0.31], 'basins',
                                          'basins') if 'creep' in what]
    expect(len(drawn) == 1, drawn)
    (x, before), (left, above), (right, below), (end, behind) = drawn[0]
    expect((x, left, right, end) == (0.28, 0.295, 0.295, 0.31), drawn)
    expect(before == above == 1 > below == behind, drawn)


def what_does_not_exist_is_grey_and_in_the_legend(room):
    """And curves end there: the saddle's is no level line to the fold."""
    drawn = sweep(room, [0.28, 0.29, 0.3, 0.33, 0.38, 0.39], 'velocities',
                  'knees')
    grey = [{x for x, _ in rows} for what, rows in drawn
            if what == 'region does not exist']
    expect(grey == [{0.28, 0.295}, {0.385, 0.39}], grey)
    for what, rows in drawn:
        if what.startswith('curves'):
            expect([x for x, _ in rows] == [0.3, 0.33, 0.38], what, rows)
    expect('does not exist' in room.read('a.svg'), 'legend')
    room.write('a.yaml', '''system:
  state: {x: real, y: real}
  parameters: {m_0: 0}
  rates: {x: m_0 - x^2, y: 0 - y}
window: {x: [-2, 2], y: [-1, 1]}
sweep: {key: system.parameters.m_0, from: -1, to: 2, points: 7}
''')
    room.good('sweep', 'a.yaml', '-o', 'a.h5', '--figure', 'a.svg',
              '--keep-script')
    drawn = blocks(room, 'a.dat')
    grey = [{x for x, _ in rows} for what, rows in drawn
            if what == 'region does not exist']
    expect(grey == [{-1, -0.25}], grey)
    script = room.read('a.gp')
    marks = {what: re.findall(rf'data index {k} with points pt (\d+)', script)[-1]
             for k, (what, _) in enumerate(drawn) if what.startswith('points')}
    expect(set(marks) == {'points saddle', 'points stable node',
                          'points not hyperbolic'}, marks)
    expect(len(set(marks.values())) == 2, marks)  # a circle is two discs


def basins_of_a_system_say_whereto_they_go(room):
    """Those of a centre are undecided, and grey."""
    for text, entries in (("x' = y; y' = x - x^3 - 0.5*y",
                           ['to stable focus 0', 'to stable focus 1']),
                          ("x' = y; y' = -x", ['undecided'])):
        room.good('basin', '--ode', text, '--window', 'x=-2:2,y=-2:2',
                  '--set', 'basins={cells: [24, 24], audit: 0}',
                  '--figure', 'a.svg')
        said = shown(room.read('a.svg'))
        expect(all(entry in said for entry in entries) and '_' not in said,
               said)


def one_value_is_drawn_as_a_point(room):
    drawn = sweep(room, [0.34], 'velocities', 'knees')
    expect(len(drawn) > 3, drawn)
    for what, rows in drawn:
        expect(what.startswith('points') and [x for x, _ in rows] == [0.34],
               what, rows)


def several_runs_differ_by_their_marks(room):
    room.write('a.yaml', '''law: {preset: dieterich_gen}
slope: {alpha: 0.34}
trajectories: {starts: [{v: 1000, psi: 50}, {v: 100, psi: 50}, {v: 10, psi: 9}]}
''')
    room.good('simulate', 'a.yaml', '--figure', 'a.svg', '--keep-script')
    script = room.read('a_slip.gp')
    marks = {}
    for line in re.findall(r'# block (\d+): points (.*)', room.read('a_slip.dat')):
        marks.setdefault(line[1], []).append(re.findall(
            rf'data index {line[0]} with points pt (\d+)', script)[-1])
    expect(len(marks) == 6, marks)  # v and psi of each
    for curve in 'vψ':
        runs = [mark for entry, mark in marks.items()
                if entry.startswith(curve + ' from')]
        expect(len(runs) == 3 and len({mark[0] for mark in runs}) == 3, marks)


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
    orbits_leave_no_hole_and_are_no_bunch,
    a_title_is_the_scene_s_or_the_law_in_words,
    a_single_value_has_an_axis_and_a_mark_of_its_own,
    a_map_has_a_tint_at_any_size_of_its_values,
    manifolds_have_arrows_along_the_flow,
    what_jumps_at_a_fold_is_drawn_as_a_jump,
    what_does_not_exist_is_grey_and_in_the_legend,
    basins_of_a_system_say_whereto_they_go,
    one_value_is_drawn_as_a_point,
    several_runs_differ_by_their_marks,
    a_kept_script_draws_the_figure_again,
    every_format_is_what_its_name_says,
])
