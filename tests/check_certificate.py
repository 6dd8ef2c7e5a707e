#!/usr/bin/python3
"""Verifies again what `slipway knees --proved --certificate FILE` claims.

usage: check_certificate.py FILE...

docs/proofs.md has the theorems; here each of their conditions is evaluated with
mpmath's intervals at 160 bits, from the inputs as decimals and the equations of
Putelat & Dawes (2015), (2)-(17), (44), (45).  Read from the file are inputs,
polynomials, where their cells end, and claims; each claim has to follow.
Exit status 0: all hold; 1: one does not, and its name.
"""
import functools
import json
import sys

from mpmath import iv, mp

from ball_series import BITS, Series, constant, series

mp.prec = BITS
ORDER = 14        # of Taylor expansions
PARTS = 64        # of a cell, at most
ZERO, ONE, UNIT = iv.mpf(0), iv.mpf(1), iv.mpf([-1, 1])


class Wrong(Exception):
    """A claim that does not follow."""


def claim(holds, *what):
    if not holds:
        raise Wrong(' '.join(str(w) for w in what))


def between(lo, hi):
    return iv.mpf([lo, hi])


def hull(u, w):
    return between(min(u.a, w.a), max(u.b, w.b))


def holds(claimed, u):
    """Whether [lo, hi] of the file has all of u in it."""
    return iv.mpf(claimed[0]) <= u.a and u.b <= iv.mpf(claimed[1])


def expm1(u):
    """Near 0 by its series: |rest| <= |last term| for |u| <= 1/2."""
    if not abs(u) < 0.5:
        return iv.exp(u) - 1
    term, total = u, u
    for k in range(2, 60):
        term = term * u / k
        total += term
    return total + term * UNIT


def value(p, s):
    total = ZERO
    for c in reversed(p):
        total = c + s * total
    return total


def integral(q, u, w):
    """Of the series q from u to w."""
    total = ZERO
    for j in range(len(q)):
        total += q[j] * (w ** (j + 1) - u ** (j + 1)) / (j + 1)
    return total


def line(at, step, n):
    return series([at, step] + [ZERO] * (n - 1))


# ---- the block on a slope ---------------------------------------------------

