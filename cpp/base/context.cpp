// HexFeatureWB - LGPL-2.1-or-later
#include "base/context.h"

#include <cstdio>

#ifdef __linux__
#include <unistd.h>
#endif

namespace hexfeature {
namespace {

/// Bytes of a process in memory; 0 where that is not known.
std::size_t resident_memory(const std::string& process = "self") {
  std::size_t pages = 0;
#ifdef __linux__
  if (std::FILE* file = std::fopen(("/proc/" + process + "/statm").c_str(), "r")) {
    if (std::fscanf(file, "%*u %zu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  pages *= static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
#endif
  return pages;
}

}  // namespace

void Context::limit_memory(std::size_t bytes) { most_memory_ = bytes > 0 ? resident_memory() + bytes : 0; }

void Context::check_memory() const {
  constexpr auto kPause = std::chrono::milliseconds(10);
  const auto now = Clock::now().time_since_epoch();
  if (now - Clock::duration(memory_seen_.load(std::memory_order_relaxed)) < kPause) return;
  memory_seen_.store(now.count(), std::memory_order_relaxed);
  if (resident_memory() > most_memory_) throw MemoryLimit();
}

void Context::check_with_child(int process) const {
  check();
  if (most_memory_ > 0 && resident_memory() + resident_memory(std::to_string(process)) > most_memory_) throw MemoryLimit();
}

}  // namespace hexfeature
