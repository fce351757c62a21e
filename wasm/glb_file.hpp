// SPDX-License-Identifier: MIT
/// GLB for the page, in a module of its own that is loaded when a GLB is opened or exported: its
/// library is a third of the rest. Meshes pass between the two modules as OBJ, which keeps every
/// bit. Plain C++, tested natively.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "planish/io/gltf.hpp"

namespace planish {

/// A GLB as the session takes it.
struct OpenedGlb {
  std::string mesh;    ///< OBJ: the base if the file holds a design, else the mesh
  std::string design;  ///< the recipe as text; "" for none
  /// With a design: the stored result, where it differs from the base.
  std::vector<int> moved;                 ///< ascending
  Positions positions = Positions(3, 0);  ///< 3 × |moved|, model units
  std::vector<std::string> warnings;
};

/// The sentence says what is wrong with the file.
[[nodiscard]] std::variant<OpenedGlb, std::string> open_glb(std::string_view bytes);

/// @param mesh OBJ of the design shown; @param content as for write_glb()
/// @return the file, or "" if `mesh` cannot be read or does not fit `content`
[[nodiscard]] std::string assemble_glb(std::string_view mesh, const GlbContent& content);

/// @param mesh OBJ
/// @param way joinTriangles: into quads; orient: panels are turned until neighbours agree;
/// joinPoints: those that its panels have of their own
/// @return OBJ, or "" if `mesh` cannot be read or joining points gives no mesh
[[nodiscard]] std::string mended(std::string_view mesh, std::string_view way);

}  // namespace planish
