#!/usr/bin/env python3
"""What `meson install` of this build puts where, and that it works (TAP).

usage: test_install.py PATH_TO_SLIPWAY SOURCE_ROOT BUILD_ROOT
"""
import functools
import itertools
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

from cli_room import READER, expect, refused, run_cases
from pages import blocks

BUILD = os.path.realpath(sys.argv[3])
LOG = os.path.join(BUILD, 'meson-logs', 'install-log.txt')
FOLDER = tempfile.TemporaryDirectory()
DESTINATION = os.path.join(FOLDER.name, 'here')
INSTALL, UNINSTALL = 'meson install -C build', 'ninja -C build uninstall'
COMPILE = 'cc docs/example.c $(pkg-config --cflags --libs slipway) -o example'

HEADERS = ['slipway.h', 'slipway_planar.h']


def ran(command, **how):
    done = subprocess.run(command, text=True, capture_output=True, timeout=300,
                          stdin=subprocess.DEVNULL, check=False, **how)
    expect(done.returncode == 0, command, done.stdout, done.stderr)
    return done.stdout


def in_build(room, line):
    """A line of the README, with `build` this one, into DESTINATION."""
    if not os.path.exists(room.path('build')):
        os.symlink(BUILD, room.path('build'))
    more = ' --no-rebuild' if line == INSTALL else ''
    ran(line + more, shell=True, cwd=room.folder,
        env={**os.environ, 'DESTDIR': DESTINATION})


@functools.cache
def options():
    found = json.loads(ran(['meson', 'introspect', '--buildoptions', BUILD]))
    return {option['name']: option['value'] for option in found}


def place(kind):
    """Where bin, lib, share, include and man pages are."""
    return os.path.join(DESTINATION + options()['prefix'], options()[kind])


def documents():
    return place('datadir') + '/doc/slipway'


def files(root):
    return {os.path.relpath(os.path.join(folder, name), root)
            for folder, _, names in os.walk(root) for name in names}


def present(tool):
    if shutil.which(tool):
        return True
    print(f'# {tool} is not installed: not tried')
    return False


def source_files(room, folder):
    return {f'{folder}/{name}' for name in files(f'{room.source}/{folder}')}


def commands(room):
    listed = re.search(r'^Commands:\n((?:  .*\n)+)', room.good('help'), re.M)
    return re.findall(r'^  (\w+)', listed[1], re.M)


def with_library():
    """An environment in which pkg-config and programs find what is here."""
    return {**os.environ, 'LD_LIBRARY_PATH': place('libdir'),
            'PKG_CONFIG_PATH': os.path.join(place('libdir'), 'pkgconfig'),
            'PKG_CONFIG_SYSROOT_DIR': DESTINATION}


# ---- what is where -----------------------------------------------------------

def the_readme_installs(room):
    with open(f'{room.source}/README.md', encoding='utf-8') as file:
        page = file.read()
    for line in (INSTALL, COMPILE, UNINSTALL):
        expect(f'\n    {line}\n' in page, 'README has', line)
    in_build(room, INSTALL)
    expect(os.path.isfile(place('bindir') + '/slipway'), files(DESTINATION))


def all_stays_below_the_prefix(room):
    outside = [name for name in files(DESTINATION) if not
               f'/{name}'.startswith(options()['prefix'])]
    expect(outside == [], outside)
    moved = room.path('elsewhere')
    ran(['meson', 'setup', '--prefix', moved, '-Dtests=disabled',
         room.path('b'), room.source])
    plan = json.loads(ran(['meson', 'introspect', '--installed',
                           room.path('b')]))
    outside = [path for path in plan.values() if not path.startswith(moved)]
    expect(len(plan) > 10 and outside == [], len(plan), outside)


