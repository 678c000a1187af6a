#!/usr/bin/env python3
"""Protects docs/reference/errors: each message that the sources can end with or warn of is in a table
of one of its pages. Looks at what stands in quotes in throw ...(), fail...(), warning() and error() calls; a row
holds a message if it holds the longest text of the message that no value interrupts.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
CALL = re.compile(r'(?:\bthrow\s+[\w:]+\s*\(|\b(?:\w+_)?fail(?:_\w+)?\s*\(|[.>]warning\s*\(|'
                  r'\bunknown_parameter\s*\(|\bfallback\s*\(|\blog_?[.]error\s*\(|->error\s*\()')
LEAST = 8  # characters that tell a message; below are prefixes, names and nouns


def literals(text, begin):
    """Texts in quotes up to the bracket that closes the call; neighbours joined as C++ does."""
    depth, at, found, last_end = 1, begin, [], -1
    while depth > 0 and at < len(text):
        quoted = re.compile(r'"((?:[^"\\\n]|\\.)*)"').match(text, at)
        character = re.compile(r"'(?:[^'\\]|\\.)'").match(text, at)
        if quoted:
            value = re.sub(r'\\(.)', r'\1', quoted[1])
            if found and not text[last_end:at].strip():
                found[-1] += value
            else:
                found.append(value)
            at = last_end = quoted.end()
            continue
        if character:
            at = character.end()
            continue
        depth += {'(': 1, ')': -1}.get(text[at], 0)
        at += 1
    return found


def messages():
    for folder in ('host', 'plugin'):
        for path in sorted((ROOT / folder).rglob('*')):
            if path.suffix not in ('.cpp', '.h'):
                continue
            text = path.read_text()
            for call in CALL.finditer(text):
                parts = [part for literal in literals(text, call.end())
                         for part in re.split(r'\{[^}]*\}', literal)]
                longest = max(parts, key=len, default='').strip()
                if len(longest) >= LEAST:
                    line = text.count('\n', 0, call.start()) + 1
                    yield f'{path.relative_to(ROOT)}:{line}', longest


def main():
    rows = [line for page in sorted((ROOT / 'docs/reference/errors').glob('*.md'))
            if page.name != 'index.md'
            for line in page.read_text().splitlines() if line.startswith('| ')]
    missing, count = [], 0
    for where, message in messages():
        count += 1
        if not any(message in row for row in rows):
            missing.append(f'{where}: {message}')
    print(f'{count} messages, {len(missing)} without a row in docs/reference/errors')
    for line in missing:
        print('  ' + line)
    if count < 200:
        sys.exit('too few messages found: does this test still know how they are raised?')
    sys.exit(1 if missing else 0)


if __name__ == '__main__':
    main()
