# HexFeatureWB - LGPL-2.1-or-later
"""*Batch*: files in, a folder of meshes out, row by row, in a worker thread; the window stays alive."""
import os
import time

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .. import batch, mesh_object, meshing
from ..job import Job
from ..source import brep_of
from ..translate import tr
from . import messages, record, settings
from .run import PATIENCE, POLL, POLL_CANCELLED
from .widgets import LengthEdit, OptionWidget, decimal, title_of

SHOWN = ("file", "solid", "result", "hexes", "min_sj", "mean_sj", "seconds", "why")
SOURCES = "*.step *.stp *.iges *.igs *.brep *.brp *.FCStd"


class BatchDialog(QtGui.QDialog):
    def __init__(self, parent=None):
        super().__init__(parent)
        self.setWindowTitle(tr("Batch of hex meshes"))
        self.setWindowIcon(messages.qicon("HexFeature_Batch"))
        self.resize(960, 560)
        self.rows, self._items, self._item, self.job, self._cancelled = [], None, None, None, False
        self._timer = QtCore.QTimer(self)
        self._timer.timeout.connect(self._look)
        column = QtGui.QVBoxLayout(self)
        column.addLayout(self._build_inputs())
        self.table = QtGui.QTableWidget(0, len(SHOWN))
        self.table.setObjectName("table")
        self.table.setHorizontalHeaderLabels(
            [tr("File"), tr("Solid"), tr("Result"), tr("Hexahedra"), tr("Worst SJ"), tr("Mean SJ"), tr("Seconds"), tr("Why not")])
        self.table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        self.table.verticalHeader().hide()
        self.table.horizontalHeader().setStretchLastSection(True)
        for column_number, width in enumerate((180, 70, 90, 90, 80, 80, 80)):
            self.table.setColumnWidth(column_number, width)
        column.addWidget(self.table)
        self.state = QtGui.QLabel(tr("Each solid leaves a FreeCAD document with its mesh, a .unv file and a report."))
        self.state.setObjectName("state")
        column.addWidget(self.state)
        row = QtGui.QHBoxLayout()
        self.start_button = QtGui.QPushButton(tr("Start"))
        self.cancel_button = QtGui.QPushButton(tr("Cancel"))
        close = QtGui.QPushButton(tr("Close"))
        for button, name, slot in ((self.start_button, "start_button", self.start), (self.cancel_button, "cancel_button", self.cancel),
                                   (close, "close_button", self.reject)):
            button.setObjectName(name)
            button.clicked.connect(slot)
            row.addWidget(button)
        row.insertStretch(0)
        self.cancel_button.setEnabled(False)
        column.addLayout(row)

    def _build_inputs(self):
        grid = QtGui.QFormLayout()
        grid.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        self.files = QtGui.QPlainTextEdit()
        self.files.setObjectName("files")
        self.files.setMaximumHeight(90)
        self.files.setPlaceholderText(tr("one file a line: STEP, IGES, BREP or FreeCAD documents; with a size of its own: part.step; 4 mm"))
        choose = QtGui.QPushButton(tr("Add files ..."))
        choose.clicked.connect(self._choose_files)
        row = QtGui.QHBoxLayout()
        row.addWidget(self.files)
        row.addWidget(choose)
        grid.addRow(tr("Files"), row)
        self.folder = QtGui.QLineEdit(os.path.join(os.path.expanduser("~"), "hexmeshes"))
        self.folder.setObjectName("folder")
        browse = QtGui.QPushButton(tr("Choose ..."))
        browse.clicked.connect(self._choose_folder)
        row = QtGui.QHBoxLayout()
        row.addWidget(self.folder)
        row.addWidget(browse)
        grid.addRow(tr("Into the folder"), row)
        self.size = LengthEdit("size", lambda value: None)
        self.size.widget.setToolTip(tr("0: each part gets a size of its own, for about 3,000 elements"))
        grid.addRow(tr("Element size, 0: chosen for each"), self.size.widget)
        spec = next(s for s in mesh_object.options_shown() if s["name"] == "order")
        self.order = OptionWidget(spec, settings.option_default(spec), lambda: None)
        grid.addRow(title_of("order"), self.order.widget)
        return grid

    def _choose_files(self):
        chosen = QtGui.QFileDialog.getOpenFileNames(self, tr("Batch"), "", "%s (%s)" % (tr("CAD files"), SOURCES))[0]
        for path in chosen:
            self.files.appendPlainText(path)

    def _choose_folder(self):
        chosen = QtGui.QFileDialog.getExistingDirectory(self, tr("Into the folder"), self.folder.text())
        if chosen:
            self.folder.setText(chosen)

    def start(self):
        """Read and write in the main thread, item by item; mesh in the worker."""
        try:
            files = self._files()
        except ValueError as error:
            self.state.setText(tr("Not a length: %s") % error)
            return
        out = self.folder.text().strip()
        if not files or not out:
            self.state.setText(tr("Give files and a folder."))
            return
        try:
            os.makedirs(out, exist_ok=True)
        except OSError as error:
            self.state.setText(tr("Cannot make the folder: %s") % error.strerror)
            return
        self.options = {spec["name"]: settings.option_default(spec) for spec in settings.option_specs()}
        self.options["order"] = self.order.value()
        if self.size.value() > 0:
            self.options["size"] = self.size.value()
        self._given, self.out, self.rows = files, out, []
        self.table.setRowCount(0)
        self._items, self._cancelled = batch.items(files, out), False
        self.start_button.setEnabled(False)
        self.cancel_button.setEnabled(True)
        self._next()
        self._timer.start(POLL)

    def cancel(self):
        self._items, self._cancelled = iter(()), True
        if self.job is not None:
            self.job.cancel()
            self._give_up_at = time.monotonic() + PATIENCE
            self._timer.setInterval(POLL_CANCELLED)

    def _next(self):
        """Begin the next solid; rows of files that cannot be read go into the table on the way."""
        self._item = self.job = None
        for item in self._items:
            if isinstance(item, batch.Item):
                self._item, self._began = item, time.time()
                options = item.options(self.options)
                self.job = Job(brep_of(item.shape), dict(options, size=options.get("size", 0.0))).start()
                return
            self._add(item)
            return

    def _look(self):
        job, item = self.job, self._item
        if job is not None and job.is_alive():
            if not job.was_cancelled:
                self.state.setText("%s: %s, %s s" % (os.path.basename(item.file), messages.step_title(job.step), decimal(job.seconds, 1)))
                return
            if time.monotonic() < self._give_up_at:
                return
        if job is not None:
            self.job = None
            error, report = meshing.cancelled_error(job.step) if job.was_cancelled else job.error, None
            if error is None:
                try:
                    # Through the same function as without a window; it takes the worker's result.
                    meshing.offer(job.brep, job.options, job.result)
                    report = batch.mesh_one(item.shape, item.stem, item.options(self.options))
                except Exception as caught:  # one part must not end the batch
                    error = caught
            self._add(batch.row_of(item, self._began, report, error))
        self._next()
        if self.job is None and self._finished():
            self._timer.stop()
            self.start_button.setEnabled(True)
            self.cancel_button.setEnabled(False)
            try:
                self._write_summary()
            except OSError as error:
                self.state.setText(tr("Cannot write summary.csv: %s") % error.strerror)
                return
            meshed = sum(row["result"] == "meshed" for row in self.rows)
            self.state.setText(tr("%(meshed)d of %(all)d meshed; summary.csv is in %(folder)s") % {
                "meshed": meshed, "all": len(self.rows), "folder": self.out})

    def _write_summary(self):
        """By the line that the macro recorder sees; a batch that was given up is not recorded. Raises OSError."""
        if self._cancelled:
            batch.write_summary(self.rows, self.out)
            return
        batch.offer(self._given, self.out, self.options, self.rows)
        record.do("import HexFeatureWB.batch")
        record.do("HexFeatureWB.batch.run(%r, %r, %r)" % (self._given, self.out, self.options))

    def _files(self):
        """The paths; (path, size) where a line ends in a size of its own after a semicolon. Raises ValueError with the line."""
        files = []
        for line in (line.strip() for line in self.files.toPlainText().splitlines()):
            path, semicolon, size = (part.strip() for part in line.rpartition(";"))
            if not line or semicolon and not path:
                continue
            if not semicolon or os.path.isfile(line):  # a semicolon may be in the path
                files.append(line)
            elif size:
                try:
                    value = FreeCAD.Units.Quantity(size)
                except (ValueError, FreeCAD.Base.FreeCADError):
                    raise ValueError(line) from None
                if value.Value <= 0 or value.Unit not in (FreeCAD.Units.Length, FreeCAD.Units.Unit()):
                    raise ValueError(line)
                files.append((path, float(value.Value)))
            else:
                files.append(path)
        return files

    def _finished(self):
        """Whether nothing is left: looks one item ahead."""
        if self._item is not None:
            return False
        for item in self._items:
            self._items = _before(item, self._items)
            return False
        return True

    def _add(self, row):
        self.rows.append(row)
        at = self.table.rowCount()
        self.table.insertRow(at)
        for column, name in enumerate(SHOWN):
            words = str(messages.batch_words(name, row[name]))  # the summary's own stay as they are: programs read them
            cell = QtGui.QTableWidgetItem(os.path.basename(words) if name == "file" else words)
            cell.setToolTip(words)
            if name == "result" and row[name] != "meshed":
                cell.setForeground(QtGui.QBrush(QtGui.QColor(200, 60, 40)))
            self.table.setItem(at, column, cell)
        self.table.scrollToBottom()

    def reject(self):
        self._timer.stop()
        self.cancel()
        super().reject()


def _before(first, rest):
    yield first
    yield from rest


current = None


def open_dialog():
    """The dialog, beside the main window, not in front of it."""
    global current
    current = BatchDialog(FreeCADGui.getMainWindow())
    current.show()
    return current
