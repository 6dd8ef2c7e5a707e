#!/usr/bin/env python3
"""Figures on a journal's page: sizes and letters, read from the PDF (TAP).

usage: cli_paper.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import math
import os
import re
import struct
import subprocess
import xml.etree.ElementTree

from cli_room import SLOPE, expect, refused, run_cases

POINT = 25.4 / 72
COARSE = ['--set', 'basins={cells: [24, 16], audit: 10}']


def words(path):
    """Of the first page: text, left, top, right, bottom in pt; the page."""
    found = subprocess.run(['pdftotext', '-bbox', path, '-'], text=True,
                           capture_output=True, check=True).stdout
    page = re.search(r'<page width="([\d.]+)" height="([\d.]+)"', found)
    return [(m[5], *map(float, m.group(1, 2, 3, 4))) for m in re.finditer(
        r'<word xMin="([-\d.]+)" yMin="([-\d.]+)" xMax="([-\d.]+)" '
        r'yMax="([-\d.]+)">(.*?)</word>', found)], float(page[1]), float(page[2])


def heights(path):
    """Of all texts: their font's, from its ascent to its descent, pt."""
    found = subprocess.run(['pdftohtml', '-xml', '-stdout', '-i', '-zoom', '1',
                            '-hidden', '-noroundcoord', path], text=True,
                           capture_output=True, check=True).stdout
    return [float(size) for size in re.findall(r'<text [^>]*height="([\d.]+)"',
                                               found)]


def letters(room, path, known=[]):
    """Sizes of all letters, pt: the font's height by its size is known from
    the largest letters without a title, which are the axes' labels, 14/13 of
    20 pt."""
    if not known:
        room.good('portrait', *SLOPE, '--figure', 'known.pdf', '--figure-width',
                  '400', '--figure-type', '20', '--set', 'figure.title=false',
                  '--set', 'products=[nullclines]')
        known.append(max(heights(room.path('known.pdf'))) / (20 * 14 / 13))
        os.remove(room.path('known.pdf'))
    return [height / known[0] for height in heights(path)]


# ---- every figure of the project ----------------------------------------------


def overlap(a, b):
    """Of two boxes, as a part of the smaller one's."""
    wide = min(a[3], b[3]) - max(a[1], b[1])
    high = min(a[4], b[4]) - max(a[2], b[2])
    least = min((c[3] - c[1]) * (c[4] - c[2]) for c in (a, b))
    return wide * high / least if wide > 0 and high > 0 else 0


def check_text(room, path, width):
    """Nothing clipped, nothing cut, no two words on each other; returns the
    smallest letter, pt."""
    found, wide, high = words(path)
    expect(len(found) > 8, path, found)
    expect(abs(wide * POINT - width) < 0.01, path, wide)
    for word in found:
        expect(-0.1 < word[1] and word[3] < wide + 0.1 and -0.1 < word[2]
               and word[4] < high + 0.1, path, word)
        expect('\u2026' not in word[0], path, word)
    for i, a in enumerate(found):
        for b in found[:i]:
            expect(overlap(a, b) < 0.3, path, a, b)
    return min(letters(room, path))


def check_figures(room, folder, width, count):
    """All PDFs of a folder; no letter is smaller than 6 pt."""
    drawn = [name for name in room.names(folder) if name.endswith('.pdf')]
    expect(len(drawn) >= count, drawn)
    for name in drawn:
        least = check_text(room, room.path(f'{folder}/{name}'), width)
        expect(least >= 6, name, least)


def figures_of_the_project_fit_one_column(room):
    """Two columns they fill in cli_gallery.py."""
    room.bring('scenes')
    room.make('g')
    for name in room.names('scenes'):
        if 'figure: ' in room.read('scenes/' + name):
            room.good('study', 'scenes/' + name, '-q', '--set', 'output={}',
                      '--figure', f'g/{name[:-5]}.pdf', '--figure-width',
                      'one_column', *COARSE)
    check_figures(room, 'g', 89, 31)


# ---- one figure ----------------------------------------------------------------


