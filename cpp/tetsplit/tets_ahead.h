// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "tetsplit/tet_split.h"

namespace hexfeature {

/// The beginning of the tet-split method, made on a thread of its own while labels are sought, which takes one thread: where they turn out
/// to be in vain, the tetrahedra are there. Begins after a while only, since most labels are found at once. The mesh is the same whether
/// or not it was begun, and how far it got.
class TetsAhead {
 public:
  /// `surface` is copied; nothing may place the geometry anew before `stop`, `take` or the end. Throws std::system_error where there is
  /// no thread to be had.
  TetsAhead(const SurfaceMesh& surface, const Geometry& geometry, const TetSplitOptions& options, std::chrono::milliseconds patience);
  ~TetsAhead() { stop(); }
  TetsAhead(const TetsAhead&) = delete;
  TetsAhead& operator=(const TetsAhead&) = delete;

  /// What is not there yet is no longer wanted: the thread soon leaves off.
  void leave_off();
  /// The same; when it returns, nothing looks at the geometry any more.
  void stop();
  /// The beginning with its tetrahedra, once; waited for if it is being made. None where it was not begun, not ended when it was left off,
  /// or failed: alone it may do better. The geometry must be placed as it was. Throws what Context::check throws of the run.
  std::optional<TetSplitStart> take(Context& run);

 private:
  void work(std::chrono::milliseconds patience);

  SurfaceMesh surface_;
  Geometry geometry_;
  TetSplitOptions options_;
  Context context_;  ///< its own: the run's may call what one thread alone may call
  std::mutex mutex_;
  std::condition_variable wake_;
  std::atomic<bool> unwanted_{false};
  bool begun_ = false, ended_ = false;
  std::optional<TetSplitStart> start_;
  std::thread thread_;
};

}  // namespace hexfeature
