"""A block on a slope: its numbers, manifolds, basins and pushes."""
import functools
import os
from collections import namedtuple

from . import _c, _show
from ._arrays import Numbers, filled, lent, numpy, reals
from ._batch import drawn
from ._basin import FATES, basin_of
from ._number import number
from ._scene import keys_of, named, scene_of
from ._sweep import labels, swept

library = _c.library
TYPES = ('saddle', 'stable_node', 'saddle_node', 'unstable_node', 'focus')
BRANCHES = ('stable_upper', 'stable_lower', 'unstable_upper', 'unstable_lower')
KNEES = '[equilibria, folds, knees, estimates]'

Equilibrium = namedtuple('Equilibrium',
                         'type v psi mu lambda_minus lambda_plus')
Branch = namedtuple('Branch', [name for name, _ in _c.Point._fields_])
Push = namedtuple('Push', 'fate slip time mu_mean v_kick psi_kick')


class Study:
    """A friction law on a slope, or a scene.

    Keywords are keys of a scene: those of `material` and `slope` and a law's
    name stand alone, sections are dictionaries, and what has a dot goes in
    `**{"accuracy.rtol": 1e-9}`.  Each number is an attribute.

    >>> s = Study(law="dieterich_gen", alpha=0.34)
    >>> print(f"{s.v_plus:.6f}, within {s.v_plus.error:.0e}")
    2832.223359, within 2e-10
    >>> s.psi_at_v0.reason
    'the lower branch ends at v_minus > 0 and never meets v = 0'
    >>> s.push(100, 1).fate
    'rest_finite'
    >>> s.at(alpha=0.33).v_plus > s.v_plus
    True
    """

    def __init__(self, law=None, alpha=None, **keys):
        self._open(None, keys_of(law=law, alpha=alpha, **keys))

    @classmethod
    def read(cls, path, **keys):
        """The scene of a file, with some keys set."""
        return cls._made(os.fspath(path), keys_of(**keys))

    def at(self, **keys):
        """The same with some keys set."""
        return self._made(self._path, self._with(keys_of(**keys)))

    @classmethod
    def _made(cls, path, keys):
        self = cls.__new__(cls)
        self._open(path, keys)
        return self

    def _open(self, path, keys):
        self._path, self._keys = path, keys
        self._study = self._run({'products': KNEES, **keys})

    def _with(self, keys):
        """The latest keys win, also over those that exclude them."""
        return {**{key: value for key, value in self._keys.items()
                   if key not in keys}, **keys}

    def _run(self, keys):
        return _c.begin('study', 'run', scene_of(self._path, keys))

    def __setattr__(self, name, value):
        if not name.startswith('_'):
            raise AttributeError(f'a study does not change: at({name}=...) '
                                 'makes another one')
        super().__setattr__(name, value)

    def __reduce__(self):
        return type(self)._made, (self._path, self._keys)

    # ---- numbers -------------------------------------------------------------

    def __getattr__(self, name):
        told = _c.CNumber()
        if name.startswith('_') or library.study_number(
                self._study, name.encode(), told):
            raise AttributeError(f'{name!r} is none of the numbers of this '
                                 'study, which are in its `numbers`')
        return number(told)

    def __dir__(self):
        return [*super().__dir__(), *self._labels]

    @functools.cached_property
    def _labels(self):
        return labels(library.study_label, self._study)

    @functools.cached_property
    def numbers(self):
        """All numbers by name."""
        return {name: getattr(self, name) for name in self._labels}

    def frame(self):
        """All numbers with units and meanings, as a pandas.DataFrame."""
        import pandas
        rows = [(n.value, n.error, n.reason, *self._meaning(name))
                for name, n in self.numbers.items()]
        return pandas.DataFrame(
            rows, index=pandas.Index(self.numbers, name='name'),
            columns=['value', 'error', 'reason', 'unit', 'meaning'])

    def _meaning(self, name):
        """Its unit, with what it is a multiple of, and what it is."""
        what = self._labels[name]
        return what.get('scale', what['units']), what['long_name']

    @functools.cached_property
    def equilibria(self):
        """The steady states, ascending in v."""
        count = library.study_equilibria(self._study, None, 0)
        told = (_c.Equilibrium * count)()
        library.study_equilibria(self._study, told, count)
        numbers = Equilibrium._fields[1:]
        return [Equilibrium(TYPES[e.type], *(number(getattr(e, name))
                                             for name in numbers))
                for e in told]

    # ---- curves, maps, states ------------------------------------------------

    @functools.cached_property
    def manifold(self):
        """The saddle's stable and unstable branches by name: arrays that the
        library lends, from the saddle outward; empty where there is none."""
        study = self._run({**self._keys, 'products': '[manifolds]'})
        found, count = {}, _c.size()
        for k, name in enumerate(BRANCHES):
            points = library.study_branch(study, k, count)
            rows = lent(points, count.value, study)
            found[name] = Branch(*(rows[column] for column in Branch._fields))
        return found

    def basin(self, cells=(512, 512), products=(), **keys):
        """The fate of every state of a grid over the window, an xarray.Dataset;
        products: "margin", "slip", "time", "friction", "peak" beside it."""
        if isinstance(products, str):
            products = [products]
        study = self.at(basins={'cells': cells},
                        products=['basins', *products], **keys)
        return basin_of(study._study, products, study.numbers)

    @functools.cached_property
    def _push(self):
        return _c.begin('push', 'open', scene_of(self._path, self._keys))

    def push(self, v, psi):
        """What becomes of states, of one or of arrays: fate, slip, time and
        mean friction until it is there, and the factors on v and on psi (a
        shift where that is a logarithm) that would change the fate."""
        return pushed(self._push, v, psi)

    def sweep(self, **axes):
        """Each number over one key or two, each with its values:
        s.sweep(alpha=numpy.linspace(0.28, 0.4, 41))."""
        return sweep(self, sweep=[{'key': key, 'values': values}
                                  for key, values in named(axes).items()])

    def batch(self, names, *, threads=0, **keys):
        """Numbers by name at keys that are numbers or arrays."""
        return drawn(self._path, self._keys, names, keys, threads)

    # ---- shown ---------------------------------------------------------------

    def __repr__(self):
        name = type(self).__name__
        told = ', '.join(f'{key}={value}' for key, value in self._keys.items())
        return f'<{name} {self._path or ""}{told}>'

    def _repr_svg_(self):
        return _show.portrait(
            [library.study_axis(self._study, k) for k in range(2)],
            [(name.partition('_')[0], (branch.v, branch.psi))
             for name, branch in self.manifold.items()] if numpy else [],
            [(e.type, (e.v, e.psi)) for e in self.equilibria])

    def _repr_html_(self):
        apart = 'equilibria_', 'estimates_', 'folds_'
        rows = [(name, *_show.digits(n), *self._meaning(name))
                for name, n in self.numbers.items()
                if not name.startswith(apart)]
        return (self._repr_svg_() or '') + _show.table(
            ['number', 'value', '+-', 'unit', 'meaning'], rows)


