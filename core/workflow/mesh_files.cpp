// SPDX-License-Identifier: MIT
#include "mesh_files.hpp"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include "planish/io/mesh_format.hpp"
#include "planish/shapes/shapes.hpp"
#include "planish/text/utf8.hpp"
#include "request.hpp"

namespace planish::workflow {

std::string shown_name(const std::string& path) { return path == "-" ? "standard input" : path; }

namespace {

namespace fs = std::filesystem;

MeshFormat format_of(const std::string& path) {
  if (path == "-") return MeshFormat::kObj;
  if (const auto format = format_from_name(path)) return *format;
  const bool design = path.ends_with(".json");
  throw UsageError(path + ": the extension must be " + all_extensions() +
                   (design ? "; planish replay opens designs" : ""));
}

constexpr std::string_view kSamplePrefix = "sample:";

/// "sample:vault:32"; nullopt for any other path.
std::optional<SampleSource> sample_in(const std::string& path) {
  if (path.rfind(kSamplePrefix, 0) != 0) return std::nullopt;
  const std::size_t colon = path.rfind(':');
  if (colon < kSamplePrefix.size()) {
    throw UsageError(path + ": a sample is written sample:NAME:SIZE");
  }
  return SampleSource{path.substr(kSamplePrefix.size(), colon - kSamplePrefix.size()),
                      parse_whole(path.substr(colon + 1), "the size of the sample")};
}

MeshFile make_sample_file(const SampleSource& sample) {
  if (auto mesh = make_sample(sample.name, sample.size)) return {std::move(*mesh), {}};
  throw UsageError("there is no sample \"" + sample.name + "\" of size " +
                   std::to_string(sample.size));
}

MeshFile read_file(const std::string& path, std::string_view bytes) {
  ReadResult result = read_mesh(bytes, format_of(path));
  if (const auto* error = std::get_if<ReadError>(&result)) {
    throw MeshError(shown_name(path) + ": " + error->message);
  }
  return std::move(std::get<MeshFile>(result));
}

/// A GLB may hold a design of its own, so what was read from it is kept as OBJ.
FileSource file_source(const std::string& path, const Mesh& mesh, std::string bytes) {
  const MeshFormat format = format_of(path);
  FileSource source;
  source.name = path == "-" ? "mesh.obj" : as_utf8(fs::path(path).filename().string());
  const bool glb = format == MeshFormat::kGlb;
  source.format = planish::extension_of(glb ? MeshFormat::kObj : format);
  source.bytes = glb ? write_mesh(mesh, MeshFormat::kObj) : std::move(bytes);
  return source;
}

}  // namespace

std::string file_name_of(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

std::string extension_of(const std::string& path) {
  const std::string name = file_name_of(path);
  const std::size_t point = name.find_last_of('.');
  std::string extension = point == std::string::npos ? "" : name.substr(point + 1);
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

std::string load_bytes(const std::string& path) {
  if (path == "-") return {std::istreambuf_iterator<char>(std::cin), {}};
  std::error_code error;
  if (fs::is_directory(path, error)) throw MeshError(path + ": is a directory");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw MeshError(path + ": cannot be opened");
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) throw MeshError(path + ": cannot be read");
  return bytes;
}

namespace {

/// True if all bytes reached the file.
bool write_directly(const fs::path& path, std::string_view bytes) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return !file.fail();
}

/// Writes beside `path`, then renames. A link is followed, so that it stays one.
bool write_and_rename(fs::path path, std::string_view bytes) {
  std::error_code error;
  const bool exists = fs::exists(path, error);
  if (exists) path = fs::canonical(path, error);
  if (error) return false;
  fs::path temporary = path;
  temporary += ".planish-" + std::to_string(getpid());
  bool done = write_directly(temporary, bytes);
  if (done && exists) fs::permissions(temporary, fs::status(path).permissions(), error);
  if (done) fs::rename(temporary, path, error);
  done = done && !error;
  if (!done) fs::remove(temporary, error);
  return done;
}

}  // namespace

MeshFile open_mesh(const std::string& path) {
  if (const auto sample = sample_in(path)) return make_sample_file(*sample);
  static_cast<void>(format_of(path));
  return read_file(path, load_bytes(path));
}

LoadedSource open_source(const std::string& path) {
  if (const auto sample = sample_in(path)) return {make_sample_file(*sample).mesh, *sample, {}};
  static_cast<void>(format_of(path));
  return source_of_bytes(path, load_bytes(path));
}

LoadedSource source_of_bytes(const std::string& name, std::string bytes) {
  MeshFile file = read_file(name, bytes);
  FileSource source = file_source(name, file.mesh, std::move(bytes));
  return {std::move(file.mesh), std::move(source), std::move(file.warnings)};
}

void check_output_name(const std::string& path) { static_cast<void>(format_of(path)); }

std::string mesh_bytes(const std::string& name, const Mesh& mesh, const GlbContent& content) {
  const MeshFormat format = format_of(name);
  return format == MeshFormat::kGlb ? write_glb(mesh, content) : write_mesh(mesh, format);
}

std::string moved_mesh_bytes(const std::string& name, const Mesh& base, const Positions& positions,
                             GlbContent content) {
  Mesh moved = base;
  moved.positions = positions;
  content.base = base.positions;
  return mesh_bytes(name, moved, content);
}

void save_bytes(const std::string& path, std::string_view bytes) {
  if (path == "-") {
    std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
    if (!std::cout) throw MeshError("standard output cannot be written");
    return;
  }
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  // A device or a pipe must be written itself: a rename would put a file in its place.
  const bool special = fs::exists(status) && !fs::is_regular_file(status);
  const bool done = special ? write_directly(path, bytes) : write_and_rename(path, bytes);
  if (!done) throw MeshError(path + ": cannot be written");
}

}  // namespace planish::workflow
