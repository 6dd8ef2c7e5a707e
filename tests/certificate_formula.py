"""Formulas as Slipway reads them (docs/formulas.md), over any kind of number: a
class with the operators, of(constant, like) and the functions below as methods;
what is constant is an interval.
"""
import functools
import operator
import re

from mpmath import iv
from mpmath.libmp import mpi_atan

ONE = iv.mpf(1)
WORD = re.compile(r'\s*((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|\w+|[^\s])')
NAME = re.compile(r'[A-Za-z_]\w*$', re.ASCII)
INTERVAL = type(ONE)
REASON = iv.mpf(2) ** 200


def sane(function):
    """For mpmath takes for ever over what a forged formula can make."""
    def run(u):
        if REASON < abs(iv.mpf(u)).b < iv.inf:
            raise ArithmeticError('a number beyond reason')
        return function(u)
    return run


iv.exp, iv.sin, iv.cos = map(sane, (iv.exp, iv.sin, iv.cos))


class Reader:
    """Trees: ('name', NAME), ('number', TEXT), (OPERATION, tree, ...)."""

    def __init__(self, text):
        self.words = WORD.findall(text) + ['']
        self.at = 0

    def take(self, *words):
        if self.words[self.at] not in words:
            return ''
        self.at += 1
        return self.words[self.at - 1]

    def need(self, holds):
        if not holds:
            raise ValueError(f'a formula cannot be read at {self.words[self.at]!r}')

    def row(self, part, *operations):
        tree = part()
        while operation := self.take(*operations):
            tree = operation, tree, part()
        return tree

    def sum(self):
        return self.row(self.product, '+', '-')

    def product(self):
        return self.row(self.sign, '*', '/')

    def sign(self):
        return ('minus', self.sign()) if self.take('-') else self.power()

    def power(self):
        tree = self.atom()
        return ('^', tree, self.sign()) if self.take('^') else tree

    def atom(self):
        if self.take('('):
            tree = self.sum()
            self.need(self.take(')'))
            return tree
        word = self.words[self.at]
        is_name = NAME.match(word)
        self.need(is_name or word[:1].isdigit() or word[:1] == '.' and word != '.')
        self.at += 1
        if is_name and self.take('('):
            tree = word, self.sum()
            self.need(self.take(')'))
            return tree
        return ('name' if is_name else 'number'), word


@functools.lru_cache(None)
def read(text):
    reader = Reader(text)
    tree = reader.sum()
    reader.need(reader.words[reader.at] == '')
    return tree


# ---- constants --------------------------------------------------------------

def atan(u):
    return iv.make_mpf(mpi_atan(u._mpi_, iv.prec))


def asinh(u):
    """Odd and rising."""
    ends = []
    for end in (u.a, u.b):
        z = abs(end)
        m = iv.log(z + iv.sqrt(z * z + 1))
        ends.append(-m if end < 0 else m)
    return iv.mpf([ends[0].a, ends[1].b])


def whole(p):
    """The whole number that a constant is, or None."""
    if not isinstance(p, INTERVAL) or p.a != p.b or abs(p) > 64:
        return None
    n = int(p.a.mid)
    return n if p == n else None


CONSTANT = {
    'exp': iv.exp, 'ln': iv.log, 'sqrt': iv.sqrt, 'sin': iv.sin, 'cos': iv.cos,
    'sinh': lambda u: (iv.exp(u) - iv.exp(-u)) / 2, 'atan': atan, 'asinh': asinh,
    'cosh': lambda u: (iv.exp(u) + iv.exp(-u)) / 2,
}


def function(name, u):
    if name == 'abs2':
        return u * u
    if name == 'log10':
        return combine('/', function('ln', u), iv.log(iv.mpf(10)))
    if name == 'tan':
        return function('sin', u) / function('cos', u)
    if name == 'tanh':
        return function('sinh', u) / function('cosh', u)
    if name == 'asin':
        return function('atan', u / function('sqrt', combine('-', ONE, u * u)))
    if name == 'acos':
        return combine('-', iv.pi / 2, function('asin', u))
    return CONSTANT[name](u) if isinstance(u, INTERVAL) else getattr(u, 'to_' + name)()


def lift(c, like):
    return like.of(c, like) if isinstance(c, INTERVAL) and not isinstance(
        like, INTERVAL) else c


def product_of(u, n):
    return functools.reduce(operator.mul, n * [u], lift(ONE, u))


