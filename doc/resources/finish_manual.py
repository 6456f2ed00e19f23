"""What Doxygen leaves to do: finish_manual.py ROOT HTML numbers the figures, names the concepts, and makes the manual
readable without a network."""
import pathlib
import re
import shutil
import sys

MATHJAX = pathlib.Path('/usr/share/javascript/mathjax')
# all that TeX formulas drawn as SVG take
MATHJAX_PARTS = ['MathJax.js', 'extensions/tex2jax.js', 'extensions/MathEvents.js', 'extensions/MathZoom.js',
                 'extensions/MathMenu.js', 'extensions/TeX', 'jax/element/mml', 'jax/input/TeX', 'jax/output/SVG/jax.js',
                 'jax/output/SVG/config.js', 'jax/output/SVG/autoload', 'jax/output/SVG/fonts/TeX']


def copy_mathjax(html):
    for part in MATHJAX_PARTS:
        source, target = MATHJAX / part, html / 'mathjax' / part
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, target)
        else:
            shutil.copy(source, target)


def number_figures(pages):
    """Figures have names in the sources, and numbers by their order in the user manual on the pages."""
    names = re.findall(r'id="fig__(\w+)"', (pages['index.html']))
    for name, text in pages.items():
        for i, figure in enumerate(names, 1):
            text = re.sub(rf'(href="[^"]*#fig__{figure}">){figure}(</a>)', rf'\g<1>{i}\2', text)
        pages[name] = text


def name_concepts(pages):
    for name, text in pages.items():
        if '<div class="concept"></div>' in text:
            text = re.sub('<p><code>#include.*?</code></p>', '', text) # there is nothing to include
            pages[name] = text.replace('Class Reference', 'Concept Reference')


def main():
    html = pathlib.Path(sys.argv[2])
    pages = {path.name: path.read_text() for path in html.glob('*.html')}
    number_figures(pages)
    name_concepts(pages)
    for name, text in pages.items():
        (html / name).write_text(text)
    copy_mathjax(html)
    root = pathlib.Path(sys.argv[1])
    meshes = (root / 'doc/Surface_mesh_denoising/fig/comparison_meshes.js').read_text()
    page = (root / 'doc/resources/comparison.html').read_text()
    (html / 'comparison.html').write_text(page.replace('/* the meshes */', meshes))


main()
