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
    shortened_ = share < 1 && whole_ != Context::Clock::time_point::max() && whole_ > now;
    if (!shortened_) return;
    context.deadline = now + std::chrono::duration_cast<Context::Clock::duration>(share * (whole_ - now));
  }
  ~Deadline() { context_.deadline = whole_; }
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  /// Whether it was the share that ended, and the run has time left.
  bool is_share() const { return shortened_ && Context::Clock::now() < whole_; }

 private:
  Context& context_;
  Context::Clock::time_point whole_;
  bool shortened_ = false;
};

MeshingError out_of_memory(const Context& context, const std::string& reason) {
#ifdef __GLIBC__
  malloc_trim(0);  // what was freed on the way here still counts as the process's
#endif
  return {Failure::NoMesh, context.current_step(), reason, "use a larger size, or allow more memory"};
}

}  // namespace

std::optional<MeshingError> run_with_share(Context& context, double share, const std::function<void()>& work) {
  std::optional<MeshingError> used_up;
  const Deadline deadline(context, share);
  try {
    work();
    return std::nullopt;
  } catch (const TimeLimit& error) {
    if (!deadline.is_share()) throw;
    used_up = MeshingError(Failure::Cancelled, error.step, "its share of the time limit is used up", "raise the time limit");
  } catch (const MemoryLimit& error) {
    used_up = out_of_memory(context, error.what());
  } catch (const std::bad_alloc&) {
    used_up = out_of_memory(context, "out of memory");
  } catch (const std::length_error&) {  // a container of more elements than there can be bytes
    used_up = out_of_memory(context, "out of memory");
  }
  context.log("cut off in step " + used_up->step + ": " + used_up->reason);
  return used_up;
}

}  // namespace hexfeature
