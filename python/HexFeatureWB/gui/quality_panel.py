# HexFeatureWB - LGPL-2.1-or-later
"""The task panel of *Mesh quality*: figures, colours, bad elements alone, a cut through the mesh, feature lines on it."""
import json

import FreeCADGui
from PySide import QtCore, QtGui

from .. import mesh_object
from ..translate import tr
from . import messages, record, scene
from .widgets import Words, beside_or_below, choice_title, decimal, number

AXES = ("None", "X", "Y", "Z")


class Histogram(QtGui.QWidget):
    """How many elements are how good, as bars in the colours of the 3D view; the square root of counts, so that few are seen."""

    def __init__(self, counts):
        super().__init__()
        self.counts = list(counts)  # over [0, 1] in steps of 0.1
        self.setMinimumHeight(90)
        self.setToolTip(tr("Elements by scaled Jacobian, from 0 (left) to 1; heights are square roots of counts"))

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        text = self.fontMetrics().height()
        height, width = self.height() - text - 2, self.width() / max(1, len(self.counts))
        most = max(max(self.counts, default=0), 1) ** 0.5
        colours = scene.quality_colours()
        for k, count in enumerate(self.counts):
            r, g, b = colours[int((k + 0.5) / len(self.counts) * scene.LEVELS)]
            bar = max(2 if count else 0, height * count ** 0.5 / most)
            painter.fillRect(QtCore.QRectF(k * width + 1, height - bar, width - 2, bar), QtGui.QColor.fromRgbF(r, g, b))
        for value in (0, 0.5, 1):
            flags = (QtCore.Qt.AlignLeft, QtCore.Qt.AlignHCenter, QtCore.Qt.AlignRight)[int(2 * value)]
            painter.drawText(QtCore.QRectF(0, height + 2, self.width(), text), messages.number_of(flags), "%g" % value)
        painter.end()


