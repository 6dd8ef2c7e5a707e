"""The field of a block on a slope over balls and intervals, and the conditions of
docs/proofs.md's theorems 1 to 5: the saddle, the cone, the tube, its joins.
Equations of Putelat & Dawes (2015), (2)-(17), (44), (45).
"""
import functools

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

    def psi_at(self, Y):
        return self.psi + Y if self.is_log else self.psi * iv.exp(Y)

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
    error = (kappa * reach).b
    beside = abs(across).b * error * UNIT
    finest = reach
    while not holds(excess, beside - piece.step * along(block, piece, reach, finest,
                                                        kappa * (1 - g.b))):
        finest /= 4
        claim(finest * PARTS >= reach, 'the integral in the cone does not follow')
    return error


def along(block, piece, reach, finest, most):
    """The integral over the cone, in parts that short or shorter where |D| < most
    takes it."""
    total, parts = ZERO, [(0, reach)]
    while parts:
        a, b = parts.pop()
        middle = (a + b) / 2
        if a == 0:
            at, (defect, q, rest) = a, near_saddle(block, piece, b)
        else:
            at, (defect, q, rest, _) = middle, on_part(block, piece, a, b)
        if defect < most and b - a <= finest:
            total += integral(q, a - iv.mpf(at), b - iv.mpf(at)) + rest * (b - iv.mpf(a))
            continue
        claim(b - a > reach / 2 ** 20, '|D| < kappa (1 - g) fails in the cone')
        parts += [(a, middle), (middle, b)]
    return total


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
    dep = value(piece.coef, ONE) + error * UNIT
    gap = abs(following.start - dep).b
    dep = hull(dep, following.start)
    way = ZERO
    for _ in range(20):
        G, q = aside(block, piece, at + way * UNIT, dep)
        claim(G[0] > 0, 'the manifold does not rise at a turn')
        found = (gap / G[0].a).b
        if found < way:
            return ((found + abs(at - following.coef[0]).b).b,
                    abs(q[0]).b * found * UNIT)
        way = 2 * found + iv.mpf('1e-290')
    raise Wrong('no box around a turn')