class Block:
    """Equations (17) in the chart (x, y) = (ln v, ln psi) or (ln v, psi)."""

    def __init__(self, law, material, slope):
        self.law = law
        get = {name: iv.mpf(text) for name, text in material.items()}
        self.get = get
        name, text = next(iter(slope.items()))
        angle = iv.mpf(text)
        if name == 'alpha_deg':
            angle = angle * iv.pi / 180
        self.tan = angle if name == 'tan_alpha' else iv.sin(angle) / iv.cos(angle)
        eps2 = get['V_star'] ** 2 / (get['g'] * get['L'])
        # cos(alpha)/eps^2
        self.force = 1 / (eps2 * iv.sqrt(1 + self.tan ** 2))
        self.is_log = law['chart'] == 'psi'
        self.first_order = law['kinetics'] == 'linear'

    def psi_ss(self, x, v):
        form = self.law['psi_ss']
        if form == 'inverse':
            return (-x).exp()
        if form == 'minus_log':
            return -x
        R = self.get['R']
        top = 1 + R if form == 'spinodal' else ONE
        return constant(top, len(v) - 1) / v.times(R).plus(ONE)

    def rate(self, v, psi_ss):
        """1/T"""
        form = self.law['timescale']
        if form == 'slip':
            return v
        R = self.get['R']
        if form == 'spinodal':
            return v.plus(1 / R)
        if form == 'ageing44':
            return constant(1 / R, len(v) - 1) / psi_ss
        return (-psi_ss).exp().times(1 / R)

    def theta(self, y, psi):
        form, get = self.law['theta'], self.get
        if form == 'psi':
            return psi
        if form == 'ln_psi':
            return psi.ln() if self.is_log else y
        factor = ONE if form == 'ln_c_psi' else 1 + get['R']
        return psi.times(factor).plus(get['c']).ln()

    def mu(self, x, theta):
        """a m, m = asinh(e^w/2): m' = w'/sqrt(1 + 4 e^(-2 w))"""
        a = self.get['a']
        inside = theta.times(self.get['b']).plus(self.get['mu_star'])
        if self.law['friction'] == 'log':
            return x.times(a) + inside
        w = x + inside.times(1 / a)
        z = iv.exp(w[0]) / 2
        four = w.times(iv.mpf(-2)).exp().times(iv.mpf(4))
        t = four.plus(ONE).ln().times(iv.mpf(-0.5)).exp()
        m = (t.part(0, len(t) - 1) * w.slope()).rise(iv.log(z + iv.sqrt(z * z + 1)))
        return m.times(a)

    def kinetics(self, d):
        return d if self.first_order else (d.exp() - (-d).exp()).times(iv.mpf(0.5))

    def state(self, x, y):
        psi = y if self.is_log else y.exp()
        v = x.exp()
        psi_ss = self.psi_ss(x, v)
        return v, psi, psi_ss, self.rate(v, psi_ss), self.mu(x, self.theta(y, psi))

    def flow(self, ind, at, dep):
        """By (ind, dep) from the saddle: both rates and v - v_sp, all times v (and
        psi where y is ln psi)."""
        both = at.plus(self.at[ind]), dep.plus(self.at[1 - ind])
        v, psi, psi_ss, rate, mu = self.state(both[ind], both[1 - ind])
        fx = (-mu).plus(self.tan).times(self.force)
        fy = -(self.kinetics(psi - psi_ss) * (v * rate))
        excess = v * v.plus(-self.v)
        if not self.is_log:
            fx, excess = fx * psi, excess * psi
        return (fx, fy, excess) if ind == 0 else (fy, fx, excess)

    def balance(self, x):
        """mu_ss - tan(alpha) at x = ln v"""
        x = constant(x, 1)
        psi = self.psi_ss(x, x.exp())
        y = psi if self.is_log else psi.ln()
        return self.mu(x, self.theta(y, psi))[0] - self.tan

    # -- the saddle: theorems 1 and 2

    def find_saddle(self, near):
        def h(x):
            return mp.mpf(self.balance(iv.mpf(x)).mid)
        x = [mp.log(near), mp.log(near) + mp.mpf(2) ** -40]
        for _ in range(14):
            g = [h(x[0]), h(x[1])]
            if g[0] == g[1]:
                break
            x = [x[1], x[1] - g[1] * (x[1] - x[0]) / (g[1] - g[0])]
        for bits in range(130, 40, -10):
            r = mp.mpf(2) ** -bits
            if (self.balance(iv.mpf(x[1] - r)) > 0
                    and self.balance(iv.mpf(x[1] + r)) < 0):
                return self.set_saddle(between(x[1] - r, x[1] + r))
        raise Wrong('no sign change of mu_ss - tan(alpha) near the saddle')

    def set_saddle(self, x):
        self.v = iv.exp(x)
        x = constant(x, 1)
        self.psi = self.psi_ss(x, x.exp())[0]
        self.at = x[0], self.psi if self.is_log else iv.log(self.psi)

    def jacobian(self, ind, at, dep):
        """Derivatives of the flow by ind and by dep over a box."""
        return ([f[1] for f in self.flow(ind, line(at, ONE, 1), line(dep, ZERO, 1))],
                [f[1] for f in self.flow(ind, line(at, ZERO, 1), line(dep, ONE, 1))])

    def eigenvalues(self):
        (xx, yx, _), (xy, yy, _) = self.jacobian(0, ZERO, ZERO)
        unit = self.v if self.is_log else self.v * self.psi
        det, trace = xx * yy - xy * yx, xx + yy
        claim(det < 0 and trace < 0, 'det J < 0 at the saddle')
        minus = (trace - iv.sqrt(trace ** 2 - 4 * det)) / 2
        return minus / unit, det / minus / unit


# ---- pieces -----------------------------------------------------------------

