"""Theorem 6 of docs/proofs.md: formulas over boxes of (x, y) that may have no end.
A number is e^(p x + q y) c + s x + r y there, and in `all`; what is known of a
formula is that of its value, of its derivative by one variable, and of its
logarithm's.
"""
from fractions import Fraction

from mpmath import iv

from certificate_formula import asinh, product_of

ZERO, ONE, PART = iv.mpf(0), iv.mpf(1), iv.mpf([0, 1])
ALL = iv.mpf(['-inf', 'inf'])
NONE = (Fraction(0), Fraction(0))


def is_zero(u):
    return u.a == 0 and u.b == 0


def has_zero(u):
    return not (u > 0 or u < 0)


def is_finite(u):
    return u.a > -iv.inf and u.b < iv.inf


def product(u, w):
    return ZERO if is_zero(u) or is_zero(w) else u * w


def quotient(u, w):
    """0 is no denominator."""
    return ALL if has_zero(w) else ZERO if is_zero(u) else u / w


def meet(u, w):
    return iv.mpf([max(u.a, w.a), min(u.b, w.b)])


def total(u, w):
    """Of two of one sign at least as large as either."""
    out = u + w
    lo, hi = out.a, out.b
    if u >= 0 and w >= 0:
        lo = max(lo, u.a, w.a)
    if u <= 0 and w <= 0:
        hi = min(hi, u.b, w.b)
    return iv.mpf([lo, hi])


def plus(u, w):
    return u[0] + w[0], u[1] + w[1]


class Grow:
    def __init__(self, box, power, slope, c, all_=ALL):
        self.box, self.power, self.slope = box, power, slope
        self.all = meet(all_, product(c, iv.exp(self.form(power))) + self.form(slope))
        self.c = c if any(power + slope) else self.all

    def form(self, u):
        return sum((iv.mpf(k.numerator) / k.denominator * at
                    for k, at in zip(u, self.box) if k), ZERO)

    def number(self, c):
        return Grow(self.box, NONE, NONE, c)

    def level(self):
        """Without slopes."""
        return self.number(self.all) if any(self.slope) else self

    def scaled(self, w):
        """Times an exact number; None: not of that kind."""
        if not any(self.slope) or any(w.power + w.slope) or w.c.a != w.c.b:
            return None
        sign, man, exp, _ = w.c.a._mpi_[0]
        k = Fraction(man) * Fraction(2) ** exp * (-1) ** sign
        return Grow(self.box, NONE, tuple(k * s for s in self.slope),
                    product(self.c, w.c), product(self.all, w.all))

    def __mul__(self, w):
        out = self.scaled(w) or w.scaled(self)
        if out is None:
            u, v = self.level(), w.level()
            out = Grow(self.box, plus(u.power, v.power), NONE, product(u.c, v.c),
                       product(self.all, w.all))
        return out

    def __truediv__(self, w):
        u, v = self.level(), w.level()
        return Grow(self.box, plus(u.power, tuple(-p for p in v.power)), NONE,
                    quotient(u.c, v.c), quotient(self.all, w.all))

    def __neg__(self):
        return Grow(self.box, self.power, tuple(-s for s in self.slope), -self.c,
                    -self.all)

    def __add__(self, w):
        """By the powers with which neither term grows where the box has no end."""
        if is_zero(self.all) or is_zero(w.all):
            return w if is_zero(self.all) else self
        u, v = self, w
        if any(u.power + v.power):
            u, v = u.level(), v.level()
        power = tuple(max(p, q) if at.a > -iv.inf else min(p, q)
                      for p, q, at in zip(u.power, v.power, self.box))
        c = [product(t.c, iv.exp(self.form(tuple(p - q for p, q in zip(t.power, power)))))
             for t in (u, v)]
        return Grow(self.box, power, plus(u.slope, v.slope), total(*c),
                    total(u.all, v.all))

    def __sub__(self, w):
        return self + -w

    def or_by(self, w):
        """By what is as large, too, whose form is its own where that has no bound."""
        u = self if is_finite(self.c) else w
        return Grow(self.box, u.power, u.slope, u.c, meet(w.all, self.all))