def sizes(room, name):
    """Width and height in mm as the file itself says."""
    data = room.bytes(name)
    if name.endswith('.svg'):
        root = xml.etree.ElementTree.fromstring(data)
        return tuple(float(root.get(key)[:-2]) for key in ('width', 'height'))
    if name.endswith('.png'):
        dots = struct.unpack('>II', data[16:24])
        at = data.index(b'pHYs') + 4
        return tuple(n / m * 1e3 for n, m in
                     zip(dots, struct.unpack('>II', data[at:at + 8])))
    box = [float(x) for x in
           re.search(rb'/MediaBox \[([-\d. ]+)', data)[1].split()]
    return (box[2] - box[0]) * POINT, (box[3] - box[1]) * POINT


def a_figure_is_as_large_as_it_was_asked_for(room):
    for ending, near in (('svg', 1e-5), ('pdf', 1e-4), ('png', 0.05)):
        name = 'a.' + ending
        room.good('portrait', *SLOPE, '--figure', name, '--figure-width', '120',
                  '--figure-height', '77.7', '--set', 'products=[nullclines]')
        for found, wanted in zip(sizes(room, name), (120, 77.7)):
            expect(abs(found - wanted) < near, name, found)
        for word, mm in (('one_column', 89), ('two_columns', 183),
                         ('slide', 254), ('screen', 238.125)):
            room.good('portrait', *SLOPE, '--figure', name, '--set',
                      'products=[nullclines]', '--set', f'figure.width={word}')
            expect(abs(sizes(room, name)[0] - mm) < near, name, word)


def letters_are_as_large_as_they_were_asked_for(room):
    for size in (7, 8, 9):
        room.good('portrait', *SLOPE, '--figure', 'a.pdf', '--figure-width',
                  'one_column', '--figure-type', str(size), '--set',
                  'products=[nullclines]')
        found = letters(room, room.path('a.pdf'))
        expect(min(found) >= 6 and any(abs(x - size) < 0.01 for x in found),
               size, found)


def plot_dots(room, name, dpi):
    """Width and height of the plot in dots of the page."""
    script = room.read(name + '.gp')
    left, right, bottom, top = (float(re.search(
        rf'set {side}margin at screen ([\d.]+)', script)[1]) for side in 'lrbt')
    wide, high = sizes(room, name + '.svg')
    return (right - left) * wide / 25.4 * dpi, (top - bottom) * high / 25.4 * dpi


def segments(room, name, entry):
    """Of the curves with that line in the legend."""
    last, wanted = None, False
    for line in room.read(name).splitlines():
        if line.startswith('# block'):
            wanted = line.endswith(': curves ' + entry)
        here = tuple(map(float, line.split())) if wanted and line[:1] not in (
            '', '#') else None
        if here and last:
            yield last, here
        last = here


def lines_are_a_quarter_of_a_dot_from_their_curves(room):
    """x' = 0 on a cubic, y' = 0 on a circle; the slopes are theirs."""
    curves = {'dx/dt = 0': (lambda x, y: y - x**3 + x,
                            lambda x, y: (1 - 3 * x * x, 1)),
              'dy/dt = 0': (lambda x, y: x * x + y * y - 1,
                            lambda x, y: (2 * x, 2 * y))}
    for width, dpi in (('screen', 300), ('one_column', 300),
                       ('two_columns', 300), ('two_columns', 600)):
        room.good('portrait', '--ode', "x' = y - x^3 + x; y' = x^2 + y^2 - 1",
                  '--window', 'x=-1.5:1.5,y=-1.5:1.5', '--set',
                  'products=[nullclines]', '--figure', 'a.svg', '--keep-script',
                  '--figure-width', width, '--set', f'figure.dpi={dpi}')
        wide, high = (dots / 3 for dots in plot_dots(room, 'a', dpi))
        for entry, (value, slope) in curves.items():
            found = list(segments(room, 'a.dat', entry))
            expect(len(found) > 20, entry, len(found))
            worst = 0
            for a, b in found:
                for k in range(5):
                    x, y = (p + k / 4 * (q - p) for p, q in zip(a, b))
                    along, up = slope(x, y)
                    worst = max(worst, abs(value(x, y)) / (
                        (along / wide)**2 + (up / high)**2)**0.5)
            expect(worst < 0.25, width, dpi, entry, worst)


