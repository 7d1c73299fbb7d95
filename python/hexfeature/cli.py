# HexFeatureWB - LGPL-2.1-or-later
"""The command line: hexfeature mesh | info | version.

Exit codes: 0 done, 2 usage, 3 bad input, 4 no mesh, 5 output, 130 cancelled. Errors go to standard error as step, reason
and hint; so does progress; data goes to standard output.
"""
import argparse
import sys
import time

from hexfeature import _core, api
from hexfeature.errors import EXIT_CODES, MeshingError, make_error, system_error

STEPS_WITHOUT_PICTURE = ("read", "frame")
INTERNAL = "internal error"  #: how the reason of an error that nobody foresaw begins
CONFIG_HINT = 'it should read like {"size": 4, "order": 2}'


def main(arguments=None, guarded=False):
    """Run the command line; returns the exit code. Never raises. `guarded`: the work runs in a process of its own (guard)."""
    verbose = "--verbose" in (sys.argv[1:] if arguments is None else arguments)

    def command():
        choice = _parser().parse_args(arguments)
        choice.guarded = guarded
        return choice.run(choice)

    return _told(command, verbose)


def _told(command, verbose):
    """command()'s exit code; what it raises is told on standard error and becomes the exit code."""
    try:
        return command()
    except BrokenPipeError:
        return EXIT_CODES["output"]
    except SystemExit as end:  # argparse: 0 after --help, 2 after a mistake
        return end.code
    except (Exception, KeyboardInterrupt) as error:
        typed = _typed(error)
        if verbose and typed.reason.startswith(INTERNAL):
            raise
        return _tell(typed)


def _typed(error):
    """Any exception as a MeshingError."""
    if isinstance(error, MeshingError):
        return error
    if isinstance(error, KeyboardInterrupt):
        return make_error("cancelled", "run", "cancelled")
    if isinstance(error, MemoryError):
        return make_error("no_mesh", "run", "out of memory", "use a larger size")
    return make_error("no_mesh", "run", f"{INTERNAL}: {type(error).__name__}: {error}",
                      "run again with --verbose and report what it prints")


def _guarded(choice, work, stopped=lambda error: None, time_limit=0, outputs=()):
    """work(at, tell) -> exit code, by a guarded worker where there may be one; `stopped` is told of the guard's own error."""
    from hexfeature import guard

    if not (choice.guarded and guard.available()):
        return work(lambda step: None, lambda: None)
    verbose = getattr(choice, "verbose", False)
    try:
        return guard.run(lambda board: _told(lambda: work(board.put, board.tell), verbose), time_limit, [path for path in outputs if path])
    except MeshingError as error:
        stopped(error)
        raise


def _tell(error):
    sys.stderr.write(f"hexfeature: error in step {error.step}: {error.reason}\n")
    if error.cad_faces:
        names = ", ".join(f"Face{f}" for f in error.cad_faces[:20])
        sys.stderr.write(f"  at: {names}{' ...' if len(error.cad_faces) > 20 else ''}\n")
    if error.hint:
        sys.stderr.write(f"  hint: {error.hint}\n")
    return EXIT_CODES.get(error.kind, EXIT_CODES["no_mesh"])


# ---------------------------------------------------------------- arguments
class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise make_error("usage", "options", message, f"see {self.prog} --help")


def _parser():
    parser = _Parser(prog="hexfeature", description="All-hexahedral meshes of CAD parts, by feature-line extraction.")
    commands = parser.add_subparsers(metavar="COMMAND", required=True)

    mesh = commands.add_parser("mesh", help="mesh a part", description="Mesh a part.")
    mesh.set_defaults(run=_mesh)
    _add_part(mesh)
    mesh.add_argument("-o", "--output", metavar="MESH", help="mesh file; the format by its ending: .vtk .vtu .inp .unv .med .msh")
    mesh.add_argument("--report", metavar="R.json", help="write what was done and how good it is")
    mesh.add_argument("--config", metavar="C.json", help="options as JSON, {\"size\": 4, ...}; the command line's own come first")
    mesh.add_argument("--element-type", default="", metavar="TYPE", help=".inp: C3D8, C3D8R, C3D8I; order 2: C3D20R, C3D20")
    mesh.add_argument("--verbose", action="store_true", help="say every step, and print a traceback of an internal error")
    mesh.add_argument("--quiet", action="store_true", help="print nothing but errors")
    advanced = mesh.add_argument_group("advanced options")
    for option in api.options():
        _add_option(advanced if option.advanced else mesh, option)

    info = commands.add_parser("info", help="read a part and print what it is, as JSON", description="Read a part and print what it is.")
    info.set_defaults(run=_info)
    _add_part(info)

    version = commands.add_parser("version", help="print the version")
    version.set_defaults(run=_version)
    return parser


def _add_part(parser):
    parser.add_argument("part", metavar="PART", help=".step .stp .iges .igs .brep .brp .stl .obj .ply .FCStd")
    parser.add_argument("--object", metavar="NAME", help=".FCStd: name or label of the object, when there is more than one solid")


