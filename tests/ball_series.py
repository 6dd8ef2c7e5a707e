"""Truncated Taylor series whose coefficients are balls: (m[k] +- r[k]) 2^e with
whole m and r >= 0 and one e, rounded to BITS (set_bits), what that costs being in r.  Where
the k-th coefficient holds the k-th derivative over k! of a function at every
point of a piece, those of what is made of it do so, too.  Functions of numbers
are those of mpmath's intervals.
"""
from operator import add, mul

from mpmath import iv, mp
from mpmath.libmp import from_man_exp

from certificate_formula import asinh, atan

BITS = iv.prec = mp.prec = 160
ONE = iv.mpf(1)


def set_bits(bits):
    global BITS
    BITS = iv.prec = mp.prec = bits


def ball(u):
    """(m, r, e) of an interval."""
    ends = [(-man if sign else man, exp) for sign, man, exp, _ in u._mpi_]
    if any(man == 0 and exp for man, exp in ends):
        raise ArithmeticError('an interval is not finite')
    exps = [exp for man, exp in ends if man] or [0]
    # what is far below the larger end is rounded outward
    e = max(min(exps), max(exps) - 4 * BITS)
    lo, hi = (man << (exp - e) if exp >= e or man == 0 else man >> min(e - exp, 8 * BITS)
              for man, exp in ends)
    hi += ends[1][0] != 0 and ends[1][1] < e
    return lo + hi, hi - lo, e - 1


