#!/usr/bin/python3
"""What users' own scripts read from the basin maps of result files.

usage: read_basin.py FILE.h5...         each map is sound; prints as JSON, for
                                        each file, the cells of every fate
       read_basin.py --near A.h5 B.h5   the same labels, but for cells of A
                                        within 1e-6 of another fate

Exits non-zero with a line that says what is wrong.
"""
import json
import sys

import h5py
import numpy

FATES = ['creep', 'sliding', 'rest_finite', 'rest_asymptotic', 'runaway',
         'undecided']
STOPS = ['creep', 'rest_finite', 'rest_asymptotic']
GOES = ['sliding', 'runaway']


def check(holds, *told):
    if not holds:
        sys.exit('read_basin.py: ' + ' '.join(str(item) for item in told))


def edges(at):
    """Of evenly spaced cells, and whether by steps or by factors."""
    charts = {'steps': (numpy.array, numpy.array),
              'factors': (numpy.log, numpy.exp)}
    for name, (there, back) in charts.items():
        if at.size < 2 or name == 'factors' and at[0] <= 0:
            continue
        u = there(at)
        half = numpy.diff(u) / 2
        if numpy.ptp(half) < 1e-9 * half[0]:
            return [name, float(back(u[0] - half[0])),
                    float(back(u[-1] + half[0]))]
    check(at.size == 1, 'cells are not even:', at)
    return None


def check_axes(basin):
    """v and psi ascend evenly and are scales."""
    for name in ('psi', 'v'):
        at = basin[name][:]
        check(h5py.h5ds.is_scale(basin[name].id), name, 'is no scale')
        check(at.dtype == numpy.float64 and numpy.all(numpy.diff(at) > 0),
              name, at)
        edges(at)
    for name in set(basin) - {'psi', 'v', 'disagreement'}:
        check([axis[0].name for axis in basin[name].dims]
              == ['/basin/psi', '/basin/v'], name, 'is not over psi, v')


def check_label(label):
    check(label.dtype == numpy.int8, label.dtype)
    check(list(label.attrs['flag_values']) == list(range(len(FATES))), 'flags')
    check(label.attrs['flag_meanings'].decode().split() == FATES, 'meanings')
    found = label[:]
    check(found.min() >= 0 and found.max() < len(FATES), 'unlabelled cells')
    return found


def shares(basin, measure):
    """[share, error] by fate; they sum to 1 within their errors."""
    found = {}
    for fate in FATES:
        name = f'fraction_{measure}_{fate}'
        if name in basin.attrs:
            found[fate] = [basin.attrs[name][0],
                           basin.attrs[name + '_error'][0]]
    total = sum(share for share, _ in found.values())
    bound = sum(error for _, error in found.values())
    check(0 < bound < 1e-6 and abs(total - 1) <= bound, measure, found)
    return found


def check_shares(basin, label):
    """Also by counting, which errs by no more than the cells of the border."""
    even = [name for name in ('psi', 'v') if label.shape[0] > 1
            and numpy.ptp(numpy.diff(basin[name][:])) < 1e-9 * basin[name][-1]]
    linear = 'v' in even
    found, _ = (shares(basin, 'linear' if linear else 'log'),
                shares(basin, 'log' if linear else 'linear'))
    for code, fate in enumerate(FATES):
        counted = numpy.count_nonzero(label == code) / label.size
        check(abs(counted - found.get(fate, [0])[0])
              <= 2 * sum(label.shape) / label.size, fate, counted, found)


def check_audit(basin):
    check(basin.attrs['audit_cells'][0] >= 0
          and basin.attrs['audit_disagreements'][0] == 0
          and 'disagreement' not in basin, 'audit', dict(basin.attrs))


def check_margin(label, at, margin):
    """Along the rows: where the label changes between two cells, the margins
    of both point at one place between them; elsewhere they are longer, or
    missing where there is no other fate."""
    check(not numpy.any(numpy.isinf(margin)), 'margins that are infinite')
    gap = numpy.diff(at)
    left, right = margin[:, :-1], margin[:, 1:]
    changes = label[:, :-1] != label[:, 1:]
    meet = (left > 0) & (right < 0) & (abs(left - right - gap) < 1e-9)
    check(numpy.all(meet[changes]), 'margins miss', numpy.sum(changes & ~meet),
          'of', numpy.sum(changes), 'changes of label')
    check(not numpy.any(meet & ~changes), 'margins where no label changes')


def check_sign(label, margin):
    """Of two fates, here: who stops needs a push, who slides a brake."""
    finite = numpy.isfinite(margin)
    stops = numpy.isin(label, [FATES.index(fate) for fate in STOPS])
    goes = numpy.isin(label, [FATES.index(fate) for fate in GOES])
    check(numpy.all((margin > 0)[finite & stops])
          and numpy.all((margin < 0)[finite & goes]), 'sign of the margin')


def check_margins(basin, label, psi_is_log):
    if 'margin' not in basin:
        check('margin_psi' not in basin, 'only one margin')
        return
    psi = basin['psi'][:]
    check_margin(label, numpy.log(basin['v'][:]), basin['margin'][:])
    check_margin(label.T, psi if psi_is_log else numpy.log(psi),
                 basin['margin_psi'][:].T)
    check_sign(label, basin['margin'][:])
    check_sign(label, -basin['margin_psi'][:])


def check_map(path):
    with h5py.File(path) as file:
        basin = file['basin']
        check_axes(basin)
        label = check_label(basin['label'])
        check_shares(basin, label)
        check_audit(basin)
        check_margins(basin, label, basin['psi'][0] <= 0)
        return {'cells': {fate: int(numpy.sum(label == code))
                          for code, fate in enumerate(FATES)
                          if numpy.any(label == code)},
                'audit': int(basin.attrs['audit_cells'][0]),
                'v': edges(basin['v'][:]), 'psi': edges(basin['psi'][:]),
                'shape': list(label.shape), 'holds': sorted(basin),
                'shares': shares(basin, 'log')}


def check_maps(names):
    found = {}
    for name in names:
        try:
            found[name] = check_map(name)
        except SystemExit as why:
            sys.exit(f'{why} in {name}')
    print(json.dumps(found))


def check_near(one, other):
    with h5py.File(one) as a, h5py.File(other) as b:
        near = numpy.fmin(abs(a['basin/margin'][:]),
                          abs(a['basin/margin_psi'][:])) < 1e-6
        differ = a['basin/label'][:] != b['basin/label'][:]
        check(not numpy.any(differ & ~near), numpy.sum(differ & ~near),
              'labels differ')
        check(not numpy.all(near), 'nothing to compare')


if __name__ == '__main__':
    if sys.argv[1] == '--near':
        check_near(*sys.argv[2:])
    else:
        check_maps(sys.argv[1:])