def scenes_and_pages_are_shared(room):
    found = files(place('datadir') + '/slipway')
    expect(source_files(room, 'scenes') <= found, found)
    found = files(documents())
    expect(files(f'{room.source}/docs') <= found, found)
    for page in ('scene', 'hdf5', 'words'):
        with open(f'{documents()}/{page}.md', encoding='utf-8') as file:
            expect(file.read() == room.good('help', '--as', page), page)


def every_command_has_a_man_page(room):
    pages = files(place('mandir') + '/man1')
    wanted = {f'slipway-{name}.1' for name in commands(room)} | {'slipway.1'}
    expect(pages == wanted, pages ^ wanted)
    for page in pages:
        with open(f'{place("mandir")}/man1/{page}', encoding='utf-8') as file:
            text = file.read()
        for section in ('NAME', 'SYNOPSIS', 'DESCRIPTION', 'OPTIONS',
                        'EXIT STATUS'):
            expect(f'\n.SH {section}\n' in text, page, section)
    check = [['mandoc', '-T', 'lint', '-W', 'error'],
             ['groff', '-man', '-Tutf8', '-ww', '-z']]
    for tool in [tool for tool in check if present(tool[0])]:
        for page in pages:
            ran(tool + [f'{place("mandir")}/man1/{page}'])


def a_man_page_has_the_options_of_its_command(room):
    with open(f'{place("mandir")}/man1/slipway-push.1',
              encoding='utf-8') as file:
        text = file.read()
    for option in ('psi', 'states', 'law', 'quiet'):
        expect(f'\\-\\-{option}\\fR' in text, option)
    for option in ('rerun', 'resume', 'tap', 'scenes'):
        expect(f'\\-\\-{option}\\fR' not in text, option)


# ---- completions -------------------------------------------------------------

def completion(shell):
    return {'bash': place('datadir') + '/bash-completion/completions/slipway',
            'zsh': place('datadir') + '/zsh/site-functions/_slipway',
            'fish': place('datadir') +
                    '/fish/vendor_completions.d/slipway.fish'}[shell]


def shells_can_read_the_completions(room):
    for shell in ('bash', 'zsh', 'fish'):
        expect(os.path.isfile(completion(shell)), shell)
        if present(shell):
            ran([shell, '-n', completion(shell)])
    refused(room.run('help', '--as', 'csh'), 2, '--as', 'bash')
    refused(room.run('help', 'knees', '--as', 'bash'), 2, 'knees')


def offered(room, *words):
    """What bash offers after Tab behind these words, the last one half; the
    script asks the program it completes."""
    words = (place('bindir') + '/slipway', *words[1:])
    script = ('source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); '
              '_slipway slipway "${COMP_WORDS[-1]}" "${COMP_WORDS[-2]}" '
              '2>/dev/null; printf "%s\\n" "${COMPREPLY[@]}"')
    return ran(['bash', '-c', script, completion('bash'), *words],
               cwd=room.folder).split()


def bash_offers_what_fits(room):
    room.write('a.yaml', '')
    room.write('a.h5', '')
    room.make('d')
    for words, wanted in (
            (('slipway', 'kn'), ['knees']),
            (('slipway', 'help', 'sw'), ['sweep']),
            (('slipway', 'info', '--re'), ['--rerun']),
            (('slipway', 'check', '--re'), ['--record']),
            (('slipway', 'knees', '--law', 'ru'), ['ruina']),
            (('slipway', 'knees', '--law', '=', 'ru'), ['ruina']),
            (('slipway', 'knees', '--friction', ''), ['asinh', 'log']),
            (('slipway', 'knees', '--set', 'slope.alpha_'),
             ['slope.alpha_deg=']),
            (('slipway', 'knees', 'a'), ['a.yaml']),
            (('slipway', 'info', 'a'), ['a.h5']),
            (('slipway', 'gallery', '-o', 'd'), ['d']),
            (('slipway', 'knees', '--figure', 'a.'), ['a.h5', 'a.yaml']),
            (('slipway', 'knees', '--nonsense', '--'), sorted(offered(
                room, 'slipway', 'knees', '--'))),
            (('slipway', 'nonsense', ''), []),
            (('slipway', 'knees', '--alpha', ''), [])):
        found = sorted(offered(room, *words))
        expect(found == wanted, words, found)
    expect(set(commands(room)) < set(offered(room, 'slipway', '')), 'commands')


