#!/usr/bin/env python3
"""Prints a header with its comments in Doxygen's form; Doxygen's INPUT_FILTER.

The headers of gonio have plain comments. These rules say what each of them describes:

* The block at the head of a file: the file.
* A block directly above a declaration: that declaration, and those after it that have no comment of their own, up to
  the next blank line.
* A comment after a declaration, on its last line: that declaration. Comments below it in the same column continue it.
* Any other comment, and any inside a function: nothing; it is for readers of the source.
"""
import re
import sys

OPENS_SCOPE = re.compile(r'^(template\s*<.*>\s*)?(inline\s+)?(namespace|class|struct|union|enum)\b[^()=]*\{$')
ACCESS = re.compile(r'^(public|protected|private)\s*:$')


def split_comment(line):
    """The code of a line, and the comment after it or None."""
    quoted = False
    for i, character in enumerate(line):
        if character == '"' and line[i - 1:i] != '\\' and line[i - 1:i + 2] != "'\"'":
            quoted = not quoted
        elif not quoted and line.startswith('//', i):
            return line[:i].rstrip(), line[i + 2:].strip()
    return line.rstrip(), None


def depth(code):
    """How many brackets the code opens and does not close."""
    code = re.sub(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])\'', '', code)
    return sum(code.count(c) for c in '({[') - sum(code.count(c) for c in ')}]')


def documentation(comment, indent):
    """The comment for Doxygen, with nothing in it that Doxygen takes for a command or a tag. Code in backticks stays."""
    parts = re.split(r'(`[^`]*`)', '\n'.join(comment))
    entities = {'<': '&lt;', '>': '&gt;', '&': '&amp;', '*': '&lowast;'}
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r'[\\@<>#%&*$]', lambda m: entities.get(m[0], '\\' + m[0]), parts[i])
    return [f'{indent}/// {text}'.rstrip() for text in ''.join(parts).split('\n')]


class Header:
    def __init__(self, source):
        self.lines = source.split('\n')
        self.parsed = [split_comment(line) for line in self.lines]
        self.out = []
        self.position = 0

    def line(self):
        return self.lines[self.position].strip() if self.position < len(self.lines) else ''

    def comment_block(self):
        """The comment that starts at the position, which moves behind it."""
        first = self.position
        while self.line().startswith('//'):
            self.position += 1
        return [self.parsed[i][1] for i in range(first, self.position)]

    def convert(self):
        head = self.comment_block()
        self.out += ['/// \\file', *documentation(head, '')] if head else []
        self.scope(False)
        return '\n'.join(self.out) + '\n'

    def scope(self, in_enum):
        """Everything up to the brace that closes the scope."""
        description = []  # the comment of the next declaration without one of its own
        while self.position < len(self.lines):
            code, comment = self.parsed[self.position]
            text = code.strip()
            indent = code[:len(code) - len(text)]
            if comment is not None and not text:
                description = self.comment_block()
            elif not text or ACCESS.match(text):
                description = []
                self.out.append(code)
                self.position += 1
            elif text.startswith('#'):
                self.directive(description, text)
            elif text.startswith('}'):
                self.out.append(code)
                self.position += 1
                return
            else:
                description = self.declaration(description, in_enum, indent)

    def directive(self, description, text):
        if text.startswith('#define'):
            self.out += documentation(description, '') if description else []
        while True:
            self.out.append(self.parsed[self.position][0])
            self.position += 1
            if not self.out[-1].endswith('\\'):
                return

    def declaration(self, description, in_enum, indent):
        """One declaration with its comment. Returns the comment that also describes the next ones."""
        first = self.position
        statement = ''
        while self.position < len(self.lines):
            code, comment = self.parsed[self.position]
            statement = f'{statement} {code.strip()}'.strip()
            self.position += 1
            if OPENS_SCOPE.match(statement) and depth(statement) == 1:
                own = description or ([comment] if comment else [])
                self.out += documentation(own, indent) if own else []
                self.out += [self.parsed[i][0] for i in range(first, self.position)]
                self.scope('enum' in statement.split())
                return []
            ends = statement.endswith((';', '}')) or in_enum and (statement.endswith(',') or self.line()[:1] in ('}', '/'))
            if ends and depth(statement) == 0:
                break
        declared = range(first, self.position)
        own = description
        if comment:
            own = [comment]
            column = self.lines[self.position - 1].index('//', len(code))
            while self.line().startswith('//') and self.lines[self.position].index('//') == column:
                own.append(self.parsed[self.position][1])
                self.position += 1
        self.out += documentation(own, indent) if own else []
        self.out += [self.parsed[i][0] for i in declared]
        return description


if __name__ == '__main__':
    with open(sys.argv[1], encoding='utf-8') as file:
        sys.stdout.write(Header(file.read()).convert())
