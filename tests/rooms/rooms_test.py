#!/usr/bin/env python3
"""Protects the plan of the engine: which room of core and adapter includes which.

A room is a folder with a README.md that says what it is for, which of its headers other rooms may
include (Open) and which rooms its own files include (Uses). This test holds the code against that:
no include that is not named, none named that is not there, no circle. docs/build-on/rooms.md shows
the same table.

    rooms_test.py            checks the repository
    rooms_test.py --planted  plants one fault of each kind in a copy; all must be found
    rooms_test.py --write    brings the page's tables and pictures up to date
"""
import dataclasses
import pathlib
import re

import planted_faults
from planted_faults import ROOT

PAGE = 'docs/build-on/rooms.md'
BEGIN, END = '<!-- rooms: begin -->', '<!-- rooms: end -->'
INCLUDE = re.compile(r'^#include "([\w/]+\.h)"', re.M)
CORE = 'core-adapter/core/include/aips/core'


@dataclasses.dataclass
class Storey:
    """Rooms of one part: where their READMEs are, where else files are, how others include them."""
    name: str
    folders: list  # the first has the READMEs
    prefix: str    # of includes in its headers, as in "aips/core/"
    beyond: tuple  # other includes in quotes begin with one of these

    def rooms(self, root):
        found = {}
        for readme in sorted((root / self.folders[0]).rglob('README.md')):
            name = str(readme.parent.relative_to(root / self.folders[0]))
            found[name] = Room.read(name, readme)
        for folder in self.folders:
            for path in sorted((root / folder).rglob('*')):
                if path.suffix in ('.h', '.cpp'):
                    name = str(path.parent.relative_to(root / folder))
                    found.setdefault(name, Room(name)).files.append(path)
        return found


@dataclasses.dataclass
class Room:
    name: str
    purpose: str = ''
    open: tuple = ()
    uses: tuple = ()
    files: list = dataclasses.field(default_factory=list)

    @staticmethod
    def read(name, readme):
        lines = [line for line in readme.read_text().splitlines() if line]
        fields = dict(line.split(': ', 1) for line in lines if line.startswith(('Open: ', 'Uses: ')))
        words = {key: tuple(w for w in value.split() if w != 'none')
                 for key, value in fields.items()}
        return Room(name, ' '.join(lines[1:-2]), words.get('Open', ()), words.get('Uses', ()))

    def opens(self, header):
        return self.open == ('all',) or header in self.open


STOREYS = [
    Storey('core', [CORE, 'core-adapter/core/src'], 'aips/core/', ()),
    Storey('adapter', ['core-adapter/adapter/src'], '', ('aips/core/', 'aips/adapter/')),
]


def wrong_includes(storey, rooms):
    """What includes say that the READMEs do not, and the other way round."""
    for room in rooms.values():
        used = set()
        for path in room.files:
            for include in INCLUDE.findall(path.read_text()):
                where = f'{storey.name}/{room.name}/{path.name}: includes "{include}"'
                if '/' not in include:
                    if not (path.parent / include).is_file():
                        yield f'{where}, which is not in its room'
                    continue
                if storey.beyond and include.startswith(storey.beyond):
                    continue
                name, header = include.removeprefix(storey.prefix).rsplit('/', 1)
                if name not in rooms:
                    yield f'{where}, which no room of {storey.name} may'
                elif name != room.name:
                    used.add(name)
                    if name not in room.uses:
                        yield f'{where}; its README does not name {name} under Uses'
                    if not rooms[name].opens(header):
                        yield f'{where}; the README of {name} does not open it'
        for name in set(room.uses) - used:
            yield f'{storey.name}/{room.name}: names {name} under Uses, and does not use it'


def levels(rooms):
    """Names by level, the lowest first; what is in a circle is left out."""
    placed, found = set(), []
    while True:
        level = [name for name, room in rooms.items()
                 if name not in placed and set(room.uses) <= placed]
        if not level:
            return found
        found.append(level)
        placed.update(level)


def faults(root):
    for storey in STOREYS:
        rooms = storey.rooms(root)
        for room in rooms.values():
            if not room.purpose:
                yield f'{storey.name}/{room.name}: no README.md that says what the room is for'
        yield from wrong_includes(storey, rooms)
        circle = set(rooms) - {name for level in levels(rooms) for name in level}
        if circle:
            yield f'{storey.name}: rooms that use each other in a circle: {sorted(circle)}'
    if page_text(root) != (root / PAGE).read_text():
        yield f'{PAGE}: not the present rooms; tests/rooms/rooms_test.py --write renews it'


def table(storey, rooms):
    yield f'Rooms of {storey.name}, each using only rooms below it:\n\n```'
    width = max(len(' | '.join(level)) for level in levels(rooms))
    for level in reversed(levels(rooms)):
        yield ' | '.join(level).center(width).rstrip()
    yield '```\n\n| room | what for | uses |\n| --- | --- | --- |'
    for level in reversed(levels(rooms)):
        for name in level:
            room = rooms[name]
            folder = f'../../{storey.folders[0]}/{name}/README.md'
            yield f'| [{name}]({folder}) | {room.purpose} | {", ".join(room.uses) or "-"} |'
    yield ''


def page_text(root):
    text = (root / PAGE).read_text()
    if BEGIN not in text or END not in text:
        return f'no {BEGIN} and {END}'
    lines = [line for storey in reversed(STOREYS) for line in table(storey, storey.rooms(root))]
    return (text[:text.index(BEGIN)] + BEGIN + '\n\n' + '\n'.join(lines) + '\n' +
            text[text.index(END):])


def planted():
    """Each deed on a copy of the engine, with a word of the fault that must be told."""
    source = 'core-adapter/adapter/src'

    def append(path, text):
        return lambda root: (root / path).write_text((root / path).read_text() + text)

    def replace(path, old, new):
        return lambda root: (root / path).write_text((root / path).read_text().replace(old, new))

    eye, paper, media = (f'{source}/{room}/README.md' for room in ('eye', 'guides/paper', 'media'))
    return {
        'does not name photons': append(f'{source}/eye/eye_pass.h',
                                        '#include "photons/photon_pass.h"\n'),
        'does not open it': append(f'{source}/photons/photon_pass.cpp',
                                   '#include "guides/adaptive/second_moments.h"\n'),
        'which no room of core may': append(f'{CORE}/trees/node.h',
                                            '#include "aips/adapter/scene.h"\n'),
        'which no room of adapter may': append(f'{source}/eye/eye_pass.h',
                                               '#include "lxs/sdk/parameters.h"\n'),
        'does not use it': replace(paper, 'Uses: ', 'Uses: photons '),
        'in a circle': replace(eye, 'Uses: ', 'Uses: photons '),
        'no README.md': lambda root: (root / media).unlink(),
        'not the present rooms': replace(media, 'Light in media', 'Light in fog'),
    }


if __name__ == '__main__':
    planted_faults.run(planted, faults, [PAGE], PAGE, page_text,
                       'every include is as the rooms say')
