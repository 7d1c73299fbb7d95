// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <cstdint>
#include <memory>
#include <set>
#include <string>

#include "base/context.h"
#include "base/options.h"
#include "pipeline/pipeline.h"

namespace hexfeature {

/// Thrown when the step named by Options::stop_after is complete; caught by the driver, never leaves the pipeline.
struct Stopped {
  std::string step;
};

/// How far boundary nodes may be from the CAD: 1e-8, or what double precision leaves of the part's size.
double certificate_tolerance(const SurfaceMesh& surface);

class TetsAhead;

/// One run in progress: options, context, the result being filled, and the clock of its steps.
class Run {
 public:
  Run(const Options& options_, Context& context_, Result& result_);
  ~Run();
  const Options& options;
  Context& context;
  Result& result;
  Look look;                              ///< of whoever started the run; may be empty
  int placed = -1;                        ///< the frame that the present solid and result.surface are in; -1: none
  std::unique_ptr<TetsAhead> tets_ahead;  ///< of the present solid; may be empty

  /// Whether another method is to come: what this one finds hard need not be tried in every way.
  bool another_way() const { return options.method == "auto"; }

  /// What is being made ahead is given up: from here on there is work for all threads.
  void leave_off_ahead();

  /// What is shown from now on is of this solid.
  void begin_solid(int solid);
  /// Labels and feature shape of the present solid for whoever looks, unless the solid has been shown before.
  void show_first(const SurfaceMesh& mesh, const FeatureShape& shape);
  /// The same when they are final: those of `result`.
  void show_final();

  /// False when these very labels on this very surface were noted before: what follows would be done twice.
  bool is_new(const LabelledSurface& labels);

  /// Begin a step: time is booked to it until the next begin(). Also a cancellation point.
  void begin(const std::string& step);
  /// The current step is complete: stop here when the options say so.
  void complete();
  /// A result that the current step yields on its way is there: stop here when the options ask for it.
  void reached(const std::string& name);
  /// Close the books.
  void finish();

 private:
  void show(LabelResult labels, bool final) const;

  int solid_ = 1;
  bool shown_ = false;
  std::set<std::uint64_t> seen_;  ///< hashes of labelled surfaces
  std::string step_;
  Context::Clock::time_point since_{};
};

}  // namespace hexfeature
