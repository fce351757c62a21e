// SPDX-License-Identifier: MIT
#include "io/text_rows.hpp"

#include "planish/text/number.hpp"

namespace planish {

void append_text_rows(const Mesh& mesh, std::string& text) {
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    for (int c = 0; c < 3; ++c) {
      append_exact(text, mesh.positions(c, v));
      text += c < 2 ? ' ' : '\n';
    }
  }
  for (int f = 0; f < mesh.face_count(); ++f) {
    append_integer(text, static_cast<long long>(mesh.face(f).size()));
    for (const int v : mesh.face(f)) {
      text += ' ';
      append_integer(text, v);
    }
    text += '\n';
  }
}

}  // namespace planish
