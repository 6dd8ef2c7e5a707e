"""Certificates of systems of formulas: equilibria, and theorems 18 and 19 of
docs/proofs.md.
"""
from mpmath import iv

from certificate_field import Plane
from certificate_formula import Formulas, lift
from certificate_tube import ONE, UNIT, ZERO, between, claim, holds, pieces_of, reach, value, walk


class System(Plane):
    """In the chart, where positive states are logarithms; sign -1: backward in time."""

    def __init__(self, system, sign=1):
        constants = {name: iv.mpf(text) for name, text in system['parameters'].items()}
        self.sign, self.states = sign, list(system['rates'])
        self.leaves = ['at ' + name for name in self.states]
        self.is_log = [system['state'][name] == 'positive' for name in self.states]
        texts = dict(system['define'])
        for name, leaf, is_log in zip(self.states, self.leaves, self.is_log):
            texts[name] = ('exp', ('name', leaf)) if is_log else ('name', leaf)
            texts['d ' + name] = system['rates'][name]
        self.formulas = Formulas(texts, constants)
        self.rates = [self.formulas.less('d ' + name, name) if is_log else
                      self.formulas.tree('d ' + name)
                      for name, is_log in zip(self.states, self.is_log)]

    def flow(self, ind, at, dep):
        both, memo = (at.plus(self.at[ind]), dep.plus(self.at[1 - ind])), {}
        known = dict(zip(self.leaves, both if ind == 0 else both[::-1]))
        f = [lift(self.formulas.evaluate(tree, known, memo), at) for tree in self.rates]
        f = f if self.sign > 0 else [-u for u in f]
        return f[ind], f[1 - ind], at.times(ZERO)

    def state(self, axis, z):
        return iv.exp(z) if self.is_log[axis] else z

    def chart(self, axis, state):
        return iv.log(state) if self.is_log[axis] else state

    def eigenvalues(self):
        """[re, im] of both."""
        (xx, yx, _), (xy, yy, _) = self.jacobian(0, ZERO, ZERO)
        square = ((xx - yy) / 2) ** 2 + xy * yx
        re, im = [iv.sqrt(between(max(u.a, 0), max(u.b, 0))) for u in (square, -square)]
        return [((xx + yy) / 2 + k * re, k * im) for k in (-1, 1)]


def find(system, states, turns=(0, 0), sign=1):
    """The equilibrium there, so many periods on."""
    found = System(system, sign)
    middle = [found.chart(axis, iv.mpf(states[axis]).mid) for axis in (0, 1)]
    for axis, n in enumerate(turns):
        chart = system['state'][found.states[axis]]
        if n:
            period = 2 * iv.pi if chart == 'angle' else iv.mpf(chart['angle'])
            middle[axis] += n * period
    found.find(*[z.mid for z in middle])
    return found


def check_rest(system, rest):
    found = find(system, rest['state'])
    for axis, claimed in enumerate(rest['state']):
        claim(holds(claimed, found.state(axis, found.at[axis])), 'an equilibrium')
    for claimed, number in zip(rest['eigenvalues'], found.eigenvalues()):
        claim(all(map(holds, claimed, number)), 'an eigenvalue')


def check_crossing(saddle, branch, pieces):
    """Theorem 18."""
    last, axis = pieces[-1], saddle.states.index(branch['state'])
    line = saddle.chart(axis, iv.mpf(branch['at']))
    at = line - saddle.at[axis]
    theta = ((at - last.start) / last.step if last.ind == axis else
             iv.mpf(branch['pieces'][-1]['cells'][-1][0]))
    error = walk(saddle, pieces, branch, theta)[0][-1][1]
    if last.ind == axis:
        other = value(last.coef, theta) + error * UNIT
    else:
        other = last.at(theta) + reach(saddle, last, theta, at, error)[0] * UNIT
    crossed = [iv.mpf(branch['at']), saddle.state(1 - axis, saddle.at[1 - axis] + other)]
    claim(all(map(holds, branch['leaves'], crossed if axis == 0 else crossed[::-1])),
          'where it leaves')


def falls_in(system, form, x, y, depth=0):
    """Whether z'(Q A + A'Q)z > 0 for all Jacobians A on a box, or on its parts: a
    mean of such matrices is one, too."""
    (fxx, fyx, _), (fxy, fyy, _) = system.jacobian(0, x, y)
    xx, xy, yy = form
    both = xx * fxy + yy * fyx + xy * (fxx + fyy)
    first = 2 * (xx * fxx + xy * fyx)
    if first > 0 and first * 2 * (xy * fxy + yy * fyy) - both ** 2 > 0:
        return True
    return depth < 5 and all(falls_in(system, form, u, w, depth + 1)
                             for u in halves(x) for w in halves(y))


def halves(u):
    return between(u.a, u.mid), between(u.mid, u.b)


def check_trap(saddle, node, branch, pieces):
    """Theorem 19."""
    xx, xy, yy = form = [iv.mpf(q) for q in branch['form']]
    level, det = iv.mpf(branch['level']), xx * yy - xy ** 2
    claim(xx > 0 and det > 0 and level > 0, 'Q > 0')
    size = [iv.sqrt(level * q / det).b for q in (yy, xx)]
    claim(falls_in(node, form, *[r * UNIT for r in size]), 'Q A + A\'Q > 0')
    theta = iv.mpf(branch['pieces'][-1]['cells'][-1][0])
    error = walk(saddle, pieces, branch, theta)[0][-1][1]
    at, dep = pieces[-1].at(theta), value(pieces[-1].coef, theta) + error * UNIT
    offsets = (at, dep) if pieces[-1].ind == 0 else (dep, at)
    x, y = [u + z - w for u, z, w in zip(offsets, saddle.at, node.at)]
    claim((xx * x ** 2 + yy * y ** 2 + 2 * xy * x * y).b <= level, 'it is not in the trap')


def check_system(certificate):
    system, rests = certificate['system'], certificate['equilibria']
    for rest in rests:
        check_rest(system, rest)
    for branch in certificate['branches']:
        if 'not_proved' in branch:
            continue
        sign = {'stable': 1, 'unstable': -1}[branch['kind']]
        saddle = find(system, rests[branch['saddle']]['state'], sign=sign)
        pieces = pieces_of(branch)
        if branch['end'] == 'crosses':
            check_crossing(saddle, branch, pieces)
        else:
            claim(branch['end'] == 'trapped', 'no such end')
            node = find(system, rests[branch['to']]['state'], branch['turns'], sign)
            check_trap(saddle, node, branch, pieces)


def verified_system(certificate):
    system, ends = certificate['system'], [b.get('end', 'not proved')
                                           for b in certificate['branches']]
    words = [f"{name}' = {text}" for name, text in system['rates'].items()]
    return ', '.join(words + [f"{len(certificate['equilibria'])} equilibria"]
                     + [f'{ends.count(end)} branches: {end}' for end in sorted(set(ends))])
