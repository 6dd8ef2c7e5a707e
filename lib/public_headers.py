#!/usr/bin/env python3
"""Prints the path of each header given and of all that they include.

usage: public_headers.py SOURCE_ROOT HEADER...
"""
import os
import re
import sys

ROOMS = ['lib', 'manifold', 'portrait']


def where(root):
    """Name -> path; names are unlike each other, since includes are flat."""
    return {name: os.path.join(folder, name) for room in ROOMS
            for folder, _, names in os.walk(os.path.join(root, room))
            for name in names if name.endswith('.h')}


def closure(paths, names):
    found = []
    for name in names:
        if name in found:
            continue
        found.append(name)
        with open(paths[name], encoding='utf-8') as file:
            names += re.findall(r'^#\s*include "(.*)"', file.read(), re.M)
    return sorted(found)


if __name__ == '__main__':
    known = where(sys.argv[1])
    for header in closure(known, sys.argv[2:]):
        print(known[header])
