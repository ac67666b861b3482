#!/usr/bin/env python3
"""Reads reports as a browser does and checks what holds for each of them.

    check_report.py GONIO PROFILES

A report of profiles in three formats, one of files that have markup in every text, in their names and in a rig, and one
with an interactive page.
"""
import base64
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile
from html.parser import HTMLParser

MARKUP = '</td><script>alert(1)</script><img src=x onerror="alert(1)">\'&amp;<!--'
VOID = {'meta', 'img'}
SVG = {'svg', 'title', 'rect', 'path', 'line', 'circle', 'text', 'clippath', 'g'}
HTML = {'html', 'head', 'meta', 'title', 'style', 'body', 'main', 'footer', 'section', 'div', 'h1', 'h2', 'h3', 'p', 'a',
        'table', 'caption', 'thead', 'tbody', 'tr', 'th', 'td', 'figure', 'figcaption', 'img', 'ul', 'li', 'strong',
        'code', 'span', 'pre', 'b', 'details', 'summary'}
INTERACTIVE = {'script', 'button'}
ATTRIBUTES = {'lang', 'charset', 'http-equiv', 'content', 'name', 'class', 'id', 'aria-labelledby', 'aria-label', 'role',
              'tabindex', 'href', 'scope', 'colspan', 'src', 'width', 'height', 'alt', 'type', 'data-name', 'hidden'}
CLOSED_POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"


class Report(HTMLParser):
    """The elements of a report; fails where they are not nested."""

    def __init__(self, text):
        super().__init__()
        self.open, self.elements, self.scripts, self.text = [], [], [], []
        self.feed(text)
        self.close()
        assert not self.open, f'left open: {self.open}'

    def handle_starttag(self, name, attributes):
        self.elements.append((name, dict(attributes), tuple(self.open)))
        assert len(dict(attributes)) == len(attributes), (name, attributes)
        if name == 'script':
            self.scripts.append([dict(attributes), ''])
        if name not in VOID:
            self.open.append(name)

    def handle_startendtag(self, name, attributes):
        assert 'svg' in self.open, name
        self.elements.append((name, dict(attributes), tuple(self.open)))

    def handle_endtag(self, name):
        assert self.open and self.open[-1] == name, f'</{name}> in {self.open}'
        self.open.pop()

    def handle_data(self, data):
        if self.open and self.open[-1] == 'script':
            self.scripts[-1][1] += data
        else:
            self.text.append(data)

    def handle_comment(self, data):
        raise AssertionError(f'a comment: {data}')

    def all(self, name):
        return [(attributes, parents) for element, attributes, parents in self.elements if element == name]


def check(text, interactive=False):
    assert text.startswith('<!DOCTYPE html>\n<html lang="en">')
    report = Report(text)
    ids = [attributes['id'] for _, attributes, _ in report.elements if 'id' in attributes]
    assert len(set(ids)) == len(ids), 'an identifier twice'
    for name, attributes, parents in report.elements:
        if 'svg' in parents or name == 'svg':
            assert name in SVG, name
            assert not any(key.startswith('on') or 'href' in key for key in attributes), attributes
            for value in attributes.values():
                for target in re.findall(r'url\((.*?)\)', value):
                    assert target[0] == '#' and target[1:] in ids, value
            continue
        assert name in HTML or (interactive and name in INTERACTIVE), name
        assert set(attributes) <= ATTRIBUTES, attributes
        if 'href' in attributes:
            assert attributes['href'][0] == '#' and attributes['href'][1:] in ids, attributes
        for key in ('aria-labelledby',):
            assert attributes.get(key, ids[0]) in ids, attributes
    for attributes, _ in report.all('img'):
        assert attributes['src'].startswith('data:image/png;base64,') and attributes['alt'], attributes
        assert base64.b64decode(attributes['src'].split(',')[1], validate=True).startswith(b'\x89PNG')
    for attributes, _ in report.all('th'):
        assert attributes['scope'] in ('row', 'col')
    assert len(report.all('caption')) == len(report.all('table'))
    levels = [int(name[1]) for name, _, _ in report.elements if name in ('h1', 'h2', 'h3')]
    assert levels[0] == 1 and levels.count(1) == 1
    assert all(after <= before + 1 for before, after in zip(levels, levels[1:])), levels
    policy = [a['content'] for a, _ in report.all('meta') if a.get('http-equiv') == 'Content-Security-Policy']
    assert len(policy) == 1
    if not interactive:
        assert policy[0] == CLOSED_POLICY and not report.scripts
    return report, policy[0]


def hash_source(script):
    return f"'sha256-{base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()}'"


