// HexFeatureWB - LGPL-2.1-or-later
// Options by name and value: what is accepted must lie in the range that the list states.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "base/error.h"
#include "base/options.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hexfeature;
  Options options;
  for (std::size_t at = 0; at + 10 <= size; at += 10) {
    const auto& list = option_list();
    const OptionSpec& spec = list[data[at] % list.size()];
    OptionValue value;
    double number = 0;
    int whole = 0;
    std::memcpy(&number, data + at + 2, sizeof number);
    std::memcpy(&whole, data + at + 2, sizeof whole);
    switch (data[at + 1] % 4) {
      case 0:
        value = number;
        break;
      case 1:
        value = whole;
        break;
      case 2:
        value = (data[at + 2] & 1) != 0;
        break;
      default:
        value = std::string(data + at + 2, data + at + 10);
    }
    try {
      set_option(options, data[at + 1] & 64 ? std::string(data + at + 2, data + at + 10) : spec.name, value);
    } catch (const MeshingError& error) {
      if (error.kind != Failure::Usage) std::abort();
    }
  }
  for (const OptionSpec& spec : option_list()) {
    const OptionValue value = get_option(options, spec);
    const double* d = std::get_if<double>(&value);
    const int* i = std::get_if<int>(&value);
    const double number = d ? *d : i ? *i : spec.minimum;
    if (!std::isfinite(number) || (spec.maximum > spec.minimum && (number < spec.minimum || number > spec.maximum))) std::abort();
  }
  return 0;
}
