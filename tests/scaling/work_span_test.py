"""Protects the reckoning of scripts/scaling: cases whose speed-up is known, bounds that hold for any
tasks, and the reading of a record."""
import pathlib
import random
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'scripts'))
from work_span import (CORES, Pair, Reader, Reckoning, Section, chains_seconds,  # noqa: E402
                       least, list_schedule, passes_of, seconds, short_name, span, Turns)


def loop(*tasks):
    return Section('loop', list(tasks))


def serial(seconds):
    return Section('serial', [], seconds)


class KnownSpeedUps(unittest.TestCase):
    def test_independent_equal_tasks_take_all_cores(self):
        reckoning = Reckoning([[loop(*[1.0] * 64)]])
        for cores in CORES:
            self.assertAlmostEqual(reckoning.speed_up(cores), cores)

    def test_no_more_cores_than_tasks(self):
        reckoning = Reckoning([[loop(*[1.0] * 8)]])
        self.assertAlmostEqual(reckoning.speed_up(8), 8)
        self.assertAlmostEqual(reckoning.speed_up(64), 8)

    def test_one_long_task_bounds_all(self):
        reckoning = Reckoning([[loop(10, *[1.0] * 90)]])
        self.assertAlmostEqual(reckoning.speed_up(64), 10)
        self.assertAlmostEqual(reckoning.span, 10)

    def test_a_long_task_that_begins_last_is_waited_for(self):
        self.assertAlmostEqual(list_schedule([1, 1, 1, 1, 10], 2), 12)
        self.assertAlmostEqual(list_schedule([10, 1, 1, 1, 1], 2), 10)

    def test_a_serial_part_as_amdahl_says(self):
        reckoning = Reckoning([[serial(0.1), loop(*[0.9 / 6400] * 6400)]])
        for cores in CORES:
            self.assertAlmostEqual(reckoning.speed_up(cores), 1 / (0.1 + 0.9 / cores), places=9)

    def test_loops_wait_for_each_other(self):
        reckoning = Reckoning([[loop(2, 1), loop(2, 1)]])
        self.assertAlmostEqual(reckoning.at[2], 4)

    def test_a_barrier_costs_each_loop_on_several_cores(self):
        reckoning = Reckoning([[loop(1, 1), serial(1), loop(1, 1)]], barrier=0.25)
        self.assertAlmostEqual(reckoning.at[1], 5)
        self.assertAlmostEqual(reckoning.at[2], 3.5)

    def test_a_pass_is_the_mean_of_several(self):
        reckoning = Reckoning([[loop(1, 1)], [loop(3, 3)]])
        self.assertAlmostEqual(reckoning.work, 4)
        self.assertAlmostEqual(reckoning.at[2], 2)
        self.assertEqual([row.tasks for row in reckoning.rows], [2])


