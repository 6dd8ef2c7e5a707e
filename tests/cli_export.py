#!/usr/bin/env python3
"""slipway export, and what XPPAUT and AUTO-07p make of it (TAP).

usage: cli_export.py PATH_TO_SLIPWAY SOURCE_ROOT

Both programs must be there: a run without them fails and names the package.
XPPAUT keeps single precision and prints 8 digits of it; AUTO prints 11.
"""
import os
import re
import shutil
import struct
import subprocess

from cli_room import LAWS, expect, refused, run_cases

SLIP_C = ['--set', 'law.theta=ln_c_psi', '--set', 'law.psi_ss=inverse',
          '--set', 'law.timescale=slip', '--set', 'law.kinetics=sinh']
FREEZING = ['--set', 'law.theta=ln_psi', '--set', 'law.psi_ss=inverse',
            '--set', 'law.timescale=slip45', '--set', 'law.kinetics=sinh']
KATO = ['--law', 'kato_tullis', '--set', 'material.V_c=1e3']


def systems():
    """Every law in both forms, at one slope."""
    laws = [['--law', law] for law in LAWS] + [KATO, SLIP_C, FREEZING]
    for law in laws:
        for form in 'asinh', 'log':
            yield [*law, '--set', f'law.friction={form}', '--alpha', '0.34']


# ---- the programs ------------------------------------------------------------

def program(name, package):
    expect(shutil.which(name), f'{name} is missing: install the package',
           package)
    return name


def run(room, *words):
    done = subprocess.run(words, cwd=room.folder, text=True, timeout=300,
                          env=room.environment(), capture_output=True,
                          stdin=subprocess.DEVNULL, check=False)
    expect(done.returncode == 0, words, done.stdout[-2000:], done.stderr)
    return done.stdout


def clear(room, ending=''):
    for name in room.names():
        if name.endswith(ending):
            os.remove(room.path(name))


def xppaut(room, name):
    """Runs NAME and answers the last line of each file it writes."""
    clear(room, '.dat')
    said = run(room, program('xppaut', 'xppaut'), '-silent', name)
    expect('Run complete' in said and 'llegal' not in said, said)
    return {old[:-4]: room.read(old).split('\n')[-2].split()
            for old in room.names() if old.endswith('.dat')}


def auto(room, script):
    program('auto-07p', 'auto-07p')
    program('gfortran', 'gfortran')
    return run(room, 'auto-07p', script)


def points(room, name, kind):
    """The points of a kind (2: LP, -4: UZ, ...) in b.NAME: their numbers."""
    rows = [line.split() for line in room.read('b.' + name).splitlines()]
    return [row[4:] for row in rows if row[0] != '0' and row[2] == str(kind)]


def as_xppaut(value):
    """What XPPAUT prints of it."""
    return '%.8g' % struct.unpack('f', struct.pack('f', value))


def as_auto(value):
    return float('%.10e' % value)


# ---- numbers -----------------------------------------------------------------

def ends_of(numbers):
    """Branch -> (column of the file, limit, as the state has it)."""
    found = {}
    if numbers['v_plus']['value'] is not None:
        found['upper'] = ('v', numbers['v_plus']['value'],
                          f"lnv-({numbers['ln_v_plus']['value']!r})")
    if numbers['v_minus']['value'] is not None:
        found['lower'] = ('v', numbers['v_minus']['value'],
                          f"lnv-({numbers['ln_v_minus']['value']!r})")
    if numbers['psi_at_v0']['value'] is not None:
        value = numbers['psi_at_v0']['value']
        found['lower'] = ('psi', value, f'PSI-({value!r})')
    return found


def columns_of(text):
    """Names of the columns that the .ode file makes XPPAUT print."""
    states = re.findall(r"^(\w+)'=", text, re.M)
    return ['t', *states, *re.findall(r'^aux (\w+)=', text, re.M)]


def with_miss(text, branch, end):
    """The file with one more column, the distance to the end, one branch."""
    psi = 'exp(lnpsi)' if "lnpsi'=" in text else 'psi'
    line = 'aux miss=' + end[2].replace('PSI', psi)
    other = 'lower' if branch == 'upper' else 'upper'
    text = re.sub(rf'^set {other} .*\n', '', text, flags=re.M)
    return text.replace('\ndone\n', f'\n{line}\ndone\n')


def xppaut_ends_where_the_branches_do(room):
    """8 digits as printed; 1e-12 of the double behind them."""
    checked, worst = 0, 0
    for system in systems():
        room.good('export', *system, '--as', 'xppaut', '-o', 'a.ode')
        text = room.read('a.ode')
        last = xppaut(room, 'a.ode')
        expect(set(last) == {'upper', 'lower'}, last)
        for branch, end in ends_of(room.json('knees', *system)).items():
            found = last[branch][columns_of(text).index(end[0])]
            expect(found == as_xppaut(end[1]), system, branch, end, found)
            room.write('b.ode', with_miss(text, branch, end))
            miss = abs(float(xppaut(room, 'b.ode')[branch][-1]))
            expect(miss < 1e-12, system, branch, end, miss)
            worst = max(worst, miss)
            checked += 1
    expect(checked >= 26, checked)
    print(f'# {checked} ends of {len(list(systems()))} systems, at most '
          f'{worst:.1e} from those of slipway')


