"""Theorems 7 to 10 and 17 of docs/proofs.md, of named laws: what is left of a
branch beyond its last cell.
"""
from mpmath import iv

from ball_series import constant
from certificate_tube import ONE, ZERO, Wrong, claim, expm1, line, value, UNIT


class Place:
    """Where a branch is, and on which side: |mu - tan(alpha)| and |psi - psi_ss|."""

    def __init__(self, block, piece, theta, error, side):
        at, dep = piece.at(theta), value(piece.coef, theta) + error * UNIT
        self.X, self.Y = (at, dep) if piece.ind == 0 else (dep, at)
        self.block, self.side = block, side
        x, y = block.at[0] + self.X, block.at[1] + self.Y
        v, psi, psi_ss, rate, mu = [u[0] for u in block.state(constant(x, 1), constant(y, 1))]
        self.force, self.lag = side * (mu - block.tan), side * (psi - psi_ss)
        self.psi = psi
        # with v and psi friction rises less where they are less
        self.slopes = [block.state(line(x, dx, 1), line(y, 1 - dx, 1))[4][1] for dx in (ONE, ZERO)]
        claim(self.force > 0 and self.lag > 0, 'the branch does not end outward')

    def steady(self, x):
        v, _, psi_ss, rate, _ = [u[0] for u in self.block.state(constant(x, 1), constant(ONE, 1))]
        return psi_ss, rate


def settled(way_for):
    """w with way_for(w).way < w: that way, the excess, the sign of dy/dx - 1."""
    w = ZERO
    for _ in range(60):
        way, excess, sign = way_for(w)
        if way < w:
            return way.b, excess.b, sign
        w = 2 * way.b + iv.mpf('1e-290')
        claim(w < 1, 'what is beyond the last piece is not bounded')
    raise Wrong('what is beyond the last piece is not bounded')


def tail_in_psi(p):
    """Theorem 8: how far x goes, and the excess."""
    block, get = p.block, p.block.get
    if p.side > 0:
        claim(not block.first_order, 'psi runs away at first order')
        A, B, q = get['a'], get['b'], ONE if block.is_log else p.psi.a - 1
        claim(q > 0, 'the rate of psi does not grow')
    else:
        claim(not (block.first_order and block.is_log), 'v settles not')
        A, B, q = p.slopes[0].b, p.slopes[1].b, ONE

    def way_for(w):
        x = block.at[0] + (p.X.a if p.side > 0 else p.X.a - w)
        g = block.kinetics(constant(p.lag.a, 1))[0] * p.steady(x.a)[1]
        under = q * (g if block.is_log else g / p.psi.b)
        m = p.force.b + A * w + B / q
        change = expm1(p.X.b + w) if p.side > 0 else expm1(p.X.a - w)
        way = block.force / iv.exp(x) * m / under
        return way, abs(block.v * change).b / under, int(way * q < 1)
    return settled(way_for)


def least_growth(block, psi, psi_ss, v):
    """q <= d ln(v g)/dx for all less v; None where that is not known."""
    form, time = block.law['psi_ss'], block.law['timescale']
    d = psi_ss - psi
    by_d = 1 / d if block.first_order else (1 + iv.exp(-2 * d)) / (1 - iv.exp(-2 * d))
    by_v = time == 'slip' or (time, form) in (('ageing44', 'inverse'), ('slip45', 'minus_log'))
    if form == 'minus_log':
        return 1 + by_v - by_d
    if form == 'inverse':
        return 1 + by_v - psi_ss * by_d if block.first_order else None
    at_v = block.get['R'] * v
    return 1 + by_v - at_v / (1 + at_v) * (psi_ss * by_d)


def tail_in_v(p):
    """Theorem 9: how far y goes, and the excess."""
    block = p.block

    def way_for(w):
        x, Y = (block.at[0] + p.X.b).b, p.Y.a - w
        psi = (block.psi + Y if block.is_log else block.psi * iv.exp(Y)).a
        v = iv.exp(x)
        psi_ss, rate = p.steady(x)
        time = v / (block.force * p.force.a)
        q = least_growth(block, psi, psi_ss, v)
        most, most_of_g = [], []
        if q is not None and q > 0:
            most_of_g.append(block.kinetics(constant(psi_ss - psi, 1))[0] * rate)
            most.append(most_of_g[0] / q)
        if 'spinodal' in block.law['psi_ss']:
            top = 1 + block.get['R'] if block.law['psi_ss'] == 'spinodal' else ONE
            most_of_g.append(block.kinetics(constant(top - psi, 1))[0] * rate)
            most.append(most_of_g[-1])
        claim(most, 'v dpsi/dt does not vanish with v')
        way = min(most, key=lambda u: u.b) * time
        steep = min(most_of_g, key=lambda u: u.b) * time
        if not block.is_log:
            way, steep = way / psi, steep / psi
        return way, block.v * time, -int(steep < 1)
    return settled(way_for)


def stays_steep(p):
    """Theorem 17, of an open branch: dy/dx > 1 at the place and beyond.  d ln|g|/dx
    is 1, R v/(1 + R v) or not negative, as psi_ss falls; d ln|g|/dy is not negative."""
    block, get = p.block, p.block.get
    theta = block.law['theta']
    x = iv.exp(block.at[0] + p.X)
    rise = {'slip': ONE, 'spinodal': 1 - 1 / (1 + get.get('R', ONE) * x.a)}
    f = block.flow(0, line(p.X, ZERO, 1), line(p.Y, ONE, 1))
    return (block.first_order and (theta == 'psi') == block.is_log
            and (f[1] / f[0])[0] > 1
            and 1 + rise.get(block.law['timescale'], ZERO)
            > (get['a'] + get['b']) / p.force.a)
