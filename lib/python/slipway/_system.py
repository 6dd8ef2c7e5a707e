"""A planar system typed as formulas."""
import functools
import os
from collections import namedtuple

from . import _c, _show
from ._arrays import Numbers, lent, numpy, reals
from ._number import number
from ._scene import scene_of, written

library = _c.library
TYPES = ('saddle', 'stable_node', 'stable_focus', 'unstable_node',
         'unstable_focus', 'nonhyperbolic')
KINDS = ('stable', 'unstable')

Rest = namedtuple('Rest', 'name type state re im share')
Manifold = namedtuple('Manifold', 'saddle kind branch end to length arc state '
                                  'slope error')
Goal = namedtuple('Goal', 'attractor kick')


class System:
    """Equations in a window: equilibria, manifolds of saddles, basins.

    Keywords are parameters; `state` says what is not real, as a scene does,
    and `scene` sets other keys of one, {"basins.audit": 1000}.

    >>> duffing = System("x' = y; y' = x - x^3 - d*y", d=0.1,
    ...                  window={"x": [-2, 2], "y": [-2, 2]})
    >>> [rest.name for rest in duffing.equilibria]
    ['stable_focus_0', 'saddle_0', 'stable_focus_1']
    >>> f"{duffing.shares['stable_focus_0']:.9f}"
    '0.500000000'
    >>> duffing.goal(1, 1).attractor
    'stable_focus_0'
    """

    def __init__(self, equations, window=None, state=None, scene=None,
                 **parameters):
        lines = (line.strip(' ;') for line in equations.splitlines())
        keys = {'system.ode': '; '.join(line for line in lines if line),
                'window': window, 'system.state': state, **(scene or {}),
                **{f'system.parameters.{name}': value
                   for name, value in parameters.items()}}
        self._open(None, keys)

    @classmethod
    def read(cls, path, scene=None, **parameters):
        """The system of a scene or a model of XPPAUT, some of it set."""
        return cls._made(os.fspath(path), {
            **(scene or {}), **{f'system.parameters.{name}': value
                                for name, value in parameters.items()}})

    @classmethod
    def _made(cls, path, keys):
        self = cls.__new__(cls)
        self._open(path, keys)
        return self

    def _open(self, path, keys):
        self._path = path
        self._keys = {key: value for key, value in keys.items()
                      if value is not None}
        told = {key: written(value) for key, value in self._keys.items()}
        self._plane = _c.begin('plane', 'run', scene_of(
            path, {'basins.audit': '0', **told}))
        self._axes = [library.plane_axis(self._plane, k) for k in range(2)]

    def __reduce__(self):
        return type(self)._made, (self._path, self._keys)

    @property
    def states(self):
        """Their names."""
        return tuple(axis.name.decode() for axis in self._axes)

    def _listed(self, kind, function, *more):
        count = function(self._plane, None, 0, *more)
        told = (kind * count)()
        function(self._plane, told, count, *more)
        return told

    @functools.cached_property
    def equilibria(self):
        """All of them, ascending in the first state."""
        return [Rest(e.name.decode(), TYPES[e.type],
                     *(tuple(map(number, both))
                       for both in (e.state, e.re, e.im)), number(e.share))
                for e in self._listed(_c.Rest, library.plane_equilibria, None)]

    @functools.cached_property
    def complete(self):
        """Whether the window was proved to hold no other equilibria."""
        told = _c.c.c_int()
        library.plane_equilibria(self._plane, None, 0, told)
        return bool(told.value)

    @functools.cached_property
    def manifolds(self):
        """Four of each saddle, with arrays that the library lends."""
        found = []
        listed = self._listed(_c.Manifold, library.plane_manifolds)
        for k, m in enumerate(listed):
            count = _c.size()
            points = library.plane_points(self._plane, k, count)
            rows = lent(points, count.value, self._plane)
            found.append(Manifold(
                m.saddle, KINDS[m.kind], m.branch, m.end and m.end.decode(),
                m.to if m.to >= 0 else None, number(m.length), rows['arc'],
                (rows['state'][:, 0], rows['state'][:, 1]), rows['slope'],
                rows['error']))
        return found

    @functools.cached_property
    def shares(self):
        """Of the window's area, by attractor."""
        return {s.attractor.decode(): number(s.fraction) for s in
                self._listed(_c.Share, library.plane_shares)}

    def goal(self, x, y):
        """Whereto a state goes, one or an array of them, and the smallest
        change of each coordinate alone after which it goes elsewhere: what is
        added, of a positive state the factor."""
        if not (numpy and (numpy.ndim(x) or numpy.ndim(y))):
            return self._goal(float(x), float(y))
        x, y = numpy.broadcast_arrays(reals(x), reals(y))
        found = [self._goal(*state) for state in zip(x.ravel(), y.ravel())]
        return Goal(numpy.array([goal.attractor for goal in found],
                                str).reshape(x.shape),
                    tuple(Numbers.of([goal.kick[k] for goal in found])
                          .reshape(x.shape) for k in range(2)))

    def _goal(self, x, y):
        attractor, kick = _c.text(), (_c.CNumber * 2)()
        _c.check(library.plane_goal(self._plane, x, y, attractor, kick))
        return Goal(attractor.value.decode(), tuple(map(number, kick)))

    # ---- shown ---------------------------------------------------------------

    def __repr__(self):
        told = ', '.join(f'{key}={value!r}'
                         for key, value in self._keys.items())
        return f'<System {self._path or ""}{told}>'

    def _repr_svg_(self):
        return _show.portrait(self._axes,
                              [(m.kind, m.state) for m in self.manifolds],
                              [(e.type, e.state) for e in self.equilibria])

    def _repr_html_(self):
        rows = [(e.name, *(cell for one in (*e.state, e.share)
                           for cell in _show.digits(one)))
                for e in self.equilibria]
        return (self._repr_svg_() or '') + _show.table(
            ['equilibrium', *(head for name in (*self.states, 'share')
                              for head in (name, '+-'))], rows)
