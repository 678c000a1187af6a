"""What MkDocs asks for while it makes the manual's site: navigation by parts, GitHub's anchors, and
links that leave docs/. scenes/README.md becomes a page; the notebook is left out; of links to
other files their text stays.
"""
import os
import pathlib
import re
import shutil
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import manual_pages  # noqa: E402
from mkdocs.structure.files import File  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCS = ROOT / 'docs'
TITLES = {'start': 'Start', 'choose': 'Choose', 'understand': 'Understand', 'reference': 'Look up',
          'build-on': 'Build on', 'measured': 'Measured'}
# Files outside of docs/ that are pages of the site: their names there.
OTHER_PAGES = {ROOT / 'scenes/README.md': 'reference/scenes.md'}


def on_config(config):
    config['mdx_configs'].setdefault('toc', {})['slugify'] = lambda text, _: manual_pages.slug(text)
    config['nav'] = navigation()
    return config


def mentioned(page):
    """Pages of docs/ that a page links to, in its order."""
    if not page.exists():
        return []
    here = manual_pages.Page(page)
    return [here.target_of(link)[0] for _, link in here.links()]


def navigation():
    """The parts in their order; pages as the part's first page and docs/index.md name them."""
    nav = [{'AIPS': 'index.md'}]
    for part in manual_pages.PARTS:
        alone = DOCS / f'{part}.md'
        if alone.exists():
            nav.append({TITLES[part]: f'{part}.md'})
        first = DOCS / part / 'index.md'
        found = sorted((DOCS / part).rglob('*.md'))
        known = mentioned(first) + mentioned(DOCS / 'index.md')
        place = {path: number for number, path in reversed(list(enumerate(known)))}
        found.sort(key=lambda path: (place.get(path, len(known)), path))
        pages = [str(path.relative_to(DOCS)) for path in found if path != first]
        if part == 'reference':
            pages += OTHER_PAGES.values()
        if pages or first.exists():
            index = [str(first.relative_to(DOCS))] if first.exists() else []
            nav.append({TITLES[part]: index + grouped(pages)})
    return nav


def grouped(pages):
    """Pages of a part's subfolder stand together, under the title of its first page."""
    entries, groups = [], {}
    for name in pages:
        folder = pathlib.PurePath(name).parent
        if len(folder.parts) < 2:
            entries.append(name)
            continue
        if folder not in groups:
            first = DOCS / folder / 'index.md'
            groups[folder] = []
            title = manual_pages.Page(first).title if first.exists() else folder.name
            entries.append({title: groups[folder]})
        groups[folder].append(name)
    return entries


def on_files(files, config):
    for page in [file for file in files if file.src_uri.startswith('notebook/')]:
        files.remove(page)
    for path, name in OTHER_PAGES.items():
        page = File(name, str(path.parent), config['site_dir'], config['use_directory_urls'])
        page.abs_src_path = str(path)
        files.append(page)
    return files


def moved(link, source, name):
    """The link for the site: `source` is the page's file, `name` its name below docs/. None: the
    link leads out of the site."""
    path, _, anchor = link.partition('#')
    if not path or manual_pages.OUTSIDE.match(link):
        return link
    target = pathlib.Path(os.path.normpath(source.parent / path))
    if target in OTHER_PAGES:
        place = OTHER_PAGES[target]
    elif (target.is_relative_to(DOCS) and not target.is_dir() and
          not target.is_relative_to(DOCS / 'notebook')):
        place = target.relative_to(DOCS)
    else:
        return None
    return os.path.relpath(place, pathlib.PurePath(name).parent) + (f'#{anchor}' if anchor else '')


def on_page_markdown(markdown, page, config, files):
    source, name = pathlib.Path(page.file.abs_src_path), page.file.src_uri
    out, fenced, previous = [], False, ''
    for line in markdown.splitlines():
        if manual_pages.FENCE.match(line):
            fenced = not fenced
        elif not fenced:
            # GitHub begins a list below a paragraph without an empty line between.
            listed = re.match(r'\s*([-*]|\d+\.)\s', line)
            if listed and previous.strip() and not re.match(r'\s*([-*]|\d+\.)\s|\s{2,}', previous):
                out.append('')
            line = re.sub(r'(!?)\[((?:[^\[\]]|\[[^\]]*\]\([^)]*\))*)\]\(([^()\s]+)\)',
                          lambda found: rewritten(found, source, name), line)
        out.append(line)
        previous = line
    return '\n'.join(out)


def rewritten(found, source, name):
    link = moved(found[3], source, name)
    return f'{found[1]}[{found[2]}]({link})' if link else found[2]


def on_page_content(html, page, config, files):
    return html.replace('<table>', '<table class="docutils">')


def on_post_build(config):
    """Debian's package has jQuery under another name than its theme asks for, and leaves out a
    script that adds nothing here."""
    scripts = pathlib.Path(config['site_dir']) / 'js'
    asked = scripts / 'jquery-3.6.0.min.js'
    for present in scripts.glob('jquery-*.min.js'):
        if not asked.exists():
            shutil.copy(present, asked)
    (scripts / 'theme_extra.js').touch()
