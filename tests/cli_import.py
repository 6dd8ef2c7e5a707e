#!/usr/bin/env python3
"""slipway import, and models of XPPAUT given to other commands (TAP).

usage: cli_import.py PATH_TO_SLIPWAY SOURCE_ROOT

XPPAUT's own examples are looked for where Debian's package has them; without
them that case says so and passes.
"""
import glob
import os
import time

from cli_room import expect, refused, run_cases

BRUSSELATOR = '''# the Brusselator
X' = A + f(X, Y) - (b + 1)*X
dY/dt = b*x - f(x,y)
f(u,v) = u**2*v
par a=1, B=1.8
init x=1 y=1
aux sum = x + y
@ total=50, xp=x, yp=y, xlo=0.1, xhi=4, ylo=0.1, yhi=4
done
'''
EXAMPLES = '/usr/share/doc/xppaut'


def a_model_and_its_scene_give_the_same_numbers(room):
    room.write('b.ode', BRUSSELATOR)
    expect(room.good('import', 'b.ode', '-o', 'b.yaml') == 'wrote b.yaml\n')
    shown = room.good('import', 'b.ode')
    expect(shown == room.read('b.yaml'), shown)
    expect(room.json('import', 'b.ode')['scene'] == shown)
    own = room.json('portrait', 'b.ode', '-o', 'a.h5')
    scene = room.json('portrait', 'b.yaml', '-o', 'b.h5')
    for found in own, scene:
        found.pop('cost', None)
    expect(own == scene, own, scene)
    expect(len(own['equilibria']) == 1, own)
    q = own['equilibria'][0]
    expect(q['type'] == 'stable_focus' and own['equilibria_complete'], q)
    expect(abs(q['state']['x']['value'] - 1) <= q['state']['x']['error'], q)
    expect(abs(q['state']['y']['value'] - 1.8) <= q['state']['y']['error'] +
           1e-15, q)


def a_parameter_of_a_model_can_be_set(room):
    room.write('b.ode', BRUSSELATOR)
    found = room.json('portrait', 'b.ode', '--set', 'system.parameters.b=3',
                      '-o', 'a.h5')
    expect(found['equilibria'][0]['type'] == 'unstable_focus', found)


def what_cannot_be_read_costs_one_line_and_leaves_nothing(room):
    room.write('three.ode', "x'=y\ny'=z\nz'=-x\n")
    room.write('time.ode', "x'=y\ny'=sin(t)\n")
    room.write('wrong.ode', "x'=y\ny'=x + bet\npar beta=1\n")
    before = room.names()
    for command in 'import', 'portrait', 'study':
        refused(room.run(command, 'three.ode', '-o', 'a'), 2, 'three.ode:3: z')
        refused(room.run(command, 'time.ode', '-o', 'a'), 2, 'time.ode:2:',
                'not autonomous')
        refused(room.run(command, 'wrong.ode', '-o', 'a'), 2, 'wrong.ode:2:',
                'beta?')
    refused(room.run('import', 'none.ode'), 4, 'none.ode')
    refused(room.run('import'), 2, 'NAME.ode')
    room.write('b.ode', BRUSSELATOR)
    refused(room.run('import', 'b.ode', '-o', '/dev/null/b.yaml'), 4, '/dev/null/b.yaml')
    expect(room.names() == sorted([*before, 'b.ode']), room.names())


def states_may_have_the_names_that_neurons_have(room):
    room.write('n.ode', "v'=v - v^3/3 - n + i\nn'=.08*(v + .7 - .8*n)\n"
               "par i=.5\n")
    found = room.json('portrait', 'n.ode', '-o', 'n.h5')
    expect(found['equilibria'][0]['type'] == 'unstable_focus', found)


def every_example_of_xppaut_is_analysed_or_refused(room):
    files = sorted(glob.glob(EXAMPLES + '/**/*.ode', recursive=True))
    done, reasons = 0, {}
    for path in files:
        begin = time.monotonic()
        found = room.run('portrait', path, '-o', 'a.h5')
        seconds = time.monotonic() - begin
        expect(seconds < 10, path, seconds)
        if found.returncode == 0:
            done += 1
        else:
            refused(found, 2, os.path.basename(path))
            reason = found.stderr.split(': ')[-1].strip()
            reasons[reason] = reasons.get(reason, 0) + 1
    print(f'# {len(files)} models, {done} analysed'
          if files else '# the examples of xppaut are not installed')
    for reason, count in sorted(reasons.items()):
        print(f'#   {count} {reason}')
    expect(done > 0 or not files)


run_cases([
    a_model_and_its_scene_give_the_same_numbers,
    a_parameter_of_a_model_can_be_set,
    what_cannot_be_read_costs_one_line_and_leaves_nothing,
    states_may_have_the_names_that_neurons_have,
    every_example_of_xppaut_is_analysed_or_refused,
])
