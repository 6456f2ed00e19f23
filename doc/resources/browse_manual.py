"""browse_manual.py HTML: opens the manual in Chromium without a network. The formulas must appear, and the interactive
comparison must draw and follow its controls."""
import pathlib
import re
import subprocess
import sys

# appended to the comparison: works the controls as a reader does, and counts the pixels that change
ACTIONS = '''<script>
addEventListener('load', () => setTimeout(() => {
  const pixels = () => {
    const data = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
    gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, data);
    return new Uint32Array(data.buffer);
  };
  let before = pixels();
  const share = test => { let n = 0; before.forEach((p, i) => { n += test(p, i); }); return n / before.length; };
  const results = { drawn: share(p => p !== 0xffffffff) };
  const act = (name, action) => {
    action();
    const after = pixels();
    results[name] = share((p, i) => p !== after[i]);
    before = after;
  };
  const set = (id, property, value) => { element(id)[property] = value; element(id).dispatchEvent(new Event('input')); };
  const point = (type, x, y) => canvas.dispatchEvent(new PointerEvent(type, { pointerId: 1, clientX: x, clientY: y }));
  canvas.setPointerCapture = () => {};
  act('slider', () => set('split', 'value', 900));
  act('colour', () => set('error', 'checked', true));
  act('mesh', () => set('left', 'value', 'noise-free'));
  act('turn', () => { point('pointerdown', 300, 300); point('pointermove', 380, 340); point('pointerup', 380, 340); });
  act('zoom', () => canvas.dispatchEvent(new WheelEvent('wheel', { deltaY: -300 })));
  act('model', () => set('model', 'value', element('model').options[1].value));
  document.body.append(Object.assign(document.createElement('pre'), { id: 'results', textContent: JSON.stringify(results) }));
}, 200));
</script></body>'''


def open_page(path):
    """The page as it is after its scripts ran, and what they complained of."""
    run = subprocess.run(['chromium', '--headless', '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader',
                          '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--host-resolver-rules=MAP * ~NOTFOUND',
                          '--enable-logging=stderr', '--virtual-time-budget=20000', '--window-size=900,700', '--dump-dom',
                          path.resolve().as_uri()], capture_output=True, text=True, timeout=300)
    return run.stdout, re.findall(r'CONSOLE.*?"(.*)", source', run.stderr)


def problems(html):
    for name in ('index.html', 'group__PkgSurfaceMeshDenoisingFunctions.html'):
        page, complaints = open_page(html / name)
        yield from (f'{name}: {complaint}' for complaint in complaints)
        if 'MathJax_SVG' not in page:
            yield f'{name}: formulas are not drawn'
        if re.search('merror|MathJax_Error|Math Processing Error', re.sub('<style.*?</style>', '', page, flags=re.DOTALL)):
            yield f'{name}: a formula is wrong'

    copy = html / 'comparison_test.html'
    copy.write_text((html / 'comparison.html').read_text().replace('</body>', ACTIONS))
    page, complaints = open_page(copy)
    copy.unlink()
    yield from (f'comparison.html: {complaint}' for complaint in complaints)
    results = re.search(r'<pre id="results">(.*?)</pre>', page)
    if not results:
        yield 'comparison.html: does not run'
        return
    print('comparison.html: share of pixels that', results.group(1))
    for action, share in re.findall(r'"(\w+)":([\d.e-]+)', results.group(1)):
        if float(share) < 0.01:
            yield f'comparison.html: {action}: nothing happens'


def main():
    found = list(problems(pathlib.Path(sys.argv[1])))
    print(*found, sep='\n', end='\n' if found else '')
    sys.exit(1 if found else 0)


main()
