#!/usr/bin/python3
"""Plots the tables in the output folder of the program compare: normal_errors.png, distances.png.

Needs Matplotlib (Debian: python3-matplotlib).
"""

import argparse
import math
import pathlib
import statistics

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402

import comparison_tables as tables  # noqa: E402

OURS = {'anisotropic_fitting': '#c1440e', 'anisotropic_fitting_paper': '#e39a6f'}
OTHERS = '#8296ab'
NOISY = '#777777'
# told apart without colour as well
LINES = [('#c1440e', '-', 2.2), ('#e39a6f', '-', 1.4), ('#1f6f8b', '--', 1.4), ('#5b8c5a', '-.', 1.4),
         ('#6a4c93', ':', 1.8), ('#333333', (0, (6, 1, 1, 1, 1, 1)), 1.2)]


def make_panels(number, width, height):
    """A figure with a row of panels, or several: the axes that are used."""
    columns = min(number, 4)
    rows = math.ceil(number / columns)
    figure, axes = plt.subplots(rows, columns, sharey=True, squeeze=False, layout='constrained',
                                figsize=(width * columns + 1.2, height * rows + 0.5))
    for unused in axes.flat[number:]:
        unused.set_axis_off()
    return figure, list(axes.flat[:number])


def plot_normal_errors(folder, methods):
    rows = [row for row in tables.read_table(folder, 'comparison.csv') if row['method'] != 'noisy']
    rows = [row for row in rows if not methods or row['method'] in methods]
    errors = {(row['pair'], row['method'], row['search']): float(row['mean_angular_error']) for row in rows}
    pairs = tables.unique(row['pair'] for row in rows)

    def mean_error(method):
        return statistics.mean(e for (_, m, search), e in errors.items() if m == method and search == 'default')

    with_defaults = tables.unique(row['method'] for row in rows if row['search'] == 'default')
    methods = sorted(with_defaults, key=mean_error, reverse=True)
    has_best = any(row['search'] == 'best' for row in rows)

    figure, axes = make_panels(len(pairs), 2.4, 0.5 + 0.19 * len(methods))
    for panel, pair in zip(axes, pairs):
        positions = {method: i for i, method in enumerate(methods)}
        for method, i in positions.items():
            if (pair, method, 'default') not in errors:
                continue
            error = errors[pair, method, 'default']
            panel.barh(i, error, height=0.7, color=OURS.get(method, OTHERS))
            panel.annotate(f'{error:.1f}', (error, i), xytext=(5 if has_best else 2, 0), textcoords='offset points',
                           va='center', fontsize=7)
            if (pair, method, 'best') in errors:
                panel.plot(errors[pair, method, 'best'], i, 'D', color='black', markersize=3.2)
        panel.set_title(tables.pair_title(pair), fontsize=9)
        panel.set_yticks(range(len(methods)), [tables.label(method) for method in methods], fontsize=8)
        panel.tick_params(axis='x', labelsize=7)
        panel.margins(x=0.14, y=0.01)
        for side in ('top', 'right'):
            panel.spines[side].set_visible(False)
    title = 'Mean angle between the face normals of the result and of the noise-free mesh, degrees'
    figure.suptitle(title + ('\nbars: default parameters; diamonds: the best of a grid' if has_best else ''), fontsize=10)
    return figure


def plot_distances(folder, methods):
    rows = tables.read_table(folder, 'histograms.csv')
    tables.check_methods({row['method'] for row in rows}, methods)
    pairs = tables.unique(row['pair'] for row in rows)

    figure, axes = make_panels(len(pairs), 2.6, 2.2)
    handles = {}
    highest = 0
    for panel, pair in zip(axes, pairs):
        for method in ['noisy', *methods]:
            bins = [row for row in rows if row['pair'] == pair and row['method'] == method]
            if not bins:
                continue
            edges = [float(row['from']) for row in bins] + [float(bins[-1]['to'])]
            shares = [100 * float(row['share']) for row in bins]
            if method == 'noisy':
                handles[method] = panel.stairs(shares, edges, color='#dddddd', fill=True)
                continue
            color, style, width = LINES[methods.index(method) % len(LINES)]
            handles[method] = panel.stairs(shares, edges, color=color, linestyle=style, linewidth=width)
            highest = max(highest, *shares)
        panel.set_title(tables.pair_title(pair), fontsize=9)
        panel.set_xlim(0, 0.4)
        panel.set_xticks([0, 0.1, 0.2, 0.3, 0.4])
        panel.tick_params(labelsize=7)
        for side in ('top', 'right'):
            panel.spines[side].set_visible(False)
    axes[0].set_ylim(0, 1.05 * highest)
    labels = ['noisy mesh' if method == 'noisy' else tables.label(method) for method in handles]
    figure.legend(handles.values(), labels, loc='upper center', bbox_to_anchor=(0.5, 0), ncols=4, fontsize=8, frameon=False)
    figure.supxlabel('distance between the result and the noise-free mesh, in mean edge lengths', fontsize=9)
    figure.supylabel('share of the surfaces, percent', fontsize=9)
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('folder', type=pathlib.Path, help='the output folder of the program compare')
    parser.add_argument('--methods', nargs='+', default=[], help='of normal_errors.png (default: all)')
    parser.add_argument('--histogram-methods', nargs='+', metavar='METHOD',
                        help='of distances.png (default: the first of the methods of the paper that have results)')
    arguments = parser.parse_args()

    known = tables.unique(row['method'] for row in tables.read_table(arguments.folder, 'histograms.csv'))
    tables.check_methods(known, arguments.methods)
    if arguments.histogram_methods is None:
        usual = ['anisotropic_fitting', 'anisotropic_fitting_paper', 'thresholded_normals', 'adaptive_gaussian_normals',
                 'bilateral', 'prescribed_mean_curvature']
        arguments.histogram_methods = [m for m in usual if m in known] or [m for m in known if m != 'noisy'][:6]

    for name, figure in (('normal_errors.png', plot_normal_errors(arguments.folder, arguments.methods)),
                         ('distances.png', plot_distances(arguments.folder, arguments.histogram_methods))):
        figure.savefig(arguments.folder / name, dpi=110, bbox_inches='tight')
        print(f'Wrote {arguments.folder / name}')


if __name__ == '__main__':
    main()
