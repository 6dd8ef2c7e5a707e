"""Arrays: of numbers, of what the library lends."""
import ctypes as c

from . import _c
from ._number import Number

try:
    import numpy
except ImportError:
    numpy = None


def arrays():
    """numpy, for what needs it."""
    if numpy is None:
        raise ImportError('slipway: arrays need numpy (Debian: python3-numpy)')
    return numpy


def reals(values):
    """As an array of doubles, if they are real numbers."""
    return arrays().asarray(values).astype(float, casting='same_kind',
                                           copy=False)


class Numbers(numpy.lib.mixins.NDArrayOperatorsMixin if numpy else object):
    """An array of numbers: `value`, `error` and `spread` of the same shape, NaN
    where there is none, and `reason`, None where there is one.  To numpy it is
    its values.

    >>> nan = float('nan')
    >>> both = Numbers.of([Number(1, 0.1), Number(nan, nan, 'why')])
    >>> both
    <2 numbers, 1 exist>
    >>> both[1]
    none (why)
    >>> 2 * both
    array([ 2., nan])
    """

    __slots__ = ('value', 'error', 'reason', 'spread')

    def __init__(self, value, error, reason, spread=float('nan')):
        self.value, self.error, self.reason = value, error, reason
        self.spread = numpy.broadcast_to(spread, value.shape)

    @classmethod
    def of(cls, numbers):
        array = arrays().array
        return cls(array([n.value for n in numbers]),
                   array([n.error for n in numbers]),
                   array([n.reason for n in numbers], object),
                   array([n.spread for n in numbers]))

    @classmethod
    def told(cls, field):
        """What the library told, a field of struct_type."""
        return cls(field['value'], field['error'], texts(field['reason']),
                   field['spread'])

    @property
    def exists(self):
        return arrays().equal(self.reason, None)

    @property
    def shape(self):
        return self.value.shape

    def reshape(self, *shape):
        return Numbers(*(getattr(self, name).reshape(*shape)
                         for name in self.__slots__))

    def __array__(self, dtype=None, copy=None):
        return arrays().array(self.value, dtype, copy=bool(copy))

    def __array_ufunc__(self, function, method, *inputs, **how):
        return getattr(function, method)(
            *(one.value if isinstance(one, Numbers) else one
              for one in inputs), **how)

    def __len__(self):
        return len(self.value)

    def __getitem__(self, at):
        found = [getattr(self, name)[at] for name in self.__slots__]
        kind = Numbers if isinstance(found[0], numpy.ndarray) else Number
        return kind(*found)

    def __repr__(self):
        return f'<{self.value.size} numbers, {self.exists.sum()} exist>'


def texts(pointers):
    """Strings by address, None where that is 0."""
    found = arrays().empty(pointers.shape, object)
    for pointer in numpy.unique(pointers):
        if pointer:
            found[pointers == pointer] = c.string_at(int(pointer)).decode()
    return found


def type_of(kind):
    """The type of ctypes as one of numpy; texts are addresses."""
    if issubclass(kind, c.Structure):
        names = [name for name, _ in kind._fields_]
        return arrays().dtype({
            'names': names, 'itemsize': c.sizeof(kind),
            'formats': [type_of(field) for _, field in kind._fields_],
            'offsets': [getattr(kind, name).offset for name in names]})
    if issubclass(kind, c.Array):
        return (type_of(kind._type_), kind._length_)
    return numpy.dtype('u8' if kind is _c.text else kind)


def lent(pointer, count, owner):
    """What the library lends, as an array that keeps its owner alive."""
    kind = type_of(pointer._type_)
    if count == 0:
        return numpy.empty(0, kind)
    block = (pointer._type_ * count).from_address(
        c.addressof(pointer.contents))
    block.owner = owner
    array = numpy.frombuffer(block, kind)
    array.flags.writeable = False
    return array


def filled(kind, count):
    """An array for the library to fill, and where it is."""
    array = arrays().empty(count, type_of(kind))
    return array, array.ctypes.data_as(_c.to(kind))
