#!/usr/bin/python3
"""draw_figures.py DATA FIGURES: draws the pictures of the manual from what manual_figures left in DATA.

Needs VTK for Python (Debian: python3-vtk9) and a display; without one, run it by xvfb-run -a.
"""

import base64
import json
import math
import pathlib
import subprocess
import sys

import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkArrowSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderWindow, vtkWindowToImageFilter

import render_meshes
from manual_tables import replace_table

PARAMETERS = {
    'angle_threshold': ('0.05', '0.5', '0.95'),
    'number_of_normal_iterations': ('0', '5', '60'),
    'neighborhood_size': ('6', '40', '400'),
    'normal_weight': ('1', '200', '100 000'),
    'number_of_iterations': ('2', '30', '300'),
}
METHODS = {
    'noisy': 'noisy',
    'anisotropic_fitting': 'default',
    'paper': 'Wang, Yu 2012',
    'guided': 'Zhang et al. 2015',
    'zheng': 'Zheng et al. 2011',
    'sun': 'Sun et al. 2007',
    'fleishman': 'Fleishman et al. 2003',
    'isotropic_fitting': 'isotropic fitting',
    'taubin': 'Taubin 1995',
}
PART = ['--azimuth', '-60', '--elevation', '30']
BLUE, GREEN, RED, GREY, SURFACE = (0.15, 0.35, 0.75), (0.1, 0.65, 0.25), (0.8, 0.15, 0.1), (0.3, 0.3, 0.3), (0.98, 0.78, 0.35)


