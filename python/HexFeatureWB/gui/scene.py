# HexFeatureWB - LGPL-2.1-or-later
"""Arrays to Coin nodes for the 3D view, and the colours of element quality."""
import numpy as np
from pivy import coin

#: scaled Jacobian 0, 0.25, 0.5, 0.75, 1 -> red to blue: readable by the colour-blind, blue is best
QUALITY_STOPS = np.array([[0.70, 0.05, 0.10], [0.94, 0.45, 0.22], [0.98, 0.86, 0.45], [0.50, 0.75, 0.82], [0.16, 0.36, 0.70]])
LEVELS = 64


def quality_levels(scaled_jacobian):
    """Index of the colour of each value in quality_colours(); below 0 is as 0."""
    return np.clip((np.asarray(scaled_jacobian) * LEVELS).astype(int), 0, LEVELS - 1)


def quality_colours():
    """(LEVELS, 3) colours from the worst to the best."""
    at = (np.arange(LEVELS) + 0.5) / LEVELS
    return np.stack([np.interp(at, np.linspace(0, 1, len(QUALITY_STOPS)), QUALITY_STOPS[:, k]) for k in range(3)], axis=1)


def compact(points, polygons):
    """Only the points that are used, and the polygons (n, k) with the new numbers."""
    used, inverse = np.unique(polygons, return_inverse=True)
    return np.asarray(points)[used], inverse.reshape(np.shape(polygons))


def compact_lines(points, polylines):
    """The same for polylines, lists of numbers of points."""
    used, inverse = np.unique(np.concatenate(polylines) if polylines else np.zeros(0, dtype=int), return_inverse=True)
    ends = np.cumsum([len(line) for line in polylines])[:-1]
    return np.asarray(points)[used], [line.tolist() for line in np.split(inverse, ends)] if polylines else []


def sides(quads):
    """(n, 2) the sides of quadrilaterals, each once."""
    ends = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    return np.unique(ends, axis=0) if len(ends) else ends


def _coordinates(points):
    node = coin.SoCoordinate3()
    node.point.setValues(0, len(points), np.asarray(points, dtype=float).tolist())
    return node


def _indices(rows):
    """Rows of node numbers -> Coin's flat list, each row ended by -1."""
    rows = np.asarray(rows)
    return np.column_stack([rows, np.full(len(rows), -1)]).ravel().tolist() if len(rows) else []


def faces(points, polygons, colour_of, colours):
    """Polygons (n, 3 or 4), polygon k in colours[colour_of[k]], each with one normal."""
    root = _lit(0.0)
    material = coin.SoMaterial()
    material.diffuseColor.setValues(0, len(colours), np.asarray(colours, dtype=float).tolist())
    binding = coin.SoMaterialBinding()
    binding.value = coin.SoMaterialBinding.PER_FACE_INDEXED
    shape = _face_set(polygons)
    chosen = np.asarray(colour_of, dtype=int).tolist()
    shape.materialIndex.setValues(0, len(chosen), chosen)
    shape.materialIndex.setNum(len(chosen))
    for node in (material, binding, _coordinates(points), shape):
        root.addChild(node)
    return root


def patches(points, triangles, colour_of, colours):
    """Triangles (n, 3), triangle k in colours[colour_of[k]], smooth where they meet at small angles; drawn faster than by `faces`: Coin
    sends a set of one colour as a whole."""
    root = _lit(0.5)
    root.addChild(_coordinates(points))
    for number in np.unique(colour_of):
        material = coin.SoMaterial()
        material.diffuseColor = tuple(map(float, colours[number]))
        root.addChild(material)
        root.addChild(_face_set(triangles[colour_of == number]))
    return root


def _lit(crease_angle):
    """What stands before faces."""
    root = coin.SoSeparator()
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    hints.creaseAngle = crease_angle
    # FreeCAD's headlight alone leaves faces that are seen aslant dark, and colours are to be read here.
    lamp = coin.SoDirectionalLight()
    lamp.direction = (-0.4, 0.5, -0.8)
    lamp.intensity = 0.45
    offset = coin.SoPolygonOffset()  # behind the lines that are drawn on it
    for node in (lamp, hints, offset):
        root.addChild(node)
    return root


