#!/usr/bin/env python3
"""slipway among hostile files, names, callers and surroundings (TAP).

usage: cli_hardening.py PATH_TO_SLIPWAY SOURCE_ROOT REPLAY_HDF5 DIE [STARVE]

REPLAY_HDF5 is tests/fuzz/replay_hdf5; DIE and STARVE are preload_die.c and
preload_starve.c as libraries (under a sanitizer nothing starves).
"""
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys

from cli_room import READER, SLOPE, expect, refused, run_cases

REPLAY, DIE, *STARVE = (os.path.realpath(path) for path in sys.argv[3:])
SEED = int(os.environ.get('CHECK_SEED', 20240229))
NOBODY = 65534
# Under sanitizers a preloaded library is not the first, and HDF5 loses memory.
WATCHED = {'ASAN_OPTIONS': 'detect_leaks=0:verify_asan_link_order=0'}


# ---- files of others ---------------------------------------------------------

def mutated(whole, source):
    """Bytes flipped, numbers made extreme, parts moved, ends cut."""
    data = bytearray(whole)
    for _ in range(source.randint(1, 6)):
        at = source.randrange(len(data) or 1)
        if source.random() < 0.5:  # where the structure is told
            at = source.randrange(min(2048, len(data)))
        what = source.randrange(6)
        if what == 0:
            data[at:at + 1] = bytes([source.randrange(256)])
        elif what == 1:
            data[at:at + 1] = bytes([data[at] ^ 1 << source.randrange(8)])
        elif what == 2:
            data[at:at + 8] = source.choice([b'\xff', b'\0', b'\x7f']) * 8
        elif what == 3:
            data[at:at + 4] = source.choice([1, 2**31, 2**32 - 1, 4096]
                                            ).to_bytes(4, 'little')
        elif what == 4:
            other = source.randrange(len(data))
            data[at:at + 64] = data[other:other + 64]
        elif source.random() < 0.2:
            del data[at + 1:]
    return bytes(data)


def thousands_of_damaged_files_end_in_a_line_at_worst(room):
    source = random.Random(SEED)
    print(f'# CHECK_SEED={SEED}')
    room.good('study', *SLOPE, '-q', '-o', 'a.h5', '--set',
              'products=[equilibria]')
    whole = room.bytes('a.h5')
    room.make('damaged')
    names = [f'damaged/{i}.h5' for i in range(2000)]
    for name in names:
        room.write(name, mutated(whole, source))
    done = subprocess.run([REPLAY, *names], cwd=room.folder, timeout=300,
                          env=room.environment(FUZZ_WHOLE='a.h5', FUZZ_GROUP='32',
                                           **WATCHED),
                          capture_output=True, text=True, check=False)
    expect(done.returncode == 0, done.stdout[-99:], done.stderr)
    for name in names[:50]:
        for extra in (['info', name], ['info', name, 'scene']):
            done = room.run(*extra, **WATCHED)
            expect(done.returncode in (0, 2, 4)
                   and len(done.stderr.splitlines())
                   == (done.returncode != 0), name, done)


def files_that_kill_hdf5_are_refused_in_a_line(room):
    """HDF5 1.10.8 crashes over each."""
    found = os.path.join(room.source, 'tests/fuzz/found/hdf5')
    expect(os.listdir(found), 'none')
    for name in os.listdir(found):
        shutil.copy(os.path.join(found, name), room.path('a.h5'))
        for extra in ([], ['--json'], ['--rerun']):
            refused(room.run('info', 'a.h5', *extra, **WATCHED), 4, 'a.h5')
        expect(room.names() == ['a.h5'], room.names())


def a_reader_that_dies_is_a_line_and_exit_4(room):
    room.good('study', *SLOPE, '-q', '-o', 'a.h5')
    for how, words in (('segv', 'damaged'), ('abort', 'damaged'),
                       ('exit', 'damaged'), ('eat', 'damaged'),
                       ('hang', 'too long')):
        for extra in ([], ['scene'], ['--json'], ['--rerun']):
            done = room.run('info', 'a.h5', *extra, LD_PRELOAD=DIE, DIE=how,
                            **WATCHED)
            refused(done, 4, 'a.h5', words)
    room.good('info', 'a.h5', LD_PRELOAD=DIE, DIE='', **WATCHED)
    expect(room.names() == ['a.h5'], room.names())