def hostile(folder, profiles):
    """Files with markup wherever they have text."""
    ies = (profiles / 'downlight.ies').read_text()
    (folder / 'a<img src=x onerror=alert(1)>"\'&.ies').write_text(re.sub(r'(?m)^(\[\w+\]).*$', lambda m: m[1] + MARKUP, ies))
    ldt = (profiles / 'downlight.ldt').read_bytes().decode('latin-1').splitlines()
    for line in (0, 7, 8, 9, 10, 11, 27, 29, 30):
        ldt[line] = MARKUP
    (folder / 'b.ldt').write_text('\r\n'.join(ldt), newline='')
    xml = (profiles / 'downlight.xml').read_text()
    escaped = MARKUP.replace('&', '&amp;').replace('<', '&lt;')
    header = re.search(r'<Header>.*?</Header>', xml, re.S)[0]
    xml = xml.replace(header, re.sub(r'>[^<>\s][^<>]*<', lambda m: f'>{escaped}<', header))
    (folder / 'c.xml').write_text(xml)
    (folder / 'd.ies').write_text(re.sub(r'(?m)^TILT=.*', 'TILT=NONE\n1 <script>alert(1)</script> 1', ies))
    (folder / 'e.ies').write_bytes(b'IESNA:LM-63-2002\r\n[TEST] \xe9\x01\x00\xff \xe2\x80\xae\r\nTILT=<b>\r\n')
    (folder / 'rig.json').write_text(json.dumps({
        'schema': 'gonio.rig/1', 'stage': 'room',
        'lights': [{'name': MARKUP, 'shape': 'sphere:r=3cm', 'intensity': '800lm', 'position': [0, 0, 2]}]}))
    return [str(folder / name) for name in sorted(path.name for path in folder.iterdir()) if name != 'rig.json']


def main():
    gonio, profiles = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def write(*words, status=0):
            output = folder / 'report.html'
            run = subprocess.run([gonio, 'report', *map(str, words), '-q', '-o', output], capture_output=True, text=True)
            assert run.returncode == status, run
            return output.read_bytes().decode('utf-8')

        named = [profiles / each for each in ('downlight.ies', 'street.ldt', 'wall-washer.xml')]
        plain = write(*named, '--no-page')
        assert write(*named, '--no-page', '-j', 1) == plain
        report, _ = check(plain)
        assert len(report.all('svg')) == 3 * 5
        assert len(report.all('img')) in (0, 3) # none without the modules
        assert 'size: A4' in plain and 'size: letter' in write(*named, '--no-page', '--no-picture', '--paper', 'letter')

        (folder / 'hostile').mkdir()
        files = hostile(folder / 'hostile', profiles)
        rig = ('--rig', folder / 'hostile/rig.json')
        report, _ = check(write(*files, *rig, '--title', MARKUP, '--no-page', status=4))
        assert len(report.all('section')) == len(files) + 1
        assert ''.join(report.text).count(MARKUP) > 25

        script = "parent.postMessage({ type: 'gonio-ready' }, '*');"
        page = folder / 'page.html'
        page.write_bytes(f'<!DOCTYPE html><title>{MARKUP.replace("<", "&lt;")}</title>\r\n<script\r\ntitle=">">{script}\r\n</SCRIPT>'.encode())
        report, policy = check(write(*files, *rig, '--page', page, '--no-picture', status=4), interactive=True)
        assert hash_source(script + '\n') in policy
        code = [text for attributes, text in report.scripts if 'type' not in attributes]
        assert len(code) == 1 and hash_source(code[0]) in policy and "'unsafe-inline'" not in policy.split('script-src')[1]
        data = {attributes.get('id', attributes.get('data-name')): base64.b64decode(text, validate=True)
                for attributes, text in report.scripts if attributes.get('type') == 'text/plain'}
        assert "'unsafe-eval'" not in policy
        page_policy = "default-src 'none'; script-src 'unsafe-inline' 'unsafe-eval'"
        other = folder / 'other.html'
        other.write_text(f'<meta http-equiv="Content-Security-Policy" content="{page_policy}"><script>{script}</script>')
        _, lax = check(write(named[0], '--page', other, '--no-picture'), interactive=True)
        assert "'unsafe-eval'" in lax and "'unsafe-inline'" not in lax.split('script-src')[1]
        assert data['page-bytes'] == page.read_bytes()
        assert data['rig-text'] == rig[1].read_bytes()
        for file in files:
            assert data[pathlib.Path(file).name] == pathlib.Path(file).read_bytes(), file
    print('reports are whole, and texts stay texts')


main()
