// HexFeatureWB - LGPL-2.1-or-later
// The extension module hexfeature._core: options in, numpy views out. No logic of its own.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <new>
#include <optional>

#include "base/share.h"
#include "bindings/convert.h"
#include "pipeline/pipeline.h"
#include "write/write.h"

namespace py = pybind11;
using namespace hexfeature;

namespace {

const char* name_of(Failure kind) {
  switch (kind) {
    case Failure::Usage:
      return "usage";
    case Failure::BadInput:
      return "bad_input";
    case Failure::NoMesh:
      return "no_mesh";
    case Failure::Output:
      return "output";
    case Failure::Cancelled:
      return "cancelled";
  }
  return "no_mesh";
}

Options options_from(const py::dict& values) {
  Options options;
  for (const auto& [key, value] : values) {
    const std::string name = py::cast<std::string>(key);
    if (py::isinstance<py::bool_>(value))
      set_option(options, name, py::cast<bool>(value));
    else if (py::isinstance<py::int_>(value))
      set_option(options, name, py::cast<double>(value));
    else if (py::isinstance<py::float_>(value))
      set_option(options, name, py::cast<double>(value));
    else if (py::isinstance<py::str>(value))
      set_option(options, name, py::cast<std::string>(value));
    else
      throw MeshingError(Failure::Usage, "options", name + " must be a number, a text, true or false", "see hexfeature mesh --help");
  }
  return options;
}

/// A context that calls back into Python. Progress and log take the GIL; cancellation is polled at most every 20 ms,
/// so that it costs nothing, and Python's own signals (Ctrl-C) are seen there too.
class PythonContext : public Context {
 public:
  PythonContext(py::object progress, py::object log, py::object cancelled) {
    if (!progress.is_none())
      on_progress = [f = progress](const std::string& step, double fraction) {
        py::gil_scoped_acquire gil;
        f(step, fraction);
      };
    if (!log.is_none())
      on_log = [f = log](const std::string& line) {
        py::gil_scoped_acquire gil;
        f(text_of(line));
      };
    is_cancelled = [this, f = cancelled] {
      const Clock::rep now = Clock::now().time_since_epoch().count();  // asked by any thread
      if (Clock::duration(now - last_.load(std::memory_order_relaxed)) < std::chrono::milliseconds(20)) return false;
      last_.store(now, std::memory_order_relaxed);
      py::gil_scoped_acquire gil;
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      return !f.is_none() && py::cast<bool>(f());
    };
  }

