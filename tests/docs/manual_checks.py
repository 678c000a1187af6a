"""What is checked of the manual. Each check takes a Manual and yields its faults, each a line that
begins with the place.
"""
import functools
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'scripts/manual'))
from manual_pages import Page, pages_below  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
MOST_WORDS = 1600
MOST_NOTEBOOK_PAGES = 15
# Of the manual: pages, words written by hand, words of GENERATED. These bounds may only fall.
MOST_PAGES, MOST_WRITTEN, MOST_GENERATED = 70, 60000, 46200
# Made from declarations or entries, as long as these are; of the pages of messages tests cause
# every row.
GENERATED = ('reference/parameters.md', 'reference/scene-language.md', 'reference/gallery.md',
             'build-on/rooms.md', 'build-on/constants.md', 'reference/errors/scene.md',
             'reference/errors/appearance.md', 'reference/errors/shapes.md',
             'reference/errors/running.md', 'reference/errors/pbrt.md')
HASH = re.compile(r'(?<![\w/.-])(?=[0-9a-f]*[a-f])(?=[0-9a-f]*[0-9])[0-9a-f]{7,40}(?![\w/-])')
DIARY = re.compile(r'\b(?:before|after), at\b|\bearlier versions?\b|\bat revision\b|'
                   r'\bsuperseded (?:figures|version)|\bprevious versions?\b', re.IGNORECASE)
LEFTOVER = re.compile(r'@@\w*@@|\bTODO\b|\bFIXME\b|\bXXX\b|(?<![\w.])/(?:work|root|home)/')
OPTION = re.compile(r'(?<![\w-])(--[a-z][\w-]*|-[a-zA-Z](?![\w-]))')
COMMAND = re.compile(r'(?:scripts/|lxsrender(?![\w-]))')


class Manual:
    """The pages below `root`/docs, and what they speak of: `root`, and the program lxsrender. The
    notebook, docs/notebook, is for maintainers and no part of the manual."""

    def __init__(self, root, lxsrender=None):
        self.root, self.docs, self.lxsrender = root, root / 'docs', lxsrender
        self.pages = pages_below(self.docs)
        others = (root / 'README.md', root / 'scenes/README.md')
        self.of_the_present = {**self.pages,
                               **{path: Page(path) for path in others if path.exists()}}
        self.notebook = pages_below(self.docs / 'notebook')
        self.all_pages = {**self.of_the_present, **self.notebook}

    def place(self, path, line=None):
        return f'{path.relative_to(self.root)}{f":{line}" if line else ""}'

    @functools.cache
    def answer(self, *command):
        ended = subprocess.run(command, capture_output=True, text=True)
        return ended.stdout + ended.stderr if ended.returncode == 0 else ''


def links(manual):
    """Every relative link, and the anchor that it names, exists."""
    for path, page in manual.all_pages.items():
        for line, link in page.links():
            target, anchor = page.target_of(link)
            where = manual.place(path, line)
            if not target.exists():
                yield f'{where}: {link}: there is no such file'
            elif target.is_dir() and target.is_relative_to(manual.docs):
                yield f'{where}: {link}: a folder, where a page of it is meant'
            elif anchor and target.suffix == '.md':
                known = manual.all_pages.get(target) or Page(target)
                if anchor not in known.anchors:
                    yield f'{where}: {link}: no heading there has this anchor'


def reach(manual):
    """Every page is reached by links from docs/index.md."""
    start = manual.docs / 'index.md'
    if start not in manual.pages:
        yield 'docs/index.md: there is no such page'
        return
    reached, new = {start}, [start]
    while new:
        page = manual.pages[new.pop()]
        targets = {page.target_of(link)[0] for _, link in page.links()}
        found = (targets & manual.pages.keys()) - reached
        reached |= found
        new += found
    for path in sorted(manual.pages.keys() - reached):
        yield f'{manual.place(path)}: no link leads here from docs/index.md'


def length(manual):
    """Pages are short, but for those that are generated."""
    for path, page in manual.pages.items():
        if page.words > MOST_WORDS and str(path.relative_to(manual.docs)) not in GENERATED:
            yield f'{manual.place(path)}: {page.words} words; at most {MOST_WORDS}'


