// HexFeatureWB - LGPL-2.1-or-later
#include "smooth/workers.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace hexfeature {
namespace {

/// Waking a thread that sleeps takes longer than most loops over some thousand elements, and the next loop is mostly some microseconds
/// away: who waits looks a while before it sleeps. Where there are more threads than processors, it lets the others go first.
template <class Condition>
void look_a_while(const Condition& condition) {
  constexpr int kRounds = 40, kLooks = 16;
  for (int round = 0; round < kRounds; ++round) {
    for (int look = 0; look < kLooks; ++look) {
      if (condition()) return;
#if defined(__x86_64__) && defined(__GNUC__)
      __builtin_ia32_pause();
#endif
    }
    std::this_thread::yield();
  }
}

}  // namespace

struct Workers::State {
  std::vector<std::thread> threads;
  std::mutex mutex;
  std::condition_variable begin, done;
  std::atomic<int> generation{0}, running{0};
  int count = 0, pieces = 1;
  std::atomic<bool> stop{false};
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
      look_a_while([&] { return stop || generation != seen; });
      {
        std::unique_lock<std::mutex> lock(mutex);
        begin.wait(lock, [&] { return stop || generation != seen; });
        if (stop) return;
        seen = generation;
      }
      piece(index);
      if (--running > 0) continue;
      const std::lock_guard<std::mutex> lock(mutex);
      done.notify_one();
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
  look_a_while([&] { return s.running == 0; });
  std::unique_lock<std::mutex> lock(s.mutex);
  s.done.wait(lock, [&] { return s.running == 0; });
  if (s.error) std::rethrow_exception(s.error);
}

}  // namespace hexfeature
