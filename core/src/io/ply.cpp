// SPDX-License-Identifier: MIT
#include "planish/io/ply.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <variant>

#include "io/ply_header.hpp"
#include "io/text_lines.hpp"
#include "io/text_rows.hpp"
#include "planish/mesh/mesh_repair.hpp"
#include "planish/text/number.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

/// Bytes as they stand in the file, or the other way round. Both our targets are little endian.
template <class T>
T value_from(const char* bytes, bool reversed) {
  char buffer[sizeof(T)];
  std::memcpy(buffer, bytes, sizeof(T));
  if (reversed) std::reverse(buffer, buffer + sizeof(T));
  T value;
  std::memcpy(&value, buffer, sizeof(T));
  return value;
}

double number_from(const char* bytes, PlyType type, bool reversed) {
  switch (type) {
    case PlyType::kInt8:
      return value_from<std::int8_t>(bytes, reversed);
    case PlyType::kUint8:
      return value_from<std::uint8_t>(bytes, reversed);
    case PlyType::kInt16:
      return value_from<std::int16_t>(bytes, reversed);
    case PlyType::kUint16:
      return value_from<std::uint16_t>(bytes, reversed);
    case PlyType::kInt32:
      return value_from<std::int32_t>(bytes, reversed);
    case PlyType::kUint32:
      return value_from<std::uint32_t>(bytes, reversed);
    case PlyType::kFloat32:
      return static_cast<double>(value_from<float>(bytes, reversed));
    case PlyType::kFloat64:
      return value_from<double>(bytes, reversed);
  }
  return 0.0;
}

/// Hands out the values of the body one after the other. After a failure `problem` says why.
class ValueStream {
 public:
  /// @param row_a_line whether each row of a text file stands on a line of its own
  ValueStream(const PlyHeader& header, bool row_a_line)
      : encoding_(header.encoding),
        row_a_line_(row_a_line),
        rest_(header.body),
        lines_(header.body),
        first_line_(header.body_line) {}

  /// Starts a row: where it has a line of its own, what is left on the line before is passed over.
  void start_row() {
    if (row_a_line_) next_line();
  }

  /// Whether nothing stands on the lines behind the last row.
  [[nodiscard]] bool ends() {
    next_line();
    return words_.empty();
  }

  /// The first line that held more than its row; 0 for none.
  [[nodiscard]] int first_long_line() const { return first_long_line_; }

  std::optional<double> take(PlyType type) {
    return encoding_ == PlyEncoding::kAscii ? take_text() : take_binary(type);
  }

  /// The place as messages say it: "line 12: " in a text file.
  [[nodiscard]] std::string place() const {
    return encoding_ == PlyEncoding::kAscii ? line_text(line(), "") : "";
  }
  [[nodiscard]] int line() const { return first_line_ + lines_.number() - 1; }
  [[nodiscard]] bool is_text() const { return encoding_ == PlyEncoding::kAscii; }
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  void next_line() {
    if (!trimmed(words_).empty() && first_long_line_ == 0) first_long_line_ = line();
    words_ = {};
    while (words_.empty() && lines_.next()) words_ = lines_.text();
  }

  std::optional<double> take_binary(PlyType type) {
    const std::size_t size = ply_size(type);
    if (rest_.size() < size) return fail("the file ends early");
    const double value =
        number_from(rest_.data(), type, encoding_ == PlyEncoding::kBinaryBigEndian);
    rest_.remove_prefix(size);
    return value;
  }

  std::optional<double> take_text() {
    std::string_view word = take_word(words_);
    if (word.empty() && row_a_line_) return fail("the line holds less than its row");
    while (word.empty()) {
      if (!lines_.next()) return fail("the file ends early");
      words_ = lines_.text();
      word = take_word(words_);
    }
    const std::optional<double> value = parse_number(word);
    return value ? value : fail(quoted(word) + " is not a number");
  }

  std::optional<double> fail(const std::string& what) {
    problem_ = what;
    return std::nullopt;
  }

  PlyEncoding encoding_;
  bool row_a_line_;
  std::string_view rest_, words_;
  TextLines lines_;
  int first_line_, first_long_line_ = 0;
  std::string problem_;
};

/// What is kept of a property.
enum class Role { kSkip, kX, kY, kZ, kCorners };

