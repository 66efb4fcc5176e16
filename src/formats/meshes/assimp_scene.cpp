#include "formats/meshes/assimp_scene.h"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cstdint>
#include <new>

#include "base/error.h"
#include "geometry/polygon.h"

namespace resect {
namespace {

constexpr int kDeepestNode = 500;

// The library's view of the disk.
class MemoryDisk : public Assimp::IOSystem {
 public:
  explicit MemoryDisk(const AssimpInput& input) : input_(input) {}

  bool Exists(const char* name) const override { return find(name).data() != nullptr; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char*) override {
    const std::string_view bytes = find(name);
    if (!bytes.data()) return nullptr;
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                      bytes.size());
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::string_view find(const std::string& name) const {
    if (name == input_.name) return input_.bytes;
    return input_.beside ? input_.beside(name) : std::string_view();
  }

  const AssimpInput& input_;
};

// The library's message on one line, without the name that the model has there.
std::string oneLine(std::string text) {
  const std::string unknown = "No suitable reader found";
  if (text.starts_with(unknown)) return "it does not begin as such a file does";
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  constexpr std::size_t kLongest = 200;
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text.empty() ? "no reason given" : text;
}

TriangleMesh meshOf(const aiMesh& source, const aiMatrix4x4& transform, const std::string& path) {
  TriangleMesh mesh;
  mesh.points.reserve(source.mNumVertices);
  for (unsigned i = 0; i < source.mNumVertices; ++i) {
    const aiVector3D& p = source.mVertices[i];
    const Vec3 q(p.x, p.y, p.z);
    const auto row = [&](const ai_real* m) {
      return double(m[0]) * q.x() + double(m[1]) * q.y() + double(m[2]) * q.z() + double(m[3]);
    };
    mesh.points.emplace_back(row(transform[0]), row(transform[1]), row(transform[2]));
  }
  std::vector<std::int32_t> loop;
  for (unsigned f = 0; f < source.mNumFaces; ++f) {
    const aiFace& face = source.mFaces[f];
    if (face.mNumIndices < 3) continue;
    loop.clear();
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      if (face.mIndices[i] >= source.mNumVertices)
        throw error("{}: face {} uses point {} of only {}; export the model again", path, f,
                    face.mIndices[i], source.mNumVertices);
      loop.push_back(std::int32_t(face.mIndices[i]));
    }
    triangulatePolygon(mesh.points, loop, mesh.triangles);
  }
  // A mirroring transform reverses the triangles; flip them back, as glTF 2.0 (3.5.3) requires.
  if (transform.Determinant() < 0) flip(mesh);
  return mesh;
}

// The name of the node, or else of its mesh. The library itself calls what has no name "nodes[3]".
std::string nameOf(const aiNode& node, const aiMesh& mesh) {
  const std::string ofNode = node.mName.C_Str(), ofMesh = mesh.mName.C_Str();
  const bool nodeIsNamed = !ofNode.empty() && !ofNode.starts_with("nodes[");
  const bool meshIsNamed = !ofMesh.empty() && !ofMesh.starts_with("meshes[");
  return nodeIsNamed || !meshIsNamed ? ofNode : ofMesh;
}

void collect(const aiScene& scene, const aiNode& node, const aiMatrix4x4& above, int depth,
             Model& model) {
  if (depth > kDeepestNode)
    throw error("{}: its nodes are nested more than {} deep; flatten the model", model.path,
                kDeepestNode);
  const aiMatrix4x4 transform = above * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    if (node.mMeshes[i] >= scene.mNumMeshes)
      throw error("{}: a node uses mesh {} of only {}; export the model again", model.path,
                  node.mMeshes[i], scene.mNumMeshes);
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
    const std::string name = nameOf(node, mesh);
    addToPart(model, name, meshOf(mesh, transform, model.path));
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    collect(scene, *node.mChildren[i], transform, depth + 1, model);
}

}  // namespace

std::optional<std::string> readByAssimp(const AssimpInput& input, Model& model) {
  Assimp::Importer importer;
  // Everything but surfaces is skipped, so that no texture or animation can do harm.
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                              aiComponent_ANIMATIONS | aiComponent_TEXTURES | aiComponent_LIGHTS |
                                  aiComponent_CAMERAS | aiComponent_NORMALS |
                                  aiComponent_TEXCOORDS | aiComponent_COLORS);
  importer.SetIOHandler(new MemoryDisk(input));  // which the importer owns
  const aiScene* scene = importer.ReadFile(input.name, aiProcess_RemoveComponent);
  if (importer.GetErrorString() == std::string("std::bad_alloc")) throw std::bad_alloc();
  if (!scene || !scene->mRootNode) return oneLine(importer.GetErrorString());
  collect(*scene, *scene->mRootNode, aiMatrix4x4(), 0, model);
  return {};
}

}  // namespace resect
