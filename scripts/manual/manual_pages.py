"""The manual's pages (docs/): titles, headings' anchors, links, code. Used by its site
(site_hooks.py) and by tests/docs. The notebook (docs/notebook) is no part of the manual.
"""
import os
import pathlib
import re

PARTS = ('start', 'choose', 'understand', 'reference', 'build-on', 'measured')
FENCE = re.compile(r'^ {0,3}(```+|~~~+)(.*)$')
LINK = re.compile(r'\]\(\s*<?([^()\s>]+)>?(?:\s+"[^"]*")?\s*\)|^\[[^\]]+\]:\s+(\S+)|'
                  r'<(?:a|img)\s[^>]*?(?:href|src)="([^"]+)"')
OUTSIDE = re.compile(r'^(?:[a-z][a-z0-9+.-]*:|//)')


def slug(heading):
    """GitHub's anchor of a heading's text."""
    text = re.sub(r'!?\[([^\]]*)\]\([^)]*\)', r'\1', heading)
    text = re.sub(r'<[^>]+>', '', text).strip().lower()
    return ''.join('-' if c == ' ' else c for c in text
                   if c.isalnum() or c in ' -_')


class Page:
    """One Markdown file."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.text = self.path.read_text(encoding='utf-8')
        self.blocks = []  # (number of the first line, language, lines) of code
        self.prose = []   # (number of the line, line without code)
        self._split()

    def _split(self):
        fence, comment = None, False
        for number, line in enumerate(self.text.splitlines(), 1):
            mark = FENCE.match(line)
            if fence is None and mark:
                fence = mark[1]
                self.blocks.append((number + 1, mark[2].strip(), []))
            elif fence is not None:
                if mark and mark[1].startswith(fence) and not mark[2].strip():
                    fence = None
                else:
                    self.blocks[-1][2].append(line)
            else:
                self.prose.append((number, line))

    @property
    def words(self):
        """As `wc -w` counts them."""
        return len(self.text.split())

    @property
    def title(self):
        return next((line[2:].strip() for _, line in self.prose if line.startswith('# ')), '')

    @property
    def anchors(self):
        found, seen = set(), {}
        for _, line in self.prose:
            heading = re.match(r' {0,3}#{1,6}\s+(.*?)\s*#*$', line)
            if heading:
                base = slug(heading[1])
                count = seen.get(base, 0)
                seen[base] = count + 1
                found.add(f'{base}-{count}' if count else base)
            found.update(re.findall(r'<\w+\s[^>]*?(?:id|name)="([^"]+)"', line))
        return found

    def links(self):
        """Yields (number of the line, target) of each link and picture but those of the web."""
        for number, line in self.prose:
            for found in LINK.finditer(re.sub(r'`[^`]*`', lambda code: ' ' * len(code[0]), line)):
                target = next(filter(None, found.groups()))
                if not OUTSIDE.match(target):
                    yield number, target

    def target_of(self, link):
        """(path of the file that a link leads to, its anchor or '')."""
        path, _, anchor = link.partition('#')
        if not path:
            return self.path, anchor
        return pathlib.Path(os.path.normpath(self.path.parent / path)), anchor


def pages_below(folder):
    """Pages of a folder by path, in order of their paths. Without the notebook below it."""
    folder = pathlib.Path(folder)
    return {path: Page(path) for path in sorted(folder.rglob('*.md'))
            if not path.is_relative_to(folder / 'notebook')}
