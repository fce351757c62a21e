// SPDX-License-Identifier: MIT
#include "io/gltf_accessors.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <type_traits>

#include "text/sentence.hpp"

namespace planish {
namespace {

/// The bytes of an accessor: element k starts at data + k · stride.
struct ElementView {
  const unsigned char* data = nullptr;
  std::size_t stride = 0, count = 0;
};

/// Where elements are said to be.
struct Place {
  int view = -1;
  std::uint64_t offset = 0, count = 0, element_size = 0;
};

/// Checks that all elements lie inside their view and the view inside the buffer, in 64 bits: every
/// sum below stays far from overflow because each term is compared first.
ElementView view_of(const tinygltf::Model& model, const Place& place, const std::string& name) {
  const auto& view = element_of(model.bufferViews, place.view, "buffer view");
  const auto& buffer = element_of(model.buffers, view.buffer, "buffer");
  const std::uint64_t size = buffer.data.size(), start = view.byteOffset, length = view.byteLength;
  const std::uint64_t offset = place.offset, count = place.count, element = place.element_size;
  const std::uint64_t stride = view.byteStride == 0 ? element : view.byteStride;
  const bool view_fits = start <= size && length <= size - start && offset <= length;
  const bool fits = view_fits && count >= 1 && stride >= element && count <= size &&
                    stride <= size && element <= length - offset &&
                    (count - 1) * stride <= length - offset - element;
  if (!fits) throw ReadError{name + " reaches outside of the file's data"};
  return {buffer.data.data() + start + offset, static_cast<std::size_t>(stride),
          static_cast<std::size_t>(count)};
}

std::string name_of(int index) { return "accessor " + std::to_string(index); }

/// A component as a number; one of a whole type from −1 or 0 to 1 if it is normalized.
template <class T>
double component_at(const unsigned char* bytes, bool normalized) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  if constexpr (std::is_integral_v<T>) {
    if (normalized) {
      return std::max(static_cast<double>(value) / std::numeric_limits<T>::max(), -1.0);
    }
  }
  return static_cast<double>(value);
}

/// How a component is read, and its bytes.
struct Component {
  double (*read)(const unsigned char*, bool) = nullptr;
  std::uint64_t size = 0;
};

Component component_of(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return {component_at<float>, 4};
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return {component_at<std::int8_t>, 1};
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return {component_at<std::uint8_t>, 1};
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return {component_at<std::int16_t>, 2};
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return {component_at<std::uint16_t>, 2};
    default:
      return {};
  }
}

/// Columns of `vectors` that `columns` names, or all in order, from the elements.
void fill(const ElementView& view, const Component& component, bool normalized,
          const std::vector<int>* columns, Eigen::MatrixXd& vectors) {
  for (std::size_t k = 0; k < view.count; ++k) {
    const auto column =
        columns ? static_cast<Eigen::Index>((*columns)[k]) : static_cast<Eigen::Index>(k);
    for (Eigen::Index c = 0; c < vectors.rows(); ++c) {
      const auto at =
          static_cast<std::size_t>(k * view.stride) + static_cast<std::size_t>(c) * component.size;
      vectors(c, column) = component.read(view.data + at, normalized);
    }
  }
}

