# HexFeatureWB - LGPL-2.1-or-later
"""The task panel of *Hex mesh from solid*: choose, see what will come, mesh in a worker thread, cancel."""
import math

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .. import mesh_object, meshing
from ..source import brep_of, names_of, shape_to_mesh, solids_of
from ..translate import tr
from . import messages, record, settings
from .parts_shown import meshes_of
from .preview import Preview, reading_job
from .run import BUILDING, Run
from .widgets import Fold, LengthEdit, OptionWidget, Words, beside_or_below, decimal, length, nice, number, title_of

STEPS = 200  #: of the slider


class HexMeshPanel:
    """Panel for a new mesh of `source`, or (mesh given) for meshing again with other options.

    FreeCAD calls getStandardButtons, accept, reject; tests press the widgets by their objectName.
    """

    def __init__(self, source, mesh=None, solid=0):
        self.source, self.mesh, self.document = source, mesh, source.Document
        self.run = None
        self._hidden = []  # views of part and mesh, while the preview stands in their place
        self._reading = self._begin_reading(mesh.Solid if mesh else solid)
        self.form = self._build(mesh.Solid if mesh else solid)
        self.run = Run(self.form, self._looked, self._ended)
        self.preview = Preview(self.document, self._preview_says, self._preview_ready, self.form)
        self.preview.set_parts(self.show_lines.isChecked(), self.show_labels.isChecked())
        self._changed()

    @property
    def job(self):
        """The run that goes on, or None."""
        return self.run.job if self.run else None

    def _begin_reading(self, solid):
        """A worker that reads the part while the panel is made, which takes as long: the core keeps it for whatever comes first. None where
        there is nothing to read, which the preview will say."""
        try:
            brep = brep_of(shape_to_mesh(self.source, min(solid, len(solids_of(self.source)))))
        except meshing.MeshingError:
            return None
        return reading_job(brep, self._length() / 20).start()

    def _first_size(self):
        """That of the mesh, or one for about 3000 elements, as the core chooses."""
        size = float(self.mesh.ElementSize.Value) if self.mesh else 0.0
        return size if size > 0 else nice((self._volume / 3000) ** (1 / 3)) or nice(self._length() / 20)

    def _length(self):
        return max(self.source.Shape.BoundBox.DiagonalLength, 1e-6)

    # ---- what is on it

    def _build(self, solid):
        form = QtGui.QWidget()
        form.setWindowTitle(tr("Hex mesh from solid"))
        form.setWindowIcon(messages.qicon("HexFeature_Mesh"))
        column = QtGui.QVBoxLayout(form)
        grid = QtGui.QFormLayout()
        grid.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        grid.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        part = QtGui.QLabel(self.source.Label)
        part.setObjectName("part")
        grid.addRow(tr("Part"), part)
        count = len(solids_of(self.source))
        self.solid = QtGui.QComboBox()
        self.solid.setObjectName("solid")
        self.solid.addItems([tr("all solids")] + ["Solid%d" % (k + 1) for k in range(count)])
        self.solid.setCurrentIndex(min(solid, count))
        if count > 1:
            grid.addRow(tr("Solid"), self.solid)
        self.solid.currentIndexChanged.connect(lambda *_: self._changed())
        self._build_size(grid)
        self.options = {}
        advanced = QtGui.QWidget()
        folded = QtGui.QFormLayout(advanced)
        folded.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        for spec in settings.option_specs():
            value = getattr(self.mesh, mesh_object.property_name(spec["name"])) if self.mesh else settings.option_default(spec)
            self.options[spec["name"]] = option = OptionWidget(spec, value, self._changed)
            (folded if spec["advanced"] else grid).addRow(title_of(spec["name"]), option.widget)
        column.addLayout(grid)
        self.advanced = Fold(tr("More options"), advanced)
        column.addWidget(self.advanced)
        column.addWidget(self._build_preview())
        column.addWidget(self._build_run())
        return form

    def _build_size(self, grid):
        self._range = self._length() / 400, self._length() / 4
        self.size = LengthEdit("size", self._size_typed)
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("size_slider")
        self.slider.setRange(0, STEPS)
        self.slider.setToolTip(tr("Fine elements on the left, coarse ones on the right"))
        self.estimate = QtGui.QLabel()
        self.estimate.setObjectName("estimate")
        self._volume = sum(s.Volume for s in solids_of(self.source))
        start = self._first_size()
        self.size.set_value(start)
        self.size.set_step(nice(start / 10))
        self._slide_to(start)
        self.slider.valueChanged.connect(self._slid)
        grid.addRow(tr("Element size"), self.size.widget)
        grid.addRow("", self.slider)
        grid.addRow("", self.estimate)

    def _build_preview(self):
        box = QtGui.QGroupBox(tr("Preview"))
        column = QtGui.QVBoxLayout(box)
        self.show_lines, self.show_labels = QtGui.QCheckBox(tr("Feature lines")), QtGui.QCheckBox(tr("Labels"))
        for check, name in ((self.show_lines, "PreviewLines"), (self.show_labels, "PreviewLabels")):
            check.setObjectName(name)
            check.setChecked(settings.switch(name))
            check.toggled.connect(self._preview_switched)
        self.preview_text = Words("preview_text")
        column.addLayout(beside_or_below(self.show_lines, self.show_labels))
        column.addWidget(self.preview_text)
        return box

    def _build_run(self):
        box = QtGui.QWidget()
        column = QtGui.QVBoxLayout(box)
        column.setContentsMargins(0, 0, 0, 0)
        row = QtGui.QHBoxLayout()
        self.mesh_button = QtGui.QPushButton(tr("Mesh again") if self.mesh else tr("Mesh"))
        self.mesh_button.setObjectName("mesh_button")
        self.mesh_button.setDefault(True)
        self.mesh_button.setIcon(messages.qicon("HexFeature_Mesh"))
        self.mesh_button.setToolTip(tr("Mesh with these options (Ctrl+Return)"))
        self.mesh_button.clicked.connect(self.start)
        shortcut = QtGui.QShortcut(QtGui.QKeySequence("Ctrl+Return"), box)
        shortcut.setContext(QtCore.Qt.WindowShortcut)
        shortcut.activated.connect(self.mesh_button.click)
        self.cancel_button = QtGui.QPushButton(tr("Cancel"))
        self.cancel_button.setObjectName("cancel_button")
        self.cancel_button.setEnabled(False)
        self.cancel_button.clicked.connect(self.cancel)
        row.addWidget(self.mesh_button)
        row.addWidget(self.cancel_button)
        self.bar = QtGui.QProgressBar()
        self.bar.setObjectName("progress")
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.state = Words("state")
        self.log = QtGui.QPlainTextEdit()
        self.log.setObjectName("log")
        self.log.setReadOnly(True)
        self.log.setMaximumHeight(140)
        self.log.setLineWrapMode(QtGui.QPlainTextEdit.NoWrap)
        column.addLayout(row)
        column.addWidget(self.bar)
        column.addWidget(self.state)
        column.addWidget(Fold(tr("Log"), self.log))
        return box

    # ---- the size, its slider, the estimate

    def _slide_to(self, size):
        low, high = self._range
        at = math.log(min(max(size, low), high) / low) / math.log(high / low)
        self.slider.blockSignals(True)
        self.slider.setValue(round(at * STEPS))
        self.slider.blockSignals(False)

    def _slid(self, at):
        low, high = self._range
        self.size.set_value(nice(low * (high / low) ** (at / STEPS)))

    def _size_typed(self, size):
        if size > 0:
            self._slide_to(size)
        if hasattr(self, "preview"):
            self._changed()

    def estimated_count(self):
        """Volume over the volume of an element; None without a size."""
        size = self.size.value()
        index = self.solid.currentIndex()
        solids = solids_of(self.source)
        volume = solids[index - 1].Volume if index else self._volume
        return volume / size ** 3 if size > 0 else None

    # ---- reactions

    def chosen(self):
        """The options as the core takes them."""
        return {"size": self.size.value(), **{name: option.value() for name, option in self.options.items()}}

    def _shape(self):
        return shape_to_mesh(self.source, self.solid.currentIndex())

    def _changed(self):
        count = self.estimated_count()
        layers = self.options["minimum_layers"].value()
        self.estimate.setWordWrap(layers > 1)  # the long text
        self.estimate.setText(tr("give a size above 0") if count is None else tr("larger than the part") if count < 1 else
                              tr("about %s elements") % number(count) if layers < 2 else
                              tr("about %(count)s elements, more where it is thinner than %(thickness)s") % {
                                  "count": number(count), "thickness": length(layers * self.size.value())})
        self.mesh_button.setEnabled(self.job is None and count is not None)
        if not hasattr(self, "preview") or self.job is not None:
            return
        self._ask_preview()

    def _ask_preview(self):
        if not (self.show_lines.isChecked() or self.show_labels.isChecked()) or self.size.value() <= 0:
            self.preview.clear()
            self._show_part()
            self.preview_text.setText("")
            return
        if self.options["method"].value() == "tet-split":
            self.preview.clear()
            self._show_part()
            self.preview_text.setText(tr("this method has neither labels nor feature lines"))
            return
        self.preview_text.setText(tr("looking at the part ..."))
        try:
            self.preview.show(brep_of(self._shape()), self.chosen(), self._reading)
        except meshing.MeshingError as error:
            self._preview_says(messages.in_words(error.reason))

    def _preview_switched(self):
        self.preview.set_parts(self.show_lines.isChecked(), self.show_labels.isChecked())
        for check in (self.show_lines, self.show_labels):
            settings.set_switch(check.objectName(), check.isChecked())
        if not self.preview.solids or not (self.show_lines.isChecked() or self.show_labels.isChecked()):
            self._ask_preview()
        else:
            self._preview_ready(None)

    def _preview_says(self, text):
        self.preview_text.setText(text)

    def _preview_ready(self, job):
        stages = self.preview.stages
        if not stages:
            self._show_part()
            return
        text = tr("%d regions, %d feature lines") if self.preview.final else tr("%d regions, %d feature lines so far, being tried ...")
        if not self.preview.failed:  # or why it failed is still to be read
            self.preview_text.setText(
                text % (sum(len(stage["chart_label"]) for stage in stages), sum(len(stage["arcs"]) for stage in stages)))
        if self.show_labels.isChecked():
            self._hide_part()
        else:
            self._show_part()

    def _hide_part(self):
        """The coloured preview stands in the place of the part and of its mesh."""
        for obj in (self.source, self.mesh):
            if obj is not None and obj.ViewObject.Visibility:
                self._hidden.append(obj.ViewObject)
                obj.ViewObject.Visibility = False

    def _show_part(self):
        hidden, self._hidden = self._hidden, []
        for view in hidden:
            view.Visibility = True

    # ---- the run

    def start(self):
        """Mesh in a worker thread. The document is written only when it has ended, in `_take`."""
        if self.job is not None:
            return
        FreeCADGui.Selection.clearSelection()
        self.log.clear()
        self._shown_lines, self._mesh_drawn = 0, False
        try:
            self.run.start(self.source, self.solid.currentIndex(), self.chosen(), self._reading)
        except meshing.MeshingError as error:
            self.state.setText(messages.failure_text(error, None))
            return
        self.preview.pause()
        self._set_running(True)

    def cancel(self):
        """Give the run up. The panel can be used again at once."""
        if self.job is not None:
            self.run.cancel()
            self.cancel_button.setEnabled(False)
            self.state.setText(tr("cancelling ..."))

    def _set_running(self, running):
        for widget in (self.size.widget, self.slider, self.solid, self.mesh_button, self.advanced,
                       *(option.widget for option in self.options.values())):
            widget.setEnabled(not running)
        self.cancel_button.setEnabled(running)

    def _looked(self, job):
        if job.step == BUILDING and not self._mesh_drawn:
            self._mesh_drawn = True
            self.preview.show_mesh(job.result.points, job.result.quads)
            self._hide_part()
        self.bar.setValue(int(1000 * job.fraction))
        if not job.was_cancelled:
            self.state.setText(tr("%(step)s, %(seconds)s s") % {
                "step": messages.step_title(job.step), "seconds": decimal(job.seconds, 1)})
        self._append_log(job)

    def _ended(self, job, error):
        self._append_log(job)
        self._set_running(False)
        self.bar.setValue(0)
        if error is None:
            self._take(job)
        else:
            self._failed(error)

    def _append_log(self, job):
        lines = job.lines[self._shown_lines:]
        self._shown_lines += len(lines)
        if lines:
            self.log.appendPlainText("\n".join(map(messages.log_in_words, lines)))

    def _take(self, job):
        """Put the finished mesh into the document, by the line that the macro recorder sees."""
        self.preview.clear()
        self._show_part()
        self.state.setText(tr("writing the mesh into the document ..."))
        self.state.repaint()
        try:
            if self.mesh is None:
                self.mesh = record.mesh(self.source, job.options, self.solid.currentIndex())
                self.mesh_button.setText(tr("Mesh again"))
            else:
                record.refresh(self.mesh, job.options, self.solid.currentIndex())
        except meshing.MeshingError as error:
            self._failed(error)
            return
        record.show(self.mesh, True)
        for older in meshes_of(self.source, self.mesh):  # in the same place: what is seen would be a mixture
            record.show(older, False)
        if settings.switch("HidePart"):
            record.show(self.source, False)
        if settings.switch("QualityAfterMeshing"):
            record.set_view(self.mesh, "DisplayMode", "Quality")
        self.bar.setValue(1000)
        self.state.setText(messages.success_text(self.mesh))
        self.state.reveal()
        self.preview_text.setText("")

    def _failed(self, error):
        self.preview.clear()
        self._show_part()
        if messages.given_up(error):
            self.state.setText(tr("cancelled; the document is as it was"))
            self._ask_preview()
            return
        names = None
        if isinstance(error, meshing.MeshingError):
            names = messages.faces_to_blame(error, names_of(self.source, self._shape()))
            for name in names:
                FreeCADGui.Selection.addSelection(self.document.Name, self.source.Name, name)
            self.preview.mark([self.source.Shape.getElement(name) for name in names])
            if names:  # seen only where the part is
                self.source.ViewObject.Visibility = True
        self.state.setText(messages.failure_text(error, names))
        self.state.reveal()
        FreeCAD.Console.PrintError(messages.failure_text(error, names, plain=True) + "\n")

    # ---- FreeCAD's side

    def getStandardButtons(self):
        return messages.number_of(QtGui.QDialogButtonBox.Close)

    def reject(self):
        """Close: a run is given up; what is in the document stays."""
        self.run.give_up()
        self.preview.remove()
        if self._reading is not None:
            self._reading.cancel()
            self._reading = None
        self._show_part()
        if self.mesh is not None and settings.switch("HidePart") and self.mesh.ViewObject.Visibility:
            record.show(self.source, False)
        FreeCADGui.getDocument(self.document.Name).resetEdit()
        FreeCADGui.Control.closeDialog()
        return True

    def isAllowedAlterDocument(self):
        return True

    def isAllowedAlterView(self):
        return True

    def isAllowedAlterSelection(self):
        return True


#: the open panel, for tests and for whoever asks what is going on
current = None


def open_panel(source, mesh=None, solid=0):
    """Show the panel; says why when there is nothing to mesh or another task is open."""
    global current
    if FreeCADGui.Control.activeDialog():
        messages.tell(tr("Another task is open: close it first."))
        return None
    current = HexMeshPanel(source, mesh, solid)
    FreeCADGui.Control.showDialog(current)
    current.size.widget.setFocus(QtCore.Qt.TabFocusReason)  # what is typed replaces the size
    return current


def edit(mesh):
    """The panel of an existing mesh."""
    source = mesh_object.source_of(mesh)
    if source is None or not solids_of(source):
        messages.tell(tr("The mesh has lost its part: link one in its property Shape."))
        return None
    return open_panel(source, mesh)
