#!/usr/bin/env python3
"""Eight threads, each with its own studies, under the thread sanitizer (TAP).

usage: test_threads.py SOURCE_ROOT
"""
import os
import subprocess
import sys
import tempfile

SOURCE = os.path.realpath(sys.argv[1])


def ran(command, folder, **more):
    return subprocess.run(command, cwd=folder, text=True, check=False,
                          capture_output=True, timeout=500,
                          stdin=subprocess.DEVNULL,
                          env={**os.environ, **more})


def main():
    with tempfile.TemporaryDirectory() as folder:
        for command in (
                ['meson', 'setup', '-Db_sanitize=thread', '-Db_lundef=false',
                 '-Dtests=disabled', '-Doptimization=0', '-Ddebug=false',
                 '-Dwarning_level=0', 'b', SOURCE],
                ['ninja', '-C', 'b', 'lib/libslipway.a'],
                ['sh', '-c', 'cc -fsanitize=thread -I "$0/include" '
                 '"$0/tests/outside/eight_threads.c" b/lib/libslipway.a -o e '
                 '$(pkg-config --libs gsl yaml-0.1) -lmpfi -lmpfr -lgmp -fopenmp '
                 '-lm', SOURCE]):
            done = ran(command, folder)
            if done.returncode:
                print(f'Bail out! {command}: {done.stdout}{done.stderr}')
                return 1
        # gomp is not watched: with one thread it starts none
        done = ran(['./e'], folder, OMP_NUM_THREADS='1',
                   TSAN_OPTIONS='exitcode=66')
        print(done.stdout, end='')
        print('\n'.join('# ' + line for line in done.stderr.splitlines()))
        return done.returncode


if __name__ == '__main__':
    sys.exit(main())
