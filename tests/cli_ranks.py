#!/usr/bin/env python3
"""Sweeps and ensembles that are shared: --shard and merge, and the ranks of slipway-mpi
(TAP).  RANK_KILLS sets how many times a run of ranks is killed (3).

usage: cli_ranks.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import os
import random
import shutil
import signal
import subprocess
import time

from cli_room import expect, refused, run_cases

SWEEP = ['--law', 'spinodal_gen', '--set', 'sweep={key: slope.alpha, from: '
         '0.28, to: 0.4, points: 40, refine: 0.05}']
MAPS = ['--law', 'spinodal_gen', '--set', 'products=[knees, basins, margin]',
        '--set', 'basins={cells: [3, 2], audit: 0}', '--set',
        'sweep={key: slope.alpha, values: [0.2, 0.3, 0.32, 0.34, 0.36]}']
DRAWS = """
law: {preset: spinodal_gen}
slope: {alpha: 0.34}
ensemble:
  parameters: {material.a: {normal: [0.0349, 0.004]},
               material.c: {lognormal: [1e-3, 3]}}
  draws: 5000
  numbers: [v_plus, v_minus]
  pushes: [{v: 2000, psi: 10}]
"""
MANY = ['--law', 'spinodal_gen', '--set', 'sweep={key: slope.alpha, from: '
        '0.28, to: 0.4, points: 3000}']
LONG = [text.replace('3000', '30000') for text in MANY]


def ranks(room, count, *args):
    """mpirun with so many of them, on fewer cores if need be."""
    return subprocess.Popen(
        ['mpirun', '--allow-run-as-root', '--oversubscribe', '-n', str(count),
         room.slipway + '-mpi', *args], cwd=room.folder, text=True,
        env=room.environment(), stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def of_ranks(process):
    found = subprocess.run(['pgrep', '-P', str(process.pid)], text=True,
                           capture_output=True, check=False)
    return [int(pid) for pid in found.stdout.split()]


def first_rank(process):
    """Its number is in the environment that Open MPI or MPICH gives it."""
    def is_first(pid):
        with open(f'/proc/{pid}/environ', 'rb') as environment:
            given = environment.read().split(b'\0')
        return b'OMPI_COMM_WORLD_RANK=0' in given or b'PMI_RANK=0' in given

    return next(filter(is_first, of_ranks(process)))


def ends(process):
    try:
        said, complaint = process.communicate(timeout=120)
    except subprocess.TimeoutExpired:
        for pid in [process.pid, *of_ranks(process)]:
            os.kill(pid, signal.SIGKILL)
        raise
    return process.returncode, said, complaint


def complaints(text):
    return [line for line in text.splitlines() if line.startswith('slipway')]


# ---- shares ------------------------------------------------------------------


def shares_are_merged_into_the_bytes_of_one_run(room):
    for sweep in (SWEEP, MAPS):
        whole = room.good('sweep', *sweep, '-o', 'whole.h5')
        for share in ('2/3', '3/3', '1/3'):
            said = room.good('sweep', *sweep, '-o', 'a.h5', '--shard', share)
            expect(f'share {share}: ' in said and 'slipway merge' in said, said)
        expect('a.h5' not in room.names(), room.names())
        said = room.good('merge', *sweep, '-o', 'a.h5')
        expect('points were there already' in said and 'v_plus' in said, said)
        expect(room.bytes('a.h5') == room.bytes('whole.h5'), whole)
        expect(room.names() == ['a.h5', 'whole.h5'], room.names())
        os.remove(room.path('a.h5'))


def an_ensemble_is_shared_like_a_sweep(room):
    room.write('draws.yaml', DRAWS)
    said = room.good('ensemble', 'draws.yaml', '-o', 'whole.h5')
    expect('exist' in said or 'missing' in said, said)
    for share in ('1/2', '2/2'):
        said = room.good('ensemble', 'draws.yaml', '-o', 'a.h5', '--shard',
                         share)
        expect(f'share {share}: ' in said, said)
    said = room.good('merge', 'draws.yaml', '-o', 'a.h5')
    expect('5000 of 5000 draws were there already' in said, said)
    expect(room.bytes('a.h5') == room.bytes('whole.h5'), 'the same bytes')
    expect(room.names() == ['a.h5', 'draws.yaml', 'whole.h5'], room.names())


def reasons_have_the_order_of_the_draws(room):
    """though a share meets them in another: seed 7 has rare ones"""
    room.write('draws.yaml', """
