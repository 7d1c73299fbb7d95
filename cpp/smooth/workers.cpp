// HexFeatureWB - LGPL-2.1-or-later
#include "smooth/workers.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace hexfeature {

struct Workers::State {
  std::vector<std::thread> threads;
  std::mutex mutex;
  std::condition_variable begin, done;
  int generation = 0, running = 0, count = 0, pieces = 1;
  bool stop = false;
  void (*call)(const void*, int, int) = nullptr;
  const void* body = nullptr;
  std::exception_ptr error;

  void piece(int index) {
    const auto at = [&](int i) { return static_cast<int>(static_cast<long long>(count) * i / pieces); };
    try {
      if (at(index) < at(index + 1)) call(body, at(index), at(index + 1));
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!error) error = std::current_exception();
    }
  }
  void work(int index) {
    int seen = 0;
    for (;;) {
      {
        std::unique_lock<std::mutex> lock(mutex);
        begin.wait(lock, [&] { return stop || generation != seen; });
        if (stop) return;
        seen = generation;
      }
      piece(index);
      const std::lock_guard<std::mutex> lock(mutex);
      if (--running == 0) done.notify_one();
    }
  }
};

Workers::Workers(int threads, const Context& context) : context_(context), state_(new State) {
  for (int i = 1; i < std::clamp(threads, 1, 64); ++i) {
    try {
      state_->threads.emplace_back([state = state_.get(), i] { state->work(i); });
    } catch (const std::system_error&) {
      break;
    }
  }
}

Workers::~Workers() {
  {
    const std::lock_guard<std::mutex> lock(state_->mutex);
    state_->stop = true;
  }
  state_->begin.notify_all();
  for (auto& t : state_->threads) t.join();
}

int Workers::size() const { return 1 + static_cast<int>(state_->threads.size()); }

void Workers::run_pieces(int count, void (*call)(const void*, int, int), const void* body) {
  State& s = *state_;
  {
    const std::lock_guard<std::mutex> lock(s.mutex);
    s.count = count;
    s.pieces = size();
    s.call = call;
    s.body = body;
    s.error = nullptr;
    s.running = size() - 1;
    ++s.generation;
  }
  s.begin.notify_all();
  s.piece(0);
  std::unique_lock<std::mutex> lock(s.mutex);
  s.done.wait(lock, [&] { return s.running == 0; });
  if (s.error) std::rethrow_exception(s.error);
}

}  // namespace hexfeature
