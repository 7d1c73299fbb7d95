#!/usr/bin/python3
"""Draw a mesh file as PNG: outside, or cut open, coloured by scaled Jacobian, CAD face, label, ...

    xvfb-run -a /usr/bin/python3 docs/render.py MESH.vtk PICTURE.png [--cut] [--colour ARRAY] [--view X,Y,Z] [--worst N]

Needs VTK (python3-vtk9) and an X display (xvfb-run makes one). ARRAY is a cell array of the file, or
scaled_jacobian (the default for meshes with hexahedra), which is computed here.
"""
import argparse
import colorsys

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

#: a corner and its three neighbours
CORNERS = np.array([[0, 1, 3, 4], [1, 2, 0, 5], [2, 3, 1, 6], [3, 0, 2, 7], [4, 7, 5, 0], [5, 4, 6, 1], [6, 5, 7, 2], [7, 6, 4, 3]])
#: from the part to the eye
VIEW = (1.0, -1.6, 1.0)
#: what lies on this side of the middle is taken away to look inside
CUT = (0.0, -1.0, 0.0)
#: +X -X +Y -Y +Z -Z
LABEL_COLOURS = [(0.86, 0.24, 0.2), (0.95, 0.65, 0.6), (0.2, 0.62, 0.27), (0.65, 0.86, 0.62), (0.2, 0.4, 0.8), (0.62, 0.75, 0.95)]


def read(path):
    reader = vtk.vtkUnstructuredGridReader()
    reader.SetFileName(path)
    reader.ReadAllScalarsOn()
    reader.ReadAllFieldsOn()
    reader.Update()
    return reader.GetOutput()


def scaled_jacobian(points, hexes):
    """Least scaled Jacobian of the eight corners of each hexahedron; points (n, 3), hexes (m, 8)."""
    corner = points[hexes][:, CORNERS]
    edges = corner[:, :, 1:] - corner[:, :, :1]
    length = np.linalg.norm(edges, axis=3).prod(2)
    return (np.linalg.det(edges) / np.maximum(length, 1e-300)).min(1)


def add_quality(grid):
    """Cell array scaled_jacobian on the hexahedra (2 on other cells); returns the hexahedra's values."""
    types = vtk_to_numpy(grid.GetCellTypesArray())
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    nodes = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    hexes = np.flatnonzero(np.isin(types, (12, 25, 29)))
    values = np.full(len(types), 2.0)
    if len(hexes):
        values[hexes] = scaled_jacobian(points, nodes[offsets[hexes][:, None] + np.arange(8)])
    array = numpy_to_vtk(values, deep=True)
    array.SetName("scaled_jacobian")
    grid.GetCellData().AddArray(array)
    return values[hexes]


def keep_cells(grid, cells):
    ids = vtk.vtkIdList()
    for c in cells:
        ids.InsertNextId(int(c))
    extract = vtk.vtkExtractCells()
    extract.SetInputData(grid)
    extract.SetCellList(ids)
    extract.Update()
    return extract.GetOutput()


def colours_for(name, low, high):
    """Lookup table for an array of that name with values in [low, high]."""
    table = vtk.vtkLookupTable()
    if name in ("label", "arc_axis"):
        colours = LABEL_COLOURS if name == "label" else LABEL_COLOURS[::2]
        table.SetNumberOfTableValues(len(colours))
        for k, rgb in enumerate(colours):
            table.SetTableValue(k, *rgb, 1)
        table.SetTableRange(-0.5, len(colours) - 0.5)
    elif name == "scaled_jacobian":
        table.SetHueRange(0.0, 0.62)
        table.SetTableRange(0, 1)
    else:  # categories: neighbouring numbers get unlike colours
        count = int(high) + 1
        table.SetNumberOfTableValues(max(count, 1))
        for k in range(count):
            rgb = colorsys.hsv_to_rgb((0.13 + 0.618034 * k) % 1, 0.35 + 0.25 * (k % 3) / 2, 0.95)
            table.SetTableValue(k, *rgb, 1)
        table.SetTableRange(-0.5, count - 0.5)
    table.Build()
    return table


