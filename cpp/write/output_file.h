// HexFeatureWB - LGPL-2.1-or-later
#pragma once
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace hexfeature {

/// A file that appears under its name only when it is complete. Everything goes to a temporary file beside it;
/// `commit` renames that, the destructor removes it when there was no commit.
/// Throws MeshingError(Output, "write") with the system's reason.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  OutputFile& operator<<(std::string_view text);
  OutputFile& operator<<(int value);
  OutputFile& operator<<(double value) = delete;  // say how: number() or fortran()
  /// At most `width` characters: the shortest text that reads back as the same double when it fits, else as many
  /// digits as do. width >= 20 keeps 13 significant digits at least.
  void number(double value, int width = 24);
  /// Right-aligned in `width` characters.
  void padded(int value, int width);
  /// FORTRAN's 1PD25.16.
  void fortran(double value);
  /// Big-endian, as legacy VTK has it.
  void big_endian(std::int32_t value);
  void big_endian(double value);

  void commit();

 private:
  void flush();
  [[noreturn]] void fail(int error_number) const;

  std::filesystem::path target_, temporary_;
  std::FILE* file_ = nullptr;
  std::string buffer_;
};

}  // namespace hexfeature