class Piece:
    """ind = start + step theta, dep = p(theta), offsets from the saddle"""

    def __init__(self, ind, start, step, coef):
        self.ind = 'xy'.index(ind)
        self.start, self.step = iv.mpf(start), iv.mpf(step)
        self.coef = [iv.mpf(c) for c in coef]
        self.p = series(self.coef + [ZERO] * (ORDER + 2 - len(coef)))

    def at(self, theta):
        return self.start + self.step * theta


def aside(block, piece, at, dep):
    """Over a box: f_dep/f_ind and the excess per ind, each with its slope by dep."""
    f = block.flow(piece.ind, line(at, ZERO, 1), line(dep, ONE, 1))
    claim(piece.step * f[0][0] < 0, 'theta does not fall towards the saddle')
    return f[1] / f[0], -f[2] / f[0]


# ---- on the polynomial ------------------------------------------------------

def bounds(piece, at_point, over_all, h):
    """sup |D|, D = step f_dep/f_ind - p', and the excess v - v_sp per f_ind as a
    series with a rest: from (f_ind, f_dep, v - v_sp, p) about a point and, for
    the order n, over all within h of it."""
    off, rest, q = [], [], []
    for ind, dep, excess, p in (at_point, over_all):
        claim(piece.step * ind[0] < 0, 'theta does not fall towards the saddle')
        off.append((dep / ind).times(piece.step) - p.slope())
        q.append(excess / ind)
    n = len(off[0]) - 1
    return (off[0].part(0, n).size(h) + abs(off[1][n]).b * h ** n, q[0].part(0, n),
            abs(q[1][n]).b * h ** n * UNIT)


def near_saddle(block, piece, b):
    """For 0 < theta <= b: of f/theta the coefficients at 0 are known, and those
    at other theta, being means of the next ones of f."""
    n, found = ORDER + 1, []
    for at in (ZERO, between(0, b)):
        p = piece.p.shift(at).part(0, n + 1)
        f = block.flow(piece.ind, line(piece.step * at, piece.step, n), p)
        found.append([u.part(1, n + 1) for u in f] + [p])
    return bounds(piece, *found, iv.mpf(b))


def on_part(block, piece, a, b):
    """For a <= theta <= b, about the middle; and p there."""
    n, found = ORDER, []
    middle, box = iv.mpf((a + b) / 2), between(a, b)
    p = piece.p.shift(middle)
    for at, q in ((middle, p), (box, p.shift(box - middle))):
        f = block.flow(piece.ind, line(piece.at(at), piece.step, n), q.part(0, n + 1))
        found.append(list(f) + [q.part(0, n + 2)])
    return bounds(piece, *found, abs(box - middle).b) + (q[0],)


# ---- the cone: theorem 3 ----------------------------------------------------

def sides(block, piece, box, kappa):
    """In the cone: g, and theta times the slope by dep of the excess per theta, by
    mean values of the Jacobian from the saddle."""
    step = piece.step
    sigma = value(piece.coef[1:], box) + kappa * UNIT
    by_ind, by_dep = block.jacobian(piece.ind, step * box, sigma * box)
    m, d, e = [step * u + sigma * w for u, w in zip(by_ind, by_dep)]
    claim(step * m < 0, 'theta does not fall in the cone')
    return [step * (by_dep[k] - u / m * by_dep[0]) / m for k, u in ((1, d), (2, e))]


@functools.lru_cache(None)
def check_cone(block, piece, reach, slope, excess):
    """Answers a bound of |dep - p| at its end."""
    kappa = iv.mpf(slope)
    claim(0 < reach <= 1 and slope > 0, 'the cone has no size')
    claim(piece.start == 0 and piece.coef[0] == 0, 'the cone is not at the saddle')
    g, across = sides(block, piece, between(0, reach), kappa)
    total, parts = ZERO, [(0, reach)]
    while parts:
        a, b = parts.pop()
        middle = (a + b) / 2
        if a == 0:
            at, (defect, q, rest) = a, near_saddle(block, piece, b)
        else:
            at, (defect, q, rest, _) = middle, on_part(block, piece, a, b)
        if defect < kappa * (1 - g.b):
            total += integral(q, a - iv.mpf(at), b - iv.mpf(at)) + rest * (b - iv.mpf(a))
            continue
        claim(b - a > reach / 2 ** 20, '|D| < kappa (1 - g) fails in the cone')
        parts += [(a, middle), (middle, b)]
    error = (kappa * reach).b
    claim(holds(excess, abs(across).b * error * UNIT - piece.step * total),
          'the integral in the cone does not follow')
    return error


