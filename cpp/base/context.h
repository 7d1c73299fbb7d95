// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <chrono>
#include <functional>
#include <limits>
#include <string>

#include "base/error.h"

namespace hexfeature {

/// What a step may ask of the world outside: progress, log, cancel, time left.
/// Passed by reference to every step; there are no globals.
class Context {
 public:
  using Clock = std::chrono::steady_clock;

  std::function<void(const std::string& step, double fraction)> on_progress;  ///< may be empty
  std::function<void(const std::string& line)> on_log;                        ///< may be empty
  std::function<bool()> is_cancelled;                                         ///< may be empty; cheap; any thread
  Clock::time_point deadline = Clock::time_point::max();                      ///< set from Options::time_limit

  /// Say how far a step is (0..1); also a cancellation point.
  void progress(const std::string& step, double fraction) {
    current_step_ = step;
    check();
    if (on_progress) on_progress(step, fraction);
  }
  /// Throws MeshingError(Cancelled). Call it at least every 0.05 s of work; it costs a clock read.
  void check() const {
    if (is_cancelled && is_cancelled()) throw MeshingError(Failure::Cancelled, current_step_, "cancelled");
    if (deadline != Clock::time_point::max() && Clock::now() > deadline)
      throw MeshingError(Failure::Cancelled, current_step_, "time limit reached", "raise the time limit or the element size");
  }
  void log(const std::string& line) const {
    if (on_log) on_log(line);
  }
  const std::string& current_step() const { return current_step_; }

 private:
  std::string current_step_ = "start";
};

}  // namespace hexfeature
