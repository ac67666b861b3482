#!/usr/bin/env python3
"""Writes the page of all commands and options from the manual pages that the tool prints.

    options.py TOOL > options.md
"""
import re
import subprocess
import sys

ESCAPES = {r'\-': '-', r'\(aq': "'", r'\(dq': '"', r'\&': '', r'\e': '\\', r'\(ga': '`', r'\(ti': '~', r'\(ha': '^'}
FONT = re.compile(r'\\f([BIR])')


def manual(tool, *command):
    return subprocess.run([tool, 'help', *command, '--man'], check=True, capture_output=True, text=True).stdout.splitlines()


def plain(text):
    return re.sub(r'\\\(..|\\.', lambda match: ESCAPES[match[0]], FONT.sub('', text))


def code(text):
    """As code in a Markdown table, whatever characters it has."""
    return '<code>' + plain(text).replace('&', '&amp;').replace('<', '&lt;').replace('|', '&#124;') + '</code>'


def prose(text):
    """As Markdown; names of options and quoted commands become code."""
    text = plain(text).replace('&', '&amp;').replace('<', '&lt;').replace('|', '&#124;')
    text = re.sub(r'([\\`*_\[\]])', r'\\\1', text)
    return re.sub(r"(?<![\w-])(--[a-z][\w-]*)", r'<code>\1</code>', text)


def sections(lines):
    """Name and lines of each .SH section."""
    found = {}
    for line in lines:
        if line.startswith('.SH '):
            name = line[4:].strip('"')
            found[name] = []
        elif found:
            found[name].append(line)
    return found


def entries(lines):
    """What stands after each .TP as pairs of term and text, and each .SS as None and its title."""
    found = []
    macro = None
    for line in lines:
        if line.startswith('.'):
            macro = line[:3]
            if macro == '.SS':
                found.append((None, line[4:].strip('"')))
        elif macro == '.TP':
            found.append((line, ''))
            macro = 'text'
        elif macro == 'text':
            found[-1] = (found[-1][0], f'{found[-1][1]} {line}'.strip())
    return found


def write(tool, command):
    page = sections(manual(tool, command))
    title = plain(' '.join(page['NAME'])).split(' - ', 1)[1]
    print(f'\n## gonio {command}\n\n{prose(title[0].upper() + title[1:])}.\n')
    print('```text\n' + ' '.join(plain(line) for line in page['SYNOPSIS']) + '\n```\n')
    paragraphs = ' '.join(line if line != '.PP' else '\n\n' for line in page['DESCRIPTION']).split('\n\n')
    for paragraph in paragraphs[1:]:  # the first is the title again
        print(prose(paragraph.strip()) + '\n')
    for term, text in entries(page.get('OPTIONS', [])):
        if term is None:
            print(f'\n**{prose(text)}**\n\n| option | meaning |\n|---|---|')
        else:
            print(f'| {code(term)} | {prose(text)} |')
    if examples := entries(page.get('EXAMPLES', [])):
        print('\n**Examples**\n\n| command | result |\n|---|---|')
        for term, text in examples:
            print(f'| {code(term)} | {prose(text)} |')


def main(tool):
    print('# Options of every command\n\nAs `gonio COMMAND --help` shows them and the manual pages have them. '
          'The [guides](cli/README.md) show the commands at work.')
    for term, _ in entries(sections(manual(tool))['COMMANDS']):
        if term is not None:
            write(tool, plain(term).removesuffix('(1)').removeprefix('gonio-'))


main(sys.argv[1])
