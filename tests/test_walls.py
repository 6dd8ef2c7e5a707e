#!/usr/bin/env python3
"""Holds the walls between the folders, and itself to holding them (TAP).

usage: test_walls.py SOURCE_ROOT BUILD_ROOT

The compiler refuses most wrong arrows, since each folder is a library that
sees only the include directories of what it depends on.  RULES are searched
for what the compiler lets through.  Then every rule is broken on purpose in a
tree of its own, and the compiler is asked for every header that the map of
the house keeps from it.
"""
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile

ROOMS = ['lib', 'manifold', 'portrait', 'apps', 'tests']
PURE = ['lib/core', 'manifold', 'portrait']


def everywhere_but(*allowed):
    return lambda path: not inside(path, allowed)


def only_in(*folders):
    return lambda path: inside(path, folders)


def inside(path, folders):
    return any(path.startswith(folder + '/') for folder in folders)


# What no one may write, as a pattern of code without its comments (COMMENTS:
# with them), in the files for which `where` holds; and a line and a file that
# break the rule.
CODE, COMMENTS = False, True
INCLUDE = r'#\s*include\s*'
RULES = [
    ('an include is flat, without folders',
     CODE, INCLUDE + r'("[^"]*/|<\.)', everywhere_but(),
     'portrait/planted.c', '#include "../manifold/branch.h"'),
    ('<stdio.h> stays out of the pure folders, but where faults are worded',
     CODE, INCLUDE + r'<stdio\.h>',
     lambda path: inside(path, PURE) and path != 'lib/core/status.c',
     'manifold/planted.c', '#include <stdio.h>'),
    ('lib/friction writes into strings only',
     CODE, r'\b(v?[df]?printf|f?puts|f?putc|putchar|perror|fopen|FILE)\b',
     only_in('lib/friction'),
     'lib/friction/planted.c', 'void p(FILE *f) { fputs("", f); }'),
    ('HDF5 stays in lib/store',
     CODE, INCLUDE + r'<(hdf5|H5)\w*\.h>', everywhere_but('lib/store', 'tests'),
     'apps/planted.c', '#include <hdf5.h>'),
    ('YAML stays in lib/scene',
     CODE, INCLUDE + r'<(cyaml/.*|yaml)\.h>',
     everywhere_but('lib/scene', 'tests'),
     'lib/study/planted.c', '#include <cyaml/cyaml.h>'),
    ('JSON stays out of physics and geometry',
     CODE, INCLUDE + r'<jansson\.h>', only_in('lib/friction', *PURE),
     'lib/friction/planted.c', '#include <jansson.h>'),
    ('gnuplot is named in lib/plot only',
     CODE, r'"gnuplot"', everywhere_but('lib/plot', 'tests'),
     'apps/planted.c', 'const char *p = "gnuplot";'),
    ('programs are started in lib/plot only',
     CODE, r'\b(popen|posix_spawnp?|exec[lv]p?e?|system)\s*\(',
     everywhere_but('lib/plot', 'tests'),
     'lib/study/planted.c', 'int p(void) { return system("true"); }'),
    ('foreign files are read apart in lib/store only',
     CODE, r'\b(v?fork|_Fork|clone)\s*\(', everywhere_but('lib/store', 'tests'),
     'apps/planted.c', 'int p(void) { return fork(); }'),
    ('only apps talk to the user',
     CODE, r'\b(v?printf|puts|putchar|perror|v?dprintf)\s*\('
           r'|\b(stdin|stdout|stderr)\b', everywhere_but('apps', 'tests'),
     'lib/plot/planted.c', 'void p(void) { fputs("done", stderr); }'),
    ('only those who run a study know all of it',
     CODE, r'\bstruct\s+study',
     everywhere_but('lib/study', 'lib/sweep', 'lib/check', 'lib/race', 'apps',
                    'tests'),
     'lib/api/planted.c', 'void p(const struct study *s);'),
    ('main() is in apps',
     CODE, r'\bint\s+main\s*\(', everywhere_but('apps', 'tests'),
     'lib/core/planted.c', 'int main(void) { return 0; }'),
    ('geometry has never heard of friction',
     COMMENTS, r'(?i)friction|\blaw\.h|\bblock\.h',
     only_in('manifold', 'portrait'),
     'portrait/planted.h', '/* The friction law decides. */'),
]

# The map of the house: what each folder may include besides itself.
LOW = ['lib/core', 'lib/results', 'lib/formula', 'lib/friction', 'lib/scene', 'lib/fit',
       'manifold', 'portrait']
ORBITS = ['lib/numbers', 'lib/proof', 'lib/motion', 'lib/slow', 'lib/basin']
MAY_SEE = {
    'lib/core': [],
    'lib/results': ['lib/core'],
    'lib/formula': ['lib/core'],
    'lib/friction': ['lib/core', 'lib/formula'],
    'lib/scene': ['lib/core', 'lib/formula', 'lib/friction', 'lib/interchange'],
    'lib/fit': ['lib/core', 'lib/formula', 'lib/friction'],
    'lib/store': ['lib/core', 'lib/results'],
    'lib/plot': ['lib/core'],
    'lib/interchange': ['lib/core', 'lib/formula', 'lib/friction'],
    'manifold': ['lib/core'],
    'portrait': ['lib/core', 'manifold'],
    'lib/numbers': LOW,
    'lib/proof': LOW + ['lib/numbers'],
    'lib/motion': LOW + ['lib/numbers'],
    'lib/slow': LOW + ['lib/numbers', 'lib/motion'],
    'lib/basin': LOW + ['lib/numbers', 'lib/motion', 'lib/slow'],
    'lib/plane': LOW + ['lib/numbers', 'lib/proof'],
    'lib/study': LOW + ORBITS,
    'lib/sweep': LOW + ORBITS + ['lib/plane', 'lib/study'],
    'lib/ensemble': LOW + ORBITS + ['lib/plane', 'lib/study', 'lib/sweep'],
    'lib/check': LOW + ORBITS + ['lib/plane', 'lib/study'],
    'lib/api': LOW + ORBITS + ['lib/plane', 'lib/study', 'lib/sweep', 'lib/ensemble'],
    'lib/race': LOW + ORBITS + ['lib/plane', 'lib/study'],
}


