#!/usr/bin/env python3
"""slipway gallery: every figure and its page (TAP).

usage: cli_gallery.py PATH_TO_SLIPWAY SOURCE_ROOT
"""
import html.parser
import itertools
import os
import re
import shutil
import subprocess
import urllib.parse
import xml.etree.ElementTree

from cli_paper import COARSE, check_figures
from cli_room import expect, refused, run_cases, seen_on_a_terminal, shown

SCENE = '''# %s
title: %s
law: {preset: dieterich_gen}
slope: {alpha: 0.34}
products: [nullclines]
output: {figure: a.svg}
'''
VOID = {'meta', 'img', 'br'}


class Page(html.parser.HTMLParser):
    """Open tags, files that the page asks for, figures."""

    def __init__(self, text):
        super().__init__()
        self.stack, self.files, self.figures, self.ids = [], [], [], []
        self.targets, self.failed = [], 0
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        found = dict(attrs)
        if tag not in VOID:
            self.stack.append(tag)
        if tag == 'figure':
            self.figures.append({'pictures': 0, 'caption': '', 'heading': ''})
            self.ids.append(found['id'])
        if tag == 'img':
            expect(found['alt'], attrs)
            self.figures[-1]['pictures'] += 1
        self.failed += found.get('class') == 'failed'
        address = found.get('src') or found.get('href', '')
        if address.startswith('#'):
            self.targets.append(address[1:])
        elif tag == 'img' or not address.startswith('https://doi.org/'):
            self.files += [address] if address else []

    def handle_endtag(self, tag):
        expect(self.stack and self.stack[-1] == tag, self.stack, tag)
        self.stack.pop()

    def handle_data(self, data):
        for tag, key in (('figcaption', 'caption'), ('h2', 'heading')):
            if tag in self.stack:
                self.figures[-1][key] += data


def read_page(room, folder):
    """Whole, well nested, and all its files are there, beside it."""
    text = room.read(folder + '/index.html')
    expect(text.startswith('<!DOCTYPE html>') and '<style>' in text, text[:99])
    page = Page(text)
    expect(page.stack == [], page.stack)
    expect(page.targets == page.ids, page.targets, page.ids)
    names = room.names(folder)
    for address in page.files:
        expect(address.startswith('./'), address)
        name = urllib.parse.unquote(address[2:])
        expect(name in names, address, names)
    return page


def linked(page, ending):
    return [urllib.parse.unquote(name[2:]) for name in page.files
            if name.endswith(ending)]


def check_pictures(room, folder, page):
    for name in linked(page, '.svg'):
        xml.etree.ElementTree.parse(room.path(f'{folder}/{name}'))
    for ending, start in (('.png', b'\x89PNG\r\n'), ('.pdf', b'%PDF'),
                          ('.h5', b'\x89HDF\r\n')):
        for name in linked(page, ending):
            expect(room.bytes(f'{folder}/{name}').startswith(start), name)


def looks(script, data):
    """Of each entry of a legend: its line's width and dash, or its marks."""
    entry = dict(re.findall(r'# block (\d+): (?:curves|points) (.+)', data))
    lines, marks = {}, {}
    for block, kind, look in re.findall(
            r"data index (\d+) with (lines|points) ([^\\\n]*)", script):
        if block in entry and kind == 'points':
            marks.setdefault(entry[block], []).append(
                re.search(r'pt (\d+)', look)[1])
        elif block in entry and "'white'" not in look:
            dash = re.search(r'dt \((.*)\)', look)
            lines[entry[block]] = (float(re.search(r'lw ([\d.]+)', look)[1]),
                                   dash[1] if dash else '')
    return lines, marks


def check_grey(room, folder, page):
    """No two entries differ by their colours alone."""
    for name in linked(page, '.gp'):
        lines, marks = looks(room.read(f'{folder}/{name}'),
                             room.read(f'{folder}/{name[:-3]}.dat'))
        for (a, (thin, dash)), (b, (wide, other)) in itertools.combinations(
                sorted(lines.items(), key=lambda item: item[1]), 2):
            expect(dash != other or wide > 1.25 * thin, name, a, b, lines)
        for a, b in itertools.combinations(marks, 2):
            expect(marks[a] != marks[b], name, a, b)


