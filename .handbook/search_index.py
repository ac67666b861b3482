#!/usr/bin/env python3
"""Writes the search index of the handbook: every section of its pages, and every public name of the library.

    search_index.py SITE TAGS
"""
import html.parser
import json
import os
import sys
import xml.etree.ElementTree as ElementTree

HEADINGS = ('h1', 'h2', 'h3')
UNSAID = ('script', 'style', 'nav')


class Sections(html.parser.HTMLParser):
    """The sections of a page: title, anchor and text."""

    def __init__(self):
        super().__init__()
        self.sections = []
        self.in_main = False
        self.heading = None
        self.unsaid = 0

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == 'main':
            self.in_main = True
        elif tag in UNSAID or tag == 'a' and attributes.get('class') == 'headerlink':
            self.unsaid += 1
            self.in_link = tag == 'a'
        elif self.in_main and tag in HEADINGS:
            self.sections.append({'title': '', 'anchor': attributes.get('id', ''), 'text': ''})
            self.heading = tag

    def handle_endtag(self, tag):
        if tag == 'main':
            self.in_main = False
        elif self.unsaid and (tag in UNSAID or tag == 'a'):
            self.unsaid -= 1
        elif tag == self.heading:
            self.heading = None

    def handle_data(self, data):
        if self.in_main and not self.unsaid and self.sections:
            self.sections[-1]['title' if self.heading else 'text'] += data


def main(site, tags):
    entries = []
    for folder, folders, files in os.walk(site):
        folders.sort()
        if os.path.relpath(folder, site).split(os.sep)[0] in ('api', 'files'):
            continue
        for name in sorted(files):
            if not name.endswith('.html') or name == '404.html':
                continue
            path = os.path.join(folder, name)
            parser = Sections()
            with open(path, encoding='utf-8') as file:
                parser.feed(file.read())
            url = os.path.relpath(path, site).replace(os.sep, '/')
            page = parser.sections[0]['title'].strip() if parser.sections else name
            for i, section in enumerate(parser.sections):
                entries.append({'page': page, 'title': ' '.join(section['title'].split()),
                                'url': url + (f'#{section["anchor"]}' if i and section['anchor'] else ''),
                                'text': ' '.join(section['text'].split())})
    seen = set()
    for compound in ElementTree.parse(tags).getroot().iter('compound'):
        if compound.get('kind') not in ('class', 'struct', 'namespace'):
            continue
        owner = compound.findtext('name')
        names = [(owner, compound.findtext('filename'))]
        for member in compound.iter('member'):
            file, anchor = member.findtext('anchorfile'), member.findtext('anchor')
            if file and anchor and member.get('kind') in ('function', 'enumeration', 'typedef', 'variable'):
                names.append((f'{owner}::{member.findtext("name")}', f'{file}#{anchor}'))
        for name, url in names:
            if name not in seen and not url.startswith('namespace') or '#' in url and name not in seen:
                seen.add(name)
                entries.append({'page': 'API reference', 'title': name, 'url': 'api/' + url, 'text': ''})
    with open(os.path.join(site, 'search-index.js'), 'w', encoding='utf-8') as file:
        file.write('const searchIndex = ' + json.dumps(entries, ensure_ascii=False, separators=(',', ':')) + ';\n')


main(*sys.argv[1:])
