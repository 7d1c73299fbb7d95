# HexFeatureWB - LGPL-2.1-or-later
"""The preferences page: defaults of a new mesh, and what the window does."""
from PySide import QtGui

from .. import core
from ..translate import tr
from . import settings
from .widgets import OptionWidget, title_of


class PreferencesPage:
    """FreeCAD makes it when the preferences are opened, and calls loadSettings and saveSettings."""

    def __init__(self, parent=None):
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(tr("Hex mesh"))
        column = QtGui.QVBoxLayout(self.form)
        self.options, self.switches = [], {}
        problem = core.problem()
        if problem:
            label = QtGui.QLabel(problem)
            label.setWordWrap(True)
            column.addWidget(label)
        else:
            box = QtGui.QGroupBox(tr("Defaults of a new mesh"))
            grid = QtGui.QFormLayout(box)
            for spec in settings.option_specs():
                option = OptionWidget(spec, settings.option_default(spec), lambda: None)
                self.options.append(option)
                grid.addRow(title_of(spec["name"]), option.widget)
            column.addWidget(box)
        box = QtGui.QGroupBox(tr("Window"))
        rows = QtGui.QVBoxLayout(box)
        for name, (_, text) in settings.SWITCHES.items():
            self.switches[name] = check = QtGui.QCheckBox(tr(text))
            check.setObjectName(name)
            rows.addWidget(check)
        column.addWidget(box)
        column.addStretch()

    def loadSettings(self):
        for option in self.options:
            option.set_value(settings.option_default(option.spec))
        for name, check in self.switches.items():
            check.setChecked(settings.switch(name))

    def saveSettings(self):
        for option in self.options:
            settings.set_option_default(option.spec, option.value())
        for name, check in self.switches.items():
            settings.set_switch(name, check.isChecked())
