// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <memory>

namespace hexfeature {

/// A few threads that share loops. Each loop is cut into contiguous pieces, one a thread; bodies write to places of their
/// own, so that results do not depend on the number of threads. The calling thread takes the first piece.
class Workers {
 public:
  explicit Workers(int threads);  ///< 1 to 64; fewer when the system refuses to start them
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// body(begin, end) on pieces of 0..count; on the calling thread alone when count is below `smallest`.
  /// The first exception of a body is thrown again here.
  template <class Body>
  void run(int count, int smallest, const Body& body) {
    if (count < smallest || size() == 1) {
      if (count > 0) body(0, count);
      return;
    }
    run_pieces(
        count, [](const void* b, int begin, int end) { (*static_cast<const Body*>(b))(begin, end); }, &body);
  }
  int size() const;

 private:
  void run_pieces(int count, void (*call)(const void*, int, int), const void* body);
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hexfeature
