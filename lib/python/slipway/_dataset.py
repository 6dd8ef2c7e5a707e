"""Tables over axes: an xarray.Dataset where xarray is, else arrays."""
from collections.abc import Mapping


class Arrays(Mapping):
    """What an xarray.Dataset would hold, where there is no xarray: arrays by
    name, also as attributes; `dims` and `attrs` of each by name."""

    def __init__(self, variables, coordinates, attributes):
        held = {**coordinates, **variables}
        self._arrays = {name: array for name, (_, array, _) in held.items()}
        self.dims = {name: dims for name, (dims, _, _) in held.items()}
        self.units = {name: attrs for name, (_, _, attrs) in held.items()}
        self.attrs = attributes

    def __getitem__(self, name):
        return self._arrays[name]

    def __getattr__(self, name):
        if name.startswith('_') or name not in self._arrays:
            raise AttributeError(name)
        return self._arrays[name]

    def __iter__(self):
        return iter(self._arrays)

    def __len__(self):
        return len(self._arrays)

    def __dir__(self):
        return [*super().__dir__(), *self._arrays]

    def __repr__(self):
        return '\n'.join(f'{name} {self.dims[name]} {array.dtype}'
                         for name, array in self._arrays.items())


def units(unit, scale, text):
    """Attributes, as files have them: `scale` is of what the values are
    multiples."""
    told = {'units': unit, 'scale': scale, 'long_name': text}
    return {key: value.decode() if isinstance(value, bytes) else value
            for key, value in told.items() if value}


def dataset(variables, coordinates, attributes):
    """Of {name: (dimensions, array, attributes)}."""
    try:
        from xarray import Dataset
    except ImportError:
        return Arrays(variables, coordinates, attributes)
    return Dataset(variables, coordinates, attributes)
