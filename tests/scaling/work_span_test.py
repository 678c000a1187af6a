"""Protects the reckoning of scripts/scaling: cases whose speed-up is known, bounds that hold for any
tasks, and the reading of a record."""
import pathlib
import random
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'scripts'))
from work_span import (CORES, Reckoning, Section, list_schedule, passes_of,  # noqa: E402
                       short_name)


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


if __name__ == '__main__':
    unittest.main()
