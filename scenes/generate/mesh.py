"""A polygon mesh and the two texts it is written as: PLY (smooth) and a scene statement (flat)."""

DECIMALS = 4


def number(value, decimals=DECIMALS):
    """Shortest text of a rounded value, so that the last bits of sin and cos never show."""
    text = f"{value:.{decimals}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def numbers(values, decimals=DECIMALS):
    return " ".join(number(value, decimals) for value in values)


class Mesh:
    """Vertices (x, y, z) and faces (three or four vertex indices, counter-clockwise outside)."""

    def __init__(self):
        self.vertices = []
        self.normals = []  # none, or one for each vertex
        self.faces = []

    def vertex(self, point, normal=None):
        self.vertices.append(point)
        if normal is not None:
            self.normals.append(normal)
        return len(self.vertices) - 1

    def face(self, *indices):
        self.faces.append(indices)

    def box(self, low, high, place=lambda point: point):
        """An axis-aligned box; `place` moves its corners."""
        corners = [
            self.vertex(place((x, y, z)))
            for z in (low[2], high[2])
            for y in (low[1], high[1])
            for x in (low[0], high[0])
        ]
        for side in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2),
                     (1, 3, 7, 5)):
            self.face(*(corners[k] for k in side))

    def ply(self):
        """Without normals of its own the renderer smooths the mesh across shared vertices."""
        if self.normals and len(self.normals) != len(self.vertices):
            raise ValueError("some vertices have a normal and some have none")
        lines = ["ply", "format ascii 1.0", f"element vertex {len(self.vertices)}"]
        lines += [f"property float {axis}" for axis in "xyz"]
        if self.normals:
            lines += [f"property float n{axis}" for axis in "xyz"]
        lines += [f"element face {len(self.faces)}",
                  "property list uchar int vertex_indices", "end_header"]
        if self.normals:
            lines += [numbers(p) + " " + numbers(n, 3)
                      for p, n in zip(self.vertices, self.normals)]
        else:
            lines += [numbers(point) for point in self.vertices]
        lines += [" ".join(map(str, (len(face), *face))) for face in self.faces]
        return "\n".join(lines) + "\n"

    def shape(self):
        """A trianglemesh statement, flat: each face keeps its own normal."""
        lines = ['Shape "trianglemesh"']
        for name, corners in (("triindices", 3), ("quadindices", 4)):
            faces = [face for face in self.faces if len(face) == corners]
            if faces:
                lines.append(f'  "integer {name}" [')
                lines += wrapped(" ".join(map(str, face)) for face in faces)
                lines.append("  ]")
        lines.append('  "point P" [')
        lines += wrapped(numbers(point) for point in self.vertices)
        lines.append("  ]")
        return "\n".join(lines) + "\n"


def wrapped(items, width=96):
    """Lines of items two spaces apart."""
    line = "   "
    for item in items:
        if len(line) + len(item) + 2 > width and line.strip():
            yield line
            line = "   "
        line += " " + item + " "
    if line.strip():
        yield line
