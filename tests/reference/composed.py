#!/usr/bin/env python3
"""High-precision values of the stable manifold, independent of Slipway.

    composed.py composed > composed.csv      composed laws and Kato-Tullis
    composed.py random SEED > random.csv     presets at random parameters
    composed.py validate manifold.csv [EVERY [FIRST]]

Needs mpmath.  The formulas are written from the paper (Putelat & Dawes 2015)
in plain, un-centred form: digits lost near the saddle are paid for with more
digits.  Method: the parameterisation z(sigma), sigma' = lambda sigma, of the
local manifold as a Taylor series, then Taylor steps of the graph y(x) or x(y),
x = ln v, y = ln psi (psi where psi is a logarithm), out to where the curve's
remaining change is below the tolerance: no closed tails.  Every row is computed
twice, at other orders, tolerances and digits; dig_* is how many digits agree.
Parameters are the doubles nearest to the decimals shown (in `validate`: the
decimals themselves).
"""

import csv
import random
import sys

import mpmath as mp

from model import COMPONENTS, KEYS, Model, PRESETS, TABLE_2
from tape import Tape

mpf = mp.mpf


# ---- the curve -----------------------------------------------------------

class Field:
    """The model on a tape: append to x and y, then run."""

    def __init__(self, model):
        self.tape = Tape()
        self.x, self.y = [], []
        self.v, self.fx, self.fy = model.components(self.tape, self.x, self.y)

    def clear(self, x0, y0):
        self.tape.clear()
        self.x[:], self.y[:] = [x0], [y0]


class Local:
    """z(sigma) with sigma' = lambda_minus sigma, and the integral of
    (v - v_sp) dt from sigma to the saddle."""

    def __init__(self, model, x0, y0, order, tol):
        f = Field(model)
        f.clear(x0, y0)
        f.tape.run(0)
        J = self.jacobian(f)
        half, det = (J[0] + J[3]) / 2, J[0] * J[3] - J[1] * J[2]
        far = half - mp.sqrt(half ** 2 - det)
        self.minus, self.plus = far, det / far
        rows = [(J[1], far - J[0]), (far - J[3], J[2])]
        e = max(rows, key=lambda r: abs(r[0]) + abs(r[1]))
        size = max(abs(e[0]), abs(e[1]))
        f.x.append(e[0] / size)
        f.y.append(e[1] / size)
        f.tape.run(1)
        for k in range(2, order + 1):
            f.x.append(mpf(0))
            f.y.append(mpf(0))
            f.tape.run(k)  # the part of f_k without z_k
            p, q = k * far - J[0], k * far - J[3]
            d = p * q - J[1] * J[2]
            f.x[k], f.y[k] = ((q * f.fx[k] + J[1] * f.fy[k]) / d,
                              (J[2] * f.fx[k] + p * f.fy[k]) / d)
            f.tape.run(k, redo=True)
        self.x, self.y = list(f.x), list(f.y)
        self.excess = [mpf(0)] + [f.v[k] / (k * -far)
                                  for k in range(1, order + 1)]
        self.radius = min(
            (tol * abs(s[1]) / abs(c)) ** (mpf(1) / (k - 1))
            for s in (self.x, self.y, self.excess) if s[1]
            for k, c in enumerate(s) if k >= order - 1) / 2

    @staticmethod
    def jacobian(f):
        """fx_x, fx_y, fy_x, fy_y: coefficients 1 along (1, 0) and (0, 1)."""
        out = []
        for ex, ey in ((1, 0), (0, 1)):
            f.x[1:], f.y[1:] = [mpf(ex)], [mpf(ey)]
            f.tape.run(1, redo=True)
            out.append((f.fx[1], f.fy[1]))
        del f.x[1:], f.y[1:]
        f.tape.forget(1)
        return out[0][0], out[1][0], out[0][1], out[1][1]


def horner(c, s):
    return mp.polyval(c[::-1], s)


