# HexFeatureWB - LGPL-2.1-or-later
"""Input widgets made from the core's list of options, so that a new option appears without a line here."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..translate import tr


NARROW = 190  #: pixels that a row of a panel may need
SETTLED = 150  #: ms after which a panel's layout may have settled


def _titles():
    return {
        "method": tr("Method"),
        "order": tr("Element order"),
        "labels": tr("Labels"),
        "capture": tr("Edges to follow"),
        "sheets": tr("O-grid sheets"),
        "minimum_layers": tr("Layers, at least"),
        "beta": tr("Smoothing speed of the paper's labels"),
        "smoothing_rounds": tr("Smoothing rounds of the paper's labels"),
        "crease_angle": tr("Crease angle of triangle surfaces (degrees)"),
        "time_limit": tr("Time limit (s), 0: none"),
        "memory_limit": tr("Memory limit (MB), 0: none"),
        "threads": tr("Threads"),
    }


def has_title(option):
    return option in _titles()


def title_of(option):
    """What a person calls an option; a new one is called by its name."""
    return _titles().get(option, option.replace("_", " ").capitalize())


def choice_title(option, choice):
    """What a person calls a choice of an option."""
    return {
        ("method", "auto"): tr("automatic"),
        ("method", "feature-line"): tr("feature lines"),
        ("method", "tet-split"): tr("from tetrahedra, of low quality"),
        ("labels", "regions"): tr("on CAD regions"),
        ("labels", "paper"): tr("the paper's, on triangles"),
        ("capture", "all"): tr("all CAD edges"),
        ("capture", "sharp"): tr("sharp CAD edges"),
        ("order", 1): tr("first (8 nodes)"),
        ("order", 2): tr("second (20 nodes)"),
    }.get((option, choice), str(choice))


class OptionWidget:
    """One option as `widget`; `changed` is called without arguments when the user changes it."""

    def __init__(self, spec, value, changed):
        self.spec = spec
        if spec["name"] == "order" or spec["choices"]:
            self._values = [1, 2] if spec["name"] == "order" else list(spec["choices"])
            self.widget = QtGui.QComboBox()
            self.widget.addItems([choice_title(spec["name"], v) for v in self._values])
            # A long choice must not make the panel wide.
            self.widget.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
            self.widget.setMinimumContentsLength(8)
            signal = self.widget.currentIndexChanged
        elif spec["type"] == "bool":
            self.widget = QtGui.QCheckBox()
            signal = self.widget.toggled
        elif spec["type"] in ("int", "float"):
            self.widget = QtGui.QSpinBox() if spec["type"] == "int" else QtGui.QDoubleSpinBox()
            low, high = spec["minimum"], spec["maximum"]
            self.widget.setRange(-1e9 if low is None else low, 1e9 if high is None else high)
            self.widget.setKeyboardTracking(False)
            signal = self.widget.valueChanged
        else:
            self.widget = QtGui.QLineEdit()
            signal = self.widget.editingFinished
        self.widget.setObjectName("option_" + spec["name"])
        self.widget.setToolTip(tr(spec["help"]))
        self.set_value(value)
        signal.connect(lambda *_: changed())

    def value(self):
        if isinstance(self.widget, QtGui.QComboBox):
            return self._values[self.widget.currentIndex()]
        if isinstance(self.widget, QtGui.QCheckBox):
            return self.widget.isChecked()
        if isinstance(self.widget, QtGui.QLineEdit):
            return self.widget.text()
        return self.widget.value()

    def set_value(self, value):
        if isinstance(self.widget, QtGui.QComboBox):
            self.widget.setCurrentIndex(self._values.index(value) if value in self._values else 0)
        elif isinstance(self.widget, QtGui.QCheckBox):
            self.widget.setChecked(bool(value))
        elif isinstance(self.widget, QtGui.QLineEdit):
            self.widget.setText(str(value))
        else:
            self.widget.setValue(value)


class LengthEdit:
    """FreeCAD's own input of a length with its unit: takes "4 mm", "0.2 in", "1+2"."""

    def __init__(self, name, changed):
        self.widget = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        self.widget.setObjectName(name)
        self.widget.setProperty("unit", "mm")
        self.widget.setProperty("minimum", 0.0)
        self.widget.setProperty("maximum", 1e6)  # the widget is as wide as its longest number
        QtCore.QObject.connect(self.widget, QtCore.SIGNAL("valueChanged(double)"), lambda value: changed(value))

    def value(self):
        """In mm."""
        return float(self.widget.property("rawValue"))

    def set_value(self, millimetres):
        self.widget.setProperty("rawValue", millimetres)

    def set_step(self, millimetres):
        self.widget.setProperty("singleStep", millimetres)