def screenshot(room, folder):
    """In headless Chromium, where there is one: every picture is shown."""
    browser = shutil.which('chromium') or shutil.which('chromium-browser')
    if not browser:
        print('# no chromium: the page was only parsed, not drawn')
        return
    script = ('<script>onload = () => document.body.dataset.missing = '
              '[...document.images].filter(i => !i.naturalWidth).length'
              '</script></body>')
    room.write(folder + '/shown.html', room.read(folder + '/index.html')
               .replace('</body>', script))
    for args, words in ((['--dump-dom'], 'data-missing="0"'),
                        (['--screenshot=' + room.path('page.png'),
                          '--window-size=1200,3000'], '')):
        done = subprocess.run(
            [browser, '--headless', '--no-sandbox', '--disable-gpu', *args,
             'file://' + room.path(folder + '/shown.html')], text=True,
            capture_output=True, timeout=300, check=False)
        expect(done.returncode == 0 and words in done.stdout, done)
    expect(len(room.bytes('page.png')) > 50000, 'an empty page')
    os.remove(room.path(folder + '/shown.html'))
    os.remove(room.path('page.png'))


def every_figure_is_built_and_shown(room):
    room.bring('scenes')
    said = room.good('gallery', '-o', 'g', '--keep-script', '--figure-width',
                     'two_columns', *COARSE)
    page = read_page(room, 'g')
    scenes = {name[:-5] for name in room.names('scenes')
              if name.endswith('.yaml')
              and 'figure: ' in room.read('scenes/' + name)}
    expect(len(scenes) >= 20 and f'{len(scenes)} figures' in said, said)
    headed = {figure['heading'].split(':')[0] for figure in page.figures}
    expect(headed == scenes, headed ^ scenes)
    for figure in page.figures:
        expect(figure['pictures'] >= 1 and len(figure['caption']) > 60, figure)
    expect(page.failed == 0, page.failed)
    made = {name for name in room.names('g') if name.endswith('.svg')}
    expect(set(linked(page, '.svg')) == made, made ^ set(linked(page, '.svg')))
    for ending in ('.svg', '.png', '.pdf', '.gp', '.dat'):
        expect(len(linked(page, ending))
               == sum(figure['pictures'] for figure in page.figures), ending)
    for name in scenes:
        expect(room.read(f'g/{name}.yaml')
               == room.read(f'scenes/{name}.yaml'), name)
    check_pictures(room, 'g', page)
    check_grey(room, 'g', page)
    check_figures(room, 'g', 183, 31)
    screenshot(room, 'g')
    expect(room.names() == ['g', 'scenes'], room.names())


def settings_hold_for_every_scene(room):
    room.make('scenes')
    room.write('scenes/a.yaml', SCENE % ('caption', 'A'))
    room.write('scenes/b.yaml', SCENE % ('caption', 'B'))
    room.good('gallery', '-o', 'g', '--set', 'slope.alpha=0.33', '--quiet')
    for name in ('a', 'b'):
        expect('0.33 rad' in room.read(f'g/{name}.svg'), name)
    shown = seen_on_a_terminal(room, 'gallery', '-o', 'g').split('\r\033[K')
    expect(any(line.startswith('scenes [') and ' left' in line
               for line in shown) and shown[-1] == '', shown)
    expect(room.names('g') == sorted(
        name + ending for name in 'ab'
        for ending in ('.h5', '.pdf', '.png', '.svg', '.yaml'))
        + ['index.html'],
        room.names('g'))


