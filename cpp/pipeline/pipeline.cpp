// HexFeatureWB - LGPL-2.1-or-later
#include "pipeline/pipeline.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <sstream>

#include "pipeline/faithfulness.h"
#include "pipeline/part.h"
#include "pipeline/run.h"
#include "pipeline/solid.h"
#include "quadratic/quadratic.h"

namespace hexfeature {
namespace {

/// The element size of a user who gave none: about 3000 elements. Refuses sizes that cannot make a mesh.
double choose_size(const Options& options, const Part& part) {
  if (options.size <= 0) return std::cbrt(part.volume() / 3000);
  if (options.size > part.diagonal())
    throw MeshingError(Failure::Usage, "options", "the element size is larger than the part",
                       "give a size well below the part's length of " + std::to_string(part.diagonal()));
  constexpr double kMost = 5e7;
  if (part.rough_volume() / std::pow(options.size, 3) > kMost) {
    std::ostringstream text;
    text << "the element size asks for about " << part.volume() / std::pow(options.size, 3) << " elements";
    throw MeshingError(Failure::Usage, "options", text.str(), "give a larger size");
  }
  return options.size;
}

/// Append one solid's complex to the mesh of all.
void append(HexComplex& all, const HexComplex& one) {
  const int offset = all.point_count();
  const int block_offset = all.hex_block.empty() ? 0 : 1 + *std::max_element(all.hex_block.begin(), all.hex_block.end());
  const auto shift = [&](auto nodes) {
    for (int& n : nodes) n += offset;
    return nodes;
  };
  all.points.insert(all.points.end(), one.points.begin(), one.points.end());
  all.shape_place.insert(all.shape_place.end(), one.shape_place.begin(), one.shape_place.end());
  all.place.insert(all.place.end(), one.place.begin(), one.place.end());
  for (const auto& h : one.hexes) all.hexes.push_back(shift(h));
  for (const auto& q : one.quads) all.quads.push_back(shift(q));
  for (const auto& e : one.feature_edges) all.feature_edges.push_back(shift(e));
  all.hex_solid.insert(all.hex_solid.end(), one.hex_solid.begin(), one.hex_solid.end());
  for (int b : one.hex_block) all.hex_block.push_back(b + block_offset);
  all.quad_chart.insert(all.quad_chart.end(), one.quad_chart.begin(), one.quad_chart.end());
  all.quad_face.insert(all.quad_face.end(), one.quad_face.begin(), one.quad_face.end());
  all.feature_edge_cad.insert(all.feature_edge_cad.end(), one.feature_edge_cad.begin(), one.feature_edge_cad.end());
}

/// The whole way from a part to its certified mesh.
void mesh_part(Part& part, Run& run) {
  Result& result = run.result;
  const Geometry geometry = part.geometry();
  result.cad_faces = static_cast<int>(geometry.faces->size());
  result.cad_edges = static_cast<int>(geometry.edges->size());
  result.cad_vertices = static_cast<int>(geometry.vertices->size());
  result.solids = part.solid_count();
  result.solid_names = part.solid_names();
  if (!run.look) result.cad_volume = part.volume();  // a preview does without, and is sooner there
  result.warnings = part.warnings();
  if (result.solids > 1) result.warnings.push_back("the solids are meshed one by one: where they touch, their meshes do not share nodes");
  run.complete();

  run.begin("frame");
  const std::vector<Mat3> frames = part.frames();
  run.complete();

  HexComplex mesh;
  for (int solid = 1; solid <= part.solid_count(); ++solid) {
    run.begin_solid(solid);
    try {
      append(mesh, mesh_solid(part, solid, frames, run));
    } catch (const Stopped&) {
      if (!run.look || solid == part.solid_count()) throw;
    }
  }
  result.mesh = std::move(mesh);

  run.begin("quality");
  part.place_in_world();
  result.quality = measure_quality(result.mesh, *geometry.projector, run.context);
  result.cad_volume = part.volume();
  result.limits = measure_limits(result.mesh, geometry);
  Faithfulness kept = measure_faithfulness(result.mesh, geometry, 0, nullptr, run.options.size, run.context);
  result.faces_without_quads = std::move(kept.faces_without_quads);
  result.sharp_edges_not_followed = std::move(kept.sharp_edges_not_followed);
  if (run.options.order == 2) {
    run.begin("second order");
    QuadraticMesh quadratic = make_quadratic(result.mesh, *geometry.projector, run.context);
    result.hexes20 = std::move(quadratic.hexes);
    result.quads8 = std::move(quadratic.quads);
    result.mesh.points.insert(result.mesh.points.end(), quadratic.mid_points.begin(), quadratic.mid_points.end());
    result.mesh.place.insert(result.mesh.place.end(), quadratic.mid_place.begin(), quadratic.mid_place.end());
    result.straightened = std::move(quadratic.straightened);
    result.straightened_faces = std::move(quadratic.straightened_faces);
    result.least_jacobian20 = quadratic.least_jacobian;
    result.mid_side_deviation = quadratic.deviation;
  }
  result.certified = true;
}

/// The part that was read from B-rep text last: a window asks for it again at another size, and reading takes longer than labels. A run
/// takes it away and brings it back, so that it never serves two; a part of other text is dropped.
class LastPart {
 public:
  std::unique_ptr<Part> take(const std::string& brep) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::unique_ptr<Part> part = std::move(part_);
    return brep == brep_ ? std::move(part) : nullptr;
  }
  void keep(const std::string& brep, std::unique_ptr<Part> part) {
    part->place_in_world();
    const std::lock_guard<std::mutex> lock(mutex_);
    brep_ = brep;
    part_ = std::move(part);
  }

