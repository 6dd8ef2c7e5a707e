#!/usr/bin/env python3
"""slipway --proved --certificate FILE: written whole or not at all, verified by
check_certificate.py, and rejected by it with any digit changed that matters,
TAMPERED times (TAP).

usage: cli_certificate.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import json
import os
import random
import sys

from cli_room import READER, expect, refused, run_cases

if os.path.realpath(sys.executable) != os.path.realpath(READER):
    os.execv(READER, [READER, *sys.argv])  # Debian's, with mpmath

from check_certificate import rejected  # noqa: E402

SEED = int(os.environ.get('CHECK_SEED', 1))
TAMPERED = int(os.environ.get('TAMPERED', 40))
ENDS = {'dieterich_gen': ('psi_inf', 'psi_0'), 'ruina': ('open', 'v_0'),
        'perrin': ('psi_inf', 'v_0'), 'spinodal': ('open', 'v_0')}


def made(room, name, *args):
    """The one of that name, which is made once."""
    if name not in room.names():
        room.good(*args, '--proved', '--certificate', name)
    return json.loads(room.read(name))


def certificate(room, law, form='asinh'):
    return made(room, f'{law}-{form}.json', 'knees', '--law', law, '--friction', form,
                '--alpha', '0.34')


def each_claim_of_a_certificate_follows(room):
    for i, law in enumerate(ENDS):
        found = certificate(room, law, ('asinh', 'log')[i % 2])
        ends = found['upper']['end'], found['lower']['end']
        expect(len(found['numbers']) == 14, law, found['numbers'])
        expect(not rejected(found), law, rejected(found))
        expect(ends == ENDS[law], law, ends)
        for side, count in (('upper', 1), ('lower', law == 'dieterich_gen')):
            knees = found[side]['knees']
            expect(knees['all'] and len(knees['at']) == count, law, knees)


def its_numbers_are_those_of_the_answer(room):
    found = certificate(room, 'perrin')['numbers']
    told = room.json('knees', '--law', 'perrin', '--alpha', '0.34', '--proved')
    for name in ('v_plus', 'psi_at_v0', 'x_excess', 'x_deficit', 'mu_s_num'):
        proved = told[name]['proved']
        expect(float(proved['lo']) <= found[name][0] <= found[name][1]
               <= float(proved['hi']), name, proved, found[name])
    expect(found['v_minus'] == 'absent', found['v_minus'])


def laws_of_the_literature_have_one(room):
    """Nagata's names the slope in a formula; of the N-shaped one psi grows for ever,
    v, too, and the proof ends where dy/dx stays above 1."""
    for name, ends in (('nagata', (None, None)), ('n_shaped', ('open', 'v_0'))):
        found = made(room, f'{name}.json', 'knees', f'{room.source}/scenes/{name}.yaml')
        sides = found['upper'], found['lower']
        expect(tuple(side.get('end') for side in sides) == ends, name, ends)
        expect(not rejected(found), name, rejected(found))
    expect([(len(side['knees']['at']), side['knees']['all']) for side in sides]
           == [(1, True), (0, True)], sides[0]['knees'])


def where_psi_is_large_the_checker_takes_more_bits(room):
    found = made(room, 'large.json', 'knees', '--law', 'dieterich_gen', '--alpha', '0.9')
    expect(found['numbers']['psi'][0] > 1e10, found['numbers']['psi'])
    found.update(dict.fromkeys(('upper', 'lower'), {'not_proved': ''}))
    for name in list(found['numbers'])[4:]:
        del found['numbers'][name]
    expect(not rejected(found), rejected(found))


# ---- forgeries --------------------------------------------------------------

def with_a_digit_changed(number, rng):
    """A number and the place of the digit; a text stays one."""
    text = number if isinstance(number, str) else repr(float(number))
    at = rng.choice([i for i, c in enumerate(text) if c.isdigit()])
    text = text[:at] + rng.choice('0123456789') + text[at + 1:]
    return text if isinstance(number, str) else float(text)


def changed(leaf, rng, matters):
    for _ in range(200):
        new = with_a_digit_changed(leaf, rng)
        if float(new) != float(leaf) and matters(float(new), float(leaf)):
            return new
    return None


def forge_bound(holder, key, rng):
    holder[key] = changed(holder[key], rng, lambda new, old: 0 <= new < old / 300)
    return holder[key] is not None


def forge_interval(interval, rng):
    """One end beyond the other, or both moved."""
    lo, hi = interval
    if rng.random() < 0.3:
        k = rng.randrange(2)
        interval[k] = changed(interval[k], rng, lambda new, _:
                              new < lo if k else new > hi)
        return interval[k] is not None
    new = changed(lo, rng, lambda new, old: abs(new - old) > 2 * (hi - lo))
    if new is None:
        return False
    interval[:] = [new, hi + (new - lo)]
    return True


def forge_polynomial(piece, rng):
    """Further than its tube is wide where that ends."""
    widest = max(c[1] for c in piece['cells'])
    k = rng.randrange(len(piece['coef']))
    most = min(piece['cells'][-1][0], 1) ** k
    new = changed(piece['coef'][k], rng,
                  lambda new, old: abs(new - old) * most > 1000 * widest)
    piece['coef'][k] = new
    return new is not None


def forge_place(piece, rng):
    """The first digits of where it is."""
    key = rng.choice(['start', 'step'])
    new = changed(piece[key], rng, lambda new, old: abs(new - old) > abs(old) / 100)
    piece[key] = new
    return new is not None


def forge_end(piece, rng):
    """Cells out of order, or not to the end."""
    cells = piece['cells']
    k = rng.randrange(len(cells))
    before = cells[k - 1][0] if k else 0
    after = cells[k + 1][0] if k + 1 < len(cells) else cells[k][0]
    new = changed(cells[k][0], rng, lambda new, _: new <= before or (
        new >= after if k + 1 < len(cells) else new < after * 0.999))
    cells[k][0] = new
    return new is not None


def forge_knees(knees, rng):
    """One more, or one less and still all."""
    at = knees['at']
    if at and rng.random() < 0.5:
        at.pop(rng.randrange(len(at)))
    else:
        at.append(at[0] if at else {'v': [0.5, 2], 'psi': [0.5, 2]})
    return True


WORDS = {'friction': ['asinh', 'log'], 'state': ['real', 'positive']}


def forge_word(certificate, rng):
    """Another form, or a part of a formula."""
    law = certificate['law']
    key = rng.choice(list(WORDS) + 2 * list(law['formulas']))
    if key in WORDS:
        law[key] = WORDS[key][law[key] == WORDS[key][0]]
        return 'mu' not in law['formulas'] or key != 'friction'
    text = law['formulas'][key]
    at = rng.choice([i for i, c in enumerate(text) if c in '+-*/'] or [0])
    new = rng.choice([c for c in '+-*/' if c != text[at]])
    law['formulas'][key] = (text[:at] + new + text[at + 1:] if text[at] in '+-*/' else
                            f'({text})*1.001')
    return True


def tube_kinds(branch, piece, rng):
    cell = rng.choice(piece['cells'])
    return {
        'polynomial': lambda: forge_polynomial(piece, rng),
        'place of a piece': lambda: forge_place(piece, rng),
        'radius': lambda: forge_bound(cell, 1, rng),
        'error': lambda: forge_bound(cell, 2, rng),
        'cone': lambda: forge_bound(branch['cone'], 'slope', rng),
    }


def forge(certificate, rng):
    """What was changed, or None where nothing of the kind was found to be."""
    side = rng.choice(['upper', 'lower'])
    branch = certificate[side]
    if branch['end'] == 'open':
        side, branch = 'lower', certificate['lower']
    piece = rng.choice(branch['pieces'])
    knees = [u for side in ('upper', 'lower') for k in certificate[side]['knees']['at']
             for u in k.values()]
    numbers = [n for n in certificate['numbers'].values() if n != 'absent']
    group = certificate[rng.choice(['material', 'material', 'slope'])]
    name = rng.choice(list(group))
    kinds = {
        'parameter': lambda: set_text(group, name, rng),
        'number': lambda: forge_interval(rng.choice(numbers), rng),
        **tube_kinds(branch, piece, rng),
        'end of a cell': lambda: forge_end(piece, rng),
        'integral': lambda: forge_interval(rng.choice(piece['cells'])[3], rng),
        'integral in the cone': lambda: forge_interval(branch['cone']['excess'], rng),
        'place of the end': lambda: forge_interval(branch['place'], rng),
        'whole integral': lambda: forge_interval(branch['excess'], rng),
        'law': lambda: forge_word(certificate, rng),
        'knee': lambda: forge_interval(rng.choice(knees), rng),
        'number of knees': lambda: forge_knees(branch['knees'], rng),
    }
    kind = rng.choice(list(kinds))
    return kind if kinds[kind]() else None


def set_text(group, name, rng):
    new = changed(group[name], rng, lambda new, _: new > 0)
    group[name] = new
    return new is not None


def a_certificate_with_a_digit_changed_is_rejected(room):
    rng = random.Random(SEED)
    print(f'# seed {SEED}')
    texts = [json.dumps(certificate(room, law, ('asinh', 'log')[i % 2]))
             for i, law in enumerate(ENDS)] + [json.dumps(typed(room))]
    count = {}
    while sum(count.values()) < TAMPERED:
        text = rng.choice(texts)
        forged = json.loads(text)
        kind = forge(forged, rng)
        if kind is None:
            continue
        count[kind] = count.get(kind, 0) + 1
        if rejected(forged):
            continue
        old = json.loads(text)
        expect(False, kind, old['law'], difference(old, forged))
    print(f'# rejected: {count}')


def difference(old, new, path=''):
    if isinstance(old, dict):
        return [d for k in old for d in difference(old[k], new[k], f'{path}/{k}')]
    if isinstance(old, list):
        return [d for k, (u, w) in enumerate(zip(old, new))
                for d in difference(u, w, f'{path}/{k}')]
    return [] if old == new else [(path, old, new)]


# ---- the file ---------------------------------------------------------------

def a_certificate_needs_a_proof(room):
    slope = ['--law', 'perrin', '--alpha', '0.34']
    refused(room.run('knees', *slope, '--certificate', 'none.json'), 2,
            '--certificate none.json', 'expected a slope or a system, and --proved')
    refused(room.run('portrait', '--ode', "x' = y; y' = -x", '--window',
                     'x=-1:1,y=-1:1', '--certificate', 'none.json'), 2,
            'expected a slope or a system, and --proved')
    room.write('file', '')
    refused(room.run('knees', *slope, '--proved', '--certificate', 'file/x'), 4,
            'file')
    expect('none.json' not in room.names(), room.names())


def a_scene_is_not_written_over_by_one(room):
    text = 'law: {preset: perrin}\nslope: {alpha: 0.34}\naccuracy: {proved: true}\n'
    room.write('p.yaml', text)
    refused(room.run('study', 'p.yaml', '--certificate', 'p.yaml'), 2, 'is read')
    expect(room.read('p.yaml') == text)
    room.good('portrait', 'p.yaml', '--certificate', 'p.json')
    expect(json.loads(room.read('p.json')) == certificate(room, 'perrin'))


def typed(room):
    """A law with a parameter of its own, its rate typed whole."""
    room.write('typed.yaml', 'law: {theta: ln(psi), rate: "-sinh(psi*v/v_0 - 1)"}\n'
               'material: {v_0: 2}\nslope: {alpha: 0.34}\n')
    return made(room, 'typed.json', 'knees', 'typed.yaml')


def a_law_of_formulas_has_one(room):
    found = typed(room)
    expect(found['law']['formulas'] == {'theta': 'ln(psi)',
                                        'rate': '-sinh(psi*v/v_0 - 1)'}, found['law'])
    expect(found['material']['v_0'] == '2' and 'v_plus' in found['numbers'], found)
    expect(not rejected(found), rejected(found))
    found['law']['formulas']['theta'] = 'ln(theta)'
    expect(rejected(found), 'a formula of itself')


def whole_powers_of_either_sign_have_one(room):
    for n, exponent in ((2, '2'), (3, 'n')):
        room.write('power.yaml', f'law: {{mu: mu_star + a*ln(v) + k*ln(v)^{exponent} + b*ln(psi), '
                   'psi_ss: 1/v, rate: 1 - v*psi}\nslope: {tan_alpha: 0.4}\n'
                   f'material: {{mu_star: 0.35, a: 0.01, b: 0.02, k: 1e-5, n: {n}}}\n')
        found = made(room, f'power{n}.json', 'knees', 'power.yaml')
        expect(not rejected(found) and ('psi_at_v0' in found['numbers']) == (n == 3), found)
        found['law']['formulas']['mu'] = found['law']['formulas']['mu'].replace('^', '^-')
        expect(rejected(found), 'another exponent')


def alone(room, law, *where):
    """Of a slope without a saddle."""
    return made(room, f'{law}-{"-".join(where)}.json'.replace('=', '-'), 'knees', '--law',
                law, *where)


ALONE = [('spinodal_gen', '--alpha', '0.6'), ('spinodal', '--alpha', '0.1'),
         ('dieterich_gen', '--alpha', '0.35', '--set', 'material.b=0.03')]


def a_slope_without_a_saddle_has_one(room):
    for where, tau in zip(ALONE, ('below', 'above', 'rises')):
        found = alone(room, *where)
        expect(found['no_saddle']['tau'] == tau, found)
        expect(found['no_saddle']['fate'] == 'node' and not rejected(found),
               rejected(found), found)


def what_cannot_be_shown_claims_nothing(room):
    found = made(room, 'why.json', 'knees', '--law', 'perrin', '--alpha', '0.34', '--set',
                 'material.b=0.03')
    expect(found['not_proved'] and 'nothing is claimed' in rejected(found), found)


def forge_alone(certificate, rng):
    """A digit of an input, another word, or an end of the window."""
    claimed, names = certificate['no_saddle'], certificate['law']['formulas']
    kind = rng.choice(['window', 'tau', 'fate', 'law', 'slope'])
    if kind == 'window' and 'window' in claimed:
        k = rng.randrange(2)
        old = list(claimed['window'])
        claimed['window'][k] = changed(old[k], rng, lambda new, _:
                                       new > old[1] if k == 0 else new < old[0])
        return kind
    if kind in ('tau', 'fate'):
        words = {'tau': ['below', 'above', 'rises'], 'fate': ['node', 'v_0', 'v_infinity']}
        old = claimed[kind]
        claimed[kind] = rng.choice([w for w in words[kind] if w != old])
        return kind
    if kind == 'law':
        key = rng.choice(list(names))
        names[key] = f'({names[key]})*1.001'
        return kind
    name = next(iter(certificate['slope']))
    inside = '0.34' if 'window' in claimed else None
    certificate['slope'][name] = inside
    return inside and kind


def a_saddle_that_is_there_is_not_denied(room):
    rng = random.Random(SEED)
    texts, count = [json.dumps(alone(room, *where)) for where in ALONE], {}
    while sum(count.values()) < max(TAMPERED // 8, 20):
        text = rng.choice(texts)
        forged = json.loads(text)
        kind = forge_alone(forged, rng)
        if kind:
            count[kind] = count.get(kind, 0) + 1
            expect(rejected(forged), kind, difference(json.loads(text), forged))
    print(f'# rejected: {count}')


def labelled(room):
    return made(room, 'labels.json', 'basin', '--law', 'ruina', '--friction', 'log', '--alpha',
                '0.34', '--set', 'basins.cells=[40,40]', '-o', 'labels.h5')


def forge_labels(claimed, rng):
    """A row's border moved by a cell, or what becomes of a side."""
    if rng.random() < 0.2:
        side = rng.choice(['slow', 'fast'])
        claimed[side] = rng.choice([w for w in ('node', 'v_0', 'v_infinity')
                                    if w != claimed[side]])
        return
    k = rng.randrange(len(claimed['rows']))
    step = rng.choice([-1, 1])
    claimed['rows'][k] = [column + step for column in claimed['rows'][k]]


