# HexFeatureWB - LGPL-2.1-or-later
"""The verification set: parts, decks for CalculiX and known solutions. Units: mm, N, MPa, t, s, K.

A problem's `deck(model)` gives what follows the mesh in the .inp file, its `errors(model, solution)` gives {quantity: relative
error}, the one that is judged first; "field" is the root mean square over all nodes, over the largest value; "stress" that of
all six stresses at the integration points, by volume, over the exact ones' own.
"""
import math
from dataclasses import dataclass

import numpy as np

import mapped
import shapes

E, NU, RHO = 210000.0, 0.3, 7.9e-9


@dataclass
class Problem:
    name: str
    title: str
    sizes: tuple  #: element sizes, coarse to fine, each about 1.4 times smaller
    faces: dict  #: name -> a point on the CAD face
    quantity: str  #: what the first error is of
    theory: str  #: where the known solution is from
    edges: dict = None
    elements: tuple = ("C3D20R",)

    def mapped(self):
        """The part as blocks by formula (mapped.blocks); None where ours is such a mesh, or no block has its shape."""
        return None

    def section(self, model, nu=NU, more=""):
        solids = "".join("*SOLID SECTION, ELSET=Solid%d, MATERIAL=STEEL\n" % (n + 1) for n in range(model.solids))
        return "*MATERIAL, NAME=STEEL\n*ELASTIC\n%r, %r\n*DENSITY\n%r\n%s%s" % (E, nu, RHO, more, solids)


def static(body, solids=0, frd="*NODE FILE\nU\n*EL FILE\nS\n"):
    """A static step; solids: of so many the stresses at the integration points are written too."""
    points = "".join("*EL PRINT, ELSET=Solid%d\nS, COORD, EVOL\n" % (n + 1) for n in range(solids))
    return "*STEP\n*STATIC\n%s%s%s*END STEP\n" % (body, frd, points)


def relative(found, exact):
    return abs(found - exact) / abs(exact)


def field_error(found, exact):
    used = np.isfinite(found).all(axis=1)
    return float(np.sqrt(((found - exact)[used] ** 2).sum(axis=1).mean()) / np.linalg.norm(exact[used], axis=1).max())


def stress_error(solution, exact):
    """exact: function of points (k, 3) -> (k, 6), xx yy zz xy xz yz."""
    found, known = solution.at_points["S"], exact(solution.at_points["COORD"])
    element = solution.at_points["elem"]
    weight = np.array([solution.volumes[e] for e in element]) / np.bincount(element)[element]
    weight = weight[:, None] * [1, 1, 1, 2, 2, 2]
    return float(np.sqrt((weight * (found - known) ** 2).sum() / (weight * known**2).sum()))


def polar_stress(points, along, hoop, axial):
    """(k, 6) of stresses along the radius from the z axis, round it and along it."""
    c, s = (points[:, :2] / np.linalg.norm(points[:, :2], axis=1)[:, None]).T
    zero = np.zeros(len(points))
    return np.column_stack([along * c * c + hoop * s * s, along * s * s + hoop * c * c, axial + zero, (along - hoop) * c * s, zero, zero])


def near(model, condition):
    """Nodes of elements where condition(points) holds."""
    used = np.unique(model.cells)
    return used[condition(model.points[used])]


def radial(points, u_of_r, axes=2):
    """Displacements (n, 3) of size u_of_r away from the z axis (axes=2) or the origin (3)."""
    r = np.linalg.norm(points[:, :axes], axis=1)
    u = np.zeros_like(points)
    u[:, :axes] = (u_of_r(r) / r)[:, None] * points[:, :axes]
    return u


