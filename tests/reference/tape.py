"""Taylor series, coefficient by coefficient, to any number of digits."""

import mpmath as mp

mpf = mp.mpf


class Tape:
    """Operations on series; run(k) computes coefficient k of them all.

    A series is a list of coefficients; `weighted` holds i * u_i beside it.
    """

    def __init__(self):
        self.steps = []
        self.weighted = {}

    def forget(self, k):
        """Coefficients from k on."""
        for _, out in self.steps:
            del out[k:]

    def clear(self):
        self.forget(0)

    def run(self, k, redo=False):
        """redo: forget coefficient k first."""
        if redo:
            self.forget(k)
        for step, out in self.steps:
            out.append(step(k))

    def record(self, step):
        out = []
        self.steps.append((step, out))
        return out

    def derivative(self, u):
        """The series i * u_i."""
        if id(u) not in self.weighted:
            self.weighted[id(u)] = self.record(lambda k: k * u[k])
        return self.weighted[id(u)]

    def linear(self, p, q, u, r=0, w=None):
        """p + q u + r w"""
        def step(k):
            value = q * u[k] if w is None else q * u[k] + r * w[k]
            return value + p if k == 0 else value
        return self.record(step)

    def product(self, u, w):
        return self.record(lambda k: mp.fdot(u[:k + 1], w[k::-1]))

    def quotient(self, u, w):
        out = []

        def step(k):
            rest = mp.fdot(out[:k], w[k:0:-1]) if k else 0
            return (u[k] - rest) / w[0]
        self.steps.append((step, out))
        return out

    def exp(self, u):
        du, out = self.derivative(u), []

        def step(k):
            if k == 0:
                return mp.exp(u[0])
            return mp.fdot(du[1:k + 1], out[k - 1::-1]) / k
        self.steps.append((step, out))
        return out

    def log(self, u):
        out, dout = [], []

        def step(k):
            if k == 0:
                return mp.log(u[0])
            return (u[k] - mp.fdot(dout[1:k], u[k - 1:0:-1]) / k) / u[0]
        self.steps.append((step, out))
        self.steps.append((lambda k: k * out[k], dout))
        return out

    def sqrt(self, u):
        out = []

        def step(k):
            if k == 0:
                return mp.sqrt(u[0])
            rest = mp.fdot(out[1:k], out[k - 1:0:-1]) if k > 1 else 0
            return (u[k] - rest) / (2 * out[0])
        self.steps.append((step, out))
        return out

    def sinh(self, u):
        up, down = self.exp(u), self.exp(self.linear(0, -1, u))
        half = mpf(1) / 2
        return self.linear(0, half, up, -half, down)
