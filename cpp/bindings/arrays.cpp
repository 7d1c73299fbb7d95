// HexFeatureWB - LGPL-2.1-or-later
// A mesh that lives elsewhere (a FreeCAD document) comes back as arrays: to be measured, to be written to a file.
#include <pybind11/stl.h>

#include <algorithm>

#include "base/error.h"
#include "bindings/convert.h"
#include "mesh/hex_element.h"

namespace py = pybind11;

namespace hexfeature {
namespace {

template <class T>
using Input = py::array_t<T, py::array::c_style | py::array::forcecast>;

[[noreturn]] void reject(const std::string& reason) {
  throw MeshingError(Failure::BadInput, "arrays", reason, "give the arrays of one mesh");
}

/// (n, N) array -> vector of arrays; every index must name one of `points` points.
template <std::size_t N>
std::vector<std::array<int, N>> rows(const Input<int>& values, std::size_t points, const char* name) {
  if (values.size() == 0) return {};
  if (values.ndim() != 2 || values.shape(1) != static_cast<py::ssize_t>(N))
    reject(std::string(name) + " must have " + std::to_string(N) + " columns");
  const auto v = values.unchecked<2>();
  std::vector<std::array<int, N>> result(v.shape(0));
  for (py::ssize_t i = 0; i < v.shape(0); ++i)
    for (std::size_t k = 0; k < N; ++k) {
      if (v(i, k) < 0 || static_cast<std::size_t>(v(i, k)) >= points) reject(std::string(name) + " names a point that is not there");
      result[i][k] = v(i, k);
    }
  return result;
}

std::vector<Vec3> points_of(const Input<double>& values) {
  if (values.size() == 0) return {};
  if (values.ndim() != 2 || values.shape(1) != 3) reject("points must have 3 columns");
  const auto v = values.unchecked<2>();
  std::vector<Vec3> points(v.shape(0));
  for (py::ssize_t i = 0; i < v.shape(0); ++i) points[i] = Vec3(v(i, 0), v(i, 1), v(i, 2));
  return points;
}

std::vector<int> numbers(const Input<int>& values, std::size_t count, const char* name) {
  if (static_cast<std::size_t>(values.size()) != count) reject(std::string(name) + " must have " + std::to_string(count) + " entries");
  return {values.data(), values.data() + values.size()};
}

py::array_t<double> scaled_jacobians(const Input<double>& points, const Input<int>& hexes) {
  const std::vector<Vec3> x = points_of(points);
  const auto elements = rows<8>(hexes, x.size(), "hexes");
  py::array_t<double> result(static_cast<py::ssize_t>(elements.size()));
  double* out = result.mutable_data();
  py::gil_scoped_release release;
  for (std::size_t i = 0; i < elements.size(); ++i) out[i] = scaled_jacobian(x, elements[i]);
  return result;
}

std::shared_ptr<Result> result_from_arrays(const Input<double>& points, const Input<int>& hexes, const Input<int>& hex_solid,
                                           const Input<int>& quads, const Input<int>& quad_face, const Input<int>& node_dim,
                                           const Input<int>& node_entity, const Input<int>& feature_edges,
                                           const Input<int>& feature_edge_cad) {
  auto result = std::make_shared<Result>();
  HexComplex& mesh = result->mesh;
  mesh.points = points_of(points);
  const std::size_t n = mesh.points.size();
  if (hexes.ndim() == 2 && hexes.shape(1) == 20) {
    result->hexes20 = rows<20>(hexes, n, "hexes");
    result->quads8 = rows<8>(quads, n, "quads");
    for (const auto& h : result->hexes20) std::copy_n(h.begin(), 8, mesh.hexes.emplace_back().begin());
    for (const auto& q : result->quads8) std::copy_n(q.begin(), 4, mesh.quads.emplace_back().begin());
  } else {
    mesh.hexes = rows<8>(hexes, n, "hexes");
    mesh.quads = rows<4>(quads, n, "quads");
  }
  mesh.hex_solid = numbers(hex_solid, mesh.hexes.size(), "hex_solid");
  mesh.quad_face = numbers(quad_face, mesh.quads.size(), "quad_face");
  mesh.feature_edges = rows<2>(feature_edges, n, "feature_edges");
  mesh.feature_edge_cad = numbers(feature_edge_cad, mesh.feature_edges.size(), "feature_edge_cad");
  const std::vector<int> dim = numbers(node_dim, n, "node_dim"), entity = numbers(node_entity, n, "node_entity");
  mesh.place.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    mesh.place[i].dim = dim[i];
    mesh.place[i].entity = entity[i];
  }
  return result;
}

}  // namespace

void bind_arrays(py::module_& m) {
  m.def("scaled_jacobians", &scaled_jacobians, py::arg("points"), py::arg("hexes"),
        "Scaled Jacobian of each hexahedron: points (n, 3), hexes (m, 8) in VTK order -> (m,).");
  m.def("result_from_arrays", &result_from_arrays, py::arg("points"), py::arg("hexes"), py::arg("hex_solid"), py::arg("quads"),
        py::arg("quad_face"), py::arg("node_dim"), py::arg("node_entity"), py::arg("feature_edges"), py::arg("feature_edge_cad"),
        "A Result of arrays as a Result gives them (hexes 8 or 20, quads 4 or 8 columns), to be written; it is not certified.");
}

}  // namespace hexfeature