Role role_of(const PlyElement& element, const PlyProperty& property) {
  if (element.name == "vertex" && !property.count_type) {
    if (property.name == "x") return Role::kX;
    if (property.name == "y") return Role::kY;
    if (property.name == "z") return Role::kZ;
  }
  const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
  if (element.name == "face" && corners && property.count_type) return Role::kCorners;
  return Role::kSkip;
}

struct PlyDraft {
  std::vector<double> coordinates;
  Mesh mesh;
  SourceLines lines;
  int first_long_line = 0;  ///< that holds more than its row; 0 for none
};

/// An index that check_mesh() can judge: anything that is none becomes −1.
int to_index(double value) {
  const bool index = value >= 0 && value <= std::numeric_limits<int>::max();
  return index && std::floor(value) == value ? static_cast<int>(value) : -1;
}

bool read_list(const PlyProperty& property, Role role, ValueStream& values, PlyDraft& draft) {
  const std::optional<double> count = values.take(*property.count_type);
  if (!count || !(*count >= 0)) return false;
  for (double k = 0; k < *count; ++k) {
    const std::optional<double> value = values.take(property.type);
    if (!value) return false;
    if (role == Role::kCorners) draft.mesh.face_vertices.push_back(to_index(*value));
  }
  return true;
}

/// Reads one vertex, face or other row.
bool read_row(const PlyElement& element, const std::vector<Role>& roles, ValueStream& values,
              PlyDraft& draft) {
  double point[3] = {0.0, 0.0, 0.0};
  for (std::size_t k = 0; k < roles.size(); ++k) {
    const PlyProperty& property = element.properties[k];
    if (property.count_type) {
      if (!read_list(property, roles[k], values, draft)) return false;
      continue;
    }
    const std::optional<double> value = values.take(property.type);
    if (!value) return false;
    if (roles[k] == Role::kX) point[0] = *value;
    if (roles[k] == Role::kY) point[1] = *value;
    if (roles[k] == Role::kZ) point[2] = *value;
  }
  if (element.name == "vertex") {
    draft.coordinates.insert(draft.coordinates.end(), point, point + 3);
    if (values.is_text()) draft.lines.vertices.push_back(values.line());
  } else if (element.name == "face") {
    draft.mesh.face_offsets.push_back(static_cast<int>(draft.mesh.face_vertices.size()));
    if (values.is_text()) draft.lines.faces.push_back(values.line());
  }
  return true;
}

/// Elements without properties take no bytes, so a claimed count of them could run for ever.
std::string read_element(const PlyElement& element, ValueStream& values, PlyDraft& draft) {
  if (element.properties.empty()) return "";
  std::vector<Role> roles;
  for (const PlyProperty& property : element.properties) {
    roles.push_back(role_of(element, property));
  }
  for (std::uint64_t row = 0; row < element.count; ++row) {
    values.start_row();
    if (read_row(element, roles, values, draft)) continue;
    const bool known = element.name == "vertex" || element.name == "face";
    const std::string name = known ? element.name : planish::quoted(element.name);
    return values.place() + name + " " + std::to_string(row) + ": " +
           (values.problem().empty() ? "the length of a list is negative" : values.problem());
  }
  return "";
}

/// Reads all elements. As text each row has a line of its own, or rows follow word by word: then
/// none of them can hold more than the header declares.
std::variant<PlyDraft, std::string> read_body(const PlyHeader& header, bool row_a_line) {
  PlyDraft draft;
  ValueStream values(header, row_a_line);
  for (const PlyElement& element : header.elements) {
    if (std::string problem = read_element(element, values, draft); !problem.empty()) {
      return problem;
    }
  }
  if (row_a_line && !values.ends()) return std::string("lines are left over");
  draft.first_long_line = values.first_long_line();
  draft.mesh.positions = Eigen::Map<const Positions>(
      draft.coordinates.data(), 3, static_cast<Eigen::Index>(draft.coordinates.size() / 3));
  return draft;
}

bool has_role(const PlyElement& element, Role role) {
  return std::any_of(
      element.properties.begin(), element.properties.end(),
      [&](const PlyProperty& property) { return role_of(element, property) == role; });
}

