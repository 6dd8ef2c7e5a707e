"""The numbers of a scene over a key, or over a grid of two."""
import itertools
import math

from . import _c
from ._arrays import Numbers, filled, lent
from ._dataset import dataset, units

library = _c.library


def axes(sweep):
    """{name of a key: (values, what they are)}."""
    found = {}
    for k in range(2):
        count, label = _c.size(), _c.Label()
        values = library.sweep_axis(sweep, k, count, label)
        if values:
            found[label.name.decode()] = (
                lent(values, count.value, sweep), about(label))
    last = [key.rpartition('.')[2] for key in found]
    return found if len(set(last)) < len(found) else dict(
        zip(last, found.values()))


def about(label):
    return units(label.unit, label.scale, label.text)


def labels(function, handle):
    """{name: unit and meaning}, of a study or a sweep."""
    told = (function(handle, k) for k in itertools.count())
    return {one.name.decode(): about(one)
            for one in itertools.takewhile(lambda one: one.name, told)}


def columns(sweep, dims, shape):
    """Of every number value, error and, where some are missing, reason."""
    count = math.prod(shape)
    for name, what in labels(library.sweep_label, sweep).items():
        array, at = filled(_c.CNumber, count)
        _c.check(library.sweep_numbers(sweep, name.encode(), at, count))
        told = Numbers.told(array.reshape(shape))
        yield name, (dims, told.value, what)
        yield name + '_error', (dims, told.error, {
            **what, 'long_name': 'bound on the error of ' + name})
        if not told.exists.all():
            yield name + '_reason', (dims, told.reason, {
                'long_name': 'why there is none'})


def swept(scene):
    """All of it."""
    sweep = _c.begin('sweep', 'run', scene)
    keys = axes(sweep)
    dims, shape = tuple(keys), tuple(len(values) for values, _ in keys.values())
    return dataset(dict(columns(sweep, dims, shape)),
                   {key: ((key,), *told) for key, told in keys.items()}, {})
