"""check_manual.py HTML: looks for dead links, missing pictures, raw markup and anything that needs a network to be shown."""
import html.parser
import pathlib
import re
import sys
import urllib.parse

# what a page loads by itself, in contrast to what it links to
LOADS = {('img', 'src'), ('script', 'src'), ('link', 'href'), ('iframe', 'src'), ('source', 'src'), ('object', 'data')}
CODE = ('script', 'style', 'pre', 'code')
# what is left over where a command of Doxygen was not understood
RAW_MARKUP = re.compile(r'[\\@](?:cgal\w+|ref\b|cite\b|image\b|anchor\b|section\b|subsection\b|include\b|ingroup\b)')


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.loads, self.text = set(), [], [], []
        self.code_depth = 0
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        self.code_depth += tag in CODE
        for name, value in attributes:
            if name in ('id', 'name') and value:
                self.anchors.add(value)
            elif (tag, name) in LOADS and value:
                self.loads.append(value)
            elif name == 'href' and value:
                self.links.append(value)

    def handle_endtag(self, tag):
        self.code_depth -= tag in CODE

    def handle_data(self, data):
        if self.code_depth <= 0:
            self.text.append(data)


def problems(folder):
    pages = {path.name: Page(path) for path in sorted(folder.glob('*.html'))}
    if 'index.html' not in pages:
        yield 'there is no index.html'
    for name, page in pages.items():
        for address in page.links + page.loads:
            parts = urllib.parse.urlsplit(address)
            if parts.scheme in ('http', 'https') or address.startswith('//'):
                if address in page.loads:
                    yield f'{name}: loads {address}'
            elif not parts.scheme:
                target = urllib.parse.unquote(parts.path) or name
                if not (folder / target).is_file():
                    yield f'{name}: {address} does not exist'
                elif parts.fragment and target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].anchors:
                    yield f'{name}: {address} has no such anchor'
        for match in RAW_MARKUP.finditer(' '.join(page.text)):
            yield f'{name}: raw markup {match.group()}'


def main():
    found = list(problems(pathlib.Path(sys.argv[1])))
    print(*found, sep='\n', end='\n' if found else '')
    sys.exit(1 if found else 0)


main()
