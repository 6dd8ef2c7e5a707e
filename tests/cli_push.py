#!/usr/bin/env python3
"""slipway push as users call it (TAP).

usage: test_push.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import math

from cli_room import SLOPE, expect, refused, run_cases

STATE = ['--v', '1e3', '--psi', '10']
KEYS = ['fate', 'slip', 'time', 'mu_mean', 'v_kick', 'psi_kick']


def is_quantity(found):
    if found['value'] is None:
        return set(found) == {'value', 'reason'} and found['reason']
    return set(found) == {'value', 'error'} and found['error'] >= 0


def one_state_is_answered_as_the_page_says(room):
    found = room.json('push', *SLOPE, *STATE)
    expect(list(found) == KEYS, found)
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
    expect(said.startswith('v = 1000, psi = 10: rest_finite\n'), said)
    for key in KEYS[1:]:
        expect(f'{found[key]["value"]:.15g}' in said, key, said)
    expect(room.good('push', *SLOPE, *STATE, '--quiet') == '', 'quiet')


def states_of_a_file_keep_their_order(room):
    states = [(1e3, 10), (1e4, 10), (3.5, 0.2), (1e-3, 100)] * 20
    room.write('s.csv', '# some states\npsi,id,v\n' + ''.join(
        f'{psi!r},{number},{v!r}\n' for number, (v, psi) in enumerate(states)))
    found = room.json('push', *SLOPE, '--states', 's.csv')
    expect(list(found) == ['states'] and len(found['states']) == 80, found)
    single = [room.json('push', *SLOPE, '--v', repr(v), '--psi', repr(psi))
              for v, psi in states[:4]]
    expect(found['states'] == single * 20, found['states'][:4], single)
    one = room.json('push', *SLOPE, '--states', 's.csv', '--threads', '1')
    expect(found == one, 'threads change the answers')


def a_file_of_one_state_is_still_a_list(room):
    room.write('s.csv', 'v,psi\n1e3,10\n')
    found = room.json('push', *SLOPE, '--states', 's.csv')
    expect(list(found) == ['states'] and len(found['states']) == 1, found)


def a_scene_gives_the_slope(room):
    room.write('a.yaml', 'law: {preset: dieterich_gen}\nslope: {alpha: 0.34}\n'
               'products: [knees]\noutput: {hdf5: a.h5}\n')
    expect(room.json('push', 'a.yaml', *STATE)
           == room.json('push', *SLOPE, *STATE), 'scene and options differ')
    expect(room.names() == ['a.yaml'], room.names())


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
    refused(push(*STATE, '-o', 'a.h5'), 2, '--output')
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


run_cases([
    one_state_is_answered_as_the_page_says,
    a_kick_as_named_changes_the_fate,
    people_read_the_same_numbers,
    states_of_a_file_keep_their_order,
    a_file_of_one_state_is_still_a_list,
    a_scene_gives_the_slope,
    psi_may_be_negative_where_it_is_a_logarithm,
    what_does_not_exist_has_a_reason,
    wrong_words_cost_one_line,
    wrong_tables_are_blamed_where_they_are_wrong,
    output_that_does_not_arrive_exits_4,
])