# ---- the tube: theorem 4 ----------------------------------------------------

def part(block, piece, a, b, end, error, radius):
    """From theta = a, where |dep - p| <= error, to b or end: the error there and
    the integral; None where the tube may be left."""
    defect, q, rest, dep = on_part(block, piece, a, b)
    G, across = aside(block, piece, piece.at(between(a, b)), dep + radius * UNIT)
    length = (iv.mpf(b) if b < end.a else end) - a
    rise = iv.exp((piece.step * G[1]).b * length).b
    made = (defect * length).b
    larger = max(ONE, rise)
    beside = abs(across[1]).b * radius
    if not (error + made) * larger <= radius:
        return None
    middle = iv.mpf((a + b) / 2)
    total = integral(q, a - middle, a + length - middle)
    total += (rest + beside * UNIT) * length
    return (rise * error + made * larger).b, -piece.step * total


@functools.lru_cache(None)
def check_cell(block, piece, a, b, end, error, radius, after, excess):
    """On a cell, in as many parts as the claims take."""
    count = 1
    while count <= PARTS:
        borders = [a + (b - a) * i / count for i in range(count)] + [b]
        e, total, found = iv.mpf(error), ZERO, ()
        for u, w in zip(borders, borders[1:]):
            found = part(block, piece, u, w, end, e, iv.mpf(radius))
            if found is None:
                break
            e, total = found[0], total + found[1]
        if found and e <= iv.mpf(after) and holds(excess, total):
            return
        count *= 2
    raise Wrong(f'theta {a} .. {b}: tube and integral do not follow')


# ---- from piece to piece: theorem 5 -----------------------------------------

def join(piece, following, end, error):
    return (error + abs(value(piece.coef, end) - following.coef[0]).b).b


def turn(block, piece, following, error):
    """Where dep = following.start: the error of ind, and the excess on the way."""
    at = piece.at(ONE)
    dep = hull(value(piece.coef, ONE) + error * UNIT, following.start)
    way = ZERO
    for _ in range(20):
        G, q = aside(block, piece, at + way * UNIT, dep)
        claim(G[0] > 0, 'the manifold does not rise at a turn')
        found = (dep.delta / G[0].a).b
        if found < way:
            return ((way + abs(at - following.coef[0]).b).b,
                    abs(q[0]).b * way * UNIT)
        way = 2 * found + iv.mpf('1e-290')
    raise Wrong('no box around a turn')


# ---- the ends: theorems 7 to 10, of named laws ------------------------------
# ---X------------------------------------------

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
    """w with way_for(w).way < w."""
    w = ZERO
    for _ in range(60):
        way, excess = way_for(w)
        if way < w:
            return way.b, excess.b
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
        return block.force / iv.exp(x) * m / under, abs(block.v * change).b / under
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
        most = []
        if q is not None and q > 0:
            most.append(block.kinetics(constant(psi_ss - psi, 1))[0] * rate / q)
        if 'spinodal' in block.law['psi_ss']:
            top = 1 + block.get['R'] if block.law['psi_ss'] == 'spinodal' else ONE
            most.append(block.kinetics(constant(top - psi, 1))[0] * rate)
        claim(most, 'v dpsi/dt does not vanish with v')
        way = min(most, key=lambda u: u.b) * time
        return way if block.is_log else way / psi, block.v * time
    return settled(way_for)


# ---- a branch ---------------------------------------------------------------

