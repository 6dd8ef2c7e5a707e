"""What the pages of docs/ say, and doing it.

A fenced block `console`, or lines indented by four blanks from one that begins
with `$`: commands behind `$ `, and below each what must be in what it prints
(`...` stands for anything, blanks for any blanks).  All commands of a page run
in one shell.  Each must succeed, unless `$ echo $?` follows.  Any other fenced
block whose first line is a comment with a name is the file of that name.
"""
import os
import re
import subprocess

from cli_room import READER, expect


class Block:
    """A fenced block, or a run of indented commands."""

    def __init__(self, line, language, text):
        self.line, self.language, self.text = line, language, text
        name = re.match(r'(?:#|//|/\*) ([\w.-]+\.\w+)\b', text)
        self.name = name[1] if name and language != 'console' else None

    def commands(self):
        """[line, command, lines it must print]"""
        found = []
        for number, text in enumerate(self.text.splitlines(), self.line + 1):
            if text.startswith('$ '):
                found.append((number, text[2:], []))
            elif text.strip():
                expect(found, f'line {number}: no command before {text!r}')
                found[-1][2].append(text.strip())
        return found


def indented(line, text):
    """The blocks of commands in text that is not fenced."""
    for found in re.finditer(r'(?:^ {4,}\$ .*\n(?:^ {4,}\S.*\n)*)+', text,
                             re.M):
        yield Block(line + text.count('\n', 0, found.start()), 'console',
                    re.sub(r'^ +', '', found[0], flags=re.M))


def blocks(path):
    with open(path, encoding='utf-8') as file:
        page = file.read()
    fence, end = re.compile(r'^```(\w*)\n(.*?)^```$', re.M | re.S), 0
    for found in fence.finditer(page):
        yield from indented(1 + page.count('\n', 0, end),
                            page[end:found.start()])
        yield Block(1 + page.count('\n', 0, found.start()), found[1], found[2])
        end = found.end()
    yield from indented(1 + page.count('\n', 0, end), page[end:])


def is_in(expected, printed):
    """Whether a line is part of what was printed, from word to word."""
    parts = []
    for text in expected.split('...'):
        words = r'\s+'.join(map(re.escape, text.split()))
        parts.append(r'\s*' * text.startswith(' ') + words
                     + r'\s*' * text.endswith(' '))
    end = '' if expected.endswith('...') else r'(?![\w.])'
    return re.search(r'(^|[^\w.])' + '.*?'.join(parts) + end, printed, re.M)


class Reader:
    """Does what a page says, block by block, in a room."""

    def __init__(self, room, path):
        self.room, self.page = room, os.path.basename(path)
        self.did = 0
        room.fake('python3', f'exec {READER} "$@"')
        os.makedirs(room.path('.out'), exist_ok=True)
        if not os.path.exists(room.path('run')):
            os.symlink(os.path.join(room.bin, 'slipway'), room.path('run'))

    def write(self, block):
        self.room.write(self.folder(block.name), block.text)

    def folder(self, name):
        """Where the shell is now."""
        return os.path.join(self.here(), name)

    def here(self):
        try:
            return self.room.read('.out/here').strip()
        except FileNotFoundError:
            return self.room.folder

    def run(self, block):
        """All commands of a block in one shell, that goes on where the one
        before ended."""
        commands = block.commands()
        script = ['cd "$(cat .out/here 2>/dev/null || pwd)"',
                  'test -e "$OUT/env" && . "$OUT/env"']
        for i, (_, command, _) in enumerate(commands):
            if command != 'echo $?':
                script.append(f'{{ {command}\n}} >"$OUT/{i}" 2>&1 </dev/null; '
                              f'echo $? >"$OUT/{i}.code"')
        script += ['pwd >"$OUT/here"', 'export -p >"$OUT/env"']
        out = self.room.path('.out')
        done = self.room.shell(f'OUT={out}\nexport MPLBACKEND=Agg\n'
                               + '\n'.join(script))
        expect((done.returncode, done.stderr) == (0, ''), done)
        for i, (line, command, lines) in enumerate(commands):
            self.check(commands, i, line, command, lines)

    def check(self, commands, i, line, command, lines):
        asked = i + 1 < len(commands) and commands[i + 1][1] == 'echo $?'
        if command == 'echo $?':
            said = self.room.read(f'.out/{i - 1}.code')
        else:
            said = self.room.read(f'.out/{i}')
            code = self.room.read(f'.out/{i}.code').strip()
            expect(asked or code == '0', f'{self.page}:{line}: {command}: exit '
                   f'{code}\n{said}')
        for wanted in lines:
            expect(is_in(wanted, said), f'{self.page}:{line}: {command}: '
                   f'{wanted!r} is not in\n{said}')
        self.did += 1


def text_of(path):
    with open(path, encoding='utf-8') as file:
        return file.read()


def run_snippets(room, path):
    done = subprocess.run(
        [READER, room.script('run_snippets.py'), path], text=True,
        cwd=room.folder, env=room.environment(), capture_output=True,
        timeout=300, check=False)
    expect(done.returncode == 0, done.stdout, done.stderr)
    return int(done.stdout.split()[-2])


def do_page(room, path):
    for folder in ('scenes', 'tests'):
        room.bring(folder)
    room.make('outputs')
    reader, snippets = Reader(room, path), 0
    for block in blocks(path):
        if block.name:
            reader.write(block)
        elif block.language == 'console':
            reader.run(block)
        elif block.language == 'python':
            snippets += 1
        else:
            expect(block.language == 'text', path, block.line, 'is not tried')
    expect(not snippets or run_snippets(room, path) == snippets, snippets)
    expect(reader.did + snippets or not re.search(r'^ *\$ ', text_of(path), re.M),
           path, 'nothing was done')
