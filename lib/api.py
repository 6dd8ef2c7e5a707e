#!/usr/bin/env python3
"""Pages of the C library's headers, by doxygen.

usage: api.py DIRECTORY            the pages; exits with 1 at a warning
       api.py --as-doxygen HEADER  a header as doxygen wants to see it

Comments are plain in the sources.  Here the one at the head of a file becomes
its description, one above a declaration that of it and of those below it up to
a blank line, one behind a member that of the member.  Indented lines stay as
they are.

What the library exports must be documented.  Members of a documented struct or
enum may go without, and so may what the other headers hold.
"""
import os
import re
import subprocess
import sys

sys.dont_write_bytecode = True  # no folder of it among the sources
from public_headers import closure, where  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SETTINGS = '''
PROJECT_NAME = Slipway
PROJECT_BRIEF = "phase planes of rate-and-state friction"
OPTIMIZE_OUTPUT_FOR_C = YES
JAVADOC_AUTOBRIEF = YES
MARKDOWN_SUPPORT = NO
AUTOLINK_SUPPORT = NO
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = MUST_CHECK=
EXTRACT_STATIC = YES
GENERATE_LATEX = NO
HAVE_DOT = NO
QUIET = YES
WARN_FORMAT = "$file:$line: $text"
'''
MEMBER = r'Member \S+ \((variable|enumvalue)\) of '


# ---- a header for doxygen ----------------------------------------------------

def escaped(line):
    return re.sub(r'([\\@<>#&$%"])', r'\\\1', line)


def documented(comment, mark='', head=''):
    """A comment as doxygen reads it."""
    lines = [re.sub(r'^\s*\* ?', '', line).rstrip() if i else line.strip()
             for i, line in enumerate(comment[2:-2].rstrip().split('\n'))]
    out, as_is = [], False
    for line in lines:
        line = line.strip() if mark else line
        is_code = line.startswith('    ')
        if is_code and not as_is:
            out.append('@verbatim')
        if as_is and line and not is_code:
            out.append('@endverbatim')
        as_is = is_code or (as_is and not line)
        out.append(line if as_is else escaped(line))
    out += ['@endverbatim'] * as_is
    return f'/**{mark} {head}' + '\n'.join(out).strip() + ' */'


def paragraphs_apart(text):
    """What stands above some declarations, above each of them."""
    def split(found):
        each = re.split(r'(?<=;\n)(?=\S)', found[2])
        return found[1] + f'\n{found[1]}'.join(each)
    return re.sub(r'^(/\*\* (?!@file)(?:(?!\*/).)*\*/\n)'
                  r'((?:(?!static)\w[^{}/#]*?;\n){2,})(?=[\n#/}])', split, text,
                  flags=re.M | re.S)


def members_apart(text):
    """`double v, psi; /**< c */` as one member a line."""
    def split(found):
        kind, names, doc = found.groups()
        return '\n'.join(f'{kind} {name.strip()};{doc}'
                         for name in names.split(','))
    return re.sub(r'^[ \t]+((?:const |struct |enum )*\w+) '
                  r'([*\w\[\]]+(?:, [*\w\[\]]+)+);([ \t]*/\*\*<.*?\*/)',
                  split, text, flags=re.M | re.S)


def for_doxygen(text, name):
    def seen(found):
        line = text[:found.start()].rpartition('\n')[2]
        if found.start() == 0:
            says = re.sub(r'\A/\*[\s*]*\S+ -- ', '/* ', found[0])
            return documented(says, head=f'@file {name}\n')
        if line.strip():
            return documented(found[0], '<')
        if re.match(r'\n[^\n/]', text[found.end():]):
            return documented(found[0])
        return found[0]
    return members_apart(paragraphs_apart(
        re.sub(r'/\*.*?\*/', seen, text, flags=re.S)))


# ---- doxygen -----------------------------------------------------------------

def exported():
    """The headers of which lib/slipway.map says that they export names."""
    with open(os.path.join(ROOT, 'lib', 'slipway.map'),
              encoding='utf-8') as file:
        return set(re.findall(r'\w+\.h', file.read().split('*/')[0]))


def counts(warning):
    """Whether a warning of doxygen is one of ours."""
    if 'is not documented' not in warning:
        return True
    strict = os.path.basename(warning.split(':')[0]) in exported()
    return strict and not re.search(MEMBER + '(struct|union|enum)', warning)


def pages(directory):
    known = where(ROOT)
    headers = closure(known, ['study.h', 'scene.h'])
    settings = SETTINGS + (
        f'OUTPUT_DIRECTORY = "{os.path.abspath(directory)}"\n'
        f'STRIP_FROM_PATH = "{ROOT}"\n'
        f'INPUT_FILTER = "{sys.executable} {os.path.abspath(__file__)} '
        '--as-doxygen"\nINPUT = '
        + ' '.join(f'"{known[header]}"' for header in headers) + '\n')
    os.makedirs(directory, exist_ok=True)
    done = subprocess.run(['doxygen', '-'], input=settings, text=True,
                          cwd=ROOT, stderr=subprocess.PIPE, check=False)
    wrong = [line for line in done.stderr.splitlines()
             if line.strip() and counts(line)]
    print('\n'.join(wrong), end='\n' * bool(wrong), file=sys.stderr)
    return done.returncode or wrong != []


def main():
    if sys.argv[1] != '--as-doxygen':
        return pages(sys.argv[1])
    with open(sys.argv[2], encoding='utf-8') as file:
        print(for_doxygen(file.read(), os.path.basename(sys.argv[2])), end='')
    return 0


if __name__ == '__main__':
    sys.exit(main())
