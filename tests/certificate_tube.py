"""The conditions of docs/proofs.md's theorems 3 to 5: the cone, the tube, its joins.
"""
import functools

from mpmath import iv

from ball_series import series

ORDER = 20        # of Taylor expansions
PARTS = 16        # of a cell, at most
ZERO, ONE, UNIT = iv.mpf(0), iv.mpf(1), iv.mpf([-1, 1])


class Wrong(Exception):
    """A claim that does not follow."""


def claim(holds, *what):
    if not holds:
        raise Wrong(' '.join(str(w) for w in what))


def attempt(run, *of):
    """None where a box is too large for an enclosure to be of use."""
    try:
        return run(*of)
    except (Wrong, ArithmeticError, ValueError):
        return None


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
    total, to, below = ZERO, w, u
    for j in range(len(q)):
        total += q[j] * (to - below) / (j + 1)
        to, below = to * w, below * u
    return total


def line(at, step, n):
    return series([at, step] + [ZERO] * (n - 1))


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

def sides(block, piece, reach, kappa, count):
    """In the cone: g, and theta times the slope by dep of the excess per theta, by
    mean values of the Jacobian from the saddle: up to a part they are between those
    up to the last one and the Jacobian on it."""
    step, mean, found = piece.step, None, None
    for i in range(count):
        box = between(iv.mpf(reach) * i / count, iv.mpf(reach) * (i + 1) / count)
        sigma = value(piece.coef[1:], box) + kappa * UNIT
        here = block.jacobian(piece.ind, step * box, sigma * box)
        far = here if i == 0 else [list(map(hull, *rows)) for rows in zip(mean, here)]
        mean = here if i == 0 else [[(i * u + w) / (i + 1) for u, w in zip(*rows)]
                                    for rows in zip(mean, here)]
        m, d, e = [step * u + sigma * w for u, w in zip(*far)]
        claim(step * m < 0, 'theta does not fall in the cone')
        now = [step * (here[1][k] - u / m * here[1][0]) / m for k, u in ((1, d), (2, e))]
        found = now if found is None else list(map(hull, found, now))
    return found


@functools.lru_cache(None)
def check_cone(block, piece, reach, slope, excess):
    """Answers a bound of |dep - p| at its end."""
    claim(0 < reach <= 1 and slope > 0, 'the cone has no size')
    claim(piece.start == 0 and piece.coef[0] == 0, 'the cone is not at the saddle')
    for count in (1, 4, 16, 64):
        found = attempt(cone_in_parts, block, piece, reach, slope, excess, count)
        if found is not None:
            return found
    raise Wrong('the cone does not follow')


def cone_in_parts(block, piece, reach, slope, excess, count):
    """At least so many."""
    kappa = iv.mpf(slope)
    g, across = sides(block, piece, reach, kappa, count)
    claim(g < 1, 'g < 1 fails in the cone')
    total, parts = ZERO, [(0, reach)]
    while parts:
        a, b = parts.pop()
        middle = (a + b) / 2
        if a == 0:
            at, found = a, attempt(near_saddle, block, piece, b)
        else:
            at, found = middle, attempt(on_part, block, piece, a, b)
        if found is not None and found[0] < kappa * (1 - g.b) and b - a <= reach / count:
            total += (integral(found[1], a - iv.mpf(at), b - iv.mpf(at))
                      + found[2] * (b - iv.mpf(a)))
            continue
        claim(b - a > reach / 2 ** 10, '|D| < kappa (1 - g) fails in the cone')
        parts += [(a, middle), (middle, b)]
    error = (kappa * reach).b
    claim(holds(excess, abs(across).b * error * UNIT - piece.step * total),
          'the integral in the cone does not follow')
    return error


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
    most = (error + made) * larger
    if not most <= radius:
        return None
    beside = abs(across[1]).b * most.b
    middle = iv.mpf((a + b) / 2)
    total = integral(q, a - middle, a + length - middle)
    total += (rest + beside * UNIT) * length
    return (rise * error + made * larger).b, -piece.step * total


@functools.lru_cache(None)
def check_cell(block, piece, a, b, end, error, radius, after, excess, count):
    """On a cell, in as many parts as the claims take, which is answered."""
    while count <= PARTS:
        borders = [a + (b - a) * i / count for i in range(count)] + [b]
        e, total, found = iv.mpf(error), ZERO, ()
        for u, w in zip(borders, borders[1:]):
            found = attempt(part, block, piece, u, w, end, e, iv.mpf(radius))
            if found is None:
                break
            e, total = found[0], total + found[1]
        if found and e <= iv.mpf(after) and holds(excess, total):
            return count
        count *= 2
    raise Wrong(f'theta {a} .. {b}: tube and integral do not follow')


# ---- from piece to piece: theorem 5 -----------------------------------------

def join(piece, following, end, error):
    return (error + abs(value(piece.coef, end) - following.coef[0]).b).b


def reach(block, piece, theta, target, error):
    """From theta to where dep is in `target`: how far ind goes, and the excess."""
    at, dep = piece.at(theta), value(piece.coef, theta) + error * UNIT
    gap = abs(target - dep).b
    dep, way = hull(dep, target), ZERO
    for _ in range(20):
        G, q = aside(block, piece, at + way * UNIT, dep)
        claim(G[0] > 0 or G[0] < 0 and not block.rises, 'the slope has no sign at a turn')
        found = (gap / abs(G[0]).a).b
        if found < way:
            return found, abs(q[0]).b * found * UNIT
        way = 2 * found + iv.mpf('1e-290')
    raise Wrong('no box around a turn')


# ---- along a branch ---------------------------------------------------------

def begin(block, pieces, branch):
    c = branch['cone']
    return check_cone(block, pieces[0], c['reach'], c['slope'], tuple(c['excess']))


def walk(block, pieces, branch, last):
    """Along the cells, of the last piece up to theta = last: the errors at the
    beginning and the end of each piece, and the integral."""
    error, a = begin(block, pieces, branch), branch['cone']['reach']
    total, errors, parts = iv.mpf(branch['cone']['excess']), [], 1
    for i, (piece, j) in enumerate(zip(pieces, branch['pieces'])):
        following = pieces[i + 1] if i + 1 < len(pieces) else None
        turns = following is not None and following.ind != piece.ind
        end = (last if following is None else ONE if turns else
               (following.start - piece.start) / piece.step)
        first = error
        for b, radius, after, excess in j['cells']:
            claim(a < b, 'cells are not in order')
            parts = check_cell(block, piece, a, b, end, error, radius, after,
                               tuple(excess), max(1, parts // 2))
            a, error, total = b, iv.mpf(after), total + iv.mpf(excess)
        claim(iv.mpf(a) >= end.b, 'a piece is not covered by its cells')
        errors.append((first, error))
        if following is None:
            return errors, total
        a = 0.0
        if turns:
            way, more = reach(block, piece, ONE, following.start, error)
            error = (way + abs(piece.at(ONE) - following.coef[0]).b).b
            total += more
        else:
            error = join(piece, following, end, error)
    raise Wrong('a branch without pieces')


def pieces_of(branch):
    return [make_piece(j['independent'], j['start'], j['step'], tuple(j['coef']))
            for j in branch['pieces']]


@functools.lru_cache(None)
def make_piece(*parts):
    return Piece(*parts)
