#!/usr/bin/env python3
"""The files named, NAME=PATH each, as C: const char text_NAME[]."""
import sys

print('#include "texts.h"')
for argument in sys.argv[1:]:
    name, path = argument.split('=', 1)
    print(f'const char text_{name}[] =')
    with open(path, encoding='utf-8') as file:
        for line in file:
            quoted = line.replace('\\', '\\\\').replace('"', '\\"')
            print('"' + quoted.rstrip('\n') + '\\n"')
    print(';')
