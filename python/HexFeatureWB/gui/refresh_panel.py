# HexFeatureWB - LGPL-2.1-or-later
"""*Refresh mesh*: mesh objects again, one after the other, in a worker thread. Closes itself when all went well."""
import FreeCAD
import FreeCADGui
from PySide import QtGui

from .. import mesh_object, meshing
from ..source import names_of, shape_to_mesh
from ..translate import tr
from . import messages, record
from .run import Run
from .widgets import Words, decimal


class RefreshPanel:
    def __init__(self, meshes):
        self.waiting, self.count = list(meshes), len(meshes)
        self.mesh = None
        self.failed = []
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(tr("Refresh mesh"))
        self.form.setWindowIcon(messages.qicon("HexFeature_Refresh"))
        column = QtGui.QVBoxLayout(self.form)
        self.state = Words("state")
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.cancel_button = QtGui.QPushButton(tr("Cancel"))
        self.cancel_button.setObjectName("cancel_button")
        self.cancel_button.clicked.connect(self.cancel)
        for widget in (self.state, self.bar, self.cancel_button):
            column.addWidget(widget)
        self.run = Run(self.form, self._looked, self._ended)

    @property
    def job(self):
        """The run that goes on, or None."""
        return self.run.job

    def cancel(self):
        self.waiting.clear()
        if self.job is not None:
            self.run.cancel()
            self.state.setText(tr("cancelling ..."))

    def start(self):
        """Begin with the next mesh; after the last one close, unless something is to be read."""
        while self.waiting:
            self.mesh = self.waiting.pop(0)
            try:
                self.run.start(mesh_object.source_of(self.mesh), self.mesh.Solid, mesh_object.options_of(self.mesh))
                return
            except meshing.MeshingError as error:
                self._failed(error)
        self.cancel_button.setEnabled(False)
        if not self.failed:
            self.reject()

    def _looked(self, job):
        self.bar.setValue(int(1000 * job.fraction))
        if not job.was_cancelled:
            self.state.setText(tr("%(mesh)s (%(number)d of %(count)d): %(step)s, %(seconds)s s") % {
                "mesh": self.mesh.Label, "number": self.count - len(self.waiting), "count": self.count,
                "step": messages.step_title(job.step), "seconds": decimal(job.seconds, 1)})

    def _ended(self, job, error):
        if error is None:
            try:
                record.refresh(self.mesh)
            except meshing.MeshingError as raised:
                error = raised
        if error is not None:
            self._failed(error)
        self.start()

    def _failed(self, error):
        names = None
        source = mesh_object.source_of(self.mesh)
        if getattr(error, "kind", "") == "no_mesh":
            names = messages.faces_to_blame(error, names_of(source, shape_to_mesh(source, self.mesh.Solid)))
            for name in names:
                FreeCADGui.Selection.addSelection(source.Document.Name, source.Name, name)
            if names:
                source.ViewObject.Visibility = True
        text = "<b>%s</b><br>%s" % (self.mesh.Label, messages.failure_text(error, names))
        if messages.given_up(error):
            text = tr("cancelled; the old mesh stays")
        self.failed.append(text)
        self.state.setText("<br><br>".join(self.failed))
        FreeCAD.Console.PrintError(messages.failure_text(error, names, plain=True) + "\n")

    def getStandardButtons(self):
        return messages.number_of(QtGui.QDialogButtonBox.Close)

    def reject(self):
        self.run.give_up()
        FreeCADGui.Control.closeDialog()
        return True

    def isAllowedAlterDocument(self):
        return True

    def isAllowedAlterView(self):
        return True


current = None


def open_panel(meshes):
    global current
    if FreeCADGui.Control.activeDialog():
        messages.tell(tr("Another task is open: close it first."))
        return None
    current = RefreshPanel(meshes)
    FreeCADGui.Control.showDialog(current)
    current.start()
    return current
