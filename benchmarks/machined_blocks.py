#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""A family of machined blocks, drawn by chance: benchmarks/machined_blocks.py OUT_DIR [--count 300] [--seed 1]

Each part is a box of 40..80 mm a side with 1 to 12 features: slots, steps, pockets, holes (also oblique ones), bosses, ribs,
chamfers, fillets. Part NNNN depends on the seed and its number alone. A feature that OpenCASCADE cannot make, that leaves no single
valid solid, or a wall thinner than half an element beside a feature's box is drawn anew.
Leaves OUT_DIR/block_NNNN.step and OUT_DIR/parts.csv (columns part, size, features). Lengths in mm.
"""
import argparse
import csv
import math
import os
import random
import sys

sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
import FreeCAD  # noqa: E402  before Part, or Part crashes outside FreeCAD
import Part  # noqa: E402

V = FreeCAD.Vector
SIZE = 4.0  # of the elements to mesh with
TRIES = 20  # for one feature


class Block:
    """The part as drawn so far: its solid and its features' names."""

    def __init__(self, chance):
        self.chance = chance
        self.sides = [chance.uniform(40, 80) for _ in range(3)]
        self.solid = Part.makeBox(*self.sides)
        self.features = []

    def size(self, low, high):
        """A length, to half a millimetre, as a designer would choose it."""
        return round(2 * self.chance.uniform(low, high)) / 2

    def place(self, shape):
        """Turn a feature drawn from above (+Z, origin at the middle of the top face) onto a side of the box chosen by chance;
        returns the shape, the half widths of that side and the depth under it are `self.span`'s."""
        axis, sign = self.side
        centre = V(*[s / 2 for s in self.sides])
        outward = V(*[sign if k == axis else 0 for k in range(3)])
        shape.Placement = FreeCAD.Placement(centre + outward * (self.sides[axis] / 2), FreeCAD.Rotation(V(0, 0, 1), outward))
        return shape

    def choose_side(self):
        """Choose the side that the next feature is drawn on; returns half widths and depth in the feature's own frame."""
        self.side = (self.chance.randrange(3), self.chance.choice((-1, 1)))
        axis, sign = self.side
        outward = V(*[sign if k == axis else 0 for k in range(3)])
        turn = FreeCAD.Rotation(V(0, 0, 1), outward)
        spans = [abs(turn.multVec(u).dot(V(*self.sides))) for u in (V(1, 0, 0), V(0, 1, 0))]
        return spans[0], spans[1], self.sides[axis]

    # ------------------------------------------------------------ features: each returns the new solid
    def slot(self):
        a, b, depth = self.choose_side()
        wide, deep = self.size(6, 0.3 * a), self.size(5, 0.4 * depth)
        x = self.size(-0.5 * a + 4 + wide / 2, 0.5 * a - 4 - wide / 2)
        return self.solid.cut(self.place(Part.makeBox(wide, b + 2, deep + 1, V(x - wide / 2, -b / 2 - 1, -deep))))

    def step(self):
        a, b, depth = self.choose_side()
        wide, deep = self.size(5, 0.35 * a), self.size(5, 0.4 * depth)
        x = self.chance.choice((-a / 2 - 1, a / 2 - wide))
        return self.solid.cut(self.place(Part.makeBox(wide + 1, b + 2, deep + 1, V(x, -b / 2 - 1, -deep))))

    def pocket(self):
        a, b, depth = self.choose_side()
        wide, long, deep = self.size(8, 0.5 * a), self.size(8, 0.5 * b), self.size(4, 0.5 * depth)
        x, y = self.size(-a / 2 + 4, a / 2 - 4 - wide), self.size(-b / 2 + 4, b / 2 - 4 - long)
        tool = Part.makeBox(wide, long, deep + 1, V(x, y, -deep))
        if self.chance.random() < 0.5:  # the mill's radius in the corners
            upright = [e for e in tool.Edges if abs(e.tangentAt(e.FirstParameter).z) > 0.9]
            tool = tool.makeFillet(self.size(1.5, 0.3 * min(wide, long)), upright)
        return self.solid.cut(self.place(tool))

    def hole(self):
        a, b, depth = self.choose_side()
        radius = self.size(2, 7)
        deep = depth + 2 if self.chance.random() < 0.6 else self.size(6, 0.6 * depth)
        x, y = self.size(-a / 2 + radius + 3, a / 2 - radius - 3), self.size(-b / 2 + radius + 3, b / 2 - radius - 3)
        return self.solid.cut(self.place(Part.makeCylinder(radius, deep + 1, V(x, y, 1), V(0, 0, -1))))

    def oblique_hole(self):
        a, b, depth = self.choose_side()
        radius = self.size(2, 6)
        tilt, turn = math.radians(self.chance.uniform(15, 50)), self.chance.uniform(0, 2 * math.pi)
        along = V(math.sin(tilt) * math.cos(turn), math.sin(tilt) * math.sin(turn), -math.cos(tilt))
        reach = 1.5 * radius / math.cos(tilt)
        x, y = self.size(-a / 2 + reach + 2, a / 2 - reach - 2), self.size(-b / 2 + reach + 2, b / 2 - reach - 2)
        deep = 250 if self.chance.random() < 0.7 else self.size(10, 0.5 * depth)
        tool = Part.makeCylinder(radius, deep + 20, V(x, y, 0) - along * 20, along)
        return self.solid.cut(self.place(tool))

    def boss(self):
        a, b, depth = self.choose_side()
        high = self.size(4, 15)
        if self.chance.random() < 0.6:
            radius = self.size(4, 0.2 * min(a, b))
            x, y = self.size(-a / 2 + radius + 2, a / 2 - radius - 2), self.size(-b / 2 + radius + 2, b / 2 - radius - 2)
            tool = Part.makeCylinder(radius, high + 1, V(x, y, -1))
        else:
            wide, long = self.size(6, 0.4 * a), self.size(6, 0.4 * b)
            x, y = self.size(-a / 2 + 2, a / 2 - 2 - wide), self.size(-b / 2 + 2, b / 2 - 2 - long)
            tool = Part.makeBox(wide, long, high + 1, V(x, y, -1))
        return self.solid.fuse(self.place(tool)).removeSplitter()

    def rib(self):
        a, b, depth = self.choose_side()
        thick, high = self.size(4, 8), self.size(6, 15)
        x = self.size(-a / 2 + 2, a / 2 - 2 - thick)
        long = b if self.chance.random() < 0.5 else self.size(0.4 * b, 0.8 * b)
        tool = Part.makeBox(thick, long, high + 1, V(x, -long / 2, -1))
        return self.solid.fuse(self.place(tool)).removeSplitter()

    def _edges(self, radius):
        """A straight edge chosen by chance, longer than the radius, perhaps with those parallel to it on the same faces."""
        lines = [e for e in self.solid.Edges if isinstance(e.Curve, (Part.Line, Part.LineSegment)) and e.Length > 3 * radius]
        return [self.chance.choice(lines)] if lines else []

    def chamfer(self):
        width = self.size(1.5, 6)
        return self.solid.makeChamfer(width, self._edges(width))

    def fillet(self):
        radius = self.size(1.5, 8)
        return self.solid.makeFillet(radius, self._edges(radius))

    KINDS = ("slot", "step", "pocket", "hole", "hole", "oblique_hole", "boss", "rib", "chamfer", "fillet")

    def add(self):
        """One more feature; chamfers and fillets come last in a shop, but here they come as they fall."""
        kind = self.chance.choice(self.KINDS)
        for _ in range(TRIES):
            try:
                made = getattr(self, kind)()
            except Exception:  # OpenCASCADE's own errors: no such fillet, no common curve ...
                continue
            if len(made.Solids) != 1 or not made.isValid() or not sound(made) or abs(made.Volume - self.solid.Volume) < 20:
                continue
            self.solid = made.Solids[0]
            self.features.append(kind)
            return


def sound(shape):
    """No edge and no face so small that a draughtsman would call it a mistake."""
    return all(e.Length > 0.3 for e in shape.Edges if not e.Degenerated) and all(f.Area > 0.3 for f in shape.Faces)


def draw(seed, number):
    """Part `number` of the family."""
    block = Block(random.Random(f"{seed} {number}"))
    for _ in range(block.chance.randint(1, 12)):
        block.add()
    return block


def main(out, count, seed):
    """Draw the family into a folder."""
    os.makedirs(out, exist_ok=True)
    with open(os.path.join(out, "parts.csv"), "w", newline="") as table:
        writer = csv.writer(table)
        writer.writerow(["part", "size", "features"])
        for number in range(count):
            block = draw(seed, number)
            name = f"block_{number:04d}.step"
            block.solid.exportStep(os.path.join(out, name))
            writer.writerow([name, SIZE, " ".join(block.features)])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out")
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    choice = parser.parse_args()
    main(choice.out, choice.count, choice.seed)
