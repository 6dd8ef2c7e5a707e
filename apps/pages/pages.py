#!/usr/bin/env python3
"""Writes what a program's help says, each page into a file of its own: one
process of python for all, since most of a page's time is python's start.

usage: pages.py PROGRAM FOLDER NAME=WORDS...   the words behind `help`
"""
import subprocess
import sys

program, folder, *pages = sys.argv[1:]
for page in pages:
    name, words = page.split('=')
    with open(f'{folder}/{name}', 'wb') as file:
        subprocess.run([program, 'help', *words.split()], stdout=file,
                       check=True)
