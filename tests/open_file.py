#!/usr/bin/python3
"""open_file.py FILE.h5 -- opens a result file with every reader users have.

h5py, xarray (engines h5netcdf and netcdf4) and ncdump must show each group
with units, long_name and named axes.  Exits non-zero at the first failure.
"""
import subprocess
import sys

import h5py
import xarray


def check(holds, what):
    if not holds:
        sys.exit(f"open_file.py: {what}")


def is_text(dataset):
    return h5py.check_string_dtype(dataset.dtype) is not None


def check_dataset(dataset):
    name = dataset.name
    wanted = ["long_name"] if is_text(dataset) else ["long_name", "units"]
    for key in wanted:
        check(len(dataset.attrs.get(key, "")) > 0, f"{name} has no {key}")
    if "flag_values" in dataset.attrs:
        words = bytes(dataset.attrs["flag_meanings"]).split()
        check(len(words) == len(dataset.attrs["flag_values"]),
              f"{name}: as many flag_values as flag_meanings")
    if h5py.h5ds.is_scale(dataset.id):
        return
    for axis in dataset.dims:
        check(len(axis) == 1, f"an axis of {name} has no scale")
        check(axis[0].parent == dataset.parent, f"{name}: scale elsewhere")


def datasets(group):
    return {k: v for k, v in group.items() if isinstance(v, h5py.Dataset)}


def check_h5py(path):
    """Checks all data sets; returns {group: {name: shape}}."""
    found = {}

    def see(_, thing):
        if isinstance(thing, h5py.Group):
            found[thing.name] = {k: v.shape
                                 for k, v in datasets(thing).items()}
        else:
            check_dataset(thing)
            thing[()]

    with h5py.File(path, "r") as file:
        see("/", file["/"])
        file.visititems(see)
    return found


def check_variable(group, name, variable, coordinates):
    where = f"{group}/{name}"
    facts = {**variable.attrs, **variable.encoding}
    check("long_name" in facts, f"{where} lost its long_name")
    check(variable.dtype.kind in "SUO" or "units" in facts,
          f"{where} lost its units")
    for axis in variable.dims:
        check("phony" not in axis, f"{where} has a phony axis")
        check(axis in coordinates, f"{where}: {axis} is no coordinate")


def check_xarray(path, engine, groups):
    for group, shapes in groups.items():
        with xarray.open_dataset(path, group=group, engine=engine) as data:
            data.load()
            check(set(data.variables) == set(shapes),
                  f"{engine} sees {sorted(data.variables)} in {group}")
            for name, variable in data.variables.items():
                check(variable.shape == shapes[name],
                      f"{engine}: shape of {group}/{name}")
                check_variable(group, name, variable, data.coords)


def check_ncdump(path, groups):
    shown = subprocess.run(["ncdump", "-h", path], capture_output=True,
                           text=True, check=False)
    check(shown.returncode == 0, f"ncdump: {shown.stderr}")
    check("phony" not in shown.stdout, "ncdump shows a phony axis")
    for group in groups:
        last = group.rsplit("/", 1)[1]
        check(not last or f"group: {last} {{" in shown.stdout,
              f"ncdump does not show {group}")


def main():
    path = sys.argv[1]
    groups = check_h5py(path)
    check(len(groups) > 1, "no groups")
    for engine in ("h5netcdf", "netcdf4"):
        check_xarray(path, engine, groups)
    check_ncdump(path, groups)


main()