class Jet:
    """Value, derivative, that of the logarithm of its size."""

    def __init__(self, value, by, rate):
        self.value, self.by = value, by.or_by(value * rate)
        self.rate = rate if has_zero(value.all) else rate.or_by(self.by / value)

    @staticmethod
    def variable(box, which, by):
        slope = tuple(Fraction(k == which) for k in (0, 1))
        value = Grow(box, NONE, slope, ZERO, box[which])
        one = value.number(ONE if which == by else ZERO)
        return Jet(value, one, one / value)

    @staticmethod
    def of(c, like):
        value, zero = like.value.number(c), like.value.number(ZERO)
        return Jet(value, zero, zero)

    def __neg__(self):
        return Jet(-self.value, -self.by, self.rate)

    def plus(self, c):
        return self + Jet.of(c, self)

    def times(self, c):
        return self * Jet.of(c, self)

    def __sub__(self, w):
        return self + -w

    def __add__(self, w):
        """(ln |u + w|)' = (ln |u|)' + ((ln |w|)' - (ln |u|)') r/(1 + r), r = w/u"""
        if is_zero(self.value.all) or is_zero(w.value.all):
            return w if is_zero(self.value.all) else self
        u, v = (w, self) if has_zero(self.value.all) else (self, w)
        r = (v.value / u.value).all
        part = meet(quotient(r, ONE + r), ONE - quotient(ONE, ONE + r))
        rate = u.rate.number(ALL) if has_zero(ONE + r) else (
            u.rate + u.rate.number(part) * (v.rate - u.rate))
        return Jet(self.value + w.value, self.by + w.by, rate)

    def __mul__(self, w):
        return Jet(self.value * w.value, self.by * w.value + self.value * w.by,
                   self.rate + w.rate)

    def __truediv__(self, w):
        q = self.value / w.value
        return Jet(q, (self.by - q * w.by) / w.value, self.rate - w.rate)

    def to_exp(self):
        """Of slopes a power."""
        u = self.value
        value = Grow(u.box, u.slope, NONE, iv.exp(u.c if any(u.slope) else u.all),
                     iv.exp(u.all))
        return Jet(value, value * self.by, self.by)

    def to_ln(self):
        """Of a power slopes."""
        u = self.value.level()
        if not u.c > 0:
            raise ArithmeticError('a logarithm of what may be 0')
        value = Grow(u.box, NONE, u.power, iv.log(u.c),
                     iv.log(u.all) if u.all > 0 else ALL)
        return Jet(value, self.rate, self.rate / value)

    def to_power(self, n):
        """Of u > 0 a product; else n u^(n - 1) u' and n (ln |u|)'."""
        u = self.value
        if n == 0 or u.level().c > 0:
            return product_of(self, n)
        size = iv.mpf(n)
        return Jet(u.number(u.all ** n), u.number(size * u.all ** (n - 1)) * self.by,
                   u.number(size) * self.rate)

    def to_sqrt(self):
        return self.to_ln().times(ONE / 2).to_exp()

    def function(self, value, slope, rate):
        """f(u), f'(u), and f'(u)/f(u) or None."""
        value, by = self.value.number(value), self.value.number(slope) * self.by
        return Jet(value, by, by / value if rate is None else
                   self.value.number(rate) * self.by)

    def to_sinh(self):
        """coth falls to 1 as |u| grows."""
        u = self.value.all
        up, down = iv.exp(u), iv.exp(-u)
        coth = None
        if not has_zero(u):
            e = iv.exp(-2 * abs(u))
            coth = (1 + e) / (1 - e) * (1 if u > 0 else -1)
        return self.function((up - down) / 2, (up + down) / 2, coth)

    def to_asinh(self):
        """Of a slope between 0 and 1."""
        return self.function(asinh(self.value.all), PART, None)

    def to_asinhexp(self):
        """asinh(e^u/2)"""
        u = self.value.all
        ends = [z if abs(z) == iv.inf else asinh(iv.exp(z) / 2) for z in (u.a, u.b)]
        lo = ZERO if u.a == -iv.inf else ends[0]
        return from_log(iv.mpf([lo.a, ends[1].b]), self.by)


def from_log(m, by):
    """m = asinh(e^u/2): m' = tanh(m) u', and 0 <= tanh(m)/m <= 1"""
    e = iv.exp(-2 * abs(m))
    tanh = (1 - e) / (1 + e)
    tanh = tanh if m.a >= 0 else -tanh if m.b <= 0 else iv.mpf([-tanh.b, tanh.b])
    return Jet(by.number(m), by.number(tanh) * by, by.number(PART) * by)
