// SPDX-License-Identifier: MIT
#include "reader_promises.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "memory_meter.hpp"
#include "planish/design/design_text.hpp"
#include "planish/io/gltf.hpp"
#include "planish/io/ply.hpp"
#include "planish/mesh/mesh_check.hpp"

namespace planish::fuzz {
namespace {

void require(bool kept, const char* promise) {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

bool same_bits(const Positions& a, const Positions& b) {
  return a.cols() == b.cols() &&
         (a.size() == 0 || std::memcmp(a.data(), b.data(),
                                       sizeof(double) * static_cast<std::size_t>(a.size())) == 0);
}

bool same_geometry(const Mesh& a, const Mesh& b) {
  return same_bits(a.positions, b.positions) && a.face_offsets == b.face_offsets &&
         a.face_vertices == b.face_vertices;
}

bool same_groups(const Mesh& a, const Mesh& b) {
  if (a.groups.size() != b.groups.size()) return false;
  for (std::size_t k = 0; k < a.groups.size(); ++k) {
    if (a.groups[k].first_face != b.groups[k].first_face) return false;
    if (a.groups[k].name != b.groups[k].name) return false;
    if (a.groups[k].one_name != b.groups[k].one_name) return false;
  }
  return true;
}

void check_refusal(const std::string& sentence) {
  require(!sentence.empty(), "a refusal says why");
  require(std::none_of(sentence.begin(), sentence.end(),
                       [](char c) { return static_cast<unsigned char>(c) < ' '; }),
          "a refusal is one line, without control characters");
  require(sentence.size() < 400, "a refusal is one sentence");
}

void check_groups(const Mesh& mesh) {
  int last = -1;
  for (const FaceGroup& group : mesh.groups) {
    require(group.first_face > last && group.first_face < mesh.face_count(),
            "groups are sorted and inside the mesh");
    last = group.first_face;
  }
}

void check_round_trip(const Mesh& mesh, MeshFormat format) {
  const ReadResult again = read_mesh(write_mesh(mesh, format), format);
  if (const auto* error = std::get_if<ReadError>(&again)) {
    std::fprintf(stderr, "read again: %s\n", error->message.c_str());
  }
  const auto* file = std::get_if<MeshFile>(&again);
  require(file != nullptr, "what is written can be read");
  require(same_geometry(mesh, file->mesh), "what is written comes back to the same bits");
  if (format == MeshFormat::kGlb) require(same_groups(mesh, file->mesh), "GLB keeps the groups");
}

/// Writing four files costs several times what reading one does, so every eighth input pays it. By
/// the bytes alone: a finding stays one when it is run again.
bool is_sampled(std::string_view bytes) {
  std::uint32_t hash = 2166136261u;  // FNV-1a
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return (hash >> 16) % 8 == 0;
}

void check_mesh_file(const MeshFile& file, bool round_trip) {
  const Mesh& mesh = file.mesh;
  require(mesh.positions.allFinite(), "coordinates are finite");
  check_groups(mesh);
  const ReadResult checked = check_mesh(mesh);
  const auto* same = std::get_if<MeshFile>(&checked);
  require(same != nullptr, "an accepted mesh passes check_mesh() again");
  require(same_geometry(mesh, same->mesh), "check_mesh() changes nothing");
  if (!round_trip) return;
  for (const MeshFormat format :
       {MeshFormat::kObj, MeshFormat::kOff, MeshFormat::kPly, MeshFormat::kGlb}) {
    check_round_trip(mesh, format);
  }
}

void check_memory(std::size_t peak, std::size_t size, MemoryBound bound) {
  if (peak <= bound.fixed + bound.multiple * size) return;
  std::fprintf(stderr, "%zu bytes held for an input of %zu\n", peak, size);
  require(false, "memory stays below its bound");
}

}  // namespace

void check_reader(std::string_view bytes, MeshFormat format, MemoryBound bound) {
  ReadResult result = ReadError{};
  std::size_t peak = 0;
  {
    const MemoryMeter meter;
    result = read_mesh(bytes, format);
    peak = meter.peak();
  }
  check_memory(peak, bytes.size(), bound);
  if (const auto* error = std::get_if<ReadError>(&result)) return check_refusal(error->message);
  check_mesh_file(std::get<MeshFile>(result), is_sampled(bytes));
}

void check_glb(std::string_view bytes, MemoryBound bound) {
  std::variant<GlbFile, ReadError> result = ReadError{};
  std::size_t peak = 0;
  {
    const MemoryMeter meter;
    result = read_glb_design(bytes);
    peak = meter.peak();
  }
  check_memory(peak, bytes.size(), bound);
  if (const auto* error = std::get_if<ReadError>(&result)) return check_refusal(error->message);
  const auto& glb = std::get<GlbFile>(result);
  const bool round_trip = is_sampled(bytes);
  check_mesh_file(glb.file, round_trip);
  if (glb.base) {
    Mesh base = glb.file.mesh;
    base.positions = *glb.base;
    require(std::holds_alternative<MeshFile>(check_mesh(std::move(base))),
            "a stored base is a mesh too");
  }
  if (!round_trip) return;
  const std::string text = write_glb(glb.file.mesh, {.base = glb.base, .design = glb.design});
  const auto again = read_glb_design(text);
  const auto* same = std::get_if<GlbFile>(&again);
  require(same != nullptr, "a written design can be read");
  require(same->design == glb.design, "the design's text comes back");
  require(same->base.has_value() == glb.base.has_value() &&
              (!glb.base || same_bits(*same->base, *glb.base)),
          "the base comes back to the same bits");
}

void check_design(std::string_view text, MemoryBound bound) {
  std::variant<Design, std::string> result;
  std::size_t peak = 0;
  {
    const MemoryMeter meter;
    result = read_design(text);
    peak = meter.peak();
  }
  check_memory(peak, text.size(), bound);
  if (const auto* sentence = std::get_if<std::string>(&result)) return check_refusal(*sentence);
  const auto& design = std::get<Design>(result);
  require(!find_problem(design), "an accepted design keeps the rules");
  const std::string written = write_design(design);
  const auto again = read_design(written);
  if (const auto* sentence = std::get_if<std::string>(&again)) {
    std::fprintf(stderr, "read again: %s\n", sentence->c_str());
  }
  require(std::holds_alternative<Design>(again), "a written design can be read");
  require(write_design(std::get<Design>(again)) == written, "a written design comes back");
}

}  // namespace planish::fuzz
