#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""The documentation's pictures, made from the project's own parts: make gallery, or

    PYTHONPATH=python xvfb-run -a /usr/bin/python3 docs/make_pictures.py [steps] [gallery]

steps: docs/pictures/STEP.png, what every step of the pipeline makes of one part. gallery: docs/pictures/part-NAME.png and
part-NAME-cut.png, every own part outside and cut open, and the page docs/gallery.md with its figures.
Needs VTK (python3-vtk9), Pillow (python3-pil), an X display (xvfb-run makes one) and, for the parts, FreeCAD.
"""
import csv
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import render
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import hexfeature
from hexfeature import report

DOCS = Path(__file__).resolve().parent
PICTURES = DOCS / "pictures"
PART = "connecting_rod"  #: whose steps are drawn
SIZE, SMALL = (720, 420), (480, 340)  #: pixels
COLOURS = 64
AXIS_COLOURS = render.LABEL_COLOURS[::2]


def poly_data(points, lines=(), polygons=(), **arrays):
    """vtkPolyData of lines, then polygons (lists of node lists), with cell arrays; three floats a cell are a colour."""
    data = vtk.vtkPolyData()
    nodes = vtk.vtkPoints()
    nodes.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    data.SetPoints(nodes)
    for cells, set_cells in ((lines, data.SetLines), (polygons, data.SetPolys)):
        if not len(cells):
            continue
        array = vtk.vtkCellArray()
        for cell in cells:
            array.InsertNextCell(len(cell), [int(n) for n in cell])
        set_cells(array)
    for name, values in arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        data.GetCellData().AddArray(array)
    return data


def triangles(stage, edges=True, **arrays):
    """Actor of a stage's surface triangles, coloured by the one array given; without one pale grey."""
    data = poly_data(stage["points"], polygons=stage["triangles"], **arrays)
    return render.actor_of(data, next(iter(arrays), None), edges)


def tubes(points, lines, radius, colour=None, **arrays):
    """Actor of lines as round bars; coloured by the one cell array given, else all in `colour` (red, green, blue)."""
    bars = vtk.vtkTubeFilter()
    bars.SetInputData(poly_data(points, lines=lines, **arrays))
    bars.SetRadius(radius)
    bars.SetNumberOfSides(10)
    bars.CappingOn()
    bars.Update()
    return render.actor_of(bars.GetOutput(), next(iter(arrays), None), False, colour or (0, 0, 0))


def balls(points, radius, colour=(0.1, 0.1, 0.12)):
    """Actors of spheres."""
    actors = []
    for p in points:
        ball = vtk.vtkSphereSource()
        ball.SetCenter(*p)
        ball.SetRadius(radius)
        ball.SetThetaResolution(12)
        ball.SetPhiResolution(12)
        ball.Update()
        actors.append(render.actor_of(ball.GetOutput(), None, False, colour))
    return actors


def arrow_head(line, sign, length, rgb):
    """A cone at the middle of a polyline, pointing along it (sign +1) or against it (-1)."""
    step = np.linalg.norm(np.diff(line, axis=0), axis=1)
    along = np.concatenate([[0], np.cumsum(step)])
    k = min(np.searchsorted(along, along[-1] / 2, side="right"), len(step)) - 1
    cone = vtk.vtkConeSource()
    cone.SetCenter(*(line[k] + (along[-1] / 2 - along[k]) / max(step[k], 1e-300) * (line[k + 1] - line[k])))
    cone.SetDirection(*(sign * (line[k + 1] - line[k])))
    cone.SetHeight(length)
    cone.SetRadius(0.38 * length)
    cone.SetResolution(16)
    cone.Update()
    return render.actor_of(cone.GetOutput(), None, False, rgb)


def feature_lines(shape, points, lines, width):
    """Actors of the arcs: their axis as colour, an arrow head along the signed direction, their corners as balls."""
    actors = [tubes(points, lines, width, arc_axis=np.asarray(shape["arc_axis"]))]
    for line, axis, sign in zip(lines, shape["arc_axis"], shape["arc_sign"]):
        rgb = [0.6 * c for c in AXIS_COLOURS[axis]]
        actors.append(arrow_head(np.asarray(points)[line], sign, 9 * width, rgb))
    return actors


