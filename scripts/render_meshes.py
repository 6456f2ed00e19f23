#!/usr/bin/python3
"""Renders meshes side by side into one PNG: flat shading, one camera, a label under each mesh.

Needs VTK for Python (Debian: python3-vtk9) and a display; without one, run it by xvfb-run -a.
"""

import argparse
import math
import pathlib
import sys

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkBoundingBox, vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction, vtkLight, vtkPolyDataMapper, vtkRenderer,
                                         vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter)
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

SUPERSAMPLING = 2
MESH_COLOR = (0.70, 0.77, 0.86)
# dark blue to yellow, as bright as the value is large, so that it also reads in grey
COLORS = [(0.267, 0.005, 0.329), (0.229, 0.322, 0.546), (0.128, 0.567, 0.551), (0.369, 0.789, 0.383),
          (0.993, 0.906, 0.144)]


def read_off(path):
    with open(path) as file:
        words = iter([word for line in file for word in line.split('#')[0].split()])
    header = next(words)
    if header != 'OFF':
        raise ValueError('not a plain OFF file')
    n_points, n_faces, _ = (int(next(words)) for _ in range(3))
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for _ in range(n_points):
        points.InsertNextPoint([float(next(words)) for _ in range(3)])
    faces = vtkCellArray()
    for _ in range(n_faces):
        corners = [int(next(words)) for _ in range(int(next(words)))]
        faces.InsertNextCell(len(corners), corners)
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(faces)
    return mesh


def read_mesh(path):
    readers = {'.ply': vtkPLYReader, '.obj': vtkOBJReader, '.stl': vtkSTLReader}
    suffix = pathlib.Path(path).suffix.lower()
    if not pathlib.Path(path).is_file():
        raise ValueError('cannot be read')
    if suffix == '.off':
        mesh = read_off(path)
    elif suffix in readers:
        reader = readers[suffix]()
        reader.SetFileName(str(path))
        reader.Update()
        mesh = reader.GetOutput()
    else:
        raise ValueError('the name must end in .off, .ply, .obj or .stl')
    if mesh.GetNumberOfCells() == 0:
        raise ValueError('holds no faces')
    triangles = vtkTriangleFilter()
    triangles.SetInputData(mesh)
    triangles.Update()
    mesh = triangles.GetOutput()
    # no normals of vertices: they would smooth the shading
    mesh.GetPointData().SetNormals(None)
    mesh.GetCellData().SetNormals(None)
    return mesh


def attach_values(mesh, path):
    """Colours the mesh by the numbers in a text file, one for each vertex or one for each face."""
    with open(path) as file:
        values = [float(word) for word in file.read().split()]
    array = vtkDoubleArray()
    for value in values:
        array.InsertNextValue(value)
    if len(values) == mesh.GetNumberOfPoints():
        mesh.GetPointData().SetScalars(array)
    elif len(values) == mesh.GetNumberOfCells():
        mesh.GetCellData().SetScalars(array)
    else:
        raise ValueError(f'{len(values)} numbers for {mesh.GetNumberOfPoints()} vertices '
                         f'and {mesh.GetNumberOfCells()} faces')
    return values


class View:
    """A direction to look in, and what shows all of the meshes in that direction."""

    def __init__(self, meshes, azimuth, elevation, up):
        a, e = math.radians(azimuth), math.radians(elevation)
        right = (-math.sin(a), math.cos(a), 0)
        upwards = (-math.sin(e) * math.cos(a), -math.sin(e) * math.sin(a), math.cos(e))
        towards_camera = (math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e))
        shift = 'zyx'.index(up)  # a cyclic change of the axes makes `up` the vertical one
        self.axes = [axis[shift:] + axis[:shift] for axis in (right, upwards, towards_camera)]

        rotation = vtkTransform()
        rotation.SetMatrix([*self.axes[0], 0, *self.axes[1], 0, *self.axes[2], 0, 0, 0, 0, 1])
        box = vtkBoundingBox()
        for mesh in meshes:
            rotate = vtkTransformPolyDataFilter()
            rotate.SetTransform(rotation)
            rotate.SetInputData(mesh)
            rotate.Update()
            box.AddBounds(rotate.GetOutput().GetBounds())
        middle = [0, 0, 0]
        box.GetCenter(middle)
        self.center = [sum(m * axis[k] for m, axis in zip(middle, self.axes)) for k in range(3)]
        self.size = [box.GetLength(k) for k in range(3)]

    def half_height(self, aspect):
        """Half the height of a panel, with a little room around the meshes."""
        return 0.52 * max(self.size[1], self.size[0] / aspect)

    def look(self, renderer, center, half_height):
        depth = self.size[2] + max(self.size)
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(center)
        camera.SetPosition([c + 2 * depth * t for c, t in zip(center, self.axes[2])])
        camera.SetViewUp(self.axes[1])
        camera.SetParallelScale(half_height)
        camera.SetClippingRange(depth, 3 * depth)


