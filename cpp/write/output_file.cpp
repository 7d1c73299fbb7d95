// HexFeatureWB - LGPL-2.1-or-later
#include "write/output_file.h"

#ifdef _WIN32
#include <process.h>
#define getpid _getpid
#else
#include <unistd.h>
#endif

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <system_error>

#include "base/error.h"

namespace hexfeature {
namespace {
constexpr std::size_t kBufferSize = 1 << 20;

std::string hint_for(int error_number) {
  switch (error_number) {
    case ENOENT:
    case ENOTDIR:
      return "make the folder first";
    case ENOSPC:
    case EFBIG:
    case EDQUOT:
      return "free some space, or write to another disk";
    case EISDIR:
      return "give a file name, not a folder";
    default:
      return "write to a folder where you may create files";
  }
}

template <class Unsigned>
void append_big_endian(std::string& buffer, Unsigned bits) {
  for (int shift = 8 * (static_cast<int>(sizeof bits) - 1); shift >= 0; shift -= 8) buffer.push_back(static_cast<char>(bits >> shift));
}
}  // namespace

OutputFile::OutputFile(const std::string& path) : target_(path) {
  std::error_code error;
  if (std::filesystem::is_symlink(target_, error)) target_ = std::filesystem::weakly_canonical(target_, error);
  const auto status = std::filesystem::status(target_, error);
  if (std::filesystem::is_directory(status)) fail(EISDIR);
  // Renaming onto a device or a pipe would replace it.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) fail(EINVAL);

  // STEM.PID.part...: the command line's guard knows these names and removes what a worker that was stopped left of them.
  for (int attempt = 0; !file_; ++attempt) {
    temporary_ = target_.parent_path() / target_.stem();
    temporary_ += "." + std::to_string(getpid()) + ".part" + std::to_string(attempt);
    file_ = std::fopen(temporary_.string().c_str(), "wxb");
    if (!file_ && (errno != EEXIST || attempt == 99)) fail(errno);
  }
  buffer_.reserve(kBufferSize + 256);
}

OutputFile::~OutputFile() {
  if (!file_) return;
  std::fclose(file_);
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void OutputFile::fail(int error_number) const {
  throw MeshingError(Failure::Output, "write", "cannot write '" + target_.string() + "': " + std::strerror(error_number),
                     hint_for(error_number));
}

void OutputFile::flush() {
  if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size()) fail(errno);
  buffer_.clear();
}

OutputFile& OutputFile::operator<<(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= kBufferSize) flush();
  return *this;
}

OutputFile& OutputFile::operator<<(int value) {
  std::array<char, 16> text;
  const auto end = std::to_chars(text.begin(), text.end(), value).ptr;
  return *this << std::string_view(text.data(), end - text.data());
}

void OutputFile::number(double value, int width) {
  std::array<char, 40> text;
  auto end = std::to_chars(text.begin(), text.end(), value).ptr;
  for (int digits = 17; end - text.begin() > width; --digits)
    end = std::to_chars(text.begin(), text.end(), value, std::chars_format::general, digits).ptr;
  *this << std::string_view(text.data(), end - text.data());
}

void OutputFile::padded(int value, int width) {
  std::array<char, 16> text;
  const auto end = std::to_chars(text.begin(), text.end(), value).ptr;
  const int length = static_cast<int>(end - text.begin());
  if (length < width) buffer_.append(width - length, ' ');
  *this << std::string_view(text.data(), length);
}

void OutputFile::fortran(double value) {
  std::array<char, 40> text;
  const int length = std::snprintf(text.data(), text.size(), "%25.16E", value);
  if (auto* e = static_cast<char*>(std::memchr(text.data(), 'E', length))) *e = 'D';
  *this << std::string_view(text.data(), length);
}

void OutputFile::big_endian(std::int32_t value) {
  append_big_endian(buffer_, static_cast<std::uint32_t>(value));
  if (buffer_.size() >= kBufferSize) flush();
}

void OutputFile::big_endian(double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  append_big_endian(buffer_, bits);
  if (buffer_.size() >= kBufferSize) flush();
}

void OutputFile::commit() {
  flush();
  if (std::fflush(file_) != 0) fail(errno);
  std::FILE* file = file_;
  file_ = nullptr;  // closed whatever fclose says; the temporary is removed here, then
  std::error_code error;
  if (std::fclose(file) != 0) {
    const int number = errno;
    std::filesystem::remove(temporary_, error);
    fail(number);
  }
  std::filesystem::rename(temporary_, target_, error);
  if (error) {
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
    fail(error.value());
  }
}

}  // namespace hexfeature
