#!/usr/bin/env python3
"""lib/api.py: the C library's pages by doxygen, without a warning (TAP).

usage: test_api.py SOURCE_ROOT

Doxygen brings 50 MB of compiler libraries, so ./run tests does not install it.
"""
import os
import shutil
import subprocess
import sys
import tempfile

SOURCE = os.path.realpath(sys.argv[1])
sys.path.insert(0, os.path.join(SOURCE, 'lib'))
sys.dont_write_bytecode = True
import api  # noqa: E402  (of the sources)

HEADER = '''/*
 * a.h -- what it is,
 *
 *     f(x) < 1.
 */
#include "b.h"

/* Each of them. */
void first(void);
int second(int a,
           int b);

/* A pair. */
struct pair {
    double v, psi; /* both; a "text"
                      of two lines */
    int alone;
};

/* ---- a heading ---- */

void bare(void);
'''
SEEN = r'''/** @file a.h
what it is,

@verbatim
    f(x) < 1.
@endverbatim */
#include "b.h"

/** Each of them. */
void first(void);

/** Each of them. */
int second(int a,
           int b);

/** A pair. */
struct pair {
double v; /**< both; a \"text\"
of two lines */
double psi; /**< both; a \"text\"
of two lines */
    int alone;
};

/* ---- a heading ---- */

void bare(void);
'''


def comments_are_seen_as_they_are_meant(_):
    seen = api.for_doxygen(HEADER, 'a.h')
    assert seen == SEEN, seen


def pages(source, folder):
    return subprocess.run(
        [sys.executable, '-B', os.path.join(source, 'lib', 'api.py'),
         os.path.join(folder, 'pages')], text=True, capture_output=True,
        timeout=300, check=False)


def there_is_no_warning(folder):
    done = pages(SOURCE, folder)
    assert (done.returncode, done.stderr) == (0, ''), done.stderr
    page = os.path.join(folder, 'pages', 'html', 'law_8h.html')
    with open(page, encoding='utf-8') as file:
        assert 'Whether the value of' in file.read(), page


def what_is_exported_must_be_documented(folder):
    copy = os.path.join(folder, 'copy')
    for room in ('lib', 'manifold', 'portrait'):
        shutil.copytree(os.path.join(SOURCE, room), os.path.join(copy, room))
    path = os.path.join(copy, 'lib', 'friction', 'law.h')
    with open(path, encoding='utf-8') as file:
        text = file.read()
    for comment in ('/* Whether the value of `key` can change anything the law '
                    'computes. */\n', '/* One of each. */\n'):
        assert text.count(comment) == 1, comment
        text = text.replace(comment, '')
    with open(path, 'w', encoding='utf-8') as file:
        file.write(text)
    done = pages(copy, folder)
    told = done.stderr.splitlines()
    assert done.returncode == 1 and len(told) == 2, told
    assert 'law_uses(' in done.stderr and 'Compound law' in done.stderr, told


def main():
    cases = [comments_are_seen_as_they_are_meant]
    if shutil.which('doxygen'):
        cases += [there_is_no_warning, what_is_exported_must_be_documented]
    failed = False
    print(f'1..{len(cases)}')
    for number, case in enumerate(cases, 1):
        with tempfile.TemporaryDirectory() as folder:
            try:
                case(folder)
                wrong = ''
            except AssertionError as error:
                wrong = f'{error}'
        failed = failed or wrong != ''
        print(f'{"not ok" if wrong else "ok"} {number} - {case.__name__}')
        print(''.join(f'# {line}\n' for line in wrong.splitlines()), end='')
    if len(cases) == 1:
        print('# doxygen is not installed: its pages were not tried')
    sys.exit(failed)


main()
