#!/usr/bin/python3
"""read_layout.py REFERENCE.md FILE.h5... -- holds result files to the page of
`slipway help --as hdf5`, and the page to them.

Every group, data set and attribute found must be on the page, with the kind,
unit, axes, meaning and words that stand there; and everything on the page must
be in one of the files.  Prints what is not so, and exits with 1.
"""
import functools
import re
import sys

import h5py

COMPANIONS = {'error': ('real', ': bound on the absolute error'),
              'exists': ('code', ': whether it exists'),
              'reason': ('text', ': why it is absent'),
              'conditioning': ('real',
                               ': relative error from rounding the inputs'),
              'spread': ('real', ': standard deviation that the scatter of the '
                                 'inputs makes'),
              'not_proved': ('text', ': why nothing is proved of it'),
              'proved': ('code', ': what is proved'),
              'lo': ('real', ': proved to be at least'),
              'hi': ('real', ': proved to be at most')}
WORDS = {'exists': ['absent', 'present'],
         'proved': ['not_proved', 'enclosed', 'absent']}
DTYPES = {'real': 'float64', 'count': 'int64', 'code': 'int8', 'text': 'object'}
SETS, ATTRIBUTES = 0, 1
DRAWN = ['/sweep', '/ensemble']  # reasons by their codes
# A map and its audit do not disagree in any scene there is, these are missing on
# no slope that workprec takes, and files of systems are not read.
NEVER = {'/basin/disagreement', '/ensemble_goals', '/workprec curve', '/workprec transient',
         '/workprec basin_rows'}


@functools.cache
def pattern(name):
    """A name of the page as a regular expression."""
    name = re.escape(name).replace(r'\{', '(?:').replace(r'\}', ')')
    name = name.replace(',', '|')
    return re.compile(re.sub(r'(?<=_)[KI](?=_|/|$)', r'\\d+', name))


def text_of(attrs, key):
    """h5py gives some texts as bytes."""
    value = attrs.get(key, '')
    return value.decode() if isinstance(value, bytes) else value


class Entry:
    """A line of a table."""

    def __init__(self, group, cells, is_set):
        self.name = cells[0].strip('`')
        self.group, self.pattern = group, pattern(self.name)
        self.kind, self.unit = cells[1], cells[2]
        self.along = cells[3] if is_set else None
        text = re.fullmatch(r'(.*?)(?:: ((?:`[^`]+` ?)+))?', cells[-1])
        self.text = text[1].replace('\\|', '|')
        self.words = re.findall(r'`([^`]+)`', text[2] or '')
        self.met = False


class Page:
    def __init__(self, path):
        self.sets, self.attributes, self.axes = [], [], {}
        group, head = None, ''
        with open(path, encoding='utf-8') as file:
            for line in file:
                title = re.match(r'##+ .*`(/.*)`$', line)
                group = title[1] if title else group
                cells = [c.strip() for c in re.split(r'(?<!\\)\|', line)][1:-1]
                if not group or not cells or set(line) <= set('|-\n'):
                    continue
                if cells[0] in ('data set', 'attribute', 'key'):
                    head = cells[0]
                elif head == 'data set':
                    self.sets.append(Entry(group, cells, True))
                elif head == 'attribute':
                    self.attributes.append(Entry(group, cells, False))
                else:
                    self.axes[cells[1].strip('`')] = cells[2:]

    @functools.cache
    def of_group(self, group):
        """(data sets, attributes) that a group may have; None: unknown."""
        kinds = [[e for e in entries if pattern(e.group).fullmatch(group)]
                 for entries in (self.sets, self.attributes)]
        return kinds if any(kinds) else None

    def find(self, kind, group, name):
        for entry in (self.of_group(group) or [[], []])[kind]:
            if entry.pattern.fullmatch(name):
                entry.met = True
                return entry
        return None


