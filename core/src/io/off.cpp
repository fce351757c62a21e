// SPDX-License-Identifier: MIT
#include "planish/io/off.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "io/coordinate.hpp"
#include "io/text_lines.hpp"
#include "io/text_rows.hpp"
#include "planish/mesh/mesh_repair.hpp"
#include "planish/text/number.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

struct OffDraft {
  long long vertices = 0, faces = 0;  ///< as the header claims; never used to allocate
  std::vector<double> coordinates;
  Mesh mesh;
  SourceLines lines;
};

/// Steps to the next line that holds something.
bool next_filled(TextLines& line) {
  while (line.next()) {
    if (!line.text().empty()) return true;
  }
  return false;
}

/// Whether `word` is OFF with any of its prefixes (ST, C, N) that keep x y z in front.
bool is_keyword(std::string_view word) {
  if (word.size() < 3 || word.substr(word.size() - 3) != "OFF") return false;
  const std::string_view prefix = word.substr(0, word.size() - 3);
  return prefix.find_first_not_of("STCN") == std::string_view::npos;
}

std::string read_header(TextLines& line, OffDraft& draft) {
  if (!next_filled(line)) return "the file is empty";
  std::string_view words = line.text();
  std::string_view word = words;
  if (is_keyword(take_word(word))) {
    words = word;
    if (trimmed(words) == "BINARY") return line_text(line.number(), "binary OFF is not supported");
    if (trimmed(words).empty()) {
      if (!next_filled(line)) return "the file ends after its first line";
      words = line.text();
    }
  }
  const std::optional<long long> vertices = parse_integer(take_word(words));
  const std::optional<long long> faces = parse_integer(take_word(words));
  if (!vertices || !faces || *vertices < 0 || *faces < 0) {
    return line_text(line.number(), "here should be the numbers of vertices and faces (OFF)");
  }
  draft.vertices = *vertices;
  draft.faces = *faces;
  if (*faces == 0) return "the file holds no faces";
  return "";
}

std::string read_vertices(TextLines& line, OffDraft& draft) {
  for (long long v = 0; v < draft.vertices; ++v) {
    if (!next_filled(line)) {
      return "the file ends after " +
             count_text(static_cast<std::size_t>(v), "vertex", "vertices") + ", but promises " +
             std::to_string(draft.vertices);
    }
    std::string_view words = line.text();
    if (const std::string problem = take_point(words, draft.coordinates); !problem.empty()) {
      return line_text(line.number(), problem);
    }
    draft.lines.vertices.push_back(line.number());
  }
  draft.mesh.positions = Eigen::Map<const Positions>(
      draft.coordinates.data(), 3, static_cast<Eigen::Index>(draft.coordinates.size() / 3));
  return "";
}

/// A face line: size, indices, and colours that are passed over.
std::string take_face(std::string_view words, Mesh& mesh) {
  const std::string_view size_word = take_word(words);
  const std::optional<long long> size = parse_integer(size_word);
  if (!size || *size < 0) return quoted(size_word) + " is not a number of vertices";
  for (long long k = 0; k < *size; ++k) {
    const std::string_view word = take_word(words);
    if (word.empty()) {
      return "the face has " + std::to_string(*size) + " vertices, but the line holds " +
             std::to_string(k);
    }
    const std::optional<long long> index = parse_integer(word);
    if (!index) return quoted(word) + " is not a vertex index";
    constexpr long long kLimit = std::numeric_limits<int>::max();
    mesh.face_vertices.push_back(static_cast<int>(std::clamp(*index, -1LL, kLimit)));
  }
  mesh.face_offsets.push_back(static_cast<int>(mesh.face_vertices.size()));
  return "";
}

std::string read_faces(TextLines& line, OffDraft& draft) {
  for (long long f = 0; f < draft.faces; ++f) {
    if (!next_filled(line)) {
      return "the file ends after " + count_text(static_cast<std::size_t>(f), "face", "faces") +
             ", but promises " + std::to_string(draft.faces);
    }
    if (const std::string problem = take_face(line.text(), draft.mesh); !problem.empty()) {
      return line_text(line.number(), problem);
    }
    draft.lines.faces.push_back(line.number());
  }
  return "";
}

/// Some programs count from 1: then no face uses index 0 and one uses index n.
bool counts_from_one(const Mesh& mesh) {
  if (mesh.face_vertices.empty()) return false;
  const auto [least, most] =
      std::minmax_element(mesh.face_vertices.begin(), mesh.face_vertices.end());
  return *least >= 1 && *most == mesh.vertex_count();
}

}  // namespace

ReadResult read_off(std::string_view bytes) {
  if (Refusal refusal = refuse_as_text(bytes)) return ReadError{*refusal};
  OffDraft draft;
  TextLines line(bytes);
  for (const auto step : {read_header, read_vertices, read_faces}) {
    if (std::string problem = step(line, draft); !problem.empty()) return ReadError{problem};
  }
  const bool from_one = counts_from_one(draft.mesh);
  draft.lines.first = from_one ? 1 : 0;
  if (from_one) {
    for (int& v : draft.mesh.face_vertices) --v;
  }
  ReadResult result = repair_and_check(std::move(draft.mesh), draft.lines);
  if (auto* file = std::get_if<MeshFile>(&result); file && from_one) {
    file->warnings.insert(file->warnings.begin(),
                          "the faces count vertices from 1, OFF counts from 0; read as from 1");
  }
  return result;
}

std::string write_off(const Mesh& mesh) {
  std::string text = "OFF\n" + std::to_string(mesh.vertex_count()) + ' ' +
                     std::to_string(mesh.face_count()) + " 0\n";
  append_text_rows(mesh, text);
  return text;
}

}  // namespace planish