def counts(manual):
    """{folder of docs/: [pages, words written by hand, words generated]}, with their sum."""
    found = {}
    for path, page in manual.pages.items():
        name = path.relative_to(manual.docs)
        for folder in (name.parts[0] if len(name.parts) > 1 else '.', 'together'):
            count = found.setdefault(folder, [0, 0, 0])
            count[0] += 1
            count[2 if str(name) in GENERATED else 1] += page.words
    return {**{name: count for name, count in found.items() if name != 'together'},
            'together': found.get('together', [0, 0, 0])}


def size(manual):
    """The manual as a whole is short."""
    together = counts(manual)['together']
    for name, count, most in zip(('pages', 'words written by hand', 'words generated'), together,
                                 (MOST_PAGES, MOST_WRITTEN, MOST_GENERATED)):
        if count > most:
            yield f'docs: {count} {name}; at most {most}'


def titles(manual):
    """Every page begins with its title."""
    for path, page in {**manual.pages, **manual.notebook}.items():
        if not page.text.startswith('# '):
            yield f'{manual.place(path)}: does not begin with a title'


def diary(manual):
    """Outside of the notebook no page speaks of revisions or of how something was before."""
    for path, page in manual.of_the_present.items():
        for number, line in enumerate(page.text.splitlines(), 1):
            for found in (*HASH.finditer(line), *DIARY.finditer(line)):
                yield f'{manual.place(path, number)}: "{found[0]}" belongs in the notebook'


def leftovers(manual):
    """No page has places to be filled in, or paths of one machine."""
    for path, page in manual.all_pages.items():
        for number, line in enumerate(page.text.splitlines(), 1):
            for found in LEFTOVER.finditer(line):
                yield f'{manual.place(path, number)}: "{found[0]}" was left there'


def options_of(manual, program):
    """Text that names every option of a script or of lxsrender. Scripts hand options on to ctest,
    or to a program that lies beside lxsrender."""
    if program == 'lxsrender':
        return manual.answer(manual.lxsrender, '--help')
    text = (manual.root / program).read_text()
    others = re.findall(r'bin/([\w-]+)" "\$@"|is for (lxsrender)', text)
    for other in {first or second for first, second in others}:
        text += manual.answer(manual.lxsrender.with_name(other), '--help')
    if 'option of ctest' in text:
        text += manual.answer('ctest', '--help')
    if 'argparse' in text:
        text += ' --help -h '
    return text


def faults_of_command(manual, command):
    program = command.split()[0]
    if program.startswith('scripts/') and not (manual.root / program).exists():
        yield f'{program}: there is no such script'
        return
    if program != 'lxsrender' and not (manual.root / program).is_file():
        return
    known = options_of(manual, program)
    for option in OPTION.findall(re.sub(r'"[^"]*"|\'[^\']*\'|\s#.*', ' ', command)):
        if not re.search(rf'(?<![\w-]){option}(?![\w-])', known):
            yield f'{program} has no option {option}'
    for plugin, parameter in re.findall(r'--set[ =](\w+)\.(\w+)=', command):
        described = manual.answer(manual.lxsrender, '--describe', plugin)
        if plugin != 'plugin' and not re.search(rf'(?m)^\s*{parameter}\b', described):
            yield f'{plugin} has no parameter {parameter}'


def joined(lines):
    """Lines of a shell, those that end with a backslash with what follows them."""
    return re.sub(r'\\\n\s*', ' ', '\n'.join(lines)).split('\n')


def commands(manual):
    """Commands name scripts, options and parameters that exist. Looks at blocks of code whose lines
    begin with scripts/ or lxsrender, and at code within lines that does."""
    for path, page in manual.of_the_present.items():
        found = [(first + number, line) for first, _, lines in page.blocks
                 for number, line in enumerate(joined(lines))]
        found += [(number, code) for number, line in page.prose
                  for code in re.findall(r'`([^`]+)`', line)]
        for number, command in found:
            if COMMAND.match(command.strip()):
                for fault in faults_of_command(manual, command.strip()):
                    yield f'{manual.place(path, number)}: {fault}'