 private:
  std::atomic<Clock::rep> last_{0};
};

template <class Mesh>
std::shared_ptr<Result> run(const Mesh& mesh, const py::dict& values, const py::object& progress, const py::object& log,
                            const py::object& cancelled) {
  const Options options = options_from(values);
  PythonContext context(progress, log, cancelled);
  context.limit_memory(static_cast<std::size_t>(options.memory_limit * 1e6));
  auto result = std::make_shared<Result>();
  std::optional<MeshingError> out_of_memory;
  {
    py::gil_scoped_release release;
    out_of_memory = run_with_share(context, 1, [&] { *result = mesh(options, context); });
  }
  if (out_of_memory) throw *out_of_memory;
  return result;
}

py::list list_of_options() {
  py::list list;
  const Options defaults;
  for (const OptionSpec& spec : option_list()) {
    py::dict d;
    d["name"] = spec.name;
    const OptionValue value = get_option(defaults, spec);
    d["type"] = std::array<const char*, 4>{"float", "int", "bool", "str"}[value.index()];
    d["default"] = std::visit([](const auto& v) { return py::cast(v); }, value);
    d["minimum"] = spec.maximum > spec.minimum ? py::cast(spec.minimum) : py::none();
    d["maximum"] = spec.maximum > spec.minimum ? py::cast(spec.maximum) : py::none();
    d["choices"] = spec.choices;
    d["advanced"] = spec.advanced;
    d["help"] = spec.help;
    list.append(d);
  }
  return list;
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  m.doc() = "HexFeatureWB's core: all-hexahedral meshes of CAD solids by feature-line extraction.";

  static PyObject* error_type = PyErr_NewExceptionWithDoc(
      "hexfeature._core.MeshingError", "A typed failure: kind, step, reason, hint, cad_faces (1-based).", PyExc_RuntimeError, nullptr);
  m.attr("MeshingError") = py::handle(error_type);
  m.attr("__version__") = HEXFEATURE_VERSION;
  m.attr("writable_endings") = py::cast(writable_endings());
  py::register_exception_translator([](std::exception_ptr p) {
    try {
      if (p) std::rethrow_exception(p);
    } catch (const MeshingError& e) {
      py::object error = py::reinterpret_borrow<py::object>(error_type)(text_of(e.what()));
      error.attr("kind") = name_of(e.kind);
      error.attr("step") = e.step;
      error.attr("reason") = text_of(e.reason);
      error.attr("hint") = text_of(e.hint);
      error.attr("cad_faces") = e.cad_faces;
      PyErr_SetObject(error_type, error.ptr());
    }
  });

  m.def("option_list", &list_of_options, "Every option: dicts of name, type, default, minimum, maximum, choices, advanced, help.");
  m.def(
      "mesh_file",
      [](const std::string& path, const py::dict& options, const py::object& progress, const py::object& log, const py::object& cancelled) {
        return run([&](const Options& o, Context& c) { return mesh_file(path, o, c); }, options, progress, log, cancelled);
      },
      py::arg("path"), py::arg("options") = py::dict(), py::arg("progress") = py::none(), py::arg("log") = py::none(),
      py::arg("cancelled") = py::none(), "Read a part file and mesh it. Raises MeshingError.");
  m.def(
      "mesh_brep",
      [](const std::string& brep, const py::dict& options, const py::object& progress, const py::object& log, const py::object& cancelled,
         const py::object& look) {
        Look show;
        if (!look.is_none())
          show = [&look](std::shared_ptr<Result> result, int solid, bool final) {
            py::gil_scoped_acquire gil;
            look(std::move(result), solid, final);
          };
        return run([&](const Options& o, Context& c) { return mesh_brep_string(brep, o, c, show); }, options, progress, log, cancelled);
      },
      py::arg("brep"), py::arg("options") = py::dict(), py::arg("progress") = py::none(), py::arg("log") = py::none(),
      py::arg("cancelled") = py::none(), py::arg("look") = py::none(),
      "Mesh a B-rep given as text. look(result, solid, final): for a preview, called with the stages labels and shape of each solid, as "
      "soon as there are some and when they are final; stop_after then ends the run at the last solid. Raises MeshingError.");

  bind_arrays(m);

  using Pointer = std::shared_ptr<Result>;
  py::class_<Result, Pointer>(m, "Result", "A mesh and how it came about; arrays are read-only views.")
      .def_readonly("method", &Result::method)
      .def_readonly("certified", &Result::certified)
      .def_readonly("stopped_after", &Result::stopped_after)
      .def_property_readonly("points", [](const Pointer& r) { return view(r->mesh.points, r); })
      .def_property_readonly("hexes", [](const Pointer& r) { return view(r->mesh.hexes, r); })
      .def_property_readonly("hex_solid", [](const Pointer& r) { return view(r->mesh.hex_solid, r); })
      .def_property_readonly("solid_groups",
                             [](const Pointer& r) {
                               py::dict groups;
                               for (const NamedSolids& group : named_solids(r->solid_names)) groups[py::str(group.name)] = group.solids;
                               return groups;
                             })
      .def_property_readonly("quads", [](const Pointer& r) { return view(r->mesh.quads, r); })
      .def_property_readonly("quad_face", [](const Pointer& r) { return view(r->mesh.quad_face, r); })
      .def_property_readonly("quad_chart", [](const Pointer& r) { return view(r->mesh.quad_chart, r); })
      .def_property_readonly("node_dim", [](const Pointer& r) { return field(r->mesh.place, &CadPlace::dim, r); })
      .def_property_readonly("node_entity", [](const Pointer& r) { return field(r->mesh.place, &CadPlace::entity, r); })
      .def_property_readonly("feature_edges", [](const Pointer& r) { return view(r->mesh.feature_edges, r); })
      .def_property_readonly("feature_edge_cad", [](const Pointer& r) { return view(r->mesh.feature_edge_cad, r); })
      .def_property_readonly("hexes20", [](const Pointer& r) { return view(r->hexes20, r); })
      .def_property_readonly("quads8", [](const Pointer& r) { return view(r->quads8, r); })
      .def(
          "write",
          [](const Result& r, const std::string& path, const std::string& element_type) {
            py::gil_scoped_release release;
            try {
              write_mesh({r.mesh, r.hexes20, r.quads8, r.solid_names}, path, {element_type});
            } catch (const std::bad_alloc&) {
              throw MeshingError(Failure::Output, "write", "cannot write '" + path + "': out of memory", "use a larger size");
            }
          },
          py::arg("path"), py::arg("element_type") = "", "Write the mesh by the path's ending (writable_endings). Raises MeshingError.")
      .def(
          "report", [](const Pointer& r) { return report_of(*r); }, "Everything of the report as a dict.")
      .def(
          "stage", [](const Pointer& r, const std::string& name) { return stage_of(r, name); }, py::arg("name"),
          "An intermediate result as a dict of arrays: surface, labels, shape, polycube, lattice, fit, sheets, smooth.");
}
