#!/usr/bin/python3
"""Python beside the C library: v_plus of many materials, and two threads.

usage: bench_python.py PATH_TO_SLIPWAY SOURCE_ROOT LIBRARY [DRAWS]
"""
import multiprocessing
import os
import sys
import threading
import time

sys.path.insert(0, os.path.join(os.path.dirname(__file__), '..'))
from python_room import SLOPE

import numpy
import slipway
from slipway import _batch, _c, _scene

DRAWS = int(sys.argv[4]) if len(sys.argv) > 4 else 100_000
LAW = SLOPE['law']
ALPHA = numpy.random.default_rng(1).uniform(0.32, 0.36, DRAWS)


def by_c():
    """The library's own calls: all that is Python's is done before."""
    scene = _scene.scene_of(None, {'law.preset': LAW})
    keys, names = _batch.texts(['slope.alpha']), _batch.texts(['v_plus'])
    batch = _c.begin('batch', 'open', scene, keys, 1, names, 1)
    return lambda: _batch.run(batch, 1, DRAWS, [ALPHA], 1)


def by_python():
    return lambda: slipway.v_plus(LAW, ALPHA, threads=1)


def seconds(make, clock):
    work = make()
    start = clock()
    work()
    return clock() - start


def twice(worker):
    """The work in two threads, or in two processes."""
    def both():
        workers = [worker(target=by_python()) for _ in range(2)]
        for one in workers:
            one.start()
        for one in workers:
            one.join()
    return lambda: both


def main():
    runs = [(seconds(by_c, time.process_time),
             seconds(by_python, time.process_time)) for _ in range(3)]
    c, python = map(min, zip(*runs))
    print(f'v_plus of {DRAWS} slopes: {1e6 * c / DRAWS:.1f} us each from C, '
          f'from Python {python / c:.3f} times that (processor time, '
          'best of 3)')
    one, threads, processes = (
        seconds(make, time.perf_counter) for make in
        (by_python, twice(threading.Thread), twice(multiprocessing.Process)))
    print(f'twice the work on {os.cpu_count()} processors: two threads '
          f'{threads / one:.2f}, two processes {processes / one:.2f} times as '
          'long as one')


main()
