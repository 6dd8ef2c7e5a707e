#!/usr/bin/python3
"""Verifies again what `slipway knees --proved --certificate FILE` claims.

usage: check_certificate.py FILE...

docs/proofs.md has the theorems; here each of their conditions is evaluated with
mpmath's intervals of 160 bits, or as many as the saddle takes, from the inputs as
decimals, the law's formulas as texts, and the equations (17) of Putelat & Dawes (2015).
Read from the file are inputs, polynomials, where their cells end, and claims; each
claim has to follow.
Exit status 0: all hold; 1: one does not, and its name.
"""
import functools
import json
import sys

from mpmath import iv

from ball_series import set_bits
from certificate_end import Place, stays_open, stays_steep, tail_in_psi, tail_in_v
from certificate_field import Block
from certificate_knees import find_knees
from certificate_plane import check_system, verified_system
from certificate_sides import Branch, check_labels
from certificate_steady import check_alone
from certificate_tube import (ONE, Wrong, attempt, begin, between, claim, expm1,
                              holds, pieces_of, walk)

BITS = 160, 320, 640, 1280


# ---- a branch ---------------------------------------------------------------

def until(branch, piece):
    """theta, where its last piece ends."""
    u = branch['until']
    return ONE if u is None else (iv.mpf(u) - piece.start) / piece.step


def check_open(block, branch, pieces, side):
    """And its knees, as far as there are cells."""
    error, reach = begin(block, pieces, branch), iv.mpf(branch['cone']['reach'])
    stays_open(Place(block, pieces[0], reach, error, side))
    if not branch['pieces'][0]['cells']:
        return claim(branch['knees'] == {'at': [], 'all': False}, 'knees beyond cells')
    theta = until(branch, pieces[-1])
    errors, _ = walk(block, pieces, branch, theta)
    place = Place(block, pieces[-1], theta, errors[-1][1], side)
    return check_knees(block, branch, pieces, errors, int(stays_steep(place)))


def check_knees(block, branch, pieces, errors, beyond):
    claimed = branch['knees']
    found, no_more = find_knees(block, pieces, branch, errors, beyond)
    claim(len(claimed['at']) <= len(found), 'there is no such knee')
    claim(not claimed['all'] or no_more and len(found) == len(claimed['at']),
          'there may be more knees')
    for knee, (X, Y) in zip(claimed['at'], found):
        claim(holds(knee['v'], block.v * iv.exp(X)), 'v of a knee')
        claim(holds(knee['psi'], block.psi_at(Y)), 'psi of a knee')


def check_branch(block, branch, side):
    """Where it settles and the excess; None: it is open."""
    return check_text(block, json.dumps(branch), side)


@functools.lru_cache(None)
def check_text(block, text, side):
    """Once, however often that branch is claimed."""
    branch = json.loads(text)
    pieces = pieces_of(branch)
    last, end = pieces[-1], branch['end']
    if end == 'open':
        return check_open(block, branch, pieces, side)
    theta = until(branch, last)
    errors, total = walk(block, pieces, branch, theta)
    place = Place(block, last, theta, errors[-1][1], side)
    claim((end, last.ind, side) in (('psi_inf', 1, 1), ('psi_0', 1, -1),
                                    ('v_0', 0, -1)), end, 'is no such end')
    way, excess, sign = tail_in_v(place) if end == 'v_0' else tail_in_psi(place)
    settles = (place.Y if end == 'v_0' else place.X) + side * between(0, way)
    total = side * total + between(0, excess)
    claim(holds(branch['place'], settles), 'the place where the branch settles')
    claim(holds(branch['excess'], total), 'the integral along the branch')
    check_knees(block, branch, pieces, errors, sign)
    return settles, total


def sides_of(block, branch, side):
    settles = check_branch(block, branch, side)
    return Branch(pieces_of(branch), branch, settles and settles[0], side > 0)


# ---- the numbers ------------------------------------------------------------

ABSENT = 'absent'
UPPER = ['v_plus', 'ln_v_plus', 'x_excess', 'fracture_energy', 'mu_s_num',
         'mu_s_mean']


def upper_numbers(block, found):
    if found is None:
        return dict.fromkeys(UPPER, ABSENT)
    X, excess = found
    unit = block.v ** 2 / (2 * block.force)
    energy, mean = unit * expm1(2 * X), unit * expm1(X) ** 2
    return dict(zip(UPPER, [block.v * iv.exp(X), block.at[0] + X, excess, energy,
                            block.tan + energy / excess, block.tan + mean / excess]))


