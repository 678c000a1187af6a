"""Makes the files in scenes/meshes: python3 scenes/generate [--check] [--seed N] [--to FOLDER]"""

import argparse
import pathlib
import sys

import bathroom
import car
import chess
import hall
import jewellery
import lantern
import pool
import sheets
import summerhouse
import tableware
import water

SEED = 1


def all_files(seed):
    """File name -> text of everything generated."""
    files = {}
    for made in (chess.files(), tableware.files(), lantern.files(), summerhouse.files(),
                 water.files(seed), pool.files(), hall.files(seed), jewellery.files(),
                 bathroom.files(), sheets.files(), car.files()):
        files.update(made)
    return files


def differences(files, folder):
    """What is missing, different or left over in `folder`, one line each."""
    present = {path.name for path in folder.iterdir()}
    for name in sorted(files.keys() | present):
        if name not in present:
            yield f"{name} is missing"
        elif name not in files:
            yield f"{name} is made by nothing"
        elif (folder / name).read_text(encoding="ascii") != files[name]:
            yield f"{name} differs from what the generator makes"


def main():
    parser = argparse.ArgumentParser(prog="python3 scenes/generate", description=__doc__)
    parser.add_argument("--check", action="store_true",
                        help="write nothing; exit with 1 if the files are not as generated")
    parser.add_argument("--seed", type=int, default=SEED,
                        help="seed of the water and of the hall's walls (default: %(default)s)")
    parser.add_argument("--to", type=pathlib.Path, metavar="FOLDER",
                        default=pathlib.Path(__file__).parent.parent / "meshes",
                        help="default: scenes/meshes")
    arguments = parser.parse_args()
    files = all_files(arguments.seed)
    if arguments.check:
        found = list(differences(files, arguments.to))
        print("\n".join(found), file=sys.stderr, end="\n" if found else "")
        return 1 if found else 0
    arguments.to.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        (arguments.to / name).write_text(text, encoding="ascii")
    return 0


if __name__ == "__main__":
    sys.exit(main())
