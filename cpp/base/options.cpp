// HexFeatureWB - LGPL-2.1-or-later
#include "base/options.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/error.h"

namespace hexfeature {

const std::vector<OptionSpec>& option_list() {
  static const std::vector<OptionSpec> list = {
      {"size", &Options::size, 0, 1e12, {}, false, "element size in the part's unit; 0 chooses one from the part's volume"},
      {"method", &Options::method, 0, 0, {"auto", "feature-line", "tet-split"}, false, "meshing method; auto tries them in order"},
      {"order", &Options::order, 1, 2, {}, false, "1: 8-node hexahedra, 2: 20-node hexahedra"},
      {"labels", &Options::labels, 0, 0, {"regions", "paper"}, false, "labeller: on CAD regions, or the paper's on triangles"},
      {"capture", &Options::capture, 0, 0, {"sharp", "all"}, false, "CAD edges that mesh edges follow: sharp ones, or all"},
      {"sheets", &Options::sheets, 0, 0, {}, true, "insert O-grid sheets where block borders lie on smooth surface"},
      {"minimum_layers", &Options::minimum_layers, 1, 100, {}, false, "least number of elements along every block edge"},
      {"beta", &Options::beta, 0, 10, {}, true, "speed of the paper's smoothing of degrees of adaptation, equation (1)"},
      {"smoothing_rounds", &Options::smoothing_rounds, 0, 1000, {}, true, "at most so many rounds of the paper's step 3-7b"},
      {"crease_angle",
       &Options::crease_angle,
       1,
       179,
       {},
       true,
       "degrees; STL, OBJ and PLY surfaces are cut into faces at sharper creases"},
      {"time_limit", &Options::time_limit, 0, 1e9, {}, true, "seconds for the whole run; 0 sets no limit"},
      {"memory_limit", &Options::memory_limit, 0, 1e9, {}, true, "megabytes of memory for the whole run; 0 sets no limit"},
      {"threads", &Options::threads, 1, 256, {}, true, "worker threads; the mesh does not depend on it"},
      {"stop_after",
       &Options::stop_after,
       0,
       0,
       {"", "read", "frame", "surface", "labels", "shape", "polycube", "lattice", "fit", "sheets", "smooth"},
       true,
       "stop after this step and return its result"},
  };
  return list;
}

OptionValue get_option(const Options& options, const OptionSpec& spec) {
  return std::visit([&](auto member) { return OptionValue(options.*member); }, spec.member);
}

namespace {
[[noreturn]] void reject(const OptionSpec& spec, const std::string& why) {
  throw MeshingError(Failure::Usage, "options", spec.name + " " + why, spec.help);
}

template <class T>
void assign(T& target, const OptionSpec& spec, const OptionValue& value) {
  double number = 0;
  if constexpr (std::is_same_v<T, std::string>) {
    const auto* s = std::get_if<std::string>(&value);
    if (!s) reject(spec, "must be a text");
    if (!spec.choices.empty() && std::find(spec.choices.begin(), spec.choices.end(), *s) == spec.choices.end()) {
      std::string all;
      for (const auto& c : spec.choices)
        if (!c.empty()) all += (all.empty() ? "" : ", ") + c;
      reject(spec, "is '" + *s + "' but must be one of " + all);
    }
    target = *s;
    return;
  } else if constexpr (std::is_same_v<T, bool>) {
    const auto* b = std::get_if<bool>(&value);
    if (!b) reject(spec, "must be true or false");
    target = *b;
    return;
  } else {
    if (const auto* i = std::get_if<int>(&value))
      number = *i;
    else if (const auto* d = std::get_if<double>(&value))
      number = *d;
    else
      reject(spec, "must be a number");
    if (!std::isfinite(number)) reject(spec, "must be a finite number");
    if (std::is_same_v<T, int> && number != std::floor(number)) reject(spec, "must be a whole number");
    if (spec.maximum > spec.minimum && (number < spec.minimum || number > spec.maximum)) {
      std::ostringstream text;
      text << "is " << number << " but must lie between " << spec.minimum << " and " << spec.maximum;
      reject(spec, text.str());
    }
    target = static_cast<T>(number);
  }
}
}  // namespace

void set_option(Options& options, const std::string& name, const OptionValue& value) {
  for (const OptionSpec& spec : option_list())
    if (spec.name == name) {
      std::visit([&](auto member) { assign(options.*member, spec, value); }, spec.member);
      return;
    }
  throw MeshingError(Failure::Usage, "options", "there is no option '" + name + "'", "see hexfeature mesh --help");
}

}  // namespace hexfeature