law: {preset: spinodal_gen}
slope: {alpha: 0.34}
ensemble:
  parameters: {material.a: {normal: [0.0349, 0.01]}, slope.alpha: {normal: [
               0.34, 0.03]}, material.b: {normal: [0.0489, 0.013]}}
  draws: 6000
  seed: 7
  numbers: [saddle_v]
""")
    room.good('ensemble', 'draws.yaml', '-o', 'whole.h5')
    for share in ('3/3', '1/3', '2/3'):
        room.good('ensemble', 'draws.yaml', '-o', 'a.h5', '--shard', share)
    room.good('merge', 'draws.yaml', '-o', 'a.h5')
    expect(room.bytes('a.h5') == room.bytes('whole.h5'), 'the same bytes')


def an_interrupted_share_goes_on_or_is_completed(room):
    room.good('sweep', *SWEEP, '-o', 'whole.h5')
    for share in ('1/2', '2/2'):
        room.good('sweep', *SWEEP, '-o', 'a.h5', '--shard', share)
    part = room.path('a.h5.part.2-of-2')
    os.truncate(part, os.path.getsize(part) // 2)
    shutil.copy(part, room.path('torn'))
    said = room.good('merge', *SWEEP, '-o', 'a.h5')
    expect('points were there already' in said
           and room.bytes('a.h5') == room.bytes('whole.h5'), said)
    os.replace(room.path('torn'), part)
    said = room.good('sweep', *SWEEP, '-o', 'a.h5', '--shard', '2/2', '--resume')
    expect('20 of 40 points' in said, said)


def what_is_missing_or_wrong_costs_one_line(room):
    merge = ['merge', *SWEEP, '-o', 'a.h5']
    refused(room.run(*merge), 2, 'a.h5.part: no share of it is there',
            '--shard 1/N')
    for share in ('1/4', '2/4', '4/4'):
        room.good('sweep', *SWEEP, '-o', 'a.h5', '--shard', share)
    refused(room.run(*merge), 2, 'a.h5.part.3-of-4: not there')
    refused(room.run('merge', *MAPS, '-o', 'a.h5'), 2, 'a.h5.part.3-of-4')
    room.good('sweep', *MAPS, '-o', 'a.h5', '--shard', '3/4')
    refused(room.run(*merge), 2, 'a.h5.part.3-of-4: of another scene')
    expect(len(room.names()) == 5, room.names())  # all shares, and the whole's
    for share in ('0/3', '4/3', '1/', '1/3x', '-1/3', '1', 'x', '1/9999999'):
        refused(room.run('sweep', *SWEEP, '-o', 'b.h5', '--shard', share), 2,
                f'--shard {share}: expected I/N', '3/8')
    refused(room.run('sweep', *SWEEP, '--shard', '1/2'), 2,
            '--shard without a file')
    refused(room.run('merge', *SWEEP), 2, 'merge without a file')
    refused(room.run('knees', '--law', 'ruina', '--shard', '1/2'), 2, '--shard')
    expect(len(room.names()) == 5, room.names())


# ---- ranks -------------------------------------------------------------------


def any_number_of_ranks_writes_the_same_bytes(room):
    for sweep in (SWEEP, MAPS):
        said = room.good('sweep', *sweep, '-o', 'a.h5')
        whole = room.bytes('a.h5')
        for count in (1, 2, 3, 4):
            code, told, complaint = ends(ranks(room, count, 'sweep', *sweep,
                                               '-o', 'a.h5'))
            expect((code, told) == (0, said), count, told, complaint)
            expect(room.bytes('a.h5') == whole, count, 'ranks')
            expect(room.names() == ['a.h5'], room.names())


def any_number_of_ranks_draws_the_same_bytes(room):
    room.write('draws.yaml', DRAWS)
    room.good('ensemble', 'draws.yaml', '-o', 'whole.h5')
    for count in (1, 3):
        code, _, complaint = ends(ranks(room, count, 'ensemble', 'draws.yaml',
                                        '-o', 'a.h5'))
        expect(code == 0, complaint)
        expect(room.bytes('a.h5') == room.bytes('whole.h5'), count, 'ranks')


def killed_at_any_moment_ranks_go_on(room):
    room.good('sweep', *MANY, '-o', 'whole.h5')
    seed = int(os.environ.get('CHECK_SEED', '20240229'))
    chance = random.Random(seed)
    kills = 0
    for _ in range(int(os.environ.get('RANK_KILLS', '3'))):
        count = chance.choice((2, 3, 4))
        process = ranks(room, count, 'sweep', *MANY, '-o', 'a.h5', '--resume')
        time.sleep(chance.uniform(0.3, 1.5))
        for pid in [process.pid, *of_ranks(process)]:
            os.kill(pid, signal.SIGKILL)
        kills += process.wait() == -signal.SIGKILL
        process.communicate()
    expect(kills > 0, 'nothing was killed; seed', seed)
    code, said, complaint = ends(ranks(room, 2, 'sweep', *MANY, '-o', 'a.h5',
                                       '--resume'))
    expect(code == 0, said, complaint)
    expect(room.bytes('a.h5') == room.bytes('whole.h5'), 'seed', seed)
    expect(room.names() == ['a.h5', 'whole.h5'], room.names())


def wait_for_parts(room, count):
    while len([name for name in room.names() if '-of-' in name]) < count:
        time.sleep(0.01)


def a_rank_that_dies_ends_the_run_which_one_process_resumes(room):
    room.good('sweep', *MANY, '-o', 'whole.h5')
    process = ranks(room, 3, 'sweep', *MANY, '-o', 'a.h5')
    wait_for_parts(room, 3)
    os.kill(of_ranks(process)[-1], signal.SIGKILL)
    code, said, complaint = ends(process)
    expect(code not in (0, 3) and said == '', code, said)
    expect('exited on signal 9' in complaint or 'Killed' in complaint, complaint)
    expect(complaints(complaint) in ([], [
        'slipway: interrupted; what is computed stays in a.h5.part for '
        '--resume']), complaint)
    said = room.good('sweep', *MANY, '-o', 'a.h5', '--resume')
    expect('points were there already' in said, said)
    expect(room.bytes('a.h5') == room.bytes('whole.h5'), 'the same bytes')


def interrupted_ranks_say_where_they_stopped(room):
    """the first by itself: who is interrupted by mpirun has a second before it
    is killed, which on a busy machine is too little for anybody's last word"""
    process = ranks(room, 2, 'sweep', *LONG, '-o', 'a.h5')
    wait_for_parts(room, 2)
    os.kill(first_rank(process), signal.SIGTERM)
    code, said, complaint = ends(process)
    expect(code != 0 and said == '', code, said)
    expect(complaints(complaint) == [
        'slipway: interrupted; what is computed stays in a.h5.part for '
        '--resume'], complaint)
    expect('a.h5' not in room.names(), room.names())