def a_scene_that_fails_is_named_and_the_others_are_built(room):
    room.make('scenes')
    room.write('scenes/a.yaml', SCENE % ('caption', 'A'))
    room.write('scenes/b.yaml', 'law: {preset: none}\n')
    room.write('scenes/c.yaml', SCENE % ('caption', 'C'))
    room.write('scenes/d.yaml', (SCENE % ('caption', 'D')).replace(
        'products: [nullclines]\n', 'rabinowicz: {data: none.csv}\n'))
    room.write('scenes/e.yaml', 'law: {preset: ruina}\nslope: {alpha: 0.3}\n')
    done = room.run('gallery', '-o', 'g')
    lines = done.stderr.splitlines()
    expect(done.returncode == 2 and len(lines) == 4, done)
    expect('scenes/b.yaml:1:' in lines[0] and 'none.csv' in lines[1], done)
    expect([line.split()[2] for line in lines[2:]]
           == ['scenes/b.yaml', 'scenes/d.yaml'], done)
    expect('2 figures' in done.stdout, done)
    page = read_page(room, 'g')
    expect(page.failed == 2 and [figure['pictures'] for figure in page.figures]
           == [1, 0, 1, 0], page.figures)
    found = room.run('gallery', '-o', 'g', '--json')
    expect(found.returncode == 2 and '"built": false' in found.stdout, found)


def names_and_titles_are_only_text(room):
    room.make('scenes')
    name = "a b&c<d>'é%20\""
    room.write(f'scenes/{name}.yaml',
               SCENE % ('<script>x</script> & "y"', '\'<b>"T" & co\''))
    room.good('gallery', '-o', 'it\'s g')
    page = read_page(room, 'it\'s g')
    figure, = page.figures
    expect(figure['heading'] == name + ': <b>"T" & co', figure)
    expect('<script>x</script> & "y"' in figure['caption'], figure)
    check_pictures(room, 'it\'s g', page)


def data_are_found_beside_the_scenes(room):
    room.bring('scenes')
    room.make('other')
    for name in ('fig08.yaml', 'rabinowicz.csv'):
        os.rename(room.path('scenes/' + name), room.path('other/' + name))
    room.good('gallery', '--scenes', 'other', '-o', 'g')
    expect([figure['pictures'] for figure in read_page(room, 'g').figures]
           == [2], 'two panels')


def scenes_are_found_beside_the_program(room):
    for program, scenes in (('p/build/apps', 'p/scenes'),
                            ('q/bin', 'q/share/slipway/scenes')):
        room.make(program)
        room.make(scenes)
        room.write(scenes + '/a.yaml', SCENE % ('caption', 'A'))
        shutil.copy(room.slipway, room.path(program + '/slipway'))
        done = room.shell(program + '/slipway gallery')
        expect(done.returncode == 0 and '1 figure\n' in done.stdout, done)
        expect(read_page(room, 'outputs/gallery').figures[0]['pictures'] == 1,
               program)
        room.shell('rm -r outputs')


def the_readme_s_pictures_are_todays(room):
    """Words and colours; the README has the commands."""
    room.bring('scenes')
    for command, scene, name in (('portrait', 'fig07b', 'fig07b'),
                                 ('basin', 'fig05b_basin', 'basin')):
        room.good(command, f'scenes/{scene}.yaml', '--figure', name + '.svg')
        with open(f'{room.source}/outputs/gallery/{name}.svg',
                  encoding='utf-8') as file:
            stored = file.read()
        made = room.read(name + '.svg')
        for what in (shown, lambda svg: set(re.findall(r'rgb\([^)]*\)', svg))):
            expect(what(made) == what(stored), name, what(made), what(stored))


def wrong_words_cost_one_line(room):
    refused(room.run('gallery', '--scenes', 'none'), 4, 'none', '--scenes')
    room.make('empty')
    refused(room.run('gallery', '--scenes', 'empty'), 4, 'empty')
    refused(room.run('gallery', 'a.yaml'), 2, 'a.yaml')
    expect(room.names() == ['empty'], room.names())


run_cases([
    every_figure_is_built_and_shown,
    settings_hold_for_every_scene,
    a_scene_that_fails_is_named_and_the_others_are_built,
    names_and_titles_are_only_text,
    data_are_found_beside_the_scenes,
    scenes_are_found_beside_the_program,
    the_readme_s_pictures_are_todays,
    wrong_words_cost_one_line,
])
