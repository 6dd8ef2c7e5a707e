#!/usr/bin/env python3
"""Where files are looked for and go (TAP); test_install.py runs the scenes.

usage: cli_places.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import os
import subprocess

from cli_room import SLOPE, expect, refused, run_cases

def an_output_makes_its_folders(room):
    room.good('knees', *SLOPE, '-o', 'new/and/deep/a.h5')
    room.good('portrait', *SLOPE, '--figure', 'another/one/a.svg', '-q')
    room.good('export', *SLOPE, '-o', 'x/slope.ode', '--as', 'xppaut')
    room.good('check', '--record', *SLOPE, '-o', 'y/a.csv')
    for made in ('new/and/deep/a.h5', 'another/one/a.svg', 'x/slope.ode',
                 'y/a.csv'):
        expect(os.path.getsize(room.path(made)) > 100, made)
    room.write('file', 'precious')
    refused(room.run('knees', *SLOPE, '-o', 'file/a.h5'), 4, 'file/a.h5')
    refused(room.run('knees', '--law', 'spinodal_gen', '--alpha', '9', '-o',
                     'never/a.h5'), 2, 'alpha')
    refused(room.run('knees', *SLOPE, '-o', '/proc/never/a.h5'), 4, '/proc')
    expect('never' not in room.names() and room.read('file') == 'precious',
           room.names())


def hdf5_is_not_named_as_a_table(room):
    """Whoever asks a sweep for a.csv means its table."""
    sweep = ['sweep', *SLOPE, '--set', 'sweep={key: material.a, values: [0.02]}']
    for command in (sweep, ['knees', *SLOPE], ['simulate', *SLOPE, '--v', '1',
                                               '--psi', '1']):
        refused(room.run(*command, '-o', 'a.csv'), 2, 'a.csv', 'FILE.h5',
                '--output -')
    expect(room.names() == [], room.names())
    expect(room.good(*sweep, '-o', '-').startswith('a,'), 'CSV')


def data_are_beside_their_scene(room):
    room.make('far')
    room.write('far/d.csv', 'tan_alpha,l_k\n0.1,1e-4\n0.2,3e-4\n0.25,5e-4\n'
               '0.3,9e-4\n0.32,12e-4\n')
    room.write('far/a.yaml', 'law: {preset: dieterich_gen}\n'
               'slope: {alpha: 0.3}\nrabinowicz: {data: d.csv}\n')
    found = room.json('rabinowicz', 'far/a.yaml')
    expect(found['fit']['points'] == 5, found)
    expect(room.json('rabinowicz', *SLOPE, '--data', 'far/d.csv')['fit']
           ['points'] == 5, 'an option is from here')
    refused(room.run('rabinowicz', 'far/a.yaml', '--data', 'd.csv'), 4, 'd.csv')


def standard_input_is_a_file_called_dash(room):
    scene = 'law: {preset: dieterich_gen}\nslope: {alpha: 0.34}\n'
    room.write('a.yaml', scene)

    def fed(text, *args):
        done = subprocess.run([room.slipway, *args], cwd=room.folder,
                              input=text, text=True, capture_output=True,
                              timeout=300, check=False)
        expect(done.stderr == '', done)
        return done.stdout
    expect(fed(scene, 'knees', '-') == room.good('knees', 'a.yaml'), 'knees')
    push = ['--v', '1000', '--psi', '10']
    expect(fed(scene, 'simulate', '-', *push) ==
           room.good('simulate', 'a.yaml', *push), 'read twice')
    room.write('s.csv', 'v,psi\n1000,10\n1,1\n')
    expect(fed(room.read('s.csv'), 'push', 'a.yaml', '--states', '-') ==
           room.good('push', 'a.yaml', '--states', 's.csv'), 'states')
    done = room.shell("echo 'law: {preset: nolaw}' | slipway knees -")
    refused(done, 2, '-:1:', 'nolaw')


def standard_output_is_a_file_called_dash(room):
    """Where a file is text; HDF5 is not, and no file is called so."""
    room.bring('scenes')
    room.write('s.csv', 'v,psi\n1000,10\n1,1\n')
    ode = 'scenes/brusselator.ode'
    sweep = ['sweep', *SLOPE, '--set',
             'sweep={key: slope.alpha, from: 0.3, to: 0.36, points: 5}']
    for file, args in (('a.csv', ['push', *SLOPE, '--states', 's.csv']),
                       ('b.csv', ['check', '--record', *SLOPE]),
                       ('a.yaml', ['import', ode]),
                       ('dieterich_gen.ode',
                        ['export', *SLOPE, '--as', 'xppaut'])):
        room.good(*args, '-o', file)
        expect(room.good(*args, '-o', '-') == room.read(file), args)
    table = room.good(*sweep, '-o', '-')
    expect(table.count('\n') == 6 and '\n0.33,' in table, table)
    for args in (['knees', *SLOPE], ['portrait', *SLOPE], ['basin', *SLOPE],
                 ['simulate', *SLOPE, '--v', '1', '--psi', '1'],
                 ['stress', '--quick'], ['workprec', '--quick'],
                 ['export', *SLOPE, '--as', 'auto']):
        refused(room.run(*args, '-o', '-'), 2, '-', 'expected')
    refused(room.run('import', ode, '-o', '-', '--json'), 2, '--json')
    expect('-' not in room.names(), room.names())


run_cases([
    an_output_makes_its_folders,
    hdf5_is_not_named_as_a_table,
    data_are_beside_their_scene,
    standard_input_is_a_file_called_dash,
    standard_output_is_a_file_called_dash,
])