def what_a_file_says_does_not_reach_the_terminal_raw(room):
    room.write('a.yaml', 'law: {preset: ruina}\nslope: {alpha: 0.34}\n'
               'products: [knees]\n')
    room.good('study', 'a.yaml', '-q', '-o', 'a.h5')
    evil = 'a\x1b]0;owned\x07\x9b31m\u202e'
    subprocess.run([READER, '-c', f'''
import h5py, numpy
with h5py.File("a.h5", "r+") as f:
    f["critical"].attrs["note"] = numpy.bytes_({evil.encode()!r})
    f["critical/v_plus"].attrs["long_name"] = numpy.bytes_({evil.encode()!r})
    f["critical/v_plus"].attrs["units"] = numpy.bytes_(b"\\xff\\xfe")
    f.create_group("x{evil}")
    f["provenance"].attrs["scene"] = numpy.bytes_("title: {evil}".encode())
'''], cwd=room.folder, check=True, env=dict(os.environ, PYTHONUTF8='1'))
    said = room.good('info', 'a.h5')
    expect('owned' in said and '\\x1b' in said and '\\xff' in said
           and all(c.isprintable() or c == '\n' for c in said), 'raw')
    said = room.good('info', 'a.h5', '--json')
    expect('\\u001B]0;owned' in said and '\x1b' not in said
           and json.loads(said), 'raw')
    refused(room.run('info', 'a.h5', 'scene'), 2, 'control character')


# ---- callers -----------------------------------------------------------------

def with_no_reader(room, stream, args, ignored):
    """Its stdout or stderr is a pipe that nobody reads any more."""
    reader, writer = os.pipe()
    os.close(reader)
    streams = {'stdout': subprocess.PIPE, 'stderr': subprocess.PIPE,
               stream: writer}

    def ignore():
        signal.signal(signal.SIGPIPE, signal.SIG_IGN if ignored
                      else signal.SIG_DFL)
    done = subprocess.run([room.slipway, *args], cwd=room.folder, text=True,
                          env=room.environment(TMPDIR=room.path('tmp')),
                          timeout=300, check=False, preexec_fn=ignore, **streams)
    os.close(writer)
    return done


def a_reader_that_goes_away_costs_no_storm(room):
    room.good('knees', *SLOPE, '-q', '-o', 'a.h5')
    shutil.copy(room.path('a.h5'), room.path('c.h5'))
    room.make('tmp')
    subprocess.run([READER, '-c', 'import h5py\nwith h5py.File("c.h5", "r+") '
                    'as f: del f["critical"]'], cwd=room.folder, check=True)
    for args in (['laws'], ['help'], ['help', '--as', 'man'],
                 ['knees', *SLOPE], ['knees', *SLOPE, '--json'],
                 ['info', 'a.h5'], ['info', 'a.h5', '--json'],
                 ['info', 'a.h5', 'scene'], ['info', 'a.h5', '--rerun'],
                 ['info', 'c.h5', '--rerun'], ['info', 'c.h5', '--rerun',
                                               '--json']):
        done = with_no_reader(room, 'stdout', args, False)
        expect((done.returncode, done.stderr) == (-signal.SIGPIPE, ''), done)
        done = with_no_reader(room, 'stdout', args, True)
        expect(done.returncode == 4 and len(done.stderr.splitlines()) == 1
               and 'standard output' in done.stderr, done)
    watched = ['basin', *SLOPE, '-q', '-o', 'd.h5', '--progress', 'json']
    done = with_no_reader(room, 'stderr', watched, False)
    expect((done.returncode, done.stdout) == (-signal.SIGPIPE, ''), done)
    expect(with_no_reader(room, 'stderr', ['none'], True).returncode == 2, '')
    expect((room.names(), room.names('tmp'))
           == (['a.h5', 'c.h5', 'tmp'], []), room.names())