std::string refuse_header(const PlyHeader& header) {
  int vertex_elements = 0, face_elements = 0;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      ++vertex_elements;
      for (const Role role : {Role::kX, Role::kY, Role::kZ}) {
        if (!has_role(element, role)) {
          return line_text(element.line, "element vertex has no x, y and z");
        }
      }
    }
    if (element.name == "face") {
      ++face_elements;
      if (element.count == 0) return "the file holds no faces";
      if (!has_role(element, Role::kCorners)) {
        return line_text(element.line, "element face has no list vertex_indices");
      }
    }
  }
  if (vertex_elements > 1 || face_elements > 1) return "the header declares an element twice";
  if (vertex_elements == 0) return "the file holds no vertices";
  if (face_elements == 0) return "the file holds no faces";
  return "";
}

template <class T>
void append_value(std::string& bytes, T value, PlyEncoding encoding) {
  char buffer[sizeof(T)];
  std::memcpy(buffer, &value, sizeof(T));
  if (encoding == PlyEncoding::kBinaryBigEndian) std::reverse(buffer, buffer + sizeof(T));
  bytes.append(buffer, sizeof(T));
}

std::string_view encoding_name(PlyEncoding encoding) {
  switch (encoding) {
    case PlyEncoding::kAscii:
      return "ascii";
    case PlyEncoding::kBinaryLittleEndian:
      return "binary_little_endian";
    case PlyEncoding::kBinaryBigEndian:
      return "binary_big_endian";
  }
  return "";
}

void append_binary_body(const Mesh& mesh, PlyEncoding encoding, bool small_faces,
                        std::string& bytes) {
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    for (int c = 0; c < 3; ++c) append_value(bytes, mesh.positions(c, v), encoding);
  }
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::size_t size = mesh.face(f).size();
    if (small_faces) {
      append_value(bytes, static_cast<std::uint8_t>(size), encoding);
    } else {
      append_value(bytes, static_cast<std::uint32_t>(size), encoding);
    }
    for (const int v : mesh.face(f)) append_value(bytes, static_cast<std::int32_t>(v), encoding);
  }
}

}  // namespace

ReadResult read_ply(std::string_view bytes) {
  if (Refusal refusal = refuse_size(bytes)) return ReadError{*refusal};
  const auto header_or_problem = read_ply_header(bytes);
  if (const auto* problem = std::get_if<std::string>(&header_or_problem)) {
    return ReadError{*problem};
  }
  const auto& header = std::get<PlyHeader>(header_or_problem);
  if (std::string problem = refuse_header(header); !problem.empty()) return ReadError{problem};
  auto read = std::variant<PlyDraft, std::string>(std::string());
  if (header.encoding == PlyEncoding::kAscii) read = read_body(header, true);
  if (std::holds_alternative<std::string>(read)) read = read_body(header, false);
  if (auto* problem = std::get_if<std::string>(&read)) return ReadError{std::move(*problem)};
  auto& draft = std::get<PlyDraft>(read);
  ReadResult result = repair_and_check(std::move(draft.mesh), draft.lines);
  if (auto* file = std::get_if<MeshFile>(&result)) {
    std::vector<std::string> warnings = header.warnings;
    if (draft.first_long_line > 0) {
      warnings.push_back("rows hold more values than the header declares (first: line " +
                         std::to_string(draft.first_long_line) + "); the rest is passed over");
    }
    file->warnings.insert(file->warnings.begin(), warnings.begin(), warnings.end());
  }
  return result;
}

std::string write_ply(const Mesh& mesh, PlyEncoding encoding) {
  bool small_faces = true;
  for (int f = 0; f < mesh.face_count(); ++f) small_faces &= mesh.face(f).size() <= 255;
  std::string bytes = "ply\nformat ";
  bytes += encoding_name(encoding);
  bytes += " 1.0\ncomment Planish\nelement vertex ";
  append_integer(bytes, mesh.vertex_count());
  bytes += "\nproperty double x\nproperty double y\nproperty double z\nelement face ";
  append_integer(bytes, mesh.face_count());
  bytes += small_faces ? "\nproperty list uchar int" : "\nproperty list uint int";
  bytes += " vertex_indices\nend_header\n";
  if (encoding == PlyEncoding::kAscii) {
    append_text_rows(mesh, bytes);
  } else {
    append_binary_body(mesh, encoding, small_faces, bytes);
  }
  return bytes;
}

}  // namespace planish