def slope_of(c):
    return [k * u for k, u in enumerate(c)][1:]


class Branch:
    """One half of the manifold from the local series to its end."""

    STEEP, FLAT, KNEE_SAMPLES = mpf(3) / 2, mpf(2) / 3, 16

    def __init__(self, model, x0, y0, local, side, order, tol):
        self.m, self.order, self.tol = model, order, tol
        self.origin, self.v_sp = (x0, y0), mp.exp(x0)
        self.knees = []  # (v, psi, rising)
        self.graph = [self.tape_for(0), self.tape_for(1)]
        s = side * local.radius
        self.z = [horner(local.x, s), horner(local.y, s)]
        self.excess = -horner(local.excess, s)
        tangent = [horner(slope_of(c), s) * side for c in (local.x, local.y)]
        self.ind = 1 if abs(tangent[1]) > abs(tangent[0]) else 0
        self.way = mp.sign(tangent[self.ind])
        self.local_knees(local, s)
        self.end = None
        while self.end is None:
            self.step()

    def tape_for(self, ind):
        f = Field(self.m)
        pair = (f.fy, f.fx) if ind == 0 else (f.fx, f.fy)
        slope = f.tape.quotient(*pair)
        fast = f.tape.linear(-self.v_sp, 1, f.v)
        rate = f.tape.quotient(fast, (f.fx, f.fy)[ind])
        return f, slope, rate

    def series(self):
        """Series of the dependent coordinate, its slope and the integral."""
        f, slope, rate = self.graph[self.ind]
        f.clear(*self.z)
        for k in range(self.order):
            f.tape.run(k)
            s = mpf(1 if k == 0 else 0)
            d = slope[k] / (k + 1)
            f.x.append(s if self.ind == 0 else d)
            f.y.append(d if self.ind == 0 else s)
        dep = f.y if self.ind == 0 else f.x
        return list(dep), list(slope), [self.excess] + [
            r / (k + 1) for k, r in enumerate(rate)]

    def field_slope(self, z):
        """(dy/dx or dx/dy, rate) at a point, from the field."""
        f, slope, rate = self.graph[self.ind]
        f.clear(*z)
        f.tape.run(0)
        return slope[0], rate[0]

    def point(self, dep, h):
        z = [None, None]
        z[self.ind] = self.z[self.ind] + h
        z[1 - self.ind] = horner(dep, h)
        return z

    def offset(self, i):
        return abs(self.z[i] - self.origin[i])

    def step(self):
        dep, slope, excess = self.series()
        scale = min(mpf(1), self.offset(1 - self.ind))
        h = mpf(8)
        for c, size in ((dep, scale), (excess, abs(self.excess))):
            for k in (len(c) - 2, len(c) - 1):
                if c[k]:
                    h = min(h, (self.tol * size / abs(c[k])) ** (mpf(1) / k))
        h *= mpf('0.9') * self.way
        while True:
            z = self.point(dep, h)
            truth, rate = self.field_slope(z)
            off = abs(horner(slope, h) - truth) * abs(h)
            slip = abs(horner(slope_of(excess), h) - rate) * abs(h)
            if off < 1000 * self.tol * scale and \
                    slip < 1000 * self.tol * abs(self.excess):
                break
            h /= 2
        self.find_knees(dep, slope, h)
        self.z, self.excess = z, horner(excess, h)
        self.finish(truth, rate)
        self.turn(truth)

    def turn(self, slope):
        """The other coordinate becomes the independent one."""
        if abs(slope) > self.STEEP:
            self.way *= mp.sign(slope)
            self.ind = 1 - self.ind

    def finish(self, slope, rate):
        far = mpf(400)
        away = self.z[self.ind] - self.origin[self.ind]
        still = self.tol / 1000
        done = (abs(slope) < still * min(mpf(1), self.offset(1 - self.ind))
                and abs(rate) < still * abs(self.excess))
        psi = self.z[1] if self.m.is_log else mp.exp(self.z[1])
        if self.ind == 1 and self.way > 0:
            if done:
                self.end = 'psi_inf'
            elif away > 30 and psi > 300:
                self.end = 'open'
        elif self.ind == 1 and done:
            self.end = 'psi_0'
        elif self.ind == 0 and self.way < 0 and done:
            self.end = 'v_0'
        if self.end is None and abs(away) > far:
            self.end = 'truncated'

    # -- knees: dy/dx = 1, which in both charts is slope = 1

    def knee_at(self, z, outward_rise):
        psi = z[1] if self.m.is_log else mp.exp(z[1])
        self.knees.append((mp.exp(z[0]), psi, outward_rise))

    def crossings(self, g, end):
        """Zeros of g between 0 and end, and whether g grows there."""
        n = self.KNEE_SAMPLES
        s = [end * i / n for i in range(n + 1)]
        values = [g(u) for u in s]
        for i in range(n):
            if (values[i] > 0) != (values[i + 1] > 0):
                u = mp.findroot(g, (s[i], s[i + 1]), solver='ridder',
                                tol=self.tol ** 2, maxsteps=400, verify=False)
                yield u, values[i + 1] > 0

    def find_knees(self, dep, slope, h):
        for u, grows in self.crossings(lambda u: horner(slope, u) - 1, h):
            self.knee_at(self.point(dep, u), grows == (self.ind == 0))

    def local_knees(self, local, s):
        dx, dy = slope_of(local.x), slope_of(local.y)
        flat = abs(horner(dx, s)) > abs(horner(dy, s))

        def g(u):
            p, q = horner(dx, u), horner(dy, u)
            return (q / p if flat else p / q) - 1
        for u, grows in self.crossings(g, s):
            self.knee_at([horner(local.x, u), horner(local.y, u)],
                         grows == flat)


