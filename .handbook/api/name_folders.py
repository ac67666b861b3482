#!/usr/bin/env python3
"""Names Doxygen's pages of folders after the folders. Doxygen names them after a hash of the whole path, which is another
one in every checkout. Drops those of folders that no header is in.

    name_folders.py API
"""
import os
import re
import sys


def main(api):
    names = {}
    for page in sorted(os.listdir(api)):
        if page.startswith('dir_') and page.endswith('.html'):
            with open(os.path.join(api, page), encoding='utf-8') as file:
                folder = re.search(r'<title>(\S+) Directory Reference', file.read())[1]
            if folder.startswith('gonio'):
                names[page] = 'folder_' + folder.replace('/', '_') + '.html'
            else:
                os.remove(os.path.join(api, page))
    for page in sorted(os.listdir(api)):
        path = os.path.join(api, page)
        if not page.endswith('.html'):
            continue
        with open(path, encoding='utf-8') as file:
            text = file.read()
        with open(path, 'w', encoding='utf-8') as file:
            file.write(re.sub(r'dir_[0-9a-f]{32}\.html', lambda match: names.get(match[0], match[0]), text))
        if page in names:
            os.rename(path, os.path.join(api, names[page]))


main(*sys.argv[1:])
