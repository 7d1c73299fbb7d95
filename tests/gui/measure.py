# HexFeatureWB - LGPL-2.1-or-later
"""How fast the window is: tests/gui/run.sh --measure [appear] [preview] [cancel]. Prints rows of tables (docs/freecad/measured.md).

The parts of `preview` are those of ../shared/parts when they lie beside the project, else the project's own. Wall times: on an
idle machine. Processor times are of FreeCAD and its threads.
"""
import csv
import os
import tempfile
import time

import driver
import FreeCAD
import FreeCADGui
import make_parts
from driver import child, live, say, wait_until

from HexFeatureWB.gui import record, task_panel
from HexFeatureWB.gui import run as run_of_panel

LONGEST = 60  #: s of a run that is measured, cancelled then
WRITING = "document"  #: stands for a step: the mesh goes into the document

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PARTS = os.path.join(os.path.dirname(ROOT), "shared", "parts")


def open_panel(part):
    FreeCADGui.Selection.clearSelection()
    panel = task_panel.open_panel(part)
    wait_until(lambda: not panel.preview.busy)
    return panel


def draw():
    FreeCADGui.ActiveDocument.ActiveView.redraw()
    live(0.0)


def appear():
    """From the end of meshing to the mesh that is seen, to the one that FreeCAD draws, and what a first look at its quality costs."""
    import Part

    say("| part | elements | nodes | meshed in | seen after | in the document after | of processor time | quality colours | cut |")
    say("|---|---|---|---|---|---|---|---|---|")
    for name, shape, size in (("cube", Part.makeBox(100, 100, 100), 2.15), ("round bar", make_parts.round_bar(), 0.5)):
        for order in (1, 2):
            document, part = driver.show_part(shape)
            panel = open_panel(part)
            panel.size.set_value(size)
            panel.options["order"].set_value(order)
            wait_until(lambda: not panel.preview.busy)
            child(panel.form, "mesh_button").click()
            job, cpu, seen = panel.job, 0.0, None
            while panel.job is not None:
                cpu = cpu if job.ended_at else time.process_time()
                if seen is None and job.step == run_of_panel.BUILDING:
                    draw()
                    seen = time.monotonic() - job.ended_at
                live(0.005)
            draw()
            seconds, cpu = time.monotonic() - job.ended_at, time.process_time() - cpu
            mesh, looks = panel.mesh, []
            for change in (("DisplayMode", "Quality"), ("CutAxis", "X")):
                start = time.monotonic()
                record.set_view(mesh, *change)
                draw()
                looks.append(time.monotonic() - start)
            say("| %s, order %d | %d | %d | %.1f s | %.2f s | %.2f s | %.2f s | %.2f s | %.2f s |" % (
                name, order, mesh.HexCount, mesh.FemMesh.NodeCount, job.seconds, seen, seconds, cpu, *looks))
            panel.reject()


def parts_to_preview(folder):
    """[(name, path, size)]"""
    table = os.path.join(PARTS, "parts.csv")
    home = PARTS
    if not os.path.isfile(table):
        say("(no ../shared/parts: the project's own parts)")
        for name in make_parts.PARTS:
            make_parts.make(name, folder)
        return [(name, os.path.join(folder, name + ".step"), size) for name, (_, size) in make_parts.PARTS.items()]
    with open(table, newline="") as f:
        return [(row["part"].rsplit(".", 1)[0], os.path.join(home, row["part"]), float(row["size"])) for row in csv.DictReader(f)]


def preview():
    """From the command to the drawn preview, and from a change of the size with the panel at rest."""
    import Part

    say("| part | faces | drawn after the panel is asked for | final | drawn after another size | final | regions, lines |")
    say("|---|---|---|---|---|---|---|")
    slowest = [0.0, 0.0]
    with tempfile.TemporaryDirectory() as folder:
        parts = parts_to_preview(folder)
        for name, path, size in parts:
            shape = Part.Shape()
            shape.read(path)
            document, part = driver.show_part(shape)
            FreeCADGui.Selection.clearSelection()
            start = time.monotonic()
            task_panel.open_panel(part)
            panel = task_panel.current
            opened = until_drawn(panel, start, {})
            before, start = dict(panel.preview.solids), time.monotonic()
            panel.size.set_value(size * 0.99 if panel.size.value() == size else size)
            changed = until_drawn(panel, start, before)
            slowest = [max(slow, each[0]) for slow, each in zip(slowest, (opened, changed))]
            say("| %s | %d | %.2f s | %.2f s | %.2f s | %.2f s | %s |" % (
                name, len(shape.Faces), *opened, *changed, panel.preview_text.text()))
            panel.reject()
            FreeCAD.closeDocument(document.Name)
    say("slowest of %d: %.2f s after the panel was asked for, %.2f s after another size" % (len(parts), *slowest))


