#!/usr/bin/env python3
"""The script `run` among tools that only pretend (TAP).

usage: test_run.py PATH_TO_RUN

Each case gets its own copy of the tree's script and a PATH on which every
tool that could change the machine is a fake that writes down how it was
called.
"""
import os
import shutil
import subprocess
import sys
import tempfile

REAL = ['bash', 'cat', 'dirname', 'env', 'flock', 'grep', 'mkdir', 'readlink',
        'rm', 'sed', 'chmod']
MESON = '''case $1 in
setup) mkdir -p "$2"
    case $* in
    *-Dtests=enabled*) printf 'build %s: x\\n' tests/test_knee apps/slipway-mpi;;
    esac >"$2/build.ninja";;
test) mkdir -p "$3/meson-logs"; cat "$ROOM/log" >"$3/meson-logs/testlog.json";;
esac'''
SLIPWAY = 'printf "%s|" "$PWD" "$@"; printf "%s\\n" "$ANSWER"; exit 3'
NINJA = f"""mkdir -p "$2/apps"
cat >"$2/apps/slipway" <<'END'
#!/bin/bash
{SLIPWAY}
END
chmod +x "$2/apps/slipway"
"""
ALL_INSTALLED = '''shift 3; printf 'installed %s\\n' "$@"'''
SOME_INSTALLED = "printf 'installed %s\\n' gcc meson; exit 1"


class Room:
    """A folder with the script, the fakes and what they wrote down."""

    def __init__(self, folder, script, uid='0', dpkg=ALL_INSTALLED):
        self.folder = folder
        self.bin = os.path.join(folder, 'bin')
        os.makedirs(os.path.join(folder, 'tree', 'tests'))
        os.mkdir(self.bin)
        source = os.path.dirname(os.path.abspath(script))
        shutil.copy(script, self.path('tree/run'))
        shutil.copy(os.path.join(source, 'tests/count.py'),
                    self.path('tree/tests'))
        for name in REAL:
            os.symlink(shutil.which(name), os.path.join(self.bin, name))
        os.symlink(sys.executable, os.path.join(self.bin, 'python3'))
        self.fake('id', f'echo {uid}')
        self.fake('dpkg-query', dpkg)
        self.fake('apt-get', '')
        self.fake('meson', MESON)
        self.fake('ninja', NINJA)

    def path(self, name):
        return os.path.join(self.folder, name)

    def fake(self, name, body):
        path = os.path.join(self.bin, name)
        with open(path, 'w', encoding='utf-8') as file:
            file.write(f'#!/bin/bash\necho "{name} $*" >>"$ROOM/calls"\n{body}')
        os.chmod(path, 0o755)

    def write(self, name, text):
        with open(self.path(name), 'w', encoding='utf-8') as file:
            file.write(text)

    def run(self, *args):
        self.write('calls', '')
        return subprocess.run(
            [self.path('tree/run'), *args], cwd=self.bin, text=True,
            env={'PATH': self.bin, 'ROOM': self.folder, 'ANSWER': '42'},
            stdin=subprocess.DEVNULL, capture_output=True, check=False)

    def calls(self, name):
        with open(self.path('calls'), encoding='utf-8') as file:
            return [line for line in file.read().splitlines()
                    if line.startswith(name + ' ')]


def arguments_folder_and_exit_code_pass_through(new):
    room = new()
    done = room.run('study', 'a b.yaml', '--set', '')
    return (done.stdout == f'{room.bin}|study|a b.yaml|--set||42\n'
            and done.stderr == '' and done.returncode == 3)


def nothing_is_asked_of_dpkg_the_second_time(new):
    room = new()
    room.run('laws')
    first = len(room.calls('dpkg-query'))
    room.run('laws')
    return (first == 1 and room.calls('dpkg-query') == []
            and room.calls('meson') == [] and len(room.calls('ninja')) == 1)


def root_installs_what_is_missing_and_no_more(new):
    room = new(dpkg=SOME_INSTALLED)
    done = room.run('laws')
    update, install = room.calls('apt-get')
    return (update.endswith(' update') and 'libgsl-dev' in install
            and 'gnuplot-nox' in install and ' gcc' not in install
            and 'cmocka' not in install and done.returncode == 3)


def tests_need_more_packages(new):
    room = new(dpkg=SOME_INSTALLED)
    room.run('tests')
    asked = room.calls('apt-get')[1].split()
    return {'libcmocka-dev', 'auto-07p', 'gfortran', 'xppaut'} <= set(asked)