def actor_of(data, colour=None, edges=True, rgb=(0.8, 0.8, 0.82), opacity=1.0):
    """An actor of poly data: coloured by the cell array `colour` (three components: red, green, blue), else all in `rgb`."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    if colour:
        data.GetCellData().SetActiveScalars(colour)
        mapper.SetScalarModeToUseCellData()
        array = data.GetCellData().GetArray(colour)
        if array.GetNumberOfComponents() == 3:
            mapper.SetColorModeToDirectScalars()
        else:
            mapper.SetLookupTable(colours_for(colour, *array.GetRange()))
            mapper.UseLookupTableScalarRangeOn()
    else:
        mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*rgb)
    actor.GetProperty().SetOpacity(opacity)
    actor.GetProperty().SetAmbient(0.25)
    if edges:
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetEdgeColor(0.12, 0.12, 0.15)
    return actor


def surface_of(grid):
    """The outside of a grid as poly data, cell arrays kept."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    surface.Update()
    return surface.GetOutput()


def cut_open(grid, normal):
    """The cells of a grid that lie behind the plane through its middle with this normal."""
    centres = vtk.vtkCellCenters()
    centres.SetInputData(grid)
    centres.Update()
    xyz = vtk_to_numpy(centres.GetOutput().GetPoints().GetData())
    middle = 0.5 * (xyz.min(0) + xyz.max(0))
    return keep_cells(grid, np.flatnonzero((xyz - middle) @ np.array(normal) <= 1e-9 * np.ptp(xyz)))


def frame(camera, actors, view, aspect):
    """Look along `view` with all actors just in the picture."""
    back = np.array(view) / np.linalg.norm(view)
    right = np.cross((0, 0, 1), back) if abs(back[2]) < 0.999 else np.array([1.0, 0, 0])
    right /= np.linalg.norm(right)
    axes = np.array([right, np.cross(back, right), back])
    points = np.vstack([vtk_to_numpy(a.GetMapper().GetInput().GetPoints().GetData()) for a in actors]) @ axes.T
    low, high = points.min(0), points.max(0)
    middle = 0.5 * (low + high) @ axes
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*(middle + np.linalg.norm(high - low) * back))
    camera.SetViewUp(*axes[1])
    camera.SetParallelScale(0.52 * max(high[1] - low[1], (high[0] - low[0]) / aspect))


def save(actors, picture, view=VIEW, size=(1000, 800), colours=0):
    """Render actors to a PNG; with `colours` > 0 its colours are reduced to so many (python3-pil), which makes it small."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    frame(renderer.GetActiveCamera(), actors, view, size[0] / size[1])
    renderer.ResetCameraClippingRange()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(4)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(picture))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    if colours:
        from PIL import Image

        with Image.open(picture) as drawn:
            small = drawn.convert("RGB").quantize(colours)
        small.save(picture, optimize=True)


def draw(path, picture, colour=None, cut=False, view=VIEW, worst=0, size=(1000, 800), edges=True, colours=0):
    """Render one file; see the module's text."""
    grid = read(str(path))
    quality = add_quality(grid)
    colour = colour or ("scaled_jacobian" if len(quality) else "cad_face")
    types = vtk_to_numpy(grid.GetCellTypesArray())
    volume = np.isin(types, (12, 25, 29))
    shown = np.flatnonzero(volume) if volume.any() else np.arange(len(types))
    actors = []
    if worst:
        values = vtk_to_numpy(grid.GetCellData().GetArray("scaled_jacobian"))
        actors.append(actor_of(surface_of(keep_cells(grid, shown)), edges=False, rgb=(1, 1, 1), opacity=0.15))
        shown = shown[np.argsort(values[shown])[:worst]]
    elif colour not in ("scaled_jacobian", "block") and volume.any() and not cut:
        shown = np.flatnonzero(~volume)
    part = keep_cells(grid, shown)
    if cut:
        part = cut_open(part, CUT)
    actors.append(actor_of(surface_of(part), colour, edges))
    save(actors, picture, view, size, colours)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("picture")
    parser.add_argument("--colour")
    parser.add_argument("--cut", action="store_true", help="cut open: only what lies beyond the middle in y")
    parser.add_argument("--view", default=",".join(map(str, VIEW)), help="direction from the part to the eye")
    parser.add_argument("--worst", type=int, default=0, help="show the N worst hexahedra inside the ghost of the part")
    a = parser.parse_args()
    draw(a.mesh, a.picture, a.colour, a.cut, tuple(float(v) for v in a.view.split(",")), a.worst)


if __name__ == "__main__":
    main()