class Figures:
    def __init__(self, data, figures):
        self.data, self.figures = data, figures
        with open(data / 'errors.md') as table:
            rows = [[cell.strip() for cell in row.split('|')[1:-1]] for row in table][2:]
        self.errors = {row[0]: [float(cell) for cell in row[1:]] for row in rows}

    def render(self, name, meshes, labels, *options):
        paths = [self.data / f'{mesh}.off' for mesh in meshes]
        subprocess.run([sys.executable, pathlib.Path(__file__).with_name('render_meshes.py'), *paths, '--labels', *labels,
                        '--output', self.figures / f'{name}.png', *map(str, options)], check=True)

    def draw_teaser(self):
        self.render('teaser', [f'method_cad_part_{m}' for m in ('ground_truth', 'noisy', 'anisotropic_fitting')],
                    ['noise-free', 'noisy', 'denoised'], *PART, '--width', 400, '--height', 340)
        self.render('surface_mesh_denoising-small', [f'method_cad_part_{m}' for m in ('noisy', 'anisotropic_fitting')],
                    ['noisy', 'denoised'], *PART, '--width', 220, '--height', 190, '--columns', 1)

    def draw_noise(self):
        self.render('noise', [f'noise_{kind}' for kind in ('none', 'normal', 'random', 'impulsive')],
                    ['none', 'along normals', 'in all directions', 'impulsive'], '--width', 300, '--height', 300)

    def draw_neighborhoods(self):
        names = [f'neighborhood_{kind}_{size}' for kind in ('isotropic', 'anisotropic') for size in (12, 40, 120)]
        self.render('neighborhood', ['neighborhood'] * 6,
                    [f'{size} faces, {kind} normals' for kind in ('without', 'with') for size in (12, 40, 120)],
                    '--values', *(self.data / f'{name}.txt' for name in names), '--range', 0, 80, '--legend', 'order',
                    '--azimuth', 0, '--elevation', 40, '--center', 1, 0, 0.9, '--zoom', 2.6, '--edges',
                    '--columns', 3, '--width', 330, '--height', 260)

    def draw_parameters(self):
        for name, values in PARAMETERS.items():
            meshes = [f'parameter_cad_part_{name}_{value}' for value in ('low', 'right', 'high')]
            errors = [self.errors[mesh][0] for mesh in meshes]
            self.render(f'parameter_{name}', meshes,
                        [f'{value}:  {error:.1f} degrees' for value, error in zip(values, errors)],
                        *PART, '--width', 320, '--height', 280)

    def draw_methods(self):
        for model, view in (('cad_part', PART), ('organic_shape', [])):
            methods = {'ground_truth': 'noise-free', **METHODS}
            self.render(f'methods_{model}', [f'method_{model}_{m}' for m in methods], methods.values(), *view,
                        '--columns', 5, '--width', 240, '--height', 210)

    def write_comparison(self):
        """The meshes of the interactive comparison, with coordinates of 16 bits."""
        models = {}
        for model, title in (('cad_part', 'part'), ('organic_shape', 'organic shape')):
            meshes = {name: render_meshes.read_mesh(str(self.data / f'method_{model}_{mesh}.off'))
                      for name, mesh in (('noise-free', 'ground_truth'), ('noisy', 'noisy'), ('denoised', 'anisotropic_fitting'))}
            points = {name: numpy.array([mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())])
                      for name, mesh in meshes.items()}
            everything = numpy.concatenate(list(points.values()))
            low, high = everything.min(axis=0), everything.max(axis=0)
            mesh = meshes['noisy']
            faces = [mesh.GetCell(i).GetPointId(k) for i in range(mesh.GetNumberOfCells()) for k in range(3)]
            models[title] = {
                'faces': encoded(numpy.array(faces)),
                'points': {name: encoded(numpy.rint(65535 * ((p - (low + high) / 2) / (high - low).max() + 0.5)))
                           for name, p in points.items()}}
        (self.figures / 'comparison_meshes.js').write_text(f'const MODELS = {json.dumps(models)};\n')

    def write_tables(self, manual):
        models = ('cad_part', 'organic_shape')
        methods = [[name] + [cell for model in models for cell in self.cells(f'method_{model}_{m}')]
                   for m, name in METHODS.items()]
        replace_table(manual, 'methods', 'scripts/figures', ['method'] + [f'{measure}, {model.split("_")[0].replace("cad", "part")}' for model in models
                                                       for measure in ('E_a', 'E_v', 'flipped faces')], methods)
        parameters = [[f'`{name}`', values[i]] + [f"{self.errors[f'parameter_{model}_{name}_{level}'][0]:.2f}"
                                                  for model in ('cad_part', 'twirl', 'organic_shape')]
                      for name, values in PARAMETERS.items() for i, level in enumerate(('low', 'right', 'high'))]
        replace_table(manual, 'parameters', 'scripts/figures', ['parameter', 'value', 'E_a, part', 'E_a, twisted prism', 'E_a, organic shape'],
                      parameters)

        models = {'cad_part': 'part', 'cut_sphere': 'cut sphere', 'organic_shape': 'organic', 'cad_part_in_all_directions': 'part (2)',
                  'organic_shape_in_all_directions': 'organic (2)', 'cad_part_with_impulses': 'part (3)',
                  'coarse_cad_part': 'part (4)', 'coarse_organic_shape': 'organic (4)',
                  'cad_part_on_one_side': 'part (5)', 'uneven': 'uneven'}
        distances = ('organic_shape', 'uneven')
        ablation = []
        for stage in ('none', 'use_adaptive_neighborhoods', 'use_adaptive_degree', 'use_round_patches', 'refit_patches',
                      'use_gentle_path', 'use_linear_path', 'use_quadric_path', 'remove_tangential_noise', 'remove_impulses',
                      'locate_noise', 'refine_noise_level', 'reassign_faces', 'unfold_faces', 'preserve_volume'):
            errors = {model: self.errors[f'ablation_{model}_{stage}'] for model in models}
            ablation.append(['all stages' if stage == 'none' else f'without `{stage}`'] +
                            [f'{e[0]:.2f}' for e in errors.values()] + [f'{errors[m][1]:.3f}' for m in distances] +
                            [f"{errors['cut_sphere'][3]:.2f}"])
        replace_table(manual, 'ablation', 'scripts/figures', [''] + [f'E_a, {title}' for title in models.values()]
                      + [f'E_v, {models[m]}' for m in distances] + ['volume in %, cut sphere'], ablation)

    def cells(self, mesh):
        angular, distance, flipped, _ = self.errors[mesh]
        return [f'{angular:.2f}', f'{distance:.3f}', f'{flipped:.0f}']

    def draw_fit(self):
        lines = numpy.loadtxt(self.data / 'fit.txt')
        vertex, normal, moved, points = lines[0], lines[1], lines[2], lines[3:]
        frame = frame_with_axis(normal)
        local = (points - vertex) @ frame.T
        coefficients = fit(local)
        height = coefficients[5]
        # the picture shows what the package computes, or there is none
        if numpy.linalg.norm(vertex + height * normal - moved) > 1e-6 * numpy.linalg.norm(local, axis=1).max():
            sys.exit('fit.txt: the vertex did not move to its projection onto the fitted surface')

        radius = numpy.linalg.norm(local[:, :2], axis=1).max()
        mesh = near_faces(render_meshes.read_mesh(str(self.data / 'neighborhood.off')), vertex, 1.35 * radius)
        noisy = render_meshes.make_actor(mesh, None, True)
        noisy.GetProperty().SetOpacity(0.45)
        surface = render_meshes.make_actor(grid(vertex, frame, coefficients, 0.9 * radius), None, False)
        surface.GetProperty().SetColor(SURFACE)
        surface.GetProperty().SetOpacity(0.6)
        actors = [noisy, surface] + [sphere(p, 0.022 * radius, BLUE) for p in points]
        actors += [sphere(vertex, 0.04 * radius, RED), sphere(moved, 0.04 * radius, GREEN)]
        # from above the edge of the cube, and close up, nearly along the tangent plane; the tangents point half sideways
        side = numpy.array([0, 0, 1.]) - normal[2] * normal
        side /= numpy.linalg.norm(side)
        across = numpy.cross(normal, side)
        actors += [arrow(vertex, axis, length * radius, color)
                   for axis, length, color in ((normal, 0.6, RED), ((side + across) / math.sqrt(2), 0.35, GREY),
                                               ((side - across) / math.sqrt(2), 0.35, GREY))]
        panels = ((vertex + 0.15 * radius * normal, 0.8 * radius, side + 1.1 * normal),
                  (vertex + 0.08 * radius * normal, 0.3 * radius, side + 0.15 * normal))
        draw_panels(self.figures / 'fit.png', actors, panels, normal, (560, 400))


