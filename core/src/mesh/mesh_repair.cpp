// SPDX-License-Identifier: MIT
#include "planish/mesh/mesh_repair.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mesh/separate_faces.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

/// How often a fault was found, and the file's name of the first face with it.
class Fault {
 public:
  void add(int f, const SourceLines& lines) {
    if (count_++ > 0) return;
    const auto face = static_cast<std::size_t>(f);
    first_ = lines.faces.empty() ? "face " + std::to_string(f + lines.first)
                                 : line_text(lines.faces[face], "");
    if (!lines.faces.empty()) first_.resize(first_.size() - 2);  // the colon
  }

  void warn(const char* one, const char* many, const std::string& mended,
            std::vector<std::string>& warnings) const {
    if (count_ == 0) return;
    warnings.push_back(count_text(count_, one, many) + " (first: " + first_ + "); " + mended);
  }

 private:
  std::size_t count_ = 0;
  std::string first_;
};

/// Puts `v` after the corners so far: a repeat is dropped, and so is an edge gone there and back.
void walk_to(int v, std::vector<int>& corners) {
  const std::size_t count = corners.size();
  if (count >= 1 && corners.back() == v) return;
  if (count >= 2 && corners[count - 2] == v) {
    corners.pop_back();
    return;
  }
  corners.push_back(v);
}

/// Drops repeats, and edges gone there and back, where the last corners meet the first ones.
void close_walk(std::vector<int>& corners) {
  while (corners.size() >= 2) {
    if (corners.back() == corners.front()) {
      corners.pop_back();
    } else if (corners.size() >= 3 && corners[corners.size() - 2] == corners.front()) {
      corners.resize(corners.size() - 2);
    } else if (corners.size() >= 3 && corners.back() == corners[1]) {
      corners.erase(corners.begin(), corners.begin() + 2);
    } else {
      return;
    }
  }
}

/// A face's corners without repeats and edges gone there and back.
std::vector<int> simple_corners(std::span<const int> face) {
  std::vector<int> corners;
  for (const int v : face) walk_to(v, corners);
  close_walk(corners);
  return corners;
}

/// Too few corners, as written, or one that comes again after one or two steps. A face without any
/// is no slip of an exporter; check_mesh() refuses it.
bool needs_repair(const Mesh& mesh, int f) {
  const auto face = mesh.face(f);
  const std::size_t count = face.size();
  if (count == 1 || count == 2) return true;
  for (std::size_t k = 0; k < count; ++k) {
    if (face[k] == face[(k + 1) % count] || face[k] == face[(k + 2) % count]) return true;
  }
  return false;
}

/// What becomes of the names of panels behind those that are left out.
std::string left_out_text(const SeparateFaces& faces) {
  const auto first = std::find(faces.left_out.begin(), faces.left_out.end(), 1);
  const auto kept_after = std::count(first, faces.left_out.end(), 0);
  if (kept_after == 0) return "left out";
  const bool one = std::count(first, faces.left_out.end(), 1) == 1;
  return one ? "left out, so each panel after it has a number and name one lower than in the file"
             : "left out, so panels after them have lower numbers and names than in the file";
}

bool any_needs_repair(const Mesh& mesh) {
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (needs_repair(mesh, f)) return true;
  }
  return false;
}

void name_corners_once(const Mesh& mesh, const SourceLines& lines, SeparateFaces& faces,
                       std::vector<std::string>& warnings) {
  Fault repeated, gone;
  for (std::size_t f = 0; f < faces.corners.size(); ++f) {
    if (!needs_repair(mesh, static_cast<int>(f))) continue;
    std::vector<int>& face = faces.corners[f];
    std::vector<int> simple = simple_corners(face);
    faces.left_out[f] = simple.size() < 3 ? 1 : 0;
    (faces.left_out[f] ? gone : repeated).add(static_cast<int>(f), lines);
    if (!faces.left_out[f]) face = std::move(simple);
  }
  repeated.warn("face names a corner twice", "faces name a corner twice", "it is read once",
                warnings);
  gone.warn("face has fewer than 3 different corners", "faces have fewer than 3 different corners",
            left_out_text(faces), warnings);
}

/// What is left of the lines, and the file's numbers of the faces.
SourceLines kept_lines(SourceLines lines, const SeparateFaces& faces) {
  std::vector<int> numbers, kept;
  for (std::size_t f = 0; f < faces.left_out.size(); ++f) {
    if (faces.left_out[f]) continue;
    numbers.push_back(lines.number_of_face(static_cast<int>(f)));
    if (!lines.faces.empty()) kept.push_back(lines.faces[f]);
  }
  lines.faces = std::move(kept);
  lines.face_numbers = std::move(numbers);
  return lines;
}

}  // namespace

ReadResult repair_and_check(Mesh mesh, SourceLines lines) {
  if (!any_needs_repair(mesh)) return check_mesh(std::move(mesh), lines);
  std::vector<std::string> warnings;
  SeparateFaces faces = separate_faces(mesh);
  name_corners_once(mesh, lines, faces, warnings);
  lines = kept_lines(std::move(lines), faces);
  ReadResult result = check_mesh(with_faces(std::move(mesh), faces), lines);
  if (auto* file = std::get_if<MeshFile>(&result)) {
    file->warnings.insert(file->warnings.begin(), warnings.begin(), warnings.end());
  }
  return result;
}

}  // namespace planish