def long_run(room, command, stage):
    """Started, and known to be in this stage; by nohup, too, it hears all."""
    job = subprocess.Popen(
        [room.slipway, *command, '--progress', 'json', '--quiet'],
        cwd=room.folder, text=True, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, env=room.environment(),
        preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL))
    while json.loads(job.stderr.readline())['stage'] != stage:
        pass
    return job


LONG = [
    ('points', [], ['sweep', *SLOPE, '--set', 'sweep={key: slope.alpha, '
                    'from: 0.2, to: 0.5, points: 100000}']),
    ('audit', [], ['basin', *SLOPE, '--set',
                   'basins={cells: [64, 64], audit: 1000000}']),
    ('trajectories', [], ['portrait', *SLOPE, '--set',
                          'trajectories.spread=10000']),
]


def every_signal_stops_a_long_run_and_leaves_nothing(room):
    for number in (signal.SIGHUP, signal.SIGTERM, signal.SIGINT):
        for stage, _, command in LONG:
            job = long_run(room, [*command, '-o', 'a.h5', '--figure', 'a.svg'],
                           stage)
            job.send_signal(number)
            said, complaints = job.communicate(timeout=300)
            told = [line for line in complaints.splitlines()
                    if line[0] != '{']
            expect((job.returncode, said, len(told)) == (130, '', 1), stage,
                   number, job.returncode, said, told)
            left = ['a.h5.part'] if stage == 'points' else []
            expect(room.names() == left, stage, number, room.names())
            for name in left:  # not a torn one, either
                os.remove(room.path(name))


def nohup_is_obeyed(room):
    job = subprocess.Popen(
        ['nohup', room.slipway, 'basin', *SLOPE, '-o', 'a.h5', '--progress',
         'json', '--quiet', '--set', 'basins={cells: [64, 64], audit: 20000}'],
        cwd=room.folder, text=True, stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    while '"audit"' not in job.stderr.readline():
        pass
    job.send_signal(signal.SIGHUP)
    job.communicate(timeout=300)
    expect(job.returncode == 0 and room.names() == ['a.h5'], job.returncode,
           room.names())


# ---- places that refuse ------------------------------------------------------

def as_nobody(room, *args):
    """Root may write everywhere; nobody may not."""
    who = {'user': NOBODY, 'group': NOBODY, 'extra_groups': []}
    return subprocess.run(
        [room.path('slipway'), *args], cwd=room.folder, text=True, timeout=300,
        env=room.environment(), capture_output=True, check=False,
        stdin=subprocess.DEVNULL, **(who if os.geteuid() == 0 else {}))


def a_folder_that_cannot_be_written_is_refused_before_work(room):
    shutil.copy(room.slipway, room.path('slipway'))
    room.make('free')
    room.make('closed')
    room.write('closed/old.h5', 'old')
    os.chmod(room.folder, 0o755)
    os.chmod(room.path('slipway'), 0o755)
    os.chmod(room.path('free'), 0o777)
    os.chmod(room.path('closed'), 0o555)
    sweep = ['--set', 'sweep={key: slope.alpha, values: [0.3, 0.34]}']
    for command, more in (('portrait', []), ('knees', []), ('basin', []),
                          ('sweep', sweep), ('simulate', ['--v', '1e3',
                                                          '--psi', '1'])):
        for args in (['-o', 'closed/a.h5'], ['-o', 'closed/old.h5'],
                     ['-o', 'free/a.h5', '--figure', 'closed/a.svg']):
            done = as_nobody(room, command, *SLOPE, *more, *args)
            refused(done, 4, args[-1], 'Permission denied')
            expect((room.names('free'), room.names('closed'),
                    room.read('closed/old.h5')) == ([], ['old.h5'], 'old'),
                   command, args, room.names('free'), room.names('closed'))
    done = as_nobody(room, 'portrait', *SLOPE, '-o', 'free/a.h5', '--figure',
                     'free/a.svg')
    expect(done.returncode == 0 and room.names('free') == ['a.h5', 'a.svg'],
           done)


def a_disk_that_fills_leaves_what_was(room):
    """Files of at most so many bytes, as if no block was left."""
    for command, name, sizes in (
            (['study', *SLOPE, '-q', '-o', 'a.h5'], 'a.h5',
             (0, 1, 4096, 20000)),
            (['portrait', *SLOPE, '-q', '--figure', 'a.svg'], 'a.svg',
             (0, 1, 100, 3000, 9000, 20000)),
            (['check', '--record', '-q', '-o', 'a.csv', 'a.yaml'], 'a.csv',
             (0, 1, 1000))):
        room.write('a.yaml', 'law: {preset: ruina}\nslope: {alpha: 0.34}\n')
        room.write(name, 'old')
        for size in sizes:
            done = subprocess.run(
                [room.slipway, *command], cwd=room.folder, text=True,
                timeout=300, env=room.environment(), capture_output=True,
                check=False, preexec_fn=lambda size=size: resource.setrlimit(
                    resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY)))
            refused(done, 4)
            expect(room.read(name) == 'old' and room.names()
                   == sorted([name, 'a.yaml']), name, size, room.names())
        os.remove(room.path(name))


