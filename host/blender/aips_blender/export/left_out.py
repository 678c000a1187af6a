"""Collects what of a scene cannot be carried over, each kind once, with the names it concerns."""

MOST_NAMES = 5


class LeftOut:
    def __init__(self):
        self._names = {}
        self.reading = ''  # the material, light or world whose nodes are being read

    def add(self, what, name=None):
        """`what` says what is missing and what stands in its place."""
        name = self.reading if name is None else name
        names = self._names.setdefault(what, [])
        if name not in names:
            names.append(name)

    def lines(self):
        return [f'{what}: {self._list(names)}' for what, names in sorted(self._names.items())]

    @staticmethod
    def _list(names):
        more = len(names) - MOST_NAMES
        return ', '.join(names[:MOST_NAMES]) + (f' and {more} more' if more > 0 else '')
