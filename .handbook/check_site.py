#!/usr/bin/env python3
"""Checks the built handbook: links, anchors, and that nothing comes from elsewhere.

    check_site.py SITE
"""
import html.parser
import os
import re
import sys
import urllib.parse

LOADS = {'img': 'src', 'script': 'src', 'source': 'src', 'iframe': 'src', 'video': 'src', 'audio': 'src', 'link': 'href',
         'object': 'data', 'embed': 'src', 'form': 'action', 'base': 'href'}


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.names = set()
        self.links = []
        self.loads = []

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.names.update(attributes[key] for key in ('id', 'name') if attributes.get(key))
        if tag in ('a', 'area') and attributes.get('href'):
            self.links.append(attributes['href'])
        if tag in LOADS and attributes.get(LOADS[tag]):
            self.loads.append(attributes[LOADS[tag]])
        if 'srcset' in attributes:
            self.loads.append(attributes['srcset'].split()[0])


def main(site):
    site = os.path.realpath(site)
    pages, faults = {}, []
    for folder, _, files in os.walk(site):
        for name in files:
            path = os.path.join(folder, name)
            if name.endswith('.html'):
                pages[path] = Page()
                with open(path, encoding='utf-8') as file:
                    pages[path].feed(file.read())
            elif name.endswith(('.css', '.js', '.svg')):
                with open(path, encoding='utf-8') as file:
                    text = file.read()
                for url in re.findall(r'(?:url\(|@import\s+)["\']?([^"\')]+)', text) if name.endswith('.css') else []:
                    if re.match(r'(https?:)?//', url):
                        faults.append(f'{os.path.relpath(path, site)} loads {url}')
                if name.endswith('.svg') and re.search(r'(?:href|src)\s*=\s*["\']https?:', text):
                    faults.append(f'{os.path.relpath(path, site)} loads something from elsewhere')

    reached, todo = set(), [os.path.join(site, 'index.html')]
    for path, page in sorted(pages.items()):
        name = os.path.relpath(path, site)
        for url in page.loads:
            if re.match(r'(https?:)?//', url):
                faults.append(f'{name} loads {url}')
        for url in page.links + page.loads:
            if re.match(r'(https?:)?//|mailto:|javascript:|data:', url):
                continue
            target, _, anchor = urllib.parse.unquote(url).partition('#')
            to = os.path.normpath(os.path.join(os.path.dirname(path), target)) if target else path
            if not to.startswith(site):
                faults.append(f'{name}: {url} leads out of the handbook')
            elif not os.path.isfile(to):
                faults.append(f'{name}: {url} leads nowhere')
            elif url == '#nested-classes':
                pass  # Doxygen's summary of a class has this link even if all its nested classes are private
            elif anchor and to in pages and anchor not in pages[to].names:
                faults.append(f'{name}: {url}: the page has no such place')
    while todo:
        path = todo.pop()
        if path in reached:
            continue
        reached.add(path)
        for url in pages[path].links:
            target = urllib.parse.unquote(url).partition('#')[0]
            to = os.path.normpath(os.path.join(os.path.dirname(path), target))
            if to in pages and not re.match(r'[a-z]+:', url):
                todo.append(to)
    for path in sorted(set(pages) - reached):
        name = os.path.relpath(path, site)
        if name != '404.html' and not name.startswith('api/'):
            faults.append(f'{name}: no page leads there')
    for fault in faults:
        print(fault, file=sys.stderr)
    if faults:
        sys.exit(1)
    print(f'{len(pages)} pages, {sum(len(p.links) + len(p.loads) for p in pages.values())} links')


main(*sys.argv[1:])
