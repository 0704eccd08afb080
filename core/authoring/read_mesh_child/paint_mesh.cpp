// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/read_mesh_child/private/paint_mesh.h"

namespace palpate::authoring {
namespace {

/// What the material of a mesh says of its colour; nullopt for the one that assimp puts in where
/// the file has none.
std::optional<Vec3> find_base_colour(const aiMaterial& material) {
  aiString name;
  aiColor4D colour;
  material.Get(AI_MATKEY_NAME, name);
  if (std::string(name.C_Str()) == AI_DEFAULT_MATERIAL_NAME) return std::nullopt;
  if (material.Get(AI_MATKEY_BASE_COLOR, colour) != aiReturn_SUCCESS &&
      material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != aiReturn_SUCCESS) {
    return std::nullopt;
  }
  return Vec3(colour.r, colour.g, colour.b);
}

/// The picture of a material, and which places of a mesh's corners are those on it.
struct Texture {
  int picture = -1;
  unsigned channel = 0;
};

Texture find_texture(const aiScene& scene, const aiMaterial& material, Pictures& pictures) {
  for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
    aiString path;
    unsigned channel = 0;
    if (material.GetTexture(type, 0, &path, nullptr, &channel) != aiReturn_SUCCESS) continue;
    const aiTexture* const inside = scene.GetEmbeddedTexture(path.C_Str());
    if (inside == nullptr) return {pictures.find(path.C_Str()), channel};
    if (inside->mHeight != 0) return {};  // texels, which no format here has
    const auto* const bytes = reinterpret_cast<const char*>(inside->pcData);
    return {pictures.add(path.C_Str(), bytes, inside->mWidth), channel};
  }
  return {};
}

double measure_area(const aiMesh& mesh, const unsigned* i) {
  const auto at = [&](unsigned k) -> Vec3 {
    const aiVector3D& p = mesh.mVertices[k];
    return {p.x, p.y, p.z};
  };
  return 0.5 * (at(i[1]) - at(i[0])).cross(at(i[2]) - at(i[0])).norm();
}

/// The paint of a corner: its colour is `factor` times its own, where it has one.
CornerPaint paint_corner(const aiMesh& mesh, unsigned i, const Vec3& factor, bool is_linear,
                         const Texture& texture) {
  Vec3 colour = factor;
  if (const aiColor4D* const own = mesh.mColors[0]) {
    colour = colour.cwiseProduct(Vec3(own[i].r, own[i].g, own[i].b));
  }
  colour = colour.cwiseMax(0.0).cwiseMin(1.0);
  if (is_linear) colour = colour.unaryExpr(&to_srgb);
  CornerPaint corner;
  corner.colour = to_channels(colour);
  if (texture.picture >= 0) {
    const aiVector3D& place = mesh.mTextureCoords[texture.channel][i];
    corner.place = {place.x, place.y};
  }
  return corner;
}

}  // namespace

void paint_mesh(const aiScene& scene, const aiMesh& mesh, bool is_linear, bool mirrors,
                Pictures& pictures, ImportedPart& part, MeanColour& mean) {
  std::optional<Vec3> base;
  Texture texture;
  if (mesh.mMaterialIndex < scene.mNumMaterials) {
    const aiMaterial& material = *scene.mMaterials[mesh.mMaterialIndex];
    base = find_base_colour(material);
    texture = find_texture(scene, material, pictures);
  }
  const bool has_places = texture.channel < AI_MAX_NUMBER_OF_TEXTURECOORDS &&
                          mesh.mTextureCoords[texture.channel] != nullptr;
  if (!has_places) texture = {};
  const bool is_coloured = base.has_value() || mesh.mColors[0] != nullptr;
  // formats other than glTF say the colour beside the picture, not a factor of it
  Vec3 factor = base.value_or(Vec3::Ones());
  if (texture.picture >= 0 && !is_linear) factor = Vec3::Ones();
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;
    const unsigned* const i = face.mIndices;
    Vec3 colour = base.value_or(Vec3::Ones());
    if (const aiColor4D* const own = mesh.mColors[0]) {
      Vec3 sum = Vec3::Zero();
      for (int c = 0; c < 3; ++c) sum += Vec3(own[i[c]].r, own[i[c]].g, own[i[c]].b) / 3.0;
      colour = colour.cwiseProduct(sum);
    }
    if (is_coloured) mean.add(colour, measure_area(mesh, i));
    for (const int c : {0, mirrors ? 2 : 1, mirrors ? 1 : 2}) {
      part.paint.push_back(paint_corner(mesh, i[c], factor, is_linear, texture));
    }
    part.pictures.push_back(texture.picture);
  }
}

}  // namespace palpate::authoring
