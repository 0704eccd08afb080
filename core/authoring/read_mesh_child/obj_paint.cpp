// SPDX-License-Identifier: GPL-3.0-or-later
#include "palpate/authoring/read_mesh_child/obj_paint.h"

#include <algorithm>
#include <limits>

#include "palpate/authoring/read_mesh_child/mean_colour.h"
#include "palpate/authoring/read_mesh_child/read_materials.h"

namespace palpate::authoring {
namespace {

constexpr float kNoPlace = std::numeric_limits<float>::max();

double measure_area(const Vec3Array& x, const Triangle& t) {
  return 0.5 * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm();
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 32) c = ' ';
  }
  return text.substr(0, 200);
}

}  // namespace

void ObjPaint::take_library(const std::string& name) {
  Materials read = read_materials(path_, name);
  if (!read.is_there) missing_.push_back(one_line(name));
  materials_.merge(read.colours);
  picture_names_.merge(read.pictures);
}

int ObjPaint::number_material(const std::string& name) {
  return numbers_.try_emplace(name, static_cast<int>(numbers_.size())).first->second;
}

void ObjPaint::take_place(TextLine& line) {
  std::array<float, 2> place{kNoPlace, kNoPlace};
  if (line.take(place[0])) line.take(place[1]);
  places_.push_back(place);
}

void ObjPaint::take_colour(TextLine& line, std::size_t vertices) {
  Vec3 colour;
  const bool has_one = line.take(colour[0]) && line.take(colour[1]) && line.take(colour[2]);
  if (has_one && colour.allFinite() && colours_.size() + 1 == vertices) {
    colours_.push_back(colour);
    if (colour.maxCoeff() > 1.0) brightest_ = 255.0;
  }
}

int ObjPaint::find_place(std::string_view word, int seen, int base) const {
  const std::size_t slash = word.find('/');
  int index = 0;
  if (slash == std::string_view::npos) return -1;
  const std::string_view rest = word.substr(slash + 1);
  if (!TextLine::parse(rest.substr(0, rest.find('/')), index)) return -1;
  const int count = static_cast<int>(places_.size());
  const int place = index < 0 ? seen + index : index - base;
  return place >= 0 && place < count ? place : -1;
}

bool ObjPaint::has_places(const Triangle& places) const {
  return std::all_of(places.begin(), places.end(), [&](int place) {
    return place >= 0 && places_[place][0] != kNoPlace && places_[place][1] != kNoPlace;
  });
}

void ObjPaint::paint(const Painted& of, ImportedPart& part) {
  std::vector<const Vec3*> told(numbers_.size(), nullptr);
  std::vector<int> pictures(numbers_.size(), -1);
  for (const auto& [name, number] : numbers_) {
    const auto colour = materials_.find(name);
    if (colour != materials_.end()) told[number] = &colour->second;
    const auto picture = picture_names_.find(name);
    if (picture != picture_names_.end()) pictures[number] = pictures_.find(picture->second);
  }
  MeanColour mean;
  for (std::size_t t = 0; t < of.triangles.size(); ++t) {
    const int material = of.materials[t];
    const Vec3* const own = material >= 0 ? told[material] : nullptr;
    const int picture = material >= 0 && has_places(of.places[t]) ? pictures[material] : -1;
    Vec3 middle = Vec3::Zero();
    for (int c = 0; c < 3; ++c) {
      CornerPaint corner;
      Vec3 colour = own == nullptr ? Vec3(Vec3::Ones()) : *own;
      if (!colours_.empty()) colour = colours_[of.triangles[t][c]] / brightest_;
      middle += colour / 3.0;
      // the colour beside a picture is no factor of it: programs write any
      if (picture < 0 || !colours_.empty()) corner.colour = to_channels(colour);
      if (picture >= 0) corner.place = places_[of.places[t][c]];
      part.paint.push_back(corner);
    }
    part.pictures.push_back(picture);
    const bool is_told = !colours_.empty() || own != nullptr;
    if (is_told) mean.add(middle, measure_area(of.vertices, of.triangles[t]));
  }
  drop_plain_paint(part);
  part.colour = mean.find(false);
}

void ObjPaint::settle(ImportedScene& scene) {
  pictures_.settle(scene);
  for (const std::string& library : missing_) {
    scene.notes.push_back("the materials in " + library + " are not there to be read");
  }
}

}  // namespace palpate::authoring