# ---- surroundings ------------------------------------------------------------

LOCALE = 'de_DE'


def without_times(text):
    return ''.join(line for line in text.splitlines(keepends=True)
                   if 'seconds' not in line and ' s\n' not in line)


def a_decimal_comma_changes_no_byte(room):
    made = subprocess.run(['localedef', '-i', LOCALE, '-f', 'UTF-8',
                           room.path(LOCALE + '.UTF-8')], capture_output=True,
                          check=False)
    if not os.path.exists(room.path(LOCALE + '.UTF-8/LC_NUMERIC')):
        print('# no localedef here:', made.stderr.decode()[:60])
        return
    room.write('states.csv', 'v,psi\n1.5,0.25\n')
    room.write('a.yaml', 'law: {preset: ruina}\nslope: {alpha: 0.34}\n'
               'estimates: {xi: [0.85, 0.9]}\n')
    german = {'LOCPATH': room.folder, 'LC_ALL': LOCALE + '.UTF-8',
              'LANG': LOCALE + '.UTF-8'}
    check = subprocess.run([READER, '-c', 'import locale; locale.setlocale('
                            'locale.LC_ALL, ""); print(f"{0.5:n}")'],
                           env=dict(os.environ, **german), text=True,
                           capture_output=True, check=False)
    expect(check.stdout == '0,5\n', check)
    for args in (['portrait', 'a.yaml', '-o', 'a.h5', '--figure', 'a.svg'],
                 ['knees', 'a.yaml'], ['knees', 'a.yaml', '--json'],
                 ['push', 'a.yaml', '--states', 'states.csv'],
                 ['check', '--record', '-o', 'a.csv', 'a.yaml'],
                 ['simulate', 'a.yaml', '--v', '1.5', '--psi', '0.25'],
                 ['info', 'a.h5']):
        said = [[without_times(room.good(*args, **where))]
                + [room.bytes(name) for name in ('a.h5', 'a.svg', 'a.csv')
                   if name in args] for where in ({'LC_ALL': 'C'}, german)]
        expect(said[0] == said[1], args)


def hostile_settings_of_gnuplot_are_not_read(room):
    """Its start-up files and environment could run commands."""
    room.make('home/.config/gnuplot')
    canary = f'system "touch {room.path("canary")}"\n'
    for name in ('.gnuplot', 'home/.gnuplot', 'home/.config/gnuplot/gnuplotrc',
                 'home/gnuplot.gp', 'gnuplotrc'):
        room.write(name, canary)
    surroundings = {
        'HOME': room.path('home'), 'XDG_CONFIG_HOME': room.path('home/.config'),
        'GNUPLOT_LIB': room.folder, 'GNUTERM': f'|touch {room.path("canary")}',
        'GNUHELP': room.path('.gnuplot'), 'GPVAL': canary,
        'GNUPLOT_SHARE_DIR': room.folder, 'PAGER': 'touch canary'}
    plain = room.shell('slipway portrait --law ruina --alpha 0.34 -q '
                       '--figure a.svg')
    expect(plain.returncode == 0, plain)
    before = room.bytes('a.svg')
    room.good('portrait', '--law', 'ruina', '--alpha', '0.34', '-q',
              '--figure', 'a.svg', **surroundings)
    expect('canary' not in room.names(), room.names())
    expect(room.bytes('a.svg') == before, 'another figure')


