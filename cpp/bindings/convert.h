// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/pipeline.h"

namespace hexfeature {

template <class T>
struct Scalars {
  using type = T;
  static constexpr int count = 1;
};
template <class T, std::size_t N>
struct Scalars<std::array<T, N>> {
  using type = T;
  static constexpr int count = static_cast<int>(N);
};
template <>
struct Scalars<Vec3> {
  using type = double;
  static constexpr int count = 3;
};

/// Messages and names may quote a damaged file, or a path, that is not UTF-8.
inline pybind11::str text_of(const std::string& text) {
  return pybind11::reinterpret_steal<pybind11::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<pybind11::ssize_t>(text.size()), "backslashreplace"));
}
inline pybind11::list text_list(const std::vector<std::string>& texts) {
  pybind11::list list;
  for (const std::string& text : texts) list.append(text_of(text));
  return list;
}

/// Owner of a view's memory: keeps the whole result alive.
template <class Owner>
pybind11::capsule keep_alive(const std::shared_ptr<Owner>& owner) {
  return pybind11::capsule(new std::shared_ptr<Owner>(owner), [](void* p) { delete static_cast<std::shared_ptr<Owner>*>(p); });
}

/// A read-only numpy view, (n,) or (n, count), of a vector inside `owner`.
template <class T, class Owner>
pybind11::array view(const std::vector<T>& data, const std::shared_ptr<Owner>& owner) {
  using Scalar = typename Scalars<T>::type;
  constexpr int count = Scalars<T>::count;
  static_assert(sizeof(T) == count * sizeof(Scalar), "rows must be contiguous");
  std::vector<pybind11::ssize_t> shape{static_cast<pybind11::ssize_t>(data.size())}, strides{sizeof(T)};
  if (count > 1) {
    shape.push_back(count);
    strides.push_back(sizeof(Scalar));
  }
  static const Scalar nothing{};
  const void* start = data.empty() ? static_cast<const void*>(&nothing) : static_cast<const void*>(data.data());
  pybind11::array result(pybind11::dtype::of<Scalar>(), shape, strides, start, keep_alive(owner));
  result.attr("flags").attr("writeable") = false;
  return result;
}

/// A read-only strided view of one int member of a vector of structs.
template <class Struct, class Owner>
pybind11::array field(const std::vector<Struct>& data, int Struct::*member, const std::shared_ptr<Owner>& owner) {
  static const int nothing = 0;
  const void* start = data.empty() ? &nothing : &(data.front().*member);
  pybind11::array result(pybind11::dtype::of<int>(), {static_cast<pybind11::ssize_t>(data.size())},
                         {static_cast<pybind11::ssize_t>(sizeof(Struct))}, start, keep_alive(owner));
  result.attr("flags").attr("writeable") = false;
  return result;
}

/// Adds `scaled_jacobians` and `result_from_arrays` to the module.
void bind_arrays(pybind11::module_& module);

pybind11::dict report_of(const Result& result);
pybind11::dict stage_of(const std::shared_ptr<Result>& result, const std::string& name);

}  // namespace hexfeature
