"""Slipway: phase planes of rate-and-state friction, and of formulas.

>>> import slipway
>>> s = slipway.Study(law="dieterich_gen", alpha=0.34)
>>> s.v_plus
2832.2233588540257 +- 1.7e-10

Study is a block on a slope, System a planar system typed as formulas; sweep
takes a scene's numbers over a key, v_plus, v_minus, x_excess and numbers those
of arrays of materials at once.  What fails raises an Error with the program's
own line.
"""
from ._arrays import Numbers
from ._batch import numbers, v_minus, v_plus, x_excess
from ._c import (BadArgument, BadScene, Error, FileTrouble, NumericalFailure,
                 OutOfMemory, Stopped, library)
from ._number import Number
from ._study import Study, sweep
from ._system import System

__version__ = library.version().decode()
__all__ = ['BadArgument', 'BadScene', 'Error', 'FileTrouble', 'Number',
           'Numbers', 'NumericalFailure', 'OutOfMemory', 'Stopped', 'Study',
           'System', 'numbers', 'sweep', 'v_minus', 'v_plus', 'x_excess']

for _name in __all__:
    globals()[_name].__module__ = __name__
