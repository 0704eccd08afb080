// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>

#include "palpate/authoring/triangle_box.h"

namespace palpate::authoring {

/// The usual kernel, but that a search in a tree of boxes asks of a triangle and a box with no
/// exact arithmetic: it may look into a box in vain, and finds what it found.
class QuickBoxKernel : public CGAL::Exact_predicates_inexact_constructions_kernel {
  using ExactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

 public:
  class Do_intersect_3 : public ExactKernel::Do_intersect_3 {
   public:
    using ExactKernel::Do_intersect_3::operator();

    bool operator()(const ExactKernel::Triangle_3& triangle, const CGAL::Bbox_3& box) const {
      const auto corner = [&](int v) {
        const ExactKernel::Point_3& p = triangle.vertex(v);
        return TriangleBox::Vector{p.x(), p.y(), p.z()};
      };
      return TriangleBox({corner(0), corner(1), corner(2)}, {box.xmin(), box.ymin(), box.zmin()},
                         {box.xmax(), box.ymax(), box.zmax()})
          .may_meet();
    }
  };

  Do_intersect_3 do_intersect_3_object() const { return {}; }
};

}  // namespace palpate::authoring