class Pairs(unittest.TestCase):
    """Of chains that go on beside each other."""

    def test_one_core_does_one_after_the_other(self):
        self.assertAlmostEqual(seconds(Pair('', [[loop(1, 2), serial(3)], [serial(4)]]), 1), 10)

    def test_what_is_short_is_hidden_where_cores_are_free(self):
        pair = Pair('', [[loop(*[1.0] * 4)], [serial(0.25), loop(0.25, 0.25)]])
        self.assertAlmostEqual(seconds(pair, 8), 1)
        self.assertAlmostEqual(span(pair), 1)

    def test_pieces_of_both_share_the_cores(self):
        # Ten of each take ten rounds of two cores, whichever comes first.
        pair = Pair('', [[loop(*[1.0] * 10)], [loop(*[1.0] * 10)]])
        self.assertAlmostEqual(seconds(pair, 2), 10)
        self.assertAlmostEqual(seconds(pair, 20), 1)

    def test_a_chain_that_has_to_wait_counts(self):
        # A serial chain of 3 behind a loop that takes both cores for 2: 5; before it, 1 + 3 = 4.
        pair = Pair('', [[loop(2, 2)], [serial(1), serial(2)]])
        self.assertAlmostEqual(chains_seconds(pair.chains, 2), 5)
        self.assertAlmostEqual(chains_seconds(pair.chains[::-1], 2), 4)
        self.assertAlmostEqual(seconds(pair, 2), 5)

    def test_sections_of_a_chain_wait_for_each_other(self):
        self.assertAlmostEqual(chains_seconds([[loop(2, 1), loop(2, 1)], []], 2), 4)
        self.assertAlmostEqual(chains_seconds([[loop(2, 1), loop(2, 1)], []], 2, 0.25), 4.5)

    def test_a_chain_alone_is_as_its_sections(self):
        numbers = random.Random(9)
        for _ in range(50):
            chain = [loop(*[numbers.expovariate(1) for _ in range(numbers.randrange(1, 90))]),
                     serial(numbers.random()), loop(1, 2, 3)]
            for cores in CORES[1:]:
                alone = sum(seconds(section, cores) for section in chain)
                self.assertAlmostEqual(chains_seconds([[], chain], cores), alone)

    def test_bounds(self):
        numbers = random.Random(8)
        for _ in range(100):
            chains = [[loop(*[numbers.expovariate(1) for _ in range(numbers.randrange(1, 90))])
                       for _ in range(3)] + [serial(numbers.random())] for _ in range(2)]
            pair = Pair('', chains)
            for cores in CORES:
                time = seconds(pair, cores)
                least = max(pair.work / cores, span(pair))
                most = sum(seconds(section, cores) for chain in chains for section in chain)
                self.assertGreaterEqual(time, least * (1 - 1e-12))
                self.assertLessEqual(time, most * (1 + 1e-12))

    def test_counts_in_a_reckoning(self):
        reckoning = Reckoning([[serial(1), Pair('a beside b', [[serial(2)], [loop(1, 1)]])]])
        self.assertAlmostEqual(reckoning.at[1], 5)
        self.assertAlmostEqual(reckoning.at[4], 3)
        self.assertAlmostEqual(reckoning.work, 5)
        self.assertEqual([row.serial for row in reckoning.rows], [True, False])


class Bounds(unittest.TestCase):
    def test_of_graham(self):
        numbers = random.Random(7)
        for _ in range(200):
            tasks = [numbers.expovariate(1) for _ in range(numbers.randrange(1, 300))]
            for cores in CORES:
                time = list_schedule(tasks, cores)
                least = max(sum(tasks) / cores, max(tasks))
                most = sum(tasks) / cores + (1 - 1 / cores) * max(tasks)
                self.assertGreaterEqual(time, least * (1 - 1e-12))
                self.assertLessEqual(time, most * (1 + 1e-12))


class Records(unittest.TestCase):
    RECORD = {'clock': 'processor',
              'names': ['aips::eye(int)::{lambda(unsigned int)#1}', 'lxs::Film::add()::{lambda()#1}'],
              'loops': [[0, 0, 1000, [400, 500]], [1, 3000, 4000, [1000]],
                        [0, 4000, 5000, [900]], [1, 5500, 6000, [500]],
                        [0, 6000, 7000, [800]], [1, 9000, 9500, [500]]]}

    def test_passes_go_from_mark_to_mark(self):
        passes = passes_of(self.RECORD, 'eye', skip=0)
        self.assertEqual([[s.name for s in sections] for sections in passes],
                         [['eye', 'eye .. Film::add', 'Film::add', 'Film::add .. eye']] * 2)
        self.assertAlmostEqual(sum(s.work for s in passes[0]), 3.9e-6)
        self.assertEqual(len(passes_of(self.RECORD, 'eye', skip=1)), 1)

    def test_pairs_have_what_lies_before_between_and_behind_their_loops(self):
        record = {'clock': 'processor', 'names': ['a()::{lambda()#1}', 'b()::{lambda()#1}'],
                  'loops': [[0, 0, 1000, [1000]], [1, 2500, 3000, [500]], [0, 3600, 3700, [100]],
                            [0, 9000, 9500, [500]]],
                  'pairs': [[1, 2, 3, 2000, 3200, 4000], [3, 3, 3, 5000, 6000, 8000]]}
        sections = Reader(record).sections()
        self.assertEqual([s.name for s in sections],
                         ['a', 'a .. b beside a', 'b beside a',
                          'b beside a .. no loop beside no loop', 'no loop beside no loop',
                          'no loop beside no loop .. a', 'a'])
        self.assertEqual([round(s.work * 1e9) for s in sections],
                         [1000, 1000, 2000, 1000, 3000, 1000, 500])
        chains = [[round(s.work * 1e9) for s in chain] for chain in sections[2].chains]
        self.assertEqual(chains, [[500, 500, 200], [400, 100, 300]])

    def test_names_are_those_of_functions(self):
        for full, short in {
            'aips::trace_eye_pass(aips::EyePassInput const&, float)::{lambda(unsigned int)#1}':
                'trace_eye_pass',
            'void aips::in_chunks<aips::positions_of(std::span<aips::A const, 1ul>)::{lambda(int)#1}>'
            '(unsigned long)::{lambda(unsigned int)#1}': 'positions_of',
            'aips::(anonymous namespace)::join<aips::V>(std::vector<aips::V>&)::{lambda(int)#1}':
                'join',
            'lxs::FilmAccumulator::add(lxs::PassSamples const&)::{lambda(auto:1 const&)#1}':
                'FilmAccumulator::add',
        }.items():
            self.assertEqual(short_name(full), short)


