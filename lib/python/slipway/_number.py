"""A number with an error bar, or a reason why there is none."""


class Number(float):
    """A float with a bound on its error, |truth - value| <= error; or NaN and
    the reason why there is none.

    >>> Number(2.5, 0.001)
    2.5 +- 0.001
    >>> 2 * Number(2.5, 0.001)
    5.0
    >>> Number(float('nan'), float('nan'), 'it is not computed')
    none (it is not computed)

    Of a study with inputs such as a='0.0349 +- 0.0005' `spread` is the standard
    deviation that these make of it, to first order; else NaN.
    """

    __slots__ = ('error', 'reason', 'spread')

    def __new__(cls, value, error, reason=None, spread=float('nan')):
        self = super().__new__(cls, value)
        self.error, self.reason, self.spread = error, reason, spread
        return self

    @property
    def value(self):
        return float(self)

    @property
    def exists(self):
        return self.reason is None

    def __getnewargs__(self):
        return self.value, self.error, self.reason, self.spread

    def __repr__(self):
        if not self.exists:
            return f'none ({self.reason})'
        return f'{self.value!r} +- {self.error:.2g}'

    __str__ = __repr__

    def __format__(self, form):
        return format(self.value, form) if form else repr(self)


def number(told):
    """What the library tells."""
    reason = told.reason
    return Number(told.value, told.error, reason and reason.decode(),
                  told.spread)