class Cantilever(Problem):
    L, B, H, P = 100.0, 10.0, 10.0, 1000.0

    def shape(self):
        return shapes.beam(self.L, self.B, self.H)

    def deck(self, model):
        # Poisson's number is 0, so that clamping a whole face is what beam theory means by clamped; the end's shear stress
        # is a parabola over the height, as in the theory of bending.
        def shear(x):
            z = x[:, 2] / self.H - 0.5
            return np.outer(-1.5 * self.P / (self.B * self.H) * (1 - 4 * z**2), [0, 0, 1])

        forces = model.traction_forces("end", shear)
        loads = "".join("%d, 3, %.12g\n" % (n + 1, forces[n, 2]) for n in np.flatnonzero(forces[:, 2]))
        return self.section(model, nu=0.0) + static("*BOUNDARY\n%s, 1, 3\n*CLOAD\n%s" % (model.face("clamp"), loads))

    def errors(self, model, solution):
        inertia, area, shear = self.B * self.H**3 / 12, self.B * self.H, E / 2
        exact = self.P * self.L**3 / (3 * E * inertia) + 1.2 * self.P * self.L / (shear * area)
        end = near(model, lambda p: (p[:, 0] > self.L - 1e-6))
        line = end[np.abs(model.points[end, 2] - self.H / 2) < 1e-6]
        end = line if len(line) else end
        return {"deflection": relative(-solution.fields["U"][end, 2].mean(), exact)}


class ThickCylinder(Problem):
    A, B, HEIGHT, PRESSURE = 10.0, 20.0, 5.0, 100.0

    def shape(self):
        return shapes.quarter_ring(self.A, self.B, self.HEIGHT)

    def mapped(self):
        return [(mapped.ring(self.A, self.B, self.HEIGHT), (self.B - self.A, (self.A + self.B) / 2 * math.pi / 2, self.HEIGHT),
                 {name: name for name in mapped.NAMES})]

    def held(self, model):
        """Symmetry, and no strain along the axis."""
        return "*BOUNDARY\n" + "".join("%s, %d, %d\n" % (model.face(f), d, d) for f, d in (("x0", 1), ("y0", 2), ("low", 3), ("top", 3)))

    def deck(self, model):
        return self.section(model) + static(self.held(model) + "*DSLOAD\n%s, P, %r\n" % (model.face("inner"), self.PRESSURE), 1)

    def exact(self, r):
        """Radial displacement, hoop and radial stress under inner pressure in plane strain (Lamé)."""
        k = self.PRESSURE * self.A**2 / (self.B**2 - self.A**2)
        return (1 + NU) / E * k * ((1 - 2 * NU) * r + self.B**2 / r), k * (1 + self.B**2 / r**2), k * (1 - self.B**2 / r**2)

    def exact_stress(self, points):
        _, hoop, along = self.exact(np.linalg.norm(points[:, :2], axis=1))
        return polar_stress(points, along, hoop, NU * (hoop + along))

    def errors(self, model, solution):
        inner, u, s = model.nodes("inner"), solution.fields["U"], solution.fields["S"]
        exact_u = radial(model.points, lambda r: self.exact(r)[0])
        # hoop stress at the two lines where the axes are the principal directions
        on_x = inner[np.abs(model.points[inner, 1]) < 1e-6]
        on_y = inner[np.abs(model.points[inner, 0]) < 1e-6]
        hoop = np.r_[s[on_x, 1], s[on_y, 0]].mean()
        return {"hoop stress": relative(hoop, self.exact(self.A)[1]), "field": field_error(u, exact_u),
                "stress": stress_error(solution, self.exact_stress)}


class RotatingDisc(ThickCylinder):
    OMEGA = 3000.0

    def deck(self, model):
        spin = "*DLOAD\nSolid1, CENTRIF, %r, 0, 0, 0, 0, 0, 1\n" % self.OMEGA**2
        return self.section(model) + static(self.held(model) + spin, 1)

    def exact(self, r):
        a2, b2, nu, e = self.A**2, self.B**2, NU / (1 - NU), E / (1 - NU**2)  # plane strain
        k = (3 + nu) / 8 * RHO * self.OMEGA**2
        along = k * (a2 + b2 - a2 * b2 / r**2 - r**2)
        hoop = k * (a2 + b2 + a2 * b2 / r**2 - (1 + 3 * nu) / (3 + nu) * r**2)
        return r / e * (hoop - nu * along), hoop, along


