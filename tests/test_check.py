#!/usr/bin/env python3
"""slipway check as users call it, and docs/check.md (TAP).

usage: test_check.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import csv
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile


class Room:
    """An empty folder with slipway and the scenes in it."""

    def __init__(self, folder, slipway, source):
        self.folder = folder
        self.source = source
        self.bin = os.path.join(folder, '.bin')
        os.mkdir(self.bin)
        os.symlink(slipway, os.path.join(self.bin, 'slipway'))
        shutil.copytree(os.path.join(source, 'scenes'),
                        os.path.join(folder, 'scenes'))

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), 'wb') as file:
            file.write(text if isinstance(text, bytes) else text.encode())

    def read(self, name):
        with open(self.path(name), encoding='utf-8') as file:
            return file.read()

    def environment(self):
        return dict(os.environ, PATH=self.bin + ':' + os.environ['PATH'])

    def shell(self, text):
        return subprocess.run(['sh', '-c', text], cwd=self.folder, text=True,
                              env=self.environment(), capture_output=True,
                              stdin=subprocess.DEVNULL, check=False)

    def check(self, *args):
        return subprocess.run([os.path.join(self.bin, 'slipway'), 'check',
                               *args], cwd=self.folder, text=True,
                              capture_output=True, stdin=subprocess.DEVNULL,
                              check=False)

    def reference(self, name):
        return os.path.join(self.source, 'tests', 'reference', name)

    def today(self, name):
        """A reference table in the names of today (names.csv), as rows."""
        with open(self.reference('names.csv'), encoding='utf-8') as file:
            now = {row['old']: row['now'] for row in csv.DictReader(file)
                   if row['table'] == name}
        with open(self.reference(name + '.csv'), encoding='utf-8') as file:
            rows = list(csv.DictReader(file))
        state, before, found = 0, None, []
        for row in rows:
            slope = list(row.values())[:list(row).index('type')
                                       if 'type' in row else 0]
            state = state + 1 if slope and slope == before else 0
            before = slope
            if row.get('lower_end') == 'psi_minus_inf_truncated':
                row['lower_end'] = ''
            if not row.get('v_minus', '1'):
                row['dlnlower_dalpha'] = ''
            found.append({now.get(key, key).replace('K', str(state)): cell
                          for key, cell in row.items() if now.get(key, key)})
            for which, digits in (('v_plus', 'vplus'), ('v_minus', 'lower')):
                key = f'sensitivities_{which}_alpha'
                if row.get(f'dln{digits}_dalpha'):
                    lost = float(row['digits_lost_alpha_' + digits] or 0)
                    found[-1][key + '_tol'] = abs(float(found[-1][key])) * (
                        1e-9 + 10 ** (lost - 12))
        return found

    def write_rows(self, name, rows):
        with open(self.path(name), 'w', encoding='utf-8') as file:
            out = csv.DictWriter(file, {key: 0 for row in rows for key in row})
            out.writeheader()
            out.writerows(rows)

    def names(self):
        return sorted(os.listdir(self.folder))


HEAD = 'law,alpha,v_plus\n'
GOOD = HEAD + 'dieterich_gen,0.34,2832.2\n'
MOVED = GOOD + 'dieterich_gen,0.30,4500\n'


# ---- the page ---------------------------------------------------------------

def page_commands(text):
    """The lines of shell blocks."""
    for block in re.findall(r'```sh\n(.*?)```', text, re.S):
        yield from block.splitlines()


def page_steps(text):
    """The `run:` steps of a recipe."""
    return re.findall(r'- run: (.*)', re.search(r'```yaml\n(.*?)```', text,
                                                re.S)[1])


def ten_digits(text):
    """Without the last digits of long numbers, and blanks."""
    return re.sub(r'\s+', ' ', re.sub(r'(\d+\.\d{6})\d+', r'\1', text))


def page_of(room):
    with open(os.path.join(room.source, 'docs', 'check.md'),
              encoding='utf-8') as file:
        return file.read()


def every_command_of_the_page_works(room):
    shutil.rmtree(room.path('scenes'))  # nothing of this repository is needed
    page = page_of(room)
    commands = list(page_commands(page))
    printed = ''
    for command in commands:
        done = room.shell(command)
        if done.returncode != 0 or done.stderr:
            print(f'# {command}: {done.returncode} {done.stderr}')
            return False
        printed += done.stdout
    shown = re.search(r'```text\n(.*?)```', page, re.S)[1]
    return (len(commands) >= 8 and ten_digits(shown) in ten_digits(printed)
            and room.read('slopes.tap').startswith('1..'))


# Tools of a machine on which slipway has never been: the build only pretends,
# and what it installs is the program of this one.
STRANGE = {
    'sudo': 'exec "$@"',
    'git': 'test "$*" = "clone --depth 1 $SLIPWAY $RUNNER_TEMP/slipway" && '
           'mkdir "$5" && cp "$SLIPWAY/run" "$5"',
    'dpkg-query': 'shift 3; for p; do echo "installed $p"; done',
    'meson': 'echo >"$2/build.ninja"',
    'ninja': 'mkdir -p "$2/apps" && ln -sf "$PROGRAM" "$2/apps/slipway"; '
             'case "$*" in *install) cp "$2/apps/slipway" "$BIN" ;; esac',
}


def the_recipe_works_in_a_stranger_s_repository(room):
    """A folder that holds slopes.csv and nothing else."""
    program = os.path.realpath(os.path.join(room.bin, 'slipway'))
    room.shell('slipway check --record --law dieterich_gen --alpha 0.34 '
               '-o slopes.csv')
    shutil.rmtree(room.path('scenes'))
    os.remove(os.path.join(room.bin, 'slipway'))
    for name, text in STRANGE.items():
        path = os.path.join(room.bin, name)
        with open(path, 'w', encoding='utf-8') as file:
            file.write(f'#!/bin/sh\n{text}\n')
        os.chmod(path, 0o755)
    with tempfile.TemporaryDirectory() as temporary:
        here = (f'export RUNNER_TEMP={temporary} SLIPWAY={room.source} '
                f'PROGRAM={program} BIN={room.bin}; unset -f slipway; ')
        steps = page_steps(page_of(room))
        for step in steps:
            done = room.shell(here + step)
            if done.returncode != 0 or done.stderr:
                print(f'# {step}: {done.returncode} {done.stderr}')
                return False
    return (len(steps) >= 5 and any('install' in step for step in steps)
            and room.names() == ['.bin', 'moved.json', 'slopes.csv']
            and json.loads(room.read('moved.json'))['tables'][0]['moved'] == [])


# ---- what holds and what does not -------------------------------------------

def reference_tables_hold(room):
    names = ['manifold', 'extreme', 'equilibria', 'folds']
    for name in names:
        room.write_rows(name + '.csv', room.today(name))
    done = room.check(*[name + '.csv' for name in names])
    return (done.returncode == 0 and done.stderr == ''
            and done.stdout.count('all hold\n') == len(names)
            and len(done.stdout.splitlines()) == len(names))


def a_moved_value_is_told_and_exits_1(room):
    room.write('t.csv', MOVED)
    done = room.check('t.csv')
    lines = done.stdout.splitlines()
    return (done.returncode == 1 and done.stderr == '' and len(lines) == 3
            and lines[1].split()[:3] == ['3', 'v_plus', '4500']
            and abs(float(lines[1].split()[3]) - 4527.32024371) < 1e-7
            and lines[2] == 't.csv: 2 rows, 2 values: 1 moved, 0 rows failed')


def planted_digits_are_found_in_the_reference_table(room):
    rows = room.today('manifold')
    planted = []
    for number, row in enumerate(rows, 2):
        for name in ('v_plus', 'v_minus', 'psi_at_v0', 'saddle_v'):
            if row[name] and number % 4 == len(name) % 4:
                lost = max(float(row['digits_lost_alpha_vplus'] or 0),
                           float(row['digits_lost_alpha_lower'] or 0), 0)
                by = 10 * (1e-12 + 10 ** (lost - 15))
                digits = float(row[name]) * (1 + by)
                row[name] = f'{digits:.17g}'
                planted.append((number, name))
    room.write_rows('p.csv', rows)
    done = room.check('p.csv', '--json')
    found = [(m['line'], m['quantity'])
             for m in json.loads(done.stdout)['tables'][0]['moved']]
    return (done.returncode == 1 and len(planted) > 50
            and sorted(found) == sorted(planted))


def tap_has_a_point_for_every_row_of_every_table(room):
    room.write('a#.csv', MOVED)
    room.write('b.csv', 'name,' + HEAD + '"x #1 \\",dieterich,0.3,1\n')
    done = room.check('--tap', 'a#.csv', 'b.csv')
    lines = done.stdout.splitlines()
    return (done.returncode == 1 and lines[0] == '1..3'
            and lines[1] == r'ok 1 - a\#.csv:2 dieterich_gen 0.34'
            and lines[2] == r'not ok 2 - a\#.csv:3 dieterich_gen 0.30'
            and lines[3].startswith('# v_plus (dieterich_gen): stored 4500, '
                                    'now 4527.32024371')
            and lines[3].endswith(', difference 27.3, tolerance 0.5')
            and lines[4] == r'not ok 3 - b.csv:2 x \#1 \\ dieterich 0.3'
            and 'now none (the upper branch is open' in lines[5]
            and len(lines) == 6)


def json_names_the_place(room):
    room.write('t.csv', MOVED + 'dieterich,0.3,1\n')
    done = room.check('t.csv', '--json')
    table = json.loads(done.stdout)['tables'][0]
    first, second = table['moved']
    return (done.returncode == 1 and table['file'] == 't.csv'
            and table['rows'] == 3 and table['compared'] == 3
            and table['failed'] == []
            and (first['line'], first['column']) == (3, 20)
            and first['law'] == 'dieterich_gen' and first['stored'] == '4500'
            and abs(first['now'] - 4500 - first['difference']) < 1e-9
            and second['now'] is None and 'open' in second['reason'])


def quiet_only_exits(room):
    room.write('t.csv', MOVED)
    done = room.check('t.csv', '--quiet')
    return (done.returncode, done.stdout, done.stderr) == (1, '', '')


def the_exit_code_agrees_with_what_is_told(room):
    """Of slopes so extreme that some may not be computed."""
    room.write('t.csv', 'law,alpha,a,b,c,R,g,v_plus\n'
               'dieterich_gen,0.34,0.0349,0.0489,0,inf,9.81,2833\n'
               'dieterich_gen,0.865268,0.00444585,0.00838474,0.000146038,'
               '45022.7,5.05934e-12,none\n'
               'dieterich_gen,1.42939,0.0128956,0.159562,0.011905,3155.33,'
               '3.83101e+10,none\n')
    done = room.check('t.csv', '--json')
    table = json.loads(done.stdout)['tables'][0]
    moved = [m for m in table['moved'] if m['line'] == 2]
    return (done.returncode == (3 if table['failed'] else 1)
            and len(moved) == 1 and done.stderr == '')


# ---- what is wrong ----------------------------------------------------------

HOSTILE = {
    'empty': b'',
    'header only': HEAD.encode(),
    'binary': bytes(range(256)) * 50,
    'UTF-16': GOOD.encode('utf-16'),
    'not a number': (HEAD + 'ruina,0.3,nan\n').encode(),
    'hexadecimal': (HEAD + 'ruina,0.3,0x1p3\n').encode(),
    'beyond a double': (HEAD + 'ruina,0.3,1e999\n').encode(),
    'a cell too few': (HEAD + 'ruina,0.3\n').encode(),
    'a cell too many': (HEAD + 'ruina,0.3,1,2\n').encode(),
    'an open quote': (HEAD + 'ruina,0.3,"1\n').encode(),
    'a stray quote': (HEAD + 'ruina,0.3,1"\n').encode(),
    'a long cell': HEAD.encode() + b'x' * 1000000,
    'a long name': b'x' * 1000000 + b'\n1\n',
    'a long number': (HEAD + 'ruina,0.3,' + '1' * 4000 + '\n').encode(),
    'many columns': b'a,' * 500000 + b'\n',
    'an unknown column': b'law,alpha,v_pluss\nruina,0.3,1\n',
    'a column twice': b'law,alpha,v_plus,v_plus\nruina,0.3,1,1\n',
    'line ends in a name': b'law,alpha,"v\n\x1b[31m"\nruina,0.3,1\n',
    'no law': b'alpha,v_plus\n0.3,1\n',
    'no alpha': b'law,v_plus\nruina,1\n',
    'alpha of a wall': b'law,alpha,v_plus\nruina,1.58,1\n',
    'a second table': None,
}


def bad_tables_are_refused_in_one_line(room):
    room.write('good.csv', MOVED)
    for what, text in HOSTILE.items():
        room.write('bad.csv', HEAD.encode() if text is None else text)
        tables = ['good.csv', 'bad.csv'] if text is None else ['bad.csv']
        done = room.check(*tables)
        lines = done.stderr.splitlines()
        if (done.returncode != 2 or done.stdout or len(lines) != 1
                or not re.match(r'slipway: bad\.csv:\d+:\d+: \S', lines[0])
                or len(lines[0]) > 600 or not lines[0].isprintable()):
            print(f'# {what}: {done}')
            return False
    return True


def crlf_and_a_byte_order_mark_are_no_harm(room):
    room.write('t.csv', b'\xef\xbb\xbf' + GOOD.replace('\n', '\r\n').encode())
    return room.check('t.csv').returncode == 0


def wrong_options_are_refused_in_one_line(room):
    room.write('t.csv', GOOD)
    for args in (['t.csv', '-o', 'x.csv'], ['t.csv', '--alpha', '0.3'],
                 ['t.csv', '--rtol', 'x'], ['t.csv', '--rtol', '1e-15'], [],
                 ['--record'], ['--record', '--law', 'ruina'],
                 ['--record', 't.csv', '--law', 'x', '-o', 'x.csv']):
        done = room.check(*args)
        if (done.returncode != 2 or done.stdout
                or len(done.stderr.splitlines()) != 1):
            print(f'# {args}: {done}')
            return False
    return room.names() == ['.bin', 'scenes', 't.csv']


def files_that_cannot_be_read_or_written_exit_4(room):
    room.write('t.csv', GOOD)
    slope = '--law ruina --alpha 0.3'
    for command in ('slipway check none.csv', 'slipway check .',
                    'slipway check t.csv none.csv',
                    'slipway check t.csv > /dev/full',
                    'slipway check t.csv --tap > /dev/full',
                    'slipway check t.csv --json > /dev/full',
                    f'slipway check --record {slope} > /dev/full',
                    f'slipway check --record {slope} -o /dev/null/x.csv',
                    f'slipway check --record {slope} -o scenes',
                    'slipway check --record none.yaml -o x.csv'):
        done = room.shell(command)
        if done.returncode != 4 or done.stdout:
            print(f'# {command}: {done}')
            return False
    return room.names() == ['.bin', 'scenes', 't.csv']


# ---- recording --------------------------------------------------------------

def every_scene_recorded_holds(room):
    scenes = sorted('scenes/' + name
                    for name in os.listdir(room.path('scenes'))
                    if name.endswith('.yaml')
                    and 'system:' not in room.read('scenes/' + name))
    done = room.check('--record', *scenes, '-o', 'all.csv')
    again = room.check('--record', *scenes)
    held = room.check('all.csv')
    rows = len(room.read('all.csv').splitlines()) - 2
    return (done.returncode == 0 and done.stderr == ''
            and done.stdout == f'wrote all.csv: {rows} rows\n'
            and again.stdout == room.read('all.csv')
            and held.returncode == 0 and rows >= len(scenes)
            and room.names() == ['.bin', 'all.csv', 'scenes'])


def any_number_of_scenes_and_tables_is_taken(room):
    for i in range(150):
        room.write(f's{i}.yaml', 'law: {preset: ruina}\n'
                   f'slope: {{alpha: {0.3 + i / 1e4}}}\n')
    done = room.check('--record', *[f's{i}.yaml' for i in range(150)], '-o',
                      'x.csv')
    text = room.read('x.csv')
    room.write('t.csv', GOOD)
    many = room.check('--tap', *['t.csv'] * 90)
    return (done.returncode == 0 and done.stderr == ''
            and all(f',{0.3 + i / 1e4:.17g}'.rstrip('0') in text
                    or f',{0.3 + i / 1e4!r}' in text for i in range(150))
            and many.returncode == 0 and many.stdout.startswith('1..90\n'))


def composed_laws_and_coarse_accuracy_hold(room):
    done = room.check('--record', '--set', 'law.theta=ln_psi', '--set',
                      'law.psi_ss=spinodal', '--set', 'law.timescale=ageing44',
                      '--set', 'law.kinetics=sinh', '--alpha', '0.35',
                      '--rtol', '1e-5', '-o', 'x.csv')
    return (done.returncode == 0 and room.check('x.csv').returncode == 0
            and room.check('x.csv', '--rtol', '1e-8').returncode == 0)


def every_setting_of_a_row_counts(room):
    room.check('--record', '--ode', "x' = y; y' = -k*x; k = 2", '--window',
               'x=-2:2,y=-1:1', '-o', 'x.csv')
    text = room.read('x.csv')
    at = text.index('"system.ode')
    room.write('y.csv', text[:at] + '"' + 90 * 'title=oscillator\n'
               + text[at + 1:])
    room.write('z.csv', text[:at] + '"' + 90 * 'title=oscillator\n'
               + 'system.parameters.k=3\n' + text[at + 1:])
    return ([room.check(name).returncode for name in ('x.csv', 'y.csv',
                                                      'z.csv')] == [0, 0, 1])


def another_material_does_not_hold(room):
    room.check('--record', '--law', 'ruina', '--alpha', '0.3', '-o', 'x.csv')
    text = room.read('x.csv').replace(',0.369', ',0.370')
    room.write('x.csv', text)
    return room.check('x.csv').returncode == 1


# ---- long tables ------------------------------------------------------------

def start_long(room):
    room.write('long.csv', GOOD + 200000 * 'dieterich_gen,0.34,2832.2\n')
    job = subprocess.Popen([os.path.join(room.bin, 'slipway'), 'check',
                            'long.csv', '--progress', 'json'],
                           cwd=room.folder, stdout=subprocess.PIPE,
                           stderr=subprocess.PIPE, text=True)
    return job, json.loads(job.stderr.readline())


def progress_is_told_and_an_interrupt_stops(room):
    job, first = start_long(room)
    job.send_signal(signal.SIGINT)
    out, _ = job.communicate(timeout=300)
    return (first == {'stage': 'rows', 'done': 1, 'total': 200001}
            and job.returncode == 130 and out == '')


CASES = [
    every_command_of_the_page_works,
    the_recipe_works_in_a_stranger_s_repository,
    reference_tables_hold,
    a_moved_value_is_told_and_exits_1,
    planted_digits_are_found_in_the_reference_table,
    tap_has_a_point_for_every_row_of_every_table,
    json_names_the_place,
    quiet_only_exits,
    the_exit_code_agrees_with_what_is_told,
    bad_tables_are_refused_in_one_line,
    crlf_and_a_byte_order_mark_are_no_harm,
    wrong_options_are_refused_in_one_line,
    files_that_cannot_be_read_or_written_exit_4,
    every_scene_recorded_holds,
    any_number_of_scenes_and_tables_is_taken,
    composed_laws_and_coarse_accuracy_hold,
    every_setting_of_a_row_counts,
    another_material_does_not_hold,
    progress_is_told_and_an_interrupt_stops,
]


def main(slipway, source):
    failed = False
    print(f'1..{len(CASES)}')
    for number, case in enumerate(CASES, 1):
        with tempfile.TemporaryDirectory() as folder:
            good = case(Room(os.path.realpath(folder),
                             os.path.realpath(slipway),
                             os.path.realpath(source)))
        failed = failed or not good
        print(f'{"ok" if good else "not ok"} {number} - {case.__name__}',
              flush=True)
    return failed


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