def gnuplot_gets_its_words_without_a_shell(room):
    """Of a name that any shell would change, from slipway itself."""
    room.fake('gnuplot', 'for word; do printf "%s\\n" "$word"; done >said; '
              'readlink /proc/$PPID/exe >parent; mv said parent "$OLD/"')
    name = '$(touch canary) `touch canary` ~ * ?; touch canary.svg'
    done = room.run('portrait', *SLOPE, '--figure', name, OLD=room.folder)
    expect(done.returncode == 4, done)  # it drew nothing
    expect(room.read('said').splitlines() == ['-d', f'./{name[:-4]}.gp'],
           room.read('said'))
    expect(room.read('parent').strip() == os.path.realpath(room.slipway),
           room.read('parent'))
    expect(room.names() == ['parent', 'said'], room.names())


def memory_that_runs_out_is_told_and_nothing_left_out(room):
    """In anyone's code: none of the answers is a part of one.  (libhdf5 may
    end the program; it writes no file then, but says nothing either.)"""
    source = random.Random(SEED)
    for args in (['knees', *SLOPE, '--json'], ['laws', '--json'],
                 ['push', *SLOPE, '--v', '9', '--psi', '1', '--json'],
                 ['portrait', *SLOPE, '-q', '--figure', 'a.svg'],
                 ['plan', *SLOPE, '--json']):
        def run(args=args, **how):
            done = room.run(*args, LD_PRELOAD=STARVE[0], OMP_NUM_THREADS='1',
                            **how)
            made = {name: room.bytes(name) for name in room.names()
                    if name.startswith('a.')}
            for name in made:
                os.remove(room.path(name))
            return done, made
        whole, files = run(STARVE_COUNT=room.path('count'))
        expect(whole.returncode == 0, whole)
        for at in source.sample(range(int(room.read('count'))), 40):
            done, made = run(STARVE_AT=str(at))
            expect(without_times(done.stdout)
                   == without_times(whole.stdout) and made == files
                   if done.returncode == 0 else done.returncode in (1, 2, 3, 4)
                   and len(done.stderr.strip().splitlines()) == 1
                   and made == {}, args, at, done.returncode, done.stderr)
            expect(room.names() == ['count'], at, room.names())


# ---- names and titles --------------------------------------------------------

NAMES = ['a b', "it's", '"q"', '-rf', '--help', '%d%s%n', '$(touch canary)',
         '`touch canary`', ';touch canary', '|touch canary', '&', '*', '\\',
         'é—世界', '~', '#', "'", "a'; touch canary; '",
         'x' * 247, '{a: 1}', '\u202e', 'a,b']


def any_file_name_is_only_a_name(room):
    for stem in NAMES:
        scene, data = stem + '.yaml', stem + '.h5'
        room.write(scene, 'law: {preset: ruina}\nslope: {alpha: 0.34}\n'
                   'products: [equilibria]\n')
        there = './' if stem[0] == '-' else ''
        said = room.good('study', there + scene, '-o', data, '-q')
        expect(said == '' and room.names() == sorted([scene, data]), stem,
               room.names())
        room.good('info', there + data)
        room.good('info', there + data, 'scene')
        expect(room.good('info', there + data, '--rerun') == 'same bytes\n',
               stem)
        for name in (scene, data):
            os.remove(room.path(name))
        for command in ('study', 'info', 'knees'):
            refused(room.run(command, there + scene), 4)
    expect(room.names() == [], room.names())


