"""What test_python*.py share: the module of this build in Debian's python3.

usage of them: PATH_TO_SLIPWAY SOURCE_ROOT LIBRARY
"""
import os
import subprocess
import sys

from cli_room import READER, expect

if os.path.realpath(sys.executable) != os.path.realpath(READER):
    os.execv(READER, [READER, *sys.argv])

SOURCE = os.path.realpath(sys.argv[2])
MODULE = os.path.join(SOURCE, 'lib', 'python')
os.environ['SLIPWAY_LIBRARY'] = os.path.realpath(sys.argv[3])
os.environ['PYTHONPATH'] = MODULE
os.environ['PYTHONDONTWRITEBYTECODE'] = '1'
sys.dont_write_bytecode = True
sys.path.insert(0, MODULE)

SLOPE = {'law': 'dieterich_gen', 'alpha': 0.34}
COMMAND = ['--law', 'dieterich_gen', '--alpha', '0.34']
WELLS = "x' = y; y' = x - x^3 - d*y"
WINDOW = {'x': [-2, 2], 'y': [-2, 2]}


def python(room, code, *more, **changes):
    return subprocess.run(
        [READER, '-c', code], text=True, timeout=300, capture_output=True,
        cwd=room.folder, check=False,
        env=room.environment(**changes))


def prints(room, code, **changes):
    done = python(room, code, **changes)
    expect((done.returncode, done.stderr) == (0, ''), done)
    return done.stdout