def fish_offers_what_fits(room):
    if not present('fish'):
        return
    for line, wanted in (('slipway kn', ['knees']),
                         ('slipway info --re', ['--rerun']),
                         ('slipway knees --re', []),
                         ('slipway knees --law=ru', ['--law=ruina']),
                         ('slipway knees --law ru', ['ruina'])):
        path = place('bindir') + ':' + os.environ['PATH']
        said = ran(['fish', '-c', f'source {completion("fish")}; '
                                  f'complete -C"{line}"'], cwd=room.folder,
                   env={**os.environ, 'PATH': path})
        found = [entry.split('\t')[0] for entry in said.splitlines()]
        expect(found == wanted, line, said)


# ---- the program and the library ---------------------------------------------

# What makes a scene a matter of a second.
SMALL = {r'^basins:': ['basins.cells=[8, 8]', 'basins.audit=4'],
         r'^trajectories:': ['trajectories.spread=0'],
         r'^sweep:[^\[]*points:': ['sweep.points=3']}
STATE = {'system:': ['--state', 'x=1,y=1'], 'units: si': ['--v', '1 V_star',
                                                         '--phi', '1']}


def smaller(text):
    return [
        word for key, sets in SMALL.items() if re.search(key, text, re.M)
        for one in sets for word in ('--set', one)]


def answers(room, path, text, folder):
    """Of all questions: what they say, or one line why they cannot."""
    law = ['--v', '1', '--psi', '1']
    push = next((state for key, state in STATE.items() if key in text), law)
    asked = [['plan'], ['knees'], ['push', *push], ['export', '--as', 'xppaut',
                                                    '-o', '-'],
             ['check', '--record'],
             ['simulate', *law, '--set', 'trajectories.until.time=1e-3']]
    for command, *more in asked:
        done = room.run(command, path, *more, cwd=folder)
        if done.returncode == 0:
            yield command
        else:
            refused(done, done.returncode, 'slipway: ')
            expect(command != 'plan' and done.returncode in (2, 3), done)


def every_scene_runs_from_an_empty_folder(room):
    """Installed, where nothing can be written: whole, without its outputs, and
    asked all questions, which write nothing."""
    scenes = place('datadir') + '/slipway/scenes'
    room.slipway = place('bindir') + '/slipway'
    installed, drawn, said = files(scenes), 0, []
    os.chmod(scenes, 0o555)
    for name in sorted(name for name in installed if name.endswith('.yaml')):
        path, folder = f'{scenes}/{name}', 'in_' + name[:-5]
        with open(path, encoding='utf-8') as file:
            text = file.read()
        room.make(folder)
        told = room.good('study', path, *smaller(text), '--set', 'output={}',
                         cwd=folder)
        said += answers(room, path, text, folder)
        expect(room.names(folder) == [] and 'wrote' not in told, name,
               room.names(folder))
        told = room.good('study', path, *smaller(text), cwd=folder)
        wanted = re.findall(r'(outputs/\w+)\.\w+', text)
        for stem in wanted:
            made = room.names(f'{folder}/outputs')
            expect(any(f'outputs/{one}'.startswith(stem) for one in made),
                   name, stem, told)
        for made in room.names(f'{folder}/outputs') if wanted else []:
            if made.endswith('.h5'):
                before = room.names(f'{folder}/outputs')
                room.good('info', f'outputs/{made}', cwd=folder)
                expect(room.names(f'{folder}/outputs') == before, made)
        drawn += bool(wanted)
    os.chmod(scenes, 0o755)
    expect(drawn > 35 and files(scenes) == installed, drawn)
    expect(len(set(said)) == 6 and said.count('plan') == drawn and
           said.count('push') > 20, said)


