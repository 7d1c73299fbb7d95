// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <functional>
#include <vector>

#include "pipeline/method.h"

namespace hexfeature {

/// Names of sheets, as SheetReport::names has them.
using SheetNames = std::vector<std::vector<int>>;

/// A smoothed mesh and the sheets it has.
struct SheetTrial {
  HexComplex mesh;
  SheetReport sheets;
  SmoothReport smoothing;
  Worth worth;            ///< nothing is known of a mesh with inverted elements
  SheetNames suspects;    ///< those at its worst elements, in the order of insertion
  std::vector<int> held;  ///< points that were drawn to where a face was not covered, and stay there
  bool again = false;     ///< the sheets made the very mesh of an earlier choice: it is not smoothed once more
};

struct SheetRules {
  bool once = false;         ///< a mesh with inverted elements is not tried with fewer sheets
  bool another_way = false;  ///< there is another method: what no choice of sheets mends is left to it
  int most = 6;              ///< choices of sheets to leave out tried
};

/// Whether a smoothed mesh is worth more: fewer inverted elements, or keeping more of the part, or a worst element better by what can be
/// seen, or with one as good a better mean. What it keeps is not known of meshes with inverted elements.
bool is_better(const SheetTrial& a, const SheetTrial& b);

/// Smooths the mesh without the named sheets; with those that are left running through the part where they can (SheetOptions), or not.
using MakeTrial = std::function<SheetTrial(const SheetNames& without, bool run_through)>;

/// The best choice of sheets: all of them at first (`mesh_without` of no names), running through the part; where one of them was
/// refused or the worst element lies at sheets, also all of them ending inside where that is shorter, and the better stays; as long as the
/// worst element lies at sheets, again without one of these, the last inserted first, then without all of them, and the better mesh is
/// kept. What is far from every sheet is not their doing: then nothing is tried, but a mesh with a bad element (Worth::sound) is made once
/// without any sheet. Where elements stay inverted, once without all the sheets there: such a mesh is seldom saved, and
/// each trial of it is dear. A large mesh that is good already is not tried often. Ends early when time or memory for more trials is used
/// up and there is a mesh. Lets through what `mesh_without` throws.
SheetTrial try_sheets(const MakeTrial& mesh_without, const SheetRules& rules, Context& context);

}  // namespace hexfeature