# ---- rows ----------------------------------------------------------------

NUMBERS = ['v_sp', 'psi_sp', 'tan_alpha', 'lambda_minus', 'lambda_plus',
           'v_plus', 'x_excess', 'mu_s_num', 'mu_s_mean', 'G_num',
           'knee_up_v', 'knee_up_psi', 'v_minus', 'psi_at_v0',
           'x_deficit_lower', 'knee_lo_v', 'knee_lo_psi']
WORDS = ['has_saddle', 'upper_end', 'n_knee_up', 'lower_end', 'n_knee_lo']


def first_knee(branch):
    rising = [k for k in branch.knees if k[2]]
    return rising[0][:2] if rising else (None, None)


def solve(row, order, tol, digits, exact_decimals=False, nudge=0):
    """Every number of a row as a dictionary."""
    mp.mp.dps = digits
    tol = mpf(tol)
    m = Model(row, exact_decimals)
    if nudge:
        m.alpha *= 1 + mpf(nudge)
        m.cos, m.tan = mp.cos(m.alpha), mp.tan(m.alpha)
    x0 = m.saddle()
    if x0 is None:
        return {'has_saddle': 0}
    y0 = m.y_ss(x0)
    local = Local(m, x0, y0, order, tol)
    side = 1 if local.x[1] > 0 else -1
    up = Branch(m, x0, y0, local, side, order, tol)
    low = Branch(m, x0, y0, local, -side, order, tol)
    v = mp.exp(x0)
    out = {'has_saddle': 1, 'v_sp': v, 'psi_sp': m.psi_ss(x0, mp.mp),
           'tan_alpha': m.tan, 'lambda_minus': local.minus,
           'lambda_plus': local.plus, 'upper_end': up.end,
           'lower_end': low.end, 'n_knee_up': len(up.knees),
           'n_knee_lo': len(low.knees)}
    out['knee_up_v'], out['knee_up_psi'] = first_knee(up)
    out['knee_lo_v'], out['knee_lo_psi'] = first_knee(low)
    if up.end == 'psi_inf':
        plus, excess = mp.exp(up.z[0]), -up.excess
        half = m.eps2 / (2 * m.cos)
        out.update(v_plus=plus, x_excess=excess,
                   G_num=half * (plus ** 2 - v ** 2),
                   mu_s_num=m.tan + half * (plus ** 2 - v ** 2) / excess,
                   mu_s_mean=m.tan + half * (plus - v) ** 2 / excess)
    if low.end == 'psi_0':
        out['v_minus'] = mp.exp(low.z[0])
    if low.end == 'v_0':
        out['psi_at_v0'] = low.z[1] if m.is_log else mp.exp(low.z[1])
    if low.end in ('psi_0', 'v_0'):
        out['x_deficit_lower'] = abs(low.excess)
    return out


