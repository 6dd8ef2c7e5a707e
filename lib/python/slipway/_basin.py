"""The fate of every state of a grid, and what is computed beside it."""
import ctypes as c

from . import _c
from ._arrays import arrays, filled, numpy
from ._dataset import dataset, units

library = _c.library
FATES = ('creep', 'sliding', 'rest_finite', 'rest_asymptotic', 'runaway',
         'undecided')
# The fields of each product, their scales and meanings.
FIELDS = {
    'slip': {'slip': ('L', 'slip to arrest')},
    'time': {'time': ('L/V_star', 'time to arrest')},
    'friction': {'mu_mean': (None, 'mean friction over that slip')},
    'peak': {'v_peak': ('V_star', 'largest slip rate before arrest'),
             'mu_peak': (None, 'largest friction before arrest')},
}
CELLS = ('psi', 'v')


class Grid:
    """The cells of a study."""

    def __init__(self, study):
        self.study = study
        size = c.c_size_t(), c.c_size_t()
        library.basin_size(study, *map(c.byref, size))
        self.columns, self.rows = (one.value for one in size)

    def axes(self):
        v, at_v = filled(_c.real, self.columns)
        psi, at_psi = filled(_c.real, self.rows)
        _c.check(library.basin_axes(self.study, at_v, at_psi))
        return {'v': (('v',), v, units('1', 'V_star', 'slip rate')),
                'psi': (('psi',), psi, units('1', None, 'interfacial state'))}

    def cells(self, *kinds):
        """Of each kind an array over the cells, and where it is."""
        both = [filled(kind, self.rows * self.columns) for kind in kinds]
        return ([array.reshape(self.rows, self.columns) for array, _ in both],
                [at for _, at in both])

    def labels(self):
        (label,), at = self.cells(c.c_int8)
        _c.check(library.basin_labels(self.study, 0, self.rows, *at))
        words = {'flag_values': arrays().arange(len(FATES), dtype='i1'),
                 'flag_meanings': ' '.join(FATES)}
        yield 'label', (CELLS, label, {**units('1', None, 'fate of the state'),
                                       **words})

    def margins(self):
        (by_v, by_psi), at = self.cells(_c.real, _c.real)
        _c.check(library.basin_margins(self.study, 0, self.rows, *at))
        for margin in (by_v, by_psi):
            margin[arrays().isinf(margin)] = numpy.nan
        text = 'to the nearest other fate; missing: there is none'
        yield 'margin', (CELLS, by_v, units(
            '1', None, 'ln of the factor on v ' + text))
        yield 'margin_psi', (CELLS, by_psi, units(
            '1', None, 'shift of ln psi (of psi where it is a logarithm) '
            + text))

    def fields(self, product):
        for name, (scale, text) in FIELDS[product].items():
            (value, error), at = self.cells(_c.real, _c.real)
            _c.check(library.basin_field(
                self.study, name.encode(), 0, self.rows, *at))
            yield name, (CELLS, value, units('1', scale, text))
            yield name + '_error', (CELLS, error, units(
                '1', scale, 'bound on the error of ' + name))


def basin_of(study, products, numbers):
    """All of it."""
    grid = Grid(study)
    variables = dict(grid.labels())
    for product in products:
        if product == 'margin':
            variables.update(grid.margins())
        elif product in FIELDS:
            variables.update(grid.fields(product))
    shares = {name[len('basin_'):]: number.value
              for name, number in numbers.items() if name.startswith('basin_')}
    return dataset(variables, grid.axes(), shares)
