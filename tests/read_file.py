#!/usr/bin/python3
"""What users' own scripts read from a result file.

usage: read_file.py layout FILE.h5        the groups and columns are there
       read_file.py curve FILE.h5 POINTS  exact points lie on the stored curve
       read_file.py same A.h5 B.h5        the same but for scene and overrides

Exits non-zero with a line that says what is wrong.  POINTS is CSV: branch, v,
psi.
"""
import csv
import sys

import h5py
import numpy

COLUMNS = {
    'equilibria': ['n', 'type', 'v', 'psi', 'mu', 'lambda_minus',
                   'lambda_plus', 'v_error', 'psi_error', 'mu_error',
                   'lambda_minus_error', 'lambda_plus_error'],
    **{'manifold/' + branch: ['arc', 'v', 'psi', 'slope', 'slip', 'time',
                              'work', 'error']
       for branch in ('stable_upper', 'stable_lower', 'unstable_upper',
                      'unstable_lower')},
    'nullcline/v_0': ['arc', 'v', 'psi'],
    'nullcline/psi_0': ['arc', 'v', 'psi'],
    'trajectory_0': ['time', 'v', 'psi', 'slip', 'mu'],
}
PROVENANCE = {'scene', 'overrides', 'version', 'compiler', 'libraries'}


def check(holds, *told):
    if not holds:
        sys.exit('read_file.py: ' + ' '.join(str(item) for item in told))


def check_layout(path):
    with h5py.File(path) as file:
        check(file.attrs['Conventions'] == b'CF-1.10', 'no Conventions')
        for name, columns in COLUMNS.items():
            check(name in file, 'no', name)
            group, axis = file[name], columns[0]
            check(set(columns) <= set(group), name, 'has', list(group))
            for column in columns:
                data = group[column]
                check(data.shape == group[axis].shape and data.size > 0, name,
                      column, data.shape)
                check(data.attrs['units'] and data.attrs['long_name'], name,
                      column)
                check(column == axis or data.dims[0][0] == group[axis], name,
                      column, 'is not over', axis)
            check(numpy.all(numpy.diff(group[axis][:]) > 0), name, axis)
        check(PROVENANCE <= set(file['provenance'].attrs), 'provenance')


def hermite(s, u, slope, at):
    """The cubic through u with these slopes, s ascending."""
    i = numpy.clip(numpy.searchsorted(s, at) - 1, 0, len(s) - 2)
    h = s[i + 1] - s[i]
    t = (at - s[i]) / h
    return ((1 - t) ** 2 * ((1 + 2 * t) * u[i] + t * h * slope[i])
            + t ** 2 * ((3 - 2 * t) * u[i + 1] + (t - 1) * h * slope[i + 1]))


def miss(group, v, psi):
    """How far (ln v, ln psi) is from the stored curve; None beyond its end.

    Along a piece as steep as this point's, over the flatter coordinate.
    """
    x, y = numpy.log(group['v'][:]), numpy.log(group['psi'][:])
    slope = group['slope'][:]
    flat = abs(slope[numpy.argmin(abs(x - v) + abs(y - psi))]) < 1
    s, u, at, wanted = (x, y, v, psi) if flat else (y, x, psi, v)
    rows = numpy.argsort(s)
    if not s[rows[0]] <= at <= s[rows[-1]]:
        return None
    by = slope if flat else numpy.where(numpy.isnan(slope), 0, 1 / slope)
    return abs(hermite(s[rows], u[rows], by[rows], at) - wanted)


def check_curve(path, points):
    met = 0
    with h5py.File(path) as file, open(points, encoding='utf-8') as table:
        for row in csv.DictReader(table):
            group = file['manifold/stable_' + row['branch']]
            d = miss(group, numpy.log(float(row['v'])),
                     numpy.log(float(row['psi'])))
            check(d is None or d <= 1e-6, row, 'is', d, 'off')
            met += d is not None
    print(met)


def contents(path):
    """Every value and attribute by its name."""
    found = {}

    def see(name, thing):
        for key, value in thing.attrs.items():
            if not key.endswith('_LIST'):  # addresses in the file
                found[name + '@' + key] = repr(numpy.asarray(value).tolist())
        if isinstance(thing, h5py.Dataset):
            found[name] = repr(numpy.asarray(thing[()]).tolist())

    with h5py.File(path) as file:
        see('', file)
        file.visititems(see)
    return found


def check_same(a, b):
    first, second = contents(a), contents(b)
    differ = {name for name in first.keys() | second.keys()
              if first.get(name) != second.get(name)}
    differ -= {'provenance@scene', 'provenance@overrides'}
    check(len(first) > 50 and not differ, 'these differ:', sorted(differ))


if __name__ == '__main__':
    {'layout': check_layout, 'curve': check_curve,
     'same': check_same}[sys.argv[1]](*sys.argv[2:])