def _face_set(polygons):
    shape = coin.SoIndexedFaceSet()
    index = _indices(polygons)
    shape.coordIndex.setValues(0, len(index), index)
    shape.coordIndex.setNum(len(index))
    return shape


def lines(points, polylines, width, colour_of=None, colours=((0.08, 0.08, 0.10),)):
    """Polylines (an array (n, 2) of edges, or lists of node numbers), unlit; polyline k in colours[colour_of[k]]."""
    root = coin.SoSeparator()
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    style = coin.SoDrawStyle()
    style.lineWidth = width
    material = coin.SoMaterial()
    material.diffuseColor.setValues(0, len(colours), [tuple(map(float, c)) for c in colours])
    binding = coin.SoMaterialBinding()
    shape = coin.SoIndexedLineSet()
    if isinstance(polylines, np.ndarray):
        index = _indices(polylines)
    else:
        index = [int(n) for line in polylines for n in (*line, -1)]
    shape.coordIndex.setValues(0, len(index), index)
    shape.coordIndex.setNum(len(index))
    if colour_of is None:
        binding.value = coin.SoMaterialBinding.OVERALL
    else:
        binding.value = coin.SoMaterialBinding.PER_FACE_INDEXED  # of a line set: one colour a polyline
        chosen = [int(c) for c in colour_of]
        shape.materialIndex.setValues(0, len(chosen), chosen)
        shape.materialIndex.setNum(len(chosen))
    for node in (light, style, material, binding, _coordinates(points), shape):
        root.addChild(node)
    return root


def group():
    return coin.SoSeparator()


def unpickable(*nodes):
    """A group that the mouse does not see: the objects underneath stay selectable."""
    root = coin.SoSeparator()
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    root.addChild(style)
    for node in nodes:
        root.addChild(node)
    return root


def in_front(node):
    """Drawn over everything, also where something stands before it."""
    root = coin.SoAnnotation()
    root.addChild(node)
    return root


def on_screen(*nodes):
    """Drawn in front of everything in window coordinates, -1 to 1 in both directions; not counted by 'fit all'."""
    kind = coin.SoType.fromName("SoSkipBoundingGroup")
    outer = kind.createInstance() if not kind.isBad() else coin.SoGroup()
    front = coin.SoAnnotation()
    camera = coin.SoOrthographicCamera()
    camera.position = (0, 0, 1)
    camera.height = 2
    camera.nearDistance = 0.1
    camera.farDistance = 10
    camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    front.addChild(camera)
    front.addChild(light)
    for node in nodes:
        front.addChild(node)
    outer.addChild(front)
    return unpickable(outer)


def colour_bar(title, text_colour=(1, 1, 1)):
    """The scale of element quality at the window's right border, 0 at the bottom and 1 on top."""
    left, right, low, high = 0.87, 0.905, -0.72, 0.18
    heights = np.linspace(low, high, LEVELS + 1)
    points = [(x, y, 0.0) for y in heights for x in (left, right)]
    quads = [[2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2] for k in range(LEVELS)]
    bar = faces(points, quads, np.arange(LEVELS), quality_colours())
    nodes = [bar]
    for value in (0, 0.25, 0.5, 0.75, 1):
        nodes.append(_text("%g" % value, right + 0.015, low + (high - low) * value - 0.012, text_colour))
    for k, line in enumerate(reversed(title.split("\n"))):
        nodes.append(_text(line, 0.985, high + 0.05 + 0.06 * k, text_colour, coin.SoText2.RIGHT))
    return on_screen(*nodes)


def _text(string, x, y, colour, justification=coin.SoText2.LEFT):
    root = coin.SoSeparator()
    place = coin.SoTranslation()
    place.translation = (x, y, 0.0)
    ink = coin.SoBaseColor()
    ink.rgb = colour
    font = coin.SoFont()
    font.size = 15
    text = coin.SoText2()
    text.string = string
    text.justification = justification
    for node in (place, ink, font, text):
        root.addChild(node)
    return root
