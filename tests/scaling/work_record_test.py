"""Protects the record of loops: which are in it, by which names, in how many pieces; and that loops work
the same whether they are recorded or not. Argument: the program recorded_loops."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'scripts'))
from work_span import short_name  # noqa: E402

# The loop within loops_within() is a part of that.
PIECES = {'numbered_items': 10, 'ranges': 4, 'many_items': 2041, 'loops_within': 3}
BESIDE = 'beside_each_other'


def record_of(program, mode, *arguments):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / 'record.json'
        subprocess.run([program, *arguments], check=True,
                       env=os.environ | {'AIPS_WORK_RECORD': f'{mode}:{file}', 'AIPS_WORK_MARK': 'ranges'})
        return json.loads(file.read_text())


def check_turns(program):
    """Four times the loops are three passes from mark to mark."""
    for mode, alone in (('even', [1, 0, 1]), ('odd', [0, 1, 0])):
        passes = record_of(program, mode, *'four')['passes']
        assert [single for single, *_ in passes] == alone, passes
        assert all(wall > 0 and used >= 0 for _, wall, used in passes), passes


def main():
    program = sys.argv[1]
    subprocess.run([program], check=True)
    for mode in ('tasks', 'walls'):
        record = record_of(program, mode)
        names = [short_name(record['names'][number]) for number, *_ in record['loops']]
        # Three loops in a pair, of which two in a pair within; in walls each pair is a loop.
        beside = [BESIDE] * (3 if mode == 'tasks' else 2)
        assert names == list(PIECES) + beside, names
        times = [time for _, begin, end, _ in record['loops'] for time in (begin, end)]
        assert times == sorted(times), times
        pieces = [len(tasks) for *_, tasks in record['loops']]
        expected = list(PIECES.values()) + [5] * 3 if mode == 'tasks' else [0] * 6
        assert pieces == expected, pieces
        pairs = [pair[:3] for pair in record['pairs']]
        assert pairs == ([[4, 5, 7], [7, 7, 7]] if mode == 'tasks' else []), pairs
        for pair in record['pairs']:
            assert pair[3:] == sorted(pair[3:]), pair
    check_turns(program)


if __name__ == '__main__':
    main()