def power(u, p):
    n = whole(p)
    if n is None:
        return function('exp', combine('*', p, function('ln', u)))
    if isinstance(u, INTERVAL):
        out = u ** abs(n)
    else:
        out = u.to_power(abs(n)) if hasattr(u, 'to_power') else product_of(u, abs(n))
    return lift(ONE, u) / out if n < 0 else out


def combine(operation, u, w):
    """Of two numbers; one of them may be a constant."""
    if isinstance(u, INTERVAL) and not isinstance(w, INTERVAL):
        if operation in '+-':
            return (w if operation == '+' else -w).plus(u)
        return w.times(u) if operation == '*' else lift(u, w) / w
    if isinstance(w, INTERVAL) and not isinstance(u, INTERVAL):
        if operation in '+-':
            return u.plus(w if operation == '+' else -w)
        return u.times(w if operation == '*' else 1 / w)
    return (u + w if operation == '+' else u - w if operation == '-' else
            u * w if operation == '*' else u / w)


# ---- formulas by their names ------------------------------------------------

class Formulas:
    """Texts that may use one another, constants, and x, y; as trees in which
    logarithms are taken as far as they go."""

    def __init__(self, texts, constants):
        self.texts, self.constants = texts, dict(constants, pi=iv.pi)
        self.trees = {}

    def tree(self, name):
        if name not in self.trees:
            text = self.texts[name]
            self.trees[name] = self.expand(read(text) if isinstance(text, str) else text)
        return self.trees[name]

    def expand(self, tree):
        if tree[0] == 'number':
            return tree
        if tree[0] == 'name':
            return self.tree(tree[1]) if tree[1] in self.texts else tree
        kind, *of = tree[0], *map(self.expand, tree[1:])
        if kind == 'ln':
            return self.log(of[0])
        if kind == 'asinh' and self.is_positive(of[0]):
            return 'asinhexp', self.log(('*', ('number', '2'), of[0]))
        if kind == '/' and of[1][0] == '/':
            return '/', ('*', of[0], of[1][2]), of[1][1]
        return (kind, *of)

    def constant(self, tree):
        """None: it is not one."""
        if tree[0] == 'number':
            return iv.mpf(tree[1])
        return self.constants.get(tree[1]) if tree[0] == 'name' else None

    def is_positive(self, tree):
        kind, c = tree[0], self.constant(tree)
        return (kind in ('exp', 'asinhexp') or c is not None and c > 0
                or kind == '^' and self.is_positive(tree[1])
                or kind in '+*/' and all(map(self.is_positive, tree[1:])))

    def log(self, tree):
        kind = tree[0]
        if kind == 'exp':
            return tree[1]
        if kind in '*/' and self.is_positive(tree):
            return ('+' if kind == '*' else '-', *map(self.log, tree[1:]))
        if kind == '^' and self.is_positive(tree[1]):
            return '*', tree[2], self.log(tree[1])
        return 'ln', tree

    def less(self, name, factor):
        """A tree that is `name` over `factor`, which is taken out where it is seen."""
        return take_out(self.tree(name), self.tree(factor)) or (
            '/', self.tree(name), self.tree(factor))

    def evaluate(self, tree, known, memo):
        """known: x and y, numbers of any kind; memo: of one call for each."""
        if id(tree) not in memo:
            memo[id(tree)] = self.value(tree, known, memo)
        return memo[id(tree)]

    def value(self, tree, known, memo):
        kind = tree[0]
        if kind == 'name':
            return known[tree[1]] if tree[1] in known else self.constants[tree[1]]
        if kind == 'number':
            return iv.mpf(tree[1])
        of = [self.evaluate(part, known, memo) for part in tree[1:]]
        if kind == '^':
            return power(*of)
        if kind == 'minus':
            return -of[0]
        return combine(kind, *of) if kind in '+-*/' else function(kind, of[0])


def take_out(tree, factor):
    """The tree without a factor, or None where it is not seen to have it."""
    if tree == factor:
        return 'number', '1'
    if tree[0] not in ('+', '-', '*', '/', 'minus'):
        return None
    of = [take_out(part, factor) for part in tree[1:]]
    if tree[0] in ('+', '-', 'minus'):
        return (tree[0], *of) if all(of) else None
    for i in range({'*': 2, '/': 1}[tree[0]]):
        if of[i]:
            return (*tree[:i + 1], of[i], *tree[i + 2:])
    return None
