// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <cstdint>
#include <cstring>

namespace hexfeature {

/// Tells whether two lists of numbers are the same without keeping both: FNV-1a, a word at a time.
class Fingerprint {
 public:
  void take(std::uint64_t word) { value_ = (value_ ^ word) * 1099511628211u; }
  void take(double number) {
    std::uint64_t word;
    std::memcpy(&word, &number, sizeof word);
    take(word ^ word >> 32);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 1469598103934665603u;
};

}  // namespace hexfeature