def the_installed_program_finds_its_scenes(room):
    program = place('bindir') + '/slipway'
    expect(ran([program, '--version']) == room.good('--version'), program)
    done = subprocess.run(
        [program, 'gallery', '-o', 'g', '--set', 'nonsense=1'],
        cwd=room.folder, text=True, capture_output=True, check=False)
    named = set(re.findall(r'(\w+)\.(?:svg|h5|yaml)', done.stdout))
    expect('nonsense' in done.stderr and 'no such folder' not in done.stderr,
           done, named)
    ran([program, 'study', place('datadir') + '/slipway/scenes/taylor.yaml',
         '--set', 'output={hdf5: a.h5}'], cwd=room.folder)
    expect('a.h5' in room.names(), room.names())


def the_example_prints_v_plus(room):
    os.symlink(documents(), room.path('docs'))
    ran(COMPILE, shell=True, cwd=room.folder, env=with_library())
    program = room.path('example')
    said = ran([program, 'dieterich_gen', '0.34'], env=with_library())
    told = room.json('knees', '--law', 'dieterich_gen', '--alpha',
                     '0.34')['v_plus']
    found = re.fullmatch(r'v_plus = (\S+), to (\S+)\n', said)
    expect(found and float(found[1]) == float(f'{told["value"]:.15g}')
           and float(found[2]) == float(f'{told["error"]:.1e}'), said, told)
    said = ran([program, 'ruina', '0.3'], env=with_library())
    expect(said.startswith('v_plus does not exist: '), said)


def the_page_about_c_is_true(room):
    path = documents() + '/c.md'
    block = [block for block in blocks(path) if block.name][0]
    room.write(block.name, block.text)
    with open(path, encoding='utf-8') as file:
        line = re.search(r'^    (cc .*)$', file.read(), re.M)[1]
    ran(line.replace('cc ', 'cc -Wall -Wextra -Werror ', 1), shell=True,
        cwd=room.folder, env=with_library())
    expect(ran([room.path('v_plus')], env=with_library()).startswith(
        'v_plus = 2832.223358'), line)


def the_recipe_of_check_works_in_another_repository(room):
    """An empty one, cloned as a runner does, with the installed program and
    page alone; a digit that moved fails the build."""
    if not present('git'):
        return
    with open(documents() + '/check.md', encoding='utf-8') as file:
        page = file.read()
    record, *_ = re.findall(r'^slipway check --record .*-o .*$', page, re.M)
    steps = [step for step in re.findall(r'- run: (.*)', page)
             if step.startswith('slipway ')]
    env = {**os.environ, 'PATH': place('bindir') + ':' + os.environ['PATH'],
           'HOME': room.folder}
    git = 'git -c user.name=a -c user.email=a@example.org'
    room.make('theirs')

    def shell(line, cwd):
        return subprocess.run(line, shell=True, cwd=room.path(cwd), text=True,
                              env=env, capture_output=True, check=False)

    for line, cwd in ((f'git init -q && {record} && git add . && {git} commit '
                       '-qm numbers', 'theirs'),
                      ('git clone -q theirs checkout', '.')):
        done = shell(line, cwd)
        expect((done.returncode, done.stderr) == (0, ''), line, done)
    for step in steps:
        done = shell(step, 'checkout')
        expect((done.returncode, done.stderr) == (0, ''), step, done)
    done = shell('git status --porcelain', 'checkout')
    expect(len(steps) == 2 and done.stdout == '?? moved.json\n', steps, done)
    table = room.read('checkout/slopes.csv')
    number = re.search(r'\b2[0-9]{3}\.[0-9]+', table)[0]
    room.write('checkout/slopes.csv', table.replace(number, number[:3] + '0' +
                                                    number[4:]))
    expect([shell(step, 'checkout').returncode for step in steps] == [1, 1],
           table)


