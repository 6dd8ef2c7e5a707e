"""The shared library, as include/slipway declares it; its handles and faults.

The library is the file that $SLIPWAY_LIBRARY names, else `libslipway.so.0` in
this folder or the nearest one above it, else where the loader finds it.
"""
import ctypes as c
import functools
import os
import pathlib
import signal
import threading
import types
import weakref

NAME = 'libslipway.so.0'


class Error(Exception):
    """What the library could not do, in the program's own line."""


class OutOfMemory(Error, MemoryError):
    """There was not enough memory."""


class BadArgument(Error, ValueError):
    """A value outside its range, or a name that there is not."""


class BadScene(Error, ValueError):
    """What was asked for is wrong; the line names key and value."""


class NumericalFailure(Error, ArithmeticError):
    """An iteration stopped before its tolerance."""


class Stopped(Error):
    """The work was stopped."""


class FileTrouble(Error, OSError):
    """A file cannot be read."""


# By slipway_status.
ERRORS = (None, OutOfMemory, BadArgument, BadScene, NumericalFailure, Stopped,
          FileTrouble)


# ---- types, as the headers have them -----------------------------------------

def struct(name, /, **fields):
    return type(name, (c.Structure,), {'_fields_': list(fields.items())})


real, size, text, byte = c.c_double, c.c_size_t, c.c_char_p, c.c_uint8
Fault = struct('Fault', text=c.c_char * 512)
CNumber = struct('CNumber', value=real, error=real, reason=text, spread=real)
Label = struct('Label', name=text, unit=text, scale=text, text=text)
Tell = c.CFUNCTYPE(c.c_int, c.c_void_p, text, c.c_uint64, c.c_uint64)
Monitor = struct('Monitor', tell=Tell, ctx=c.c_void_p)
Equilibrium = struct('Equilibrium', type=c.c_int, v=CNumber, psi=CNumber,
                     mu=CNumber, lambda_minus=CNumber, lambda_plus=CNumber)
Point = struct('Point', arc=real, v=real, psi=real, slope=real, slip=real,
               time=real, work=real, excess=real, error=real)
State = struct('State', v=real, psi=real)
Answer = struct('Answer', fate=c.c_int, slip=CNumber, time=CNumber,
                mu_mean=CNumber, v_kick=CNumber, psi_kick=CNumber)
Rest = struct('Rest', name=text, type=c.c_int, state=CNumber * 2,
              re=CNumber * 2, im=CNumber * 2, share=CNumber)
Manifold = struct('Manifold', saddle=size, kind=c.c_int, branch=c.c_int,
                  end=text, to=c.c_long, length=CNumber)
Place = struct('Place', arc=real, state=real * 2, slope=real, error=real)
Axis = struct('Axis', name=text, is_log=c.c_int, range=real * 2)
Column = struct('Column', value=c.POINTER(real), error=c.POINTER(real),
                reason=c.POINTER(byte))
Share = struct('Share', attractor=text, fraction=CNumber)

# ---- functions: what they return, what they take -----------------------------

