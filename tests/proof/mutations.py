#!/usr/bin/env python3
"""Inequalities of the proofs, weakened one by one: which test sees it.

    tests/proof/mutations.py BUILD [WORD...]

Each line of mutations.tsv is a place of a file and what stands there instead.
The file is changed, its tests are built in the build folder BUILD and run, the
one beside it first, until one fails or takes a minute, and the file is put
back.  Only lines that have one of the words.  It takes an hour; nothing but a
copy of the sources should be given to it.
"""

import csv
import os
import pathlib
import resource
import signal
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BESIDE = {'flow': ['cone', 'cell'], 'fold': ['side'], 'root': ['law']}
OTHERS = ['field', 'join', 'cone', 'cell', 'side', 'rest', 'end', 'law', '']


def rows():
    with open(HERE / 'mutations.tsv', newline='', encoding='utf-8') as table:
        for row in csv.DictReader(table, delimiter='\t', quoting=csv.QUOTE_NONE):
            yield {k: v.encode().decode('unicode_escape') for k, v in row.items()}


def tests_of(file):
    own = pathlib.Path(file).stem.removeprefix('proof_')
    first = BESIDE.get(own, [own])
    names = [t for t in first if t in OTHERS] + [t for t in OTHERS if t not in first]
    return ['test_proof' + (t and '_' + t) for t in names]


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (60, 60))


def seen_by(build, file):
    for test in tests_of(file):
        made = subprocess.run(['ninja', '-C', build, 'tests/' + test], capture_output=True)
        if made.returncode:
            return 'does not build'
        run = subprocess.run([f'{build}/tests/{test}'], capture_output=True, cwd=ROOT, preexec_fn=limit,
                             env=os.environ | {'SOURCE_ROOT': str(ROOT)})
        if run.returncode:
            return test
    return 'ESCAPES'


def main(build, *words):
    escaped = 0
    for row in rows():
        line = f'{row["file"]}: {row["weakened"]}'
        if words and not any(w in line for w in words):
            continue
        path = ROOT / row['file']
        text = path.read_text(encoding='utf-8')
        if row['text'] not in text:
            sys.exit(f'{line}: {row["text"]!r} is not there')
        try:
            path.write_text(text.replace(row['text'], row['instead'], 1), encoding='utf-8')
            found = seen_by(build, row['file'])
        finally:
            path.write_text(text, encoding='utf-8')
        escaped += found == 'ESCAPES'
        print(f'{line}: {found}', flush=True)
    return escaped > 0


if __name__ == '__main__':
    for ending in signal.SIGTERM, signal.SIGHUP:
        signal.signal(ending, lambda *_: sys.exit('ended by a signal'))
    sys.exit(main(os.path.abspath(sys.argv[1]), *sys.argv[2:]))
