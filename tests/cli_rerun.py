#!/usr/bin/env python3
"""slipway info --rerun: does a file's own scene make it again (TAP).

usage: cli_rerun.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import json
import os
import subprocess

from cli_room import READER, SLOPE, expect, refused, run_cases


def change(room, code):
    """Runs Python on the open file `f`."""
    subprocess.run([READER, '-c', 'import h5py, numpy\n'
                    'with h5py.File("a.h5", "r+") as f:\n'
                    '    p = f["provenance"].attrs\n    ' + code],
                   cwd=room.folder, check=True)


def again(room, *more):
    before = set(os.listdir(room.path('tmp')))
    done = room.run('info', 'a.h5', '--rerun', *more, TMPDIR=room.path('tmp'))
    expect(set(os.listdir(room.path('tmp'))) == before, 'left behind')
    return done


def same(room, *command):
    """The command's file is made again from what the file holds alone."""
    room.good(*command, '-q', '-o', 'a.h5')
    done = again(room)
    expect((done.returncode, done.stdout, done.stderr) ==
           (0, 'same bytes\n', ''), command, done)


def every_command_s_file_is_made_again(room):
    room.bring('scenes')
    room.make('tmp')
    room.make('outputs')
    same(room, 'study', 'scenes/fig07b.yaml')
    same(room, 'study', 'scenes/taylor.yaml')
    same(room, 'knees', *SLOPE, '--set', 'law.friction=log')
    same(room, 'knees', 'scenes/sweep.yaml')
    same(room, 'basin', *SLOPE, '--set', 'basins.cells=[64, 64]')
    same(room, 'portrait', *SLOPE, '--seed', '7', '--figure', 'a.svg')
    same(room, 'sweep', 'scenes/sweep.yaml', '--set', 'sweep.points=5')
    same(room, 'sweep', 'scenes/sweep.yaml', '--set',
         'products=[knees, sensitivities]', '--set',
         'sweep.points=3')
    same(room, 'simulate', *SLOPE, '--v', '1e3', '--psi', '10')
    for name in ('rabinowicz.yaml', 'rabinowicz.csv'):
        os.rename(room.path('scenes/' + name), room.path(name))
    same(room, 'rabinowicz', 'rabinowicz.yaml')


def nothing_else_is_written(room):
    room.make('tmp')
    room.good('knees', *SLOPE, '-q', '-o', 'a.h5', '--set',
              'output.figure=a.svg')
    os.remove(room.path('a.svg'))
    stamp = os.stat(room.path('a.h5'))
    expect(again(room).stdout == 'same bytes\n', 'rerun')
    expect(room.names() == ['a.h5', 'tmp'], room.names())
    expect(os.stat(room.path('a.h5')).st_mtime_ns == stamp.st_mtime_ns, 'kept')


def a_changed_file_is_named_data_set_by_data_set(room):
    room.make('tmp')
    room.good('knees', *SLOPE, '-q', '-o', 'a.h5')
    change(room, 'f["critical/v_plus"][()] *= 1 + 1e-9')
    done = again(room)
    expect((done.returncode, done.stderr) == (1, '') and done.stdout ==
           '/critical/v_plus: 1 of 1 values differ, by up to 1.0e-09 of them\n'
           'not the same bytes\n', done)
    change(room, 'del f["folds"]')
    change(room, 'p["version"] = numpy.bytes_("0.0.9")')
    done = again(room)
    expect(done.returncode == 1 and '/folds: only in the second\n'
           in done.stdout and "/provenance version: '0.0.9' and '"
           in done.stdout, done)
    found = json.loads(again(room, '--json').stdout)
    expect(found['same_bytes'] is False and
           {'path': '/critical/v_plus', 'key': '',
            'what': '1 of 1 values differ, by up to 1.0e-09 of them'}
           in found['differences'], found)
    done = again(room, '-q')
    expect((done.returncode, done.stdout) == (1, ''), done)


def another_scene_inside_makes_other_numbers(room):
    room.make('tmp')
    room.good('knees', *SLOPE, '-q', '-o', 'a.h5')
    change(room, 'p["overrides"] = numpy.bytes_(bytes(p["overrides"])'
                 '.replace(b"0.34", b"0.35"))')
    done = again(room)
    expect(done.returncode == 1 and '/critical/v_plus: 1 of 1' in done.stdout,
           done)


def what_cannot_run_again_says_so_in_a_line(room):
    room.make('tmp')
    room.good('stress', '--quick', '--only', 'flat/spinodal_gen', '-q',
              '-o', 'a.h5')
    refused(again(room), 2, 'a.h5', 'stress')
    room.good('knees', *SLOPE, '-q', '-o', 'a.h5')
    change(room, 'p["overrides"] = numpy.bytes_("law.preset=none")')
    refused(again(room), 2, 'law.preset')
    change(room, 'del f["provenance"]')
    refused(again(room), 4, 'a.h5')
    refused(room.run('info', '--rerun'), 2, 'FILE.h5')
    refused(room.run('info', '--rerun', 'none.h5'), 4, 'none.h5')
    refused(room.run('info', '--rerun', 'a.h5', 'scene'), 2, 'scene')


def it_takes_no_more_threads_than_told(room):
    room.make('tmp')
    room.good('basin', *SLOPE, '-q', '-o', 'a.h5', '--threads', '1', '--set',
              'basins.cells=[64, 64]')
    for threads in ('1', '2'):
        expect(again(room, '--threads', threads).stdout == 'same bytes\n',
               threads)


run_cases([
    every_command_s_file_is_made_again,
    nothing_else_is_written,
    a_changed_file_is_named_data_set_by_data_set,
    another_scene_inside_makes_other_numbers,
    what_cannot_run_again_says_so_in_a_line,
    it_takes_no_more_threads_than_told,
])