def a_nullcline_of_friction_is_as_smooth(room):
    """psi = 101/(1 + 100 v), where it bends most: no polygon."""
    room.good('portrait', '--law', 'spinodal_gen', '--alpha', '0.34',
              '--figure', 'a.svg', '--keep-script', '--figure-width',
              'two_columns', '--set', 'products=[nullclines]')
    wide, high = plot_dots(room, 'a', 300)
    across, up = wide / math.log(1e12), high / math.log(1e5)
    found = list(segments(room, 'a.dat', 'dψ/dt = 0'))
    expect(len(found) > 10, found)
    for a, b in found:
        for k in range(9):
            x, y = (math.log(p) + k / 8 * (math.log(q) - math.log(p))
                    for p, q in zip(a, b))
            part = 100 * math.exp(x) / (1 + 100 * math.exp(x))
            off = abs(y - math.log(101 / (1 + 100 * math.exp(x)))) / (
                1 / up**2 + (part / across)**2)**0.5
            expect(off < 0.25, x, y, off)


def labels_at_the_ends_of_log_axes_are_there(room):
    for low, high, ends in (('1e4', '1e6', ('104', '106')),
                            ('1e-5', '1e-3', ('10−5', '10−3'))):
        room.good('portrait', *SLOPE, '--figure', 'a.pdf', '--figure-width',
                  'two_columns', '--set', f'window.v=[{low}, {high}]',
                  '--set', 'window.psi=[10, 100]', '--set',
                  'products=[nullclines]')
        found = [word[0] for word in words(room.path('a.pdf'))[0]]
        for end in (*ends, '100'):
            expect(end in ''.join(found), end, found)
        expect('10' in found, found)


def a_figure_has_what_was_asked_for(room):
    def text(*args):
        room.good('portrait', *SLOPE, '--figure', 'a.svg', '--set',
                  'title=Heading', *args)
        return room.read('a.svg')
    whole = text('--figure-legend', 'inside')
    expect('Heading' in whole and 'saddle' in whole, 'title and legend')
    expect('font-style="italic"' in whole, 'italics')
    bare = text('--figure-legend', 'none', '--set', 'figure.title=false')
    expect('Heading' not in bare and 'saddle' not in bare, 'no title, no legend')
    expect('DejaVu Serif' in text('--set', 'figure.font=DejaVu Serif'), 'font')


def wrong_paper_costs_one_line(room):
    for key, value, word in (('width', 'wide', 'one_column'),
                             ('width', '3', 'mm from 20'),
                             ('height', '-1', 'mm'), ('type', '2', 'pt'),
                             ('legend', 'above', 'below'),
                             ('colours', 'jet', 'viridis'),
                             ('font', "a'b", 'letters'), ('dpi', '0', 'inch'),
                             ('size', '3', 'figure.')):
        refused(room.run('portrait', *SLOPE, '--figure', 'a.svg', '--set',
                         f'figure.{key}={value}'), 2, 'figure.' + key, word)
    refused(room.run('portrait', *SLOPE, '--figure', 'a.svg', '--figure-width',
                     '20', '--figure-type', '72'), 2, '20 mm', '72 pt')
    expect(room.names() == [], room.names())


if __name__ == '__main__':
    run_cases([
        a_figure_is_as_large_as_it_was_asked_for,
        letters_are_as_large_as_they_were_asked_for,
        lines_are_a_quarter_of_a_dot_from_their_curves,
        a_nullcline_of_friction_is_as_smooth,
        labels_at_the_ends_of_log_axes_are_there,
        a_figure_has_what_was_asked_for,
        wrong_paper_costs_one_line,
        figures_of_the_project_fit_one_column,
    ])
