#!/usr/bin/python3
"""The Python module in long, parallel and bare use, and as declared (TAP)."""
import ast
import copy
import ctypes
import doctest
import gc
import importlib
import json
import os
import pickle
import re
import signal
import subprocess
import threading
import time
import xml.etree.ElementTree

from cli_room import READER, expect, run_cases
from pages import do_page
from python_room import MODULE, SLOPE, SOURCE, WELLS, WINDOW, prints, python

import matplotlib
import numpy
import slipway
from slipway import _c


# ---- memory, threads, processes ----------------------------------------------

def ctrl_c_ends_long_work(room):
    code = ('import slipway\ns = slipway.Study("spinodal_gen", 0.34)\n'
            'print("on", flush=True)\ntry:\n    s.batch("v_plus", alpha='
            '[0.34 + 1e-9 * k for k in range(10 ** 6)])\n'
            'except KeyboardInterrupt:\n    print(s.v_plus > 0)')
    with subprocess.Popen(
            [READER, '-c', code], text=True, stdout=subprocess.PIPE,
            env=room.environment()) as job:
        expect(job.stdout.readline() == 'on\n', 'it starts')
        try:
            job.wait(2)
        except subprocess.TimeoutExpired:
            job.send_signal(signal.SIGINT)
        expect(job.communicate(timeout=60)[0] == 'True\n', job.returncode)


class Mallinfo(ctypes.Structure):
    _fields_ = [(name, ctypes.c_size_t) for name in (
        'arena', 'ordblks', 'smblks', 'hblks', 'hblkhd', 'usmblks', 'fsmblks',
        'uordblks', 'fordblks', 'keepcost')]


def in_use():
    """Bytes that malloc has given out."""
    gc.collect()
    told = ctypes.CDLL(None).mallinfo2
    told.restype = Mallinfo
    told = told()
    return told.uordblks + told.hblkhd


def cycle(k):
    s = slipway.Study(**SLOPE)
    s.v_plus, s.psi_at_v0
    if k % 10 == 0:
        s.manifold['stable_upper'].v[0]
        s.batch('v_plus', alpha=[0.33, 0.34])
        slipway.Study('spinodal_gen', 0.34).v_plus  # its constants need enclosures
    if k % 100 == 0:
        s.push([1, 10], 1), s.basin((4, 4)), s.sweep(alpha=[0.33, 0.34])
        slipway.System(WELLS, window=WINDOW, d=0.1).manifolds
    for bad in ({'alpha': 7}, {'aplha': 1}):
        try:
            slipway.Study(**{**SLOPE, **bad})
        except slipway.BadScene:
            pass


def a_thousand_studies_leave_nothing(_):
    for k in range(100):
        cycle(k)
    before = in_use()
    for k in range(1000):
        cycle(k)
    left = in_use() - before
    print('#', left, 'bytes more after 1000 studies')
    expect(left < 100_000, left)


def the_lock_of_python_is_released(_):
    """Else nobody wakes while the library works."""
    alpha, found = numpy.linspace(0.3, 0.36, 4000), []
    work = threading.Thread(target=lambda: found.append(
        slipway.v_plus('spinodal_gen', alpha, threads=1)))
    turns = 0
    work.start()
    while work.is_alive():
        time.sleep(0.001)
        turns += 1
    expect(turns > 50 and found[0].exists.any(), turns)


