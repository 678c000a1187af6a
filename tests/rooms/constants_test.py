#!/usr/bin/env python3
"""Protects what is known of the engine's tuned constants: where each comes from, and who vouches.

A constant that was chosen by judgement or by measurement stands in its room's constants.h. Its
comment says what it is, and then

    Unit: what it counts.
    Balances: what against what.
    Chosen by: a page of docs; or "measurement", of the scenes that support it; or "reasoning: "
      and why, where it was never measured.
    Supported by: scenes; or "one scene only: SCENE"; or "no measurement".

This test holds the comments against that: all labels, no page that is not there, no constant that
nothing uses, none twice, and no other number of its own in a room than those of facts.txt, which
says why they are no such constants. docs/build-on/constants.md lists them in short.

    constants_test.py            checks the repository
    constants_test.py --planted  plants one fault of each kind in a copy; all must be found
    constants_test.py --write    brings the page's figures and tables up to date
"""
import dataclasses
import pathlib
import re

import planted_faults
from planted_faults import ROOT
from rooms_test import STOREYS

PAGE = 'docs/build-on/constants.md'
FACTS = 'tests/rooms/facts.txt'
BEGIN, END = '<!-- constants: begin -->', '<!-- constants: end -->'
LABELS = ('Unit', 'Balances', 'Chosen by', 'Supported by')
DECLARED = re.compile(r'((?:^///.*\n)*)^inline constexpr (.+?) (k\w+)(?: = |\{)((?:.|\n)*?)\}?;\n',
                      re.M)
PAGES = re.compile(r'\bdocs/[\w/-]+\.md\b')
# What the page says of a constant; the rest stands in its header.
FIRST_CLAUSE = re.compile(r'(?:[^.:;,(]|\.(?=\d)|,(?! (?:so|as|those|which|and|but|for)))*')
# A constexpr, and the names in it that are given a value of their own.
CONSTEXPR = re.compile(r'\bconstexpr\b([^;]*);')
GIVEN = re.compile(r'\b(k[A-Z]\w*)(?=\s*(=(?!=)|\{))([^,]*)')
# What follows from something else, or is no number.
FOLLOWS = re.compile(r'\bk[A-Z]\w*|std::numeric_limits|Limits::|std::numbers|quiet_NaN|"|\w\(\)')


@dataclasses.dataclass
class Constant:
    name: str
    value: str
    what: str
    labels: dict

    @property
    def support(self):
        """"scenes", "one" or "none"."""
        told = self.labels.get('Supported by', '')
        return ('one' if told.startswith('one scene only') else
                'none' if told.startswith('no measurement') else 'scenes')


def constants_of(path):
    for comment, _, name, value in DECLARED.findall(path.read_text()):
        text = ' '.join(line.removeprefix('///').strip() for line in comment.splitlines())
        parts = re.split(rf'(?:^|(?<= ))({"|".join(LABELS)}): ', text)
        labels = {label: told.strip().removesuffix('.')
                  for label, told in zip(parts[1::2], parts[2::2])}
        yield Constant(name, ' '.join(value.split()), parts[0].strip().removesuffix('.'), labels)


def rooms(root):
    """(storey/room, Room) of all, the lower storey first."""
    for storey in STOREYS:
        for name, room in storey.rooms(root).items():
            yield f'{storey.name}/{name}', room


def tables(root):
    """{storey/room: its constants}, of the rooms that have any."""
    return {place: list(constants_of(path)) for place, room in rooms(root)
            for path in room.files if path.name == 'constants.h'}


def facts(root):
    lines = (root / FACTS).read_text().splitlines()
    return {line.split(': ', 1)[0] for line in lines if line and not line.startswith('#')}


def numbers(root):
    """"storey/room kName" of each constexpr outside of constants.h that has a number of its own."""
    for place, room in rooms(root):
        for path in room.files:
            if path.name != 'constants.h':
                for told in CONSTEXPR.findall(path.read_text()):
                    for name, _, value in GIVEN.findall(told):
                        if re.search(r'\d', value) and not FOLLOWS.search(value):
                            yield f'{place} {name}'


def wrong_comments(root):
    for place, constants in tables(root).items():
        for c in constants:
            where = f'{place}: {c.name}'
            if not c.what:
                yield f'{where}: its comment does not say what it is'
            for label in LABELS:
                if not c.labels.get(label):
                    yield f'{where}: its comment has no "{label}: "'
            chosen = c.labels.get('Chosen by', '')
            if chosen and not chosen.startswith(('docs/', 'measurement', 'reasoning: ')):
                yield (f'{where}: Chosen by names neither a page of docs nor "measurement" nor '
                       '"reasoning: "')
            if chosen.startswith('reasoning: ') and len(chosen) < 15:
                yield f'{where}: no reasoning'
            if c.support == 'one' and not re.match(r'one scene only: \S', c.labels['Supported by']):
                yield f'{where}: "one scene only: " names no scene'
            for page in PAGES.findall(' '.join(c.labels.values())):
                if not (root / page).is_file():
                    yield f'{where}: names {page}, which does not exist'


