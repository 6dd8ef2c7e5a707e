#!/usr/bin/env python3
"""Makes the seeds of the fuzz targets, from what the project has anyway.

usage: seeds.py PATH_TO_SLIPWAY SOURCE_ROOT FOLDER

FOLDER/scene, csv, formula, hdf5, journal, ode get the seeds, and what tests/fuzz/found has
under these names: inputs that once were findings;
FOLDER/scene.dict the words of scenes; FOLDER/whole.h5 is for FUZZ_WHOLE.
"""
import glob
import os
import re
import shutil
import subprocess
import sys

SLOPE = ['--law', 'dieterich_gen', '--alpha', '0.34']
SETS = '''#set slope={alpha_deg: 20}
#set window.v=[1e-3, 1e3]
#set title=Anything
'''
SWEEPS = ['sweep: {key: material.a, values: [0.01, 0.02, 0.03]}',
          'sweep: [{key: slope.alpha, from: 0.2, to: 0.4, points: 3}, '
          '{key: material.R, from: 1, to: 9, points: 4, scale: log}]',
          'material: {preset: bristol_board, R: inf, V_star: 1e-6}\n'
          'rabinowicz: {tan_alpha: [0.3, 0.4], data: a.csv, restitution: 1}']
# What has broken parsers elsewhere: deep, long, wide, and doubled ten times.
LAUGHS = ''.join(f'a{i}: &a{i} [{", ".join([f"*a{i - 1}"] * 9)}]\n'
                 for i in range(1, 10))
HOSTILE = [LAUGHS, '[' * 100000, '{a: ' * 100000, '- ' * 100000, '? ' * 100000,
           'x' * 1000000 + ': 1', 'title: "' + 'x' * 1000000, 'a: ' * 100000,
           'title: ' + 'é' * 400000, "title: '" + "''" * 400000, '\t' * 500000,
           'title: "' + '\\x41' * 200000 + '"', '#' * 1000000, '&' * 1000000,
           'title: |\n' + ' x\n' * 300000, 'title: >\n' + ' x\n\n' * 200000,
           '\n'.join(f'k{i}: 1' for i in range(90000)), '%' * 1000000,
           'title: ' + '9' * 1000000, '---\n' * 250000, '!' * 1000000,
           'slope: {alpha: 0.' + '3' * 500000 + '}',
           'estimates: {xi: [' + '0.5, ' * 200000 + ']}',
           'trajectories: {starts: [' + '{v: 1, psi: 1}, ' * 60000 + ']}',
           'sweep: {key: slope.alpha, values: ['
           + ', '.join(f'0.{i:06}' for i in range(100000, 190000)) + ']}',
           ''.join('title: a\n#set title=b\n' for _ in range(40000)),
           'title: "a\\0b"\n', '"a\\0b": 1\n', '\0' * 1000, 'title: a\0b\n',
           '\ufeff' * 300000, '\ud800'.encode('utf-8', 'surrogatepass')]
# Records of a sweep's side file as fuzz_journal.c takes them: a sentence; a row
# of one number that is there, and of one that is not.
REASON = b'\1\x09\0too steep'
ROWS = [b'\2\x34\0' + bytes(40) + bytes([code]) + bytes(11) for code in (1, 2)]


def write(path, content):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'wb') as file:
        file.write(content if isinstance(content, bytes) else content.encode())


def read(path):
    with open(path, 'rb') as file:
        return file.read()


def scenes(source, folder):
    for path in glob.glob(source + '/scenes/*.yaml'):
        write(f'{folder}/scene/{os.path.basename(path)}', read(path))
        write(f'{folder}/scene/set-{os.path.basename(path)}',
              read(path) + SETS.encode())
    for i, text in enumerate(SWEEPS):
        write(f'{folder}/scene/own-{i}.yaml', 'law: {preset: spinodal_gen}\n'
              'slope: {alpha: 0.34}\n' + text + '\n')
    for i, text in enumerate(HOSTILE):
        write(f'{folder}/scene/hostile-{i}', text)


def dictionary(source, folder):
    """Every word in quotes of the code that knows scenes."""
    words = set()
    for path in glob.glob(source + '/lib/scene/*.c') + [
            source + '/lib/friction/law.c']:
        words |= {part for word in re.findall(r'"([a-zA-Z_0-9.]{1,40})"',
                                              read(path).decode())
                  for part in (word, *word.split('.'))}
    signs = ['[', ']', '{', '}', ', ', ': ', '- ', '&a ', '*a', '!!str ', '? ',
             '|\\x0a', '>\\x0a', '\\"', '---\\x0a', '...\\x0a', '%YAML 1.1\\x0a',
             '\\x0a#set ', '\\xef\\xbb\\xbf', '\\xff', '\\x00', 'inf', '1e308',
             '1e-400', '250000', '99999999999999999999', '0x10', '<<']
    write(folder + '/scene.dict', ''.join(
        f'"{word}"\n' for word in [*sorted(words - {''}), *signs]))


def tables(slipway, source, folder):
    """A few lines of each table are enough, and quicker."""
    os.makedirs(folder + '/csv', exist_ok=True)
    subprocess.run([slipway, 'check', '--record', *SLOPE, '-q', '-o',
                    folder + '/csv/recorded'], check=True)
    for path in glob.glob(source + '/tests/reference/*.csv'):
        lines = read(path).splitlines(keepends=True)[:4]
        write(f'{folder}/csv/{os.path.basename(path)}', b''.join(lines))
    for i, cell in enumerate(('a,' * 500000, '"' * 999999, 'a\n' * 500000,
                              ' ' * 999999, '"a\n' * 300000, '\r' * 999999,
                              'v,psi\n' + '1,2\n' * 200000, '9' * 999999,
                              ','.join(f'a{i}' for i in range(1024)) + '\n'
                              + ',' * 1023)):
        write(f'{folder}/csv/hostile-{i}', cell)
    write(folder + '/csv/states', 'v,psi\n1,2\n 1e3 ,"0.5"\r\n# none\n1,\n')
    write(folder + '/csv/data', '\ufefftan_alpha,l_k,l_k_error,x_k\n'
          '0.3,0.01,1e-3,\n0.4,"0.02",,1e-6\n')