class Kirsch(Problem):
    W, A, T, S = 40.0, 10.0, 5.0, 100.0

    def shape(self):
        return shapes.quarter_plate(self.W, self.A, self.T)

    def exact_u(self, p):
        """Displacements of the infinite plate with a hole pulled along x, plane strain (Kirsch 1898)."""
        a, mu, k = self.A, E / (2 * (1 + NU)), 3 - 4 * NU
        r, t = np.hypot(p[:, 0], p[:, 1]), np.arctan2(p[:, 1], p[:, 0])
        ux = r / a * (k + 1) * np.cos(t) + 2 * a / r * ((1 + k) * np.cos(t) + np.cos(3 * t)) - 2 * (a / r) ** 3 * np.cos(3 * t)
        uy = r / a * (k - 3) * np.sin(t) + 2 * a / r * ((1 - k) * np.sin(t) + np.sin(3 * t)) - 2 * (a / r) ** 3 * np.sin(3 * t)
        return self.S * a / (8 * mu) * np.column_stack([ux, uy, np.zeros(len(r))])

    def deck(self, model):
        # The outer faces move as those points of the infinite plate do.
        u = self.exact_u(model.points)
        held = [(model.face("x0"), 1, 0.0), (model.face("y0"), 2, 0.0), (model.face("low"), 3, 0.0), (model.face("top"), 3, 0.0)]
        rows = ["%s, %d, %d, %r\n" % (f, d, d, v) for f, d, v in held]
        for n in np.union1d(model.nodes("right"), model.nodes("back")).tolist():
            rows += ["%d, %d, %d, %.12g\n" % (n + 1, d, d, u[n, d - 1]) for d in (1, 2) if abs(model.points[n, d - 1]) > 1e-9]
        return self.section(model) + static("*BOUNDARY\n" + "".join(rows), 1)

    def exact_stress(self, points):
        a2 = self.A**2 / (points[:, 0] ** 2 + points[:, 1] ** 2)
        t = np.arctan2(points[:, 1], points[:, 0])
        c2, c4, s2, s4 = np.cos(2 * t), np.cos(4 * t), np.sin(2 * t), np.sin(4 * t)
        xx = self.S * (1 - a2 * (1.5 * c2 + c4) + 1.5 * a2**2 * c4)
        yy = self.S * (-a2 * (0.5 * c2 - c4) - 1.5 * a2**2 * c4)
        xy = self.S * (-a2 * (0.5 * s2 + s4) + 1.5 * a2**2 * s4)
        zero = np.zeros(len(t))
        return np.column_stack([xx, yy, NU * (xx + yy), xy, zero, zero])

    def errors(self, model, solution):
        top = near(model, lambda p: (np.abs(p[:, 0]) < 1e-6) & (np.abs(p[:, 1] - self.A) < 1e-6))
        return {"stress concentration": relative(solution.fields["S"][top, 0].mean() / self.S, 3.0),
                "field": field_error(solution.fields["U"], self.exact_u(model.points)),
                "stress": stress_error(solution, self.exact_stress)}


