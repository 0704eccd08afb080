// SPDX-License-Identifier: GPL-3.0-or-later
#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <map>
#include <new>
#include <set>

#include "palpate/authoring/read_mesh_child/confine.h"
#include "palpate/authoring/read_mesh_child/foreign_formats.h"
#include "palpate/authoring/read_mesh_child/gltf_head.h"
#include "palpate/authoring/read_mesh_child/print_unit.h"
#include "palpate/authoring/read_mesh_child/private/paint_mesh.h"

namespace palpate::authoring {
namespace {

// deeper scenes do not come from people; the walk below is recursive
constexpr int kDeepestNode = 500;

/// The files that assimp may open on behalf of a mesh file: those that its folder holds.
class FolderFiles : public Assimp::DefaultIOSystem {
 public:
  explicit FolderFiles(const std::string& mesh) : folder_(mesh) {}

  bool Exists(const char* reference) const override {
    const std::string file = find_name(reference);
    return folder_.holds(file) && DefaultIOSystem::Exists(file.c_str());
  }

  Assimp::IOStream* Open(const char* reference, const char* mode) override {
    const std::string name = find_name(reference);
    const char* const file = name.c_str();
    if (folder_.holds(file)) return DefaultIOSystem::Open(file, mode);
    std::error_code nothing_there;
    if (std::filesystem::exists(file, nothing_there)) outside_.insert(file);
    return nullptr;
  }

  const std::set<std::string>& outside() const { return outside_; }  ///< asked for and not opened

 private:
  /// A file of that very name, or else of the one that it stands for in glTF.
  static std::string find_name(const char* reference) {
    std::error_code nothing_there;
    return std::filesystem::exists(reference, nothing_there) ? reference
                                                             : decode_reference(reference);
  }

  MeshFolder folder_;
  std::set<std::string> outside_;
};

/// The node's matrix in double: a chain of floats would move shared borders apart.
Eigen::Matrix4d to_matrix(const aiMatrix4x4& m) {
  Eigen::Matrix4d matrix;
  for (unsigned i = 0; i < 4; ++i) {
    for (unsigned j = 0; j < 4; ++j) matrix(i, j) = m[i][j];
  }
  return matrix;
}

/// Adds a mesh as the scene shows it; whether its node mirrors, which would turn the triangles
/// inside out: they are turned back.
bool append(const aiMesh& from, const Eigen::Matrix4d& place, SurfaceMesh& to) {
  const Mat3 linear = place.topLeftCorner<3, 3>();
  const Vec3 shift = place.topRightCorner<3, 1>();
  const bool mirrors = linear.determinant() < 0.0;
  const int first = static_cast<int>(to.vertices.size());
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    const aiVector3D& p = from.mVertices[i];
    to.vertices.push_back(linear * Vec3(p.x, p.y, p.z) + shift);
  }
  for (unsigned f = 0; f < from.mNumFaces; ++f) {
    const aiFace& face = from.mFaces[f];
    if (face.mNumIndices != 3) continue;
    const auto corner = [&](int c) { return first + static_cast<int>(face.mIndices[c]); };
    to.triangles.push_back(mirrors ? Triangle{corner(0), corner(2), corner(1)}
                                   : Triangle{corner(0), corner(1), corner(2)});
  }
  return mirrors;
}

class Walk {
 public:
  Walk(const std::string& file, const aiScene& scene, bool is_linear)
      : file_(file), scene_(scene), is_linear_(is_linear), pictures_(file) {}

  void visit(const aiNode& node, const Eigen::Matrix4d& above, int depth) {
    if (depth > kDeepestNode) {
      throw FileError(file_, "node tree", "more than " + std::to_string(kDeepestNode) + " levels",
                      "fewer");
    }
    const Eigen::Matrix4d place = above * to_matrix(node.mTransformation);
    ImportedPart part;
    MeanColour colour;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
      const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[m]];
      const bool mirrors = append(mesh, place, part.mesh);
      paint_mesh(scene_, mesh, is_linear_, mirrors, pictures_, part, colour);
    }
    drop_plain_paint(part);
    std::string name = node.mName.C_Str();
    if (!part.mesh.triangles.empty()) {
      part.name = name_part(node);
      part.groups = groups_;
      part.colour = colour.find(is_linear_);
      name = part.name;
      parts_.push_back(std::move(part));
    }
    // the root is the file
    const bool is_group = node.mParent != nullptr && !name.empty();
    if (is_group) groups_.push_back(name);
    for (unsigned c = 0; c < node.mNumChildren; ++c) visit(*node.mChildren[c], place, depth + 1);
    if (is_group) groups_.pop_back();
  }

  void finish(ImportedScene& scene) {
    scene.parts = std::move(parts_);
    pictures_.settle(scene);
  }

 private:
  /// The node's name, or its mesh's, made different from all before.
  std::string name_part(const aiNode& node) {
    std::string name = node.mName.C_Str();
    if (name.empty()) name = scene_.mMeshes[node.mMeshes[0]]->mName.C_Str();
    if (name.empty()) name = "part";
    const int times = ++seen_[name];
    return times == 1 ? name : name + " (" + std::to_string(times) + ")";
  }

  const std::string& file_;
  const aiScene& scene_;
  bool is_linear_;
  Pictures pictures_;
  std::vector<ImportedPart> parts_;
  std::vector<std::string> groups_;  ///< above the node that is visited
  std::map<std::string, int> seen_;
};