def formulas(folder):
    for i, text in enumerate((
            '(b - a*asinh(v/2*exp((b + a*y)/a)))/sqrt(1 + b^2)#-(y + ln(v))*v',
            '-sinh(y - 1/v)*exp(-1/v)', 'y - y^3/3 + b#(v - a)/(y^2 + 1)',
            'v*(exp(-v/a - ln(v)) - ln(v))', 'tan(b) - lambert(a)*sinh(y)*y',
            '(v + a)^(1/3) - v^y#ln(v^2 + exp(y))', 'pi*1.5e-3', '1..2', '')):
        write(f'{folder}/formula/own-{i}', text)
    for i, text in enumerate((
            '(' * 1000 + 'v', 'v^' * 1000 + 'v', '-' * 9999 + 'v', 'v' * 10001,
            'exp(' * 199 + 'y' + ')' * 199, 'sinh(' * 199 + 'v' + ')' * 199,
            '+'.join(f'{i}/(v+{i})' for i in range(700)), 'y*' * 4999 + 'y',
            '(y-1)*' * 900 + 'y', '(y-v)/' * 900 + 'y', '1e' + '9' * 9000,
            '0.' + '3' * 9000, '\0' * 99, 'ln(' * 180 + 'v' + ')' * 180)):
        write(f'{folder}/formula/hostile-{i}', text)
    write(folder + '/formula.dict', ''.join(
        f'"{word}"\n' for word in ('exp(', 'ln(', 'sqrt(', 'sinh(', 'asinh(',
                                   'tan(', 'lambert(', 'v', 'y', 'a', 'b',
                                   '^', '#', 'pi', '0.5', '1e3', '-', '1/v')))


def models(folder):
    """And XPPAUT's own, where they are."""
    for i, text in enumerate((
            "x'=f(x,a)-y\ndy/dt=eps*(x-g*y)\nf(u,k)=u*(1-u)*(u-k)\n"
            "par a=.25 eps=.1,g=1\ninit x=.5\n@ xp=x,yp=y,xlo=-1,xhi=2\ndone\n",
            "q'=p\np'=-sin(q)-d*p\n@ fold=q\npar d=.2\n",
            "x'=x*(1-x-y/(h+x))\ny'=y*(m*x/(h+x)-d)\nnumber m=2,h=.3,d=1\n",
            "v'=tanh(v/2)**3-w+log(2+cos(w))\nw'=z-w^1.5\nz=asin(v/9)\n!k=z\n",
            "x'=delay(x,1)\ny'=t\nglobal 1 x {x=0}\n", "x(t+1)=y\n",
            "x'=f(f(f(f(x))))\nf(x)=f(x)+g(x)\ng(x)=x\ny'=x", "d\n",
            "x'=a\n" + "".join(f"a{i}=a{i + 1}+a{i + 2}\n" for i in range(90)),
            "x'=y\\\n+y\r\ny'=x\\", "par a=1," * 2000, "f(" * 5000,
            "@ " + "a=b," * 9000, "x'=" + "f(" * 2000 + "\nf(x)=x",
            "x'=f1(x)\ny'=x\n" + "".join(f"f{i}(x)=f{i + 1}(x)*f{i + 1}(x)\n"
                                        for i in range(1, 60)))):
        write(f'{folder}/ode/own-{i}', text)
    for path in glob.glob('/usr/share/doc/xppaut/**/*.ode', recursive=True):
        write(f'{folder}/ode/{os.path.basename(path)}', read(path))
    write(folder + '/ode.dict', ''.join(
        f'"{word}"\n' for word in (
            "x'=", "y'=", 'dx/dt=', 'par ', 'init ', 'number ', 'aux ', '@ ',
            'f(u)=', 'f(', 'done', '!', '\\x0a', '\\\\\\x0a', 'exp(', 'ln(', 'log(',
            'sqrt(', 'sin(', 'cos(', 'tan(', 'asin(', 'atan(', 'tanh(', 'cosh(',
            'sinh(', 'acos(', '**', '^', '^-1', '^0.5', 'fold=x', '1/', 'x', 'y',
            'a', '0', '1e3', '1e-9', '-')))


def results(slipway, folder):
    for name, products in (('small', '[equilibria]'), ('knees', '[knees]'),
                           ('all', '[equilibria, folds, manifolds, basins]')):
        path = f'{folder}/hdf5/{name}.h5'
        os.makedirs(os.path.dirname(path), exist_ok=True)
        subprocess.run([slipway, 'study', *SLOPE, '-q', '-o', path, '--set',
                        f'products={products}', '--set',
                        'basins={cells: [4, 4], audit: 0}'], check=True)
    shutil.copy(folder + '/hdf5/small.h5', folder + '/whole.h5')


def main(slipway, source, folder):
    scenes(source, folder)
    dictionary(source, folder)
    tables(slipway, source, folder)
    formulas(folder)
    models(folder)
    results(slipway, folder)
    write(folder + '/journal/records', REASON + b''.join(ROWS))
    write(folder + '/journal/head', b'slipswp\0\7' + bytes(99))
    found = source + '/tests/fuzz/found'
    if os.path.isdir(found):
        shutil.copytree(found, folder, dirs_exist_ok=True)


if __name__ == '__main__':
    main(*sys.argv[1:])