handle, status, to = c.c_void_p, c.c_int, c.POINTER
out, why, monitor = to(handle), to(Fault), to(Monitor)
FUNCTIONS = {
    'version': (text,),
    'status_text': (text, status),
    'scene_new': (status, out),
    'scene_read': (status, text, out, why),
    'scene_set': (status, handle, text, text),
    'scene_free': (None, handle),
    'study_run': (status, handle, monitor, out, why),
    'study_free': (None, handle),
    'study_number': (status, handle, text, to(CNumber)),
    'study_label': (Label, handle, size),
    'study_axis': (Axis, handle, c.c_int),
    'study_equilibria': (size, handle, to(Equilibrium), size),
    'study_branch': (to(Point), handle, c.c_int, to(size)),
    'basin_size': (None, handle, to(size), to(size)),
    'basin_axes': (status, handle, to(real), to(real)),
    'basin_labels': (status, handle, size, size, to(c.c_int8)),
    'basin_margins': (status, handle, size, size, to(real), to(real)),
    'basin_field': (status, handle, text, size, size, to(real), to(real)),
    'push_open': (status, handle, monitor, out, why),
    'push_find': (status, handle, to(State), size, monitor, to(Answer), why),
    'push_free': (None, handle),
    'sweep_run': (status, handle, monitor, out, why),
    'sweep_axis': (to(real), handle, size, to(size), to(Label)),
    'sweep_label': (Label, handle, size),
    'sweep_numbers': (status, handle, text, to(CNumber), size),
    'sweep_free': (None, handle),
    'batch_open': (status, handle, to(text), size, to(text), size, out, why),
    'batch_run': (status, handle, size, to(to(real)), c.c_int, monitor,
                  to(Column), why),
    'batch_reason': (text, handle, byte),
    'batch_free': (None, handle),
    'plane_run': (status, handle, monitor, out, why),
    'plane_axis': (Axis, handle, c.c_int),
    'plane_equilibria': (size, handle, to(Rest), size, to(c.c_int)),
    'plane_manifolds': (size, handle, to(Manifold), size),
    'plane_points': (to(Place), handle, size, to(size)),
    'plane_shares': (size, handle, to(Share), size),
    'plane_goal': (status, handle, real, real, to(text), to(CNumber)),
    'plane_free': (None, handle),
}


def find():
    """Path or name of the library."""
    named = os.environ.get('SLIPWAY_LIBRARY')
    if named:
        return named
    for folder in pathlib.Path(__file__).resolve().parents:
        if (folder / NAME).is_file():
            return str(folder / NAME)
    return NAME


def load():
    try:
        found = c.CDLL(find())
    except OSError as error:
        raise ImportError(
            f'slipway: {error}; expected {NAME} beside this module, above it, '
            'among the libraries of the system, or in $SLIPWAY_LIBRARY'
        ) from None
    functions = {'pause': found.omp_pause_resource_all}
    for name, (gives, *takes) in FUNCTIONS.items():
        functions[name] = getattr(found, 'slipway_' + name)
        functions[name].restype, functions[name].argtypes = gives, takes
    return types.SimpleNamespace(**functions)


library = load()

# Threads of OpenMP do not outlive a fork: they end before it, and begin again
# at the next work of either process.
SOFT = 1
os.register_at_fork(before=lambda: library.pause(SOFT))


# ---- calls -------------------------------------------------------------------

class Handle:
    """What the library hands out, freed when nothing refers to it any more."""

    def __init__(self, kind):
        self._as_parameter_ = handle()
        end = weakref.finalize(self, getattr(library, kind + '_free'),
                               self._as_parameter_)
        end.atexit = False

    def out(self):
        """Where the library puts it."""
        return c.byref(self._as_parameter_)


def check(failed, fault=None):
    """Raises what the status of a call says."""
    if failed:
        line = fault.text if fault else library.status_text(failed)
        raise ERRORS[failed](line.decode(errors='replace'))


def begin(kind, function, *arguments):
    """What slipway_KIND_FUNCTION(arguments, &out, &why) opens, with a monitor
    before the last two where it takes one."""
    opened, fault = Handle(kind), Fault()
    call = getattr(library, f'{kind}_{function}')
    work = functools.partial(call, *arguments)
    ends = opened.out(), fault
    if monitor in call.argtypes:
        failed = interruptible(lambda told: work(told, *ends))
    else:
        failed = work(*ends)
    check(failed, fault)
    return opened


def interruptible(work):
    """work(monitor), which Ctrl-C ends: only the main thread is told of it."""
    if (threading.current_thread() is not threading.main_thread()
            or signal.getsignal(signal.SIGINT)
            is not signal.default_int_handler):
        return work(None)
    stop = []
    tell = Tell(lambda *_: len(stop))
    before = signal.signal(signal.SIGINT, lambda *_: stop.append(1))
    try:
        done = work(c.byref(Monitor(tell, None)))
    finally:
        signal.signal(signal.SIGINT, before)
    if stop:
        raise KeyboardInterrupt
    return done
