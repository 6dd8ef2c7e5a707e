#!/usr/bin/python3
"""Runs scripts that read files, each in a process of its own that need not
import again what one before it has: most of their time would go there.

usage: reader.py   asked on stdin, a line of JSON each: folder, path of the
                   script or its text, arguments, files for stdout and stderr;
                   answers with a line, its exit code
"""
import importlib
import json
import os
import runpy
import sys
import traceback

SHARED = ('numpy', 'h5py', 'xarray', 'h5netcdf', 'netCDF4')


def prepare(text):
    for name in SHARED:
        if name.lower() in text.lower() and name not in sys.modules:
            importlib.import_module(name)
            if name == 'xarray':
                sys.modules[name].backends.list_engines()  # it keeps the list


def run(path, text):
    """What python does with a script; returns its exit code."""
    try:
        if path:
            runpy.run_path(path, run_name='__main__')
        else:
            exec(text, {'__name__': '__main__'})  # pylint: disable=exec-used
    except SystemExit as end:
        if end.code is None or isinstance(end.code, int):
            return end.code or 0
        print(end.code, file=sys.stderr)
        return 1
    except BaseException:  # pylint: disable=broad-except
        traceback.print_exc()
        return 1
    return 0


def answer(asked):
    path, text = asked['path'], asked['text']
    if path:
        with open(path, encoding='utf-8') as file:
            text = file.read()
    prepare(text)
    child = os.fork()
    if child:
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    for number, name in (1, 'out'), (2, 'err'):
        os.dup2(os.open(asked[name], os.O_WRONLY | os.O_TRUNC), number)
    os.chdir(asked['folder'])
    sys.argv = [path or '-c', *asked['args']]
    if path:
        sys.path[0] = os.path.dirname(path)
    code = run(path, text)
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


for line in sys.stdin:
    print(answer(json.loads(line)), flush=True)