def a_name_that_is_no_text_is_told_as_one(room):
    for stem, shown in (('a\nb', 'a\\x0ab'), ('\x1b[31m', '\\x1b[31m'),
                        ('\udcff', '\\xff')):
        room.write(stem + '.yaml', 'law: {preset: ruina}\nslope: {alpha: x}\n')
        refused(room.run('study', stem + '.yaml'), 2, shown + '.yaml:2:')
        refused(room.run('study', 'no' + stem), 4, 'no' + shown)
        refused(room.run('info', 'no' + stem), 4, 'no' + shown)
        refused(room.run('knees', *SLOPE, '-o', stem + '.h5'), 2, shown)
        expect(room.names() == [stem + '.yaml'], room.names())
        os.remove(room.path(stem + '.yaml'))


def a_name_that_is_too_long_is_told(room):
    refused(room.run('knees', *SLOPE, '-o', 'x' * 300 + '.h5'), 4,
            'File name too long')
    refused(room.run('knees', *SLOPE, '-o', 'x/' * 3000 + 'a.h5'), 4,
            'File name too long')
    refused(room.run('portrait', *SLOPE, '--figure', 'x' * 300 + '.svg'), 4,
            'File name too long')
    refused(room.run('study', 'x' * 300), 4, 'File name too long')
    expect(room.names() == [], room.names())


TITLES = ['x' * 65535, 'y' * 65536, 'é' * 70000, '"; system("touch canary"); "',
          '`touch canary`', '%s%n', 'a\nb\n', '\\', '@macro', "'", '\u202e',
          '/a/b', '.', '..', 'NAME', 'α→β', '<&>"', ' ', '\t']


def a_title_is_stored_as_it_is(room):
    for title in TITLES:
        room.write('a.yaml', f'title: {json.dumps(title, ensure_ascii=False)}'
                   '\nlaw: {preset: ruina}\nslope: {alpha: 0.34}\n'
                   'products: [equilibria]\n')
        room.good('study', 'a.yaml', '-o', 'a.h5', '-q')
        held = room.reads(
            'import h5py, sys\n'
            'with h5py.File("a.h5") as f: t = f.attrs["title"]\n'
            'sys.stdout.buffer.write(t.encode() if isinstance(t, str) else t)')
        expect(held == title, title[:60], held[:60])
        expect(room.json('info', 'a.h5')[0]['texts']['title'] == title,
               title[:60])
        expect(len(room.good('info', 'a.h5').splitlines()[2]) < 4200, 'cut')
        expect(room.names() == ['a.h5', 'a.yaml'], title[:60], room.names())


def a_zero_byte_in_a_title_is_refused(room):
    room.write('a.yaml', 'title: "a\\0b"\nlaw: {preset: ruina}\n'
               'slope: {alpha: 0.34}\n')
    refused(room.run('study', 'a.yaml', '-o', 'a.h5'), 2, ':1:8:', 'zero byte')
    expect(room.names() == ['a.yaml'], room.names())


def a_64_kilobyte_title_is_drawn(room):
    room.write('a.yaml', f'title: "{"w " * 32768}"\nlaw: {{preset: ruina}}\n'
               'slope: {alpha: 0.34}\nproducts: [equilibria]\n')
    room.good('portrait', 'a.yaml', '-q', '--figure', 'a.svg')
    shown = room.read('a.svg').count('w w')
    expect(10 < shown < 1000, shown)


run_cases([
    thousands_of_damaged_files_end_in_a_line_at_worst,
    files_that_kill_hdf5_are_refused_in_a_line,
    a_reader_that_dies_is_a_line_and_exit_4,
    what_a_file_says_does_not_reach_the_terminal_raw,
    a_reader_that_goes_away_costs_no_storm,
    every_signal_stops_a_long_run_and_leaves_nothing,
    nohup_is_obeyed,
    a_folder_that_cannot_be_written_is_refused_before_work,
    a_disk_that_fills_leaves_what_was,
    a_decimal_comma_changes_no_byte,
    hostile_settings_of_gnuplot_are_not_read,
    gnuplot_gets_its_words_without_a_shell,
    *([memory_that_runs_out_is_told_and_nothing_left_out] if STARVE else []),
    any_file_name_is_only_a_name,
    a_name_that_is_no_text_is_told_as_one,
    a_name_that_is_too_long_is_told,
    a_title_is_stored_as_it_is,
    a_zero_byte_in_a_title_is_refused,
    a_64_kilobyte_title_is_drawn,
])
