// HexFeatureWB - LGPL-2.1-or-later
#include "tetsplit/tets_ahead.h"

#include <utility>

namespace hexfeature {

TetsAhead::TetsAhead(const SurfaceMesh& surface, const Geometry& geometry, const TetSplitOptions& options,
                     std::chrono::milliseconds patience)
    : surface_(surface), geometry_(geometry), options_(options) {
  context_.is_cancelled = [this] { return unwanted_.load(); };
  thread_ = std::thread([this, patience] { work(patience); });
}

void TetsAhead::work(std::chrono::milliseconds patience) {
  {
    std::unique_lock<std::mutex> lock(mutex_);
    if (wake_.wait_for(lock, patience, [&] { return unwanted_.load(); })) return;
    begun_ = true;
  }
  try {
    start_ = begin_tet_split(surface_, geometry_, options_, context_);
  } catch (...) {  // left off; or what the run meets again when it comes there
  }
  surface_ = {};
  const std::lock_guard<std::mutex> lock(mutex_);
  ended_ = true;
  wake_.notify_all();
}

void TetsAhead::leave_off() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    unwanted_ = true;
  }
  wake_.notify_all();
}

void TetsAhead::stop() {
  leave_off();
  if (thread_.joinable()) thread_.join();
}

std::optional<TetSplitStart> TetsAhead::take(Context& run) {
  constexpr std::chrono::milliseconds kLook{20};
  {
    std::unique_lock<std::mutex> lock(mutex_);
    while (begun_ && !ended_ && !wake_.wait_for(lock, kLook, [&] { return ended_; })) {
      lock.unlock();
      run.check();
      lock.lock();
    }
  }
  stop();
  std::optional<TetSplitStart> start = std::exchange(start_, std::nullopt);
  if (start && start->failure) start.reset();
  return start;
}

}  // namespace hexfeature
