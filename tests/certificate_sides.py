"""Theorems 12 to 14 of docs/proofs.md: on which side of the manifold the cells of a
grid lie, and what becomes of a side.
"""
from mpmath import iv

from certificate_steady import end_of, nodes
from certificate_tube import UNIT, claim, value


class Branch:
    """Parts of a tube, outward: [t], theta in units of each, until `settles`."""

    def __init__(self, pieces, branch, settles, rises):
        kappa, reach = iv.mpf(branch['cone']['slope']), branch['cone']['reach']
        self.parts = [(pieces[0], 0.0, reach, lambda theta: kappa * theta)]
        self.end, self.settles, self.rises = branch['end'], settles, rises
        a = reach
        for piece, j in zip(pieces, branch['pieces']):
            for b, radius, _, _ in j['cells']:
                self.parts.append((piece, a, b, lambda _, r=iv.mpf(radius): r))
                a = b
            a = 0.0

    def place(self, t):
        """(X, Y), intervals."""
        k = min(int(t), len(self.parts) - 1)
        piece, a, b, error = self.parts[k]
        theta = iv.mpf(min(a + (t - k) * (b - a), b))
        at, dep = piece.at(theta), value(piece.coef, theta) + error(theta) * UNIT
        return (at, dep) if piece.ind == 0 else (dep, at)

    def beside(self, Y, above):
        """Places near the row Y that are above it, or below, with their tube."""
        lo, hi = 0.0, float(len(self.parts))
        for _ in range(64):
            t = (lo + hi) / 2
            y = self.place(t)[1]
            is_above = bool(y > Y) if above else not y < Y
            lo, hi = (lo, t) if is_above == self.rises else (t, hi)
        found = [self.place(t) for t in (lo, hi)]
        return [p for p in found if (p[1] > Y if above else p[1] < Y)]


def is_slow(x, Y, upper, lower):
    """Left of the point where the manifold meets the row."""
    if lower.end == 'psi_0' and x < lower.settles.a:
        return True
    return any(x < X for b in (upper, lower) for X, _ in b.beside(Y, False))


def is_fast(x, Y, upper, lower):
    if upper.end == 'psi_inf' and x > upper.settles.b:
        return True
    if lower.end == 'v_0' and Y < lower.settles.a:
        return True
    return any(x > X for b in (upper, lower) for X, _ in b.beside(Y, True))


def check_labels(block, law, claimed, upper, lower):
    for side, node in zip(('slow', 'fast'), nodes(block, law)):
        claim(claimed[side] == end_of(side == 'fast', node), 'what becomes of a side')
    xs = [iv.log(iv.mpf(v)) - block.at[0] for v in claimed['v']]
    claim(all(u < w for u, w in zip(xs, xs[1:])), 'columns are not in order')
    for psi, (slow, fast) in zip(claimed['psi'], claimed['rows'], strict=True):
        y = iv.mpf(psi) if block.is_log else iv.log(iv.mpf(psi))
        Y = y - block.at[1]
        claim(0 <= slow <= fast <= len(xs), 'columns of a row')
        claim(slow == 0 or is_slow(xs[slow - 1], Y, upper, lower),
              f'psi = {psi}: the slow side')
        claim(fast == len(xs) or is_fast(xs[fast], Y, upper, lower),
              f'psi = {psi}: the fast side')