class ThickPlate(Problem):
    def shape(self):
        return shapes.quarter_elliptic_plate((2000.0, 1000.0), (3250.0, 2750.0), 600.0)

    def mapped(self):
        at = mapped.elliptic((2000.0, 1000.0), (3250.0, 2750.0), 600.0)
        return [(at, (1500.0, 3600.0, 600.0), {name: name.split()[0] for name in self.faces})]

    def deck(self, model):
        held = [(model.face("x0 low"), 1), (model.face("x0 high"), 1), (model.face("y0 low"), 2), (model.face("y0 high"), 2)]
        held += [(model.face(f), d) for f in ("outer low", "outer high") for d in (1, 2)] + [(model.edge("middle"), 3)]
        rows = "".join("%s, %d, %d\n" % (f, d, d) for f, d in held)
        return self.section(model) + static("*BOUNDARY\n%s*DSLOAD\n%s, P, 1.0\n" % (rows, model.face("top")))

    def errors(self, model, solution):
        d = np.argmin(np.linalg.norm(model.points - [2000.0, 0, 600.0], axis=1))
        return {"stress at D": relative(solution.fields["S"][d, 1], -5.38)}


class Sphere(Problem):
    A, B, PRESSURE = 10.0, 20.0, 100.0

    def shape(self):
        return shapes.octant_shell(self.A, self.B)

    def deck(self, model):
        rows = "".join("%s, %d, %d\n" % (model.face(f), d, d) for f, d in (("x0", 1), ("y0", 2), ("z0", 3)))
        return self.section(model) + static("*BOUNDARY\n%s*DSLOAD\n%s, P, %r\n" % (rows, model.face("inner"), self.PRESSURE), 1)

    def exact_stress(self, points):
        k = self.PRESSURE * self.A**3 / (self.B**3 - self.A**3)
        r = np.linalg.norm(points, axis=1)
        along, hoop = k * (1 - self.B**3 / r**3), k * (1 + self.B**3 / (2 * r**3))
        n = points / r[:, None]
        return np.column_stack([(along - hoop) * n[:, i] * n[:, j] + (hoop if i == j else 0)
                                for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))])

    def errors(self, model, solution):
        k = self.PRESSURE * self.A**3 / (self.B**3 - self.A**3)
        exact_u = radial(model.points, lambda r: k / E * ((1 - 2 * NU) * r + (1 + NU) * self.B**3 / (2 * r**2)), axes=3)
        s, p, inner = solution.fields["S"], model.points, model.nodes("inner")
        # Hoop stress at all inner nodes: the trace less the radial stress, halved.
        n = p[inner] / np.linalg.norm(p[inner], axis=1)[:, None]
        xx, yy, zz, xy, yz, zx = s[inner].T
        along = xx * n[:, 0] ** 2 + yy * n[:, 1] ** 2 + zz * n[:, 2] ** 2
        along += 2 * (xy * n[:, 0] * n[:, 1] + yz * n[:, 1] * n[:, 2] + zx * n[:, 2] * n[:, 0])
        hoop = (xx + yy + zz - along) / 2
        exact = k * (1 + self.B**3 / (2 * self.A**3))
        return {"hoop stress": float(np.sqrt(((hoop - exact) ** 2).mean())) / exact, "field": field_error(solution.fields["U"], exact_u),
                "stress": stress_error(solution, self.exact_stress)}


class HotWall(Problem):
    L, SINK, FILM, CONDUCTIVITY, COLD = 20.0, 500.0, 0.5, 50.0, 20.0

    def shape(self):
        return shapes.beam(self.L, 10.0, 10.0)

    def deck(self, model):
        return self.section(model, more="*CONDUCTIVITY\n%r\n" % self.CONDUCTIVITY) + (
            "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNodes, 0\n*STEP\n*HEAT TRANSFER, STEADY STATE\n*BOUNDARY\n%s, 11, 11, %r\n*FILM\n%s"
            "*NODE FILE\nNT\n*END STEP\n" % (model.face("cold"), self.COLD, film_rows(model, "hot", self.SINK, self.FILM)))

    def errors(self, model, solution):
        flux = (self.SINK - self.COLD) / (1 / self.FILM + self.L / self.CONDUCTIVITY)
        exact = self.SINK - flux / self.FILM - flux / self.CONDUCTIVITY * model.points[:, :1]
        return {"temperature": field_error(solution.fields["NT"], exact)}