def folds_of(room, system):
    folds = room.json('knees', *system)['folds']
    return [folds[name]['value'] for name in ('alpha_cM', 'alpha_cm')
            if folds[name]['value'] is not None]


def auto_finds_every_fold_to_its_last_digit(room):
    checked = 0
    for system in systems():
        if 'kato_tullis' in system:
            system += ['--set', 'material.a=0.06']  # where there are folds
        room.good('export', *system, '--as', 'auto', '-o', 'a.c')
        expected = folds_of(room, system)
        if not expected and checked > 2:
            continue  # another law without folds
        auto(room, 'a.auto')
        found = [float(row[0]) for row in points(room, 'a', 2)]
        expect(found == [as_auto(value) for value in expected], system, found,
               expected)
        expect(('c.a.folds' in room.names()) == ('b.a.folds' in room.names()),
               room.names())
        clear(room)
        checked += len(expected)
    expect(checked >= 16, checked)


SPINODAL = ['--law', 'spinodal_gen', '--alpha', '0.34']


def auto_follows_the_folds_through_the_cusp(room):
    """To what AUTO's differences of differences leave."""
    room.good('export', *SPINODAL, '--as', 'auto', '-o', 'a.c')
    auto(room, 'a.auto')
    folds = room.json('knees', *SPINODAL)['folds']
    cusp = points(room, 'a.folds', -22) or points(room, 'a.folds', 22)
    expect(len(cusp) == 1, room.read('b.a.folds')[-3000:])
    alpha, c = float(cusp[0][0]), float(cusp[0][4])
    expect(abs(alpha / folds['alpha_cusp']['value'] - 1) < 1e-9, alpha)
    expect(abs(c / folds['c_cusp']['value'] - 1) < 1e-6, c)
    end = points(room, 'a.folds', -24)[0]
    other = room.json('knees', *SPINODAL, '--set', f'material.c={end[4]}')
    expect(float(end[0]) == as_auto(other['folds']['alpha_cm']['value']), end)


# ---- parameters --------------------------------------------------------------

def a_parameter_changed_in_auto_is_changed(room):
    """Continued in R to 50, then in alpha: the folds of R = 50."""
    room.good('export', *SPINODAL, '--as', 'auto', '-o', 'a.c')
    room.write('b.auto', "run('a', ICP=['R'], UZSTOP={'R': 50}, DS=-0.01, "
               "DSMAX=5)\nsave('R')\nsave(run('a', s='R', IRS='UZ1', "
               "ICP=['alpha']), 'a')\n")
    auto(room, 'b.auto')
    expected = folds_of(room, [*SPINODAL, '--set', 'material.R=50'])
    found = [float(row[0]) for row in points(room, 'a', 2)]
    expect(len(found) == 2, found)
    expect(all(abs(a - b) < 2e-11 for a, b in zip(found, expected)), found,
           expected)


def where_differences_are_taken_from_changes_nothing(room):
    room.good('export', *SPINODAL, '--as', 'xppaut', '-o', 'a.ode')
    first = xppaut(room, 'a.ode')
    text = re.sub(r'^par lnv0=.*$', 'par lnv0=-2.5', room.read('a.ode'),
                  flags=re.M)
    room.write('b.ode', text)
    second = xppaut(room, 'b.ode')
    v = columns_of(text).index('v')
    expect([first[name][v] for name in first]
           == [second[name][v] for name in second], first, second)


def parameters_have_names_and_meanings(room):
    for how in (('xppaut', 'a.ode', r'^# (.*)\npar (\w+)=\S+$'),
                ('auto', 'a.c', r'^ +/\* (.*) \*/\n +const double (\w+) = par')):
        room.good('export', *SPINODAL, '--as', how[0], '-o', how[1])
        found = re.findall(how[2], room.read(how[1]), re.M)
        expect([row[1] for row in found if row[1] != 'dir'] ==
               ['alpha', 'mu_star', 'a', 'b', 'c', 'R', 'eps2', 'lnv0'], found)
        expect(found[0][0] == 'slope angle (rad)', found)
        expect(all(re.search(r' \(\w+\)$', row[0]) for row in found[:8]),
               found)


# ---- the other form ----------------------------------------------------------

