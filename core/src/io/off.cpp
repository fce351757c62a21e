// SPDX-License-Identifier: MIT
#include "planish/io/off.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
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
  std::string wrapped;  ///< says which face was the first to go on in the next line
};

/// The words of a file, in their lines.
class OffWords {
 public:
  /// Whether a vertex or face starts a line, with colours behind it that are passed over, or
  /// follows the one before word by word.
  enum class Layout { kLines, kStream };

  OffWords(std::string_view bytes, Layout layout) : line_(bytes), layout_(layout) {}

  /// Steps to where the next vertex or face starts; false at the end.
  bool next_element() { return stays() || next_line(); }

  /// Steps to the next line that holds something.
  bool next_line() {
    while (line_.next()) {
      words_ = line_.text();
      if (!words_.empty()) return true;
    }
    words_ = {};
    return false;
  }

  /// The next word of the current line, "" at its end.
  std::string_view take() { return take_word(words_); }

  [[nodiscard]] std::string_view& words() { return words_; }
  [[nodiscard]] bool at_line_end() const { return trimmed(words_).empty(); }
  [[nodiscard]] Layout layout() const { return layout_; }
  [[nodiscard]] int line() const { return line_.number(); }

 private:
  [[nodiscard]] bool stays() const { return layout_ == Layout::kStream && !at_line_end(); }

  TextLines line_;
  std::string_view words_;
  Layout layout_;
};

/// What stands before the counts: "OFF", its variants, and counts glued to it.
struct OffKeyword {
  std::string_view prefix;  ///< of the variants: "ST", "C", "N", "4", "n" …
  std::string_view counts;
};

/// The keyword at the start of `word`, also in small letters; nullopt if there is none.
std::optional<OffKeyword> keyword_in(std::string_view word) {
  const std::size_t at = std::min(word.find("OFF"), word.find("off"));
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view prefix = word.substr(0, at), counts = word.substr(at + 3);
  if (prefix.find_first_not_of("STCNstcn4") != std::string_view::npos) return std::nullopt;
  if (!counts.empty() && !parse_integer(counts)) return std::nullopt;
  return OffKeyword{prefix, counts};
}

/// Points of 4 or of any number of coordinates: 4OFF, nOFF. In "noff" n is for normals.
bool has_other_dimension(std::string_view word, const OffKeyword& keyword) {
  const bool capitals = word.find("OFF") != std::string_view::npos;
  return keyword.prefix.find(capitals ? "n" : "4") != std::string_view::npos ||
         keyword.prefix.find('4') != std::string_view::npos;
}

std::string read_header(OffWords& words, OffDraft& draft) {
  if (!words.next_line()) return "the file is empty";
  std::string_view rest = words.words();
  const std::string_view word = take_word(rest);
  if (const auto keyword = keyword_in(word)) {
    if (has_other_dimension(word, *keyword)) {
      return line_text(words.line(),
                       "OFF with points of other than 3 coordinates is not supported");
    }
    words.words() = keyword->counts.empty() ? rest
                                            : words.words().substr(static_cast<std::size_t>(
                                                  keyword->counts.data() - words.words().data()));
    if (words.at_line_end() && !words.next_line()) return "the file ends after its first line";
  }
  const std::optional<long long> vertices = parse_integer(words.take());
  const std::optional<long long> faces = parse_integer(words.take());
  if (!vertices || !faces || *vertices < 0 || *faces < 0) {
    return line_text(words.line(), "here should be the numbers of vertices and faces (OFF)");
  }
  draft.vertices = *vertices;
  draft.faces = *faces;
  if (*faces == 0) return "the file holds no faces";
  static_cast<void>(words.take());  // the number of edges
  return "";
}

/// What a file that ends early lacks.
std::string ends_early(long long count, const char* one, const char* many, long long promised) {
  return "the file ends after " + count_text(static_cast<std::size_t>(count), one, many) +
         ", but promises " + std::to_string(promised);
}

/// The words of a point, from as many lines as they stand on where the file is a stream.
std::string take_vertex(OffWords& words, std::vector<double>& coordinates) {
  if (words.layout() == OffWords::Layout::kLines) return take_point(words.words(), coordinates);
  std::string point;
  for (int c = 0; c < 3; ++c) {
    if (words.at_line_end() && !words.next_line()) break;
    point += std::string(words.take()) + ' ';
  }
  std::string_view three = point;
  return take_point(three, coordinates);
}