def sweep(scene, **keys):
    """The `sweep` of a scene, a file or a Study, with some keys set: each
    number over its key or its grid of two."""
    path, fixed = (scene._path, scene._keys) if isinstance(
        scene, Study) else (os.fspath(scene), {})
    return swept(scene_of(path, {**fixed, **keys_of(**keys)}))


def pushed(push, v, psi):
    """The library's answers to states."""
    if not (numpy and (numpy.ndim(v) or numpy.ndim(psi))):
        state, answer, fault = _c.State(v, psi), _c.Answer(), _c.Fault()
        _c.check(library.push_find(push, state, 1, None, answer, fault),
                 fault)
        return Push(FATES[answer.fate], *(number(getattr(answer, name))
                                          for name in Push._fields[1:]))
    v, psi = numpy.broadcast_arrays(reals(v), reals(psi))
    states, at = filled(_c.State, v.size)
    states['v'], states['psi'] = v.ravel(), psi.ravel()
    answers, to, fault = *filled(_c.Answer, v.size), _c.Fault()
    failed = _c.interruptible(lambda monitor: library.push_find(
        push, at, v.size, monitor, to, fault))
    _c.check(failed, fault)
    answers = answers.reshape(v.shape)
    return Push(numpy.array(FATES)[answers['fate']],
                *(Numbers.told(answers[name]) for name in Push._fields[1:]))
