"""Reckons from a record of parallel loops what more cores would bring (docs/measured/scaling.md).

A record says of each loop when it began and ended and how long each of its pieces took, all on one
thread. What lies between two loops is serial. On P cores the pieces of a loop are given out in
their order, each to the core that is free first, as work stealing does but for details; the next
loop begins when the last piece has ended.

Some parts of a pass go on beside each other, each a chain of loops and serial sections. The record
has them one after the other. On P cores pieces of both are given to cores that are free, one chain's
before the other's; whichever of the two takes longer, counts: threads know of no such order.
"""
import dataclasses
import heapq
import json
import math
import re
import statistics

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
    if isinstance(section, Pair):
        return section.seconds(cores, barrier)
    if not section.tasks:
        return section.serial
    return list_schedule(section.tasks, cores) + (barrier if cores > 1 else 0.0)


def span(section):
    """On any number of cores, with threads that wake at once."""
    if isinstance(section, Pair):
        return section.span()
    return max(section.tasks) if section.tasks else section.serial


@dataclasses.dataclass
class Pair:
    """Two chains of sections that go on beside each other."""
    name: str
    chains: list         # two lists of sections

    @property
    def work(self):
        return sum(section.work for chain in self.chains for section in chain)

    @property
    def tasks(self):
        return [task for chain in self.chains for section in chain for task in section.tasks]

    def seconds(self, cores, barrier=0.0):
        if cores == 1:
            return self.work
        return max(chains_seconds(chains, cores, barrier)
                   for chains in (self.chains, self.chains[::-1]))

    def span(self):
        return max(sum(span(section) for section in chain) for chain in self.chains)


class Chain:
    """Sections of which each begins when the one before has ended, while they are scheduled."""

    def __init__(self, sections, barrier):
        self.sections, self.barrier = iter(sections), barrier
        self.ready, self.at, self.running, self.ends = [], 0.0, 0, 0.0
        self.next_section()

    def next_section(self):
        """The next one with pieces; `at` is when they may begin, which is in self.ready."""
        for section in self.sections:
            self.ready = list(section.tasks or [section.serial])[::-1]
            self.wait = self.barrier if section.tasks else 0.0
            return
        self.ready = []

    def ended(self, time):
        """A piece has."""
        self.running -= 1
        if not self.ready and self.running == 0:
            self.at = self.ends = time + self.wait
            self.next_section()


def chains_seconds(chains, cores, barrier=0.0):
    """Until both have ended, where a free core takes the next piece of the first chain that has one."""
    chains = [Chain(chain, barrier) for chain in chains]
    now, free, working = 0.0, cores, []  # working: (end, number, chain) of pieces
    number = 0
    while True:
        for chain in chains:
            while free and chain.ready and chain.at <= now:
                number += 1
                heapq.heappush(working, (now + chain.ready.pop(), number, chain))
                chain.running += 1
                free -= 1
        waiting = [chain.at for chain in chains if chain.ready and chain.at > now]
        if not working and not waiting:
            return max(now, *(chain.ends for chain in chains))
        if working and (not waiting or working[0][0] <= min(waiting)):
            now, _, chain = heapq.heappop(working)
            free += 1
            chain.ended(now)
        else:
            now = min(waiting)


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


class Reader:
    """Loops of a record and what lies between them, in order."""

    def __init__(self, record):
        self.loops = record['loops']
        self.names = [short_name(name) for name in record['names']]
        self.walls = record['clock'] == 'wall'
        self.pairs = record.get('pairs', [])

    def sections(self):
        """From the first loop on."""
        sections, i, time, last = [], 0, None, None
        for pair in self.pairs:
            sections, time, last = self.add_loops(sections, i, pair[0], time, last)
            both = self.pair(pair)
            if time is not None:
                sections.append(between(last, both.name, time, pair[3]))
            sections.append(both)
            i, time, last = pair[2], pair[5], both.name
        return self.add_loops(sections, i, len(self.loops), time, last)[0]

    def add_loops(self, sections, first, end, time, last):
        """Those from `first` to before `end`, behind what ended at `time` and is called `last`."""
        for number, begin, done, tasks in self.loops[first:end]:
            if not tasks and not self.walls:
                continue
            name = self.names[number]
            if time is not None:
                sections.append(between(last, name, time, begin))
            sections.append(Section(name, [t * 1e-9 for t in tasks] or [(done - begin) * 1e-9]))
            time, last = done, name
        return sections, time, last

    def pair(self, pair):
        first, second, end, *times = pair
        chains, names = [], []
        for loops, begin_time, end_time in (((first, second), times[0], times[1]),
                                            ((second, end), times[1], times[2])):
            sections, time, last = self.add_loops([], *loops, begin_time, 'beginning')
            sections.append(between(last, 'end', time, end_time))
            chains.append(sections)
            longest = max((s for s in sections if s.tasks), key=lambda s: s.work, default=None)
            names.append(longest.name if longest else 'no loop')
        return Pair(' beside '.join(names), chains)


def between(last, name, time, until):
    """What lies between two loops, and is named by them."""
    return Section(f'{last} .. {name}', [], max(0, until - time) * 1e-9)


def passes_of(record, mark, skip=1):
    """Sections of each pass: from one loop in the function `mark` to the next, without the first
    `skip` passes and what comes after the last such loop."""
    sections = Reader(record).sections()
    begins = [i for i, section in enumerate(sections) if section.name == mark]
    return [sections[a:b] for a, b in zip(begins[skip:], begins[skip + 1:])]


def least(records):
    """Sections of the same work in several records, each piece with the least of its times: what disturbed
    the machine in one of them is left out. A pass has the same pieces in each, as it does the same."""
    def kind(work):
        if isinstance(work, Section):
            return Section, len(work.tasks), work.name if work.tasks else ''
        return type(work), len(work) if isinstance(work, list) else 0

    first = records[0]
    if any(kind(other) != kind(first) for other in records):
        raise SystemExit('records of different work')
    if isinstance(first, list):
        return [least(same) for same in zip(*records)]
    if isinstance(first, Pair):
        return Pair(first.name, least([pair.chains for pair in records]))
    if isinstance(first, Section):
        return Section(first.name, least([section.tasks for section in records]),
                       min(section.serial for section in records))
    return min(records)


class Turns:
    """What two records say of passes that are on one thread and on all in turn, of which one has the even
    passes on one thread and the other the odd ones. Each pass on all threads is compared with the mean speed
    of the passes before and after it, which are on one thread and on different processors. Neither a drift of
    the machine's speed, nor a processor that is slower than another, nor that even passes do more than odd
    ones is taken for a gain."""

    def __init__(self, even, odd, skip=1):
        gains = [self.gains(record['passes'][skip:]) for record in (even, odd)]
        if not all(gains):
            raise SystemExit(f'fewer than {skip + 5} passes')
        self.speed_up = math.prod(statistics.mean(of_one) for of_one in gains) ** 0.5
        passes = [a_pass for record in (even, odd) for a_pass in record['passes'][skip:]]
        self.alone = statistics.mean(wall * 1e-9 for alone, wall, _ in passes if alone)
        #: processors that the passes on all threads kept busy
        self.busy = statistics.mean(used / wall for alone, wall, used in passes if not alone)

    @staticmethod
    def gains(passes):
        threes = zip(passes, passes[1:], passes[2:])
        return [statistics.harmonic_mean((before, after)) / wall
                for (_, before, _), (alone, wall, _), (_, after, _) in threes if not alone]


def read_record(path):
    with open(path) as file:
        return json.load(file)
