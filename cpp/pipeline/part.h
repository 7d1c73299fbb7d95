// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/context.h"
#include "base/options.h"
#include "mesh/geometry.h"
#include "mesh/surface_mesh.h"

namespace hexfeature {

/// A part to mesh, whatever it came from: a B-rep or a triangle surface. What the driver and the methods see.
class Part {
 public:
  virtual ~Part() = default;
  virtual Geometry geometry() const = 0;
  virtual int solid_count() const = 0;
  virtual std::vector<std::string> solid_names() const { return {}; }  ///< one a solid, or none
  virtual double volume() const = 0;
  virtual double rough_volume() const { return volume(); }  ///< within some percent, at once
  virtual double diagonal() const = 0;
  virtual std::vector<std::string> warnings() const = 0;
  /// Candidate working frames, best first (rotations of the part as read).
  virtual std::vector<Mat3> frames() const = 0;
  /// Move into a working frame x -> rotation * (x - centre()), with all of geometry().
  virtual void place(const Mat3& rotation) = 0;
  /// Back to the part's own coordinates.
  virtual void place_in_world() = 0;
  virtual Vec3 to_world(const Vec3& p) const = 0;
  virtual Vec3 centre() const = 0;
  /// Step 3-1: the surface mesh of the placed part, all solids.
  virtual SurfaceMesh surface(double size, Context& context) const = 0;
};

/// Chooses the reader by the file's ending. Throws MeshingError(BadInput, "read").
std::unique_ptr<Part> read_part(const std::string& path, const Options& options, Context& context);
std::unique_ptr<Part> part_of_brep_string(const std::string& brep, const Options& options, Context& context);

/// The triangles of one solid, as a mesh of their own.
SurfaceMesh surface_of_solid(const SurfaceMesh& surface, const Geometry& geometry, int solid);

}  // namespace hexfeature
