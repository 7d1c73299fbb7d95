// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <new>
#include <string>

#include "base/error.h"

namespace hexfeature {

/// The run has grown beyond Options::memory_limit.
struct MemoryLimit : std::bad_alloc {
  const char* what() const noexcept override { return "memory limit reached"; }
};

/// The context's deadline has passed; a cancel by the user is a plain MeshingError.
struct TimeLimit : MeshingError {
  explicit TimeLimit(const std::string& where)
      : MeshingError(Failure::Cancelled, where, "time limit reached", "raise the time limit or the element size") {}
};

/// What a step may ask of the world outside: progress, log, cancel, time left.
/// Passed by reference to every step; there are no globals.
class Context {
 public:
  using Clock = std::chrono::steady_clock;

  std::function<void(const std::string& step, double fraction)> on_progress;  ///< may be empty
  std::function<void(const std::string& line)> on_log;                        ///< may be empty
  std::function<bool()> is_cancelled;                                         ///< may be empty; cheap; any thread
  Clock::time_point deadline = Clock::time_point::max();                      ///< set from Options::time_limit

  /// From now on the process may grow by so many bytes; 0: no limit. Looked at by check(), some times a second. Where the system does not
  /// tell a process its size (elsewhere than on Linux) there is no limit.
  void limit_memory(std::size_t bytes);

  /// Say how far a step is (0..1); also a cancellation point.
  void progress(const std::string& step, double fraction) {
    current_step_ = step;
    check();
    if (on_progress) on_progress(step, fraction);
  }
  /// Throws MeshingError(Cancelled), or MemoryLimit. Call it at least every 0.05 s of work; it costs a clock read.
  void check() const {
    if (is_cancelled && is_cancelled()) throw MeshingError(Failure::Cancelled, current_step_, "cancelled");
    if (deadline != Clock::time_point::max() && Clock::now() > deadline) throw TimeLimit(current_step_);
    if (most_memory_ > 0) check_memory();
  }
  /// The same while a child process works for this one: its memory counts too.
  void check_with_child(int process) const;
  void log(const std::string& line) const {
    if (on_log) on_log(line);
  }
  const std::string& current_step() const { return current_step_; }

 private:
  void check_memory() const;

  std::string current_step_ = "start";
  std::size_t most_memory_ = 0;  ///< bytes, resident
  mutable std::atomic<Clock::rep> memory_seen_{0};
};

}  // namespace hexfeature