class SeveralRecords(unittest.TestCase):
    @staticmethod
    def record(*late):
        """Passes of 64 equal tasks and a pair, in which the pieces of these numbers took nine times as long."""
        times = [9 if number in late else 1 for number in range(100)]
        return [[loop(*times[:64]), serial(times[64]), Pair('', [[loop(*times[65:80])], [loop(*times[80:])]])]]

    def test_what_disturbs_one_of_them_is_left_out(self):
        undisturbed = Reckoning(self.record())
        together = Reckoning(least([self.record(3, 64, 90), self.record(4, 66), self.record(50, 99)]))
        self.assertLess(Reckoning(self.record(4)).speed_up(64), 0.7 * undisturbed.speed_up(64))
        for cores in CORES:
            self.assertAlmostEqual(together.at[cores], undisturbed.at[cores])

    def test_other_work_is_refused(self):
        renamed = self.record()
        renamed[0][0].name = 'another'
        for other in [[loop(1)]], renamed, [[*self.record()[0][:2], serial(1)]]:
            with self.assertRaises(SystemExit):
                least([self.record(), other])


class PassesInTurn(unittest.TestCase):
    @staticmethod
    def record(alone, seconds_of, slower=1):
        """Twelve passes, those whose number has the remainder `alone` on one thread and the others 1.8 times
        as fast, on threads of which 1.9 are busy. Of the two processors the second takes so many times as long."""
        passes, mean = [], (1 + 1 / slower) / 2
        for number in range(12):
            single = number % 2 == alone
            wall = seconds_of(number) * ((1, slower)[number // 2 % 2] if single else 1 / (1.8 * mean))
            passes.append([int(single), wall * 1e9, wall * (1 if single else 1.9) * 1e9])
        return {'passes': passes}

    def turns(self, seconds_of, slower=1):
        return Turns(*(self.record(alone, seconds_of, slower) for alone in (0, 1)))

    def test_equal_passes(self):
        turns = self.turns(lambda number: 3)
        self.assertAlmostEqual(turns.speed_up, 1.8)
        self.assertAlmostEqual(turns.alone, 3)
        self.assertAlmostEqual(turns.busy, 1.9)

    def test_even_passes_that_do_more_are_no_gain(self):
        self.assertAlmostEqual(self.turns(lambda number: 5 if number % 2 else 2).speed_up, 1.8)

    def test_a_slow_processor_is_neither_gain_nor_loss(self):
        self.assertAlmostEqual(self.turns(lambda number: 3, slower=1.5).speed_up, 1.8)

    def test_a_machine_that_gets_slower_is_no_loss(self):
        self.assertAlmostEqual(self.turns(lambda number: 3 + 0.05 * number).speed_up, 1.8, places=3)

    def test_too_few_passes_are_told(self):
        with self.assertRaises(SystemExit):
            Turns({'passes': [[1, 1, 1]]}, {'passes': [[0, 1, 1]]})


if __name__ == '__main__':
    unittest.main()
