"""Theorem 16 of docs/proofs.md: the knees of a branch, from signs of dy/dx - 1 and
of its derivative along the manifold, part by part.
"""
from mpmath import iv

from certificate_tube import (ONE, UNIT, ZERO, attempt, between, claim, hull, line,
                              value)

HALVINGS = 40


def sign_of(u):
    return 1 if u > 0 else -1 if u < 0 else 0


class Seeker:
    def __init__(self, block):
        self.block = block
        self.sign = self.turn = 0
        self.place = None
        self.knees = []

    def over_one(self, piece, at, dep):
        return self.aside(piece, at, dep)[0] - 1

    def aside(self, piece, at, dep):
        f = self.block.flow(piece.ind, line(at, ZERO, 1), line(dep, ONE, 1))
        return f[1] / f[0]

    def at_point(self, piece, at, dep):
        """By the mean value over dep."""
        middle = iv.mpf(dep.mid)
        return (self.over_one(piece, at, middle)
                + self.aside(piece, at, dep)[1] * (dep - middle))

    def bend(self, piece, at, dep):
        slope = [(f[1] / f[0]) for f in (
            self.block.flow(piece.ind, line(at, ONE, 1), line(dep, ZERO, 1)),
            self.block.flow(piece.ind, line(at, ZERO, 1), line(dep, ONE, 1)))]
        return piece.step * (slope[0][1] + slope[1][1] * slope[1][0])

    def upright(self, piece, u):
        return u if piece.ind == 0 else -u

    def passes(self, sign):
        if self.sign and sign != self.sign:
            claim(self.turn == sign and self.place, 'how the slope passes through 1')
            if sign > 0:
                self.knees.append(self.place)
        self.sign, self.turn, self.place = sign, 0, None

    def turns(self, rise):
        claim(rise and self.sign and self.turn in (0, rise), 'the slope is too near 1')
        self.turn = rise

    def add_place(self, piece, at, dep):
        new = (at, dep) if piece.ind == 0 else (dep, at)
        self.place = tuple(map(hull, self.place, new)) if self.place else new

    def narrow(self, piece, box, a, b):
        """Newton's method over intervals."""
        for _ in range(12):
            m = (a + b) / 2
            to = m - self.at_point(piece, *box(m, m)) / self.bend(piece, *box(a, b))
            size, a, b = b - a, max(iv.mpf(a).a, to.a), min(iv.mpf(b).b, to.b)
            if not a <= b:
                return
            if not b - a < size / 2:
                break
        self.add_place(piece, *box(a, b))

    def part(self, piece, box, a, b, cone=None, depth=0):
        over = (attempt(self.at_saddle, piece, b, cone) if cone and a == 0 else
                attempt(self.over_one, piece, *box(a, b)))
        sign = 0 if over is None else sign_of(self.upright(piece, over))
        if sign:
            return self.passes(sign)
        rise = 0 if a == 0 and cone or over is None else sign_of(
            self.upright(piece, self.bend(piece, *box(a, b))))
        if rise:
            self.narrow(piece, box, a, b)
            return self.turns(rise)
        m = (a + b) / 2
        claim(depth < HALVINGS, 'the slope is too near 1')
        self.part(piece, box, a, m, cone, depth + 1)
        return self.part(piece, box, m, b, cone, depth + 1)

    def at_saddle(self, piece, b, kappa):
        """By mean values of the Jacobian over the cone up to theta = b."""
        box = between(0, b)
        sigma = value(piece.coef[1:], box) + kappa * UNIT
        by_ind, by_dep = self.block.jacobian(piece.ind, piece.step * box, sigma * box)
        m, d = [piece.step * u + sigma * w for u, w in zip(by_ind[:2], by_dep[:2])]
        claim(piece.step * m < 0, 'theta does not fall in the cone')
        return d / m - 1


def boxes(piece, error):
    """Of [a, b]: where the manifold is, |dep - p| <= error(b)."""
    def box(a, b):
        theta = between(iv.mpf(a).a, iv.mpf(b).b)
        m = iv.mpf(theta.mid)
        p = piece.p.shift(m)
        dep = value([p[k] for k in range(len(piece.coef))], theta - m)
        return piece.at(theta), dep + error(iv.mpf(b).b) * UNIT
    return box


def find_knees(block, pieces, branch, errors, beyond):
    """errors: at the beginning and at the end of each piece.  The places (x, y), and
    whether there are no more."""
    s, cone = Seeker(block), branch['cone']
    kappa = iv.mpf(cone['slope'])
    s.part(pieces[0], boxes(pieces[0], lambda b: kappa * b), iv.mpf(0),
           iv.mpf(cone['reach']), kappa)
    a = cone['reach']
    for i, (piece, j) in enumerate(zip(pieces, branch['pieces'])):
        if i and pieces[i - 1].ind != piece.ind:
            last = pieces[i - 1]
            end = value(last.coef, ONE) + errors[i - 1][1] * UNIT
            at = hull(end, piece.start)
            dep = piece.coef[0] + errors[i][0] * UNIT
            sign = sign_of(s.upright(piece, s.over_one(piece, at, dep)))
            if sign:
                s.passes(sign)
            else:
                s.add_place(piece, at, dep)
                s.turns(sign_of(s.upright(piece, s.bend(piece, at, dep))))
        for b, radius, _, _ in j['cells']:
            r = iv.mpf(radius)
            s.part(piece, boxes(piece, lambda _, r=r: r), iv.mpf(a), iv.mpf(b))
            a = b
        a = 0
    if beyond:
        s.passes(beyond)
    return s.knees, beyond != 0
