#!/usr/bin/env python3
"""Inequalities of the proofs, weakened one by one: which test sees it.

    tests/proof/mutations.py BUILD [WORD...]

Each line of mutations.tsv is a place of a file and what stands there instead.
The file is copied, changed and compiled, and the tests of the build folder
BUILD that are meant to see it are linked with that and run, until one fails or
takes 20 s of processor; two lines at a time.  Only lines that have one of the
words.  Sources are not touched.
"""

import concurrent.futures
import csv
import json
import os
import pathlib
import re
import resource
import shlex
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BESIDE = {  # else the test of its own name
    'interval': ['interval_power', 'interval_math', 'proof_field', 'proof_cone', 'proof_cell'],
    'plane_proof': ['plane_proof'], 'proof_plane': ['proof_plane', 'plane_proof'],
    'proof_trap': ['proof_trap', 'plane_proof'], 'proof_cell': ['proof_cell', 'proof'],
    'proof_flow': ['proof_cone', 'proof_cell'], 'proof_fold': ['proof_side'],
    'proof_input': ['proof'], 'proof_knee': ['proof_knee', 'proof'],
    'proof_law': ['proof_root', 'proof_law'],
    'proof_numbers': ['proof', 'study_proof'], 'proof': ['proof_rest', 'proof_root', 'proof'],
}


def rows():
    with open(HERE / 'mutations.tsv', newline='', encoding='utf-8') as table:
        for row in csv.DictReader(table, delimiter='\t', quoting=csv.QUOTE_NONE):
            yield {k: v.encode().decode('unicode_escape') for k, v in row.items()}


def ninja(build, *args):
    return subprocess.run(['ninja', '-C', build, *args], capture_output=True, text=True,
                          check=True).stdout


def tests_of(file):
    own = pathlib.Path(file).stem
    return BESIDE.get(own.split('_')[0] if own.startswith('interval') else own, [own])


def sources_of(build, file):
    """Itself, or those beside it that include it."""
    if file.endswith('.c'):
        return [file]
    beside = re.compile(rf'^    \.\./({os.path.dirname(file)}/\w+\.c)$', re.M)
    blocks = ninja(build, '-t', 'deps').split('\n\n')
    found = [beside.search(b) for b in blocks if f'../{file}\n' in b + '\n']
    return sorted({f[1] for f in found if f})


def compile_in(build, folder, row):
    """The objects; [] if one does not build."""
    file, objects = ROOT / row['file'], []
    for header in file.parent.glob('*.h'):
        shutil.copy(header, folder)
    sources = sources_of(build, row['file'])
    text = file.read_text(encoding='utf-8').replace(row['text'], row['instead'], 1)
    with open(f'{build}/compile_commands.json', encoding='utf-8') as commands:
        how = {c['file'].removeprefix('../'): c for c in json.load(commands)}
    for source in sources:
        copy = pathlib.Path(folder, pathlib.Path(source).name)
        shutil.copy(ROOT / source, copy)
        pathlib.Path(folder, file.name).write_text(text, encoding='utf-8')
        args = how[source]['command'].split()
        objects.append(f'{copy}.o')
        args[args.index('-o') + 1] = objects[-1]
        args[args.index('-c') + 1] = str(copy)
        args[args.index('-MF') + 1] = '/dev/null'
        if subprocess.run(args, cwd=build, capture_output=True).returncode:
            return []
    return objects


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (20, 20))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def seen_by(build, links, row):
    with tempfile.TemporaryDirectory() as folder:
        objects = compile_in(build, folder, row)
        for test in tests_of(row['file']) if objects else []:
            args = shlex.split(links[test])
            at = args.index('-o') + 2
            args[at - 1:at] = [f'{folder}/test', *objects]
            subprocess.run(args, cwd=build, capture_output=True, check=True)
            run = subprocess.run([f'{folder}/test'], capture_output=True, cwd=ROOT,
                                 preexec_fn=limit,
                                 env=os.environ | {'SOURCE_ROOT': str(ROOT),
                                                   'CMOCKA_TEST_ABORT': '1'})
            if run.returncode:
                return test
    return 'ESCAPES' if objects else 'DOES NOT BUILD'


def main(build, *words):
    wanted = [(f'{r["file"]}: {r["weakened"]}', r) for r in rows()]
    wanted = [w for w in wanted if not words or any(word in w[0] for word in words)]
    for line, row in wanted:
        if (ROOT / row['file']).read_text(encoding='utf-8').count(row['text']) == 0:
            sys.exit(f'{line}: {row["text"]!r} is not there')
    tests = {t for _, row in wanted for t in tests_of(row['file'])}
    ninja(build, *[f'tests/test_{t}' for t in tests])
    links = {t: ninja(build, '-t', 'commands', f'tests/test_{t}').splitlines()[-1]
             for t in tests}
    count = {}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        found = pool.map(lambda w: seen_by(build, links, w[1]), wanted)
        for (line, _), by in zip(wanted, found):
            print(f'{line}: {by}', flush=True)
            count[by] = count.get(by, 0) + 1
    print(count)
    return bool({'ESCAPES', 'DOES NOT BUILD'} & set(count))


if __name__ == '__main__':
    sys.exit(main(os.path.abspath(sys.argv[1]), *sys.argv[2:]))