def begin(block, pieces, branch):
    c = branch['cone']
    return check_cone(block, pieces[0], c['reach'], c['slope'], tuple(c['excess']))


def walk(block, pieces, branch):
    """Along the cells: where they end, the error there, and the integral."""
    error, a = begin(block, pieces, branch), branch['cone']['reach']
    total = iv.mpf(branch['cone']['excess'])
    for i, (piece, j) in enumerate(zip(pieces, branch['pieces'])):
        following = pieces[i + 1] if i + 1 < len(pieces) else None
        turns = following is not None and following.ind != piece.ind
        end = (ONE if turns else iv.mpf(j['cells'][-1][0]) if following is None else
               (following.start - piece.start) / piece.step)
        for b, radius, after, excess in j['cells']:
            claim(a < b, 'cells are not in order')
            check_cell(block, piece, a, b, end, error, radius, after, tuple(excess))
            a, error, total = b, iv.mpf(after), total + iv.mpf(excess)
        claim(iv.mpf(a) >= end.b, 'a piece is not covered by its cells')
        if following is None:
            return end, error, total
        a = 0.0
        if turns:
            error, more = turn(block, piece, following, error)
            total += more
        else:
            error = join(piece, following, end, error)
    raise Wrong('a branch without pieces')


def check_branch(block, branch, side):
    """Where it settles and the excess; None: it is open."""
    pieces = [make_piece(j['independent'], j['start'], j['step'], tuple(j['coef']))
              for j in branch['pieces']]
    last, end = pieces[-1], branch['end']
    if end == 'open':
        error = begin(block, pieces, branch)
        Place(block, pieces[0], iv.mpf(branch['cone']['reach']), error, side)
        claim(side > 0 and block.first_order, 'the branch is not open')
        return None
    theta, error, total = walk(block, pieces, branch)
    place = Place(block, last, theta, error, side)
    claim((end, last.ind, side) in (('psi_inf', 1, 1), ('psi_0', 1, -1),
                                    ('v_0', 0, -1)), end, 'is no such end')
    way, excess = tail_in_v(place) if end == 'v_0' else tail_in_psi(place)
    settles = (place.Y if end == 'v_0' else place.X) + side * between(0, way)
    total = side * total + between(0, excess)
    claim(holds(branch['place'], settles), 'the place where the branch settles')
    claim(holds(branch['excess'], total), 'the integral along the branch')
    return settles, total


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
        out['psi_at_v0'] = block.psi + at if block.is_log else block.psi * iv.exp(at)
    return out


@functools.lru_cache(None)
def make_piece(*parts):
    return Piece(*parts)


@functools.lru_cache(None)
def make_block(law, material, slope, near):
    block = Block(json.loads(law), json.loads(material), json.loads(slope))
    block.find_saddle(near)
    return block


def check(certificate):
    """Raises Wrong, or another error of what cannot be computed."""
    claim(certificate['slipway_certificate'] == 1, 'not a certificate known here')
    claim('not_proved' not in certificate, 'nothing is claimed')
    claims = certificate['numbers']
    block = make_block(*(json.dumps(certificate[k])
                         for k in ('law', 'material', 'slope')), claims['v'][0])
    minus, plus_ = block.eigenvalues()
    found = {'v': block.v, 'psi': block.psi, 'lambda_minus': minus,
             'lambda_plus': plus_}
    for name in ('v', 'psi', 'lambda_minus', 'lambda_plus'):
        claim(holds(claims[name], found[name]), name)
    upper, lower = certificate['upper'], certificate['lower']
    if 'not_proved' not in upper:
        found.update(upper_numbers(block, check_branch(block, upper, 1)))
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
    except (Wrong, LookupError, TypeError, ValueError, ArithmeticError) as wrong:
        return f'{wrong}' or 'something is missing'
    return ''


def main(paths):
    failed = False
    for path in paths:
        with open(path, encoding='utf-8') as file:
            why = rejected(json.load(file))
        print(f"{path}: {why or 'every claim holds'}")
        failed = failed or why
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
