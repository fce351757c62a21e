// SPDX-License-Identifier: MIT
#include "planish/io/obj.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "io/coordinate.hpp"
#include "io/text_lines.hpp"
#include "planish/mesh/mesh_repair.hpp"
#include "planish/text/number.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

/// A file while it is read. Face corners hold the file's positive indices until the end, since
/// faces may come first.
struct ObjDraft {
  std::vector<double> coordinates;  ///< x y z, one vertex after the other
  std::vector<int> face_offsets{0};
  std::vector<int> corners;  ///< from 1
  std::vector<FaceGroup> groups;
  SourceLines lines;

  [[nodiscard]] long long vertex_count() const {
    return static_cast<long long>(coordinates.size() / 3);
  }
  [[nodiscard]] int face_count() const { return static_cast<int>(face_offsets.size()) - 1; }
};

/// Appends the corner `word` ("7", "7/1", "7//3", "7/1/3", "-1"). Returns what is wrong.
std::string take_corner(std::string_view word, ObjDraft& draft) {
  const std::string_view index_word = word.substr(0, word.find('/'));
  const std::string_view attributes = word.substr(index_word.size());
  const std::optional<long long> index = parse_integer(index_word);
  if (!index || attributes.find_first_not_of("/-+0123456789") != std::string_view::npos) {
    return quoted(word) + " is not a face corner";
  }
  if (*index == 0) return "a face uses index 0, but OBJ counts from 1";
  const long long from_one = *index > 0 ? *index : draft.vertex_count() + 1 + *index;
  if (from_one < 1) {
    return "the relative index " + std::to_string(*index) + " points before the first vertex";
  }
  if (from_one > std::numeric_limits<int>::max()) {
    return "the index " + quoted(index_word) + " is too large";
  }
  draft.corners.push_back(static_cast<int>(from_one));
  return "";
}

std::string take_face(std::string_view words, ObjDraft& draft) {
  for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
    if (std::string problem = take_corner(word, draft); !problem.empty()) return problem;
  }
  draft.face_offsets.push_back(static_cast<int>(draft.corners.size()));
  return "";
}

/// The statements of OBJ. A line that begins with one is none that a backslash has broken.
constexpr std::string_view kStatements[] = {
    "v",    "vt",   "vn",   "vp",     "f",      "fo",     "l",      "p",          "g",
    "o",    "s",    "mg",   "usemtl", "mtllib", "usemap", "maplib", "cstype",     "deg",
    "bmat", "step", "surf", "curv",   "curv2",  "parm",   "trim",   "hole",       "scrv",
    "sp",   "end",  "con",  "bevel",  "lod",    "ctech",  "stech",  "c_interp",   "d_interp",
    "call", "csh",  "bsp",  "bzp",    "cdc",    "cdp",    "res",    "shadow_obj", "trace_obj"};

bool begins_statement(std::string_view line) {
  const std::string_view word = take_word(line);
  return word.empty() || word.front() == '#' ||
         std::find(std::begin(kStatements), std::end(kStatements), word) != std::end(kStatements);
}

/// Numbers without the backslash of a line that the next one does not go on.
std::string_view without_backslash(std::string_view words) {
  if (!words.empty() && words.back() == '\\') words.remove_suffix(1);
  return words;
}

/// What follows the keyword of `line` up to a '#' with a blank on both sides: "Panel #1" is a name.
std::string_view name_in(std::string_view line) {
  static_cast<void>(take_word(line));
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1)) {
    const bool ends = at + 1 == line.size() || is_blank(line[at + 1]);
    if (ends && is_blank(line[at - 1])) return trimmed(line.substr(0, at));
  }
  return trimmed(line);
}

/// A group without faces leaves no trace: the next one takes its place.
void start_group(std::string_view name, bool one_name, ObjDraft& draft) {
  const int first_face = draft.face_count();
  if (!draft.groups.empty() && draft.groups.back().first_face == first_face) {
    draft.groups.pop_back();
  }
  draft.groups.push_back({std::string(name), first_face, one_name});
}