std::string read_vertices(OffWords& words, OffDraft& draft) {
  for (long long v = 0; v < draft.vertices; ++v) {
    if (!words.next_element()) return ends_early(v, "vertex", "vertices", draft.vertices);
    draft.lines.vertices.push_back(words.line());
    if (const std::string problem = take_vertex(words, draft.coordinates); !problem.empty()) {
      return line_text(words.line(), problem);
    }
  }
  draft.mesh.positions = Eigen::Map<const Positions>(
      draft.coordinates.data(), 3, static_cast<Eigen::Index>(draft.coordinates.size() / 3));
  return "";
}

/// A face: size, indices that may go on in the next lines, and colours that are passed over.
std::string take_face(OffWords& words, OffDraft& draft) {
  const std::string_view size_word = words.take();
  const std::optional<long long> size = parse_integer(size_word);
  if (!size || *size < 0) return quoted(size_word) + " is not a number of vertices";
  for (long long k = 0; k < *size; ++k) {
    if (words.at_line_end()) {
      const std::string held = "the face has " + std::to_string(*size) +
                               " vertices, but the line holds " + std::to_string(k);
      if (draft.wrapped.empty()) draft.wrapped = line_text(words.line(), held);
      if (!words.next_line()) return held;
    }
    const std::string_view word = words.take();
    const std::optional<long long> index = parse_integer(word);
    if (!index) return quoted(word) + " is not a vertex index";
    constexpr long long kLimit = std::numeric_limits<int>::max();
    draft.mesh.face_vertices.push_back(static_cast<int>(std::clamp(*index, -1LL, kLimit)));
  }
  draft.mesh.face_offsets.push_back(static_cast<int>(draft.mesh.face_vertices.size()));
  return "";
}

std::string read_faces(OffWords& words, OffDraft& draft) {
  for (long long f = 0; f < draft.faces; ++f) {
    if (!words.next_element()) {
      // A face went on in the next line by mistake: that is where the file is broken.
      if (!draft.wrapped.empty()) return draft.wrapped;
      return ends_early(f, "face", "faces", draft.faces);
    }
    draft.lines.faces.push_back(words.line());
    if (const std::string problem = take_face(words, draft); !problem.empty()) {
      return line_text(words.line(), problem);
    }
  }
  return "";
}

/// The file in one of its layouts, or what is wrong with it in that one.
std::variant<OffDraft, std::string> read_draft(std::string_view bytes, OffWords::Layout layout) {
  OffDraft draft;
  OffWords words(bytes, layout);
  for (const auto step : {read_header, read_vertices, read_faces}) {
    if (std::string problem = step(words, draft); !problem.empty()) return problem;
  }
  if (layout == OffWords::Layout::kStream && (!words.at_line_end() || words.next_line())) {
    return std::string("words are left over");
  }
  return draft;
}

/// Refuses what says that it is binary before it is refused as no text.
Refusal refuse_binary(std::string_view bytes) {
  TextLines line(bytes.substr(0, 256));
  while (line.next()) {
    std::string_view words = line.text();
    if (words.empty()) continue;
    if (!keyword_in(take_word(words))) return std::nullopt;
    std::string_view second = take_word(words);
    if (second != "BINARY" && second != "binary") return std::nullopt;
    return line_text(line.number(), "binary OFF is not supported");
  }
  return std::nullopt;
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
  if (Refusal refusal = refuse_binary(bytes)) return ReadError{*refusal};
  if (Refusal refusal = refuse_as_text(bytes)) return ReadError{*refusal};
  auto read = read_draft(bytes, OffWords::Layout::kLines);
  if (std::holds_alternative<std::string>(read)) {
    auto stream = read_draft(bytes, OffWords::Layout::kStream);
    if (std::holds_alternative<OffDraft>(stream)) read = std::move(stream);
  }
  if (auto* problem = std::get_if<std::string>(&read)) return ReadError{std::move(*problem)};
  auto& draft = std::get<OffDraft>(read);
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
