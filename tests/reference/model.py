"""The friction laws at any number of digits, as the paper writes them."""

import mpmath as mp

mpf = mp.mpf

PRESETS = {  # theta, psi_ss, timescale, kinetics
    'dieterich': ('ln_psi', 'inverse', 'slip', 'linear'),
    'dieterich_gen': ('ln_psi', 'inverse', 'slip', 'sinh'),
    'ruina': ('psi', 'minus_log', 'slip', 'linear'),
    'perrin': ('psi', 'minus_log', 'slip', 'sinh'),
    'spinodal': ('ln_c_psi', 'spinodal', 'spinodal', 'linear'),
    'spinodal_gen': ('ln_c_psi', 'spinodal', 'spinodal', 'sinh'),
    'spinodal_phi_gen': ('ln_c_1pR_psi', 'spinodal_unit', 'spinodal', 'sinh'),
    'kato_tullis': ('ln_psi', 'lambert', 'slip', 'composite'),
}
KEYS = ['mu_star', 'a', 'b', 'L', 'V_star', 'g', 'c', 'R', 'V_c', 'alpha']
COMPONENTS = ['theta', 'psi_ss', 'timescale', 'kinetics']
TABLE_2 = {'mu_star': '0.369', 'a': '0.0349', 'b': '0.0489', 'L': '0.9e-6',
           'V_star': '1e-6', 'g': '9.81', 'c': '1e-3', 'R': '100', 'V_c': '1'}


class Model:
    """One law, one material, one slope, at the current working precision."""

    def __init__(self, row, exact_decimals=False):
        parts = PRESETS.get(row['law']) or [row[k] for k in COMPONENTS]
        self.theta, self.steady_name, self.timescale, self.kinetics = parts
        self.asinh = row['form'] == 'asinh'
        self.is_log = self.theta == 'psi'  # psi itself is a logarithm
        for key in KEYS:
            text = row.get(key) or TABLE_2[key]
            setattr(self, key, mpf(text) if exact_decimals
                    else mpf(float(text)))
        self.eps2 = self.V_star ** 2 / (self.g * self.L)
        self.cos, self.tan = mp.cos(self.alpha), mp.tan(self.alpha)

    # dx/dt and dy/dt as series along the series x, y, on a tape

    def components(self, t, x, y):
        """Series of v, dx/dt and dy/dt."""
        v = t.exp(x)
        psi = y if self.is_log else t.exp(y)
        force = t.linear(self.tan, -1, self.friction(t, x, y, psi))
        fx = t.quotient(t.linear(0, self.cos / self.eps2, force), v)
        rate = self.rate(t, x, y, v, psi)
        return v, fx, rate if self.is_log else t.quotient(rate, psi)

    def friction(self, t, x, y, psi):
        if self.theta in ('ln_psi', 'psi'):
            theta = y
        elif self.theta == 'ln_c_psi':
            theta = t.log(t.linear(self.c, 1, psi))
        else:
            theta = t.log(t.linear(self.c, 1 + self.R, psi))
        if not self.asinh:
            return t.linear(0, 1, t.linear(self.mu_star, self.a, x),
                            self.b, theta)
        # a asinh(v/2 exp((mu_star + b theta)/a)); asinh z = ln(z + sqrt(..))
        w = t.linear(self.mu_star / self.a, 1, x, self.b / self.a, theta)
        z = t.linear(0, mpf(1) / 2, t.exp(w))
        root = t.sqrt(t.linear(1, 1, t.product(z, z)))
        return t.linear(0, self.a, t.log(t.linear(0, 1, z, 1, root)))

    def rate(self, t, x, y, v, psi):
        """dpsi/dt"""
        if self.kinetics == 'composite':  # exp(-v/V_c) - v psi ln(v psi)
            heal = t.exp(t.linear(0, -1 / self.V_c, v))
            slip = t.product(t.product(v, psi), t.linear(0, 1, x, 1, y))
            return t.linear(0, 1, heal, -1, slip)
        steady = self.steady(t, x, v)
        lag = t.linear(0, -1, psi, 1, steady)
        drive = t.sinh(lag) if self.kinetics == 'sinh' else lag
        if self.timescale == 'slip':
            return t.product(drive, v)
        if self.timescale == 'spinodal':  # T = R/(1 + R v)
            return t.product(drive, t.linear(1 / self.R, 1, v))
        if self.timescale == 'ageing44':  # T = R psi_ss
            return t.quotient(t.linear(0, 1 / self.R, drive), steady)
        slow = t.exp(t.linear(0, -1, steady))  # T = R exp(psi_ss)
        return t.product(t.linear(0, 1 / self.R, drive), slow)

    def steady(self, t, x, v):
        """psi_ss(v)"""
        if self.steady_name == 'minus_log':
            return t.linear(0, -1, x)
        if self.steady_name == 'inverse' or mp.isinf(self.R):
            return t.exp(t.linear(0, -1, x))
        top = 1 + self.R if self.steady_name == 'spinodal' else mpf(1)
        one = t.record(lambda k: top if k == 0 else mpf(0))
        return t.quotient(one, t.linear(1, self.R, v))

    # steady states; f: the context of the numbers, mp.mp or mp.fp

    def psi_ss(self, x, f):
        if self.steady_name == 'minus_log':
            return -x
        if self.steady_name == 'lambert':  # v psi ln(v psi) = exp(-v/V_c)
            u = f.exp(-f.exp(x) / f.mpf(self.V_c))
            return f.exp(f.lambertw(u).real - x)
        if self.steady_name == 'inverse' or mp.isinf(self.R):
            return f.exp(-x)
        R = f.mpf(self.R)
        top = 1 + R if self.steady_name == 'spinodal' else 1
        return top / (1 + R * f.exp(x))

    def y_ss(self, x):
        psi = self.psi_ss(x, mp.mp)
        return psi if self.is_log else mp.log(psi)

    def theta_ss(self, x, f):
        psi = self.psi_ss(x, f)
        if self.theta == 'psi':
            return psi
        if self.theta == 'ln_psi':
            return f.log(psi)
        share = f.mpf(self.R) if self.theta == 'ln_c_1pR_psi' else 0
        return f.log(f.mpf(self.c) + (1 + share) * psi)

    def balance(self, x, f=mp.mp):
        """mu_star + a x + b theta_ss less its value where mu = tan(alpha)."""
        a, tau = f.mpf(self.a), f.mpf(self.tan)
        if self.asinh:  # exp(w) = 2 sinh(tan/a)
            tau += a * f.log(1 - f.exp(-2 * tau / a))
        return (f.mpf(self.mu_star) + a * x
                + f.mpf(self.b) * self.theta_ss(x, f) - tau)

    def saddle(self):
        """x where `balance` falls through zero; None if it never does."""
        n = 4000
        grid = [-100.0 + 200.0 * i / n for i in range(n + 1)]
        values = [self.balance(x, mp.fp) for x in grid]
        for i in range(n):
            if values[i] > 0 >= values[i + 1]:
                return self.root(mpf(grid[i]), mpf(grid[i + 1]))
        return None

    def root(self, lo, hi):
        for _ in range(60):
            mid = (lo + hi) / 2
            lo, hi = (mid, hi) if self.balance(mid) > 0 else (lo, mid)
        f_lo, f_hi = self.balance(lo), self.balance(hi)
        for _ in range(20):  # secant
            if f_hi == f_lo or f_hi == 0:
                break
            lo, hi, f_lo = hi, hi - f_hi * (hi - lo) / (f_hi - f_lo), f_hi
            f_hi = self.balance(hi)
        return hi