def encoded(numbers):
    return base64.b64encode(numbers.astype('<u2').tobytes()).decode()


def near_faces(mesh, center, radius):
    faces = vtkCellArray()
    for i in range(mesh.GetNumberOfCells()):
        corners = [mesh.GetCell(i).GetPointId(k) for k in range(3)]
        if all(numpy.linalg.norm(mesh.GetPoint(c) - center) < radius for c in corners):
            faces.InsertNextCell(3, corners)
    part = vtkPolyData()
    part.SetPoints(mesh.GetPoints())
    part.SetPolys(faces)
    return part


def frame_with_axis(normal):
    """Two tangents and the normal: the fit does not depend on the choice of the tangents."""
    axis = numpy.eye(3)[numpy.argmin(abs(normal))]
    first = numpy.cross(normal, axis)
    first /= numpy.linalg.norm(first)
    return numpy.array([first, numpy.cross(normal, first), normal])


def fit(local):
    """The coefficients a, b, c, e, f, g of the quadratic surface, by weighted least squares."""
    u, v, h = local.T
    distance = numpy.linalg.norm(local, axis=1)
    root_of_weight = numpy.exp(-distance / distance.max() / 2)
    columns = numpy.column_stack([u * u, u * v, v * v, u, v, numpy.ones_like(u)])
    return numpy.linalg.lstsq(columns * root_of_weight[:, None], h * root_of_weight, rcond=None)[0]


def grid(vertex, frame, coefficients, radius, n=48):
    """A disc of the fitted surface."""
    a, b, c, e, f, g = coefficients
    points, faces = vtkPoints(), vtkCellArray()
    for i in range(n + 1):
        for j in range(n):
            r, t = radius * i / n, 2 * math.pi * j / n
            u, v = r * math.cos(t), r * math.sin(t)
            points.InsertNextPoint(vertex + numpy.array([u, v, a*u*u + b*u*v + c*v*v + e*u + f*v + g]) @ frame)
    for i in range(n):
        for j in range(n):
            k = (j + 1) % n
            faces.InsertNextCell(4, [i*n + j, (i+1)*n + j, (i+1)*n + k, i*n + k])
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(faces)
    return surface


def plain_actor(source, color):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetAmbient(0.3)
    return actor


def sphere(center, radius, color):
    source = vtkSphereSource()
    source.SetCenter(center)
    source.SetRadius(radius)
    source.SetThetaResolution(24)
    source.SetPhiResolution(24)
    return plain_actor(source, color)


def arrow(start, axis, length, color):
    source = vtkArrowSource()
    source.SetTipResolution(24)
    source.SetShaftResolution(24)
    source.SetShaftRadius(0.018)
    source.SetTipRadius(0.05)
    source.SetTipLength(0.18)
    second = numpy.cross(axis, numpy.eye(3)[numpy.argmin(abs(axis))])
    second /= numpy.linalg.norm(second)
    third = numpy.cross(axis, second)
    transform = vtkTransform()
    matrix = numpy.eye(4)
    matrix[:3, 0], matrix[:3, 1], matrix[:3, 2], matrix[:3, 3] = length * axis, length * second, length * third, start
    transform.SetMatrix(matrix.flatten())
    turned = vtkTransformPolyDataFilter()
    turned.SetTransform(transform)
    turned.SetInputConnection(source.GetOutputPort())
    return plain_actor(turned, color)


def draw_panels(path, actors, panels, up, size):
    scale = render_meshes.SUPERSAMPLING
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(True)
    window.SetSize(scale * size[0] * len(panels), scale * size[1])
    for i, (center, half_height, direction) in enumerate(panels):
        panel = render_meshes.make_renderer(window, (i / len(panels), 0, (i + 1) / len(panels), 1), actors)
        panel.SetUseDepthPeeling(True)
        render_meshes.add_lights(panel)
        camera = panel.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(center)
        camera.SetPosition(center + 20 * half_height * direction / numpy.linalg.norm(direction))
        camera.SetViewUp(up)
        camera.SetParallelScale(half_height)
        panel.ResetCameraClippingRange()
    window.Render()
    render_meshes.write_image(window, path)


def main():
    data, folder = map(pathlib.Path, sys.argv[1:3])
    figures = Figures(data, folder)
    for draw in (figures.draw_teaser, figures.draw_noise, figures.draw_neighborhoods, figures.draw_fit,
                 figures.draw_parameters, figures.draw_methods, figures.write_comparison):
        draw()
    figures.write_tables(folder.parent / 'Surface_mesh_denoising.txt')


if __name__ == '__main__':
    main()
