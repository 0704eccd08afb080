// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "bindings.h"
#include "border.h"
#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/tree/aabb_tree.h"
#include "rows.h"
#include "value.h"

namespace palpate::bindings {

template <>
py::dtype row_dtype<ToolState::Hold>() {
  return RowType<ToolState::Hold>()
      .field("triangle", &ToolState::Hold::triangle)
      .field("weights", &ToolState::Hold::weights)
      .field("stiffness", &ToolState::Hold::stiffness)
      .field("offset", &ToolState::Hold::offset)
      .field("body", &ToolState::Hold::body)
      .field("normal", &ToolState::Hold::normal)
      .field("sideways", &ToolState::Hold::sideways)
      .dtype();
}

template <>
py::dtype row_dtype<ToolState::PatchPoint>() {
  return RowType<ToolState::PatchPoint>()
      .field("triangle", &ToolState::PatchPoint::triangle)
      .field("body", &ToolState::PatchPoint::body)
      .field("weights", &ToolState::PatchPoint::weights)
      .field("share", &ToolState::PatchPoint::share)
      .dtype();
}

template <>
py::dtype row_dtype<ToolState::Anchor>() {
  return RowType<ToolState::Anchor>()
      .field("triangle", &ToolState::Anchor::triangle)
      .field("body", &ToolState::Anchor::body)
      .field("jaw", &ToolState::Anchor::jaw)
      .field("weights", &ToolState::Anchor::weights)
      .field("place", &ToolState::Anchor::place)
      .field("pressed", &ToolState::Anchor::pressed)
      .field("stiffness", &ToolState::Anchor::stiffness)
      .dtype();
}

namespace {

void bind_jaws(py::module_& m) {
  const Jaws usual;
  py::class_<Jaws> jaws(
      m, "Jaws",
      "Two jaws on one hinge, which close on what lies between them with a limited force: of a "
      "tool of two capsules, each of them a jaw where it is closed. The first opens by turning "
      "about axis, the second the other way.");
  jaws.def(
      py::init([](const Vec3& hinge, const Vec3& axis, double open, double grip, double pad_area) {
        return Jaws{hinge, axis, open, grip, pad_area};
      }),
      py::kw_only(), "hinge"_a = usual.hinge, "axis"_a = usual.axis, "open"_a = usual.open,
      "grip"_a = usual.grip, "pad_area"_a = usual.pad_area);
  def_vector(jaws, "hinge", &Jaws::hinge, "[m] a point of the axis, in the tool's frame.");
  def_vector(jaws, "axis", &Jaws::axis, "[-] Unit.");
  jaws.def_readwrite("open", &Jaws::open, "[rad] the farthest that each jaw turns.")
      .def_readwrite("grip", &Jaws::grip,
                     "[N] that each closes with at most, at the middle of its capsule.")
      .def_readwrite("pad_area", &Jaws::pad_area, "[m²] of the side of each that holds.");
  def_value(jaws, &Jaws::hinge, &Jaws::axis, &Jaws::open, &Jaws::grip, &Jaws::pad_area);
  def_repr(jaws, {"hinge", "axis", "open", "grip", "pad_area"});
}

void def_jaw_state(py::class_<ToolState>& state) {
  state
      .def_readonly("jaw_angle", &ToolState::jaw_angle,
                    "[rad] by which each jaw is open; of a tool with jaws, as what follows.")
      .def_readonly("jaw_wanted", &ToolState::jaw_wanted,
                    "[rad] by which the hand would have it open.")
      .def_readonly("grip_limit", &ToolState::grip_limit,
                    "[N] up to which it closes now: Jaws.grip, less as it lets go.")
      .def_readonly("pinch", &ToolState::pinch, "[N] that each jaw presses with, the mean of both.")
      .def_readonly("pad_pressure", &ToolState::pad_pressure,
                    "[Pa] of that on what is touched of a pad.");
  def_vector(state, "carried", &ToolState::carried,
             "[N] on the tool, of all anchors: what it holds up.");
  def_vector(state, "felt_before", &ToolState::felt_before,
             "[N] What was felt in the tick before, for felt_change.");
  def_fixed_rows(
      state, "anchors", &ToolState::anchors,
      "Where tissue sticks to the jaws, all there is room for: a structured array of "
      "shape (anchor_capacity,) (triangle, body, jaw, weights, place, pressed, stiffness); a view, "
      "read-only.");
  state
      .def_readonly("turn_limited", &ToolState::turn_limited,
                    "Tissue keeps it from turning as its hand does, in this tick.")
      .def_readonly("anchor_count", &ToolState::anchor_count, "How many of them there are.")
      .def_readonly("held_load", &ToolState::held_load,
                    "[N] that they carry, each whatever its direction.")
      .def_readonly("pinches", &ToolState::pinches, "Tissue sticks to both jaws.")
      .def_readonly("felt_change", &ToolState::felt_change,
                    "[N] by which what is felt may change in this tick, as it lets go; 0: by any.")
      .def("has_hold", &ToolState::has_hold,
           "Something follows the tool: it is fastened, or pinched.");
}

void bind_tool(py::module_& m) {
  const Tool usual;
  m.attr("MOST_CAPSULES") = kMostCapsules;
  py::class_<Capsule> capsule(
      m, "Capsule",
      "All points within the tool's radius of a segment, which is given in the tool's frame.");
  capsule.def(py::init([](const Vec3& from, const Vec3& to) {
                return Capsule{from, to};
              }),
              "from_"_a = Vec3::Zero().eval(), "to"_a = Vec3::Zero().eval());
  def_vector(capsule, "from_", &Capsule::from, "[m]");
  def_vector(capsule, "to", &Capsule::to, "[m]");
  def_value(capsule, &Capsule::from, &Capsule::to);
  def_repr(capsule, {"from_", "to"});

  bind_jaws(m);
  py::class_<Tool> tool(m, "Tool",
                        "What of the instrument touches, never a point: a ball, or a rigid list of "
                        "capsules.");
  tool.def(py::init([](double radius, double stiffness, double friction,
                       const std::vector<Capsule>& capsules, const std::optional<Jaws>& jaws) {
             return Tool{radius, stiffness, friction, capsules, jaws};
           }),
           py::kw_only(), "radius"_a = usual.radius, "stiffness"_a = usual.stiffness,
           "friction"_a = usual.friction, "capsules"_a = py::list(), "jaws"_a = py::none());
  tool.def_readwrite("radius", &Tool::radius, "[m]")
      .def_readwrite("stiffness", &Tool::stiffness,
                     "[N/m³] k_A: pressure per depth of the contact law.")
      .def_readwrite("friction", &Tool::friction,
                     "[-] Coulomb's coefficient mu between tip and tissue; 0: it slides.");
  tool.def_property(
      "capsules", [](const Tool& self) { return self.capsules; },
      [](Tool& self, const std::vector<Capsule>& capsules) { self.capsules = capsules; },
      "A list of at most MOST_CAPSULES, copied; empty: a ball about the position.");
  tool.def_property(
      "jaws", [](const Tool& self) { return self.jaws; },
      [](Tool& self, const std::optional<Jaws>& jaws) { self.jaws = jaws; },
      "Of a tool of two capsules, copied; None: what touches is rigid.");
  def_value(tool, &Tool::radius, &Tool::stiffness, &Tool::friction, &Tool::capsules, &Tool::jaws);
  def_repr(tool, {"radius", "stiffness", "friction", "capsules", "jaws"});

  py::class_<ToolState> state(
      m, "ToolState", "Where the tool is (the paper's ideal tip, IUN) and what it is fastened to.");
  py::class_<ToolState::Carrier> carrier(
      state, "Carrier",
      "The surface nearest to the tool after the last substep; the tool rides on its motion.");
  carrier.def_readonly("triangle", &ToolState::Carrier::triangle, "-1 when nothing is touched.");
  def_vector(carrier, "weights", &ToolState::Carrier::weights,
             "[-] Barycentric, of the closest point.");
  def_vector(carrier, "point", &ToolState::Carrier::point, "[m] where that was.");
  def_vector(carrier, "direction", &ToolState::Carrier::direction,
             "[-] Unit, from there to the tool's centre.");
  carrier.def_readonly("body", &ToolState::Carrier::body, "Whose triangle.");
  def_value(carrier, &ToolState::Carrier::triangle, &ToolState::Carrier::weights,
            &ToolState::Carrier::point, &ToolState::Carrier::direction, &ToolState::Carrier::body);
  def_repr(carrier, {"triangle", "weights", "point", "direction", "body"});
  state.def(py::init([](int capacity, int patch_capacity, int anchor_capacity) {
              return ToolState(to_count(capacity, "capacity"),
                               to_count(patch_capacity, "patch_capacity"),
                               to_count(anchor_capacity, "anchor_capacity"));
            }),
            "capacity"_a = 0, "patch_capacity"_a = 0, "anchor_capacity"_a = 0,
            "Room for so many holds and, with friction, triangles that are touched at once, and "
            "with jaws, of both.");
  def_vector(state, "position", &ToolState::position, "[m]");
  state.def_property_readonly(
      "orientation",
      [](const py::object& self) { return view_one(self.cast<ToolState&>().orientation, self); },
      "[-] Of the tool's frame: unit quaternion (x, y, z, w), shape (4,); a view.");
  def_vector(state, "torque", &ToolState::torque,
             "[N m] on a tool with capsules about its position, in the last substep.");
  state.def_readwrite("placed", &ToolState::placed,
                      "False until the first sample has put it somewhere.");
  def_fixed_rows(state, "holds", &ToolState::holds,
                 "All holds there is room for, a structured array of shape (capacity,) (triangle, "
                 "weights, stiffness, "
                 "offset); a view, read-only: attach_tool writes it.");
  state.def_readonly("hold_count", &ToolState::hold_count, "0 when nothing is attached.")
      .def_readwrite("touching", &ToolState::touching, "Any contact in force in the last substep.");
  def_vector(state, "residual", &ToolState::residual,
             "[N] left between hand and tissue after the last substep.");
  def_fixed_rows(state, "patch", &ToolState::patch,
                 "What a tool with friction touched in the last substep, all there is room for: a "
                 "structured array of shape (patch_capacity,) (triangle, body, weights, share); a "
                 "view, read-only.");
  state.def_readonly("patch_count", &ToolState::patch_count, "How many of them there are.");
  def_vector(state, "patch_position", &ToolState::patch_position,
             "[m] where the mean of the patch's points was.");
  def_vector(state, "patch_normal", &ToolState::patch_normal,
             "[-] Unit, in which the contacts together push the tool.");
  def_vector(state, "friction", &ToolState::friction, "[N] on the tool in the last substep.");
  state.def_readonly("carrier", &ToolState::carrier, "The surface nearest to the tool.");
  def_jaw_state(state);
  def_value(state, &ToolState::position, &ToolState::orientation, &ToolState::torque,
            &ToolState::placed, &ToolState::holds, &ToolState::hold_count, &ToolState::carrier,
            &ToolState::touching, &ToolState::residual, &ToolState::patch, &ToolState::patch_count,
            &ToolState::patch_position, &ToolState::patch_normal, &ToolState::friction,
            &ToolState::jaw_angle, &ToolState::jaw_wanted, &ToolState::grip_limit,
            &ToolState::pinch, &ToolState::pad_pressure, &ToolState::carried, &ToolState::anchors,
            &ToolState::anchor_count, &ToolState::held_load, &ToolState::pinches,
            &ToolState::felt_change, &ToolState::felt_before, &ToolState::turn_limited);
  def_repr(state, {"position", "placed", "touching", "hold_count", "residual"});

  const Coupling spring;
  py::class_<Coupling> coupling(m, "Coupling",
                                "The hand's spring: what pulls the tool to where the device is.");
  coupling.def(py::init([](double stiffness, double force_max) {
                 return Coupling{stiffness, force_max};
               }),
               py::kw_only(), "stiffness"_a = spring.stiffness, "force_max"_a = spring.force_max);
  coupling.def_readwrite("stiffness", &Coupling::stiffness, "[N/m] K of Eq 12.")
      .def_readwrite("force_max", &Coupling::force_max, "[N]");
  def_value(coupling, &Coupling::stiffness, &Coupling::force_max);
  def_repr(coupling, {"stiffness", "force_max"});
}

void bind_contact_law(py::module_& m) {
  m.attr("BARRIER_FLOOR") = kBarrierFloor;
  m.attr("NO_ARM") = kNoArm;
  m.attr("FULL_FACING") = kFullFacing;
  m.attr("PARALLEL") = kParallel;
  m.attr("JAW_SPREAD") = kJawSpread;
  py::class_<Contact> contact(m, "Contact", "How the tip touches one triangle.");
  contact.def(py::init<>());
  def_vector(contact, "weights", &Contact::weights, "[-] Barycentric, of the closest point.");
  def_vector(contact, "direction", &Contact::direction,
             "[-] Unit, from the closest point to the tool's centre.");
  contact.def_readwrite("distance", &Contact::distance, "[m] between the two.")
      .def_readwrite("force", &Contact::force,
                     "[N] along direction on the tool, against it on the tissue.")
      .def_readwrite("stiffness", &Contact::stiffness, "[N/m] d force / d depth.");
  def_value(contact, &Contact::weights, &Contact::direction, &Contact::distance, &Contact::force,
            &Contact::stiffness);
  def_repr(contact, {"weights", "direction", "distance", "force", "stiffness"});
  m.def("find_contact", &find_contact, "tool"_a, "rest_area"_a, "centre"_a, "a"_a, "b"_a, "c"_a,
        "contact"_a,
        "Fills in the contact of a tip at centre with the triangle a, b, c of rest_area [m²]; "
        "False where there is none, or where the centre lies behind the triangle.");
  m.def("find_capsule_contact", &find_capsule_contact, "tool"_a, "rest_area"_a, "from_"_a, "to"_a,
        "a"_a, "b"_a, "c"_a, "contact"_a,
        "The same of a capsule of the tool whose axis goes from from_ to to [m].");
  m.def(
      "compute_point",
      [](const Triangle& t, const Vec3& weights, const Numbers& x) {
        const auto xs = points(x, "x");
        require_triangles(std::span(&t, 1), xs.size());
        return compute_point(t, weights, xs);
      },
      "t"_a, "weights"_a, "x"_a, "[m] The point of a triangle with these barycentric weights.");
}

void bind_candidates(py::module_& m) {
  m.attr("CANDIDATE_MARGIN") = kCandidateMargin;
  py::class_<Candidates> candidates(
      m, "Candidates",
      "Triangles the tool may touch during one tick, ascending, with the area of each [m²].");
  candidates.def(py::init([](int capacity, int capsules) {
                   return Candidates(to_count(capacity, "capacity"),
                                     to_count(capsules, "capsules"));
                 }),
                 "capacity"_a = 0, "capsules"_a = 0,
                 "Room for so many triangles, for each of the capsules of a tool.");
  def_table(
      candidates, "triangles", &Candidates::triangles,
      "All there is room for, shape (capacity,); the first count of them hold; a view, read-only.");
  def_view(candidates, "areas", &Candidates::areas,
           "[m²] shape (capacity,), at rest, so that pressing does not change the law; a view.");
  candidates.def_readonly("count", &Candidates::count, "How many of them there are.");
  def_vector(candidates, "from_", &Candidates::from, "[m] the path they were looked for along.");
  def_vector(candidates, "to", &Candidates::to, "[m]");
  def_value(candidates, &Candidates::triangles, &Candidates::areas, &Candidates::count,
            &Candidates::from, &Candidates::to);
  def_repr(candidates, {"count", "from_", "to"});
  m.def(
      "find_candidates",
      [](const AabbTree& tree, const Numbers& x, const Tool& tool, const Vec3& tool_position,
         const Vec3& hand_position, const Numbers& rest_areas, Candidates& found,
         const Eigen::Vector4d& xyzw, double jaw_angle) {
        const auto xs = points(x, "x");
        require_fit(tree, xs);
        const auto areas = numbers(rest_areas, "rest_areas");
        require_count("rest_areas", areas.size(), tree.triangles().size());
        const std::size_t all =
            tree.triangles().size() * std::max<std::size_t>(1, tool.capsules.size());
        if (found.triangles.size() < all) {
          refuse("candidates", "room for " + std::to_string(found.triangles.size()),
                 "for every triangle and capsule, " + std::to_string(all));
        }
        find_candidates(tree, xs, tool, tool_position, hand_position, areas, found,
                        to_quaternion(xyzw), jaw_angle);
      },
      "tree"_a, "x"_a, "tool"_a, "tool_position"_a, "hand_position"_a, "rest_areas"_a,
      "candidates"_a, "orientation"_a = Eigen::Vector4d(0.0, 0.0, 0.0, 1.0), "jaw_angle"_a = 0.0,
      "Finds every triangle within radius + CANDIDATE_MARGIN of the path from the tool's last "
      "position to where the hand is now, with jaws open by jaw_angle [rad]. rest_areas [m²] per "
      "triangle of the tissue.");
}

/// Rows and positions as a contact function wants them, checked against each other.
struct Surface {
  Surface(const Integers& triangles_in, const Numbers& x_in)
      : triangles(copy_index_rows<3>(triangles_in, "triangles")), x(points(x_in, "x")) {
    require_triangles(triangles, x.size());
  }
  std::vector<Triangle> triangles;
  std::span<const Vec3> x;
};

void bind_balance(py::module_& m) {
  m.def(
      "balance_tool",
      [](const Tool& tool, const Coupling& coupling, const Vec3& hand_position,
         Candidates& candidates, const Integers& triangles, const Numbers& x, ToolState& state,
         Load& load) {
        const Surface surface(triangles, x);
        require_fit(candidates, surface.triangles.size());
        require_fit(state, surface.triangles.size());
        return balance_tool(tool, coupling, hand_position, candidates, surface.triangles, surface.x,
                            state, load);
      },
      "tool"_a, "coupling"_a, "hand_position"_a, "candidates"_a, "triangles"_a, "x"_a, "state"_a,
      "load"_a,
      "Moves the massless tool to where the hand's spring and the tissue's pushes cancel, and "
      "writes those pushes into load. Returns the force on the hand [N], K (tool - hand), limited "
      "to force_max: Eq 12.");
  m.def(
      "attach_tool",
      [](const Load& contacts, const Integers& triangles, const Numbers& x, double stiffness,
         ToolState& state) {
        const Surface surface(triangles, x);
        require_pushes(contacts.pushes(), surface.triangles.size());
        return attach_tool(contacts, surface.triangles, surface.x, stiffness, state);
      },
      "contacts"_a, "triangles"_a, "x"_a, "stiffness"_a, "state"_a,
      "Fastens the tool to the patch it touches, shares weighted by contact force; stiffness [N/m] "
      "in all. Does nothing, and returns False, when it touches nothing.");
  m.def("release_tool", &release_tool, "state"_a, "Lets go of what the tool is fastened to.");
  m.def(
      "bound_contact_stiffness",
      [](const Tool& tool, const Candidates& candidates, const Integers& triangles,
         const Numbers& x, const Numbers& mass, const ToolState& state, const NumbersOut& scratch,
         int body, const NearField* near, double coupling) {
        const Surface surface(triangles, x);
        require_fit(candidates, surface.triangles.size());
        require_fit(state, surface.triangles.size());
        const auto masses = numbers(mass, "mass");
        require_count("mass", masses.size(), surface.x.size());
        const auto room = entries_out(scratch, "scratch");
        require_count("scratch", room.size(), surface.x.size());
        return bound_contact_stiffness(tool, candidates, surface.triangles, surface.x, masses,
                                       state, room, body, near, coupling);
      },
      "tool"_a, "candidates"_a, "triangles"_a, "x"_a, "mass"_a, "state"_a, "scratch"_a,
      "body"_a = 0, "near"_a = py::none(), "coupling"_a = 0.0,
      "Largest extra eigenvalue [1/s²] that contacts and holds may add to M⁻¹K: max over particles "
      "of sum k_t w / m. scratch holds one number per particle.");
}

void bind_near_field(py::module_& m) {
  py::class_<NearField, std::shared_ptr<NearField>> near(
      m, "NearField",
      "What a body's tissue does near a ball, and what its mesh does of that already: with it a "
      "ball is felt as on tissue, however large the triangles are. Made by build_near_field.");
  near.def_readonly("modulus", &NearField::modulus, "[Pa] E / (1 - nu²).");
  near.def_readonly("wall_thickness", &NearField::wall_thickness, "[m] of prisms; 0 of a solid.");
  def_table(near, "far_compliance", &NearField::far_compliance,
            "[m/N] per vertex of the surface, shape (n,): of the body beyond that of a half space; "
            "a view, read-only.");
  def_table(
      near, "far_tensor", &NearField::far_tensor,
      "[m/N] the same in every direction (xx, yy, zz, xy, yz, zx), shape (n, 6), where it was "
      "given, else empty; a view, read-only.");
  def_table(near, "curvature", &NearField::curvature,
            "[1/m] per vertex, shape (n,): of the surface at rest, positive where it is convex; a "
            "view, read-only.");
  def_table(near, "rest_position", &NearField::rest_position,
            "[m] per vertex, shape (n, 3): at rest, where a ball feels how curved facets are, else "
            "empty; a view, read-only.");
  def_table(near, "first", &NearField::first,
            "Of each vertex in neighbour and compliance, shape (n + 1,); a view, read-only.");
  def_table(near, "neighbour", &NearField::neighbour,
            "Vertices around each vertex, ascending, shape (k,); a view, read-only.");
  near.def_property_readonly(
      "compliance",
      [](const py::object& self) {
        const auto& table = self.cast<const NearField&>().compliance;
        return read_only(
            py::array_t<float>(static_cast<py::ssize_t>(table.size()), table.data(), self));
      },
      "[m/N] of the mesh, shape (k,): what a vertex moves along its normal under 1 N along that "
      "of a neighbour; a view, read-only.");
  m.def(
      "build_near_field",
      [](const TissueModel& model, double modulus, double radius, const Numbers& far, bool facets) {
        return build_near_field(model, modulus, radius, copy_tensors(far, "far"), facets);
      },
      "model"_a, "modulus"_a, "radius"_a, "far"_a = py::tuple(), "facets"_a = false,
      "The near field of a model touched by balls of up to radius [m]; modulus [Pa] is E / (1 - "
      "nu²). Solves for a unit force on each vertex of the surface. far [m/N] is the far "
      "compliance of "
      "each vertex; where it is empty, that of this mesh is found. With facets a ball feels how "
      "curved those of a solid are. Raises ValueError for numbers that are not positive.");
}

}  // namespace

void bind_contact(py::module_& m) {
  bind_tree(m);
  bind_queries(m);
  bind_tool(m);
  bind_contact_law(m);
  bind_near_field(m);
  bind_candidates(m);
  bind_balance(m);
}

}  // namespace palpate::bindings
