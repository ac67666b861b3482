#!/usr/bin/env python3
"""Checks the page of the rig format against the schema.

    tests/handbook/check_rig_page.py PAGE SCHEMA

Each object of the schema has a section of its name with a table of exactly its keys, each key's default as the schema
states it, and the example on the page uses every key.
"""
import json
import re
import sys


def sections(text):
    """Of each heading: the rows of its tables, as key and default."""
    rows, heading = {}, None
    for line in text.split('\n'):
        if line.startswith('#'):
            heading = line.lstrip('#').strip()
        match = re.match(r'^\| `(\w+)` \|.*\| (.*)\|$', line)
        if match and heading:
            rows.setdefault(heading, {})[match[1]] = match[2].strip()
    return rows


def keys_of(value):
    """All keys of JSON, at any depth."""
    if isinstance(value, dict):
        return set(value) | {key for inner in value.values() for key in keys_of(inner)}
    return {key for inner in value for key in keys_of(inner)} if isinstance(value, list) else set()


def main(page, schema):
    with open(page, encoding='utf-8') as file:
        text = file.read()
    with open(schema, encoding='utf-8') as file:
        schema = json.load(file)
    objects = {'The rig': schema}
    for name, one in schema['$defs'].items():
        if 'properties' in one:
            objects[name] = one
    for name, one in schema['$defs']['surface']['properties'].items():
        if 'properties' in one:
            objects[name] = one

    faults = []
    rows = sections(text)
    for name, one in objects.items():
        told, known = rows.get(name, {}), one['properties']
        faults += [f'{name}: the page lacks the key {key}' for key in known if key not in told]
        faults += [f'{name}: the schema has no key {key}' for key in told if key not in known]
        for key in set(known) & set(told):
            default = re.search(r'Default: (.*)\.$', known[key].get('description', ''))
            if default and default[1] != told[key]:
                faults.append(f'{name}.{key}: the default is "{default[1]}", the page has "{told[key]}"')
            if (key in one.get('required', [])) != told[key].startswith('required'):
                # An intensity is required by the reader of shapes, not by the schema.
                if (name, key) != ('light', 'intensity'):
                    faults.append(f'{name}.{key}: required in one of page and schema')

    example = re.search(r'^```json studio\.json\n(.*?)^```$', text, re.M | re.S)
    used = keys_of(json.loads(re.sub(r'//.*', '', example[1])))
    for name, one in objects.items():
        faults += [f'the example lacks {name}.{key}' for key in one['properties'] if key not in used]
    print('\n'.join(faults), file=sys.stderr)
    return 1 if faults else 0


sys.exit(main(*sys.argv[1:]))
