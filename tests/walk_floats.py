"""Every float of HDF5 files is finite, or missing and declared so.

usage: walk_floats.py FILE...
"""
import sys

import h5py
import numpy


class Walk:
    """Counts the datasets it has seen."""
    count = 0

    def look(self, path, item):
        for name, value in item.attrs.items():
            value = numpy.asarray(value)
            if value.dtype.kind == 'f':
                assert not numpy.isinf(value).any(), (path, name)
        if not isinstance(item, h5py.Dataset) or item.dtype.kind != 'f':
            return
        self.count += 1
        value = item[()]
        assert not numpy.isinf(value).any(), path
        if numpy.isnan(value).any():
            assert numpy.isnan(item.attrs['_FillValue']).all(), path


walk = Walk()
for file in sys.argv[1:]:
    h5py.File(file, 'r').visititems(walk.look)
print(walk.count)