def film_rows(model, name, sink, coefficient):
    """*FILM has no surfaces by name in CalculiX 2.20: element and side, from the .inp file's *SURFACE."""
    rows, inside = [], False
    with open(model.path) as lines:
        for line in lines:
            if line.startswith("*"):
                inside = line.upper().startswith("*SURFACE, NAME=%s," % model.face(name).upper())
            elif inside:
                element, side = line.strip().split(",")[:2]
                rows.append("%s, F%s, %r, %r\n" % (element, side[1:], sink, coefficient))
    return "".join(rows)


class HotCylinder(ThickCylinder):
    HOT, COLD, CONDUCTIVITY = 500.0, 20.0, 50.0

    def deck(self, model):
        return self.section(model, more="*CONDUCTIVITY\n%r\n" % self.CONDUCTIVITY) + (
            "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNodes, 0\n*STEP\n*HEAT TRANSFER, STEADY STATE\n*BOUNDARY\n%s, 11, 11, %r\n"
            "%s, 11, 11, %r\n*NODE FILE\nNT\n*NODE PRINT, NSET=%s, TOTALS=ONLY\nRFL\n*END STEP\n"
            % (model.face("inner"), self.HOT, model.face("outer"), self.COLD, model.face("inner")))

    def errors(self, model, solution):
        r = np.linalg.norm(model.points[:, :2], axis=1)[:, None]
        exact = self.HOT - (self.HOT - self.COLD) * np.log(r / self.A) / math.log(self.B / self.A)
        heat = self.CONDUCTIVITY * (self.HOT - self.COLD) / math.log(self.B / self.A) * math.pi / 2 * self.HEIGHT
        return {"field": field_error(solution.fields["NT"], exact), "heat": relative(abs(solution.totals[0][0]), heat)}


class BeamModes(Problem):
    L, B, H = 100.0, 10.0, 6.0

    def shape(self):
        return shapes.beam(self.L, self.B, self.H)

    def deck(self, model):
        return self.section(model, nu=0.0) + "*STEP\n*FREQUENCY\n4\n*BOUNDARY\n%s, 1, 3\n*END STEP\n" % model.face("clamp")

    def timoshenko(self, guess, inertia):
        """Frequency near a guess of a clamped beam with shear and rotary inertia: the root of the boundary conditions' determinant."""
        area, shear = self.B * self.H, 5 / 6 * E / 2

        def determinant(f):
            w2 = (2 * math.pi * f) ** 2
            a = np.zeros((4, 4))  # of deflection, rotation, moment, shear force along the beam
            a[0, 1], a[0, 3] = 1, 1 / (shear * area)
            a[1, 2] = 1 / (E * inertia)
            a[2, 1], a[2, 3] = -RHO * inertia * w2, -1
            a[3, 0] = -RHO * area * w2
            scale = np.array([1, 1 / self.L, E * inertia / self.L**2, E * inertia / self.L**3])
            values, vectors = np.linalg.eig(a * self.L * scale[None, :] / scale[:, None])
            transfer = (vectors * np.exp(values)) @ np.linalg.inv(vectors)
            return np.linalg.det(transfer[2:, 2:]).real

        low, high = 0.9 * guess, 1.05 * guess
        sign = determinant(low)
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if determinant(middle) * sign > 0 else (low, middle)
        return low

    def errors(self, model, solution):
        def frequency(root, thickness, width):
            inertia = width * thickness**3 / 12
            return self.timoshenko((root / self.L) ** 2 / (2 * math.pi) * math.sqrt(E * inertia / (RHO * width * thickness)), inertia)

        exact = [frequency(1.875104, self.H, self.B), frequency(1.875104, self.B, self.H), frequency(4.694091, self.H, self.B)]
        off = [min(relative(f, e) for f in solution.frequencies) for e in exact]
        return {"first frequency": off[0], "second": off[1], "third": off[2]}