def without_comments(text):
    """Each comment becomes as many line ends as it had; strings stay."""
    token = r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\''

    def keep(match):
        found = match.group()
        return '\n' * found.count('\n') if found[0] == '/' else found

    return re.sub(token, keep, text, flags=re.S)


def sources(root):
    for room in ROOMS:
        for folder, _, names in os.walk(os.path.join(root, room)):
            for name in names:
                if name.endswith(('.c', '.h')):
                    yield os.path.relpath(os.path.join(folder, name), root)


def texts(root):
    """path -> text, text without comments."""
    found = {}
    for path in sorted(sources(root)):
        with open(os.path.join(root, path), encoding='utf-8') as file:
            text = file.read()
        found[path] = {COMMENTS: text, CODE: without_comments(text)}
    return found


def violations(tree, rule):
    _, comments, pattern, where, _, _ = rule
    pattern, found = re.compile(pattern), []
    for path, text in tree.items():
        if not where(path) or not pattern.search(text[comments]):
            continue
        for number, line in enumerate(text[comments].split('\n'), 1):
            if pattern.search(line):
                found.append(f'{path}:{number}: {line.strip()}')
    return found


def planted(rule):
    """What the search, which takes each file for itself, finds in a tree where
    the rule is broken."""
    path, line = rule[4], rule[5]
    with tempfile.TemporaryDirectory() as root:
        os.makedirs(os.path.join(root, os.path.dirname(path)))
        with open(os.path.join(root, path), 'w', encoding='utf-8') as file:
            file.write('/* One line that\n * must be found: */\n' + line + '\n')
        return [text for text in violations(texts(root), rule)
                if text.startswith(path + ':3:' if rule[1] == CODE else path)]


def compilers(root, build):
    """Folder -> (working directory, command without its source file)."""
    with open(os.path.join(build, 'compile_commands.json')) as file:
        entries = json.load(file)
    commands = {}
    for entry in entries:
        source = os.path.join(entry['directory'], entry['file'])
        if os.path.realpath(source).startswith(os.path.realpath(build)):
            continue  # made by the build
        folder = os.path.relpath(os.path.dirname(os.path.realpath(source)),
                                 os.path.realpath(root))
        words = shlex.split(entry['command'])
        for option in ['-o', '-MF', '-MQ']:
            if option in words:
                at = words.index(option)
                del words[at:at + 2]
        words = [word for word in words
                 if word not in ('-c', '-MD', '-MMD', entry['file'])]
        commands.setdefault(folder, (entry['directory'], words))
    return commands


def found_by(command, names):
    """Those of the headers that the folder's compiler would find."""
    directory, words = command
    text = ''.join(f'#if __has_include("{name}")\nSEEN {number}\n#endif\n'
                   for number, name in enumerate(names))
    run = subprocess.run(words + ['-E', '-P', '-x', 'c', '-'], cwd=directory,
                         input=text, capture_output=True, text=True, check=True)
    return [names[int(number)]
            for number in re.findall(r'^SEEN (\d+)$', run.stdout, re.M)]


def headers(root, folder):
    path = os.path.join(root, folder)
    return sorted(name for name in os.listdir(path) if name.endswith('.h'))


def seen_through_walls(root, folder, command):
    """Complaints; also if it misses its own headers, as a check of this one."""
    others = {header: other for other in MAY_SEE
              if other != folder and other not in MAY_SEE[folder]
              for header in headers(root, other)}
    own = headers(root, folder)
    found = found_by(command, own + list(others))
    for header in found:
        if header in others:
            yield f'{folder} sees {header} of {others[header]}'
    if [header for header in found if header in own] != own:
        yield f'{folder} does not see its own headers'


def foreign_libm(build):
    """Test programs that take exp and log of the C library, not ours."""
    folder = os.path.join(build, 'tests')
    programs = [os.path.join(folder, name) for name in os.listdir(folder)
                if re.fullmatch(r'test_\w+', name)]
    listed = subprocess.run(['nm', '-A', *programs], capture_output=True,
                            text=True, check=True).stdout
    own = set(re.findall(r'^(.*?):.* T log1p$', listed, re.M))
    return sorted(set(programs) - own) if programs else ['none is built']


def main(root, build):
    results, tree = [], texts(root)
    for rule in RULES:
        results.append((rule[0], violations(tree, rule)))
        results.append(('a search sees it broken: ' + rule[0],
                        [] if planted(rule) else ['not found']))
    commands = compilers(root, build)
    results.append(('every library is on the map',
                    [folder for folder in commands if folder not in MAY_SEE
                     and not inside(folder + '/', ['apps', 'tests'])]))
    for folder in MAY_SEE:
        if folder in commands:
            complaints = seen_through_walls(root, folder, commands[folder])
            results.append((f'{folder} can include only what it may',
                            list(complaints)))
    results.append(("tests compute with the program's own exp and log",
                    foreign_libm(build)))
    print(f'1..{len(results)}')
    for number, (name, complaints) in enumerate(results, 1):
        print(f'{"not ok" if complaints else "ok"} {number} - {name}')
        for complaint in complaints:
            print('# ' + complaint)
    return any(complaints for _, complaints in results)


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], sys.argv[2]))
