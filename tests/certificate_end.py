"""Theorems 7 to 10 and 17 of docs/proofs.md: what is left of a branch beyond its
last cell, by the law's formulas over strips that have no end.
"""
from mpmath import iv

from ball_series import constant
from certificate_growth import Jet, is_finite
from certificate_tube import (ONE, UNIT, ZERO, Wrong, between, claim, expm1, line,
                              value)


class Place:
    """Where a branch is, on which side, and |mu - tan(alpha)|."""

    def __init__(self, block, piece, theta, error, side):
        at, dep = piece.at(theta), value(piece.coef, theta) + error * UNIT
        self.X, self.Y = (at, dep) if piece.ind == 0 else (dep, at)
        self.x, self.y = block.at[0] + self.X, block.at[1] + self.Y
        self.block, self.side = block, side
        mu, = block.at_state(constant(self.x, 1), constant(self.y, 1), 'mu')
        self.force = side * (mu[0] - block.tan)
        claim(self.force > 0, 'the branch does not end outward')

    def grow(self, x, y, by):
        """mu and dy/dt over a box."""
        at = [Jet.variable((x, y), k, by) for k in (0, 1)]
        return self.block.at_state(*at, 'mu', 'by_y')

    def rise(self, mu):
        """d ln m at most: the slope of mu over m_1, and that of ln mu times mu/m."""
        m = between(self.force.a, self.force.a)
        bounds = [mu.by.all / m]
        if self.block.tan > 0:
            bounds.append(mu.rate.all * (1 + self.block.tan / m))
        return min(u.b for u in bounds)

    def strip(self, x, y):
        """Bounds of the slopes of mu, dy/dt, and its logarithm's slopes."""
        both = [self.grow(x, y, by) for by in (0, 1)]
        slopes = [mu.by.all for mu, _ in both]
        claim(slopes[0] >= 0 and slopes[1] >= 0, 'mu does not rise outward')
        return slopes, [g for _, g in both], [g.rate.all for _, g in both]

    def edge(self, x, y):
        """|dy/dt| on an edge of the strip."""
        g = -self.side * self.grow(x, y, 0)[1].value.all
        claim(g >= 0, 'psi does not move outward')
        return g


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


def outward(z, side, w):
    return between(z.a, z.b + w) if side > 0 else between(z.a - w, z.b)


def beyond(z, side):
    return between(z.a, iv.inf) if side > 0 else between(-iv.inf, z.b)


def tail_in_psi(p):
    """Theorem 8: how far x goes, and the excess."""
    block = p.block

    def way_for(w):
        x = outward(p.x, p.side, w)
        slopes, _, rate = p.strip(x, beyond(p.y, p.side))
        q, g = (p.side * rate[1]).a, p.edge(x, p.y).a
        claim(q > 0, 'the rate of psi does not grow')
        m = p.force.b + slopes[0].b * w + slopes[1].b / q
        change = expm1(x - block.at[0])
        way = block.force / iv.exp(x.a) * m / (q * g)
        return way, abs(block.v * change).b / (q * g), int(way * q < 1)
    return settled(way_for)


def tail_in_v(p):
    """Theorem 9: how far y goes, and the excess."""
    block = p.block

    def way_for(w):
        x, y = beyond(p.x, -1), outward(p.y, -1, w)
        _, both, rate = p.strip(x, y)
        most = p.edge(p.x.b, y).b
        time = iv.exp(p.x.b) / (block.force * p.force.a)
        g, q = both[0].value.all, 1 + rate[0].a
        ways = [(g.b, g.b)] if g >= 0 and is_finite(g) else []
        if q > 0:
            ways.append((most / q, most))
        claim(ways, 'v dpsi/dt does not vanish with v')
        way, steep = [min(column, key=lambda u: u.b) * time for column in zip(*ways)]
        return way, block.v * time, -int(steep < 1)
    return settled(way_for)


def is_level(u):
    return is_finite(u.c) and u.power[1] <= 0 and not any(u.slope)


def stays_open(p):
    """Theorem 10: v has no limit."""
    _, (_, g), _ = p.strip(beyond(p.x, 1), beyond(p.y, 1))
    claim(p.side > 0 and g.value.all < 0, 'psi does not move outward')
    claim(is_level(g.value) or is_level(g.by), 'the branch is not open')


def stays_steep(p):
    """Theorem 17, of an open branch: dy/dx > 1 at the place and beyond."""
    _, (_, g), rate = p.strip(x := beyond(p.x, 1), y := beyond(p.y, 1))
    f = p.block.flow(0, line(p.X, ZERO, 1), line(p.Y, ONE, 1))
    rises = [p.rise(p.grow(x, y, by)[0]) for by in (0, 1)]
    return (g.value.all < 0 and (f[1] / f[0])[0] > 1
            and 1 + rate[0].a + rate[1].a > rises[0] + rises[1])
