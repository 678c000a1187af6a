"""Which layers of a mesh, uv maps and colours, a material reads.

A file holds one of each; a second uv map lies in the place of the colours.
"""
import dataclasses

RENDERED = ''  # stands for the layer that is chosen for renders


@dataclasses.dataclass(frozen=True)
class Layers:
    """Names of layers that are read, of uv maps in their order."""
    uv: tuple = ()
    colors: frozenset = frozenset()


class Read:
    """Collects what a material reads while it is written."""

    def __init__(self):
        self.uv, self.colors = [], set()
        self.generated = False  # whether it depends on the mesh's box
        self.of_object = set()  # what of the object it depends on: names of ObjectInfo's values

    def place_of_uv(self, name):
        """Number of the place that a uv map has, or None where there is none left for it."""
        if name not in self.uv:
            if len(self.uv) == 2 or self.uv and self.colors:
                return None
            self.uv.append(name)
        return self.uv.index(name)

    def has_place_for_colors(self):
        return len(self.uv) < 2

    def taken(self):
        """The Layers so far, to begin anew."""
        found = Layers(tuple(self.uv), frozenset(self.colors))
        self.uv.clear()
        self.colors.clear()
        self.generated, self.of_object = False, set()
        return found


def chosen(read, rendered):
    """Of names that are read the one to write, and whether there are others."""
    names = {name or rendered for name in read} or {rendered}
    return rendered if rendered in names else min(names), len(names) > 1