def beside_or_below(*widgets):
    """A layout of widgets side by side, or one below the other where a language's words would make FreeCAD's task column too wide."""
    wide = sum(widget.sizeHint().width() for widget in widgets) > NARROW
    row = QtGui.QVBoxLayout() if wide else QtGui.QHBoxLayout()
    for widget in widgets:
        row.addWidget(widget)
    return row


def nice(value):
    """Three significant digits."""
    return float("%.3g" % value)


def _language():
    """FreeCAD's language, which may be another than the system's."""
    return QtCore.QLocale(FreeCADGui.supportedLocales().get(FreeCADGui.getLocale(), "en"))


def number(value):
    """A count for people, as FreeCAD's language has it: 12,345. A space parts the digits where FreeCAD writes lengths, beside it, in the
    system's way with that same sign as decimal point."""
    sign = _language().groupSeparator()
    return "{:,}".format(round(value)).replace(",", "\N{NO-BREAK SPACE}" if sign == QtCore.QLocale().decimalPoint() else sign)


def decimal(value, digits, form="f"):
    """A number with so many digits behind the point, or what FreeCAD's language has for one; form "g": with so many digits."""
    return _language().toString(float(value), form, digits)


def length(millimetres):
    """A length in the units that the user has chosen in FreeCAD."""
    return FreeCAD.Units.Quantity(millimetres, FreeCAD.Units.Length).UserString


class Words(QtGui.QLabel):
    """A text of several lines that is never cut and never squeezes what is above it: Qt forgets the height of wrapped lines."""

    def __init__(self, name):
        super().__init__()
        self.setObjectName(name)
        self.setWordWrap(True)
        self.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        self._later = QtCore.QTimer(self)
        self._later.setSingleShot(True)
        self._later.timeout.connect(self._scroll)

    def setText(self, text):
        super().setText(text)
        self._make_room()

    def reveal(self):
        """Scroll the panel until the text is seen, once the layout has settled."""
        self._tries = 5
        self._later.start(SETTLED)

    def _scroll(self):
        # Not from parent to parent: PySide makes each of them an owner, and forgets what they own (the LengthEdit) when they go.
        for area in FreeCADGui.getMainWindow().findChildren(QtGui.QScrollArea):
            if area.isAncestorOf(self):
                area.ensureWidgetVisible(self)
        self._tries -= 1
        if self._tries and self.visibleRegion().boundingRect().height() < self.height():
            self._later.start(SETTLED)

    def resizeEvent(self, event):
        super().resizeEvent(event)
        self._make_room()

    def _make_room(self):
        self.setMinimumHeight(self.heightForWidth(self.width()) if self.text() else 0)


class Fold(QtGui.QWidget):
    """A title that opens and closes what is under it."""

    def __init__(self, title, content, opened=False):
        super().__init__()
        self.button = QtGui.QToolButton()
        self.button.setText(title)
        self.button.setCheckable(True)
        self.button.setAutoRaise(True)
        self.button.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
        self.content = content
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.button)
        column.addWidget(content)
        self.button.toggled.connect(self._show)
        self.button.setChecked(opened)
        self._show(opened)

    def _show(self, opened):
        self.button.setArrowType(QtCore.Qt.DownArrow if opened else QtCore.Qt.RightArrow)
        self.content.setVisible(opened)