/// The name of a unit of so many centimetres, as FBX states it.
std::optional<std::string> name_unit(double centimetres) {
  const std::pair<const char*, double> units[] = {{"m", 100.0}, {"cm", 1.0},   {"mm", 0.1},
                                                  {"in", 2.54}, {"ft", 30.48}, {"um", 1e-4}};
  for (const auto& [name, size] : units) {
    if (std::abs(centimetres - size) < 1e-5 * size) return name;
  }
  return std::nullopt;
}

void take_fbx_units(const aiMetadata& data, ImportedScene& scene) {
  float centimetres = 0.0f;
  double precise = 0.0;
  if (data.Get("UnitScaleFactor", centimetres)) precise = centimetres;
  if (precise > 0.0 || data.Get("UnitScaleFactor", precise)) {
    scene.unit = name_unit(precise);
    if (!scene.unit) {
      scene.notes.push_back("states a unit of " + std::to_string(precise) +
                            " cm, which has no name here");
    }
  }
  std::int32_t axis = -1, sign = 1;
  if (data.Get("UpAxis", axis) && axis >= 0 && axis <= 2) {
    data.Get("UpAxisSign", sign);
    scene.up = std::string(sign < 0 ? "-" : "") + "xyz"[axis];
  }
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = ' ';
  }
  return text.substr(0, 200);
}

/// Of the files of printers, whose word for it assimp passes over.
void take_print_unit(const std::string& path, const std::string& format, ImportedScene& scene) {
  const std::pair<const char*, const char*> units[] = {
      {"millimeter", "mm"}, {"micron", "um"}, {"centimeter", "cm"}, {"meter", "m"},
      {"inch", "in"},       {"foot", "ft"},   {"feet", "ft"}};
  const std::string said = read_print_unit(path, format);
  for (const auto& [word, name] : units) {
    if (said == word) scene.unit = name;
  }
  if (!scene.unit && !said.empty()) {
    scene.notes.push_back("states a unit of '" + one_line(said).substr(0, 40) +
                          "', which has no name here");
  }
}

/// glTF is in metres with y up by its specification. assimp turns Collada and 3DS to y up, and
/// Collada to metres, as it reads them.
void take_units(const aiScene& from, const std::string& path, const std::string& format,
                ImportedScene& scene) {
  if (format == "GLB" || format == "GLTF" || format == "DAE") {
    scene.unit = "m";
    scene.up = "y";
  } else if (format == "3DS") {
    scene.up = "y";
  } else if (format == "FBX" && from.mMetaData != nullptr) {
    take_fbx_units(*from.mMetaData, scene);
  } else if (format == "3MF" || format == "AMF") {
    take_print_unit(path, format, scene);
  }
}

}  // namespace

ImportedScene read_with_assimp(const std::string& path, const std::string& format) {
  ImportedScene scene{};
  const bool is_gltf = format == "GLB" || format == "GLTF";
  if (is_gltf) check_gltf(path, scene.notes);
  Assimp::Importer importer;
  auto* const files = new FolderFiles(path);  // the importer's own from the next line on
  importer.SetIOHandler(files);
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                              aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS |
                                  aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
                                  aiComponent_LIGHTS | aiComponent_CAMERAS);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* from =
      importer.ReadFile(path, aiProcess_RemoveComponent | aiProcess_Triangulate |
                                  aiProcess_SortByPType | aiProcess_ValidateDataStructure);
  const std::set<std::string>& outside = files->outside();
  if (from == nullptr && !outside.empty()) {
    throw FileError(path, "", "a reference to " + one_line(*outside.begin()),
                    "references to files beside the mesh or below its folder");
  }
  const std::string said = importer.GetErrorString();
  if (from == nullptr && (said.find("mNumMeshes is 0") != std::string::npos ||
                          said.find("contains no faces") != std::string::npos ||
                          said.find("No meshes remaining") != std::string::npos)) {
    throw FileError(path, "", "no faces", "a surface made of triangles or polygons");
  }
  if (from == nullptr && said.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
  if (from == nullptr || from->mRootNode == nullptr) {
    throw FileError(path, "", "content assimp refuses (" + one_line(said) + ")",
                    "a readable " + format + " file");
  }

  // the colours of glTF are linear; those of other formats are as they are seen
  Walk walk(path, *from, is_gltf);
  walk.visit(*from->mRootNode, Eigen::Matrix4d::Identity(), 0);
  walk.finish(scene);
  take_units(*from, path, format, scene);
  for (const std::string& file : outside) {
    scene.notes.push_back("did not open " + one_line(file) + ", which lies outside of its folder");
  }
  return scene;
}

}  // namespace palpate::authoring