def in_time_the_block_goes_where_slipway_says(room):
    for alpha in '0.34', '0.2', '0.39':  # two ends, creep only, sliding only
        system = ['--law', 'spinodal_gen', '--alpha', alpha]
        room.good('export', *system, '--as', 'xppaut', '--form', 'time', '-o',
                  'a.ode')
        text = room.read('a.ode')
        last = xppaut(room, 'a.ode')['output']
        nodes = [as_xppaut(state['v']['value'])
                 for state in room.json('knees', *system)['equilibria']]
        found = last[columns_of(text).index('v')]
        expect(found == nodes[0 if alpha == '0.2' else -1], alpha, found, nodes)


def without_a_saddle_only_the_arc_is_refused(room):
    flat = ['--law', 'spinodal_gen', '--alpha', '0.2', '--as', 'xppaut', '-o',
            'a.ode']
    for form in [], ['--form', 'arclength']:
        refused(room.run('export', *flat, *form), 3, 'no saddle', '--form time')
    expect(room.names() == [], room.names())
    room.good('export', *flat, '--form', 'time')
    expect(room.names() == ['a.ode'], room.names())
    refused(room.run('export', '--law', 'dieterich', '--alpha', '1.5', '--set',
                     'material.mu_star=0.1', '--as', 'auto'), 3,
            'no steady state')


# ---- files -------------------------------------------------------------------

HOSTILE = ('title: "a */ int x; /* b \\\\ # done"\n'
           'law: {preset: dieterich_gen}  # c */ \\\nslope: {alpha: 0.34}\n'
           'output: {hdf5: never.h5, figure: never.svg}\n')


def headers_say_where_the_system_comes_from(room):
    room.write('s.yaml', HOSTILE)
    room.good('export', 's.yaml', '--as', 'xppaut', '-o', 'a.ode')
    room.good('export', 's.yaml', '--as', 'auto', '-o', 'a.c')
    expect(sorted(xppaut(room, 'a.ode')) == ['lower', 'upper'], room.names())
    auto(room, 'a.auto')
    expect(not any(name.startswith('never') for name in room.names()),
           room.names())
    for name in 'a.ode', 'a.c':
        text = room.read(name)
        for word in ('slipway ', 'slope: {alpha: 0.34}', 'v_plus  ', '+- ',
                     'lambda_minus', 'saddle in the chart', 'int x;'):
            expect(word in text, name, word, text[:3000])


def files_are_the_same_twice_and_named_on_request(room):
    said = room.good('export', *SPINODAL, '--as', 'auto', '-o', 'a.c')
    expect(said == ''.join(f'wrote {name}\n' for name in (
        'a.c', 'a.auto', 'c.a', 'c.a.folds')), said)
    before = {name: room.read(name) for name in room.names()}
    expect(room.good('export', *SPINODAL, '--as', 'auto', '-o', 'a.c',
                     '--quiet') == '', 'not quiet')
    expect(before == {name: room.read(name) for name in room.names()},
           'not the same')
    expect(room.good('export', *SPINODAL, '--as', 'xppaut')
           == 'wrote spinodal_gen.ode\n', room.names())
    found = room.json('export', *SPINODAL, '--as', 'xppaut', '-o', 'a.ode')
    expect(found['v_plus']['value'] > 2850, found)


def wrong_words_cost_one_line(room):
    def export(*args):
        return room.run('export', *SPINODAL, *args)
    refused(export(), 2, '--as', 'xppaut or auto')
    refused(export('--as', 'matlab'), 2, 'matlab', 'xppaut or auto')
    refused(export('--as', 'xppaut', '--form', 'x'), 2, 'arclength')
    refused(export('--as', 'auto', '--form', 'time'), 2, '--form')
    refused(export('--as', 'auto', '-o', 'a.ode'), 2, 'NAME.c')
    refused(export('--as', 'xppaut', '-o', "a'b.ode"), 2, 'NAME.ode')
    refused(export('--as', 'xppaut', '-o', '.ode'), 2, 'NAME.ode')
    refused(export('--as', 'xppaut', '--figure', 'a.svg'), 2, '--figure')
    refused(export('--as', 'xppaut', '--set', 'output.hdf5=a.h5'), 2,
            'output.hdf5')
    refused(export('--as', 'xppaut', '-o', '/dev/null/a.ode'), 4, '/dev/null/a.ode')
    refused(export('--as', 'xppaut', 'a.yaml', 'b.yaml'), 2, 'b.yaml')
    refused(room.run('export', '--as', 'auto', '--law', 'ruina'), 2, 'slope')
    expect(room.names() == [], room.names())


run_cases([
    xppaut_ends_where_the_branches_do,
    auto_finds_every_fold_to_its_last_digit,
    auto_follows_the_folds_through_the_cusp,
    a_parameter_changed_in_auto_is_changed,
    where_differences_are_taken_from_changes_nothing,
    parameters_have_names_and_meanings,
    in_time_the_block_goes_where_slipway_says,
    without_a_saddle_only_the_arc_is_refused,
    headers_say_where_the_system_comes_from,
    files_are_the_same_twice_and_named_on_request,
    wrong_words_cost_one_line,
])
