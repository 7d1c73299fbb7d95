// HexFeatureWB - LGPL-2.1-or-later
#include "base/share.h"

#include <new>
#include <stdexcept>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace hexfeature {
namespace {

/// While it lives the context's deadline is that of a share of the time left.
class Deadline {
 public:
  Deadline(Context& context, double share) : context_(context), whole_(context.deadline) {
    const auto now = Context::Clock::now();
    if (share >= 1 || whole_ == Context::Clock::time_point::max() || whole_ <= now) return;
    context.deadline = now + std::chrono::duration_cast<Context::Clock::duration>(share * (whole_ - now));
  }
  ~Deadline() { context_.deadline = whole_; }
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  /// Whether the share's time is up while the run's is not, and nobody has cancelled.
  bool passed() const {
    const auto now = Context::Clock::now();
    return now > context_.deadline && now < whole_ && !(context_.is_cancelled && context_.is_cancelled());
  }

 private:
  Context& context_;
  Context::Clock::time_point whole_;
};

MeshingError out_of_memory(const Context& context, const std::string& reason) {
#ifdef __GLIBC__
  malloc_trim(0);  // what was freed on the way here still counts as the process's
#endif
  return {Failure::NoMesh, context.current_step(), reason, "use a larger size, or allow more memory"};
}

}  // namespace

std::optional<MeshingError> run_with_share(Context& context, double share, const std::function<void()>& work) {
  const Deadline deadline(context, share);
  try {
    work();
  } catch (const MeshingError& error) {
    if (error.kind != Failure::Cancelled || !deadline.passed()) throw;
    return MeshingError(Failure::Cancelled, error.step, "its share of the time limit is used up", "raise the time limit");
  } catch (const MemoryLimit& error) {
    return out_of_memory(context, error.what());
  } catch (const std::bad_alloc&) {
    return out_of_memory(context, "out of memory");
  } catch (const std::length_error&) {  // a container of more elements than there can be bytes
    return out_of_memory(context, "out of memory");
  }
  return std::nullopt;
}

}  // namespace hexfeature