class PressFit(Problem):
    A, C, B, HEIGHT, INTERFERENCE, STIFFNESS = 10.0, 15.0, 20.0, 5.0, 0.02, 1e7

    def shape(self):
        rings = [shapes.quarter_ring(self.A, self.C + self.INTERFERENCE, self.HEIGHT), shapes.quarter_ring(self.C, self.B, self.HEIGHT)]
        return shapes.Part.makeCompound(rings)

    def mapped(self):
        rings = ((" inside", self.A, self.C + self.INTERFERENCE), (" outside", self.C, self.B))
        contact = {" inside": ("contact inside", "outer"), " outside": ("contact outside", "inner")}
        parts = []
        for ring, inner, outer in rings:
            names = {name: name[:-len(ring)] for name in self.faces if name.endswith(ring) and not name.startswith("contact")}
            names[contact[ring][0]] = contact[ring][1]
            if ring == " inside":
                names["inner"] = "inner"
            parts.append((mapped.ring(inner, outer, self.HEIGHT), (outer - inner, 15 * math.pi / 2, self.HEIGHT), names))
        return parts

    def deck(self, model):
        held = [(f + ring, d) for ring in (" inside", " outside") for f, d in (("x0", 1), ("y0", 2), ("low", 3), ("top", 3))]
        rows = "".join("%s, %d, %d\n" % (model.face(f), d, d) for f, d in held)
        contact = ("*SURFACE INTERACTION, NAME=PRESSED\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n%r\n"
                   "*CONTACT PAIR, INTERACTION=PRESSED, TYPE=SURFACE TO SURFACE\n%s, %s\n"
                   % (self.STIFFNESS, model.face("contact outside"), model.face("contact inside")))
        return self.section(model) + contact + static("*BOUNDARY\n" + rows, 2)

    def errors(self, model, solution):
        # Two rings of their own free radii; the force across the contact is the same for both, so the pressures differ a little.
        a2, b2, c2, o = self.A**2, self.B**2, self.C**2, self.C + self.INTERFERENCE
        within = -(1 + NU) / E * self.C / o * o**2 / (o**2 - a2)  # of the displacement for a pressure of 1 on the outer ring
        without = (1 + NU) / E * c2 / (b2 - c2)
        inner, outer = (lambda r: within * ((1 - 2 * NU) * r + a2 / r)), (lambda r: without * ((1 - 2 * NU) * r + b2 / r))
        pressure = self.INTERFERENCE / (outer(self.C) - inner(o))

        def u(r):
            return pressure * np.where(inside, inner(r), outer(r))

        inside = np.linalg.norm(model.points[:, :2], axis=1) < self.C
        inside[model.nodes("contact outside")] = False
        inside[model.nodes("contact inside")] = True
        rim, s = model.nodes("inner"), solution.fields["S"]
        on_x, on_y = rim[np.abs(model.points[rim, 1]) < 1e-6], rim[np.abs(model.points[rim, 0]) < 1e-6]
        hoop = np.r_[s[on_x, 1], s[on_y, 0]].mean()

        def exact_stress(points):
            r2 = (points[:, :2] ** 2).sum(axis=1)
            p, q = pressure * self.C * o / (o**2 - a2), pressure * c2 / (b2 - c2)
            inner_ring = np.sqrt(r2) < self.C + self.INTERFERENCE / 2  # integration points lie within their rings
            hoops, along = (np.where(inner_ring, -p * (1 + sign * a2 / r2), q * (1 + sign * b2 / r2)) for sign in (1, -1))
            return polar_stress(points, along, hoops, NU * (hoops + along))

        return {"hoop stress": relative(hoop, -2 * pressure * self.C * o / (o**2 - a2)),
                "field": field_error(solution.fields["U"], radial(model.points, u)), "stress": stress_error(solution, exact_stress)}


