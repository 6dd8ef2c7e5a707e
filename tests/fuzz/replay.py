#!/usr/bin/env python3
"""The fuzz targets over their seeds and all findings of old (TAP).

usage: replay.py PATH_TO_SLIPWAY SOURCE_ROOT FOLDER_OF_REPLAY_PROGRAMS
"""
import os
import subprocess
import sys
import tempfile

import seeds

SECONDS = 60  # for all files of a target: none may hang


def replay(program, folder, environment):
    files = sorted(os.path.join(folder, name) for name in os.listdir(folder))
    done = subprocess.run([program, *files], env=environment, text=True,
                          timeout=SECONDS, capture_output=True, check=False)
    told = done.stdout.splitlines()
    print(f'# {len(files)} files')
    bad = done.returncode != 0 or 'runtime error' in done.stderr  # UBSan's
    if bad:
        print('# over', told[-1] if told else 'nothing')
        print('# ' + done.stderr.replace('\n', '\n# '))
    return not bad and len(told) == len(files) > 0


def main(slipway, source, programs):
    names = ['csv', 'formula', 'hdf5', 'journal', 'ode', 'scene']
    print(f'1..{len(names)}')
    with tempfile.TemporaryDirectory() as folder:
        seeds.main(slipway, source, folder)
        environment = dict(os.environ, FUZZ_WHOLE=folder + '/whole.h5')
        for i, name in enumerate(names, 1):
            good = replay(f'{programs}/replay_{name}', f'{folder}/{name}',
                          environment)
            print('ok' if good else 'not ok', i, '-',
                  f'all_files_of_{name}_are_read_or_refused')


main(*(os.path.realpath(path) for path in sys.argv[1:]))
