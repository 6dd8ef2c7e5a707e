#!/usr/bin/python3
"""What users' own scripts read from the fields of basin maps.

usage: read_fields.py FILE.h5...   each file is sound; prints as JSON, for each,
                                   what its fields hold

Exits non-zero with a line that says what is wrong.
"""
import json
import sys

import h5py
import numpy
import xarray

FATES = ['creep', 'sliding', 'rest_finite', 'rest_asymptotic', 'runaway',
         'undecided']
FIELDS = ['slip', 'time', 'mu_mean', 'v_peak', 'mu_peak']


def check(holds, *told):
    if not holds:
        sys.exit('read_fields.py: ' + ' '.join(str(item) for item in told))


def check_reason(reason):
    check(reason.dtype == numpy.int8, reason.dtype)
    check(list(reason.attrs['flag_values']) == list(range(len(FATES))), 'flags')
    check(reason.attrs['flag_meanings'].decode().split() == FATES, 'meanings')


def check_layers(basin, names):
    for name in names:
        check([axis[0].name for axis in basin[name].dims]
              == ['/basin/psi', '/basin/v'], name, 'is not over psi, v')
        check(basin[name].attrs['units'] == b'1'
              and basin[name].attrs['long_name'], name, 'has no unit or name')


def check_values(basin, name):
    """A value and its error are there together, and are positive."""
    value, error = basin[name][:], basin[name + '_error'][:]
    there = ~numpy.isnan(value)
    check(numpy.all(there == ~numpy.isnan(error)), name, 'without error')
    check(numpy.all(value[there] > 0) and numpy.all(error[there] > 0)
          and numpy.all(numpy.isfinite(error[there])), name, 'sign')
    ratio = error[there] / value[there]
    return {'missing': int(numpy.sum(~there)),
            'worst': float(ratio.max()) if ratio.size else 0.0}


def some_cells(basin, names):
    """A few cells, as users would write them down."""
    shape = basin['exit_reason'].shape
    return [{'v': float(basin['v'][i % shape[1]]),
             'psi': float(basin['psi'][i // shape[1]]),
             **{name: float(basin[name][i // shape[1], i % shape[1]])
                for name in names},
             'exit_reason': FATES[basin['exit_reason'][i // shape[1],
                                                       i % shape[1]]]}
            for i in range(0, shape[0] * shape[1], 7)]


def read(path):
    with h5py.File(path) as file:
        basin = file['basin']
        holds = sorted(set(basin) - {'v', 'psi', 'label', 'margin',
                                     'margin_psi'})
        if not holds:
            return {'holds': holds}
        names = [name for name in FIELDS if name in basin]
        check_reason(basin['exit_reason'])
        check_layers(basin, holds)
        found = {name: check_values(basin, name) for name in names}
        reason = basin['exit_reason'][:]
        numbers = [name for name in holds if name != 'exit_reason']
        return {'holds': holds,
                'exits': {fate: int(numpy.sum(reason == code))
                          for code, fate in enumerate(FATES)
                          if numpy.any(reason == code)},
                'differ': int(numpy.sum(reason != basin['label'][:])),
                'rtol': float(basin.attrs['cell_rtol'][0]),
                'missing': {name: found[name]['missing'] for name in names},
                'worst': {name: found[name]['worst'] for name in names},
                'some': some_cells(basin, numbers)}


def check_xarray(path):
    with xarray.open_dataset(path, group='basin', engine='h5netcdf') as basin:
        for name in FIELDS:
            if name in basin:
                check(basin[name].dims == ('psi', 'v'), name, 'in xarray')


if __name__ == '__main__':
    answers = {}
    for given in sys.argv[1:]:
        answers[given] = read(given)
        check_xarray(given)
    print(json.dumps(answers))
