#!/usr/bin/python3
"""plot_performance.py FILE MANUAL: draws what benchmark_fitting measured, and writes its table into the manual."""
import json
import pathlib
import sys

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402

from manual_tables import replace_table  # noqa: E402


def read(path):
    """The counters of each benchmark, by its name and size."""
    runs = {}
    for run in json.loads(path.read_text())['benchmarks']:
        name, *rest = run['name'].split('/')
        size = next((int(part) for part in rest if part.isdigit()), None)
        runs[name, size] = run
    return runs


def curve(runs, name, value):
    points = sorted((size, value(run)) for (n, size), run in runs.items() if n == name)
    return [p[0] for p in points], [p[1] for p in points]


def plot(runs, path):
    figure, panel = plt.subplots(figsize=(6.4, 3.4), layout='constrained')
    default = 'default_run_beside_smooth_shape'
    panel.plot(*curve(runs, default, lambda run: run['us/vertex'] / run['ratio']), 'o--', color='#8296ab',
               label='ten iterations of smooth_shape()')
    panel.plot(*curve(runs, default, lambda run: run['us/vertex']), 'o-', color='#c1440e', linewidth=2.2,
               label='a run without parameters')
    panel.plot(*curve(runs, 'iteration_with_size_of_mesh', lambda run: run['us/vertex']), 's-.', color='#1f6f8b',
               label='one iteration, neighborhoods of 20 faces')
    panel.set_xscale('log')
    panel.set_yscale('log')
    panel.set_xlabel('vertices')
    panel.set_ylabel('microseconds a vertex, one core')
    panel.grid(True, color='#e4e4e4')
    for side in ('top', 'right'):
        panel.spines[side].set_visible(False)
    panel.legend(fontsize=9, frameon=False, loc='center left', bbox_to_anchor=(1, 0.5))
    figure.savefig(path, dpi=110)


def rows_of_runs(runs, benchmark, meaning):
    rows = []
    for size, run in sorted((size, run) for (name, size), run in runs.items() if name == benchmark):
        number = f'{size:,}'.replace(',', ' ')
        rows.append([f'{meaning}, {number} vertices',
                     f"{run['us/vertex']:.1f} microseconds a vertex, {run['ratio']:.2f} times ten iterations of `smooth_shape()`"])
    return rows


def table(runs):
    iteration = runs['iteration_beside_smooth_shape', None]
    rows = [['one iteration, 100 000 vertices', f"{iteration['us/vertex']:.1f} microseconds a vertex"],
            ['`smooth_shape()`, one iteration, the same mesh', f"{iteration['smooth_shape us/vertex']:.1f} microseconds a vertex"],
            ['ratio of the two', f"{iteration['ratio']:.2f}"],
            ['cost of an iteration per vertex, 2 million vertices beside 10 000',
             f"{runs['iteration_with_size_of_mesh', 2000000]['ratio to 10k']:.2f} times"],
            ['convergence tests', f"{100 * runs['convergence_tests', None]['share of tests']:.2f} % of a run of "
                                  f"{runs['convergence_tests', None]['iterations']:.0f} iterations"],
            ['memory beside the mesh, 1 million vertices', f"{runs['peak_memory', 1000000]['bytes/vertex']:.0f} bytes a vertex"]]
    if ('two_threads', None) in runs:
        rows.append(['two threads beside one', f"{runs['two_threads', None]['speedup']:.2f} times as fast"])
    rows += rows_of_runs(runs, 'default_run_beside_smooth_shape', 'a run without parameters')
    rows.append(['its memory beside the mesh, 1 million vertices',
                 f"{runs['default_run_peak_memory', 1000000]['bytes/vertex']:.0f} bytes a vertex"])
    if ('default_run_two_threads', None) in runs:
        rows.append(['its two threads beside one', f"{runs['default_run_two_threads', None]['speedup']:.2f} times as fast"])
    rows += rows_of_runs(runs, 'dear_run_beside_smooth_shape', 'a run on a sphere with noise of 0.8 in all directions')
    return rows


def main():
    manual = pathlib.Path(sys.argv[2])
    runs = read(pathlib.Path(sys.argv[1]))
    plot(runs, manual / 'fig/performance.png')
    replace_table(manual / 'Surface_mesh_denoising.txt', 'performance', 'scripts/performance', ['', 'measured'], table(runs))


main()
