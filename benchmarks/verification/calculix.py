# HexFeatureWB - LGPL-2.1-or-later
"""Run CalculiX on a deck and read what it left: .frd fields, eigenfrequencies and totals of the .dat file."""
import os
import re
import resource
import subprocess
from dataclasses import dataclass, field

import numpy as np


@dataclass
class Solution:
    """fields: name -> (n, components) over all nodes (NaN where there is none); S: xx yy zz xy yz zx; U: x y z; NT: T."""

    fields: dict = field(default_factory=dict)
    frequencies: list = field(default_factory=list)
    totals: list = field(default_factory=list)  #: of *NODE PRINT, TOTALS=ONLY, in order: 3 components, or 1 of heat
    #: of *EL PRINT at k integration points: elem -> (k,), S -> (k, 6) xx yy zz xy xz yz, COORD -> (k, 3)
    at_points: dict = field(default_factory=dict)
    volumes: dict = field(default_factory=dict)  #: of *EL PRINT, EVOL: element number -> volume
    seconds: float = 0.0  #: processor time


def run(path, threads=1):
    """Solve `path` (.inp). Raises RuntimeError with CalculiX's own words when it did not finish, or warned of the mesh."""
    folder, name = os.path.split(os.path.splitext(path)[0])
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(["ccx", name], cwd=folder or ".", capture_output=True, text=True, errors="replace",
                          env=dict(os.environ, OMP_NUM_THREADS=str(threads)))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    text = done.stdout + done.stderr
    if "Job finished" not in text or "*ERROR" in text:
        at = text.find("*ERROR")
        raise RuntimeError(text[at:at + 600] if at >= 0 else text[-600:])
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    stem = os.path.splitext(path)[0]
    dat = open(stem + ".dat").read() if os.path.exists(stem + ".dat") else ""
    return Solution(read_frd(stem + ".frd") if os.path.exists(stem + ".frd") else {}, frequencies(dat), _totals(dat),
                    *_at_points(dat), seconds)


def read_frd(path):
    """Fields of the last step in an ASCII .frd file. Source: CalculiX GraphiX manual, "Result Format"."""
    fields, count, name, rows, components = {}, 0, None, [], 0
    names = {"DISP": "U", "STRESS": "S", "NDTEMP": "NT"}
    with open(path) as lines:
        for line in lines:
            key = line[:3]
            if key == " -1" and name:
                rows.append((int(line[3:13]), [float(line[13 + 12 * k:25 + 12 * k]) for k in range(components)]))
            elif key == " -1" and components == -1:
                count = max(count, int(line[3:13]))
            elif line.startswith("    2C"):
                components = -1
            elif key == " -3":
                if name:
                    values = np.full((count, components), np.nan)
                    for node, row in rows:
                        values[node - 1] = row
                    fields[name] = values
                name, rows, components = None, [], 0
            elif key == " -4":
                name, components = names.get(line.split()[1]), 0
            elif key == " -5" and name:
                components += "ALL" not in line
    return fields


def frequencies(dat):
    """Natural frequencies in cycles a time unit."""
    at = dat.find("E I G E N V A L U E   O U T P U T")
    if at < 0:
        return []
    rows = re.findall(r"^\s+\d+\s+(\S+)\s+(\S+)\s+(\S+)\s+(\S+)\s*$", dat[at:dat.find("P A R T", at)], re.MULTILINE)
    return [float(row[2]) for row in rows]


def buckling_factors(dat):
    """Factors on the load, least first."""
    at = dat.find("B U C K L I N G   F A C T O R   O U T P U T")
    return [float(row[1]) for row in re.findall(r"^\s+(\d+)\s+(\S+)\s*$", dat[at:], re.MULTILINE)] if at >= 0 else []


def _at_points(dat):
    """(values at integration points, volumes of elements)."""
    found, volumes, rows = {"elem": [], "S": [], "COORD": []}, {}, None
    for line in dat.splitlines():
        if "(elem" in line:
            rows = "S" if "stresses" in line else "COORD" if "coord" in line else "EVOL" if "volume" in line else None
        elif rows and line.strip():
            row = line.split()
            if not row[0].isdigit():
                rows = None
            elif rows == "EVOL":
                volumes[int(row[0])] = float(row[1])
            else:
                found[rows].append([float(v) for v in row[2:]])
                if rows == "S":
                    found["elem"].append(int(row[0]))
    return {name: np.array(values) for name, values in found.items() if values}, volumes


def _totals(dat):
    """Lines below "total force (fx,fy,fz)" or "total heat"."""
    lines, totals = dat.splitlines(), []
    for n, line in enumerate(lines):
        if "total force" in line or "heat generation for set" in line:
            numbers = next(row for row in lines[n + 1:] if row.strip())
            totals.append([float(v) for v in numbers.split()])
    return totals