def agreement(p, q):
    if p is None or q is None:
        return 99.0 if p is q else 0.0
    if p == q:
        return 99.0
    return float(-mp.log10(abs(p - q) / max(abs(p), abs(q))))


def twice(row, exact_decimals=False):
    """Two runs; the finer one, and the digits they share, number by number."""
    coarse = solve(row, 36, '1e-27', 65, exact_decimals)
    fine = solve(row, 42, '1e-32', 80, exact_decimals)
    shared = {k: agreement(coarse.get(k), fine.get(k)) for k in NUMBERS}
    if any(coarse.get(k) != fine.get(k) for k in WORDS):
        shared['v_sp'] = 0.0
    return fine, shared


def sensitivity(row):
    """d ln v_plus/d alpha, and of the lower branch's end (of psi itself where
    it is a logarithm), by central differences."""
    h = mpf('1e-7')
    up, down = (solve(row, 18, '1e-16', 45, False, s * h) for s in (1, -1))
    width = 2 * h * mpf(float(row['alpha']))
    out = []
    for keys in (['v_plus'], ['v_minus', 'psi_at_v0']):
        key = next((k for k in keys if up.get(k) is not None
                    and down.get(k) is not None), None)
        plain = key == 'psi_at_v0' and Model(row).is_log
        f = (lambda u: u) if plain else mp.log
        out.append((f(up[key]) - f(down[key])) / width if key else None)
    return out


COLUMNS = (['law', 'form'] + COMPONENTS + KEYS[:-1] + ['alpha', 'has_saddle']
           + NUMBERS[:5] + ['upper_end'] + NUMBERS[5:12] + ['n_knee_up',
           'lower_end'] + NUMBERS[12:] + ['n_knee_lo', 'dlnvplus_dalpha',
           'dlnlower_dalpha', 'digits_lost_alpha_vplus',
           'digits_lost_alpha_lower', 'dig_least'])


def text_of(value):
    if isinstance(value, mpf):
        return mp.nstr(value, 25, min_fixed=-5, max_fixed=15)
    return '' if value is None else str(value)


def finished(row):
    values, shared = twice(row)
    out = {k: row.get(k, '') for k in COLUMNS}
    out.update(values)
    if values['has_saddle']:
        out['dig_least'] = '%.1f' % min(shared.values())
        slopes = sensitivity(row)
        for end, slope in zip(('vplus', 'lower'), slopes):
            if slope is not None:
                lost = mp.log10(abs(slope) * float(row['alpha']))
                out['dln%s_dalpha' % end] = mp.nstr(slope, 9)
                out['digits_lost_alpha_' + end] = mp.nstr(lost, 3)
    return [text_of(out[k]) for k in COLUMNS]


