"""Reckons from a record of parallel loops what more cores would bring (docs/measured/scaling.md).

A record says of each loop when it began and ended and how long each of its pieces took, all on one
thread. What lies between two loops is serial. On P cores the pieces of a loop are given out in
their order, each to the core that is free first, as work stealing does but for details; the next
loop begins when the last piece has ended.
"""
import dataclasses
import heapq
import json
import re

CORES = (1, 2, 4, 8, 16, 32, 64)


@dataclasses.dataclass
class Section:
    """A loop, or what lies before it; times in seconds."""
    name: str
    tasks: list          # of a loop; empty: serial
    serial: float = 0.0

    @property
    def work(self):
        return sum(self.tasks) + self.serial


def list_schedule(tasks, cores):
    """Seconds until the last of `tasks` has ended, each begun in its turn by the first free core."""
    if cores == 1 or len(tasks) == 1:
        return sum(tasks)
    if len(tasks) <= cores:
        return max(tasks, default=0.0)
    free = list(tasks[:cores])
    heapq.heapify(free)
    for task in tasks[cores:]:
        heapq.heapreplace(free, free[0] + task)
    return max(free)


def seconds(section, cores, barrier=0.0):
    """On so many cores; `barrier` seconds to wake threads and to wait for them, on more than one."""
    if not section.tasks:
        return section.serial
    return list_schedule(section.tasks, cores) + (barrier if cores > 1 else 0.0)


def span(section):
    """On any number of cores, with threads that wake at once."""
    return max(section.tasks) if section.tasks else section.serial


@dataclasses.dataclass
class Row:
    """Of all sections of one name, mean of a pass."""
    name: str
    serial: bool
    loops: float = 0.0
    tasks: float = 0.0
    work: float = 0.0
    at: dict = dataclasses.field(default_factory=dict)  # cores -> seconds


class Reckoning:
    """Of some passes: seconds a pass by number of cores, altogether and by the sections' names."""

    def __init__(self, passes, cores=CORES, barrier=0.0):
        self.passes, self.cores = len(passes), cores
        self.at = dict.fromkeys(cores, 0.0)
        self.work = self.span = 0.0
        rows = {}
        for section in (s for sections in passes for s in sections):
            row = rows.setdefault((section.name, not section.tasks),
                                  Row(section.name, not section.tasks, at=dict.fromkeys(cores, 0.0)))
            row.loops += 1 / self.passes
            row.tasks += len(section.tasks) / self.passes
            row.work += section.work / self.passes
            self.work += section.work / self.passes
            self.span += span(section) / self.passes
            for p in cores:
                time = seconds(section, p, barrier) / self.passes
                row.at[p] += time
                self.at[p] += time
        self.rows = list(rows.values())

    def speed_up(self, cores):
        return self.work / self.at[cores]

    def limiting(self, cores):
        """Rows by what they lack to be perfectly parallel: most first."""
        return sorted(self.rows, key=lambda row: row.work / cores - row.at[cores])


def short_name(name):
    """The function that a loop is in, from the full name of its body's type."""
    name = name.replace('(anonymous namespace)::', '')
    name = re.sub(r'^\w+::(?:in_chunks|for_pixels|in_blocks)<', '', name)
    found = re.search(r'([\w~]+(?:::[\w~]+)*)(?:<[^()]*>)?\(', name)
    return re.sub(r'^(?:aips|lxs)::', '', found[1]) if found else name


def sections_of(loops, names):
    """Loops and what lies between them, in order, from the first loop on. What lies between is
    named by the loops around it."""
    sections = []
    last_end = last_name = None
    for number, begin, end, tasks in loops:
        name = names[number]
        if last_end is not None:
            sections.append(Section(f'{last_name} .. {name}', [], max(0, begin - last_end) * 1e-9))
        sections.append(Section(name, [t * 1e-9 for t in tasks] or [(end - begin) * 1e-9]))
        last_end, last_name = end, name
    return sections


def passes_of(record, mark, skip=1):
    """Sections of each pass: from one loop in the function `mark` to the next, without the first
    `skip` passes and what comes after the last such loop."""
    names = [short_name(name) for name in record['names']]
    sections = sections_of([loop for loop in record['loops'] if loop[3] or record['clock'] == 'wall'],
                           names)
    begins = [i for i, section in enumerate(sections) if section.name == mark]
    return [sections[a:b] for a, b in zip(begins[skip:], begins[skip + 1:])]


def read_record(path):
    with open(path) as file:
        return json.load(file)
