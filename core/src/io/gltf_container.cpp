// SPDX-License-Identifier: MIT
#include "io/gltf_container.hpp"

#include <cstdint>
#include <cstring>
#include <exception>
#include <nlohmann/json.hpp>

#include "io/base64.hpp"
#include "io/json_depth.hpp"
#include "io/text_lines.hpp"
#include "text/sentence.hpp"

namespace planish {
namespace {

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

constexpr std::size_t kHeader = 12, kChunkHeader = 8;

/// What is wrong with the lengths and marks, or "". tinygltf 2.7 forgets the 8 bytes of the second
/// chunk's header when it compares lengths, so all are compared here.
std::string refuse_container(std::string_view bytes) {
  constexpr std::uint32_t kJson = 0x4E4F534A;
  if (bytes.substr(0, 4) != "glTF") return "this is not a GLB file: it does not start with glTF";
  if (bytes.size() < kHeader + kChunkHeader) return "the GLB file ends in its header";
  if (word_at(bytes, 4) != 2) return "only version 2 of GLB can be read";
  if (word_at(bytes, 8) > bytes.size()) return "the GLB file ends early";
  const std::uint64_t length = word_at(bytes, 8), json = word_at(bytes, 12);
  if (word_at(bytes, 16) != kJson) return "the GLB file does not start with its JSON";
  if (kHeader + kChunkHeader + json > length) return "the GLB file ends in its JSON";
  const std::uint64_t second = kHeader + kChunkHeader + json;
  if (second < length) {
    if (second + kChunkHeader > length) return "the GLB file ends in a chunk header";
    const std::uint64_t binary = word_at(bytes, static_cast<std::size_t>(second));
    if (second + kChunkHeader + binary > length) return "the GLB file ends in its binary data";
  }
  return "";
}

/// Extensions that say nothing about where panels are, and those that are read here.
bool is_supported(const std::string& extension) {
  for (const char* known :
       {"KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "MSFT_texture_dds", "FB_ngon_encoding",
        "KHR_techniques_webgl", "MSFT_packing_normalRoughnessMetallic",
        "MSFT_packing_occlusionRoughnessMetallic", "EXT_mesh_features", "EXT_structural_metadata",
        "EXT_feature_metadata", "EXT_mesh_manifold", "KHR_animation_pointer"}) {
    if (extension == known) return true;
  }
  for (const char* start : {"KHR_materials_", "EXT_materials_", "KHR_texture_", "EXT_texture_",
                            "KHR_lights_", "EXT_lights_", "KHR_xmp", "KHR_audio", "EXT_audio",
                            "ADOBE_materials_", "AGI_stk_metadata"}) {
    if (extension.starts_with(start)) return true;
  }
  return false;
}

std::string refuse_extensions(const nlohmann::json& document) {
  if (!document.contains("extensionsRequired")) return "";
  const nlohmann::json& required = document["extensionsRequired"];
  if (!required.is_array()) return "";
  for (const nlohmann::json& extension : required) {
    const std::string name = extension.is_string() ? extension.get<std::string>() : "?";
    if (is_supported(name)) continue;
    return "the GLB file requires the extension " + printable(name, 64) +
           ", which is not supported";
  }
  return "";
}

/// Several buffers would each copy the binary chunk; other files cannot be reached.
std::string refuse_document(const nlohmann::json& document) {
  if (!document.is_object()) return "the GLB file's JSON is damaged";
  if (!document.contains("buffers")) return "the GLB file holds no mesh";
  const nlohmann::json& buffers = document["buffers"];
  if (!buffers.is_array() || buffers.empty() || !buffers[0].is_object()) {
    return "the GLB file holds no data";
  }
  if (buffers.size() != 1) return "the GLB file holds its data in several buffers; it can have one";
  if (buffers[0].contains("uri")) {
    const nlohmann::json& uri = buffers[0]["uri"];
    if (!uri.is_string() || !uri.get_ref<const std::string&>().starts_with("data:")) {
      return "the GLB file refers to data outside of itself";
    }
  }
  return refuse_extensions(document);
}

/// The bytes of a buffer that stands in the JSON as a data URI; nullopt unless it is base64.
std::optional<std::string> data_of(const std::string& uri) {
  constexpr std::string_view kMark = ";base64,";
  const std::size_t mark = uri.substr(0, uri.find(',') + 1).rfind(kMark);
  if (mark == std::string::npos) return std::nullopt;
  return decode_base64(std::string_view(uri).substr(mark + kMark.size()));
}

/// The binary chunks of the file, or one of the data in its JSON, which is taken out there; nullopt
/// if that is no base64.
std::optional<std::string> take_chunks(nlohmann::json& document, std::string_view bytes) {
  const std::size_t end = kHeader + kChunkHeader + word_at(bytes, kHeader);
  if (!document["buffers"][0].contains("uri")) {
    return std::string(bytes.substr(end, word_at(bytes, 8) - end));
  }
  std::optional<std::string> data =
      data_of(document["buffers"][0]["uri"].get_ref<const std::string&>());
  if (!data) return std::nullopt;
  document["buffers"][0].erase("uri");
  data->resize((data->size() + 3) / 4 * 4, '\0');
  const auto length = static_cast<std::uint32_t>(data->size());
  std::string chunk(sizeof length, '\0');
  std::memcpy(chunk.data(), &length, sizeof length);
  return chunk + std::string("BIN\0", 4) + *data;
}

/// The file with nothing but its geometry: tinygltf takes up to 2 KiB for an empty material that is
/// 3 bytes in the file, and needs no code of ours for what is not read.
std::string geometry_only(const nlohmann::json& document, std::string_view bytes,
                          std::string_view chunks) {
  nlohmann::json kept = nlohmann::json::object();
  for (const char* key :
       {"asset", "scene", "scenes", "nodes", "meshes", "accessors", "bufferViews", "buffers"}) {
    if (document.contains(key)) kept[key] = document[key];
  }
  std::string json = kept.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string file(bytes.substr(0, kHeader + kChunkHeader));
  const auto length = static_cast<std::uint32_t>(file.size() + json.size() + chunks.size());
  const auto json_length = static_cast<std::uint32_t>(json.size());
  std::memcpy(file.data() + 8, &length, sizeof length);
  std::memcpy(file.data() + kHeader, &json_length, sizeof json_length);
  file += json;
  return file += chunks;
}

/// Textures mean nothing for a mesh, so no image is decoded.
bool ignore_image(tinygltf::Image*, const int, std::string*, std::string*, int, int,
                  const unsigned char*, int, void*) {
  return true;
}

/// What tinygltf says may quote the file: names of any length and any bytes.
std::string first_line(const std::string& text) {
  constexpr std::size_t kLongest = 160;
  const std::string_view line = trimmed(std::string_view(text).substr(0, text.find('\n')));
  return line.empty() ? "unknown error" : printable(line, kLongest);
}

}  // namespace

std::variant<tinygltf::Model, std::string> load_glb_model(std::string_view bytes) {
  if (Refusal refusal = refuse_size(bytes)) return *refusal;
  if (std::string problem = refuse_container(bytes); !problem.empty()) return problem;
  const std::string_view json = bytes.substr(kHeader + kChunkHeader, word_at(bytes, kHeader));
  constexpr int kDeepest = 64;
  if (is_json_deeper_than(json, kDeepest)) return "the GLB file's JSON is nested too deeply";
  std::string file;
  {
    nlohmann::json document = nlohmann::json::parse(json, nullptr, false);
    if (std::string problem = refuse_document(document); !problem.empty()) return problem;
    const std::optional<std::string> chunks = take_chunks(document, bytes);
    if (!chunks) return "the GLB file holds its data as text that is not base64";
    file = geometry_only(document, bytes, *chunks);
  }
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(ignore_image, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  try {
    const auto* data = reinterpret_cast<const unsigned char*>(file.data());
    if (loader.LoadBinaryFromMemory(&model, &error, &warning, data,
                                    static_cast<unsigned int>(file.size()))) {
      return model;
    }
  } catch (const std::exception& exception) {
    error = exception.what();
  }
  return "the GLB file is damaged: " + first_line(error);
}

}  // namespace planish