 private:
  std::mutex mutex_;
  std::string brep_;
  std::unique_ptr<Part> part_;
};

LastPart& last_part() {
  static LastPart& last = *new LastPart;  // never destroyed: OpenCASCADE's own statics may be gone by then
  return last;
}

/// A part that is brought back however the run ends.
struct Borrowed {
  const std::string& brep;
  std::unique_ptr<Part> part = last_part().take(brep);

  explicit Borrowed(const std::string& text) : brep(text) {}
  Borrowed(const Borrowed&) = delete;
  Borrowed& operator=(const Borrowed&) = delete;
  ~Borrowed() {
    try {
      if (part) last_part().keep(brep, std::move(part));
    } catch (...) {  // no memory for that: it is read again then
    }
  }
};

/// Meshes the part that `read` gives.
template <class Read>
Result mesh_read_part(const Options& options, Context& context, const Read& read, const Look& look = {}) {
  Result result;
  result.options = options;
  if (options.time_limit > 0)
    context.deadline =
        Context::Clock::now() + std::chrono::duration_cast<Context::Clock::duration>(std::chrono::duration<double>(options.time_limit));
  Run run(result.options, context, result);
  run.look = look;
  run.begin("read");
  Part& part = read();
  result.options.size = choose_size(options, part);
  try {
    mesh_part(part, run);
  } catch (const Stopped& stopped) {
    result.stopped_after = stopped.step;
  }
  run.finish();
  return result;
}

}  // namespace

Result mesh_file(const std::string& path, const Options& options, Context& context) {
  std::unique_ptr<Part> part;
  return mesh_read_part(options, context, [&]() -> Part& {
    part = read_part(path, options, context);
    return *part;
  });
}

Result mesh_brep_string(const std::string& brep, const Options& options, Context& context, const Look& look) {
  Borrowed last(brep);
  const auto read = [&]() -> Part& {
    if (last.part)
      context.log("read: the part is still there from the run before");
    else
      last.part = part_of_brep_string(brep, options, context);
    return *last.part;
  };
  return mesh_read_part(options, context, read, look);
}

}  // namespace hexfeature