def lower_numbers(block, found, end):
    at, excess = found
    out = {'x_deficit': excess, 'v_minus': ABSENT, 'ln_v_minus': ABSENT,
           'psi_at_v0': ABSENT}
    if end == 'psi_0':
        out.update(v_minus=block.v * iv.exp(at), ln_v_minus=block.at[0] + at)
    else:
        out['psi_at_v0'] = block.psi_at(at)
    return out


@functools.lru_cache(None)
def make_block(law, material, slope, near, bits):
    """With so many bits, which are those of all that follows."""
    set_bits(bits)
    block = Block(json.loads(law), json.loads(material), json.loads(slope))
    if near:
        block.find_saddle(*near)
        block.lambda_ = block.eigenvalues()
    return block


def find_block(inputs, near):
    """With bits enough for eigenvalues of 70: where psi is large psi - psi_ss loses
    as many as psi has before the point."""
    for bits in BITS:
        found = attempt(make_block, *inputs, near, bits)
        if found and all((u.delta / u).b < 2 ** -70 for u in map(abs, found.lambda_)):
            set_bits(bits)
            return found
    raise Wrong('no saddle is found near the one that is claimed')


def check(certificate):
    """Raises Wrong, or another error of what cannot be computed."""
    claim(certificate['slipway_certificate'] == 3, 'not a certificate known here')
    claim('not_proved' not in certificate, 'nothing is claimed')
    set_bits(BITS[0])
    if 'system' in certificate:
        return check_system(certificate)
    inputs = [json.dumps(certificate[k]) for k in ('law', 'material', 'slope')]
    if 'no_saddle' in certificate:
        return check_alone(make_block(*inputs, None, BITS[0]), certificate['law'],
                           certificate['no_saddle'])
    claims = certificate['numbers']
    block = find_block(inputs, (claims['v'][0], claims['psi'][0]))
    minus, plus_ = block.lambda_
    found = {'v': block.v, 'psi': block.psi, 'lambda_minus': minus,
             'lambda_plus': plus_}
    for name in ('v', 'psi', 'lambda_minus', 'lambda_plus'):
        claim(holds(claims[name], found[name]), name)
    upper, lower = certificate['upper'], certificate['lower']
    if 'not_proved' not in upper:
        found.update(upper_numbers(block, check_branch(block, upper, 1)))
    if 'labels' in certificate:
        sides = [sides_of(block, certificate[name], side)
                 for name, side in (('upper', 1), ('lower', -1))]
        check_labels(block, certificate['law'], certificate['labels'], *sides)
    if 'not_proved' not in lower:
        found.update(lower_numbers(block, check_branch(block, lower, -1),
                                   lower['end']))
    for name, claimed in claims.items():
        claim(name in found, name, 'does not follow')
        claim(claimed == ABSENT if found[name] is ABSENT else
              claimed != ABSENT and holds(claimed, found[name]), name)


def rejected(certificate):
    """Why; '': every claim holds."""
    try:
        check(certificate)
    except (Wrong, LookupError, TypeError, ValueError, ArithmeticError,
            MemoryError, RecursionError, AttributeError) as wrong:
        return f'{wrong}' or 'something is missing'
    return ''


def verified(certificate):
    """What has been, in words."""
    if 'system' in certificate:
        return verified_system(certificate)
    law, slope = certificate['law'], certificate['slope']
    words = [f'{key} = {text}' for part in (law['formulas'], certificate['material'], slope)
             for key, text in part.items()]
    if 'no_saddle' in certificate:
        fate = certificate['no_saddle'].get('fate')
        return ', '.join(words + ['no saddle'] + [f'all states to {fate}'] * bool(fate))
    for side in ('upper', 'lower'):
        words.append(f"{side} branch: {certificate[side].get('end', 'not proved')}")
    if 'labels' in certificate:
        words.append(f"sides of {len(certificate['labels']['psi'])} rows of cells")
    return ', '.join(words + list(certificate['numbers']))


def main(paths):
    failed = False
    for path in paths:
        with open(path, encoding='utf-8') as file:
            certificate = json.load(file)
        why = rejected(certificate)
        print(f"{path}: {why or 'every claim holds: ' + verified(certificate)}")
        failed = failed or why
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