class Reader:
    def __init__(self, page):
        self.page, self.wrong, self.keys = page, [], []

    def sweep(self, file):
        """Names of the keys' axes, or of an ensemble's parameters."""
        groups = [name for name in ('sweep', 'ensemble') if name in file]
        keys = file[groups[0]].attrs['keys'] if groups else b''
        return [key.rsplit('.', 1)[-1] for key in keys.decode().split()]

    def demand(self, holds, *what):
        if not holds:
            self.wrong.append(' '.join(map(str, what)))

    def attributes(self, group):
        for key, value in group.attrs.items():
            entry = self.page.find(ATTRIBUTES, group.name, key)
            where = f'attribute {key} of {group.name}'
            self.demand(entry, where, 'is not on the page')
            if entry:
                kind = ('text' if isinstance(value, (str, bytes)) else
                        'count' if value.dtype == 'int64' else 'real')
                self.demand(kind == entry.kind, where, 'is a', kind)

    def entry(self, group, name):
        """(kind, unit, along, text, words): of the line, or of a companion."""
        e = self.page.find(SETS, group, name)
        if e:
            return (e.kind.replace('number', 'real'), e.unit, e.along, e.text,
                    e.words)
        suffix = next((s for s in COMPANIONS if name.endswith('_' + s)), '')
        base = name[:-len(suffix) - 1]
        e = suffix and self.page.find(SETS, group, base)
        exact = group in DRAWN and suffix == 'exists' and e
        if not e or e.kind != 'number' and not (exact and e.kind == 'real'):
            return None
        kind, text = COMPANIONS[suffix]
        unit = ('' if kind == 'text' else
                e.unit if suffix in ('error', 'spread', 'lo', 'hi') else '1')
        if suffix == 'exists' and group in DRAWN:
            text = ': whether it exists, or why not'
        return kind, unit, e.along, e.text + text, WORDS.get(suffix, [])

    def described(self, path, dataset, kind, is_axis):
        wanted = {'long_name'} | ({'units'} if kind != 'text' else set())
        wanted |= {'flag_values', 'flag_meanings'} if kind == 'code' else set()
        if is_axis:
            wanted |= {'CLASS', 'NAME'}
        elif kind in ('real', 'code'):
            wanted.add('_FillValue')
        if dataset.ndim and not is_axis:
            wanted.add('DIMENSION_LIST')
        found = set(dataset.attrs) - {'REFERENCE_LIST', 'scale'} - (
            {'comment'} if dataset.size == 1 else set())
        self.demand(found == wanted, path, 'has', found ^ wanted)

    def unit(self, path, dataset, unit):
        """What V_star and L scale has no unit as it is."""
        scaled = 'V_star' in unit or unit == 'L'
        found = (text_of(dataset.attrs, 'units'), text_of(dataset.attrs, 'scale'))
        self.demand(found == (('1', unit) if scaled else (unit, '')), path, unit)

    def words(self, path, dataset, words):
        found = text_of(dataset.attrs, 'flag_meanings').split()
        if path.rsplit('/', 1)[0] in DRAWN and path.endswith('_exists'):
            found = found[:2]
        self.demand(found == words, path, 'has the words', found)

    def axis(self, dataset, name):
        """Of a sweep."""
        unit, text = self.page.axes[name]
        self.demand(text_of(dataset.attrs, 'units') == unit, dataset.name, 'unit')
        self.demand(text_of(dataset.attrs, 'long_name') == text, dataset.name, 'meaning')

    def dataset(self, path, dataset):
        group, name = path.rsplit('/', 1)
        is_axis = h5py.h5ds.is_scale(dataset.id)
        if name in self.keys and (is_axis and group == '/sweep'
                                  or group == '/ensemble'):
            self.axis(dataset, name)
            return
        entry = self.entry(group, name)
        self.demand(entry, path, 'is not on the page')
        if not entry:
            return
        kind, unit, along, text, words = entry
        long_name = re.sub(r' at xi = [\d.]+', ' at xi = 0.85',
                           text_of(dataset.attrs, 'long_name'))
        axes = ([name] if is_axis else [
            axis[0].name.rsplit('/', 1)[1] for axis in dataset.dims])
        self.demand(dataset.dtype == DTYPES[kind], path, dataset.dtype)
        self.unit(path, dataset, unit)
        self.demand(long_name == text, path, 'means', long_name)
        along = along.replace('the axes', ', '.join(self.keys))
        self.demand(along == ', '.join(axes), path, 'is along', axes)
        self.described(path, dataset, kind, is_axis)
        self.words(path, dataset, words)

    def file(self, path):
        def see(name, thing):
            if isinstance(thing, h5py.Dataset):
                self.dataset('/' + name, thing)
            else:
                self.attributes(thing)

        with h5py.File(path, 'r') as file:
            self.keys = self.sweep(file)
            self.attributes(file['/'])
            file.visititems(see)


def main():
    page = Page(sys.argv[1])
    reader = Reader(page)
    for path in sys.argv[2:]:
        reader.file(path)
    for entry in page.sets + page.attributes:
        reader.demand(entry.met or entry.group in NEVER
                      or f'{entry.group} {entry.name}' in NEVER, entry.name,
                      'of', entry.group, 'is in no file')
    print('\n'.join(sorted(set(reader.wrong))))
    print(len(page.sets), 'data sets,', len(page.attributes), 'attributes,',
          len(sys.argv) - 2, 'files')
    sys.exit(reader.wrong != [])


main()
