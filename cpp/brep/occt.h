// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <Message_ProgressIndicator.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <exception>
#include <gp_Ax3.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>
#include <mutex>
#include <new>
#include <string>
#include <utility>

#include "base/context.h"
#include "base/types.h"

namespace hexfeature {

inline Vec3 to_eigen(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }
inline Vec3 to_eigen(const gp_Pnt& p) { return to_eigen(p.XYZ()); }
inline Vec3 to_eigen(const gp_Vec& p) { return to_eigen(p.XYZ()); }
inline Vec3 to_eigen(const gp_Dir& p) { return to_eigen(p.XYZ()); }
inline Vec2 to_eigen(const gp_Pnt2d& p) { return {p.X(), p.Y()}; }
inline gp_Pnt to_occt(const Vec3& p) { return {p[0], p[1], p[2]}; }

/// Run `work`; OCCT's exceptions (which are not std::exception) come out as MeshingError(BadInput, step), want of memory
/// as std::bad_alloc.
template <class Work>
auto guarded(const std::string& step, const std::string& what, Work&& work) -> decltype(work()) {
  try {
    return std::forward<Work>(work)();
  } catch (const Standard_OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const Standard_Failure& failure) {
    const char* text = failure.GetMessageString();
    const std::string detail = text != nullptr && text[0] != '\0' ? text : failure.DynamicType()->Name();
    throw MeshingError(Failure::BadInput, step, what + " (" + detail + ")", "the geometry may be damaged; try repairing the part");
  }
}

/// Lets OCCT's long-running algorithms see that the user cancelled. OCCT may ask from threads of its own, which must not throw: what the
/// caller's question throws ends the algorithm, and `rethrow` brings it to light afterwards.
class CancelIndicator : public Message_ProgressIndicator {
 public:
  explicit CancelIndicator(const Context& context) : context_(context) {}
  Standard_Boolean UserBreak() override {
    try {
      if (context_.is_cancelled && context_.is_cancelled()) return Standard_True;
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!thrown_) thrown_ = std::current_exception();
      return Standard_True;
    }
    return context_.deadline != Context::Clock::time_point::max() && Context::Clock::now() > context_.deadline;
  }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {}
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  const Context& context_;
  std::mutex mutex_;
  std::exception_ptr thrown_;
};

}  // namespace hexfeature
