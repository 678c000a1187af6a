"""What the tests of rooms have in common: the command line, and faults planted in a copy."""
import pathlib
import shutil
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def missed(planted, faults, kept):
    """Faults of `planted` (by a word of what is said of them) that `faults` did not find, each in
    a copy of core-adapter and of what `kept` names."""
    for word, deed in planted.items():
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder)
            for path in ['core-adapter', *kept]:
                (copy / path).parent.mkdir(parents=True, exist_ok=True)
                if (ROOT / path).is_dir():
                    shutil.copytree(ROOT / path, copy / path,
                                    ignore=shutil.ignore_patterns('images'))
                else:
                    shutil.copy(ROOT / path, copy / path)
            deed(copy)
            if not any(word in fault for fault in faults(copy)):
                yield f'a planted fault was not found: "{word}"'


def run(planted, faults, kept, page, page_text, healthy):
    """`--write` renews `page`, `--planted` plants faults, nothing looks for faults."""
    if sys.argv[1:] == ['--write']:
        (ROOT / page).write_text(page_text(ROOT))
        return
    found = list(missed(planted(), faults, kept) if sys.argv[1:] == ['--planted']
                 else faults(ROOT))
    print('\n'.join(found) or healthy)
    sys.exit(1 if found else 0)
