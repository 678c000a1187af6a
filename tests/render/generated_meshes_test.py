"""Protects scenes/meshes: they are what scenes/generate makes, and glass in them is closed."""

import collections
import importlib.util
import pathlib
import sys
import unittest

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"


def load_generator():
    """scenes/generate/__main__.py as a module, without running it."""
    folder = SCENES / "generate"
    sys.path.insert(0, str(folder))
    spec = importlib.util.spec_from_file_location("generator", folder / "__main__.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


generator = load_generator()

SOLIDS = ("goblet.ply", "vase.ply", "ring.ply", "gem-brilliant.ply", "gem-step-cut.ply",
          "ring-claws.ply", "basin.ply", "lamp-cover.ply", "tap-spout.ply", "car-tyre.ply",
          "car-rim.ply", "car-lens.ply", "car-bumper.ply", "car-steering-wheel.ply") + tuple(
    f"chess-{piece}.ply" for piece in ("pawn", "rook", "knight", "bishop", "queen", "king"))


def read_ply(text):
    """Points and faces; points at the same place become one."""
    lines = text.splitlines()
    sizes = [int(line.split()[-1]) for line in lines if line.startswith("element")]
    body = lines[lines.index("end_header") + 1:]
    points = [tuple(map(float, line.split()[:3])) for line in body[:sizes[0]]]
    faces = [[points[int(k)] for k in line.split()[1:]] for line in body[sizes[0]:]]
    assert len(faces) == sizes[1]
    return points, faces


def triangles(faces):
    for face in faces:
        for k in range(1, len(face) - 1):
            yield face[0], face[k], face[k + 1]


def signed_volume(faces):
    return sum(
        (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
         + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
        for a, b, c in triangles(faces))


def open_edges(faces):
    """Directed edges that no face takes the other way round."""
    count = collections.Counter()
    for face in faces:
        for p, q in zip(face, face[1:] + face[:1]):
            if p != q:
                count[p, q] += 1
                count[q, p] -= 1
    return [edge for edge, balance in count.items() if balance != 0]


class GeneratedMeshes(unittest.TestCase):
    def test_folder_holds_what_the_generator_makes(self):
        files = generator.all_files(generator.SEED)
        self.assertEqual(list(generator.differences(files, SCENES / "meshes")), [])

    def test_seed_decides_water_and_lamps_alone(self):
        first, second = generator.all_files(1), generator.all_files(2)
        changed = {name for name in first if first[name] != second[name]}
        self.assertEqual(changed, {"water.ply", "hall-lamps.lxs"})

    def test_a_changed_file_is_noticed(self):
        files = generator.all_files(generator.SEED)
        files["ring.ply"] += "\n"
        del files["vase.ply"]
        self.assertEqual(list(generator.differences(files, SCENES / "meshes")),
                         ["ring.ply differs from what the generator makes",
                          "vase.ply is made by nothing"])

    def test_solids_are_closed_and_face_outwards(self):
        for name in SOLIDS:
            with self.subTest(name):
                _, faces = read_ply((SCENES / "meshes" / name).read_text(encoding="ascii"))
                self.assertEqual(open_edges(faces), [])
                self.assertGreater(signed_volume(faces), 0)

    def test_tumbler_is_closed_by_the_wall_that_water_wets(self):
        faces = [face for name in ("tumbler", "tumbler-wet") for face in
                 read_ply((SCENES / f"meshes/{name}.ply").read_text(encoding="ascii"))[1]]
        self.assertEqual(open_edges(faces), [])
        self.assertGreater(signed_volume(faces), 0)

    def test_files_are_small(self):
        for path in (SCENES / "meshes").iterdir():
            self.assertLess(path.stat().st_size, 100_000, path.name)


if __name__ == "__main__":
    unittest.main()
