#!/usr/bin/python3
"""Draw a mesh file as PNG: outside, or cut open, coloured by scaled Jacobian, CAD face, label, ...

    xvfb-run -a /usr/bin/python3 docs/render.py MESH.vtk PICTURE.png [--cut] [--colour ARRAY] [--view X,Y,Z] [--worst N]

Needs VTK (python3-vtk9) and an X display (xvfb-run makes one). ARRAY is a cell array of the file, or
scaled_jacobian (the default for meshes with hexahedra), which is computed here.
"""
import argparse

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

#: a corner and its three neighbours
CORNERS = np.array([[0, 1, 3, 4], [1, 2, 0, 5], [2, 3, 1, 6], [3, 0, 2, 7], [4, 7, 5, 0], [5, 4, 6, 1], [6, 5, 7, 2], [7, 6, 4, 3]])
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
    table = vtk.vtkLookupTable()
    if name == "label":
        table.SetNumberOfTableValues(6)
        for k, rgb in enumerate(LABEL_COLOURS):
            table.SetTableValue(k, *rgb, 1)
        table.SetTableRange(-0.5, 5.5)
    elif name == "scaled_jacobian":
        table.SetHueRange(0.0, 0.62)
        table.SetTableRange(0, 1)
    else:  # categories: neighbouring numbers get unlike colours
        count = int(high) + 1
        table.SetNumberOfTableValues(max(count, 1))
        for k in range(count):
            rgb = vtk.vtkMath.HSVToRGB((0.13 + 0.618034 * k) % 1, 0.35 + 0.25 * (k % 3) / 2, 0.95)
            table.SetTableValue(k, *rgb, 1)
        table.SetTableRange(-0.5, count - 0.5)
    table.Build()
    return table


def draw(path, picture, colour=None, cut=False, view=(1.0, -1.6, 1.0), worst=0, size=(1000, 800), edges=True):
    """Render one file; see the module's text."""
    grid = read(path)
    quality = add_quality(grid)
    colour = colour or ("scaled_jacobian" if len(quality) else "cad_face")
    types = vtk_to_numpy(grid.GetCellTypesArray())
    volume = np.isin(types, (12, 25, 29))
    shown = np.flatnonzero(volume) if volume.any() else np.arange(len(types))
    if worst:
        values = vtk_to_numpy(grid.GetCellData().GetArray("scaled_jacobian"))
        outline = keep_cells(grid, shown)
        shown = shown[np.argsort(values[shown])[:worst]]
    elif colour != "scaled_jacobian" and volume.any() and not cut:
        shown = np.flatnonzero(~volume)
    part = keep_cells(grid, shown)
    if cut:
        centres = vtk.vtkCellCenters()
        centres.SetInputData(part)
        centres.Update()
        xyz = vtk_to_numpy(centres.GetOutput().GetPoints().GetData())
        middle = 0.5 * (xyz.min(0) + xyz.max(0))
        normal = np.array(view) * (1, 1, 0.35)
        part = keep_cells(part, np.flatnonzero((xyz - middle) @ normal <= 1e-9 * np.ptp(xyz)))
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(part)
    surface.Update()
    surface = surface.GetOutput()
    surface.GetCellData().SetActiveScalars(colour)
    low, high = surface.GetCellData().GetArray(colour).GetRange()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetScalarModeToUseCellData()
    mapper.SetLookupTable(colours_for(colour, low, high))
    mapper.UseLookupTableScalarRangeOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    if edges:
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetEdgeColor(0.12, 0.12, 0.15)
    actor.GetProperty().SetAmbient(0.25)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    if worst:
        ghost_surface = vtk.vtkDataSetSurfaceFilter()
        ghost_surface.SetInputData(outline)
        ghost = vtk.vtkActor()
        ghost_mapper = vtk.vtkPolyDataMapper()
        ghost_mapper.SetInputConnection(ghost_surface.GetOutputPort())
        ghost_mapper.ScalarVisibilityOff()
        ghost.SetMapper(ghost_mapper)
        ghost.GetProperty().SetOpacity(0.15)
        renderer.AddActor(ghost)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*view)
    camera.SetViewUp(0, 0, 1)
    camera.ParallelProjectionOn()
    renderer.ResetCamera()
    camera.Zoom(1.25)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(4)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("picture")
    parser.add_argument("--colour")
    parser.add_argument("--cut", action="store_true", help="cut open")
    parser.add_argument("--view", default="1,-1.6,1", help="direction from the part to the eye")
    parser.add_argument("--worst", type=int, default=0, help="show the N worst hexahedra inside the ghost of the part")
    a = parser.parse_args()
    draw(a.mesh, a.picture, a.colour, a.cut, tuple(float(v) for v in a.view.split(",")), a.worst)


if __name__ == "__main__":
    main()
