// SPDX-License-Identifier: MIT
// DEFLATE by stb_image_write (public domain or MIT): one header that both builds compile, so that
// the page and the command line write the same bytes. See docs/decisions/0014-cutting-package.md.
#include <cstdlib>
#include <limits>
#include <new>
#include <stdexcept>

#include "planish/io/zip.hpp"

#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace planish {

std::string deflate_raw(std::string_view bytes) {
  constexpr int kQuality = 5;     // the quickest; higher ones gain a few percent
  constexpr int kZlibHeader = 2;  // around the raw stream
  constexpr int kZlibTrailer = 4;
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::length_error("deflate_raw: 2 GiB or more");
  }
  if (bytes.empty()) return {"\x03\0", 2};  // for which the library writes no block at all
  std::string input(bytes);  // the library takes bytes that it might write, and does not
  int length = 0;
  unsigned char* zlib = stbi_zlib_compress(reinterpret_cast<unsigned char*>(input.data()),
                                           static_cast<int>(input.size()), &length, kQuality);
  if (zlib == nullptr) throw std::bad_alloc();
  std::string raw(reinterpret_cast<const char*>(zlib) + kZlibHeader,
                  static_cast<std::size_t>(length - kZlibHeader - kZlibTrailer));
  std::free(zlib);  // NOLINT(cppcoreguidelines-no-malloc): allocated by the library
  return raw;
}

}  // namespace planish