class QualityPanel:
    def __init__(self, mesh):
        self.mesh, self.view = mesh, mesh.ViewObject
        self._before = self.view.DisplayMode
        self.form = self._build()
        self._set("DisplayMode", "Quality")
        self._set("Visibility", True)
        # The part would be drawn into its mesh.
        part = mesh_object.source_of(mesh)
        self._hidden = part if part is not None and part.ViewObject.Visibility else None
        if self._hidden:
            record.show(part, False)

    def _build(self):
        form = QtGui.QWidget()
        form.setWindowTitle(tr("Mesh quality"))
        form.setWindowIcon(messages.qicon("HexFeature_Quality"))
        column = QtGui.QVBoxLayout(form)
        figures = Words("figures")
        figures.setText(self._figures())
        column.addWidget(figures)
        report = json.loads(self.mesh.Report) if self.mesh.Report else {}
        histogram = report.get("quality", {}).get("histogram", [])
        column.addWidget(Histogram(histogram[10:]))
        grid = QtGui.QFormLayout()
        grid.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        grid.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        self.below = QtGui.QDoubleSpinBox()
        self.below.setObjectName("below")
        self.below.setRange(0, 1)
        self.below.setDecimals(3)
        self.below.setSingleStep(0.05)
        self.below.setToolTip(tr("Show only elements of a scaled Jacobian below this; 1 shows all"))
        self.below.setValue(self.view.ShowBelow)
        self.below.setKeyboardTracking(False)
        self.below.valueChanged.connect(self._below)
        self.shown = QtGui.QLabel()
        self.shown.setObjectName("shown")
        self.worst = QtGui.QPushButton(tr("The ten worst"))
        self.worst.setObjectName("worst")
        self.worst.clicked.connect(self._ten_worst)
        row = beside_or_below(self.below, self.worst)
        grid.addRow(tr("Only elements below"), row)
        grid.addRow("", self.shown)
        self.axis = QtGui.QComboBox()
        self.axis.setObjectName("cut_axis")
        self.axis.addItems([tr("no cut"), tr("across X"), tr("across Y"), tr("across Z")])
        self.axis.setCurrentIndex(AXES.index(self.view.CutAxis))
        self.axis.currentIndexChanged.connect(self._cut)
        self.position = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.position.setObjectName("cut_position")
        self.position.setRange(0, 100)
        self.position.setValue(self.view.CutPosition)
        self.position.valueChanged.connect(self._cut_moved)
        self.position.sliderReleased.connect(lambda: record.set_view(self.mesh, "CutPosition", self.position.value()))
        self.flip = self._check("cut_flip", tr("other side"), "CutFlip")
        grid.addRow(tr("Cut open"), self.axis)
        grid.addRow("", self.position)
        grid.addRow("", self.flip)
        self._cut(self.axis.currentIndex())
        self.lines = self._check("feature_lines", tr("Feature lines"), "FeatureLines")
        self.bar = self._check("colour_bar", tr("Colour scale"), "ColourBar")
        self.keep = QtGui.QCheckBox(tr("Keep this view when closed"))
        self.keep.setObjectName("keep")
        self.keep.setChecked(self._before == "Quality")
        column.addLayout(grid)
        for check in (self.lines, self.bar, self.keep):
            column.addWidget(check)
        self._count()
        return form

    def _check(self, name, text, view_property):
        check = QtGui.QCheckBox(text)
        check.setObjectName(name)
        check.setChecked(getattr(self.view, view_property))
        check.toggled.connect(lambda on: self._set(view_property, on))
        return check

    def _figures(self):
        mesh = self.mesh
        report = json.loads(mesh.Report) if mesh.Report else {}
        quality = report.get("quality", {})
        off = float(mesh.LargestDeviation.Value)
        rows = [
            (tr("Hexahedra"), number(mesh.HexCount)),
            (tr("Nodes"), number(mesh.FemMesh.NodeCount)),
            (tr("Scaled Jacobian, worst"), decimal(mesh.MinScaledJacobian, 3)),
            (tr("Scaled Jacobian, mean"), decimal(mesh.MeanScaledJacobian, 3)),
            (tr("Elements below 0.2"), decimal(100 * quality.get("below_0.2", 0), 2, "g") + " %"),
            (tr("Volume off by"), decimal(100 * quality.get("volume_error", 0), 2, "g") + " %"),
            (tr("Farthest from the CAD"), decimal(off, 2, "g") + " mm" if off >= 1e-9 else "&lt; 1e-9 mm"),
            (tr("Method"), choice_title("method", mesh.MethodUsed)),
            (tr("Time"), decimal(mesh.Seconds, 1) + " s"),
        ]
        return "<table>%s</table>" % "".join("<tr><td>%s&nbsp;&nbsp;</td><td><b>%s</b></td></tr>" % row for row in rows)

    def _elements(self):
        node = getattr(self.view.Proxy, "quality", None)
        return node.elements(self.mesh) if node else None

    def _count(self):
        elements = self._elements()
        if elements is not None:
            count = int(elements.visible(self.below.value()).sum())
            self.shown.setText(tr("%(some)s of %(all)s elements") % {"some": number(count), "all": number(len(elements.hexes))})

    def _cut(self, index):
        self._set("CutAxis", AXES[index])
        for widget in (self.position, self.flip):
            widget.setEnabled(index > 0)

    def _cut_moved(self, value):
        if self.position.isSliderDown():  # a macro needs the last position only
            self.view.CutPosition = value
        else:
            self._set("CutPosition", value)

    def _below(self, value):
        self._set("ShowBelow", value)
        self._count()

    def _ten_worst(self):
        elements = self._elements()
        if elements is not None and len(elements.quality) > 10:
            import numpy as np

            # rounded up: the spin box has three digits
            self.below.setValue(min(1.0, float(np.ceil(np.partition(elements.quality, 9)[9] * 1000 + 1e-9)) / 1000))

    def _set(self, name, value):
        if getattr(self.view, name) != value:
            record.set_view(self.mesh, name, value)

    def getStandardButtons(self):
        return messages.number_of(QtGui.QDialogButtonBox.Close)

    def reject(self):
        if not self.keep.isChecked() and self._before != "Quality":
            self._set("DisplayMode", self._before)
            if self._hidden:
                record.show(self._hidden, True)
        FreeCADGui.Control.closeDialog()
        return True

    def isAllowedAlterDocument(self):
        return True

    def isAllowedAlterView(self):
        return True

    def isAllowedAlterSelection(self):
        return True


current = None


def open_panel(mesh):
    global current
    if FreeCADGui.Control.activeDialog():
        messages.tell(tr("Another task is open: close it first."))
        return None
    current = QualityPanel(mesh)
    FreeCADGui.Control.showDialog(current)
    return current
