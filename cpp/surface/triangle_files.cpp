// HexFeatureWB - LGPL-2.1-or-later
#include "surface/triangle_files.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "base/error.h"

namespace hexfeature {
namespace {

[[noreturn]] void bad_input(const std::string& reason, const std::string& hint = "export the surface again") {
  throw MeshingError(Failure::BadInput, "read", reason, hint);
}

std::string load(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) bad_input("there is no file '" + path + "'", "check the path");
  if (std::filesystem::is_directory(status)) bad_input("'" + path + "' is a directory", "give the part's file");
  std::ifstream in(path, std::ios::binary);
  if (!in) bad_input("'" + path + "' cannot be opened", "check its permissions");
  std::string text(std::istreambuf_iterator<char>(in), {});
  if (text.empty()) bad_input("'" + path + "' is empty");
  return text;
}

/// Words and numbers of a text, one after another, independent of the locale.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}
  bool done() {
    skip();
    return at_ == end_;
  }
  std::string_view word() {
    skip();
    const char* begin = at_;
    while (at_ != end_ && !space(*at_)) ++at_;
    return {begin, static_cast<std::size_t>(at_ - begin)};
  }
  std::string_view line() {
    const char* begin = at_;
    while (at_ != end_ && *at_ != '\n') ++at_;
    const char* stop = at_;
    if (at_ != end_) ++at_;
    if (stop != begin && stop[-1] == '\r') --stop;
    return {begin, static_cast<std::size_t>(stop - begin)};
  }
  template <class Number>
  Number number() {
    std::string_view w = word();
    if (!w.empty() && w.front() == '+') w.remove_prefix(1);
    Number value{};
    const auto result = std::from_chars(w.data(), w.data() + w.size(), value);
    if (result.ec != std::errc() || result.ptr != w.data() + w.size()) bad_input("'" + std::string(w.substr(0, 40)) + "' is not a number");
    return value;
  }
  Vec3 point() {
    const double x = number<double>(), y = number<double>(), z = number<double>();
    return {x, y, z};
  }
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  const char* position() const { return at_; }

 private:
  static bool space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  void skip() {
    while (at_ != end_ && space(*at_)) ++at_;
  }
  const char *at_, *end_;
};

bool equals(std::string_view word, const char* lower) {
  if (word.size() != std::strlen(lower)) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (std::tolower(static_cast<unsigned char>(word[i])) != lower[i]) return false;
  return true;
}

TriangleSoup read_stl(const std::string& text) {
  TriangleSoup soup;
  std::uint32_t count = 0;
  if (text.size() >= 84) std::memcpy(&count, text.data() + 80, 4);
  const std::uint64_t needed = 84 + 50 * static_cast<std::uint64_t>(count);
  const bool says_solid = equals(std::string_view(text).substr(0, 5), "solid");
  // Binary files may begin with "solid" too: their length tells.
  if (text.size() >= 84 && count > 0 && (text.size() == needed || (!says_solid && text.size() > needed))) {
    for (std::uint32_t t = 0; t < count; ++t)
      for (int c = 0; c < 3; ++c) {
        float xyz[3];
        std::memcpy(xyz, text.data() + 84 + 50 * static_cast<std::size_t>(t) + 12 * (c + 1), 12);
        soup.points.push_back(Vec3(xyz[0], xyz[1], xyz[2]));
      }
  } else if (says_solid) {
    Scanner scan(text);
    while (!scan.done())
      if (equals(scan.word(), "vertex")) soup.points.push_back(scan.point());
  } else {
    bad_input("the STL file is truncated or not an STL file");
  }
  if (soup.points.size() % 3 != 0) bad_input("the STL file is truncated");
  for (int i = 0; i + 2 < static_cast<int>(soup.points.size()); i += 3) soup.triangles.push_back({i, i + 1, i + 2});
  return soup;
}

void add_fan(TriangleSoup& soup, const std::vector<int>& polygon) {
  if (polygon.size() < 3) return;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) soup.triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
}

TriangleSoup read_obj(const std::string& text) {
  TriangleSoup soup;
  Scanner lines(text);
  std::vector<int> polygon;
  while (lines.left() > 0) {
    Scanner line(lines.line());
    const std::string_view word = line.word();
    if (word == "v") {
      soup.points.push_back(line.point());
    } else if (word == "f") {
      polygon.clear();
      while (!line.done()) {
        std::string_view corner = line.word();
        corner = corner.substr(0, corner.find('/'));
        long index = 0;
        const auto result = std::from_chars(corner.data(), corner.data() + corner.size(), index);
        const long count = static_cast<long>(soup.points.size());
        if (index < 0) index += count + 1;
        if (result.ec != std::errc() || index < 1 || index > count) bad_input("the OBJ file names a vertex that it does not have");
        polygon.push_back(static_cast<int>(index) - 1);
      }
      add_fan(soup, polygon);
    }
  }
  return soup;
}

/// A number of one of PLY's types, from bytes or from text.
class PlyReader {
 public:
  PlyReader(const std::string& text, std::size_t start, int format)
      : text_(text), scan_(std::string_view(text).substr(start)), at_(start), format_(format) {}

