"""Writes statements of the LuxRender 1.x scene language, one a line."""
import os

LONGEST_STRING = 1023  # LuxRender 1.9's limit


def number(value):
    """Shortest text that gives back a 32-bit float or an integer."""
    return str(value) if isinstance(value, int) else f'{float(value):.9g}'


def quoted(text):
    """A string of the language, which has no escapes for its own marks."""
    return '"' + text.replace('\\', '/').replace('"', "'").replace('\n', ' ')[:LONGEST_STRING] + '"'


def fits_string(text):
    """Whether a string of the language holds a text as it is."""
    return quoted(text) == f'"{text}"'


def parameter(kind, name, value):
    """`"kind name" [value]`, where value is a number, a text, a bool, or a sequence of these."""
    values = [value] if isinstance(value, (str, bool, int, float)) else list(value)
    if kind == 'bool':
        values = ['true' if v else 'false' for v in values]
    texts = [quoted(v) if isinstance(v, str) else number(v) for v in values]
    return f'"{kind} {name}" [{" ".join(texts)}]'


def color(name, value):
    """A colour's parameter; value is three numbers, or a texture's name."""
    return parameter('texture' if isinstance(value, str) else 'color', name, value)


def factor(name, value):
    """A number's parameter; value is a number, or a texture's name."""
    return parameter('texture' if isinstance(value, str) else 'float', name, value)


class LxsText:
    """Statements in their order, and the names that are taken of each kind of thing."""

    def __init__(self, folder):
        self.lines = []
        self._folder = folder
        self._taken = set()  # pairs of kind and name

    def file(self, path, name='filename'):
        """A file's parameter: its path from the scene's folder if it is in there."""
        inside = os.path.commonpath([self._folder, path]) == self._folder
        return parameter('string', name, os.path.relpath(path, self._folder) if inside else path)

    def statement(self, keyword, *words, parameters=()):
        """Keyword, then names in quotes and numbers without, then parameters as they are."""
        self.lines.append(self.written(keyword, *words, parameters=parameters))

    @staticmethod
    def written(keyword, *words, parameters=()):
        """The same, to be put elsewhere."""
        head = [keyword] + [quoted(w) if isinstance(w, str) else number(w) for w in words]
        return ' '.join(head + list(parameters))

    def matrix(self, keyword, rows):
        """A transform; rows are those of a 4 x 4 matrix that multiplies columns."""
        columns = ' '.join(number(rows[r][c]) for c in range(4) for r in range(4))
        self.lines.append(f'{keyword} [{columns}]')

    def comment(self, text):
        self.lines.append('# ' + text.replace('\n', ' '))

    def free_name(self, wanted, kind='texture'):
        """`wanted`, or `wanted 2`, `wanted 3`, ... where a thing of that kind has it."""
        name, count = wanted, 1
        while (kind, name) in self._taken:
            count += 1
            name = f'{wanted} {count}'
        self._taken.add((kind, name))
        return name

    def taken(self):
        """The lines so far, to be put elsewhere."""
        lines, self.lines[:] = list(self.lines), []
        return lines