def until_drawn(panel, start, before):
    """Seconds until every solid is drawn anew, and until what is drawn is final."""
    first = None
    while panel.preview.busy:
        live(0.002)
        now = panel.preview.solids
        if first is None and now and all(shown is not before.get(solid) for solid, shown in now.items()):
            draw()
            first = time.monotonic() - start
    draw()
    seconds = time.monotonic() - start
    return first or seconds, seconds


def cancel():
    """Cancel pressed in every step of both methods: the longest time until the panel can be used again, and how long the window stood
    still in that step of a run to the end."""
    say("| run | step | after | answer to Cancel | window stood still |")
    say("|---|---|---|---|---|")
    worst = (0.0, "")
    for name, shape, size in parts_to_cancel():
        for method in ("feature-line", "tet-split"):
            document, part = driver.show_part(shape)
            panel = open_panel(part)
            panel.show_lines.setChecked(False)
            panel.show_labels.setChecked(False)
            panel.size.set_value(size)
            panel.options["method"].set_value(method)
            for step, moments, still in steps_of(panel):
                for moment, seconds in ((moment, cancelled_after(panel, step, *moment)) for moment in moments):
                    if seconds is not None:
                        say("| %s, %s | %s | %.1f s | %.3f s | %.2f s |" % (name, method, step, sum(moment), seconds, still))
                        worst = max(worst, (seconds, "%s, %s, %s" % (name, method, step)))
            panel.reject()
            FreeCAD.closeDocument(document.Name)
    say("slowest answer: %.3f s (%s)" % worst)


def parts_to_cancel():
    """(name, shape, size)"""
    import Part

    if os.path.isdir(PARTS):
        with tempfile.TemporaryDirectory() as folder:
            for name, path, size in parts_to_preview(folder):
                if name in ("leg_fork", "nist_ctc_01"):
                    shape = Part.Shape()
                    shape.read(path)
                    yield name, shape, size
    yield "crank_shaft", make_parts.crank_shaft(), 2.0
    yield "pipe_tee", make_parts.pipe_tee(), 2.5


def steps_of(panel):
    """[(step, [(when it began, how long after that Cancel is to be pressed)], longest time that the window stood still in it)] of a run to
    its end, or to the end of LONGEST; the document is given back as it was."""
    child(panel.form, "mesh_button").click()
    job, seen, still = panel.job, [], {}
    start = time.monotonic()
    while panel.job is job:
        now = time.monotonic()
        if job.step and (not seen or seen[-1][0] != job.step):
            seen.append((job.step, now - start))
        step = job.step
        live(0.0)
        if panel.job is not job:
            step = WRITING
        still[step] = max(still.get(step, 0.0), time.monotonic() - now)
        time.sleep(0.002)
        if now - start > LONGEST and not job.was_cancelled:
            child(panel.form, "cancel_button").click()
    seen.append(("", time.monotonic() - start))
    if panel.mesh is not None:
        panel.document.removeObject(panel.mesh.Name)
        panel.mesh = None
        say("(the window stood still for %.2f s when the mesh was written into the document)" % still[WRITING])
    steps = {}
    for (step, begin), (_, end) in zip(seen, seen[1:]):
        if end - begin > 0.02:
            steps.setdefault(step, []).append((begin, end - begin))
    for step, times in steps.items():
        longest = max(times, key=lambda each: each[1])
        # The first time and the longest, in the middle, and near the beginning and the end of a long one.
        moments = {(begin, share * lasts) for begin, lasts in {times[0], longest} for share in ((0.1, 0.5, 0.9) if lasts > 1 else (0.5,))}
        moments = {moment for moment in moments if sum(moment) < LONGEST / 2} or {(times[0][0], times[0][1] / 2)}
        yield step, sorted(moments), still.get(step, 0.0)


def cancelled_after(panel, step, begin, wait):
    """Seconds from Cancel, pressed `wait` after `begin`, or when the step comes after that, to a panel that can be used; None when the step
    did not come again (the part is read once)."""
    child(panel.form, "mesh_button").click()
    job, start = panel.job, time.monotonic()
    while panel.job is job and (job.step != step or time.monotonic() - start < begin * 0.9):
        live(0.002)
        if time.monotonic() - start > 1.5 * begin + 2 and not job.was_cancelled:
            child(panel.form, "cancel_button").click()
            wait_until(lambda: panel.job is None)
            return None
    there = time.monotonic()
    while panel.job is job and job.step == step and time.monotonic() - there < wait:
        live(0.002)
    if panel.job is not job:
        panel.document.removeObject(panel.mesh.Name) if panel.mesh is not None else None
        panel.mesh = None
        return None
    start = time.monotonic()
    child(panel.form, "cancel_button").click()
    wait_until(lambda: panel.job is None and panel.mesh_button.isEnabled())
    return time.monotonic() - start


def run():
    driver.prepare_window()
    wanted = os.environ.get("HEXFEATURE_GUI_TESTS", "").split()
    for each in (appear, preview, cancel):
        if not wanted or each.__name__ in wanted:
            say("")
            say(each.__doc__)
            each()
    return 0
