#!/usr/bin/env python3
"""What slipway says of wrong words, wrong scenes and refusing files (TAP).

usage: cli_errors.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import json
import os
import signal
import subprocess

from cli_room import SLOPE, expect, refused, run_cases

SCENE = '''title: a slope
law: {preset: dieterich_gen}
slope: {alpha: 0.34}
products: [equilibria, manifolds]
output: {hdf5: out.h5, figure: out.svg}
'''

# ---- the command line --------------------------------------------------------

WRONG_WORDS = [
    (['portrat'], "'portrat'", 'did you mean portrait?'),
    (['knee', *SLOPE], 'did you mean knees?'),
    (['xyzzy'], "'xyzzy'", 'slipway help'),
    ([''], "no command ''"),
    (['help', 'plann'], 'did you mean plan?'),
    (['help', 'plan', 'knees'], 'knees'),
    (['laws', 'ruina'], 'ruina'),
    (['info'], 'FILE.h5'),
    (['info', 'a.h5', 'b.h5'], 'FILE.h5'),
    (['knees', '--bogus', *SLOPE], '--bogus'),
    (['knees', '-x', *SLOPE], '-x'),
    (['knees', *SLOPE, '--states', 'nothere.csv'], '--states', 'push'),
    (['knees', *SLOPE, '--v', '3'], '--v', 'push, simulate'),
    (['sweep', *SLOPE, '--sensitivities'], '--sensitivities', 'knees'),
    (['basin', *SLOPE, '--resume'], '--resume', 'sweep'),
    (['push', *SLOPE, '--tap'], '--tap', 'check, stress'),
    (['knees', *SLOPE, '--json=yes'], '--json=yes'),
    (['knees', '--law', 'ruina', '--alpha'], '--alpha'),
    (['knees'], '--law'),
    (['plan'], '--law'),
    (['knees', '--law', 'ruina'], '--alpha'),
    (['knees', '--law', 'ruinna', '--alpha', '0.3'], 'ruina'),
    (['knees', '--law', 'ageing', '--alpha', '0.3'], 'did you mean dieterich?'),
    (['knees', '--law', 'slip', '--alpha', '0.3'], 'did you mean ruina?'),
    (['knees', *SLOPE, '--set', 'material.Dc=1e-5'],
     'did you mean material.L?'),
    (['knees', '--law', 'ruina', '--alpha', '19.5'],
     'did you mean slope.alpha_deg?'),
    (['push', *SLOPE, '--v', '1', '--theta', '1'], 'did you mean psi?'),
    (['knees', '--law', 'ruina', '--alpha', '2'], 'alpha', 'pi/2'),
    (['knees', '--law', 'ruina', '--alpha', 'nan'], 'nan'),
    (['knees', *SLOPE, '--friction', 'logg'], 'log'),
    (['knees', *SLOPE, '--rtol', '0'], 'rtol'),
    (['knees', *SLOPE, '--seed', '-1'], 'seed'),
    (['knees', *SLOPE, '--set', 'material.a'], 'KEY=VALUE'),
    (['knees', *SLOPE, '--set', '=1'], '=1'),
    (['knees', *SLOPE, '--set', 'material.mu=1'], 'mu_star'),
    (['knees', *SLOPE, '--set', 'window.v=[1, 0.1]'], 'window.v'),
    (['knees', *SLOPE, '--progress', 'loud'], 'loud', 'none'),
    (['knees', *SLOPE, '--figure', 'a.jpg', '-o', 'a.h5'], 'a.jpg', '.svg'),
    (['portrait', *SLOPE, '--figure', 'a.svg', '-o', 'a.svg'], 'a.svg'),
    (['portrait', *SLOPE, '-o', 'portrait.svg', '--figure', 'portrait.svg'],
     'portrait.svg'),
    *[(['knees', *SLOPE, '--threads', n], '--threads', 'from 1')
      for n in ('0', '-1', 'abc', '', '1e3', '99999999999999999999')],
]


def wrong_words_are_refused_in_one_line(room):
    for args, *words in WRONG_WORDS:
        refused(room.run(*args), 2, *words)
    expect(room.names() == [], room.names())


def two_scenes_are_one_too_many(room):
    room.write('a.yaml', SCENE)
    room.write('b.yaml', SCENE)
    for command in ('knees', 'study', 'portrait', 'plan'):
        refused(room.run(command, 'a.yaml', 'b.yaml'), 2, 'b.yaml')
    expect(room.names() == ['a.yaml', 'b.yaml'], room.names())


def no_arguments_list_the_commands(room):
    said = room.good()
    expect('portrait' in said and 'Examples:' in said, said)


# ---- scenes ------------------------------------------------------------------

def changed(old, new):
    expect(old in SCENE, old)
    return SCENE.replace(old, new)


MALFORMED = [
    (changed('title', 'titel'), ':1:1:', 'titel', 'title'),
    (changed('preset: d', 'presett: d'), ':2:7:', 'preset'),
    (changed('dieterich_gen', 'dietrich_gen'), ':2:', 'dieterich_gen'),
    (changed('law: {preset: dieterich_gen}\n', ''), 'no law'),
    (changed('slope: {alpha: 0.34}\n', ''), 'no slope'),
    (changed('0.34', '0.34x'), ':3:', 'slope.alpha', '0.34x'),
    (changed('0.34', '1.58'), ':3:', 'slope.alpha', 'pi/2'),
    (changed('alpha: 0.34', 'alpha: 0.34, alpha_deg: 20'), ':3:', 'alpha_deg'),
    (changed('0.34', '[0.34]'), ':3:', 'slope.alpha'),
    (changed('0.34', '0x1p-2'), ':3:', 'slope.alpha'),
    (changed('[equilibria, manifolds]', '[equilibria, manifold]'), ':4:',
     'manifolds'),
    (changed('[equilibria, manifolds]', '{}'), ':4:', 'products'),
    (SCENE + 'window: {v: [1, 1]}\n', ':6:', 'window.v'),
    (SCENE + 'window: {psi: [1, 2, 3]}\n', ':6:', 'window.psi'),
    (SCENE + 'material: {a: -1}\n', ':6:', 'material.a'),
    (SCENE + 'material: {R: 100}\n', ':6:', 'material.R', 'dieterich_gen'),
    (SCENE + 'accuracy: {rtol: 1e-20}\n', ':6:', 'accuracy.rtol'),
    (SCENE + 'orbits: {spread: 8}\n', ':6:1:', 'orbits', 'trajectories'),
    (SCENE + 'trajectories: {starts: [{v: 1}]}\n', ':6:', 'starts', 'psi'),
    (SCENE + 'trajectories: {spread: 1.5}\n', ':6:', 'spread'),
    (changed('out.svg', 'out.jpg'), ':5:', 'output.figure', '.svg'),
    (SCENE + 'title: again\n', ':6:1:', 'title'),
    (changed('0.34}', '0.34'), ':4:', 'YAML'),
    (SCENE + '\tgravity: 9.81\n', ':6:', 'YAML'),
    (SCENE + 'gravity: &g 9.81\n', ':6:', 'anchors'),
    (SCENE + '---\nlaw: x\n', 'second document'),
    ('- a\n- list\n', 'list'),
    ('', 'no law'),
    (SCENE.encode() + b'gravity: \xff\n', 'byte', 'UTF-8'),
    (SCENE.encode('utf-16'), 'byte'),
    (bytes(range(256)), ':1:1:'),
    (SCENE + 'x' * 100000 + ': 1\n', ':6:'),
    (SCENE + 'gravity: ' + '[' * 5000 + '\n', ':6:'),
]


def malformed_scenes_cost_one_line_and_write_nothing(room):
    for text, *words in MALFORMED:
        room.write('bad.yaml', text)
        for command in ('study', 'plan'):
            refused(room.run(command, 'bad.yaml'), 2, 'bad.yaml', *words)
        expect(room.names() == ['bad.yaml'], text[:300], room.names())
    expect(len(MALFORMED) >= 20, len(MALFORMED))


def a_wrong_override_is_named_as_such(room):
    room.write('a.yaml', SCENE)
    refused(room.run('study', 'a.yaml', '--set', 'slope.alpha=x'), 2,
            '--set slope.alpha=x', 'slope.alpha')
    refused(room.run('study', 'a.yaml', '--set', 'slope.beta=1'), 2,
            '--set slope.beta=1', 'alpha')
    expect(room.names() == ['a.yaml'], room.names())


def scenes_that_cannot_be_read_exit_4(room):
    room.make('folder')
    for name in ('none.yaml', 'folder', 'none/a.yaml'):
        for command in ('study', 'portrait', 'knees', 'plan'):
            refused(room.run(command, name), 4, name)
    expect(room.names() == ['folder'], room.names())


# ---- files that cannot be written --------------------------------------------

def outputs_that_cannot_be_written_exit_4_before_anything_is(room):
    room.make('folder')
    room.make('folder.svg')
    os.mkfifo(room.path('pipe'))
    for args in (['-o', '/dev/null/a.h5'], ['-o', 'folder'], ['-o', 'pipe'],
                 ['-o', 'a.h5', '--figure', '/dev/null/a.svg'],
                 ['-o', 'a.h5', '--figure', 'folder.svg'],
                 ['-o', '/proc/a.h5', '--figure', 'a.svg']):
        refused(room.run('portrait', *SLOPE, *args), 4, args[-1]
                if 'a.h5' in args else args[1])
    expect(room.names() == ['folder', 'folder.svg', 'pipe'], room.names())


def an_old_file_survives_a_failed_run(room):
    room.write('a.yaml', SCENE)
    room.good('study', 'a.yaml')
    before = room.bytes('out.h5'), room.bytes('out.svg')
    refused(room.run('study', 'a.yaml', '--set', 'slope.alpha=9'), 2)
    refused(room.run('study', 'a.yaml', '--figure', '/dev/null/a.png'), 4)
    expect((room.bytes('out.h5'), room.bytes('out.svg')) == before, 'changed')
    expect(room.names() == ['a.yaml', 'out.h5', 'out.svg'], room.names())


def without_gnuplot_the_numbers_are_written_and_the_exit_is_4(room):
    room.write('a.yaml', SCENE)
    done = room.run('portrait', 'a.yaml', PATH=room.folder)
    lines = done.stderr.splitlines()
    expect(done.returncode == 4 and len(lines) == 1
           and 'gnuplot was not found' in lines[0]
           and done.stdout == 'wrote out.h5\n', done)
    expect(room.names() == ['a.yaml', 'out.h5'], room.names())
    room.good('info', 'out.h5')


def a_gnuplot_that_fails_is_quoted_and_leaves_nothing(room):
    room.fake('gnuplot', 'echo "no terminal today" >&2; exit 1')
    refused(room.run('portrait', *SLOPE, '--figure', 'a.svg'), 4,
            'no terminal today')
    room.fake('gnuplot', 'exit 0')
    refused(room.run('portrait', *SLOPE, '--figure', 'a.svg'), 4, 'a.svg')
    room.fake('gnuplot', 'kill -9 $$')
    refused(room.run('portrait', *SLOPE, '--figure', 'a.svg'), 4, 'gnuplot')
    expect(room.names() == [], room.names())


PRINTING = ['', 'help', 'help knees', '--help', 'knees --help', '--version',
            'laws', 'laws --json', 'plan a.yaml', 'plan a.yaml --json',
            'knees a.yaml', 'knees a.yaml --json', 'info out.h5',
            'info out.h5 --json', 'info out.h5 scene', 'study a.yaml']


def output_that_does_not_arrive_exits_4(room):
    room.write('a.yaml', SCENE)
    room.good('study', 'a.yaml')
    before = room.bytes('out.h5')
    for command in PRINTING:
        for where in ('>/dev/full', '>&-'):
            done = room.shell(f'slipway {command} {where}')
            refused(done, 4, 'standard output')
    # nothing of what is printed ends up in a file that was opened meanwhile
    for where in ('>&- 2>&-', '<&- >&- 2>&-', '2>&- >/dev/null'):
        room.shell(f'slipway study a.yaml {where}')
        expect(room.bytes('out.h5') == before, where)
    expect(room.names() == ['a.yaml', 'out.h5', 'out.svg'], room.names())


def an_interrupt_stops_and_leaves_nothing(room):
    for number in (signal.SIGINT, signal.SIGTERM):
        job = subprocess.Popen(
            [room.slipway, 'portrait', *SLOPE, '-o', 'a.h5', '--figure',
             'a.svg', '--set', 'trajectories.spread=10000', '--progress',
             'json'], cwd=room.folder, text=True, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE)
        while json.loads(job.stderr.readline())['stage'] != 'trajectories':
            pass
        job.send_signal(number)
        said, complaints = job.communicate(timeout=300)
        told = [line for line in complaints.splitlines() if line[0] != '{']
        expect((job.returncode, said) == (130, '') and len(told) == 1,
               job.returncode, said, told)
        expect(room.names() == [], room.names())


# ---- files that are none of ours ---------------------------------------------

def info_refuses_what_is_no_whole_result(room):
    room.good('study', *SLOPE, '-o', 'a.h5')
    whole = room.bytes('a.h5')
    room.write('a.yaml', SCENE)
    room.write('empty.h5', '')
    room.make('folder')
    os.mkfifo(room.path('pipe'))
    for name in ('none.h5', 'a.yaml', 'empty.h5', 'folder', 'pipe',
                 '/dev/null'):
        refused(room.run('info', name), 4, name)
        refused(room.run('info', name, 'scene'), 4, name)
    for part in (10, 100, 1000, len(whole) // 2, len(whole) - 1):
        room.write('t.h5', whole[:part])
        refused(room.run('info', 't.h5'), 4, 't.h5')


def info_never_crashes_on_damaged_files(room):
    room.good('study', *SLOPE, '-o', 'a.h5', '--set', 'products=[equilibria]')
    whole = room.bytes('a.h5')
    for at in range(8, len(whole), len(whole) // 60):
        damaged = bytearray(whole)
        damaged[at:at + 4] = b'\xff\xfe\x00\x80'
        room.write('d.h5', bytes(damaged))
        for extra in ([], ['scene']):
            # HDF5 loses some memory over damaged files
            done = room.run('info', 'd.h5', *extra,
                            ASAN_OPTIONS='detect_leaks=0')
            expect(done.returncode in (0, 2, 4)
                   and len(done.stderr.splitlines())
                   == (done.returncode != 0), at, done)


run_cases([
    wrong_words_are_refused_in_one_line,
    two_scenes_are_one_too_many,
    no_arguments_list_the_commands,
    malformed_scenes_cost_one_line_and_write_nothing,
    a_wrong_override_is_named_as_such,
    scenes_that_cannot_be_read_exit_4,
    outputs_that_cannot_be_written_exit_4_before_anything_is,
    an_old_file_survives_a_failed_run,
    without_gnuplot_the_numbers_are_written_and_the_exit_is_4,
    a_gnuplot_that_fails_is_quoted_and_leaves_nothing,
    output_that_does_not_arrive_exits_4,
    an_interrupt_stops_and_leaves_nothing,
    info_refuses_what_is_no_whole_result,
    info_never_crashes_on_damaged_files,
])
