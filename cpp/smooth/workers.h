// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <algorithm>
#include <memory>

#include "base/context.h"

namespace hexfeature {

/// A few threads that share loops. Each loop is cut into contiguous pieces, one a thread, and these into slices, between which the run
/// may be cancelled; bodies write to places of their own, so that results do not depend on the number of threads. The calling thread
/// takes the first piece.
class Workers {
 public:
  Workers(int threads, const Context& context);  ///< 1 to 64; fewer when the system refuses to start them
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// body(begin, end) on slices of 0..count; on the calling thread alone when count is below `smallest`.
  /// The first exception of a body is thrown again here. Throws what Context::check throws.
  template <class Body>
  void run(int count, int smallest, const Body& body) {
    const auto in_slices = [&](int begin, int end) {
      for (int i = begin; i < end; i += kSlice) {
        context_.check();
        body(i, std::min(i + kSlice, end));
      }
    };
    if (count < smallest || size() == 1) return in_slices(0, count);
    run_pieces(
        count, [](const void* b, int begin, int end) { (*static_cast<const decltype(in_slices)*>(b))(begin, end); }, &in_slices);
  }
  int size() const;

 private:
  /// Items between two looks at the context: of the dearest loop (a stiffness) about 0.02 s.
  static constexpr int kSlice = 4096;
  void run_pieces(int count, void (*call)(const void*, int, int), const void* body);
  struct State;
  const Context& context_;
  std::unique_ptr<State> state_;
};

}  // namespace hexfeature
