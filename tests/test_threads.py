#!/usr/bin/env python3
"""Eight threads, each with its own studies, under the thread sanitizer (TAP).

usage: test_threads.py SOURCE_ROOT BUILD_ROOT

What of the build's library they link is compiled again, watched.
"""
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

SOURCE, BUILD = map(os.path.realpath, sys.argv[1:3])
PROGRAM = [f'-I{SOURCE}/include', f'{SOURCE}/tests/outside/eight_threads.c']
LIBRARIES = ['-lmpfi', '-lmpfr', '-lgmp', '-fopenmp', '-lm']


def ran(*command, cwd=BUILD, **more):
    done = subprocess.run(command, cwd=cwd, text=True, check=False,
                          capture_output=True, timeout=500,
                          stdin=subprocess.DEVNULL,
                          env={**os.environ, **more})
    if done.returncode:
        print(f'Bail out! {command}: {done.stdout}{done.stderr}')
        sys.exit(1)
    return done.stdout


def linked(folder):
    """The names of the library's objects that the program takes."""
    ran('cc', *PROGRAM, f'{BUILD}/lib/libslipway.a', *libraries(), '-o',
        f'{folder}/plain', f'-Wl,-Map={folder}/map')
    with open(f'{folder}/map', encoding='utf-8') as file:
        return set(re.findall(r'^\S*libslipway\.a\((\S+)\)$', file.read(), re.M))


def libraries():
    return ran('pkg-config', '--libs', 'gsl', 'yaml-0.1').split() + LIBRARIES


def watched(folder):
    """Objects, compiled on all processors."""
    wanted = linked(folder)
    with open(f'{BUILD}/compile_commands.json', encoding='utf-8') as file:
        entries = [e for e in json.load(file)
                   if os.path.basename(e['output']) in wanted and
                   not re.match('tests/|apps/|lib/(race|store|plot)/', e['output'])]

    def compiled(number):
        entry, out = entries[number], f'{folder}/{number}.o'
        flags = [word for word in shlex.split(entry['command']) if re.match(
            '-I|-D|-std|-m|-f(openmp|fp-contract|no-math-errno)', word)]
        ran('cc', *flags, '-fsanitize=thread', '-O0', '-w', '-c', entry['file'],
            '-o', out)
        return out

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(compiled, range(len(entries))))


def main():
    with tempfile.TemporaryDirectory() as folder:
        ran('cc', '-fsanitize=thread', *PROGRAM, *watched(folder), *libraries(),
            '-o', f'{folder}/e')
        # gomp is not watched: with one thread it starts none
        done = subprocess.run([f'{folder}/e'], text=True, check=False,
                              capture_output=True, timeout=500,
                              env={**os.environ, 'OMP_NUM_THREADS': '1',
                                   'TSAN_OPTIONS': 'exitcode=66'})
        print(done.stdout, end='')
        print('\n'.join('# ' + line for line in done.stderr.splitlines()))
        return done.returncode


if __name__ == '__main__':
    sys.exit(main())
