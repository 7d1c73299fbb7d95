# HexFeatureWB - LGPL-2.1-or-later
"""A FEM analysis without a window: set up, solve with FreeCAD's own CalculiX tools, read reactions."""
import os
import re


def static_analysis(document, mesh_object, fixed, force, newtons, direction=None, name="Analysis"):
    """An analysis of steel, fixed on some faces and loaded on others.

    fixed, force: [(part object, ("Face1", ...)), ...]; newtons: the resultant force, shared by the force's faces;
    direction: (part object, ("Face1",)) whose normal or line is the force's direction; None: the face's own normal.
    Returns (analysis, solver).
    """
    import ObjectsFem

    analysis = ObjectsFem.makeAnalysis(document, name)
    make_solver = getattr(ObjectsFem, "makeSolverCalculiXCcxTools", None) or ObjectsFem.makeSolverCalculixCcxTools
    solver = make_solver(document)
    solver.AnalysisType = "static"
    solver.GeometricalNonlinearity = "linear"
    solver.ThermoMechSteadyState = False
    solver.MatrixSolverType = "default"
    solver.IterationsControlParameterTimeUse = False
    material = ObjectsFem.makeMaterialSolid(document, "Steel")
    card = material.Material
    card["Name"], card["YoungsModulus"], card["PoissonRatio"], card["Density"] = "Steel", "210000 MPa", "0.30", "7900 kg/m^3"
    material.Material = card
    support = ObjectsFem.makeConstraintFixed(document, "Fixed")
    support.References = fixed
    load = ObjectsFem.makeConstraintForce(document, "Force")
    load.References = force
    try:
        load.Force = "%r N" % float(newtons)
    except TypeError:  # FreeCAD 0.20: a number; later ones would take a number as mN
        load.Force = float(newtons)
    if direction is not None:
        load.Direction = direction
    for member in (solver, material, support, load, mesh_object):
        analysis.addObject(member)
    document.recompute()
    return analysis, solver


def solve(analysis, solver, folder):
    """Write the input, run ccx, load the results. Returns the path of ccx's .dat file. Raises RuntimeError."""
    from femtools.ccxtools import FemToolsCcx

    tools = FemToolsCcx(analysis, solver, test_mode=False)
    tools.update_objects()
    os.makedirs(folder, exist_ok=True)
    tools.setup_working_dir(folder)
    tools.setup_ccx()
    problem = tools.check_prerequisites()
    if problem:
        raise RuntimeError(problem)
    tools.purge_results()
    tools.write_inp_file()
    tools.ccx_run()
    tools.load_results()
    return os.path.splitext(tools.inp_file_name)[0] + ".dat"


def total_reaction(dat_path):
    """Sum of the reaction forces over the fixed nodes (x, y, z) in N, from ccx's .dat file."""
    total = None
    with open(dat_path) as f:
        lines = iter(f)
        for line in lines:
            if re.search(r"total force", line, re.IGNORECASE):
                next(lines)
                total = [float(v) for v in next(lines).split()[-3:]]
    if total is None:
        raise RuntimeError("no reaction forces in " + dat_path)
    return total