def faults(root):
    yield from wrong_comments(root)
    known = {}
    everywhere = {path: path.read_text() for _, room in rooms(root) for path in room.files}
    words = {path: set(re.findall(r'\w+', text)) for path, text in everywhere.items()}
    for place, room in rooms(root):
        for path in room.files:
            if path.name != 'constants.h':
                continue
            found = [c.name for c in constants_of(path)]
            told = len(re.findall(r'\bconstexpr\b', everywhere[path]))
            if told != len(found):
                yield f'{place}: {told} times constexpr in constants.h, {len(found)} constants read'
            for name in found:
                if name in known:
                    yield f'{place}: {name} is in {known[name]} as well'
                known[name] = place
                if not any(name in used for other, used in words.items() if other != path):
                    yield f'{place}: {name}: nothing uses it'
    present, named = set(numbers(root)), facts(root)
    for name in sorted(present - named):
        yield f'{name}: neither in constants.h nor in {FACTS}'
    for name in sorted(named - present):
        yield f'{FACTS}: {name}: there is no such number'
    if page_text(root) != (root / PAGE).read_text():
        yield f'{PAGE}: not the present constants; tests/rooms/constants_test.py --write renews it'


def linked(text):
    """Pages as links from docs/build-on, and what Markdown would take for a table's edge."""
    def link(found):
        name = pathlib.PurePath(found[0]).stem
        name = re.sub(r'^\d{4}-\d{2}-\d{2}-', '', name).replace('-', ' ')
        return f'[{name}](../{found[0].removeprefix("docs/")})'
    return PAGES.sub(link, text.replace('|', r'\|'))


def table(root):
    found = tables(root)
    count = {kind: sum(c.support == kind for constants in found.values() for c in constants)
             for kind in ('scenes', 'one', 'none')}
    yield (f'There are {sum(count.values())} of them: measurements in two scenes or more support '
           f'{count["scenes"]}, in one scene only {count["one"]}, and none {count["none"]}.')
    for storey in reversed(STOREYS):
        for place in [p for p in found if p.startswith(storey.name + '/')]:
            yield f'\n## {place.replace("/", ": ", 1)}\n'
            yield '| constant | value | what | supported by |'
            yield '| --- | --- | --- | --- |'
            for c in found[place]:
                told = linked(c.labels.get('Supported by', '')).split(' (')[0].split(';')[0]
                yield f'| `{c.name}` | {c.value} | {linked(FIRST_CLAUSE.match(c.what)[0])} | {told} |'


def page_text(root):
    text = (root / PAGE).read_text()
    if BEGIN not in text or END not in text:
        return f'no {BEGIN} and {END}'
    return (text[:text.index(BEGIN)] + BEGIN + '\n\n' + '\n'.join(table(root)) + '\n\n' +
            text[text.index(END):])


def planted():
    """Each deed on a copy of the engine, with a word of the fault that must be told."""
    source = 'core-adapter/adapter/src'
    contribution, eye = f'{source}/contribution/constants.h', f'{source}/eye/constants.h'

    def change(path, pattern, new, count=1):
        def deed(root):
            text = (root / path).read_text()
            changed = re.sub(pattern, new, text, count=count)
            assert changed != text, (path, pattern)
            (root / path).write_text(changed)
        return deed

    last = r'\n\}  // namespace aips\n$'
    return {
        **{f'has no "{label}: "': change(contribution, f'{label}: ', '') for label in LABELS},
        'does not say what it is': change(contribution, r'/// (?!Unit)[^:]*?Unit: ', '/// Unit: '),
        'which does not exist': change(contribution, r'where-photons-are-split\.md', 'no-such-page.md'),
        'neither a page of docs nor': change(contribution, 'Chosen by: reasoning: ', 'Chosen by: '),
        'no reasoning': change(contribution, r'reasoning: [^.]*\.', 'reasoning: so.'),
        'names no scene': change(contribution, r'Supported by: [^.]*\.', 'Supported by: one scene only.'),
        'as well': change(eye, last, '\ninline constexpr double kMostPhotons = 4;\n\\g<0>'),
        'nothing uses it': change(contribution, 'constexpr float kMostPhotons', 'constexpr float kUnused'),
        'constants read': change(contribution, last, '\nconstexpr int kLoose = 1;\n\\g<0>'),
        'neither in constants.h nor in': change(f'{source}/eye/eye_pass.cpp', r'namespace \{\n',
                                                'namespace {\nconstexpr double kGuess = 0.3;\n'),
        'there is no such number': change(FACTS, 'kItemsPerJob', 'kOtherItems'),
        'not the present constants': change(contribution, r'kPhotonCost = [\d.]+',
                                             'kPhotonCost = 0.6'),
    }


if __name__ == '__main__':
    planted_faults.run(planted, faults, ['docs', FACTS], PAGE, page_text,
                       'every tuned constant says where it comes from')
