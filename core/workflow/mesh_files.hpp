// SPDX-License-Identifier: MIT
/// Meshes in from files, results out to them; "-" is standard input or output.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "planish/design/design.hpp"
#include "planish/io/gltf.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/mesh/read_result.hpp"

namespace planish::workflow {

/// The mesh in `path`, or the sample that "sample:NAME:SIZE" names, checked. Throws RequestError.
[[nodiscard]] MeshFile open_mesh(const std::string& path);

/// The file `path` as messages call it.
[[nodiscard]] std::string shown_name(const std::string& path);

/// The last part of `path`.
[[nodiscard]] std::string file_name_of(const std::string& path);

/// The extension in small letters, without its point; "" if the name has none.
[[nodiscard]] std::string extension_of(const std::string& path);

/// A mesh together with what a design must keep to find it again.
struct LoadedSource {
  Mesh mesh;
  DesignSource source;
  std::vector<std::string> warnings;  ///< of the reader
};

/// Opens a mesh as open_mesh() does, for a design. The hash of a FileSource is left to whoever
/// knows the flat base.
[[nodiscard]] LoadedSource open_source(const std::string& path);

/// The source of a design from the bytes of a file. @param name with the extension of its format
[[nodiscard]] LoadedSource source_of_bytes(const std::string& name, std::string bytes);

/// The bytes of `path`. Throws RequestError.
[[nodiscard]] std::string load_bytes(const std::string& path);

/// Throws RequestError unless `path` is "-" or has the extension of a mesh format. Commands call
/// it before the work, so that a typing error does not cost a solve.
void check_output_name(const std::string& path);

/// `mesh` in the format of `name`'s extension; `content` is used by GLB only.
[[nodiscard]] std::string mesh_bytes(const std::string& name, const Mesh& mesh,
                                     const GlbContent& content = {});

/// `base` with its points at `positions`, in the format of `name`'s extension; a GLB holds both.
[[nodiscard]] std::string moved_mesh_bytes(const std::string& name, const Mesh& base,
                                           const Positions& positions, GlbContent content = {});

/// Writes `bytes` so that `path` holds either all of them or what it held before.
void save_bytes(const std::string& path, std::string_view bytes);

}  // namespace planish::workflow