class Series:
    def __init__(self, m, r, e):
        extra = max((x.bit_length() for x in m), default=0) - BITS
        if extra > 0:
            below = (1 << extra) - 1  # nothing is lost where these bits are 0
            r = [(y >> extra) + 2 * ((x | y) & below != 0) for x, y in zip(m, r)]
            m = [x >> extra for x in m]
            e += extra
        self.m, self.r, self.e = m, r, e

    def __len__(self):
        return len(self.m)

    def __getitem__(self, k):
        m, r = self.m[k], self.r[k]
        return iv.make_mpf((from_man_exp(m - r, self.e, BITS, 'f'),
                            from_man_exp(m + r, self.e, BITS, 'c')))

    def part(self, first, last):
        return Series(self.m[first:last], self.r[first:last], self.e)

    def at(self, e):
        """m and r to that exponent, which is not larger."""
        s = self.e - e
        return [x << s for x in self.m], [x << s for x in self.r]

    def __add__(self, other):
        low, high = sorted((self, other), key=lambda u: u.e)
        e = max(low.e, high.e - 4 * BITS)
        s = e - low.e
        below = (1 << s) - 1
        m, r = high.at(e)
        return Series([x + (y >> s) for x, y in zip(m, low.m)],
                      [x + (z >> s) + 2 * ((y | z) & below != 0)
                       for x, y, z in zip(r, low.m, low.r)], e) if s else Series(
                           list(map(add, m, low.m)), list(map(add, r, low.r)), e)

    def times(self, c):
        """By a number, an interval."""
        m, r, e = ball(c)
        return Series([m * x for x in self.m],
                      [r * abs(x) + (abs(m) + r) * y for x, y in zip(self.m, self.r)],
                      e + self.e)

    def plus(self, c):
        return self + constant(c, len(self) - 1)

    def __neg__(self):
        return Series([-x for x in self.m], self.r, self.e)

    def __sub__(self, other):
        return self + -other

    def __mul__(self, other):
        n = len(self)
        u, ru, w, rw = self.m, self.r, other.m[::-1], other.r[::-1]
        au, aw = [abs(x) for x in u], [abs(x) + y for x, y in zip(w, rw)]
        m = [sum(map(mul, u[:k + 1], w[n - 1 - k:])) for k in range(n)]
        r = [sum(map(mul, au[:k + 1], rw[n - 1 - k:]))
             + sum(map(mul, ru[:k + 1], aw[n - 1 - k:])) for k in range(n)]
        return Series(m, r, self.e + other.e)

    def __truediv__(self, other):
        """out_k = (u_k - sum_{j>0} w_j out_{k-j})/w_0"""
        w, rw, b = other.m, other.r, abs(other.m[0]) - other.r[0]
        if b <= 0:
            raise ArithmeticError('a quotient by what may be 0')
        aw = [abs(x) + y for x, y in zip(w, rw)]
        m, r = [], []
        for k, (x, y) in enumerate(zip(self.m, self.r)):
            mk, rk = m[::-1], r[::-1]
            top = (x << BITS) - sum(map(mul, w[1:], mk))
            wide = ((y << BITS) + sum(map(mul, aw[1:], rk))
                    + sum(map(mul, rw[1:], map(abs, mk))))
            m.append(top // w[0])
            r.append((wide + (abs(m[-1]) + bool(top)) * rw[0]) // b + 2 * bool(top or wide))
        return Series(m, r, self.e - other.e - BITS)

    def slope(self):
        """The derivative, one coefficient shorter."""
        return Series([k * x for k, x in enumerate(self.m)][1:],
                      [k * x for k, x in enumerate(self.r)][1:], self.e)

    def rise(self, first):
        """The antiderivative that is `first` at 0, one longer."""
        e = self.e - BITS
        out = series([first] + [iv.mpf(0)] * len(self))
        return out + Series([0] + [(x << BITS) // k for k, x in enumerate(self.m, 1)],
                            [0] + [(y << BITS) // k + 2 * bool(x or y) for k, (x, y) in
                                   enumerate(zip(self.m, self.r), 1)], e)

    def exp(self):
        """k w_k = sum_{j>0} j u_j w_{k-j}"""
        m0, r0, e = ball(iv.exp(self[0]))
        keep = BITS - m0.bit_length()
        first = Series([m0 << max(keep, 0)], [r0 << max(keep, 0)], e - max(keep, 0))
        d = [k * x for k, x in enumerate(self.m)][1:]
        rd = [k * x for k, x in enumerate(self.r)][1:]
        ad = [abs(x) + y for x, y in zip(d, rd)]
        m, r, up, down = first.m, first.r, max(self.e, 0), max(-self.e, 0)
        for k in range(1, len(self)):
            mk, rk = m[::-1], r[::-1]
            top = sum(map(mul, d, mk))
            wide = sum(map(mul, ad, rk)) + sum(map(mul, rd, map(abs, mk)))
            m.append((top << up >> down) // k)
            r.append(((wide << up >> down) + bool(top)) // k + 2 * bool(top or wide))
        return Series(m, r, first.e)

    def ln(self):
        return self.over(self, iv.log(self[0]))

    # functions of formulas (certificate_formula.py)
    to_exp, to_ln = exp, ln

    @staticmethod
    def of(c, like):
        return constant(c, len(like) - 1)

    def over(self, w, first):
        """The antiderivative of self'/w that is `first` at 0."""
        return (self.slope() / w.part(0, len(w) - 1)).rise(first)

    def to_sqrt(self):
        return self.ln().times(iv.mpf(0.5)).exp()

    def to_sinh(self):
        return (self.exp() - (-self).exp()).times(iv.mpf(0.5))

    def to_cosh(self):
        return (self.exp() + (-self).exp()).times(iv.mpf(0.5))

    def to_atan(self):
        return self.over((self * self).plus(ONE), atan(self[0]))

    def to_asinh(self):
        return self.over((self * self).plus(ONE).to_sqrt(), asinh(self[0]))

    def to_asinhexp(self):
        """asinh(e^u/2)' = u'/sqrt(1 + 4 e^(-2 u))"""
        z = iv.exp(self[0]) / 2
        four = self.times(iv.mpf(-2)).exp().times(iv.mpf(4))
        return self.over(four.plus(ONE).to_sqrt(), iv.log(z + iv.sqrt(z * z + 1)))

    def to_sin(self):
        return self.turned()[0]

    def to_cos(self):
        return self.turned()[1]

    def turned(self):
        """k s_k = sum_{j>0} j u_j c_{k-j}, k c_k = -sum_{j>0} j u_j s_{k-j}"""
        u = list(self)
        s, c = [iv.sin(u[0])], [iv.cos(u[0])]
        for k in range(1, len(u)):
            steps = [j * u[j] / k for j in range(1, k + 1)]
            s.append(sum((d * w for d, w in zip(steps, c[::-1])), iv.mpf(0)))
            c.append(-sum((d * w for d, w in zip(steps, s[k - 1::-1])), iv.mpf(0)))
        return series(s), series(c)

    def size(self, h):
        """sup |sum u_k t^k| over |t| <= h"""
        m, r, e = ball(iv.mpf([0, abs(h).b]))
        total, step, s = 0, (abs(m) + r) << max(e, 0), max(-e, 0)
        for x, y in zip(reversed(self.m), reversed(self.r)):
            total = abs(x) + y - (-total * step >> s)  # upward
        return iv.make_mpf((from_man_exp(total, self.e, BITS, 'c'),) * 2)

    def shift(self, s):
        """Coefficients of p(s + t) in t."""
        m, r = list(self.m), list(self.r)
        sm, sr, e = ball(s)
        a = abs(sm) + sr
        up, down = max(e, 0), max(-e, 0)
        below = (1 << down) - 1
        for i in range(len(m)):
            for j in range(len(m) - 2, i - 1, -1):
                x, y = m[j + 1], r[j + 1]
                to, wide = x * sm << up, (abs(x) * sr + y * a) << up
                m[j] += to >> down
                r[j] += (wide >> down) + 2 * ((to | wide) & below != 0)
        return Series(m, r, self.e)


def series(u):
    """Of intervals."""
    balls = [ball(x) for x in u]
    e = max((e + m.bit_length() for m, _, e in balls if m), default=0) - BITS
    m, r = [], []
    for x, y, k in balls:
        s = k - e
        m.append(x << s if s >= 0 else x >> -s)
        r.append(y << s if s >= 0 else (y >> -s) + 2 * ((x | y) & ((1 << -s) - 1) != 0))
    return Series(m, r, e)


def constant(c, n):
    m, r, e = ball(c)
    s = max(BITS - m.bit_length(), 0)
    return Series([m << s] + [0] * n, [r << s] + [0] * n, e - s)
