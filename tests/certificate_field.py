"""The field of a block on a slope, (17) of Putelat & Dawes (2015), with the law's
formulas as they are typed, and its saddle.
"""
from mpmath import iv

from ball_series import constant
from certificate_formula import Formulas, combine, read
from certificate_tube import ONE, UNIT, ZERO, claim, line


class Plane:
    """A planar field by offsets from self.at: flow(ind, at, dep)."""

    at, rises = None, False

    def jacobian(self, ind, at, dep):
        """Derivatives of the flow by ind and by dep over a box."""
        return ([f[1] for f in self.flow(ind, line(at, ONE, 1), line(dep, ZERO, 1))],
                [f[1] for f in self.flow(ind, line(at, ZERO, 1), line(dep, ONE, 1))])

    def inverse(self):
        """About that of the Jacobian at self.at."""
        (a, c, *_), (b, d, *_) = [[iv.mpf(u.mid) for u in row[:2]]
                                  for row in self.jacobian(0, ZERO, ZERO)]
        det = iv.mpf((a * d - b * c).mid)
        return [[iv.mpf((u / det).mid) for u in row] for row in ((d, -b), (-c, a))]

    def value(self):
        return [f[0] for f in self.flow(0, constant(ZERO, 1), constant(ZERO, 1))[:2]]

    def find(self, x, y):
        """Newton's method, and Krawczyk's operator on a box around where it ends."""
        self.at = iv.mpf(x), iv.mpf(y)
        for _ in range(9):
            C, f = self.inverse(), self.value()
            self.at = tuple(iv.mpf((z - row[0] * f[0] - row[1] * f[1]).mid)
                            for z, row in zip(self.at, C))
        C, f = self.inverse(), self.value()
        for bits in range(iv.prec - 30, 20, -10):
            r = [iv.mpf(2) ** -bits] * 2
            to = self.krawczyk(C, f, r)
            if all(abs(u) < w for u, w in zip(to, r)):
                break
        else:
            claim(False, 'no equilibrium is found near the one that is claimed')
        for _ in range(20):
            to = self.krawczyk(C, f, [iv.mpf(abs(u).b) for u in to])
        self.at = tuple(z + u for z, u in zip(self.at, to))

    def krawczyk(self, C, f, r):
        """Where the equilibrium is that lies within r, as an offset."""
        J = list(zip(*[row[:2] for row in self.jacobian(0, r[0] * UNIT, r[1] * UNIT)]))
        to = []
        for i in (0, 1):
            moved = -C[i][0] * f[0] - C[i][1] * f[1]
            for k in (0, 1):
                rest = int(i == k) - C[i][0] * J[0][k] - C[i][1] * J[1][k]
                moved += rest * r[k] * UNIT
            to.append(moved)
        return to


class Block(Plane):
    """Equations (17) in the chart (x, y) = (ln v, ln psi) or (ln v, psi)."""

    rises = True  # does the manifold

    def __init__(self, law, material, slope):
        self.known = {name: iv.mpf(text) for name, text in material.items()}
        name, text = next(iter(slope.items()))
        angle = iv.mpf(text)
        if name == 'alpha_deg':
            angle = angle * iv.pi / 180
        self.tan = angle if name == 'tan_alpha' else iv.sin(angle) / iv.cos(angle)
        eps2 = self.known['V_star'] ** 2 / (self.known['g'] * self.known['L'])
        self.known.update(tan_alpha=self.tan, eps2=eps2)
        # cos(alpha)/eps^2
        self.force = 1 / (eps2 * iv.sqrt(1 + self.tan ** 2))
        self.is_log = law['state'] == 'real'
        y, a = ('name', 'y'), ('name', 'a')
        mu = read('mu_star + a*ln(v) + b*theta')
        if law['friction'] == 'asinh':
            mu = '*', a, ('asinhexp', ('/', mu, a))
        self.formulas = Formulas({
            'v': ('exp', ('name', 'x')), 'psi': y if self.is_log else ('exp', y),
            'd': 'psi - psi_ss', 'mu': mu, 'K': 'd',
            'rate': '-K/T', **law['formulas']}, self.known)
        tree = self.formulas.tree
        by_y = tree('rate') if self.is_log else self.formulas.less('rate', 'psi')
        self.trees = {'v': tree('v'), 'psi': tree('psi'), 'mu': tree('mu'),
                      'rate': tree('rate'), 'by_y': by_y}
        if 'rate' not in law['formulas']:
            self.trees['psi_ss'] = tree('psi_ss')

    def at_state(self, x, y, *names):
        """Of trees, at x and y of any kind."""
        known, memo = {'x': x, 'y': y}, {}
        return [self.formulas.evaluate(self.trees[name], known, memo) for name in names]

    def flow(self, ind, at, dep):
        """By (ind, dep) from the saddle: both rates and v - v_sp, all times v (and
        psi where y is ln psi)."""
        both = at.plus(self.at[ind]), dep.plus(self.at[1 - ind])
        v, psi, mu, rate = self.at_state(both[ind], both[1 - ind], 'v', 'psi', 'mu', 'rate')
        fx = combine('-', self.tan, mu).times(self.force)
        fy, excess = rate * v, v * v.plus(-self.v)
        if not self.is_log:
            fx, excess = fx * psi, excess * psi
        return (fx, fy, excess) if ind == 0 else (fy, fx, excess)

    def find_saddle(self, v, psi):
        """Theorem 2, of the one equilibrium near there."""
        self.v = iv.mpf(v)
        x, psi = iv.mpf(iv.log(self.v).mid), iv.mpf(psi)
        if 'psi_ss' in self.trees:
            psi, = self.at_state(x, None, 'psi_ss')
        self.find(x, (psi if self.is_log else iv.log(psi)).mid)
        self.v = iv.exp(self.at[0])
        self.psi = self.at[1] if self.is_log else iv.exp(self.at[1])

    def psi_at(self, Y):
        return self.psi + Y if self.is_log else self.psi * iv.exp(Y)

    def eigenvalues(self):
        (xx, yx, _), (xy, yy, _) = self.jacobian(0, ZERO, ZERO)
        unit = self.v if self.is_log else self.v * self.psi
        det, trace = xx * yy - xy * yx, xx + yy
        claim(det < 0, 'det J < 0 at the saddle')
        root, falls = iv.sqrt(trace ** 2 - 4 * det), trace.mid < 0
        away = (trace - root if falls else trace + root) / 2
        both = away / unit, det / away / unit
        return both if falls else both[::-1]