def threads_have_the_numbers_of_one(_):
    def all_of(alpha):
        s = slipway.Study('spinodal_gen', alpha)
        return [repr(n) for n in s.numbers.values()] + [
            s.push(100, 1).fate, s.manifold['stable_lower'].v.tolist()]
    slopes = [0.32 + 0.005 * k for k in range(6)]
    found, alone = [None] * 6, [all_of(alpha) for alpha in slopes]

    def work(k):
        found[k] = all_of(slopes[k])
    threads = [threading.Thread(target=work, args=(k,)) for k in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    expect(found == alone, 'threads')


def a_fork_can_go_on(room):
    code = ('import multiprocessing, slipway\n'
            'def work(alpha):\n    return slipway.v_plus("dieterich_gen", '
            'alpha=[alpha, alpha]).value[1]\n'
            'before = [work(a) for a in (0.33, 0.34)]\n'
            's = slipway.Study("dieterich_gen", 0.34)\ns.push([1, 10], 1)\n'
            'with multiprocessing.get_context("fork").Pool(2) as pool:\n'
            '    print(pool.map(work, [0.33, 0.34]) == before)\n'
            '    print(pool.map(repr, [s]) == [repr(s)])\n'
            'print([work(a) for a in (0.33, 0.34)] == before)')
    expect(prints(room, code, OMP_NUM_THREADS='2') == 'True\n' * 3, 'fork')


# ---- with less, and for people -----------------------------------------------

def numbers_need_no_numpy(room):
    code = ('import sys\nfor name in ("numpy", "xarray", "pandas"):\n'
            '    sys.modules[name] = None\nimport slipway\n'
            's = slipway.Study("dieterich_gen", 0.34)\n'
            'print(f"{s.v_plus:.3f}", s.push(100, 1).fate, '
            's.equilibria[0].type, len(s.numbers) > 20,'
            ' "<table>" in s._repr_html_(), s._repr_svg_())\n'
            'for call in (lambda: s.manifold, lambda: slipway.v_plus('
            '"ruina", alpha=[0.3]), lambda: s.basin((8, 8)), s.frame):\n'
            '    try: call()\n    except ImportError as why: print(why)')
    said = prints(room, code).splitlines()
    expect(said[0] == '2832.223 rest_finite saddle True True None', said)
    expect(len(said) == 5 and all('numpy' in line or 'pandas' in line
                                  for line in said[1:]), said)


def arrays_need_no_xarray(room):
    code = ('import sys\nsys.modules["xarray"] = None\nimport slipway\n'
            's = slipway.Study("dieterich_gen", 0.34)\n'
            'b = s.basin((8, 6), ["slip"])\nw = s.sweep(alpha=[0.33, 0.34])\n'
            'print(b.label.shape, b["slip"].shape, b.dims["v"], sorted(b)[:2],'
            ' b.attrs["fraction_log_runaway"] > 0, "label" in dir(b))\n'
            'print(w.v_plus[1] == s.v_plus, w.units["v_plus"]["scale"])\n'
            'print(hasattr(w, "v_plsu"), len(repr(w)) > 100)')
    expect(prints(room, code) ==
           "(6, 8) (6, 8) ('v',) ['label', 'psi'] True True\n"
           'True V_star\nFalse True\n', 'without xarray')


def a_missing_library_is_said_in_one_line(room):
    room.make('lib')
    subprocess.run(['cp', '-r', os.path.join(MODULE, 'slipway'),
                    room.path('lib')], check=True)
    for library in ('/nowhere/libslipway.so.0', os.path.realpath(__file__)):
        done = python(room, 'import slipway', SLIPWAY_LIBRARY=library)
        last = done.stderr.splitlines()[-1]
        expect(done.returncode == 1 and '$SLIPWAY_LIBRARY' in last and
               last.startswith('ImportError: slipway: '), done.stderr)


def proved_bounds_are_numbers_too(_):
    s = slipway.Study(**SLOPE, **{'accuracy.proved': 'true'})
    lo, hi = s.numbers['v_plus_lo'], s.numbers['v_plus_hi']
    expect(lo.exists and lo.error == 0 and 2832.2233588 < lo < hi < 2832.2233589,
           lo, hi)
    none = s.numbers['psi_at_v0_lo']
    expect(not none.exists and 'proved' in none.reason, none.reason)
    expect('v_plus_lo' not in slipway.Study(**SLOPE).numbers, 'nobody asked')


def studies_are_copied_and_shown(_):
    s = slipway.Study(**SLOPE)
    for one in (pickle.loads(pickle.dumps(s)), copy.copy(s), copy.deepcopy(s)):
        expect(repr(one) == repr(s) and one.v_plus == s.v_plus, one)
    expect({'v_plus', 'saddle_v', 'push', 'manifold'} <= set(dir(s)), dir(s))
    frame = s.frame()
    expect(frame.loc['v_plus', 'value'] == s.v_plus and
           frame.loc['v_plus', 'unit'] == 'V_star', frame)
    w = slipway.System(WELLS, window=WINDOW, d=0.1)
    expect(pickle.loads(pickle.dumps(w)).shares == w.shares, w)
    for one, names in ((s, ['v', 'psi']), (w, ['x', 'y'])):
        root = xml.etree.ElementTree.fromstring(one._repr_svg_())
        tag = '{http://www.w3.org/2000/svg}'
        expect(len(list(root.iter(tag + 'polyline'))) == 4 and
               len(list(root.iter(tag + 'circle'))) == len(one.equilibria) and
               {text.text for text in root.iter(tag + 'text')} >= set(names) and
               'nan' not in one._repr_svg_(), one)
        xml.etree.ElementTree.fromstring('<p>' + one._repr_html_() + '</p>')
    expect('2832.223358854<' in s._repr_html_(), s._repr_html_())


# ---- the module itself -------------------------------------------------------

def headers():
    folder = f'{SOURCE}/include/slipway'
    text = ''
    for name in ('slipway.h', 'slipway_planar.h'):
        with open(f'{folder}/{name}', encoding='utf-8') as file:
            text += re.sub(r'/\*.*?\*/', '', file.read(), flags=re.S)
    return text


KINDS = {'size_t': 'size', 'double': 'real', 'int': 'int', 'long': 'long',
         'int8_t': 'byte', 'uint8_t': 'byte'}
C_NAMES = {'size': 'size', 'real': 'real'}


def declared():
    """{function: its arguments in C}"""
    found = re.findall(r'\bslipway_(\w+)\(([^{};]*)\);', headers())
    return {name: [] if args.strip() == 'void' else args.split(',')
            for name, args in found if 'tell' not in args}


def kind_of(argument):
    """Of an argument in C, in short."""
    stars = argument.count('*') + argument.count('[')
    word = re.sub(r'\b(const|enum|struct)\b|[*\[\]]', ' ', argument).split()[0]
    if word == 'char':
        return '*' * (stars - 1) + 'text'
    handles = ('scene', 'study', 'push', 'sweep', 'plane', 'batch')
    if word in {f'slipway_{name}' for name in handles}:
        return '*' * (stars - 1) + 'handle'
    if word in ('slipway_status', 'slipway_branch'):
        word = 'int'
    return '*' * stars + word.removeprefix('slipway_').removesuffix('_t')


def kind_here(argument):
    stars = 0
    while hasattr(argument, '_type_') and not isinstance(argument._type_, str):
        argument, stars = argument._type_, stars + 1
    name = argument.__name__
    short = {'c_double': 'double', 'c_ulong': 'size', 'c_char_p': 'text',
             'c_int': 'int', 'c_void_p': 'handle', 'c_byte': 'int8',
             'c_ubyte': 'uint8', 'CNumber': 'number'}
    return '*' * stars + short.get(name, name.lower())


def functions_are_declared_as_in_the_headers(_):
    there = declared()
    for name, (_, *takes) in _c.FUNCTIONS.items():
        expect(name in there, name)
        wanted = [kind_of(argument) for argument in there[name]]
        expect([kind_here(one) for one in takes] == wanted, name, wanted,
               [kind_here(one) for one in takes])
    expect(set(there) - set(_c.FUNCTIONS) == {'plane_open', 'scene_set_number'},
           set(there) ^ set(_c.FUNCTIONS))


def structs_lie_as_in_the_headers(room):
    names = {'CNumber': 'slipway_number'}
    lines, wanted = [], []
    for kind in vars(_c).values():
        if isinstance(kind, type) and issubclass(
                kind, ctypes.Structure) and kind is not ctypes.Structure:
            name = names.get(kind.__name__, 'slipway_' + kind.__name__.lower())
            lines.append(f'printf("%zu\\n", sizeof({name}));')
            wanted.append(ctypes.sizeof(kind))
            for field, _ in kind._fields_:
                lines.append(f'printf("%zu\\n", offsetof({name}, {field}));')
                wanted.append(getattr(kind, field).offset)
    room.write('a.c', '#include "slipway_planar.h"\n#include <stddef.h>\n'
                      '#include <stdio.h>\nint main(void)\n{\n'
                      + '\n'.join(lines) + '\n}\n')
    done = subprocess.run(f'cc -I{SOURCE}/include/slipway a.c -o a && ./a',
                          shell=True, cwd=room.folder, text=True,
                          capture_output=True, check=False)
    expect(list(map(int, done.stdout.split())) == wanted and len(wanted) > 60,
           done)


def the_page_is_true(room):
    do_page(room, f'{SOURCE}/docs/python.md')


def run_cell(source, names):
    """Its last line's value, as a notebook shows it."""
    tree = ast.parse(source)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, 'cell', 'exec'), names)
    return last and eval(compile(ast.Expression(last.value), 'cell', 'eval'),
                         names)


