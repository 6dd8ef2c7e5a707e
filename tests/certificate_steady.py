"""Theorems 14, 15 and 20 of docs/proofs.md, of laws whose parts are those of (2)-(10),
(44), (45): where mu_ss can fall, that no saddle is there, where all states go.
"""
from mpmath import iv

from certificate_formula import Formulas
from certificate_tube import ONE, ZERO, between, claim, value

NAMED = {
    'theta': {'ln(psi)', 'psi', 'ln(c + psi)', 'ln(c + (1 + R)*psi)'},
    'psi_ss': {'1/v', '(1 + R)/(1 + R*v)', '1/(1 + R*v)', '-ln(v)'},
    'T': {'1/v', 'R/(1 + R*v)', 'R*psi_ss', 'R*exp(psi_ss)'}, 'K': {'d', 'sinh(d)'},
}


class Ratio:
    """Of polynomials of v."""

    def __init__(self, over, under=(ONE,)):
        self.over, self.under = list(over), list(under)

    @staticmethod
    def of(c, _):
        return Ratio([c])

    def plus(self, c):
        return self + Ratio([c])

    def times(self, c):
        return Ratio([c * u for u in self.over], self.under)

    def __add__(self, w):
        return Ratio(add(multiply(self.over, w.under), multiply(w.over, self.under)),
                     multiply(self.under, w.under))

    def __truediv__(self, w):
        return Ratio(multiply(self.over, w.under), multiply(self.under, w.over))


def add(u, w):
    n = max(len(u), len(w))
    return [x + y for x, y in zip(u + [ZERO] * (n - len(u)), w + [ZERO] * (n - len(w)))]


def multiply(u, w):
    out = [ZERO] * (len(u) + len(w) - 1)
    for i, x in enumerate(u):
        for k, y in enumerate(w):
            out[i + k] += x * y
    return out


def slope(u):
    """v du/dv"""
    return [k * x for k, x in enumerate(u)]


def check_named(law):
    formulas = law['formulas']
    claim(set(formulas) == set(NAMED), 'not a law of named parts')
    for part, texts in NAMED.items():
        claim(formulas[part] in texts, part, 'is not a named one')
    claim((law['state'] == 'real') == (formulas['theta'] == 'psi'), 'state')


class Steady:
    """tau = mu_star + a ln v + b theta(psi_ss), by which mu_ss rises."""

    def __init__(self, block, law):
        check_named(law)
        self.get, self.asinh = block.known, law['friction'] == 'asinh'
        self.plain = law['state'] == 'real'
        claim(law['formulas']['psi_ss'] != '-ln(v)', 'psi_ss is not of that kind')
        get = self.get
        claim(get['a'] > 0 and get['b'] > 0 and get.get('R', ONE) > 0
              and get.get('c', ZERO) >= 0, 'a parameter is out of range')
        formulas = Formulas({'psi': 'psi_ss', 'psi_ss': law['formulas']['psi_ss'],
                             'theta': law['formulas']['theta']}, get)
        tree = formulas.tree('theta')
        tree = tree if self.plain else tree[1]
        ratio = formulas.evaluate(tree, {'v': Ratio([ZERO, ONE])}, {})
        P, Q = self.P, self.Q = ratio.over, ratio.under
        claim(all(u >= 0 for u in P + Q), 'psi_ss is not positive')
        across = add(multiply(slope(P), Q), [-u for u in multiply(P, slope(Q))])
        self.falls = add([get['a'] * u for u in multiply(Q if self.plain else P, Q)],
                         [get['b'] * u for u in across])
        self.tan = block.tan

    def fall(self, x):
        """Of the sign of dtau/dx."""
        return value(self.falls, iv.exp(x))

    def tau(self, x):
        v = iv.exp(x)
        ratio = value(self.P, v) / value(self.Q, v)
        theta = ratio if self.plain else iv.log(ratio)
        return self.get['mu_star'] + self.get['a'] * x + self.get['b'] * theta

    def level(self):
        """tau where mu_ss = tan(alpha)"""
        a, t = self.get['a'], self.tan
        return t + a * iv.log(1 - iv.exp(-2 * t / a)) if self.asinh else t

    def ends(self):
        """Whether psi_ss is bounded as v -> 0, theta(psi_ss) as v -> infinity."""
        top = [max(k for k, u in enumerate(w) if u > 0) for w in (self.P, self.Q)]
        return self.Q[0] > 0, self.plain or top[0] == top[1]


def nodes(block, law):
    """Theorem 14: of the slow and the fast side."""
    if law['formulas']['psi_ss'] == '-ln(v)' and law['state'] == 'real':
        check_named(law)
        return False, False
    return Steady(block, law).ends()


def end_of(fast, node):
    return 'node' if node else 'v_infinity' if fast else 'v_0'


def check_alone(block, law, claimed):
    """Theorems 15 and 20.  dtau/dx is < 0 on one interval of v at most, as no
    coefficient but that of v can be; there it goes from one end of tau to the other."""
    steady, tau = Steady(block, law), claimed['tau']
    C, B, A = steady.falls + [ZERO] * (3 - len(steady.falls))
    claim(A >= 0 and C >= 0, 'dtau/dx may change its sign more often')
    if tau == 'rises':
        claim(B >= 0 or 4 * A * C > B ** 2, 'mu_ss may fall')
        steep = block.known['a'] > block.known['b']
        bounded = [steady.ends()[0], steady.ends()[1] and not steady.plain]
        fate = 'node' if all(u or steep or k and steady.plain
                             for k, u in enumerate(bounded)) else None
    else:
        lo, hi = [iv.mpf(x) for x in claimed['window']]
        claim(tau in ('below', 'above') and lo < hi, 'no such window')
        sign = 1 if tau == 'below' else -1
        claim(sign * steady.fall(lo) > 0 and sign * steady.fall(hi) < 0,
              'mu_ss has no such extremum in the window')
        claim(sign * (steady.level() - steady.tau(between(lo, hi))) > 0,
              'mu_ss may pass tan(alpha)')
        fast = tau == 'below'
        fate = end_of(fast, steady.ends()[fast])
    claim(claimed.get('fate') in (None, fate), 'not all states go there')
