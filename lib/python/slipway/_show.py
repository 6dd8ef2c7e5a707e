"""What a notebook shows: a portrait drawn from the branches, and a table.

The library has no figures.  `slipway portrait` draws better ones, to files.
"""
import html
import math

from ._arrays import numpy

WIDTH, HEIGHT, LEFT, BOTTOM, EDGE = 420, 320, 46, 34, 14
COLOURS = {'stable': '#1f5fae', 'unstable': '#c8553d'}


class Axis:
    """A coordinate along a side of the frame."""

    def __init__(self, axis, start, end):
        self.name, self.is_log = axis.name.decode(), bool(axis.is_log)
        self.low, self.high = (self.chart(value) for value in axis.range)
        self.start, self.end = start, end

    def chart(self, value):
        return math.log10(value) if self.is_log else value

    def at(self, values):
        """Where states are, in pixels; not far outside."""
        values = numpy.log10(values) if self.is_log else numpy.asarray(values)
        share = (values - self.low) / (self.high - self.low)
        return self.start + numpy.clip(share, -1, 2) * (self.end - self.start)

    def ticks(self):
        """(state, text), some four to eight of them."""
        wide = self.high - self.low
        step = 10.0 ** math.floor(math.log10(wide / 4))
        step *= next(s for s in (5, 2, 1) if s * step <= wide / 4 or s == 1)
        if self.is_log:
            step = max(1, round(step))
        first = math.ceil(self.low / step - 1e-9)
        for k in range(first, math.floor(self.high / step + 1e-9) + 1):
            mark = round(k * step, 12)
            yield (10.0 ** mark if self.is_log else mark,
                   f'1e{mark:g}' if self.is_log else f'{mark:g}')


def frame(x, y):
    """Ticks and names of both axes."""
    yield f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>'
    for value, text in x.ticks():
        at = float(x.at(value))
        yield (f'<path d="M{at:.1f} {y.start}v4" stroke="#444"/><text '
               f'x="{at:.1f}" y="{y.start + 15}" text-anchor="middle">{text}'
               '</text>')
    for value, text in y.ticks():
        at = float(y.at(value))
        yield (f'<path d="M{x.start} {at:.1f}h-4" stroke="#444"/><text '
               f'x="{x.start - 6}" y="{at + 4:.1f}" text-anchor="end">{text}'
               '</text>')
    yield (f'<text x="{(x.start + x.end) / 2}" y="{HEIGHT - 4}" '
           f'text-anchor="middle" font-style="italic">{html.escape(x.name)}'
           '</text>')
    yield (f'<text x="4" y="{(y.start + y.end) / 2}" font-style="italic">'
           f'{html.escape(y.name)}</text>')


def curve(x, y, kind, states):
    """A branch: the states along it, a pixel or more apart."""
    points = numpy.column_stack([x.at(states[0]), y.at(states[1])])
    points = points[numpy.isfinite(points).all(axis=1)]
    steps = numpy.hypot(*numpy.diff(points, axis=0).T)
    points = points[numpy.unique(numpy.floor(numpy.cumsum([0, *steps])),
                                 return_index=True)[1]]
    told = ' '.join(f'{a - x.start:.1f},{b - y.end:.1f}' for a, b in points)
    return (f'<polyline points="{told}" fill="none" stroke="{COLOURS[kind]}" '
            'stroke-width="1.6"/>')


def rest(x, y, kind, state):
    """An equilibrium: filled where it attracts."""
    fill = 'black' if kind.startswith('stable') else 'white'
    return (f'<circle cx="{float(x.at(state[0])) - x.start:.1f}" '
            f'cy="{float(y.at(state[1])) - y.end:.1f}" r="3.5" fill="{fill}" '
            f'stroke="black"><title>{html.escape(kind)}</title></circle>')


def portrait(axes, curves, rests):
    """SVG of curves, (kind, states), and equilibria, (type, state), in the
    window of two axes; None without numpy."""
    if numpy is None:
        return None
    x = Axis(axes[0], LEFT, WIDTH - EDGE)
    y = Axis(axes[1], HEIGHT - BOTTOM, EDGE)
    with numpy.errstate(divide='ignore', invalid='ignore'):
        inner = [curve(x, y, *one) for one in curves]
        inner += [rest(x, y, *one) for one in rests]
    wide, high = x.end - x.start, y.start - y.end
    return ''.join([
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" '
        f'height="{HEIGHT}" font-family="sans-serif" font-size="11">',
        *frame(x, y),
        f'<svg x="{x.start}" y="{y.end}" width="{wide}" height="{high}">',
        *inner, '</svg>',
        f'<rect x="{x.start}" y="{y.end}" width="{wide}" height="{high}" '
        'fill="none" stroke="#444"/></svg>'])


def digits(number):
    """A number as far as its bar lets it be known, and the bar."""
    if not number.exists:
        return f'none: {number.reason}', ''
    if not number.error or not number.value:
        return f'{number.value!r}', f'{number.error:.1g}'
    known = math.log10(abs(number.value) / number.error)
    return f'{number.value:.{min(17, max(1, math.ceil(known)))}g}', \
        f'{number.error:.1g}'


def table(head, rows):
    """HTML of rows of texts."""
    lines = [(html.escape(str(cell)) for cell in row) for row in rows]
    return ('<table><tr>' + ''.join(f'<th>{name}</th>' for name in head)
            + '</tr>' + ''.join(
                '<tr>' + ''.join(f'<td>{cell}</td>' for cell in line) + '</tr>'
                for line in lines) + '</table>')