def the_notebook_runs(_):
    """Cell by cell, without jupyter, whose packages are many."""
    with open(f'{SOURCE}/docs/slipway.ipynb', encoding='utf-8') as file:
        cells = [cell for cell in json.load(file)['cells']
                 if cell['cell_type'] == 'code']
    names = {}
    matplotlib.use('Agg')
    shown = [run_cell(''.join(cell['source']), names) for cell in cells]
    expect(all(cell['outputs'] == [] for cell in cells), 'outputs')
    expect(sum('<svg' in one._repr_html_() for one in shown
               if hasattr(one, '_repr_html_')) == 2, shown)
    figures = names['plt'].get_fignums()
    expect(len(figures) == 2 and len(shown) == 5, figures)
    names['plt'].close('all')


def what_its_texts_say_is_true(_):
    tried = 0
    for name in sorted(os.listdir(f'{MODULE}/slipway')):
        if name.endswith('.py'):
            module = importlib.import_module(
                'slipway' if name == '__init__.py' else f'slipway.{name[:-3]}')
            done = doctest.testmod(module)
            expect(done.failed == 0, name, done)
            tried += done.attempted
    expect(tried > 15, tried)


run_cases([
    ctrl_c_ends_long_work,
    a_thousand_studies_leave_nothing,
    the_lock_of_python_is_released,
    threads_have_the_numbers_of_one,
    a_fork_can_go_on,
    numbers_need_no_numpy,
    arrays_need_no_xarray,
    a_missing_library_is_said_in_one_line,
    proved_bounds_are_numbers_too,
    studies_are_copied_and_shown,
    functions_are_declared_as_in_the_headers,
    structs_lie_as_in_the_headers,
    the_page_is_true,
    the_notebook_runs,
    what_its_texts_say_is_true,
])
