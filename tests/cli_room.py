"""What the cli_*.py share: a folder to run slipway in, and TAP."""
import atexit
import csv
import inspect
import json
import os
import pty
import re
import shutil
import subprocess
import sys
import tempfile
import traceback
import xml.etree.ElementTree

LAWS = ['dieterich', 'dieterich_gen', 'ruina', 'perrin', 'spinodal',
        'spinodal_gen', 'spinodal_phi_gen']
SLOPE = ['--law', 'dieterich_gen', '--alpha', '0.34']
READER = '/usr/bin/python3'  # Debian's, with h5py and xarray


def shown(svg):
    """The words that a figure shows, each text on a line: lines that were
    broken are joined, and what stands below or above a line is in it."""
    root = xml.etree.ElementTree.fromstring(svg)
    texts = (''.join(text.itertext()) for text in
             root.iter('{http://www.w3.org/2000/svg}text'))
    return ' '.join(texts)


def read_by(path, text, args, folder, started=[]):
    """By reader.py, which is started once and ends with this program."""
    if not started:
        started.append(subprocess.Popen(
            [READER, os.path.join(os.path.dirname(__file__), 'reader.py')],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True))
        atexit.register(started[0].communicate)
    said = [tempfile.NamedTemporaryFile(mode='w+') for _ in range(2)]
    print(json.dumps({'path': path, 'text': text, 'args': args,
                      'folder': folder, 'out': said[0].name,
                      'err': said[1].name}), file=started[0].stdin, flush=True)
    code = int(started[0].stdout.readline())
    return subprocess.CompletedProcess([path or text, *args], code,
                                       *(file.read() for file in said))


class Room:
    """An empty folder of its own, with slipway first in PATH."""

    def __init__(self, folder, slipway, source):
        self.folder = folder
        self.source = source
        self.slipway = slipway
        self.bin = os.path.join(folder, '.bin')
        os.mkdir(self.bin)
        os.symlink(slipway, os.path.join(self.bin, 'slipway'))

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), 'wb') as file:
            file.write(text if isinstance(text, bytes) else text.encode())

    def bytes(self, name):
        with open(self.path(name), 'rb') as file:
            return file.read()

    def read(self, name):
        return self.bytes(name).decode()

    def names(self, folder='.'):
        return sorted(name for name in os.listdir(self.path(folder))
                      if name != '.bin')

    def make(self, name):
        os.makedirs(self.path(name))

    def bring(self, name):
        """A copy of a folder of the project."""
        shutil.copytree(os.path.join(self.source, name), self.path(name))

    def fake(self, name, body):
        path = os.path.join(self.bin, name)
        with open(path, 'w', encoding='utf-8') as file:
            file.write('#!/bin/sh\n' + body + '\n')
        os.chmod(path, 0o755)

    def environment(self, **changes):
        found = dict(os.environ, PATH=self.bin + ':' + os.environ['PATH'])
        found.pop('OMP_NUM_THREADS', None)
        return {**found, **changes}

    def run(self, *args, cwd='.', **changes):
        """slipway with these arguments and changes of the environment."""
        return subprocess.run(
            [self.slipway, *args], cwd=self.path(cwd), text=True, timeout=300,
            env=self.environment(**changes), capture_output=True,
            stdin=subprocess.DEVNULL, check=False)

    def good(self, *args, **how):
        """The same; it must succeed and complain of nothing."""
        done = self.run(*args, **how)
        expect((done.returncode, done.stderr) == (0, ''), done)
        return done.stdout

    def json(self, *args):
        return json.loads(self.good(*args, '--json'))

    def shell(self, text, cwd='.'):
        return subprocess.run(
            ['sh', '-c', text], cwd=self.path(cwd), text=True, timeout=300,
            env=self.environment(), capture_output=True,
            stdin=subprocess.DEVNULL, check=False)

    def python(self, script, *args):
        """A script of this folder, by its name, or the text of one, run by
        the python with h5py and xarray."""
        return read_by(self.script(script) if script.endswith('.py') else '',
                       script, args, self.folder)

    def reads(self, script, *args):
        """What it prints; it must succeed."""
        done = self.python(script, *args)
        expect(done.returncode == 0, done)
        return done.stdout

    def reference(self, name):
        path = os.path.join(self.source, 'tests', 'reference', name)
        with open(path, encoding='utf-8') as file:
            return list(csv.DictReader(file))

    def script(self, name):
        return os.path.join(self.source, 'tests', name)


def expect(holds, *told):
    """Told to whoever reads the log."""
    assert holds, ' '.join(str(item) for item in told)


def expect_number(said, name, found):
    """That a number's line has the value to the digits that its bar leaves."""
    line = re.search(rf'^ +{name} +(\S+) +\+- (\S+)', said, re.M)
    expect(line, name, said)
    cut = abs(float(line[1]) - found['value'])
    expect(cut + found['error'] <= float(line[2]), name, said)


def refused(done, code, *words):
    """Exactly one line, which holds the words, and nothing printed."""
    lines = done.stderr.splitlines()
    expect(done.returncode == code and done.stdout == '' and len(lines) == 1
           and lines[0].startswith('slipway: ') and lines[0].isprintable()
           and len(lines[0]) < 600 and all(word in lines[0] for word in words),
           f'expected exit {code}, one line with {words}:', done)


def starts(room, *args, **how):
    return subprocess.Popen([room.slipway, *args], cwd=room.folder, text=True,
                            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            env=room.environment(),
                            **{'stderr': subprocess.PIPE, **how})


def seen_on_a_terminal(room, *args):
    """What a terminal on stderr receives."""
    ours, theirs = pty.openpty()
    job = starts(room, *args, stderr=theirs)
    os.close(theirs)
    seen = b''
    try:
        while part := os.read(ours, 4096):
            seen += part
    except OSError:  # its other end is closed
        pass
    os.close(ours)
    job.communicate()
    expect(job.returncode == 0, seen)
    return seen.decode()


def uncalled():
    """Functions of a room that the script defines and names nowhere else."""
    script = sys.modules['__main__']
    text = inspect.getsource(script)
    return [name for name, what in inspect.getmembers(script, inspect.isfunction)
            if what.__module__ == '__main__' and text.count(name) == 1
            and list(inspect.signature(what).parameters) == ['room']]


def run_cases(cases):
    """usage of every cli_*.py: PATH_TO_SLIPWAY SOURCE_ROOT"""
    expect(uncalled() == [], 'not among the cases:', uncalled())
    slipway, source = (os.path.realpath(path) for path in sys.argv[1:3])
    failed = False
    print(f'1..{len(cases)}')
    for number, case in enumerate(cases, 1):
        with tempfile.TemporaryDirectory() as folder:
            try:
                case(Room(os.path.realpath(folder), slipway, source))
                bad = ''
            except Exception:  # whatever it was, the next case runs
                bad = traceback.format_exc()
        failed = failed or bad != ''
        print(f'{"not ok" if bad else "ok"} {number} - {case.__name__}')
        print(''.join('# ' + line + '\n' for line in bad.splitlines()), end='',
              flush=True)
    sys.exit(failed)
