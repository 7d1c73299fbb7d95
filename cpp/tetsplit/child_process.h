// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

#include "base/context.h"

namespace hexfeature {

struct ChildResult {
  bool started = false;
  bool ended_well = false;  ///< exit code 0
  std::vector<char> output;
};

/// Run a program: `input` to its standard input, its standard output back. Asks the context twenty times a second and kills the
/// program when that throws. The program gets no other open file. It may ask to be killed when the thread that started it ends (Linux).
ChildResult run_child(const std::string& program, const std::vector<char>& input, Context& context);

/// Path of a program in the folder of the library (or executable) that this code is in.
std::string program_beside_library(const std::string& name);

}  // namespace hexfeature
