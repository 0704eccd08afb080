// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "palpate/sim/collision/body_pair.h"
#include "palpate/sim/contact/contact_law.h"
#include "palpate/sim/dynamics/step.h"
#include "palpate/sim/mesh/mesh.h"
#include "palpate/sim/model/tissue_model.h"
#include "palpate/sim/response/response.h"

namespace palpate {

/// Which form of the tissue's laws a tick runs.
enum class Kernel {
  reference,  ///< double, plain, one particle after the other
  packed,     ///< float, in vector code
  response,   ///< of a linear solid: quasi-static, from its precomputed response
  automatic,  ///< build_scene chooses the fastest of these that the body's integrator has
};

/// A tissue and how it is moved.
struct SoftBody {
  TissueModel tissue;
  int substeps = 0;      ///< steps per tick in the air; build_scene chooses when 0
  int substeps_max = 0;  ///< contact may raise them to this; build_scene chooses when 0

  /// [N] by which the force may be wrong: what is at rest may then sleep
  /// (packed/private/active_set.h), under the packed kernel. 0: the tissue moves until it is at
  /// rest to the last bit, which vector code hardly ever is
  double force_error = 0.0;

  /// packed is reference where Palpate has no vector code for this machine; build_scene chooses
  /// response in its place for a linear solid
  Kernel kernel = Kernel::automatic;
  /// any but symplectic Euler under the reference kernel only. An implicit one allocates in every
  /// step, and what cannot be solved is an alarm
  Integrator integrator = Integrator::symplectic_euler;
  /// of xpbd and projective_dynamics in every step; build_scene chooses when 0, and refuses any
  /// for another integrator
  int iterations = 0;
  std::string simd_target;  ///< of the packed kernel: one of simd_targets(), empty for the best

  /// [Pa] E* = E / (1 - nu²) of a solid organ: balls are felt as on such tissue, whatever the size
  /// of its triangles [contact: near field]. 0: by the hard law alone, as a wall or a bone
  double contact_modulus = 0.0;
  /// [m/N] per vertex of the surface: how much more the body gives way than a half space, in every
  /// direction at rest, solved on a finer mesh than this [contact: far field]. Empty: that of this
  /// mesh, found by build_scene
  std::vector<Symmetric> far_compliance;
  /// Of a solid with a contact_modulus: a ball feels how curved the facets under it are, and is
  /// felt from the highest of them on [contact: facets]; else as curved as vertices are on the mean
  bool contact_facets = false;
  /// Of a body with a contact_modulus: what a tool holds gives way as tissue does under it
  /// [contact: hold]; else as the mesh does where it is fastened
  bool tied_holds = false;
  /// [-] A link in jaws that is more than so many times as long as at rest, for 5 ms, tears, and
  /// its force fades over 50 ms [contact: tear]. 0: nothing tears
  double tear_stretch = 0.0;

  /// Parts of its surface may touch others of it: build_scene adds a BodyPair of it with itself
  bool may_fold = false;
  /// Gravity does not act on it: its rest shape is the one that it has under its weight, as of an
  /// organ that was scanned as it lies [motion: weight]
  bool weightless = false;

