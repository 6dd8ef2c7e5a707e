#!/usr/bin/python3
"""What users' own scripts read from a sweep.

usage: read_sweep.py FILE.h5   the file is sound; prints as JSON its keys, and
                               of v_plus, v_minus values, errors and words

Exits non-zero with a line that says what is wrong.
"""
import json
import sys

import h5py
import numpy
import xarray


def check(holds, *told):
    if not holds:
        sys.exit('read_sweep.py: ' + ' '.join(str(item) for item in told))


def check_axes(sweep, names):
    for name in names:
        axis = sweep[name]
        check(h5py.h5ds.is_scale(axis.id), name, 'is no scale')
        check(axis.ndim == 1 and (numpy.diff(axis[()]) > 0).all(), name)


def check_number(sweep, name, dims):
    """Value, error and code, each a cube; missing ones NaN, with a reason."""
    value, error = sweep[name], sweep[name + '_error']
    code = sweep[name + '_exists']
    for cube in (value, error, code):
        check([axis[0].name for axis in cube.dims]
              == ['/sweep/' + dim for dim in dims], cube.name, 'axes')
    check(code.dtype == numpy.int8, code.dtype)
    words = code.attrs['flag_meanings'].decode().split()
    check(list(code.attrs['flag_values']) == list(range(len(words)))
          and words[:2] == ['absent', 'present'], words)
    there = code[()] == 1
    check((numpy.isnan(value[()]) != there).all(), name, 'NaN')
    check((numpy.isnan(error[()]) != there).all() and (error[()][there] >= 0)
          .all(), name, 'errors')
    check(numpy.isnan(value.attrs['_FillValue']), name, 'fill')
    return {'value': [None if numpy.isnan(x) else x for x in value[()].flat],
            'error': [None if numpy.isnan(x) else x for x in error[()].flat],
            'words': [words[k] for k in code[()].flat]}


def read(path):
    with h5py.File(path) as file:
        sweep = file['sweep']
        keys = sweep.attrs['keys'].decode().split()
        names = [key.split('.')[-1] for key in keys]
        check_axes(sweep, names)
        numbers = [name for name in sweep if name + '_exists' in sweep]
        check(len(numbers) > 10, numbers)
        found = {name: check_number(sweep, name, names) for name in numbers}
        axes = {name: list(sweep[name][()]) for name in names}
    with xarray.open_dataset(path, group='sweep', engine='h5netcdf') as data:
        check(list(data.v_plus.dims) == names, data.v_plus.dims)
        check(all((data[name] == axes[name]).all() for name in names), axes)
    return {'keys': keys, 'axes': axes,
            **{name: found[name] for name in ('v_plus', 'v_minus')}}


print(json.dumps(read(sys.argv[1])))