def the_static_library_holds_the_same(room):
    said = ran(['pkg-config', '--static', '--libs', 'slipway'],
               env=with_library())
    flags = [flag for flag in said.split()
             if flag.startswith(('-l', '-f')) and flag != '-lslipway']
    example = documents() + '/example.c'
    ran(['cc', example, f'-I{place("includedir")}',
         place('libdir') + '/libslipway.a', *flags, '-o',
         room.path('example')])
    expect(ran([room.path('example')]).startswith('v_plus = '), 'static')


def headers_stand_on_their_own(room):
    folder = place('includedir')
    expect(sorted(os.listdir(folder + '/slipway')) == HEADERS, folder)
    for name, program, language in itertools.product(
            HEADERS, ('cc', 'c++'), ('c', 'c++')):
        if (program == 'c++') == (language == 'c++'):
            room.write('a.c', f'#include <slipway/{name}>\n')
            ran([program, '-x', language, '-Wall', '-Wextra', '-Wpedantic',
                 '-Werror', '-fsyntax-only', f'-I{folder}', room.path('a.c')])


def friction_and_a_pendulum_from_c_and_cpp(room):
    source = f'{room.source}/tests/outside/two_planes.c'
    for compiler in ('cc', 'c++ -x c++'):
        ran(f'{compiler} -Wall -Wextra -Werror "{source}" -x none '
            '$(pkg-config --cflags --libs slipway) -lm -o two', shell=True,
            cwd=room.folder, env=with_library())
        said = ran([room.path('two')], env=with_library())
        expect('\nok 1 ' in said and 'not ok' not in said, compiler, said)


def declared():
    """Functions of the public headers that are not inline."""
    found = set()
    for name in HEADERS:
        with open(f'{place("includedir")}/slipway/{name}',
                  encoding='utf-8') as file:
            text = re.sub(r'/\*.*?\*/|^#.*?(?<!\\)$', '', file.read(),
                          flags=re.S | re.M)
        found |= set(re.findall(
            r'^(?!static|typedef)(?:\w+[ \n*]+)+(slipway_\w+)\([^{};]*;', text,
            re.M))
    return found


def only_public_names_leave_the_library(room):
    listed = ran(['nm', '-D', '--defined-only',
                  place('libdir') + '/libslipway.so'])
    names = {line.split()[2].split('@')[0] for line in listed.splitlines()
             if line.split()[1] != 'A'}
    expect(names == declared(), 'exported but not declared:',
           sorted(names - declared()), 'declared but not exported:',
           sorted(declared() - names))
    expect(20 <= len(names) <= 40, len(names))


def the_library_has_a_version(room):
    library = os.path.realpath(place('libdir') + '/libslipway.so')
    version = room.good('--version').split()[1]
    expect(library.endswith('libslipway.so.' + version), library)
    expect('libslipway.so.0]' in ran(['readelf', '-d', library]), library)


def python_finds_the_module(room):
    """With the library that was installed beside it, wherever that is."""
    path = [name for name in files(DESTINATION)
            if name.endswith('slipway/__init__.py')]
    expect(len(path) == 1, path)
    site = os.path.dirname(os.path.dirname(os.path.join(DESTINATION, path[0])))
    asked = 'import sys; print(*sys.path, sep=chr(10))'
    if options()['prefix'] == '/usr/local':  # as Debian's python has it
        expect(site.removeprefix(DESTINATION) in ran([READER, '-c', asked]),
               site)
    code = ('import slipway; print(slipway._c.find(), slipway.__version__, '
            'slipway.Study("dieterich_gen", 0.34).v_plus)')
    said = ran([READER, '-c', code], env=bare(PYTHONPATH=site))
    expect(said.startswith(f'{place("libdir")}/libslipway.so.0 '
                           + room.good('--version').split()[1]
                           + ' 2832.223358'), said)