std::size_t index_size(int component) {
  if (component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return 1;
  if (component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return 2;
  if (component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) return 4;
  throw ReadError{"a list of indices has a type that glTF does not allow"};
}

std::uint32_t index_at(const ElementView& view, std::size_t k, std::size_t size) {
  std::uint32_t value = 0;
  std::memcpy(&value, view.data + k * view.stride, size);
  return value;
}

/// Negative offsets are no places.
std::uint64_t offset_of(int offset) {
  return offset < 0 ? std::numeric_limits<std::uint64_t>::max()
                    : static_cast<std::uint64_t>(offset);
}

/// The columns that a sparse accessor gives in place of those of its view.
void fill_sparse(const tinygltf::Model& model, int index, const Component& component,
                 Eigen::MatrixXd& vectors) {
  const tinygltf::Accessor& accessor = element_of(model.accessors, index, "accessor");
  const auto& sparse = accessor.sparse;
  if (sparse.count <= 0) return;
  const auto count = static_cast<std::uint64_t>(sparse.count);
  const std::size_t size = index_size(sparse.indices.componentType);
  const ElementView indices =
      view_of(model, {sparse.indices.bufferView, offset_of(sparse.indices.byteOffset), count, size},
              name_of(index));
  const std::uint64_t element = component.size * static_cast<std::uint64_t>(vectors.rows());
  const ElementView values = view_of(
      model, {sparse.values.bufferView, offset_of(sparse.values.byteOffset), count, element},
      name_of(index));
  std::vector<int> columns;
  for (std::size_t k = 0; k < indices.count; ++k) {
    const std::uint32_t column = index_at(indices, k, size);
    if (column >= static_cast<std::uint64_t>(vectors.cols())) {
      throw ReadError{name_of(index) + " reaches outside of the file's data"};
    }
    columns.push_back(static_cast<int>(column));
  }
  fill(values, component, accessor.normalized, &columns, vectors);
}

}  // namespace

Eigen::MatrixXd read_vectors(const tinygltf::Model& model, int index, int width) {
  const tinygltf::Accessor& accessor = element_of(model.accessors, index, "accessor");
  const Component component = component_of(accessor.componentType);
  if (!component.read || accessor.type != (width == 3 ? TINYGLTF_TYPE_VEC3 : TINYGLTF_TYPE_VEC4)) {
    throw ReadError{name_of(index) + " should hold points of " + std::to_string(width) + " floats"};
  }
  const bool has_view = !accessor.sparse.isSparse || accessor.bufferView >= 0;
  const std::uint64_t count = accessor.count;
  if (!has_view) {  // zeros: nothing in the file speaks for their number
    std::uint64_t bytes = 0;
    for (const tinygltf::Buffer& buffer : model.buffers) bytes += buffer.data.size();
    if (count > bytes) throw ReadError{name_of(index) + " reaches outside of the file's data"};
  }
  const std::uint64_t element = component.size * static_cast<std::uint64_t>(width);
  ElementView view;
  if (has_view) {
    view =
        view_of(model, {accessor.bufferView, accessor.byteOffset, count, element}, name_of(index));
  }
  Eigen::MatrixXd vectors = Eigen::MatrixXd::Zero(width, static_cast<Eigen::Index>(count));
  fill(view, component, accessor.normalized, nullptr, vectors);
  if (accessor.sparse.isSparse) fill_sparse(model, index, component, vectors);
  return vectors;
}

std::vector<int> read_indices(const tinygltf::Model& model, int index, Eigen::Index vertex_count) {
  std::vector<int> indices;
  if (index < 0) {
    indices.resize(static_cast<std::size_t>(vertex_count));
    std::iota(indices.begin(), indices.end(), 0);
  } else {
    const tinygltf::Accessor& accessor = element_of(model.accessors, index, "accessor");
    if (accessor.sparse.isSparse) {
      throw ReadError{name_of(index) + " is sparse, which is not supported for indices"};
    }
    const std::size_t size = index_size(accessor.componentType);
    const ElementView view = view_of(
        model, {accessor.bufferView, accessor.byteOffset, accessor.count, size}, name_of(index));
    indices.reserve(view.count);
    for (std::size_t k = 0; k < view.count; ++k) {
      const std::uint32_t value = index_at(view, k, size);
      if (value >= static_cast<std::uint64_t>(vertex_count)) {
        throw ReadError{"triangle " + std::to_string(k / 3) + " uses vertex " +
                        std::to_string(value) + ", but the mesh has " +
                        count_text(static_cast<std::size_t>(vertex_count), "vertex", "vertices")};
      }
      indices.push_back(static_cast<int>(value));
    }
  }
  if (indices.size() % 3 != 0)
    throw ReadError{"the number of triangle corners is not a multiple of 3"};
  return indices;
}

}  // namespace planish
