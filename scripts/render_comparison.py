#!/usr/bin/python3
"""Renders the meshes in the output folder of the program compare: for each pair the shaded results, their angular errors
and their mean curvatures, side by side, in its folder pictures.

Needs what render_meshes.py needs, and NumPy (Debian: python3-numpy).
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersGeneral import vtkCurvatures

import comparison_tables as tables
import render_meshes

METHODS = ['anisotropic_fitting', 'anisotropic_fitting_paper', 'bilateral', 'noniterative', 'alpha_trimmed_normals',
           'adaptive_gaussian_normals', 'thresholded_normals', 'prescribed_mean_curvature', 'bilateral_normals',
           'guided_normals']


def corners(mesh):
    """The points of the three corners of each face, and a unit normal of each face: zero if it is degenerate."""
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    faces = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = (points[faces[:, i]] for i in range(3))
    normals = numpy.cross(b - a, c - a)
    lengths = numpy.linalg.norm(normals, axis=1, keepdims=True)
    return (a, b, c), numpy.divide(normals, lengths, out=numpy.zeros_like(normals), where=lengths > 0)


def mean_edge_length(mesh):
    (a, b, c), _ = corners(mesh)
    return numpy.mean([numpy.linalg.norm(p - q, axis=1).mean() for p, q in ((a, b), (b, c), (c, a))])


def angular_errors(mesh, noise_free):
    """Degrees between the normals of corresponding faces."""
    m, n = corners(mesh)[1], corners(noise_free)[1]
    return numpy.degrees(numpy.arctan2(numpy.linalg.norm(numpy.cross(m, n), axis=1), (m * n).sum(axis=1)))


def mean_curvatures(mesh, unit):
    """Absolute mean curvatures at the vertices, times the unit of length."""
    curvatures = vtkCurvatures()
    curvatures.SetCurvatureTypeToMean()
    curvatures.SetInputData(mesh)
    curvatures.Update()
    return unit * numpy.abs(vtk_to_numpy(curvatures.GetOutput().GetPointData().GetArray('Mean_Curvature')))


def render(folder, pair, methods, errors, arguments):
    meshes = folder / 'meshes' / pair
    panels = ['noise_free', 'noisy'] + [m for m in methods if (meshes / f'{m}.ply').exists()]
    paths = [str(meshes / f'{panel}.ply') for panel in panels]
    labels = ['noise-free', f'noisy, {errors[pair, "noisy"]:.1f}°']
    labels += [f'{tables.label(m)}, {errors[pair, m]:.1f}°' for m in panels[2:]]

    def picture(name, first, *options):
        output = folder / 'pictures' / f'{pair}_{name}.png'
        panel_options = ['--output', str(output), '--columns', str(arguments.columns),
                         '--width', str(arguments.width), '--height', str(arguments.height), '--up', arguments.up,
                         '--azimuth', str(arguments.azimuth), '--elevation', str(arguments.elevation)]
        subprocess.run([sys.executable, render_meshes.__file__, *paths[first:], '--labels', *labels[first:],
                        *panel_options, *options], check=True)
        print(f'Wrote {output}')

    picture('shaded', 0)
    read = [render_meshes.read_mesh(path) for path in paths]
    unit = mean_edge_length(read[0])
    with tempfile.TemporaryDirectory() as scratch:
        def values_files(name, all_values):
            files = [pathlib.Path(scratch) / f'{i}_{name}.txt' for i in range(len(all_values))]
            for file, values in zip(files, all_values):
                numpy.savetxt(file, values, fmt='%.6g')
            return map(str, files)

        picture('errors', 1, '--values', *values_files('errors', [angular_errors(m, read[0]) for m in read[1:]]),
                '--range', '0', '20', '--legend', 'degrees')
        picture('curvature', 0, '--values', *values_files('curvature', [mean_curvatures(m, unit) for m in read]),
                '--range', '0', '0.4', '--legend', '|H| * edge')


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('folder', type=pathlib.Path, help='the output folder of the program compare')
    parser.add_argument('--pairs', nargs='+', help='default: all')
    parser.add_argument('--methods', nargs='+', help='default: those that the paper compares, and later ones')
    parser.add_argument('--columns', type=int, default=4, help='panels in a row (default: %(default)s)')
    parser.add_argument('--width', type=int, default=420, help='pixels of one panel (default: %(default)s)')
    parser.add_argument('--height', type=int, default=360, help='the same (default: %(default)s)')
    parser.add_argument('--up', choices='xyz', default='z', help='the axis that points upwards (default: %(default)s)')
    parser.add_argument('--azimuth', type=float, default=-60, help='degrees around the vertical (default: %(default)s)')
    parser.add_argument('--elevation', type=float, default=25, help='degrees above the horizon (default: %(default)s)')
    arguments = parser.parse_args()

    rows = [row for row in tables.read_table(arguments.folder, 'comparison.csv') if row['search'] == 'default']
    errors = {(row['pair'], row['method']): float(row['mean_angular_error']) for row in rows}
    known_methods = tables.unique(method for _, method in errors)
    tables.check_methods(known_methods, arguments.methods or [])
    methods = arguments.methods or [m for m in METHODS if m in known_methods] or known_methods[1:]
    for pair in arguments.pairs or tables.unique(pair for pair, _ in errors):
        if (pair, 'noisy') not in errors:
            sys.exit(f"there is no pair '{pair}'")
        render(arguments.folder, pair, methods, errors, arguments)


if __name__ == '__main__':
    main()