def _ring(inner, outer, height):
    m, s = (inner + outer) / 2, math.sqrt(0.5)
    return {"x0": (0, m, height / 2), "y0": (m, 0, height / 2), "low": (m * s, m * s, 0), "top": (m * s, m * s, height),
            "inner": (inner * s, inner * s, height / 2), "outer": (outer * s, outer * s, height / 2)}


def _press_fit():
    p = PressFit
    parts = {" inside": _ring(p.A, p.C + p.INTERFERENCE, p.HEIGHT), " outside": _ring(p.C, p.B, p.HEIGHT)}
    faces = {name + part: at for part, points in parts.items() for name, at in points.items()}
    return {**faces, "contact inside": faces["outer inside"], "contact outside": faces["inner outside"], "inner": faces["inner inside"]}


def _plate():
    s = math.sqrt(0.5)
    halves = {" low": 150.0, " high": 450.0}
    faces = {"top": (2.6e3 * s, 1.9e3 * s, 600.0)}
    for half, z in halves.items():
        faces.update({"x0" + half: (0, 1900, z), "y0" + half: (2600, 0, z), "outer" + half: (3250 * s, 2750 * s, z)})
    return faces


PROBLEMS = [
    Cantilever("cantilever", "Cantilever with an end load", (10.0, 5.0, 3.34, 2.5), {"clamp": (0, 5, 5), "end": (100, 5, 5)},
               "deflection of the end", "Timoshenko beam", elements=("C3D8", "C3D8I", "C3D8R", "C3D20", "C3D20R")),
    ThickCylinder("lame", "Thick-walled cylinder under pressure", (2.5, 1.7, 1.25, 0.85), _ring(10, 20, 5),
                  "hoop stress at the bore", "Lamé, plane strain"),
    Kirsch("kirsch", "Plate with a hole", (5.0, 3.4, 2.5, 1.7),
           {"x0": (0, 25, 2.5), "y0": (25, 0, 2.5), "low": (25, 25, 0), "top": (25, 25, 5), "right": (40, 20, 2.5), "back": (20, 40, 2.5)},
           "stress concentration at the hole", "Kirsch, infinite plate, Kt = 3"),
    ThickPlate("le10", "NAFEMS LE10, elliptic thick plate", (300.0, 200.0, 150.0, 100.0), _plate(),
               "stress yy at D", "NAFEMS: -5.38 MPa", edges={"middle": (3250 * math.sqrt(0.5), 2750 * math.sqrt(0.5), 300.0)}),
    Sphere("sphere", "Hollow sphere under pressure", (3.4, 2.5, 1.7, 1.25),
           {"x0": (0, 10.6, 10.6), "y0": (10.6, 0, 10.6), "z0": (10.6, 10.6, 0), "inner": (10 / math.sqrt(3),) * 3},
           "hoop stress at all inner nodes (root mean square)", "Lamé"),
    RotatingDisc("disc", "Rotating disc held between plates", (2.5, 1.7, 1.25, 0.85), _ring(10, 20, 5),
                 "hoop stress at the bore", "Timoshenko and Goodier, plane strain"),
    HotWall("wall", "Heat through a wall with convection", (5.0, 3.4, 2.5, 1.7), {"hot": (0, 5, 5), "cold": (20, 5, 5)},
            "temperature, root mean square", "linear, exact in every mesh"),
    HotCylinder("pipe", "Heat through a cylinder", (2.5, 1.7, 1.25, 0.85), _ring(10, 20, 5), "temperature, root mean square", "logarithm"),
    BeamModes("modes", "Natural frequencies of a beam", (6.0, 4.0, 3.0, 2.0), {"clamp": (0, 5, 3)}, "first frequency",
              "Timoshenko beam"),
    PressFit("pressfit", "Ring pressed on a ring, contact", (3.4, 2.5, 1.7, 1.25), _press_fit(), "hoop stress at the bore",
             "Lamé, both rings, plane strain"),
]
