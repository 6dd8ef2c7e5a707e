#!/usr/bin/env python3
"""slipway workprec as users call it (TAP); never a time.

usage: cli_workprec.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import json
import math
import re
import subprocess

from cli_room import READER, expect, refused, run_cases

QUANTITIES = ['v_plus', 'v_minus', 'x_excess', 'curve', 'transient',
              'basin_rows', 'slip']
RUN = {'quantity', 'method', 'foreign', 'rtol', 'true_error', 'reported_error',
       'seconds', 'field_evaluations', 'steps', 'status'}
RANK = {'quantity', 'accuracy', 'method', 'seconds', 'own', 'own_seconds',
        'foreign', 'foreign_seconds', 'ratio_to_best_foreign'}
BARS = ('slipway', 'slow_curve')
READ = '''
import h5py, json
with h5py.File('a.h5') as f:
    g = f['workprec']
    for group in (g, g['fastest']):
        for name, data in group.items():
            if isinstance(data, h5py.Dataset) and name != 'n':
                assert data.dims[0][0].name == group['n'].name, name
    print(json.dumps({
        'runs': len(g['n']), 'ranks': len(g['fastest/n']),
        'methods': sorted({m.decode() for m in g['method'][...]}),
        'errors': g['true_error'][...].tolist(),
        'compiler': g['environment/compiler'][()].decode(),
        'units': g['seconds'].attrs['units'].decode()
                 if isinstance(g['seconds'].attrs['units'], bytes)
                 else g['seconds'].attrs['units']}))
'''


def check_run(run):
    expect(set(run) == RUN, run)
    expect(run['status'] in ('done', 'failed', 'silent_failure'), run)
    expect(run['seconds'] > 0, run)
    expect(run['field_evaluations'] > 0 or run['method'] == 'slow_curve', run)
    if run['foreign'] == 'foreign':
        expect(run['reported_error'] is None, run)
        return
    expect(run['status'] != 'silent_failure', run)
    if run['method'] in BARS:
        expect(run['true_error'] <= run['reported_error'], run)


def everything_is_raced_and_ours_does_not_lie(room):
    found = room.json('workprec', '--quick', '-o', 'a.h5', '--figure', 'a.svg')
    expect(list(found) == ['runs', 'fastest', 'missing', 'environment',
                           'units'],
           list(found))
    for run in found['runs']:
        check_run(run)
    expect([q for i, q in enumerate(r['quantity'] for r in found['runs'])
            if i == 0 or found['runs'][i - 1]['quantity'] != q] == QUANTITIES,
           'order')
    methods = {run['method'] for run in found['runs']}
    expect(methods >= {'slipway', 'radau', 'explicit8', 'gsl_rk8pd', 'gsl_rkf45',
                       'gsl_msbdf', 'gsl_bsimp', 'gsl_rk4imp'}, methods)
    expect(found['missing'] == {}, found['missing'])
    expect(len(found['fastest']) == 4 * len(QUANTITIES), 'ranks')
    for rank in found['fastest']:
        expect(set(rank) == RANK, rank)
        if rank['own'] and rank['foreign']:
            ratio = rank['foreign_seconds'] / rank['own_seconds']
            expect(abs(rank['ratio_to_best_foreign'] / ratio - 1) < 1e-12, rank)
    for key in ('cpu', 'system', 'compiler', 'flags', 'gsl', 'sundials'):
        expect(found['environment'][key], key)
    expect(room.names() == sorted(['a.h5'] + [f'a_{q}.svg' for q in QUANTITIES]),
           room.names())
    for quantity in QUANTITIES:
        shown = ' '.join(re.findall(r'>([^<]+)<', room.read(f'a_{quantity}.svg')))
        expect('GSL, ' in shown and not re.search(
            'v_plus|v_minus|x_excess|slow_curve|gsl_|explicit8', shown), shown)
    check_file(room, found)


def check_file(room, found):
    done = subprocess.run([READER, '-c', READ], cwd=room.path('.'), text=True,
                          capture_output=True, timeout=300, check=False)
    expect(done.returncode == 0, done.stderr)
    stored = json.loads(done.stdout)
    expect(stored['runs'] == len(found['runs']), stored['runs'])
    expect(stored['ranks'] == len(found['fastest']), stored['ranks'])
    expect(stored['methods'] == sorted({r['method'] for r in found['runs']}),
           stored['methods'])
    expect(stored['units'] == 's', stored['units'])
    expect(stored['compiler'] == found['environment']['compiler'], 'compiler')
    for a, run in zip(stored['errors'], found['runs']):
        b = run['true_error']
        expect(math.isnan(a) if b is None else float(b) == a, run, a)


def people_read_who_is_fastest_and_what_failed(room):
    said = room.good('workprec', '--quick', '--law', 'dieterich_gen',
                     '--alpha', '0.34')
    for words in ('dieterich_gen at alpha = 0.34', 'ratio_to_best_foreign',
                  'v_plus', 'runs that failed:', 'runs that failed silently:',
                  'missing_slip     no state tried arrives at a node',
                  'where times were measured', 'compiler'):
        expect(words in said, words, said)
    expect(room.names() == [], room.names())


def no_saddle_is_an_answer(room):
    found = room.json('workprec', '--quick', '--alpha', '0.5')
    expect(found['runs'] == [] and found['fastest'] == [], found)
    expect(set(found['missing']) == set(QUANTITIES), found['missing'])


def of_a_system_both_stable_branches_of_a_saddle_are_raced(room):
    window = ['--window', 'x=-2:2,y=-2:2']
    found = room.json('workprec', '--quick', '--ode', "x' = y; y' = x - x^3 - 0.4*y",
                      *window, '-o', 'p.h5')
    for run in found['runs']:
        check_run(run)
    own = [run for run in found['runs'] if run['method'] == 'slipway']
    expect(len(own) == 4 and {run['quantity'] for run in found['runs']} == {'curve'}, own)
    expect(own[-1]['true_error'] <= 1e-11 and len(found['fastest']) == 4, own[-1])
    expect(any(run['foreign'] == 'foreign' and run['status'] == 'done'
               and run['true_error'] < 1e-8 for run in found['runs']), found['runs'])
    expect(set(found['missing']) == set(QUANTITIES) - {'curve'}, found['missing'])
    found = room.json('workprec', '--quick', '--ode', "x' = -x; y' = -y", *window)
    expect(found['runs'] == [] and 'saddle' in found['missing']['curve'], found)


def what_cannot_be_done_is_refused(room):
    refused(room.run('workprec', '--quick', '--law', 'none'), 2, 'none')
    refused(room.run('workprec', '--quick', '-o', '/dev/null/a.h5'), 4,
            '/dev/null')
    refused(room.run('workprec', '--quick', '--figure', '/dev/null/a.svg'), 4,
            '/dev/null')
    refused(room.run('workprec', 'a.yaml', 'b.yaml'), 2, 'b.yaml')


if __name__ == '__main__':
    run_cases([
        everything_is_raced_and_ours_does_not_lie,
        people_read_who_is_fastest_and_what_failed,
        no_saddle_is_an_answer,
        of_a_system_both_stable_branches_of_a_saddle_are_raced,
        what_cannot_be_done_is_refused,
    ])