def changing(manual):
    """docs/build-on/changing.md names only files and folders that exist. NAME stands for any; what
    is below build/ comes with a build."""
    path = manual.docs / 'build-on/changing.md'
    if not path.exists():
        yield 'docs/build-on/changing.md: there is no such page'
        return
    for number, line in manual.pages[path].prose:
        for code in re.findall(r'`([^`\s]+)[^`]*`', line):
            named = re.split(r'/?[^/]*(?:NAME|\*)', code)[0]
            is_path = re.fullmatch(r'[\w.-]+(?:/[\w.-]+)*/?', named) and re.search(r'/|.\.', code)
            if is_path and not named.startswith('build/'):
                if not (manual.root / named).exists():
                    yield f'{manual.place(path, number)}: {code}: there is no such file'


def named(manual):
    """Pages that sources, scripts and tests name exist."""
    for folder in ('core-adapter', 'host', 'plugin', 'scripts', 'tests'):
        for path in sorted((manual.root / folder).rglob('*')):
            if path.is_relative_to(HERE) or not path.is_file() or path.stat().st_size > 1 << 20:
                continue
            if path.suffix not in ('', '.h', '.cpp', '.py', '.txt', '.cmake', '.json', '.yml'):
                continue
            text = path.read_text(errors='replace')
            for found in re.finditer(r'\bdocs/[\w/-]+\.md\b', text):
                if not (manual.root / found[0]).exists():
                    line = text.count('\n', 0, found.start()) + 1
                    yield f'{manual.place(path, line)}: {found[0]}: there is no such page'


def notebook(manual):
    """The notebook stays small: measurements that decided what still stands, each under a date and
    the question that a maintainer would ask again. No page of the manual links to it."""
    if len(manual.notebook) > MOST_NOTEBOOK_PAGES:
        yield f'docs/notebook: {len(manual.notebook)} pages; at most {MOST_NOTEBOOK_PAGES}'
    for path in manual.notebook:
        if not re.match(r'\d{4}-\d\d-\d\d-', path.name):
            yield f'{manual.place(path)}: its name does not begin with a date'
    for path, page in manual.of_the_present.items():
        for line, link in page.links():
            if path.name != 'constants.md' and page.target_of(link)[0] in manual.notebook:
                yield f'{manual.place(path, line)}: {link}: the notebook is no part of the manual'


def tables_of(text):
    """The tables of a page: of each, a dictionary from the first cell of a row, without emphasis
    and what stands behind a comma, to those by column."""
    rows = [[cell.strip(' *\\') for cell in line.strip().strip('|').split('|')]
            if line.startswith('|') else None for line in text.split('\n')]
    tables, head = [], None
    for row in rows:
        if row is None:
            head = None
        elif head is None:
            head = row
            tables.append({})
        elif set(''.join(row)) - set('-: '):
            tables[-1][row[0].split(',')[0]] = dict(zip(head[1:], row[1:]))
    return tables


def figures(manual):
    """Every figure of README.md's tables of scenes is the one of its scene and method in the first
    table of a page of docs/measured that has all of these methods."""
    methods = ('path', 'sppm', 'aips', 'pbrt path', 'pbrt bdpt', 'pbrt sppm')
    readme = manual.all_pages.get(manual.root / 'README.md')
    measured = {}
    for name in ('results', 'other-renderers'):
        page = manual.pages.get(manual.docs / f'measured/{name}.md')
        for table in tables_of(page.text)[:1] if page else []:
            measured[f'docs/measured/{name}.md'] = table
    for table in tables_of(readme.text) if readme else []:
        wanted = {column for cells in table.values() for column in cells} & set(methods)
        page, known = next(((name, rows) for name, rows in measured.items()
                            if all(wanted <= set(cells) for cells in rows.values())),
                           ('docs/measured', {}))
        for scene, cells in table.items():
            for method in sorted(wanted):
                figure = known.get(scene, {}).get(method)
                if cells.get(method) != figure:
                    yield f'README.md: {scene}, {method}: {cells.get(method)}, but {figure} in {page}'


CHECKS = {check.__name__: check
          for check in (links, reach, length, size, titles, diary, leftovers, commands,
                        changing, named, notebook, figures)}
