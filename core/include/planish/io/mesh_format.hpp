// SPDX-License-Identifier: MIT
/// The mesh formats behind one door, chosen by the file's name. The table is all that knows which
/// there are: a new one is a row.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "planish/io/obj.hpp"
#include "planish/io/off.hpp"
#include "planish/io/ply.hpp"
#include "planish/mesh/mesh.hpp"
#include "planish/mesh/read_result.hpp"

namespace planish {

/// How a format is called and what it is read and written by.
struct MeshFormatRow {
  std::string_view extension;  ///< of its files, lower case; its name in designs
  std::string_view media;      ///< the media type of its files
  ReadResult (*read)(std::string_view bytes);
  std::string (*write)(const Mesh& mesh);
};

/// All but GLB, which needs a library: they are what the page's solver reads and writes itself.
inline constexpr std::array kPlainFormats = {
    MeshFormatRow{"obj", "model/obj", read_obj, write_obj},
    MeshFormatRow{"off", "text/plain", read_off, write_off},
    MeshFormatRow{"ply", "application/octet-stream", read_ply,
                  [](const Mesh& mesh) { return write_ply(mesh); }},
};

/// What else there is to say of GLB is behind read_mesh() and write_mesh().
inline constexpr std::string_view kGlbName = "glb", kGlbMedia = "model/gltf-binary";

/// GLB, then the rows of kPlainFormats. Those that code names; the table may have more after them.
enum class MeshFormat : std::uint8_t { kGlb, kObj, kOff, kPly };
static_assert(kPlainFormats[0].extension == "obj" && kPlainFormats[1].extension == "off" &&
                  kPlainFormats[2].extension == "ply",
              "MeshFormat names rows by their place: new ones go behind");

/// The format by its extension, in any case; nullopt for any other name.
[[nodiscard]] std::optional<MeshFormat> format_from_name(std::string_view name);

/// As MeshFormatRow::extension has it.
[[nodiscard]] std::string_view extension_of(MeshFormat format);

/// All extensions for a sentence, ".obj, .off, .ply or .glb".
/// @param point what each begins with; @param last what the last is preceded by
[[nodiscard]] std::string all_extensions(std::string_view point = ".",
                                         std::string_view between = ", ",
                                         std::string_view last = " or ");

/// By the format's own reader.
[[nodiscard]] ReadResult read_mesh(std::string_view bytes, MeshFormat format);

/// By the format's own writer; PLY is little-endian binary.
[[nodiscard]] std::string write_mesh(const Mesh& mesh, MeshFormat format);

}  // namespace planish
