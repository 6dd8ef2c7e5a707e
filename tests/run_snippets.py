#!/usr/bin/python3
"""run_snippets.py PAGE.md -- runs each ```python block of a page on its own.

A block whose first line is a comment with a file's name is that file, not a
snippet.  What a block saves must be a picture with something on it.
"""
import contextlib
import io
import os
import re
import sys
import traceback

import matplotlib
import matplotlib.pyplot as plt
import numpy as np

matplotlib.use('Agg')


def snippets(path):
    """(line, text)"""
    with open(path, encoding='utf-8') as file:
        page = file.read()
    for found in re.finditer(r'^```python\n(.*?)^```$', page, re.M | re.S):
        if not re.match(r'# \S+\.py\n', found[1]):
            yield page.count('\n', 0, found.start()) + 2, found[1]


def draws(axes):
    """Whether there is anything finite within the frame."""
    lines = [np.column_stack(line.get_data()) for line in axes.lines]
    seen = [np.isfinite(line.astype(float)).all(axis=1).sum() for line in lines]
    return any(n > 1 for n in seen) or bool(axes.collections or axes.images)


def is_blank(name):
    picture = plt.imread(name)[:, :, :3]
    middle = picture[picture.shape[0] // 5:-picture.shape[0] // 5,
                     picture.shape[1] // 5:-picture.shape[1] // 5]
    inked = (np.abs(middle - middle[0, 0]).max(axis=2) > 0.05).mean()
    return inked < 0.002


def run(text, line):
    """What is wrong, or nothing."""
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        exec(compile('\n' * (line - 1) + text, 'page', 'exec'), {})
    figures = [plt.figure(number) for number in plt.get_fignums()]
    saved = re.findall(r'savefig\("([^"]+)"', text)
    empty = [axes for figure in figures for axes in figure.axes
             if not draws(axes)]
    if bool(saved) != bool(figures) or empty:
        return f'{len(figures)} figures, {saved} saved, {len(empty)} axes empty'
    if any(not os.path.getsize(name) or is_blank(name) for name in saved):
        return f'{saved} is blank'
    return '' if saved or said.getvalue() else 'neither a figure nor a word'


def main():
    count, failed = 0, False
    for line, text in snippets(sys.argv[1]):
        plt.close('all')
        try:
            wrong = run(text, line)
        except Exception:  # told, and the next one runs
            wrong = traceback.format_exc()
        if wrong:
            print(f'line {line}: {wrong}')
        count, failed = count + 1, failed or bool(wrong)
    print(count, 'snippets')
    sys.exit(failed)


main()
