// SPDX-License-Identifier: MIT
/// Writes the seed corpus: small samples in every format and dialect, by the project's own writers.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "planish/design/design_text.hpp"
#include "planish/io/gltf.hpp"
#include "planish/io/mesh_format.hpp"
#include "planish/io/ply.hpp"
#include "planish/shapes/shapes.hpp"

namespace planish::fuzz {
namespace {

class Corpus {
 public:
  explicit Corpus(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void add(const char* format, const std::string& bytes) {
    const std::filesystem::path folder = folder_ / format;
    std::filesystem::create_directories(folder);
    std::ofstream(folder / (std::to_string(count_++) + "." + format), std::ios::binary) << bytes;
  }

 private:
  std::filesystem::path folder_;
  int count_ = 0;
};

/// JSON, NUL, binary data: what read_glb_fuzzer wraps by itself.
std::string parts_of(const std::string& glb) {
  const auto word = [&](std::size_t at) {
    std::size_t value = 0;
    for (std::size_t k = 4; k-- > 0;) value = value * 256 + static_cast<unsigned char>(glb[at + k]);
    return value;
  };
  const std::size_t json = word(12), binary = word(20 + json);
  return glb.substr(20, json) + '\0' + glb.substr(20 + json + 8, binary);
}

void add_sample(const Mesh& mesh, Corpus& corpus) {
  corpus.add("obj", write_mesh(mesh, MeshFormat::kObj));
  corpus.add("off", write_mesh(mesh, MeshFormat::kOff));
  for (const PlyEncoding encoding :
       {PlyEncoding::kAscii, PlyEncoding::kBinaryLittleEndian, PlyEncoding::kBinaryBigEndian}) {
    corpus.add("ply", write_ply(mesh, encoding));
  }
  GlbContent content;
  content.base = mesh.positions;
  content.base->row(2).array() += 0.25;
  content.design = R"({"version":1,"handles":[{"vertex":4,"target":[1,2,3.5]}]})";
  GlbVariations variations{{0, 2}, {Positions::Constant(3, 2, 0.5)}};
  content.variations = variations;
  for (const std::string& glb : {write_glb(mesh), write_glb(mesh, content)}) {
    corpus.add("glb", glb);
    corpus.add("glb", parts_of(glb));
  }
}

/// A design with everything in it, and one with as little as can be.
void add_designs(Corpus& corpus) {
  Design design;
  design.title = "caf\xC3\xA9 \"1\"\n";
  design.source = SampleSource{"vault", 8};
  corpus.add("design", write_design(design));
  design.source = FileSource{"a.obj", 0xdeadbeef, "obj", "v 0 0 0\n"};
  design.planarised = kNearestFlat;
  design.targets = {{{4, {1.0, 2.0, 3.5}}, {7, {-1e-9, 1e9, 0.1}}}, {1, 2}};
  design.variations.push_back({{.dimension = 2}, {0.5, -0.25}, true});
  design.result = DesignMark{0x12345678, 1, {{4, {1.0, 2.0, 3.5}}}};
  corpus.add("design", write_design(design));
  corpus.add("design",
             R"({"format":"planish-design","version":1,"source":{"sample":"a","size":3}})");
}

/// Dialects that our writers do not speak.
void add_dialects(Corpus& corpus) {
  corpus.add("obj",
             "# c\r\no part\r\nv 0 0 0 1 0 0\r\nv 1e0 0 0\r\nv +1 1. .5\r\nvt 0 0\r\n"
             "g a b\r\nf 1/1/1 2//2 3/3/\\\r\n\r\nusemtl x\r\ns off\r\nf -1 -2 -3\r\n");
  corpus.add("obj", "f 1 2 3 4\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 nan\n");
  corpus.add("off",
             "COFF # c\n4 2 0\n\n0 0 0 255 0 0 255\n1 0 0\n1 1 0\n0 1 0\n"
             "3 0 1 2 1 0 0\n3 0 2 3\n");
  corpus.add("obj",
             "# c\\\nv 0 0 0\nv 1 0 \\ \n 0\nv 1 1 0\no a b\\\nf 1 2\nf 1 2 \\\n3\n"
             "g a #1 # c\nf 1 1 2\n");
  corpus.add("off", "coff4 2\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1\n2\n3 0 2 3\n");
  corpus.add("off", "OFF 4 1 0 0 0 0 1 0 0 1 1 0 0 1 0 4 0 1 2 3");
  corpus.add("off", "3 1\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n");
  corpus.add("ply",
             "ply\nformat ascii 1.0\ncomment c\nobj_info o\nelement vertex 3\n"
             "property float x\nproperty float y\nproperty float z\nproperty uchar red\n"
             "element face 1\nproperty list uchar int vertex_index\n"
             "element edge 1\nproperty int vertex1\nproperty list uint float weights\n"
             "end_header\n0 0 0 9\n1 0 0 9\n0 1 0 9\n3 0 1 2\n7 2 0.5 0.5\n");
  corpus.add("ply",
             "ply\nformat ascii 1.0\nMade by hand\nelement vertex 3\nproperty float x\n"
             "property float y\nproperty float z\nelement face 1\n"
             "property list uchar int vertex_index\nend_header\n0 0 0 9\n1 0 0 9\n0 1 0\n"
             "3 0 1 2 8 8\n");
  corpus.add("glb",
             std::string(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
                         R"("nodes":[{"children":[1],"rotation":[0,0,0,1]},{"mesh":0,)"
                         R"("scale":[2,2,2],"translation":[1,0,0]}],"meshes":[{"primitives")"
                         R"(:[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":)"
                         R"(0,"componentType":5126,"count":3,"type":"VEC3","byteOffset":0}],)"
                         R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{)"
                         R"("byteLength":36}]})") +
                 '\0' +
                 std::string("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\0\0"
                             "\0\0\0\0\0\0\x80\x3f\0\0\0\0",
                             36));
}

/// Two triangles as a GLB of others has them, in the parts that read_glb_fuzzer wraps. The binary
/// data are four points, six corners, one and two points more, and one corner more.
std::string foreign_glb(const std::string& node, const std::string& primitive,
                        const std::string& document) {
  const std::vector<float> points = {0, 0, 0, 1, 0, 0, 1, 0, -1, 0, 0, -1, 0, 0.5, 0, 0, 0, 2};
  const std::vector<std::uint16_t> corners = {0, 1, 2, 0, 2, 3, 2, 0};
  std::string binary(reinterpret_cast<const char*>(points.data()), points.size() * 4);
  binary.append(reinterpret_cast<const char*>(corners.data()), corners.size() * 2);
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0)" +
         node + R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1)" +
         primitive +
         R"(}]}],"accessors":[)"
         R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
         R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"},)"
         R"({"bufferView":2,"componentType":5126,"count":2,"type":"VEC3"},)"
         R"({"bufferView":0,"componentType":5122,"count":4,"type":"VEC3","normalized":true,)"
         R"("byteOffset":0},{"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,)"
         R"("indices":{"bufferView":3,"componentType":5123},"values":{"bufferView":2}}}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":72,)"
         R"("byteLength":12},{"buffer":0,"byteOffset":48,"byteLength":24},)"
         R"({"buffer":0,"byteOffset":84,"byteLength":4}],"buffers":[{"byteLength":88}])" +
         document + "}" + '\0' + binary;
}