def add_lights(renderer):
    """A strong light from the upper left that grazes the surface, and weak ones that lighten its shadows."""
    renderer.AutomaticLightCreationOff()
    for position, intensity in (((-1.2, 1.1, 0.9), 0.85), ((0.6, -0.1, 1), 0.32), ((0.2, 0.6, -0.4), 0.15)):
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(position)
        light.SetFocalPoint(0, 0, 0)
        light.SetIntensity(intensity)
        renderer.AddLight(light)


def make_actor(mesh, color_map, with_edges):
    has_values = bool(mesh.GetPointData().GetScalars() or mesh.GetCellData().GetScalars())
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.SetScalarVisibility(has_values)
    if has_values:
        mapper.SetLookupTable(color_map)
    actor = vtkActor()
    actor.SetMapper(mapper)
    surface = actor.GetProperty()
    surface.SetInterpolationToFlat()
    surface.SetColor(MESH_COLOR)
    # shadows must not be taken for values
    surface.SetAmbient(0.4 if has_values else 0.12)
    surface.SetDiffuse(0.65 if has_values else 0.9)
    surface.SetSpecular(0.12)
    surface.SetSpecularPower(25)
    if with_edges:
        surface.EdgeVisibilityOn()
        surface.SetEdgeColor(0.15, 0.15, 0.2)
        surface.SetLineWidth(0.8 * SUPERSAMPLING)
    return actor


def make_text(text, size):
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.SetTextScaleModeToNone()
    style = actor.GetTextProperty()
    style.SetFontFamilyToArial()
    style.SetFontSize(size)
    style.SetColor(0.1, 0.1, 0.1)
    style.SetJustificationToCentered()
    style.SetVerticalJustificationToCentered()
    return actor


def make_renderer(window, viewport, actors=()):
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.SetViewport(*viewport)
    for actor in actors:
        renderer.AddActor(actor)
    window.AddRenderer(renderer)
    return renderer


def make_color_map(low, high):
    color_map = vtkColorTransferFunction()
    for i, color in enumerate(COLORS):
        color_map.AddRGBPoint(low + (high - low) * i / (len(COLORS) - 1), *color)
    color_map.SetNanColor(0.6, 0.6, 0.6)
    return color_map


def make_legend(color_map, title, size):
    legend = vtkScalarBarActor()
    legend.SetLookupTable(color_map)
    legend.SetTitle(title)
    legend.SetNumberOfLabels(5)
    legend.SetMaximumNumberOfColors(256)
    legend.SetLabelFormat('%.2g')
    legend.SetTextPad(4)
    legend.SetPosition(0.1, 0.08)
    legend.SetWidth(0.85)
    legend.SetHeight(0.84)
    legend.SetBarRatio(0.25)
    legend.SetUnconstrainedFontSize(True)
    for style in (legend.GetTitleTextProperty(), legend.GetLabelTextProperty()):
        style.SetFontFamilyToArial()
        style.SetFontSize(size)
        style.SetColor(0.1, 0.1, 0.1)
        style.BoldOff()
        style.ItalicOff()
        style.ShadowOff()
    return legend


def write_image(window, path):
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.Update()
    smaller = vtkImageShrink3D()
    smaller.SetInputConnection(image.GetOutputPort())
    smaller.SetShrinkFactors(SUPERSAMPLING, SUPERSAMPLING, 1)
    smaller.AveragingOn()
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(smaller.GetOutputPort())
    pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
    writer.Write()


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('meshes', nargs='+', help='.off, .ply, .obj or .stl files, one for each panel')
    parser.add_argument('-o', '--output', default='meshes.png', help='the picture (default: %(default)s)')
    parser.add_argument('-l', '--labels', nargs='+', help='one for each mesh (default: from the names of the files)')
    parser.add_argument('--azimuth', type=float, default=-60, help='degrees around the vertical (default: %(default)s)')
    parser.add_argument('--elevation', type=float, default=25, help='degrees above the horizon (default: %(default)s)')
    parser.add_argument('--up', choices='xyz', default='z', help='the axis that points upwards (default: %(default)s)')
    parser.add_argument('--zoom', type=float, default=1, help='enlarges the middle (default: %(default)s)')
    parser.add_argument('--center', type=float, nargs=3, metavar=('X', 'Y', 'Z'),
                        help='the point to show in the middle (default: the middle of the meshes)')
    parser.add_argument('--inset', type=float, nargs=4, metavar=('X', 'Y', 'Z', 'RADIUS'),
                        help='also show the neighborhood of a point, enlarged, in a corner of each panel')
    parser.add_argument('--inset-corner', default='lower-right', help='where (default: %(default)s)',
                        choices=['lower-left', 'lower-right', 'upper-left', 'upper-right'])
    parser.add_argument('--edges', action='store_true', help='draw the edges of the faces')
    parser.add_argument('--values', nargs='+', metavar='FILE',
                        help='colour each mesh by the numbers in a text file, for its vertices or faces; - for none')
    parser.add_argument('--range', type=float, nargs=2, metavar=('LOW', 'HIGH'),
                        help='the values at the ends of the colour scale (default: those of all meshes)')
    parser.add_argument('--legend', default='', help='the title of the colour scale')
    parser.add_argument('--columns', type=int, help='panels in a row (default: all)')
    parser.add_argument('--camera-per-row', action='store_true',
                        help='let the meshes of each row fill their panels (default: the same scale everywhere)')
    parser.add_argument('--width', type=int, default=640, help='pixels of one panel (default: %(default)s)')
    parser.add_argument('--height', type=int,
                        help='the same, without the label (default: what the meshes need)')
    arguments = parser.parse_args()

    n = len(arguments.meshes)
    if arguments.labels is None:
        arguments.labels = [pathlib.Path(m).stem.replace('_', ' ') for m in arguments.meshes]
    for name, given in (('labels', arguments.labels), ('values', arguments.values)):
        if given is not None and len(given) != n:
            parser.error(f'{len(given)} {name} for {n} meshes')
    if arguments.columns is None:
        arguments.columns = n
    if arguments.columns < 1 or arguments.zoom <= 0 or min(arguments.width, arguments.height or 16) < 16:
        parser.error('--columns and --zoom must be positive, --width and --height at least 16')
    return arguments


