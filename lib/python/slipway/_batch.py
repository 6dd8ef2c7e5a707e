"""A few numbers of very many materials and slopes at once."""
import itertools
import math
import operator

from . import _c
from ._arrays import Numbers, arrays, filled, numpy, reals
from ._scene import keys_of, named, scene_of

library = _c.library


class Table(dict):
    """Numbers, each an array, by name."""

    def frame(self):
        """Value and error of each, as a pandas.DataFrame."""
        import pandas
        return pandas.DataFrame({
            name + part: getattr(found, field).ravel()
            for name, found in self.items()
            for part, field in (('', 'value'), ('_error', 'error'))})


def texts(keys):
    return (_c.text * len(keys))(*(key.encode() for key in keys))


def varied(keys):
    """The keys whose values are arrays, these side by side, their shape."""
    given = {key: value for key, value in keys.items()
             if '.' in key and numpy and numpy.ndim(value)}
    columns = arrays().broadcast_arrays(*map(reals, given.values()))
    shape = columns[0].shape if columns else ()
    return (list(given), [numpy.ascontiguousarray(column).ravel()
                          for column in columns], shape)


def drawn(path, fixed, names, keys, threads=0):
    """{name: its numbers}; arrays among the keys vary."""
    keys, names = named(keys), [names] if isinstance(names, str) else names
    vary, columns, shape = varied(keys)
    rest = {key: value for key, value in keys.items() if key not in vary}
    scene = scene_of(path, {**fixed, **keys_of(**rest)})
    batch = _c.begin('batch', 'open', scene, texts(vary), len(vary),
                     texts(names), len(names))
    found = run(batch, len(names), math.prod(shape), columns, threads)
    words = numpy.array([None, *reasons(batch)], object)
    told = [Numbers(value, error, words[reason])
            for value, error, reason in found]
    return Table((name, numbers.reshape(shape) if shape else numbers[0])
                 for name, numbers in zip(names, told))


def run(batch, names, count, columns, threads):
    """Of each name its values, errors and reasons by number."""
    found = [[filled(kind, count) for kind in (_c.real, _c.real, _c.byte)]
             for _ in range(names)]
    out = (_c.Column * names)(*(tuple(at for _, at in one) for one in found))
    into = (_c.to(_c.real) * len(columns))(
        *(column.ctypes.data_as(_c.to(_c.real)) for column in columns))
    fault = _c.Fault()
    _c.check(_c.interruptible(lambda monitor: library.batch_run(
        batch, count, into, operator.index(threads), monitor, out, fault)),
        fault)
    return [[array for array, _ in one] for one in found]


def reasons(batch):
    """Those that were given, from the first on."""
    told = (library.batch_reason(batch, k) for k in range(1, 256))
    return [text.decode() for text in itertools.takewhile(bool, told)]


def numbers(names, law=None, alpha=None, *, threads=0, **keys):
    """Numbers by name, of a law at keys that are numbers or arrays.

    >>> both = numbers(["v_plus", "x_excess"], law="dieterich_gen",
    ...                alpha=[0.33, 0.34], a=0.035)
    >>> both["v_plus"]
    <2 numbers, 2 exist>
    """
    return drawn(None, {}, names, {'law': law, 'alpha': alpha, **keys},
                 threads)


def _one(name, what):
    def of(law=None, alpha=None, *, threads=0, **keys):
        return numbers([name], law, alpha, threads=threads, **keys)[name]
    of.__name__ = of.__qualname__ = name
    of.__doc__ = f"""{what}, of a law at keys that are numbers or arrays."""
    return of


v_plus = _one('v_plus', 'The critical slip rate, the limit as psi -> infinity')
v_minus = _one('v_minus', 'The critical slip rate, the limit as psi -> 0')
x_excess = _one('x_excess', 'The persistence length of the upper branch')