/// What other programs put into a GLB and our writer does not.
void add_foreign_glb(Corpus& corpus) {
  corpus.add("glb", foreign_glb(R"(,"scale":[-1,1,1])", "", ""));
  corpus.add("glb", foreign_glb(R"(,"matrix":[-1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1])", "", ""));
  corpus.add("glb", foreign_glb(R"(,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":)"
                                R"({"TRANSLATION":2}}})",
                                "", R"(,"extensionsUsed":["EXT_mesh_gpu_instancing"])"));
  for (const char* target : {"0", "4"}) {
    corpus.add("glb", foreign_glb(R"(,"weights":[0.5])",
                                  R"(,"targets":[{"POSITION":)" + std::string(target) + "}]", ""));
  }
  corpus.add("glb", foreign_glb("", R"(,"extras":{"polygonSizes":[3,3]})", ""));
  corpus.add("glb", foreign_glb("", R"(,"extras":{"polygonSizes":[4]})", ""));
  for (const char* mode : {"5", "6"}) {
    corpus.add("glb", foreign_glb("", R"(,"mode":)" + std::string(mode), ""));
  }
  corpus.add("glb", foreign_glb("", "", R"(,"extensionsRequired":["KHR_materials_unlit"])"));
  corpus.add("glb", foreign_glb("", "", R"(,"extensionsRequired":["KHR_mesh_quantization"])"));
  corpus.add("glb", foreign_glb("", "", R"(,"skins":[{"joints":[0]}])"));
  std::string quantized = foreign_glb("", "", R"(,"extensionsRequired":["KHR_mesh_quantization"])");
  const std::string position = R"("POSITION":0)";
  quantized.replace(quantized.find(position), position.size(), R"("POSITION":3)");
  corpus.add("glb", quantized);
  corpus.add("glb",
             R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":)"
             R"([{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
             R"("componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,)"
             R"("byteLength":36}],"buffers":[{"byteLength":36,"uri":)"
             R"("data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8)"
             R"(AAAAA"}]})");
}

}  // namespace
}  // namespace planish::fuzz

int main(int count, char** arguments) {
  using namespace planish;
  if (count != 2) return std::fputs("usage: fuzz_seeds FOLDER\n", stderr), 2;
  fuzz::Corpus corpus(arguments[1]);
  for (const std::string_view name : sample_names()) {
    Mesh mesh = make_sample(name, 3).value();
    mesh.groups = {{"roof", 0}, {"caf\xC3\xA9 <b>", mesh.face_count() - 1}};
    if (mesh.face_count() < 2) mesh.groups.pop_back();
    fuzz::add_sample(mesh, corpus);
  }
  fuzz::add_dialects(corpus);
  fuzz::add_foreign_glb(corpus);
  fuzz::add_designs(corpus);
  return 0;
}
