#!/usr/bin/env python3
"""slipway push as users call it (TAP).

usage: test_push.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import csv
import math

from cli_room import READER, SLOPE, expect, expect_number, refused, run_cases

STATE = ['--v', '1e3', '--psi', '10']
KEYS = ['fate', 'slip', 'time', 'mu_mean', 'v_kick', 'psi_kick']


def is_quantity(found):
    if found['value'] is None:
        return set(found) == {'value', 'reason'} and found['reason']
    return set(found) == {'value', 'error'} and found['error'] >= 0


def one_state_is_answered_as_the_page_says(room):
    found = room.json('push', *SLOPE, *STATE)
    expect(list(found) == [*KEYS, 'units'], found)
    expect(found['fate'] == 'rest_finite', found)
    expect(all(is_quantity(found[key]) for key in KEYS[1:]), found)
    expect(abs(found['slip']['value'] - 0.2689053) < 1e-6, found)


def a_kick_as_named_changes_the_fate(room):
    found = room.json('push', *SLOPE, *STATE)
    for name, v, psi in (('v_kick', 1e3, 10), ('psi_kick', 1e3, 10)):
        factor = found[name]['value']
        for more, fate in ((1e-9, 'runaway'), (-1e-9, 'rest_finite')):
            kick = factor * math.exp(math.copysign(more, math.log(factor) *
                                                   more))
            state = (v * kick, psi) if name == 'v_kick' else (v, psi * kick)
            then = room.json('push', *SLOPE, '--v', repr(state[0]), '--psi',
                             repr(state[1]))
            expect(then['fate'] == fate, name, more, then)


def people_read_the_same_numbers(room):
    said = room.good('push', *SLOPE, *STATE)
    found = room.json('push', *SLOPE, *STATE)
    expect(said.startswith('v = 1000 V_star = 0.001 m/s, psi = 10: '
                           'rest_finite\n'), said)
    for key in KEYS[1:]:
        expect_number(said, key, found[key])
    expect(room.good('push', *SLOPE, *STATE, '--quiet') == '', 'quiet')


def push_and_simulate_say_one_thing(room):
    fates = set()
    for law in ('dieterich', 'dieterich_gen', 'ruina', 'spinodal_gen'):
        for v, psi in ((1e3, 10), (1e4, 1), (1e-3, 1)):
            state = ['--law', law, '--alpha', '0.34', '--v', repr(v), '--psi',
                     repr(psi)]
            push = room.json('push', *state)
            run = room.json('simulate', *state)['trajectories'][0]
            expect(push['fate'] == run['fate'], law, v, psi, push, run)
            fates.add(push['fate'])
            for key in ('slip', 'time', 'mu_mean'):
                a, b = push[key], run[key]
                expect(a.get('reason') == b.get('reason'), state, key, a, b)
                expect(a['value'] is None or abs(a['value'] - b['value'])
                       <= a['error'] + b['error'], state, key, a, b)
    expect(fates == {'creep', 'sliding', 'runaway', 'rest_finite',
                     'rest_asymptotic'}, fates)


def states_of_a_file_keep_their_order(room):
    states = [(1e3, 10), (1e4, 10), (3.5, 0.2), (1e-3, 100)] * 20
    room.write('s.csv', '# some states\npsi,id,v\n' + ''.join(
        f'{psi!r},{number},{v!r}\n' for number, (v, psi) in enumerate(states)))
    found = room.json('push', *SLOPE, '--states', 's.csv')
    expect(list(found) == ['states', 'units'] and len(found['states']) == 80, found)
    single = [room.json('push', *SLOPE, '--v', repr(v), '--psi', repr(psi))
              for v, psi in states[:4]]
    expect([{**state, 'units': found['units']['states']}
            for state in found['states']] == single * 20, found['states'][:4], single)
    one = room.json('push', *SLOPE, '--states', 's.csv', '--threads', '1')
    expect(found == one, 'threads change the answers')


def a_file_of_one_state_is_still_a_list(room):
    room.write('s.csv', 'v,psi\n1e3,10\n')
    found = room.json('push', *SLOPE, '--states', 's.csv')
    expect(list(found) == ['states', 'units'] and len(found['states']) == 1, found)


def a_scene_gives_the_slope(room):
    room.write('a.yaml', 'law: {preset: dieterich_gen}\nslope: {alpha: 0.34}\n'
               'products: [knees]\noutput: {hdf5: a.h5}\n')
    expect(room.json('push', 'a.yaml', *STATE)
           == room.json('push', *SLOPE, *STATE), 'scene and options differ')
    expect(room.names() == ['a.yaml'], room.names())


SI = '''law: {preset: %s}
slope: {alpha: 0.34}
material: {V_star: 4e-7, L: 3e-6}
units: si
'''
def the_range_of_a_logarithm_is_the_one_that_holds(room):
    law = ['--law', 'ruina', '--alpha', '0.34', '--v', '1']
    done = room.run('push', *law, '--psi', '5000')
    refused(done, 2, 'psi = 5000', 'psi from -1e+300 to ')
    top = done.stderr.split(' to ')[-1].strip()
    room.good('push', *law, '--psi', top)
    refused(room.run('push', *law, '--psi', str(float(top) + 2)), 2, top)


# phi of psi = 10: in L/V_star, or as it is where the law's phi has no unit.
UNIT_OF_PHI = {'dieterich_gen': 3e-6 / 4e-7, 'spinodal_gen': 1 / 101}


def in_si_a_bare_number_is_in_the_si_and_psi_is_refused(room):
    for law in UNIT_OF_PHI:
        room.write('a.yaml', SI % law)
        for command in ('push', 'simulate'):
            def say(*args):
                return room.run(command, 'a.yaml', *args)
            expect(say('--v', '8e-3', '--phi', '1').stdout ==
                   say('--v', '8e-3 m/s', '--phi', '1').stdout != '', law)
            refused(say('--v', '8e-3m/s', '--psi', '10'), 2, '--psi 10', 'phi')
            refused(say('--v', '8e-3m', '--phi', '1'), 2, '--v 8e-3m')
            refused(say('--v', '8e-3m/s', '--phi', '-1'), 2, '--phi -1', '> 0')
            refused(say('--v', '8e-3m/s', '--phi', '1', '--psi', '1'), 2,
                    'one of them')
            refused(say('--v', '8e-3m/s'), 2, '--phi')
    room.write('b.csv', 'v,phi\n1e-3,1\n')
    expect(room.json('push', 'a.yaml', '--states', 'b.csv')['states'][0]['fate']
           == room.json('push', 'a.yaml', '--v', '1e-3 m/s', '--phi',
                        '1')['fate'], 'b.csv')
    room.write('b.csv', 'v [m/s],psi\n1e-3,1\n')
    refused(room.run('push', 'a.yaml', '--states', 'b.csv'), 2, 'b.csv:2:6',
            'phi')


def physical_and_own_units_give_the_same_answer(room):
    """And the answer says in which units it was asked."""
    own = ['--set', 'units=dimensionless']
    for law, unit in UNIT_OF_PHI.items():
        room.write('a.yaml', SI % law)
        phi = repr(10 * unit)
        told = room.good('push', 'a.yaml', '--v', '4e-4m/s', '--phi', phi)
        first = told.splitlines()[0]
        expect(' m/s = 1000 V_star, phi = ' in first and first.startswith(
            'v = 0.0004 m/s') and ', psi = 10: ' in first, told)
        expect((' s, ' in first) == (law == 'dieterich_gen'), told)
        for command in ('push', 'simulate'):
            twin = room.json(command, 'a.yaml', *own, '--v', '1000', '--psi',
                             '10')
            for args in ([*own, '--v', '4e-4 m/s', '--phi', phi],
                         [*own, '--v', '1000V_star', '--phi', phi],
                         [*own, '--v', '4e-4m/s', '--psi', '10'],
                         [*own, '--v', '1000 V_star', '--phi', phi]):
                found = room.json(command, 'a.yaml', *args)
                found = found.get('trajectories', [found])[0]
                wanted = twin.get('trajectories', [twin])[0]
                expect(found['fate'] == wanted['fate'], args, found, wanted)
                for key in ('slip', 'time', 'mu_mean'):
                    was, now = wanted[key], found[key]
                    expect((was['value'] is None) == (now['value'] is None)
                           and (was['value'] is None or
                                abs(was['value'] - now['value']) <=
                                was['error'] + now['error'] +
                                1e-12 * abs(was['value'])), args, was, now)
        room.write('s.csv', f'phi,v [m/s]\n{phi},4e-4\n{phi},4e-3\n')
        room.write('t.csv', f'phi,v [V_star]\n{phi},1000\n{phi},10000\n')
        room.write('u.csv', f'phi,v\n{phi},4e-4 m/s\n{phi},1e4V_star\n')
        fates = [[state['fate'] for state in room.json(
            'push', 'a.yaml', '--states', name)['states']]
                 for name in ('s.csv', 't.csv', 'u.csv')]
        expect(fates[0] == fates[1] == fates[2], fates)


def states_and_answers_go_to_files(room):
    """With their names; what CSV holds is read again."""
    for law, state in (('dieterich_gen', 'phi [s]'), ('spinodal_gen', 'phi'),
                       ('perrin', 'phi [s]')):
        room.write('a.yaml', SI % law)
        room.write('s.csv', 'id,v [m/s],phi\nslow,1e-9,2\n"a, b",2e-3,70\n'
                   '7,0.5,0.09\n')
        found = room.json('push', 'a.yaml', '--states', 's.csv', '-o',
                          'new/a.csv')['states']
        with open(room.path('new/a.csv'), encoding='utf-8') as file:
            rows = list(csv.DictReader(file))
        expect([row['id'] for row in rows] == ['slow', 'a, b', '7'], rows)
        expect([float(row['v [m/s]']) for row in rows] == [1e-9, 2e-3, 0.5]
               and abs(float(rows[0][state]) - 2) < 1e-12, rows)
        for row, answer in zip(rows, found):
            expect(row['fate'] == answer['fate'], row, answer)
            for key, unit in (('slip', ' [m]'), ('time', ' [s]'),
                              ('mu_mean', ''), ('v_kick', '')):
                value = answer[key]['value']
                if value is None:
                    expect(row[key + unit] == '' and row[key + '_reason'] ==
                           answer[key]['reason'], row, answer)
                    continue
                expect(float(row[key + unit]) == value and
                       float(row[f'{key}_error{unit}']) ==
                       answer[key]['error'], row, answer)
        again = room.json('push', 'a.yaml', '--states', 'new/a.csv', '-o',
                          'b.h5', '-q')['states']
        expect([state['fate'] for state in again] ==
               [state['fate'] for state in found], again)
    done = room.shell(f"{READER} -c 'import h5py; f = h5py.File(\"b.h5\")[\"push\"]"
                      "; print([i.decode() for i in f[\"id\"][:]], "
                      "f[\"v\"].attrs[\"scale\"], f[\"v\"][0])'")
    expect(done.stdout.startswith("['slow', 'a, b', '7'] ") and 'V_star' in
           done.stdout, done)
    refused(room.run('info', 'b.h5', '--rerun'), 2, 'push --states')


def psi_may_be_negative_where_it_is_a_logarithm(room):
    found = room.json('push', '--law', 'perrin', '--alpha', '0.34', '--v',
                      '1e3', '--psi', '-2')
    expect(found['fate'] == 'runaway', found)
    refused(room.run('push', *SLOPE, '--v', '1', '--psi', '-2'), 2, '1e-300')


def what_does_not_exist_has_a_reason(room):
    found = room.json('push', '--law', 'spinodal_gen', '--alpha', '0.2',
                      *STATE)
    expect(found['fate'] == 'creep' and found['v_kick']['value'] is None
           and 'no saddle' in found['v_kick']['reason'], found)


def wrong_words_cost_one_line(room):
    def push(*args):
        return room.run('push', *SLOPE, *args)
    refused(push(), 2, '--v')
    refused(push('--v', '1'), 2, '--psi')
    refused(push('--psi', '1'), 2, '--v')
    refused(push('--v', 'fast', '--psi', '1'), 2, '--v', 'fast')
    refused(push('--v', '1', '--psi', '0x1'), 2, '--psi', '0x1')
    refused(push('--v', '0', '--psi', '1'), 2, '1e-300')
    refused(push('--v', '1', '--psi', 'inf'), 2, '1e300')
    refused(push(*STATE, '-o', 'a.txt'), 2, '--output', 'a.txt', '.csv')
    refused(push(*STATE, '-o', '/dev/null/a.csv'), 4, '/dev/null')
    refused(push(*STATE, '--figure', 'a.svg'), 2, '--figure')
    refused(push(*STATE, '--states', 's.csv'), 2, '--states')
    refused(push('a.yaml', 'b.yaml', *STATE), 2, 'b.yaml')
    refused(room.run('push', *STATE), 2, 'law')
    expect(room.names() == [], room.names())


TABLES = {
    'v\n1\n': ['s.csv:1:1', 'psi'],
    'v,psi\n1,2\n3,x\n': ['s.csv:3:3', "'x'"],
    'v,psi\n1,2\n3,\n': ['s.csv:3:', 'psi'],
    'v,psi\n1,2\n0,2\n': ['s.csv:3:1', '1e-300'],
    'v,psi\n': ['s.csv'],
    'id,v,v [m/s],psi\na,1,1,3\n': ['s.csv:1:6', "'v [m/s]' beside 'v'"],
    'v,psi,phi\n1,1,3\n': ['s.csv:1:7', "'phi' beside 'psi'"],
}


def wrong_tables_are_blamed_where_they_are_wrong(room):
    for text, words in TABLES.items():
        room.write('s.csv', text)
        refused(room.run('push', *SLOPE, '--states', 's.csv'), 2, *words)
    refused(room.run('push', *SLOPE, '--states', 'none.csv'), 4, 'none.csv')


def output_that_does_not_arrive_exits_4(room):
    for how in ('', '--json'):
        done = room.shell('slipway push --law dieterich_gen --alpha 0.34 '
                          f'--v 1e3 --psi 10 {how} >/dev/full')
        refused(done, 4, 'standard output')


def csv_goes_to_standard_output(room):
    room.write('states.csv', 'id,v,psi\na,1000,10\nb,0.01,10\n')
    args = ['push', '--law', 'spinodal_gen', '--alpha', '0.34', '--states',
            'states.csv', '-o']
    room.good(*args, 'a.csv')
    expect(room.good(*args, '-') == room.read('a.csv') and
           '-' not in room.names(), room.names())
    refused(room.run(*args, '-', '--json'), 2, '--output -', '--json')


def a_kick_starts_from_the_creep_state(room):
    law = ['--law', 'spinodal_gen', '--alpha', '0.34']
    creep = room.json('knees', *law)['equilibria'][0]
    state = ['--v', repr(creep['v']['value'] + 2500), '--psi',
             repr(creep['psi']['value'])]
    kicked = room.good('push', *law, '--from', 'creep', '--kick', '2500')
    expect(kicked == room.good('push', *law, *state), kicked)
    expect(kicked == room.good('push', *law, '--from', 'creep', '--kick',
                               '2.5e-3m/s'), kicked)
    for args, words in (
            ([*law, '--from', 'creep'], '--kick'),
            ([*law, '--kick', '1'], '--from creep'),
            ([*law, '--from', 'creep', '--kick', '1', '--v', '1'], '--from'),
            ([*law, '--from', 'creep', '--kick', 'x'], '--kick x'),
            (['--law', 'dieterich_gen', '--alpha', '0.34', '--from', 'creep',
              '--kick', '1'], 'there is no creep node')):
        refused(room.run('push', *args), 2, words)


run_cases([
    a_kick_starts_from_the_creep_state,
    csv_goes_to_standard_output,
    one_state_is_answered_as_the_page_says,
    a_kick_as_named_changes_the_fate,
    people_read_the_same_numbers,
    push_and_simulate_say_one_thing,
    states_of_a_file_keep_their_order,
    a_file_of_one_state_is_still_a_list,
    a_scene_gives_the_slope,
    in_si_a_bare_number_is_in_the_si_and_psi_is_refused,
    physical_and_own_units_give_the_same_answer,
    states_and_answers_go_to_files,
    psi_may_be_negative_where_it_is_a_logarithm,
    what_does_not_exist_has_a_reason,
    wrong_words_cost_one_line,
    wrong_tables_are_blamed_where_they_are_wrong,
    output_that_does_not_arrive_exits_4,
    the_range_of_a_logarithm_is_the_one_that_holds,
])