def labels_have_one_and_no_cell_changes_its_side(room):
    found, rng = labelled(room), random.Random(SEED)
    rows = found['labels']['rows']
    expect(len(rows) == 40 and all(u == w for u, w in rows) and rows[0] != rows[-1], rows)
    expect((found['labels']['slow'], found['labels']['fast']) == ('v_0', 'v_infinity'))
    expect(not rejected(found), rejected(found))
    for _ in range(max(TAMPERED // 8, 20)):
        forged = json.loads(json.dumps(found))
        forge_labels(forged['labels'], rng)
        expect(rejected(forged), difference(found, forged))


# ---- systems ----------------------------------------------------------------

POSITIVE = ['--set', 'system.state={u: positive, v: positive}']
SYSTEMS = {  # equilibria, and how many branches cross the edge and are trapped
    'pendulum': (2, 4, 0, "x' = y; y' = -sin(x)", 'x=-4:1,y=-3:3'),
    'turns': (2, 2, 2, "x' = y; y' = -sin(x) - d*y; d = 0.6", 'x=-4:2.25,y=-3:3',
              '--set', 'system.state={x: angle, y: real}'),
    'nagumo': (1, 4, 0, "u' = v; v' = (1 - 2*a)/sqrt(2)*v - u*(1 - u)*(u - a); a = 0.25",
               'u=-0.2:0.2,v=-0.5:0.5'),
    'duffing': (3, 2, 2, "x' = y; y' = x - x^3 - 0.9*y", 'x=-2:2,y=-2:2'),
    'linear': (1, 4, 0, "x' = x; y' = -2*y", 'x=-1:1,y=-1:1'),
    'toggle': (3, 2, 2, "u' = a/hold - u; v' = a/(1 + u^n) - v; hold = 1 + v^n; a = 3; n = 2",
               'u=0.05:10,v=0.05:10', *POSITIVE),
}


def certificate_of(room, name, ode, window, *more):
    return made(room, f'{name}.json', 'study', '--ode', ode, '--window', window, *more)


def systems_have_certificates(room):
    for name, (rests, crosses, trapped, *of) in SYSTEMS.items():
        found = certificate_of(room, name, *of)
        ends = [b.get('end') for b in found['branches']]
        told = len(found['equilibria']), ends.count('crosses'), ends.count('trapped')
        expect(told == (rests, crosses, trapped), name, told)
        expect(not rejected(found), name, rejected(found))


def random_shears_have_certificates(room):
    """Of x' = x - x^3, y' = -0.7 y, by (x + q y, y + p x)."""
    rng = random.Random(SEED)
    for i in range(3):
        p, q = round(rng.uniform(-0.6, 0.6), 2), round(rng.uniform(-0.4, 0.4), 2)
        found = certificate_of(
            room, f'shear{i}', f"p = {p}; q = {q}; X = x - q*y; Y = y - p*X; dX = X - X^3;"
            " dY = -0.7*Y; dy = dY + p*dX; x' = dX + q*dy; y' = dy", 'x=-3:3,y=-2.5:2.5')
        expect(any('end' in b for b in found['branches']), p, q, found['branches'])
        expect(not rejected(found), p, q, rejected(found))


def move(interval):
    """By ten of its widths."""
    lo, hi = interval
    step = 10 * max(hi - lo, 1e-15 * abs(lo), 1e-300)
    interval[:] = [lo + step, hi + step]
    return True


def replace(holder, key, new):
    old, holder[key] = holder[key], new
    return new != old


def forge_system(certificate, rng):
    """As forge(); of the branches one is kept."""
    branch = rng.choice([b for b in certificate['branches'] if 'end' in b])
    certificate['branches'] = [branch]
    system, rests = certificate['system'], certificate['equilibria']
    rest = rng.choice(rests)
    numbers = rest['state'] + [u for pair in rest['eigenvalues'] for u in pair]
    rate = rng.choice(list(system['rates']))
    kinds = {
        **tube_kinds(branch, rng.choice(branch['pieces']), rng),
        'equilibrium': lambda: move(rng.choice(numbers)),
        'kind': lambda: replace(branch, 'kind', {'stable': 'unstable',
                                                 'unstable': 'stable'}[branch['kind']]),
        'formula': lambda: replace(system['rates'], rate, f"({system['rates'][rate]})*1.001"),
        'saddle': lambda: replace(branch, 'saddle', rng.randrange(len(rests))),
    }
    if branch['end'] == 'crosses':
        kinds['leaves'] = lambda: move(rng.choice(branch['leaves']))
        kinds['edge'] = lambda: set_text(branch, 'at', rng)
    else:
        form = branch['form']
        kinds['level'] = lambda: replace(branch, 'level', branch['level'] * 1e-9)
        kinds['form'] = lambda: replace(form, 1, 2 * (form[0] * form[2]) ** 0.5)
        kinds['to'] = lambda: replace(branch, 'to', branch['saddle'])
        kinds['turns'] = lambda: replace(branch, 'turns', [0.5, 0])
    kind = rng.choice(list(kinds))
    return kind if kinds[kind]() else None


def a_forged_certificate_of_a_system_is_rejected(room):
    rng, count = random.Random(SEED), {}
    texts = {name: json.dumps(certificate_of(room, name, *of))
             for name, (_, _, _, *of) in SYSTEMS.items() if name != 'linear'}
    while sum(count.values()) < max(TAMPERED // 2, 20):
        name = rng.choice(list(texts))
        forged = json.loads(texts[name])
        kind = forge_system(forged, rng)
        if kind:
            count[kind] = count.get(kind, 0) + 1
            expect(rejected(forged), name, kind, forged['branches'][0].get('end'))
    print(f'# rejected: {count}')


run_cases([
    each_claim_of_a_certificate_follows,
    its_numbers_are_those_of_the_answer,
    laws_of_the_literature_have_one,
    where_psi_is_large_the_checker_takes_more_bits,
    a_certificate_with_a_digit_changed_is_rejected,
    a_certificate_needs_a_proof,
    a_scene_is_not_written_over_by_one,
    a_law_of_formulas_has_one,
    whole_powers_of_either_sign_have_one,
    a_slope_without_a_saddle_has_one,
    what_cannot_be_shown_claims_nothing,
    a_saddle_that_is_there_is_not_denied,
    systems_have_certificates,
    random_shears_have_certificates,
    a_forged_certificate_of_a_system_is_rejected,
    labels_have_one_and_no_cell_changes_its_side,
])