def bare(**changes):
    """An environment in which python finds nothing by name, and leaves
    nothing."""
    return {**{name: value for name, value in os.environ.items()
               if name not in ('SLIPWAY_LIBRARY', 'PYTHONPATH')},
            'PYTHONDONTWRITEBYTECODE': '1', **changes}


def a_place_for_the_module_is_found_below_any_prefix(room):
    told = {prefix: ran([READER, f'{room.source}/lib/python/site_below.py',
                         prefix], env=bare(HOME='/home/me')).strip()
            for prefix in ('/usr', '/usr/local', '/home/me/.local', '/opt/me')}
    version = ran([READER, '-c', 'import sys; print("%d.%d" % '
                   'sys.version_info[:2])']).strip()
    expect(told == {
        '/usr': '/usr/lib/python3/dist-packages',
        '/usr/local': f'/usr/local/lib/python{version}/dist-packages',
        '/home/me/.local':
            f'/home/me/.local/lib/python{version}/site-packages',
        '/opt/me': ''}, told)


def pip_installs_it_without_a_network(room):
    with open(f'{room.source}/README.md', encoding='utf-8') as file:
        expect('    pip install ./lib/python\n' in file.read(), 'README')
    ran([READER, '-m', 'venv', '--system-site-packages', '--without-pip',
         room.path('v')])
    pip = [READER, '-m', 'pip', '--python', room.path('v/bin/python')]
    library = os.path.join(BUILD, 'lib', 'libslipway.so.0')
    ran([*pip, 'install', '--no-index', '--quiet',
         f'{room.source}/lib/python'], env=bare(SLIPWAY_LIBRARY=library))
    code = ('import slipway; print(slipway._c.find()); '
            'print(slipway.Study("dieterich_gen", 0.34).v_plus)')
    said = ran([room.path('v/bin/python'), '-c', code], env=bare())
    expect(said.startswith(room.path('v/lib')) and '\n2832.223358' in said, said)
    listed = ran([*pip, 'list'], env=bare())
    expect(re.search(r'^slipway +' + room.good('--version').split()[1], listed,
                     re.M), listed)
    done = subprocess.run(
        [*pip, 'wheel', '--no-index', '-w', room.folder,
         f'{room.source}/lib/python'], text=True, capture_output=True,
        env=bare(SLIPWAY_LIBRARY='/nowhere.so'), check=False)
    expect(done.returncode != 0 and
           'slipway: no /nowhere.so, expected the library' in done.stderr, done)


def nothing_stays_behind(room):
    in_build(room, UNINSTALL)
    expect(files(DESTINATION) == set(), files(DESTINATION))


def main():
    """Whoever installed this build for good can still uninstall it."""
    kept = None
    if os.path.exists(LOG):
        with open(LOG, 'rb') as file:
            kept = file.read()
    try:
        run_cases([
            the_readme_installs,
            all_stays_below_the_prefix,
            scenes_and_pages_are_shared,
            every_command_has_a_man_page,
            a_man_page_has_the_options_of_its_command,
            shells_can_read_the_completions,
            bash_offers_what_fits,
            fish_offers_what_fits,
            every_scene_runs_from_an_empty_folder,
            the_installed_program_finds_its_scenes,
            the_example_prints_v_plus,
            the_page_about_c_is_true,
            the_recipe_of_check_works_in_another_repository,
            the_static_library_holds_the_same,
            headers_stand_on_their_own,
            friction_and_a_pendulum_from_c_and_cpp,
            only_public_names_leave_the_library,
            the_library_has_a_version,
            python_finds_the_module,
            a_place_for_the_module_is_found_below_any_prefix,
            pip_installs_it_without_a_network,
            nothing_stays_behind,
        ])
    finally:
        if kept is not None:
            with open(LOG, 'wb') as file:
                file.write(kept)


main()
