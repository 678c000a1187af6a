"""Which layers of a mesh, uv maps and colours, a material reads; a file holds one of each."""
import dataclasses

RENDERED = ''  # stands for the layer that is chosen for renders


@dataclasses.dataclass(frozen=True)
class Layers:
    """Names of layers that are read."""
    uv: frozenset = frozenset()
    colors: frozenset = frozenset()


class Read:
    """Collects what a material reads while it is written."""

    def __init__(self):
        self.uv, self.colors = set(), set()
        self.generated = False  # whether it depends on the mesh's box
        self.of_object = set()  # what of the object it depends on: names of ObjectInfo's values

    def taken(self):
        """The Layers so far, to begin anew."""
        found = Layers(frozenset(self.uv), frozenset(self.colors))
        self.uv.clear()
        self.colors.clear()
        self.generated, self.of_object = False, set()
        return found


def chosen(read, rendered):
    """Of names that are read the one to write, and whether there are others."""
    names = {name or rendered for name in read} or {rendered}
    return rendered if rendered in names else min(names), len(names) > 1