def ranks_complain_once(room):
    for args, code, words in (
            (['knees', '--law', 'ruina', '--alpha', '0.3'], 2, 'several ranks'),
            (['sweep', 'nothere.yaml', '-o', 'a.h5'], 4, 'nothere.yaml'),
            (['sweep', *SWEEP], 2, 'sweep without a file'),
            (['sweep', *SWEEP, '-o', 'none/such/../../a.txt/b.h5'], 4, 'b.h5')):
        room.write('a.txt', 'a file')
        found, said, complaint = ends(ranks(room, 3, *args))
        lines = complaints(complaint)
        expect((found, said) == (code, '') and len(lines) == 1
               and words in lines[0], found, said, complaint)


SHARES = [
    shares_are_merged_into_the_bytes_of_one_run,
    an_ensemble_is_shared_like_a_sweep,
    reasons_have_the_order_of_the_draws,
    an_interrupted_share_goes_on_or_is_completed,
    what_is_missing_or_wrong_costs_one_line,
]
RANKS = [
    any_number_of_ranks_writes_the_same_bytes,
    any_number_of_ranks_draws_the_same_bytes,
    killed_at_any_moment_ranks_go_on,
    a_rank_that_dies_ends_the_run_which_one_process_resumes,
    interrupted_ranks_say_where_they_stopped,
    ranks_complain_once,
]
run_cases(SHARES + (RANKS if shutil.which('mpirun') else []))