def polycube_faces(stage):
    """Actor of the charts at their integer coordinates: polygons (with holes) between the corners, coloured by label."""
    points = np.asarray(stage["corner_coordinates"], dtype=float)
    join = vtk.vtkAppendPolyData()
    start, end = stage["arc_start"], stage["arc_end"]
    for label, loops in zip(stage["chart_label"], stage["chart_loops"]):
        outlines = [[(end if dart % 2 else start)[dart // 2] for dart in loop] for loop in loops]
        fill = vtk.vtkContourTriangulator()
        fill.SetInputData(poly_data(points, lines=[loop + loop[:1] for loop in outlines]))
        fill.Update()
        face = fill.GetOutput()
        labels = numpy_to_vtk(np.full(face.GetNumberOfCells(), label), deep=True)
        labels.SetName("label")
        face.GetCellData().AddArray(labels)
        join.AddInputData(face)
    join.Update()
    return render.actor_of(join.GetOutput(), "label", False)


def new_sheets_apart(path, blocks_before):
    """Grid of a mesh file with the cell array colour: hexahedra of sheets stand out from those of the lattice."""
    grid = render.read(str(path))
    block = vtk_to_numpy(grid.GetCellData().GetArray("block"))
    types = vtk_to_numpy(grid.GetCellTypesArray())
    rgb = np.full((len(block), 3), 225, dtype=np.uint8)
    rgb[block >= blocks_before] = (242, 142, 43)
    colour = numpy_to_vtk(rgb, deep=True)
    colour.SetName("colour")
    grid.GetCellData().AddArray(colour)
    return render.keep_cells(grid, np.flatnonzero(types == 12))


def draw_steps(part, size, scratch):
    """One picture for every step's result."""
    mesh = hexfeature.mesh(part, size=size)
    surface, labels, shape, polycube = (mesh.stage(name) for name in ("surface", "labels", "shape", "polycube"))
    width = 0.012 * np.linalg.norm(np.ptp(surface["points"], axis=0)) / 2

    def save(name, actors, **more):
        render.save(actors, PICTURES / f"{name}.png", size=SIZE, colours=COLOURS, **more)

    cad_edges = np.asarray(surface["cad_edge"]).reshape(-1, 3)
    sides = [[t[k], t[(k + 1) % 3]] for t, on in zip(np.asarray(surface["triangles"]), cad_edges) for k in range(3) if on[k] > 0]
    vertices = np.asarray(surface["points"])[np.asarray(surface["point_dim"]) == 0]
    save("read", [triangles(surface, edges=False, cad_face=np.asarray(surface["cad_face"])),
                  tubes(surface["points"], sides, 0.4 * width), *balls(vertices, width)])
    save("surface", [triangles(surface, cad_face=np.asarray(surface["cad_face"]))])

    paper = hexfeature.mesh(part, size=size, labels="paper", stop_after="labels").stage("labels")
    adaptation = np.asarray(paper["adaptation"])
    save("adaptation", [triangles(paper, edges=False, colour=(40 + 215 * np.abs(adaptation)).clip(0, 255).astype(np.uint8))])
    save("labels-paper", [triangles(paper, edges=False, label=np.asarray(paper["label"]))])

    save("sites", [triangles(labels, edges=False, site=np.asarray(labels["site"]))])
    lines = [list(arc) for arc in shape["arcs"]]
    save("labels", [triangles(labels, edges=False, label=np.asarray(labels["label"])), tubes(shape["points"], lines, 0.4 * width)])
    corners = np.asarray(shape["points"])[shape["corners"]]
    save("shape", [triangles(shape, edges=False), *feature_lines(shape, shape["points"], lines, 0.7 * width), *balls(corners, 1.2 * width)])

    points = np.asarray(polycube["corner_coordinates"], dtype=float)
    straight = [[a, b] for a, b in zip(polycube["arc_start"], polycube["arc_end"])]
    width = 0.006 * np.linalg.norm(np.ptp(points, axis=0))
    save("polycube", [polycube_faces(polycube), *feature_lines(polycube, points, straight, width / 2), *balls(points, width)])

    for name in ("lattice", "fit", "sheets"):
        stopped = hexfeature.mesh(part, size=size, stop_after=name)
        path = scratch / f"{name}.vtk"
        stopped.write_stage(name, path)
        if name == "lattice":
            blocks = 1 + int(np.max(stopped.stage(name)["hex_block"]))
            # By label, as the polycube is.
            grid = render.read(str(path))
            chart = vtk_to_numpy(grid.GetCellData().GetArray("chart"))
            label = numpy_to_vtk(np.where(chart >= 0, np.asarray(shape["chart_label"])[chart], 0), deep=True)
            label.SetName("label")
            grid.GetCellData().AddArray(label)
            save(name, [render.actor_of(render.surface_of(render.keep_cells(grid, np.flatnonzero(chart >= 0))), "label")])
        elif name == "fit":
            render.draw(path, PICTURES / "fit.png", "cad_face", size=SIZE, colours=COLOURS)
            render.draw(path, PICTURES / "fit-cut.png", "scaled_jacobian", cut=True, size=SIZE, colours=COLOURS)
        else:
            grid = new_sheets_apart(path, blocks)
            save(name, [render.actor_of(render.surface_of(render.cut_open(grid, render.CUT)), "colour")])

    mesh.write(scratch / "smooth.vtk")
    render.draw(scratch / "smooth.vtk", PICTURES / "result.png", "cad_face", size=SIZE, colours=COLOURS)
    render.draw(scratch / "smooth.vtk", PICTURES / "smooth.png", size=SIZE, colours=COLOURS)
    render.draw(scratch / "smooth.vtk", PICTURES / "smooth-cut.png", cut=True, size=SIZE, colours=COLOURS)

    hexfeature.mesh(part, size=size, method="tet-split").write(scratch / "tet-split.vtk")
    render.draw(scratch / "tet-split.vtk", PICTURES / "tet-split.png", size=SIZE, colours=COLOURS)
    render.draw(scratch / "tet-split.vtk", PICTURES / "tet-split-cut.png", cut=True, size=SIZE, colours=COLOURS)

    # Free turns: a sharp edge inside a chart that is a quarter of a circle.
    draw = DOCS.parent / "tests" / "parts" / "make_odd_parts.py"
    subprocess.run(["/usr/bin/python3", str(draw), str(scratch), "corner_cone"], check=True, capture_output=True)
    hexfeature.mesh(scratch / "corner_cone.step", size=1.5, method="feature-line").write(scratch / "turns.vtk")
    render.draw(scratch / "turns.vtk", PICTURES / "free-turns.png", "cad_face", size=SIZE, colours=COLOURS, view=(0.6, 1.0, 1.6))

    # Second looks: the border of a fillet that the first mesh does not cover.
    subprocess.run(["/usr/bin/python3", str(draw), str(scratch), "hub"], check=True, capture_output=True)
    hexfeature.mesh(scratch / "hub.step", size=4.6, method="feature-line").write(scratch / "hub.vtk")
    render.draw(scratch / "hub.vtk", PICTURES / "recover.png", "cad_face", size=SIZE, colours=COLOURS, view=(0.3, -0.5, 1.0))


GALLERY = """# Gallery

The project's own parts (`tests/parts/make_parts.py`), meshed with the default options at the element sizes of that file, outside
and cut open. Colour is the scaled Jacobian: red 0, blue 1. Seconds are those of reading, meshing and writing on the machine that
made this page, which `make gallery` does; [benchmarks](benchmarks.md) tells times apart.

"""


def draw_gallery(folder, scratch):
    """Every part twice, and the page that shows them."""
    page = GALLERY
    with open(folder / "parts.csv", newline="") as table:
        rows = list(csv.DictReader(table))
    for row in rows:
        name = Path(row["part"]).stem
        started = time.monotonic()
        path = scratch / f"{name}.vtk"
        try:
            mesh = hexfeature.mesh(folder / row["part"], size=float(row["size"]))
            mesh.write(path)
        except hexfeature.MeshingError as error:
            page += f"## {name}\n\nNo mesh: {error}\n\n"
            continue
        seconds = time.monotonic() - started
        render.draw(path, PICTURES / f"part-{name}.png", size=SMALL, colours=COLOURS)
        render.draw(path, PICTURES / f"part-{name}-cut.png", cut=True, size=SMALL, colours=COLOURS)
        quality = mesh.report["quality"]
        page += (f"## {name}\n\n{quality['hexes']} hexahedra of size {row['size']}, "
                 f"scaled Jacobian min {quality['min_scaled_jacobian']:.3f}, mean {quality['mean_scaled_jacobian']:.3f}; "
                 f"{seconds:.2f} s\n\n"
                 f"![{name}](pictures/part-{name}.png) ![{name}, cut open](pictures/part-{name}-cut.png)\n\n")
        print(f"{name}: {report.summary(mesh.report).splitlines()[0]}", flush=True)
    (DOCS / "gallery.md").write_text(page.rstrip() + "\n", encoding="utf-8")


def main(what):
    """Draw what is asked for; returns the exit code."""
    PICTURES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        parts = Path(scratch) / "parts"
        make_parts = DOCS.parent / "tests" / "parts" / "make_parts.py"
        subprocess.run(["/usr/bin/python3", str(make_parts), str(parts)], check=True, capture_output=True)
        with open(parts / "parts.csv", newline="") as table:
            size = {Path(row["part"]).stem: float(row["size"]) for row in csv.DictReader(table)}
        if "steps" in what:
            draw_steps(parts / f"{PART}.step", size[PART], Path(scratch))
        if "gallery" in what:
            draw_gallery(parts, Path(scratch))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:] or ["steps", "gallery"]))
