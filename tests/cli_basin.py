#!/usr/bin/env python3
"""Basin maps from the command line: files, kills, signals, full disks (TAP).

usage: cli_basin.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import json
import os
import random
import resource
import signal
import subprocess
import time

from cli_room import expect, refused, run_cases, seen_on_a_terminal, starts

SADDLE = ['basin', '--law', 'spinodal_gen', '--alpha', '0.34']
FIGURES = {'fig05a': {'creep'}, 'fig05b': {'creep', 'sliding'},
           'fig05c': {'sliding'}}
KILLS = 50
# So many rows that writing them takes a while.
HUGE = ['--set', 'basins={cells: [16384, 16384], audit: 0}']
LARGE = ['--set', 'basins={cells: [4096, 4096], audit: 0, exact: true}']


def small(nv=40, npsi=30, audit=50):
    return ['--set', f'basins={{cells: [{nv}, {npsi}], audit: {audit}}}']


def maps(room, *names):
    return json.loads(room.reads('read_basin.py', *names))


def ends(job):
    """What it said, once it is gone."""
    try:
        return job.communicate(timeout=300)
    finally:
        job.kill()


# ---- what the files hold -----------------------------------------------------

def figure_5_is_read_by_everyone(room):
    room.bring('scenes')
    room.make('outputs')
    for name in FIGURES:
        room.good('basin', f'scenes/{name}_basin.yaml', '--set',
                  'basins.audit=200', '-o', name + '.h5')
        expect(os.path.getsize(room.path(f'outputs/{name}_basin.svg')) > 1e4,
               name)
    room.reads('open_file.py', 'fig05b.h5')
    for name, found in maps(room, *(n + '.h5' for n in FIGURES)).items():
        expect(set(found['cells']) == FIGURES[name[:6]]
               and found['shape'] == [300, 400] and found['audit'] == 200
               and found['holds'] == ['label', 'margin', 'margin_psi', 'psi',
                                      'v'], name, found)
    facts = {item['path']: item for item in room.json('info', 'fig05b.h5')}
    expect(facts['/basin/label']['shape'] == [300, 400], facts)


def margins_are_written_only_where_asked_for(room):
    room.good(*SADDLE, *small(), '-o', 'a.h5')
    expect(maps(room, 'a.h5')['a.h5']['holds'] == ['label', 'psi', 'v'],
           'more than labels')


def numbers_printed_are_those_of_the_file(room):
    told = json.loads(room.good(*SADDLE, *small(audit=77), '-o', 'a.h5',
                                '--json'))['basin']
    stored = maps(room, 'a.h5')['a.h5']
    expect(told['cells'] == [40, 30]
           and told['audit'] == {'cells': 77, 'disagreements': 0}, told)
    expect({fate: [share['log']['value'], share['log']['error']]
            for fate, share in told['fractions'].items()} == stored['shares'],
           told, stored)


# ---- the same map ------------------------------------------------------------

def the_same_bytes_from_anywhere_at_any_thread_count(room):
    room.bring('scenes')
    for folder, threads in (('a', '1'), ('b c', '3')):
        room.make(folder)
        for exact in ([], ['--exact', '--set', 'basins.cells=[24, 18]']):
            room.good('basin', '../scenes/fig05b_basin.yaml', '--set',
                      'basins.audit=300', '--threads', threads, *exact, '-o',
                      'exact.h5' if exact else 'map.h5', '--figure', 'map.svg',
                      cwd=folder)
    for name in ('map.h5', 'exact.h5', 'map.svg'):
        expect(room.bytes('a/' + name) == room.bytes('b c/' + name), name)


def exact_labels_are_those_of_the_separatrix(room):
    for name, law in (('a', 'spinodal_gen'), ('b', 'dieterich_gen')):
        scene = ['basin', '--law', law, '--alpha', '0.34', *small(60, 45),
                 '--set', 'products=[basins, margin]']
        room.good(*scene, '-o', name + '1.h5')
        room.good(*scene, '-o', name + '2.h5', '--exact')
        room.reads('read_basin.py', '--near', name + '1.h5', name + '2.h5')


# ---- other windows, other laws -----------------------------------------------

def window(v, psi, axes='log'):
    return ['--set', f'window={{v: {v}, psi: {psi}, axes: {axes}}}']


REGIMES = {  # law, alpha, more arguments; fates of the cells
    'linear': (['spinodal_gen', '0.34', *window('[1e-3, 2e4]', '[1e-4, 10]',
                                                'linear')],
               {'creep', 'sliding'}),
    'no saddle inside': (['spinodal_gen', '0.34',
                          *window('[100, 1e6]', '[1e-6, 1e3]')],
                         {'creep', 'sliding'}),
    'far from the saddle': (['spinodal_gen', '0.34',
                             *window('[1e-3, 1e-2]', '[1, 10]')], {'creep'}),
    'one cell': (['spinodal_gen', '0.34', *small(1, 1)], {'sliding'}),
    'one row': (['spinodal_gen', '0.34', *small(300, 1)],
                {'creep', 'sliding'}),
    'below the folds': (['spinodal_gen', '0.28'], {'creep'}),
    'above the folds': (['spinodal_gen', '0.40'], {'sliding'}),
    'other fates': (['dieterich_gen', '0.34'], {'rest_finite', 'runaway'}),
    'lower branch meets v = 0': (['spinodal', '0.34'], {'creep', 'sliding'}),
    'another spinodal law': (['spinodal_phi_gen', '0.34'],
                             {'creep', 'sliding'}),
    'open upper branch': (['dieterich', '0.34'],
                          {'rest_asymptotic', 'runaway'}),
    'psi is a logarithm, open': (['perrin', '0.34'],
                                 {'rest_asymptotic', 'runaway'}),
    'ruina': (['ruina', '0.34'], {'rest_asymptotic', 'runaway'}),
}


def every_regime_is_labelled(room):
    for name, ((law, alpha, *args), _) in REGIMES.items():
        room.good('basin', '--law', law, '--alpha', alpha, *small(),
                  *args, '--set', 'products=[basins, margin]', '-o',
                  name + '.h5')
    found = maps(room, *(name + '.h5' for name in REGIMES))
    for name, axis, even, *sides in (
            ('linear', 'v', 'steps', 1e-3, 2e4),
            ('linear', 'psi', 'steps', 1e-4, 10),
            ('no saddle inside', 'v', 'factors', 100, 1e6),
            ('psi is a logarithm, open', 'psi', 'steps', -7, 5)):
        how, *near = found[name + '.h5'][axis]
        expect(how == even and all(abs(a - b) < 1e-9 * sides[1]
                                   for a, b in zip(near, sides)), name, near)
    wrong = {name: found[name + '.h5']['cells']
             for name, (_, fates) in REGIMES.items()
             if set(found[name + '.h5']['cells']) != fates}
    expect(not wrong, wrong)


# ---- killed, interrupted -----------------------------------------------------

def a_killed_run_leaves_the_old_file_or_the_new_one(room):
    scene = [*SADDLE, *small(300, 200, 0), '--set',
             'products=[basins, margin]', '--quiet', '-o', 'a.h5']
    whole = []
    for alpha in ('0.34', '0.33'):
        start = time.monotonic()
        room.good(*scene, '--alpha', alpha)
        usual = time.monotonic() - start
        whole.append(room.bytes('a.h5'))
    chance = random.Random(int(os.environ.get('CHECK_SEED', '1')))
    between = 0
    for turn in range(KILLS):
        old, new = room.bytes('a.h5'), whole[turn % 2]
        job = starts(room, *scene, '--alpha', ('0.34', '0.33')[turn % 2])
        # every other one about when it writes
        time.sleep(usual * chance.uniform(0.8 * (turn % 4 > 1), 1.1))
        job.kill()
        job.communicate()
        expect(room.bytes('a.h5') in (old, new), 'broken at kill', turn)
        expect(room.bytes('a.h5') == new or job.returncode != 0, 'not written')
        # between the two calls that give the whole new file its name
        left = [name for name in room.names() if name != 'a.h5']
        expect(all(room.bytes(name) == new for name in left), 'left', left)
        for name in left:
            os.remove(room.path(name))
        between += len(left)
    expect(between < KILLS / 10, 'files were left by', between, 'kills')


def interrupts_stop_and_leave_the_old_file(room):
    room.write('old.h5', 'old')
    for number in (signal.SIGINT, signal.SIGTERM):
        for name in ('new.h5', 'old.h5'):
            job = starts(room, *SADDLE, *HUGE, '-o', name, '--progress',
                         'json')
            while json.loads(job.stderr.readline())['stage'] != 'rows':
                pass
            job.send_signal(number)
            said, complaints = ends(job)
            told = [line for line in complaints.splitlines()
                    if line[0] != '{']
            expect((job.returncode, said) == (130, '') and len(told) == 1
                   and name in told[0], job.returncode, said, told)
            expect(room.names() == ['old.h5']
                   and room.read('old.h5') == 'old', room.names())


# ---- progress ----------------------------------------------------------------

def progress_json_is_one_object_a_line(room):
    done = room.run(*SADDLE, *small(64, 900, 500), '--exact', '--progress',
                    'json', '-o', 'a.h5')
    lines = [json.loads(line) for line in done.stderr.splitlines()]
    expect(done.returncode == 0 and len(lines) > 3, done)
    expect(all(list(line) == ['stage', 'done', 'total']
               and 0 <= line['done'] and isinstance(line['total'], int)
               and (line['done'] <= line['total'] or line['total'] == 0)
               for line in lines), lines)
    rows = [line['done'] for line in lines if line['stage'] == 'rows']
    expect(rows == sorted(set(rows)) and lines[-1]
           == {'stage': 'rows', 'done': 900, 'total': 900}, lines)


def a_terminal_shows_a_bar_with_rate_and_time_left(room):
    scene = [*SADDLE, *small(64, 1500, 0), '--exact', '-o', 'a.h5']
    shown = seen_on_a_terminal(room, *scene).split('\r\033[K')
    expect(any(line.startswith('rows [') and '%' in line and '/s' in line
               and line.endswith(' left') for line in shown), shown)
    expect(shown[-1] == '' and max(map(len, shown)) < 80
           and '\n' not in ''.join(shown), shown)
    for args in (['--quiet'], ['--progress', 'none']):
        expect(seen_on_a_terminal(room, *SADDLE, *small(), *args) == '', args)
    room.good(*SADDLE, *small(), '--progress', 'auto')  # none: no complaint
    again = seen_on_a_terminal(room, 'info', '--rerun', 'a.h5')
    expect('rows [' in again and ' left' in again, again)
    expect(seen_on_a_terminal(room, 'info', '--rerun', 'a.h5', '--quiet') == '',
           'quiet')


# ---- full disks, memory ------------------------------------------------------

def a_file_size_limit_exits_4_and_keeps_the_old_file(room):
    room.write('a.h5', 'old')
    done = subprocess.run(
        [room.slipway, *SADDLE, *small(300, 200, 0), '--set',
         'products=[basins, margin]', '-o', 'a.h5'], cwd=room.folder,
        text=True, capture_output=True, check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE,
                                              (50000, 50000)))
    refused(done, 4, 'a.h5', 'File too large')
    expect(room.names() == ['a.h5'] and room.read('a.h5') == 'old',
           room.names())


def a_full_disk_exits_4_and_leaves_nothing(room):
    room.make('disk')
    mount = 'mount -t tmpfs -o size=64k none disk'
    if room.shell(f'unshare -m sh -c "{mount}"').returncode != 0:
        a_full_disk_exits_4_and_leaves_nothing.__name__ += (
            ' # SKIP only root may mount a small disk')
        return
    done = room.shell(
        f"unshare -m sh -c '{mount}; slipway basin --law spinodal_gen "
        "--alpha 0.34 --set \"products=[basins, margin]\" -o disk/a.h5; "
        "echo $?; ls -A disk'")
    lines = done.stderr.splitlines()
    expect(done.stdout == '4\n' and len(lines) == 1 and 'disk/a.h5' in lines[0]
           and 'No space left' in lines[0], done)


def memory(room, *args):
    """Largest resident size of slipway, in MiB."""
    job = subprocess.Popen([room.slipway, *args], cwd=room.folder,
                           stdout=subprocess.DEVNULL)
    _, code, used = os.wait4(job.pid, 0)
    job.returncode = os.waitstatus_to_exitcode(code)
    expect(job.returncode == 0, args)
    return used.ru_maxrss / 1024


def a_map_of_8192_squared_cells_takes_less_than_64_megabytes(room):
    with open(room.slipway, 'rb') as file:
        if b'__asan_init' in file.read():
            a_map_of_8192_squared_cells_takes_less_than_64_megabytes \
                .__name__ += ' # SKIP the sanitizer takes memory of its own'
            return
    used = memory(room, *SADDLE, *small(8192, 8192, 100), '-o', 'a.h5')
    expect(used < 64, used)


# ---- wrong keys --------------------------------------------------------------

WRONG_BASINS = [
    ('cells: [0, 5]', 6, 18, 'basins.cells', "'0'", '1 to 32768'),
    ('cells: [5, 40000]', 6, 21, 'basins.cells', "'40000'"),
    ('cells: [5.5, 5]', 6, 18, 'basins.cells', "'5.5'"),
    ('cells: [5]', 6, 17, 'basins.cells', '[nv, npsi]'),
    ('cells: [5, 5, 5]', 6, 17, 'basins.cells', '[nv, npsi]'),
    ('cells: 5', 6, 17, 'basins.cells', '[nv, npsi]'),
    ('audit: -1', 6, 17, 'basins.audit', "'-1'"),
    ('audit: many', 6, 17, 'basins.audit', "'many'"),
    ('exact: maybe', 6, 17, 'basins.exact', 'false or true'),
    ('exakt: true', 6, 10, 'basins.exakt', 'did you mean basins.exact?'),
    ('cells: [5, 5], cells: [6, 6]', 6, 25, 'cells'),
]


def a_separatrix_beyond_doubles_is_refused_with_the_reason(room):
    far = ['--law', 'dieterich_gen', '--alpha', '1.4']
    for more in (['basin', *far, '-o', 'a.h5'],
                 ['push', *far, '--v', '1', '--psi', '1']):
        done = room.run(*more)
        expect(done.returncode == 3 and done.stderr.count('\n') == 1
               and 'further apart than doubles' in done.stderr, done)
    expect(room.names() == [], room.names())


def wrong_basins_are_refused_in_one_line(room):
    scene = ('title: t\nlaw: {preset: ruina}\nslope: {alpha: 0.34}\n'
             'products: [basins]\noutput: {hdf5: a.h5}\nbasins: {%s}\n')
    for text, line, column, *words in WRONG_BASINS:
        room.write('a.yaml', scene % text)
        for command in ('basin', 'plan'):
            refused(room.run(command, 'a.yaml'), 2,
                    f'a.yaml:{line}:{column}: ', *words)
    room.write('a.yaml', scene % 'audit: 0')
    for override, *words in (('basins.cells=[0, 1]', 'basins.cells'),
                             ('basins.cell=[1, 1]', 'basins.cells'),
                             ('basins=7', 'basins')):
        refused(room.run('basin', 'a.yaml', '--set', override), 2,
                '--set ' + override, *words)
    expect(room.names() == ['a.yaml'], room.names())


run_cases([
    figure_5_is_read_by_everyone,
    margins_are_written_only_where_asked_for,
    numbers_printed_are_those_of_the_file,
    the_same_bytes_from_anywhere_at_any_thread_count,
    exact_labels_are_those_of_the_separatrix,
    every_regime_is_labelled,
    a_killed_run_leaves_the_old_file_or_the_new_one,
    interrupts_stop_and_leave_the_old_file,
    progress_json_is_one_object_a_line,
    a_terminal_shows_a_bar_with_rate_and_time_left,
    a_file_size_limit_exits_4_and_keeps_the_old_file,
    a_full_disk_exits_4_and_leaves_nothing,
    a_map_of_8192_squared_cells_takes_less_than_64_megabytes,
    a_separatrix_beyond_doubles_is_refused_with_the_reason,
    wrong_basins_are_refused_in_one_line,
])