def _add_option(group, option):
    flag = "--" + option.name.replace("_", "-")
    text = option.help.replace("%", "%%")
    if option.type == "bool":
        group.add_argument(flag, action=argparse.BooleanOptionalAction, default=argparse.SUPPRESS, help=text)
        return
    default = f" (default {option.default})" if option.default != "" and option.name != "size" else ""
    names = [c for c in option.choices if c]
    kind, metavar = {"float": (float, "X"), "int": (int, "N"), "str": (str, "TEXT")}[option.type]
    if names:
        metavar = "{" + ",".join(names) + "}"
    group.add_argument(flag, type=kind, default=argparse.SUPPRESS, metavar=metavar, help=text + default)


def _options_of(choice):
    """The config file's options, overruled by the command line's."""
    chosen = _read_config(choice.config) if choice.config else {}
    chosen.update({o.name: getattr(choice, o.name) for o in api.options() if hasattr(choice, o.name)})
    return chosen


def _read_config(path):
    import json

    try:
        with open(path, encoding="utf-8") as file:
            config = json.load(file)
    except OSError as error:
        raise system_error("usage", "options", f"cannot read '{path}'", error, "check the name of the options file") from None
    except ValueError as error:
        raise make_error("usage", "options", f"'{path}' is not valid JSON: {error}", CONFIG_HINT) from None
    if not isinstance(config, dict):
        raise make_error("usage", "options", f"'{path}' must hold an object", CONFIG_HINT)
    return config


# ---------------------------------------------------------------- commands
def _mesh(choice):
    from hexfeature import formats

    started = time.monotonic()
    options = _options_of(choice)
    _check_outputs(choice, options.get("stop_after", ""), formats)
    limit = options.get("time_limit", 0)
    limit = limit if isinstance(limit, (int, float)) and limit > 0 else 0  # the core says what is wrong with another
    return _guarded(choice, lambda at, tell: _make_mesh(choice, options, started, at, tell),
                    lambda error: _report_failure(choice, error, started), limit, (choice.output, choice.report))


def _make_mesh(choice, options, started, at, tell):
    """The work itself; `at(step)` is told where it is, `tell()` that it has stopped with an error."""
    from hexfeature import report

    stop_after = options.get("stop_after", "")
    progress = Progress(choice.verbose, choice.quiet, at)
    try:
        mesh = api.mesh(choice.part, object_name=choice.object, progress=progress.callback, log=progress.log, **options)
        progress.done()
        at("write")
        if choice.output and stop_after:
            mesh.write_stage(stop_after, choice.output)
        elif choice.output:
            mesh.write(choice.output, choice.element_type)
        at("written")
    except (Exception, KeyboardInterrupt) as error:
        tell()
        progress.done()
        _report_failure(choice, _typed(error), started)
        raise
    if choice.report:
        report.write(report.of_mesh(mesh, choice.part, time.monotonic() - started), choice.report)
    if not choice.quiet:
        for warning in mesh.report["warnings"]:
            sys.stderr.write(f"hexfeature: warning: {warning}\n")
        sys.stderr.write(report.summary(mesh.report) + "\n")
    return 0


def _report_failure(choice, error, started):
    from hexfeature import report

    if choice.report:
        report.write(report.of_error(error, choice.part, time.monotonic() - started), choice.report)


def _check_outputs(choice, stop_after, formats):
    """Before the work: what could not be written afterwards."""
    if choice.output and stop_after in STEPS_WITHOUT_PICTURE:
        raise make_error("usage", "options", f"there is nothing to write after step '{stop_after}'", "leave -o out and ask for a --report")
    if choice.output:
        formats.check_output(choice.output, [".vtk"] if stop_after else None)
    elif not stop_after:
        raise make_error("usage", "options", "no mesh file given", "add -o MESH, as in -o part.vtk")
    if choice.report:
        formats.check_output(choice.report, [])


def _info(choice):
    return _guarded(choice, lambda at, tell: _print_info(choice, at))


def _print_info(choice, at):
    import json

    at("read")
    mesh = api.mesh(choice.part, object_name=choice.object, stop_after="read")
    facts = dict(mesh.report["part"], warnings=mesh.report["warnings"], suggested_size=mesh.report["options"]["size"])
    print(json.dumps({"part_file": choice.part, **facts}, indent=1))
    return 0


def _version(_choice):
    print(_core.__version__)
    return 0


class Progress:
    """Progress on standard error: one changing line on a terminal, a line a step with --verbose, else nothing."""

    def __init__(self, verbose, quiet, at):
        self._verbose = verbose
        self._live = not quiet and not verbose and sys.stderr.isatty()
        self._at = at
        self._step, self._shown = "", 0.0
        self.log = self._log if verbose else None

    def callback(self, step, fraction):
        """What to hand to `mesh`."""
        if step != self._step:
            self._at(step)
            if self._verbose:
                self._log(f"step {step}")
        if self._live and (step != self._step or time.monotonic() - self._shown > 0.1):
            sys.stderr.write(f"\r\033[K{step} {100 * fraction:3.0f}%")
            sys.stderr.flush()
            self._shown = time.monotonic()
        self._step = step

    def done(self):
        if self._live:
            sys.stderr.write("\r\033[K")

    def _log(self, line):
        sys.stderr.write(line + "\n")