def render(arguments):
    meshes, values = [], []
    for i, path in enumerate(arguments.meshes):
        try:
            meshes.append(read_mesh(path))
        except (OSError, ValueError, StopIteration) as error:
            sys.exit(f'{path}: {error}')
        if arguments.values and arguments.values[i] != '-':
            try:
                values.append(attach_values(meshes[-1], arguments.values[i]))
            except (OSError, ValueError) as error:
                sys.exit(f'{arguments.values[i]}: {error}')

    color_map = None
    if values:
        low, high = arguments.range or (min(map(min, values)), max(map(max, values)))
        color_map = make_color_map(low, high)

    columns = min(arguments.columns, len(meshes))
    rows = (len(meshes) + columns - 1) // columns
    directions = (arguments.azimuth, arguments.elevation, arguments.up)
    if arguments.camera_per_row:
        views = [View(meshes[row * columns:(row + 1) * columns], *directions) for row in range(rows)]
    else:
        views = [View(meshes, *directions)] * rows

    width = SUPERSAMPLING * arguments.width
    if arguments.height:
        height = SUPERSAMPLING * arguments.height
    else:
        height = round(width * min(1.25, max(0.4, *(view.size[1] / view.size[0] for view in views))))
    label_height = SUPERSAMPLING * 48
    legend_width = SUPERSAMPLING * 130 if values else 0
    total = (columns * width + legend_width, rows * (height + label_height))

    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetSize(*total)

    make_renderer(window, (0, 0, 1, 1))  # white where there is no panel

    def viewport(left, bottom, right, top):
        return left / total[0], bottom / total[1], right / total[0], top / total[1]

    for i, (mesh, label) in enumerate(zip(meshes, arguments.labels)):
        row, column = divmod(i, columns)
        left, bottom = column * width, (rows - 1 - row) * (height + label_height)
        view = views[row]
        actor = make_actor(mesh, color_map, arguments.edges)

        text = make_text(label, SUPERSAMPLING * 24)
        text.SetPosition(width / 2, label_height / 2)
        make_renderer(window, viewport(left, bottom, left + width, bottom + label_height), [text])

        panel = make_renderer(window, viewport(left, bottom + label_height, left + width,
                                               bottom + label_height + height), [actor])
        add_lights(panel)
        view.look(panel, arguments.center or view.center, view.half_height(width / height) / arguments.zoom)

        if arguments.inset:
            side, margin, frame_width = 0.42 * min(width, height), SUPERSAMPLING * 6, SUPERSAMPLING
            vertical, horizontal = arguments.inset_corner.split('-')
            x = left + (margin if horizontal == 'left' else width - side - margin)
            y = bottom + label_height + (margin if vertical == 'lower' else height - side - margin)
            frame = make_renderer(window, viewport(x - frame_width, y - frame_width,
                                                   x + side + frame_width, y + side + frame_width))
            frame.SetBackground(0.3, 0.3, 0.3)
            detail = make_renderer(window, viewport(x, y, x + side, y + side), [actor])
            add_lights(detail)
            view.look(detail, arguments.inset[:3], arguments.inset[3])

    if values:
        legend = make_legend(color_map, arguments.legend, SUPERSAMPLING * 18)
        make_renderer(window, viewport(columns * width, label_height, total[0], total[1]), [legend])

    window.Render()
    write_image(window, arguments.output)


if __name__ == '__main__':
    render(parse_arguments())
