"""What nodes of a material can tell of the object that they are on: constants of each instance."""

GOLDEN = 0xdeadbeef + (2 << 2) + 13  # of Jenkins' hash of two words
WORD = 0xffffffff


class ObjectInfo:
    """Of an instance of the dependency graph, whose object is not kept. `matrix` is where it is
    placed; `grids` are the Grids within it, or None. `names`, of the object and
    its data, are those by which changes of its shape are told; None where there are none."""

    def __init__(self, instance, matrix, grids=None):
        thing = instance.object
        number = instance.random_id & WORD if instance.is_instance else hashed(thing.name)
        self._thing = thing.original
        # Instances that nodes make may share their names with others.
        self.names = None if instance.is_instance else (thing.original.name_full,
                                                        thing.data.name_full if thing.data else '')
        self.grids = grids
        size = _size(matrix) if grids and grids.by_size else 1.0
        self._known = {'Matrix': tuple(map(tuple, matrix)), 'Grids': (grids,),
                       'Size of Density': (size,),
                       'Object Index': (float(thing.pass_index),), 'Random': (number / WORD,),
                       'Color': tuple(thing.color)[:3], 'Alpha': (thing.color[3],),
                       'Location': tuple(instance.matrix_world.translation)}

    def value(self, name):
        """An output of node Object Info, or after a dot an attribute: one number or three."""
        return self._known[name] if name in self._known else self._attribute(name[1:])

    def _attribute(self, name):
        """A property of the object or its data, of users or of Blender; black if there is none."""
        for owner in (self._thing, self._thing.data):
            value = owner.get(name) if owner is not None else None
            if value is None:
                value = getattr(owner, name, None)
            numbers = tuple(value)[:3] if hasattr(value, '__len__') else (value,)
            if numbers and all(isinstance(n, (int, float)) for n in numbers):
                return tuple(map(float, numbers))
        return (0.0, 0.0, 0.0)


def _size(matrix):
    """What Cycles divides a volume's density by: how long the diagonal of a cube becomes."""
    return sum(sum(row[:3]) ** 2 / 3 for row in matrix[:3]) ** 0.5 or 1.0


def values_of(info, names):
    """Values by which what depends on these names alone differs."""
    return tuple(info.value(name) for name in sorted(names))


def hashed(name):
    """Cycles' number of an object that is no instance."""
    key = 0
    for byte in name.encode():
        key = (key * 37 + byte) & WORD
    return _jenkins(key)


def _jenkins(key):
    """Bob Jenkins' final mix of lookup3, of a word and 0."""
    a, b, c = (GOLDEN + key) & WORD, GOLDEN & WORD, GOLDEN & WORD
    for turn in (14, 11, 25, 16, 4, 14, 24):
        # Each step mixes the next of the three words with the one before it.
        c = ((c ^ b) - _rotated(b, turn)) & WORD
        a, b, c = b, c, a
    return b


def _rotated(word, by):
    return ((word << by) | (word >> (32 - by))) & WORD
