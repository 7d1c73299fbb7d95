// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <string>
#include <variant>
#include <vector>

namespace hexfeature {

/// Everything a user may choose. The command line, the Python keywords, the JSON file and FreeCAD's properties are all
/// made from `option_list()`.
struct Options {
  double size = 0;                 ///< element size h, in the part's unit; 0: chosen from the part's volume
  std::string method = "auto";     ///< auto (all in order, the best mesh is kept) | feature-line | tet-split
  std::string labels = "regions";  ///< regions (default labeller) | paper (the paper's own)
  int order = 1;                   ///< 1: 8-node, 2: 20-node hexahedra
  std::string capture = "all";     ///< CAD edges that mesh edges follow: sharp | all (tangent ones too, where a cheap path exists)
  bool sheets = true;              ///< insert O-grid sheets where chart borders lie on smooth surface
  int minimum_layers = 1;          ///< least number of elements along every polycube edge
  double beta = 0.5;               ///< speed of the paper's smoothing, equation (1)
  int smoothing_rounds = 50;       ///< at most so many rounds of the paper's step 3-7b
  double crease_angle = 30;        ///< degrees: STL, OBJ, PLY surfaces are cut into faces at sharper creases
  double time_limit = 0;           ///< seconds for the whole run; 0: none
  double memory_limit = 0;         ///< megabytes by which the process may grow during the run; 0: none
  int threads = 2;                 ///< worker threads; the mesh does not depend on it
  std::string stop_after;          ///< stop after this step and return its intermediate result; empty: go to the end
};

using OptionValue = std::variant<double, int, bool, std::string>;

struct OptionSpec {
  std::string name;  ///< as in JSON and Python; the command line writes '-' for '_'
  std::variant<double Options::*, int Options::*, bool Options::*, std::string Options::*> member;
  double minimum = 0, maximum = 0;   ///< numbers: inclusive range; equal: unbounded
  std::vector<std::string> choices;  ///< strings: allowed values; empty: any
  bool advanced = false;             ///< folded away in user interfaces
  std::string help;
};

/// The one list, in display order.
const std::vector<OptionSpec>& option_list();
OptionValue get_option(const Options& options, const OptionSpec& spec);
/// Throws MeshingError(Usage, "options") when the value has the wrong type, is not finite, is out of range or not a choice.
void set_option(Options& options, const std::string& name, const OptionValue& value);

}  // namespace hexfeature