def composed_rows():
    laws = [  # components, form, material, alphas
        (('ln_c_psi', 'spinodal', 'ageing44', 'sinh'), 'asinh', {},
         ('0.30', '0.34', '0.375')),
        (('ln_c_psi', 'spinodal', 'slip45', 'sinh'), 'log', {},
         ('0.30', '0.34', '0.375')),
        (('ln_psi', 'spinodal_unit', 'slip', 'linear'), 'asinh',
         {'R': '3', 'mu_star': '0.6'}, ('0.40', '0.45', '0.48')),
        (('psi', 'spinodal', 'spinodal', 'sinh'), 'log', {'R': '3'},
         ('0.40', '0.405', '0.41')),
        (('ln_c_1pR_psi', 'inverse', 'ageing44', 'linear'), 'log',
         {'R': '5', 'mu_star': '0.3'}, ('0.30', '0.34', '0.38')),
    ]
    for parts, form, material, alphas in laws:
        for alpha in alphas:
            yield make_row('composed', form, dict(material, alpha=alpha),
                           parts)
    for form, alpha in (('asinh', '0.34'), ('log', '0.36'), ('asinh', '0.38')):
        yield make_row('kato_tullis', form, {'V_c': '10', 'alpha': alpha})


def make_row(law, form, values, parts=None):
    return dict(TABLE_2, law=law, form=form, **values,
                **dict(zip(COMPONENTS, parts or PRESETS[law])))


def random_rows(seed, count):
    """Presets in turn, parameters drawn wide, a slope that has a saddle."""
    r = random.Random(seed)

    def draw(lo, hi):
        return '%.4g' % (lo * (hi / lo) ** r.random())
    laws = list(PRESETS)
    while count > 0:
        values = {'a': draw(0.004, 0.1), 'mu_star': draw(0.1, 0.9),
                  'L': draw(1e-7, 1e-4), 'V_star': draw(1e-8, 1e-5),
                  'g': draw(1, 100), 'c': draw(1e-6, 1e-1),
                  'R': draw(2, 1e4), 'V_c': draw(1e-1, 1e5), 'alpha': '1'}
        values['b'] = '%.4g' % (float(values['a']) * (1.05 + 3 * r.random()))
        form = r.choice(['asinh', 'log'])
        law = laws[count % len(laws)]
        m = Model(make_row(law, form, values))
        mu = m.balance(r.uniform(-12, 14), mp.fp) + \
            (m.tan + m.a * mp.log(1 - mp.exp(-2 * m.tan / m.a))
             if m.asinh else m.tan)  # (2); its asinh is near
        if not 0.03 < mu < 3:
            continue
        values['alpha'] = '%.5g' % float(mp.atan(mu))
        row = make_row(law, form, values)
        if Model(row).saddle() is not None:
            count -= 1
            yield row


def write(rows):
    out = csv.writer(sys.stdout, lineterminator='\n')
    out.writerow(COLUMNS)
    for row in rows:
        out.writerow(finished(row))
        sys.stdout.flush()


def validate(path, every, first):
    with open(path, newline='') as file:
        rows = list(csv.DictReader(file))[first::every]
    for row in rows:
        mine, shared = twice(row, True)
        worst = {}
        for key in NUMBERS:
            if row.get(key, '') in ('', 'none'):
                if mine.get(key) is not None:
                    worst[key] = 'exists'
                continue
            if mine.get(key) is None:
                worst[key] = 'missing'
                continue
            worst[key] = round(agreement(mpf(row[key]), mine[key]), 1)
        words = [k for k in WORDS if row.get(k)
                 and str(mine.get(k)) not in row[k]]
        least = min((v for v in worst.values() if isinstance(v, float)),
                    default=None)
        bad = {k: v for k, v in worst.items()
               if not isinstance(v, float) or v < 16}
        print(row['law'], row['form'], row['alpha'], row.get('tag'),
              'least', least, 'own', round(min(shared.values()), 1),
              bad, words, flush=True)


def main():
    command, rest = sys.argv[1], sys.argv[2:]
    if command == 'composed':
        write(composed_rows())
    elif command == 'random':
        write(random_rows(int(rest[0]), 24))
    else:
        validate(rest[0], int(rest[1]) if rest[1:] else 1,
                 int(rest[2]) if rest[2:] else 0)


if __name__ == '__main__':
    main()