  // filled in by build_scene
  std::vector<double> rest_areas;            ///< [m²] per triangle
  double spectrum_stiffness = 0.0;           ///< [1/s²] largest eigenvalue of M⁻¹K at rest
  double spectrum_damping = 0.0;             ///< [1/s] of M⁻¹C
  double least_damping_time = 0.0;           ///< [s] of C over K, for an integrator that needs it
  double damped_limit = 0.0;                 ///< [s] at rest, under implicit damping
  std::shared_ptr<const Response> response;  ///< under the response kernel, else null
  std::shared_ptr<const NearField> near_field;  ///< with a contact_modulus, else null
};
static_assert(alignof(SoftBody) == 8);

/// A tool, and how the hand that moves it is coupled to it.
struct Instrument {
  Tool tool;
  Coupling coupling;
  double hold_stiffness = 500.0;  ///< [N/m] between tool and patch while attached
  /// [m] where the shaft, which goes along the tool's z to the hand, passes the abdominal wall: z
  /// points there from the tool's position, and only the roll is the device's. None: the device
  /// turns the tool [contact: trocar]
  std::optional<Vec3> trocar = {};
  /// [-] mu of the tool with each surface of the scene: bodies, then scenery, then rigid bodies, in
  /// place of tool.friction; empty: that with all. Where that is 0, nothing rubs [contact:
  /// friction]
  std::vector<double> pair_friction = {};
};

/// What moves and keeps its shape, a stone for one. Instruments touch its mesh;
/// tissues, scenery and other rigid bodies its spheres, which lie in that.
struct RigidBody {
  SurfaceMesh mesh;  ///< [m] in its own frame; build_scene makes that of the spheres if empty
  Vec3Array sphere_centres;  ///< [m] in its own frame, (k, 3); its centre of mass is the origin
  std::vector<double> sphere_radii;                 ///< [m] (k,), positive
  double mass = 0.0;                                ///< [kg], positive
  Vec3 inertia = Vec3::Zero();                      ///< [kg m²] about the axes of its frame
  Vec3 position = Vec3::Zero();                     ///< [m] of its frame, at the start
  Quaternion orientation = Quaternion::Identity();  ///< [-] of its frame, at the start
  /// [-] Coulomb's coefficient on tissue, scenery and other rigid bodies; instruments have their
  /// own
  double friction = 0.3;
  double stiffness = 3e7;             ///< [N/m³] k_A of its spheres on tissue [contact: law]
  double contact_stiffness = 1000.0;  ///< [N/m] of each sphere on what is hard, and of instruments
};
static_assert(alignof(RigidBody) == 8);

/// What never moves, a bone or a table for one. Neither instruments pass it, nor the bodies that it
/// lists [contact: scenery].
struct Scenery {
  SurfaceMesh mesh;         ///< [m] in the scene's frame
  std::vector<int> bodies;  ///< of Scene::bodies: those that stop at it; others pass through
  double friction = 0.0;    ///< [-] Coulomb's coefficient of these on it; 0: they slide
};

/// What rigid bodies are in where nothing else is: water that irrigates, for one.
struct Fluid {
  double density = 0.0;    ///< [kg/m³] of buoyancy and drag; 0: none
  double viscosity = 0.0;  ///< [Pa s] of drag
};

/// Tissues and the instruments that touch them: all that a tick needs and never changes. Each
/// instrument has a hand of its own.
struct Scene {
  std::vector<SoftBody> bodies = std::vector<SoftBody>(1);
  std::vector<RigidBody> rigid;
  std::vector<Scenery> scenery;
  Fluid fluid;  ///< of the rigid bodies
  std::vector<Instrument> instruments = std::vector<Instrument>(1);
  std::vector<BodyPair> body_pairs;  ///< which bodies may touch each other; each pair once
  Vec3 gravity = Vec3::Zero();       ///< [m/s²]
  double rate = 1000.0;              ///< [Hz]
  /// [Hz] 0: the live loop ticks the tissue with the hands. Else the tissue ticks in a thread of
  /// its own, is told where the hands are so often, and is felt between by its local stiffness
  /// [stability: slow tissue]; a whole number of ticks each time. tick() knows nothing of it
  double exchange_rate = 0.0;

  std::uint64_t identity = 0;  ///< another in every call of build_scene; copies share it
};
static_assert(alignof(Scene) == 8);

/// A scene of one tissue and one instrument with the usual values.
Scene make_scene(TissueModel tissue);

/// Checks a scene once and fills in what is derived from it.
/// Throws std::invalid_argument naming the field, what it got and what was expected.
Scene build_scene(Scene scene);

}  // namespace palpate
