#!/usr/bin/env python3
"""Gathers the pages of the handbook into one folder for MkDocs.

    gather.py ROOT TAGS PAGES

ROOT is the checkout, TAGS Doxygen's tag file of the API reference, PAGES the folder to fill. The site's own pages come
from .handbook/pages, all others are the Markdown files of the tree, which stay where they are. In both a link is
relative to the file that it stands in; here each becomes a link of the site:

* to another page, or to a folder with a README.md: to that page;
* to a picture: to a copy of it;
* to a public header: to its page in the API reference;
* to any other file: to a page that shows it, or to a copy of it if it is not text for people;
* to any other folder: to nothing, its text stays.

A block fenced with ```json room.json is the content of a file, and gets its name above it. A line "--8<-- PATH" stands for the file of that path from the root of the tree, and "--8<-- PATH :: TEXT" for the block
of code in that page that begins with the text: a program or a script that a test runs has one place.
"""
import os
import posixpath
import re
import shutil
import sys
import xml.etree.ElementTree as ElementTree

OWN = '.handbook/pages/'
PICTURES = ('.png', '.svg')
COPIED = ('.ipynb', '.ies', '.ldt', '.xml', '.csv')
LANGUAGES = {'.cpp': 'cpp', '.hpp': 'cpp', '.h': 'cpp', '.sh': 'bash', '.py': 'python', '.json': 'json', '.cmake': 'cmake'}
LINK = re.compile(r'(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^()\s]+)\)')
INCLUDE = re.compile(r'^--8<-- (\S+)(?: :: (.+))?$', re.M)
NAMED = re.compile(r'^```(\w+) ([\w.-]+)$', re.M)
BLOCK = re.compile(r'^```\w*\n(.*?)\n```$', re.M | re.S)
# A definition in CODES.md, which becomes a place to link to: **IES0204** title (error)
CODE = re.compile(r'^\*\*([A-Z]{3}\d{4})\*\* ', re.M)


def place(path):
    """Where a file of the tree is on the site. MkDocs leaves out names that begin with a dot."""
    if path.startswith(OWN):
        return path[len(OWN):]
    if path == 'README.md':
        return 'overview.md'
    return '/'.join(part.lstrip('.') for part in path.split('/'))


def pages_of(root):
    """The Markdown files of the tree, as paths from its root."""
    found = []
    for folder, folders, files in os.walk(root):
        folders[:] = sorted(f for f in folders if f not in ('.git', '.cache', 'node_modules') and not f.startswith('build'))
        found += [os.path.relpath(os.path.join(folder, f), root) for f in sorted(files) if f.endswith('.md')]
    return found


def api_pages(tags):
    """The page of the API reference for each header, by its path in the tree."""
    pages = {}
    for compound in ElementTree.parse(tags).getroot().iter('compound'):
        if compound.get('kind') == 'file':
            name = compound.findtext('filename')
            pages[f'lib/{compound.findtext("path")}{compound.findtext("name")}'] = \
                'api/' + name + ('' if name.endswith('.html') else '.html')
    return pages


class Gatherer:
    def __init__(self, root, tags, target):
        self.root, self.target = root, target
        self.pages = pages_of(root)
        self.api = api_pages(tags)
        self.files = set()  # other files that are linked to

    def write(self, path, text):
        path = os.path.join(self.target, path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, 'w', encoding='utf-8') as file:
            file.write(text)

    def copy(self, path, to):
        to = os.path.join(self.target, to)
        os.makedirs(os.path.dirname(to), exist_ok=True)
        shutil.copyfile(os.path.join(self.root, path), to)

    def link(self, source, target):
        """The link of the site for a link in `source`; None if it leads nowhere on the site."""
        if re.match(r'[a-z]+:', target):
            return target
        target, _, anchor = target.partition('#')
        anchor = '#' + anchor if anchor else ''
        if not target:
            return anchor
        path = posixpath.normpath(posixpath.join(posixpath.dirname(source), target))
        if path == 'api':
            raise SystemExit(f'{source}: link to the API reference by a header, not by {target}')
        if path in self.api:
            to = self.api[path]
        elif posixpath.join(path, 'README.md') in self.pages or path == '.':
            to = place(posixpath.normpath(posixpath.join(path, 'README.md')))
        elif path in self.pages:
            to = place(path)
        elif os.path.isdir(os.path.join(self.root, path)):
            return None
        elif not os.path.isfile(os.path.join(self.root, path)):
            raise SystemExit(f'{source}: there is no {path}, which it links to')
        elif path.endswith(PICTURES + COPIED):
            self.copy(path, place(path))
            to = place(path)
        else:
            self.files.add(path)
            to = f'files/{place(path)}.md'
        return posixpath.relpath(to, posixpath.dirname(place(source)) or '.') + anchor

    def included(self, match):
        with open(os.path.join(self.root, match[1]), encoding='utf-8') as file:
            text = file.read().rstrip('\n')
        if not match[2]:
            return text
        found = [block for block in BLOCK.findall(text) if block.startswith(match[2])]
        if len(found) != 1:
            raise SystemExit(f'{match[1]}: {len(found)} blocks begin with {match[2]}')
        return found[0]

    def converted(self, source, text):
        text = INCLUDE.sub(self.included, text)
        text = NAMED.sub(r'<p class="file"><code>\2</code></p>\n\n```\1', text)

        def replace(match):
            to = self.link(source, match[3])
            return match[2] if to is None else f'{match[1]}[{match[2]}]({to})'

        # Code stays as it is: what looks like a link in it is none.
        keep = []

        def put_away(match):
            keep.append(match[0])
            return f'\0{len(keep) - 1}\0'

        text = re.sub(r'^```.*?^```$|`[^`\n]+`', put_away, text, flags=re.M | re.S)
        text = LINK.sub(replace, text)
        return re.sub('\0(\\d+)\0', lambda m: keep[int(m[1])], text)

    def run(self):
        for page in self.pages:
            if page.startswith('.handbook/') and not page.startswith(OWN):
                continue
            with open(os.path.join(self.root, page), encoding='utf-8') as file:
                text = self.converted(page, file.read())
            if page.endswith('/CODES.md'):
                text = CODE.sub(r'<a id="\1"></a>**\1** ', text)
            self.write(place(page), text)
        for path in sorted(self.files):
            with open(os.path.join(self.root, path), encoding='utf-8') as file:
                text = file.read().rstrip('\n')
            language = LANGUAGES.get(os.path.splitext(path)[1], 'cmake' if path.endswith('CMakeLists.txt') else 'text')
            self.write(f'files/{place(path)}.md', f'# {path}\n\n````{language}\n{text}\n````\n')


Gatherer(*sys.argv[1:]).run()
