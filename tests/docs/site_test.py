#!/usr/bin/env python3
"""Protects the manual's site: MkDocs makes it without a warning, every page but the notebook's is in
it and in its navigation and found by its search, links and anchors lead somewhere, nothing is loaded from another
host.

    site_test.py MKDOCS FOLDER      the site is made in FOLDER
"""
import json
import pathlib
import re
import subprocess
import sys
from html.parser import HTMLParser
from urllib.parse import unquote

ROOT = pathlib.Path(__file__).resolve().parents[2]
LOADED = {'script': 'src', 'img': 'src', 'iframe': 'src', 'link': 'href'}


class Html(HTMLParser):
    """What a page loads, links to, and can be linked to."""

    def __init__(self, text):
        super().__init__()
        self.loads, self.links, self.ids = [], [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.ids.update(filter(None, (values.get('id'), values.get('name'))))
        if values.get('rel') in ('canonical', 'next', 'prev'):
            return
        if LOADED.get(tag) in values:
            self.loads.append(values[LOADED[tag]] or '')
        elif tag == 'a' and 'href' in values:
            self.links.append(values['href'] or '')


def faults(site):
    pages = {path: Html(path.read_text()) for path in site.rglob('*.html')}
    for path, page in pages.items():
        for link in page.loads + page.links:
            outside = re.match(r'[a-z]+:|//', link)
            if outside and link in page.loads:
                yield f'{path.name}: loads {link}'
            target, _, anchor = unquote(link).partition('#')
            if outside or path.name == '404.html':
                continue
            file = (path.parent / target).resolve() if target else path
            if file.is_dir():
                file /= 'index.html'
            if not file.exists():
                yield f'{path.relative_to(site)}: {link} leads nowhere'
            elif anchor and file in pages and anchor not in pages[file].ids:
                yield f'{path.relative_to(site)}: {link}: no such anchor'
    loaded_by_css = re.compile(r'(?:url\(|@import\s)\s*["\']?((?:https?:)?//[^"\')]+)')
    for path in site.rglob('*.css'):
        for url in loaded_by_css.findall(path.read_text()):
            yield f'{path.name}: loads {url}'
    found = {entry['location'].partition('#')[0]
             for entry in json.loads((site / 'search/search_index.json').read_text())['docs']}
    navigation = {(site / unquote(link)).resolve() for link in pages[site / 'index.html'].links}
    for path in sorted((ROOT / 'docs').rglob('*.md')):
        if path.parent.name == 'notebook':
            continue
        name = path.relative_to(ROOT / 'docs').with_suffix('.html')
        if str(name) not in found:
            yield f'{name}: search does not know it'
        if site / name not in navigation and name.name != 'index.html':
            yield f'{name}: not in the navigation'


def main():
    mkdocs, site = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    ended = subprocess.run([mkdocs, 'build', '--strict', '--clean', '--config-file',
                            ROOT / 'scripts/manual/mkdocs.yml', '--site-dir', site],
                           capture_output=True, text=True)
    found = [ended.stdout + ended.stderr] if ended.returncode != 0 else list(faults(site))
    print('\n'.join(found) if found else 'no faults')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
