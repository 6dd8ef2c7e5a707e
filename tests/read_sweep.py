#!/usr/bin/python3
"""What users' own scripts read from a sweep.

usage: read_sweep.py FILE.h5... [NAME...]
                               the files are sound; prints as JSON of each its
                               keys, all axes, the axes of every data set, and
                               of the named ones (v_plus, v_minus) values and,
                               of numbers, errors and words; of a single file
                               nothing else

Exits non-zero with a line that says what is wrong.
"""
import json
import sys

import h5py
import numpy
import xarray

EXACT = ('trajectory_energy_defect', 'basin_audit_cells',
         'basin_audit_disagreements')
GRIDS = (['psi', 'v'], ['arrow_psi', 'arrow_v'], ['chi_alpha', 'chi_v'])


def check(holds, *told):
    if not holds:
        sys.exit('read_sweep.py: ' + ' '.join(str(item) for item in told))


def check_axis(sweep, name):
    axis = sweep[name]
    order = numpy.diff(axis[()])
    check(h5py.h5ds.is_scale(axis.id), name, 'is no scale')
    check(axis.ndim == 1 and ((order > 0).all() or (order < 0).all()), name)


def dims_of(cube):
    names = [axis[0].name for axis in cube.dims]
    check(all(name.startswith('/sweep/') for name in names), cube.name, names)
    return [name[len('/sweep/'):] for name in names]


def words_of(code):
    check(code.dtype == numpy.int8 and code.attrs['_FillValue'] == -1,
          code.name, code.dtype)
    words = code.attrs['flag_meanings'].decode().split()
    check(list(code.attrs['flag_values']) == list(range(len(words))),
          code.name, words)
    return words


def check_number(sweep, name, dims):
    """Value, error and code, each a cube; missing ones NaN, with a reason."""
    value, code = sweep[name], sweep[name + '_exists']
    check(dims[name + '_exists'] == dims[name], name, 'axes')
    words = words_of(code)
    check(words[:2] == ['absent', 'present'], words)
    there = code[()] == 1
    check((code[()] >= 0).all(), name, 'has no code')
    check((numpy.isnan(value[()]) != there).all(), name, 'NaN')
    check(numpy.isnan(value.attrs['_FillValue']), name, 'fill')
    check((name + '_error' in sweep) != (name in EXACT), name, 'error')
    if name not in EXACT:
        error = sweep[name + '_error'][()]
        check(dims[name + '_error'] == dims[name], name, 'axes')
        check((numpy.isnan(error) != there).all()
              and (error[there] >= 0).all(), name, 'errors')


def check_map(sweep, name):
    """Codes and their words, or numbers and, of fields, their bounds."""
    cube = sweep[name]
    if cube.dtype == numpy.int8:
        check(cube[()].max() < len(words_of(cube)), name)
        return
    there = ~numpy.isnan(cube[()])
    check(there.any() and numpy.isnan(cube.attrs['_FillValue']), name, 'NaN')
    if name + '_error' in sweep:
        error = sweep[name + '_error'][()]
        check((~numpy.isnan(error) == there).all()
              and (error[there] >= 0).all(), name, 'errors')


def listed(values):
    return [None if x != x else x for x in values.flatten().tolist()]


def told(sweep, name):
    if name + '_exists' not in sweep:
        return {'value': listed(sweep[name][()])}
    words = words_of(sweep[name + '_exists'])
    return {'value': listed(sweep[name][()]),
            'error': listed(sweep[name + '_error'][()]),
            'words': [words[k] for k in sweep[name + '_exists'][()].flat]}


def check_sweep(sweep, keys):
    """Every data set is an axis, a number with what belongs to it, a code or a
    map; the axes of each."""
    axes = [name for name in sweep if h5py.h5ds.is_scale(sweep[name].id)]
    dims = {name: dims_of(sweep[name]) for name in sweep if name not in axes}
    numbers = [name for name in sweep if name + '_exists' in dims]
    for name in axes:
        check_axis(sweep, name)
    for name in numbers:
        check_number(sweep, name, dims)
    for name, along in dims.items():
        starts = name in ('start_v', 'start_psi')
        check(along == ['start'] if starts else along[:len(keys)] == keys,
              name, along)
        if along[-2:] in GRIDS:
            check_map(sweep, name)
        elif name not in numbers and name.rsplit('_', 1)[0] not in numbers \
                and not starts:
            words_of(sweep[name])
    return axes, dims


def read(path, names):
    with h5py.File(path) as file:
        sweep = file['sweep']
        keys = sweep.attrs['keys'].decode().split()
        short = [key.split('.')[-1] for key in keys]
        axes, dims = check_sweep(sweep, short)
        found = {'keys': keys,
                 'axes': {name: list(sweep[name][()]) for name in axes},
                 'dims': dims,
                 **{name: told(sweep, name) for name in names
                    if name in sweep}}
    # h5netcdf takes seconds for hundreds of data sets
    engine = 'h5netcdf' if len(dims) < 250 else 'netcdf4'
    with xarray.open_dataset(path, group='sweep', engine=engine) as data:
        for name, along in dims.items():
            check(list(data.variables[name].dims) == along, name)
        for name, values in found['axes'].items():
            check((data[name] == values).all(), name)
    return found


FILES = [name for name in sys.argv[1:] if name.endswith('.h5')]
NAMES = [name for name in sys.argv[1:] if not name.endswith('.h5')]
FOUND = {name: read(name, NAMES or ['v_plus', 'v_minus']) for name in FILES}
print(json.dumps(FOUND if len(FILES) > 1 else FOUND[FILES[0]]))