  double value(const std::string& type) {
    if (format_ == 0) return scan_.number<double>();
    if (type == "char" || type == "int8") return bytes<std::int8_t>();
    if (type == "uchar" || type == "uint8") return bytes<std::uint8_t>();
    if (type == "short" || type == "int16") return bytes<std::int16_t>();
    if (type == "ushort" || type == "uint16") return bytes<std::uint16_t>();
    if (type == "int" || type == "int32") return bytes<std::int32_t>();
    if (type == "uint" || type == "uint32") return bytes<std::uint32_t>();
    if (type == "float" || type == "float32") return bytes<float>();
    if (type == "double" || type == "float64") return bytes<double>();
    bad_input("the PLY file has a property of unknown type '" + type.substr(0, 40) + "'");
  }
  std::size_t left() const { return format_ == 0 ? scan_.left() : text_.size() - at_; }

 private:
  template <class T>
  double bytes() {
    if (text_.size() - at_ < sizeof(T)) bad_input("the PLY file is truncated");
    char raw[sizeof(T)];
    std::memcpy(raw, text_.data() + at_, sizeof(T));
    if (format_ == 2) std::reverse(raw, raw + sizeof(T));
    T value;
    std::memcpy(&value, raw, sizeof(T));
    at_ += sizeof(T);
    return static_cast<double>(value);
  }
  const std::string& text_;
  Scanner scan_;
  std::size_t at_;
  int format_;  ///< 0 text, 1 little endian, 2 big endian
};

TriangleSoup read_ply(const std::string& text) {
  struct Property {
    std::string name, type, count_type;  // count_type: of a list
  };
  struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
  };
  if (text.compare(0, 3, "ply") != 0) bad_input("the file is not a PLY file");
  Scanner header(text);
  std::vector<Element> elements;
  int format = -1;
  bool ended = false;
  while (header.left() > 0 && !ended) {
    Scanner line(header.line());
    const std::string_view word = line.word();
    if (word == "format") {
      const std::string_view kind = line.word();
      format = kind == "ascii" ? 0 : kind == "binary_little_endian" ? 1 : kind == "binary_big_endian" ? 2 : -1;
    } else if (word == "element") {
      Element e;
      e.name = line.word();
      e.count = line.number<std::uint64_t>();
      elements.push_back(e);
    } else if (word == "property" && !elements.empty()) {
      Property p;
      p.type = line.word();
      if (p.type == "list") {
        p.count_type = line.word();
        p.type = line.word();
      }
      p.name = line.word();
      elements.back().properties.push_back(p);
    } else if (word == "end_header") {
      ended = true;
    }
  }
  if (!ended || format < 0) bad_input("the PLY file's header is incomplete");
  PlyReader reader(text, static_cast<std::size_t>(header.position() - text.data()), format);
  TriangleSoup soup;
  std::vector<int> polygon;
  for (const Element& e : elements) {
    if (e.properties.empty()) continue;
    if (e.count > reader.left()) bad_input("the PLY file is truncated");  // every item takes a byte at least
    for (std::uint64_t i = 0; i < e.count; ++i) {
      Vec3 point = Vec3::Zero();
      for (const Property& p : e.properties) {
        if (p.count_type.empty()) {
          const double value = reader.value(p.type);
          if (p.name.size() == 1 && p.name[0] >= 'x' && p.name[0] <= 'z') point[p.name[0] - 'x'] = value;
          continue;
        }
        const double n = reader.value(p.count_type);
        if (!(n >= 0) || n > static_cast<double>(reader.left())) bad_input("the PLY file is truncated");
        polygon.clear();
        for (int k = 0; k < static_cast<int>(n); ++k) {
          const double index = reader.value(p.type);
          polygon.push_back(index >= 0 && index < 2147483647.0 ? static_cast<int>(index) : -1);
        }
        if (e.name == "face" && (p.name == "vertex_indices" || p.name == "vertex_index")) add_fan(soup, polygon);
      }
      if (e.name == "vertex") soup.points.push_back(point);
    }
  }
  return soup;
}

}  // namespace

TriangleSoup read_triangle_file(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return parse_triangles(load(path), ending);
}

TriangleSoup parse_triangles(const std::string& text, const std::string& ending) {
  TriangleSoup soup;
  if (ending == ".stl")
    soup = read_stl(text);
  else if (ending == ".obj")
    soup = read_obj(text);
  else if (ending == ".ply")
    soup = read_ply(text);
  else
    bad_input("'" + ending + "' is no surface file that can be read", "use .stl, .obj or .ply");
  if (soup.triangles.empty()) bad_input("the file holds no triangles");
  const int n = static_cast<int>(soup.points.size());
  for (const auto& t : soup.triangles)
    for (const int v : t)
      if (v < 0 || v >= n) bad_input("a triangle names a vertex that the file does not have");
  for (const Vec3& p : soup.points)
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() > 1e30) bad_input("a coordinate is not a finite number");
  return soup;
}

}  // namespace hexfeature