/// Takes one line into the draft. Returns what is wrong, without the line.
std::string take_line(const TextLines& line, ObjDraft& draft) {
  std::string_view words = line.text();
  const std::string_view keyword = take_word(words);
  if (keyword == "v") {
    draft.lines.vertices.push_back(line.number());
    words = without_backslash(words);
    return take_point(words, draft.coordinates);
  }
  if (keyword == "f") {
    draft.lines.faces.push_back(line.number());
    return take_face(without_backslash(words), draft);
  }
  if (keyword == "g" || keyword == "o") {
    const std::string_view name = name_in(line.with_comment());
    const bool blanks = std::any_of(name.begin(), name.end(), is_blank);
    start_group(name, keyword == "o" && blanks, draft);
  }
  return "";
}

/// Indices from 0, all in range.
std::string resolve_corners(ObjDraft& draft) {
  const auto count = draft.vertex_count();
  std::size_t face = 0;
  for (std::size_t k = 0; k < draft.corners.size(); ++k) {
    while (static_cast<int>(k) >= draft.face_offsets[face + 1]) ++face;
    if (draft.corners[k] > count) {
      return line_text(draft.lines.faces[face],
                       "a face uses vertex " + std::to_string(draft.corners[k]) +
                           " (from 1), but the file has " +
                           count_text(static_cast<std::size_t>(count), "vertex", "vertices"));
    }
    --draft.corners[k];
  }
  return "";
}

Mesh to_mesh(ObjDraft& draft) {
  Mesh mesh;
  mesh.positions = Eigen::Map<const Positions>(draft.coordinates.data(), 3,
                                               static_cast<Eigen::Index>(draft.vertex_count()));
  mesh.face_offsets = std::move(draft.face_offsets);
  mesh.face_vertices = std::move(draft.corners);
  if (!draft.groups.empty() && draft.groups.back().first_face == mesh.face_count()) {
    draft.groups.pop_back();
  }
  mesh.groups = std::move(draft.groups);
  return mesh;
}

/// A name must stay on its line.
std::string one_line(std::string_view name) {
  std::string result(name);
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\\') c = ' ';
  }
  return result;
}

}  // namespace

ReadResult read_obj(std::string_view bytes) {
  if (Refusal refusal = refuse_as_text(bytes)) return ReadError{*refusal};
  if (bytes.empty()) return ReadError{"the file is empty"};
  ObjDraft draft;
  TextLines line(bytes, begins_statement);
  while (line.next()) {
    if (const std::string problem = take_line(line, draft); !problem.empty()) {
      return ReadError{line_text(line.number(), problem)};
    }
  }
  if (draft.coordinates.empty()) return ReadError{"the file holds no vertices (no \"v\" lines)"};
  if (draft.face_count() == 0) return ReadError{"the file holds no faces (no \"f\" lines)"};
  if (std::string problem = resolve_corners(draft); !problem.empty()) return ReadError{problem};
  Mesh mesh = to_mesh(draft);
  draft.lines.first = 1;
  return repair_and_check(std::move(mesh), draft.lines);
}

std::string write_obj(const Mesh& mesh) {
  std::string text = "# Planish, " + std::to_string(mesh.vertex_count()) + " vertices, " +
                     std::to_string(mesh.face_count()) + " faces\n";
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    text += 'v';
    for (int c = 0; c < 3; ++c) {
      text += ' ';
      append_exact(text, mesh.positions(c, v));
    }
    text += '\n';
  }
  auto group = mesh.groups.begin();
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (; group != mesh.groups.end() && group->first_face == f; ++group) {
      text += (group->one_name ? "o " : "g ") + one_line(group->name) + '\n';
    }
    text += 'f';
    for (const int v : mesh.face(f)) {
      text += ' ';
      append_integer(text, v + 1LL);
    }
    text += '\n';
  }
  return text;
}

}  // namespace planish