def sudo_serves_those_who_are_not_root(new):
    room = new(uid='1000', dpkg=SOME_INSTALLED)
    room.fake('sudo', '[ "$1" = -n ] || exec "$@"')
    done = room.run('laws')
    asked = [call for call in room.calls('sudo') if 'apt-get' in call]
    return (len(asked) == 2 and len(room.calls('apt-get')) == 2
            and done.returncode == 3)


def without_root_or_sudo_missing_packages_are_named(new):
    room = new(uid='1000', dpkg=SOME_INSTALLED)
    done = room.run('laws')
    return (done.returncode == 1 and 'libhdf5-dev' in done.stderr
            and room.calls('apt-get') == [] and room.calls('meson') == [])


def a_failed_installation_is_shown(new):
    room = new(dpkg=SOME_INSTALLED)
    room.fake('apt-get', 'echo no such package; exit 100')
    done = room.run('laws')
    again = room.run('laws')
    return (done.returncode == 1 and 'no such package' in done.stderr
            and again.returncode == 1)


def build_errors_are_shown(new):
    room = new()
    room.fake('ninja', 'echo x.c:1: wrong; exit 1')
    done, tests = room.run('laws'), room.run('tests')
    return (done.returncode == 1 and 'x.c:1: wrong' in done.stderr
            and done.stdout == '' and tests.returncode == 1
            and tests.stdout == 'no test ran\n0 passed, 0 failed\n')


def warnings_are_errors_but_nothing_is_built_twice(new):
    room = new()
    room.run('laws')
    room.run('tests')
    later = room.calls('meson')
    shutil.rmtree(room.path('tree/build'))
    room.run('tests')
    whole = room.calls('meson')
    return (later and not any('werror' in call for call in later)
            and any('configure' in call for call in later)
            and any('-Dwerror=true' in call for call in whole)
            and not any('configure' in call for call in whole))


def last_line_counts_cases(new):
    room = new()
    room.write('log', '\n'.join([
        r'{"result": "OK", "stdout": "1..2\nok 1 - a\nok 2 - b\n"}',
        r'{"result": "OK", "stdout": "ok 1 - a # SKIP no clang\n"}',
        r'{"result": "OK", "stdout": "no TAP"}']))
    done = room.run('tests')
    return (done.stdout.endswith('3 passed, 0 failed\n')
            and done.returncode == 0)


def quick_leaves_the_slow_ones_and_nothing_else_is_known(new):
    room = new()
    room.write('log', r'{"result": "OK", "stdout": "ok 1 - a\n"}')
    quick = room.run('tests', 'quick'), room.calls('meson')[-1]
    wrong = room.run('tests', 'quikc')
    return (quick[0].returncode == 0 and '--no-suite slow' in quick[1]
            and wrong.returncode == 1 and 'quikc' in wrong.stderr
            and not room.calls('meson'))


def failures_count_and_so_do_crashes(new):
    room = new()
    room.write('log', '\n'.join([
        r'{"name": "x", "result": "FAIL",'
        r' "stdout": "1..2\nok 1 - a\nnot ok 2 - b\n# why\n"}',
        r'{"name": "y", "result": "ERROR", "stdout": "1..2\nok 1 - a\n"}',
        r'{"name": "z", "result": "TIMEOUT"}']))
    done = room.run('tests')
    return (done.stdout.endswith('2 passed, 3 failed\n')
            and 'x: not ok 2 - b\n# why\ny: ERROR\nz: TIMEOUT\n' in done.stdout
            and done.returncode == 1)


def no_test_at_all_is_a_failure(new):
    room = new()
    room.write('log', '')
    done = room.run('tests')
    return (done.stdout.endswith('no test ran\n0 passed, 0 failed\n')
            and done.returncode == 1)


CASES = [
    arguments_folder_and_exit_code_pass_through,
    nothing_is_asked_of_dpkg_the_second_time,
    root_installs_what_is_missing_and_no_more,
    tests_need_more_packages,
    sudo_serves_those_who_are_not_root,
    without_root_or_sudo_missing_packages_are_named,
    a_failed_installation_is_shown,
    build_errors_are_shown,
    warnings_are_errors_but_nothing_is_built_twice,
    last_line_counts_cases,
    quick_leaves_the_slow_ones_and_nothing_else_is_known,
    failures_count_and_so_do_crashes,
    no_test_at_all_is_a_failure,
]


def main(script):
    failed = False
    print(f'1..{len(CASES)}')
    for number, case in enumerate(CASES, 1):
        with tempfile.TemporaryDirectory() as folder:
            folder = os.path.realpath(folder)
            good = case(lambda **options: Room(folder, script, **options))
        failed = failed or not good
        print(f'{"ok" if good else "not ok"} {number} - {case.__name__}')
    return failed


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
