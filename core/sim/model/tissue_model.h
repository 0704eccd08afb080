// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "palpate/sim/base/types.h"

namespace palpate {

/// How the damping of a link acts on the relative velocity w of its ends (Eq 2 of the paper).
enum class DampingLaw {
  axis,       ///< -c (w·n) n: only along the link; rotation is free [Provot95]
  isotropic,  ///< -c w: the paper's other reading; damps rigid rotation too
};

/// How an angle pushes back.
enum class AngleLaw {
  gradient,  ///< the negative gradient of Eq 9 and Eq 11
  eq10,      ///< the paper's Eq 10: a pair force along the opposite edge; not conservative
};

/// Pairs of particles that resist a change of distance.
///
/// A spring of the mass-spring model and a bond of the molecular model obey the same law, so
/// they share this table and one kernel; they differ only in how they are built.
struct Links {
  std::vector<std::array<int, 2>> ends;  ///< particle indices, ends[l][0] < ends[l][1]
  std::vector<double> rest_length;       ///< [m]
  std::vector<double> stiffness;         ///< [N/m]; a bond's may be negative
  std::vector<double> damping;           ///< [N·s/m]
};

/// Triangles whose three corners resist a change of angle (molecular model, Eq 9 and Eq 11).
///
/// Row a is one triangle; column c belongs to its corner c, or to the side opposite corner c.
struct Angles {
  std::vector<Triangle> corners;                   ///< particle indices
  std::vector<std::array<double, 3>> rest_cosine;  ///< [-] of the angle at the corner
  std::vector<std::array<double, 3>> rest_length;  ///< [m] of the side opposite the corner
  /// [J] K_theta of the corner; [N] under AngleLaw::eq10
  std::vector<std::array<double, 3>> bend_stiffness;
  std::vector<std::array<double, 3>> stretch_coupling;  ///< [N] K_btheta of the corner
  /// [N/m] this triangle's part of the bond opposite the corner; a bond is the sum of its parts
  std::vector<std::array<double, 3>> bond_share;
};

/// Triangular prisms of a wall that resist transverse shear, which is what makes a wall bend: row p
/// joins a triangle of the inner face to the one above it.
///
/// The two faces are rows of Angles and bonds, the pillars between them springs. What is left is
/// the shear of the three sides. In side c, opposite corner c, the first diagonal runs from the
/// inner corner c + 1 to the outer corner c + 2, the second from the inner corner c + 2 to the
/// outer corner c + 1. Shear makes one longer and the other shorter; stretching and thinning do
/// not.
struct Prisms {
  std::vector<std::array<int, 6>> corners;  ///< particles: three inner, then the three above them
  std::vector<std::array<double, 3>> rest_difference;  ///< [m] first diagonal less the second
  std::vector<std::array<double, 3>> shear_stiffness;  ///< [N/m] of that difference
  std::vector<std::array<double, 3>> shear_damping;    ///< [N·s/m] likewise
};

/// Tetrahedra that resist a change of volume, and with it being turned inside out [laws: solid].
///
/// With J the volume over that at rest, the part 1 - nodal_share of each tetrahedron's bulk acts on
/// its own J; the part nodal_share on the mean J around each of its particles, which does not lock
/// a nearly incompressible tissue.
struct Volumes {
  std::vector<std::array<int, 4>> corners;  ///< particle indices, (b - a) x (c - a) towards d
  std::vector<double> rest_volume;          ///< [m³], positive
  std::vector<double> bulk;                 ///< [Pa] lambda - mu: what springs leave to be done
  std::vector<int> first_around;  ///< of each particle in `around`, and the end; see build_volumes
  std::vector<int> around;   ///< the rows around particle 0, those around 1, ... each ascending
  double nodal_share = 0.0;  ///< [-] 0 to 1
};

/// Tetrahedra of a linear elastic solid, for shallow presses: the strain of each is constant, and
/// Hooke's law gives its stress. Strain is what displacements from rest have of it to first order,
/// so that turning a body far strains it.
///
/// With theta the trace of the strain, the part 1 - nodal_share of each tetrahedron's lambda acts
/// on its own theta; the part nodal_share on the mean theta around each of its particles.
struct Elastic {
  std::vector<std::array<int, 4>> corners;  ///< particle indices, (b - a) x (c - a) towards d
  std::vector<double> lame;                 ///< [Pa] lambda, Lamé's first constant
  std::vector<double> shear;                ///< [Pa] mu
  std::vector<int> first_around;            ///< as in Volumes; see build_elastic
  std::vector<int> around;
  /// particles that pushes may move, ascending; empty for all that carry the surface
  std::vector<int> reach;
  double nodal_share = 0.0;   ///< [-] 0 to 1
  double damping_time = 0.0;  ///< [s] in which strain follows stress (Kelvin-Voigt)
};

/// Tetrahedra of a solid that may be strained and turned far: the deformation gradient F of each is
/// constant, and the law of the table that they stand in gives its stress [laws: corotated],
/// [laws: neo-hookean].
///
/// Of lambda the part 1 - nodal_share acts on each tetrahedron's own volume, as its law says; the
/// part nodal_share on the mean J around each of its particles, as lambda (J - 1)²/2.
struct Hyperelastic {
  std::vector<std::array<int, 4>> corners;  ///< particle indices, (b - a) x (c - a) towards d
  std::vector<double> lame;                 ///< [Pa] lambda, Lamé's first constant
  std::vector<double> shear;                ///< [Pa] mu
  std::vector<double> viscosity;            ///< [Pa·s] eta: 2 eta times the rate of Green's strain
  std::vector<int> first_around;            ///< as in Volumes; see build_hyperelastic
  std::vector<int> around;
  double nodal_share = 0.0;  ///< [-] 0 to 1
};

/// Linear viscoelasticity: beside every spring, bond, angle and stretch-bend a Maxwell branch of
/// `ratio` times its stiffness, whose force fades with `time` while the tissue holds still. A
/// tissue is 1 + ratio times as stiff against a sudden push as against a slow one [laws:
/// relaxation].
struct Maxwell {
  double ratio = 0.0;  ///< [-] k_v/k, 0 for none
  double time = 0.5;   ///< [s] tau
};

/// How a fine surface rides on coarse tetrahedra. Vertex v of the surface is at the sum over k of
/// weights[v][k] times the position of particle corners[v][k]. Empty where the particles
/// themselves are the surface.
struct Skin {
  std::vector<std::array<int, 4>> corners;     ///< particle indices
  std::vector<std::array<double, 4>> weights;  ///< [-] sum 1; below 0 outside of the tetrahedron
};

/// An organ as built: everything about it that a simulation never changes.
/// Made by a build_* function, checked once by validate(), then shared as const.
struct TissueModel {
  Vec3Array rest_position;   ///< [m]
  std::vector<double> mass;  ///< [kg], positive
  std::vector<int> fixed;    ///< particles held at rest, ascending
  Links springs;             ///< mass-spring model; may be empty
  Links bonds;               ///< molecular model; may be empty
  Angles angles;             ///< molecular model; may be empty
  Prisms prisms;             ///< walls that bend; may be empty
  Volumes volumes;           ///< solids; may be empty
  Elastic elastic;           ///< linear solids, which have no other law; may be empty
  Hyperelastic corotated;    ///< solids of the corotated law; may be empty
  Hyperelastic neo_hookean;  ///< solids of the neo-Hookean law; may be empty
  Maxwell maxwell;           ///< what of links and angles relaxes
  Skin skin;                 ///< solids under a finer surface; may be empty
  std::vector<double> home;  ///< [N/m] pull of each particle to its rest; may be empty
  double pressure = 0.0;     ///< [Pa] inside above outside; 0 where there is a skin
  /// outer surface, counter-clockwise from outside: of vertices of the skin, or of particles
  /// where there is none
  std::vector<Triangle> triangles;
  double drag = 0.0;  ///< [1/s], velocity lost to the surroundings
  DampingLaw damping_law = DampingLaw::axis;
  AngleLaw angle_law = AngleLaw::gradient;
};

inline int particle_count(const TissueModel& model) {
  return static_cast<int>(model.rest_position.size());
}

/// Vertices of the surface: those of the skin, or the particles where there is none.
inline int surface_count(const TissueModel& model) {
  return model.skin.corners.empty() ? particle_count(model)
                                    : static_cast<int>(model.skin.corners.size());
}

/// [kg]
double compute_total_mass(const TissueModel& model);

/// One line for people: how many particles and links of each kind, and the total mass [g].
std::string describe(const TissueModel& model);

/// Throws std::invalid_argument, naming table, row, what was found and what was expected.
/// Includes definiteness: a triangle whose bond shares, angle and stretch-bend constants make
/// its tangent at rest indefinite is refused. What AngleLaw::eq10 must satisfy instead stands at
/// check_definiteness (definiteness.h).
void validate(const TissueModel& model);

/// Volumes with the tables of what lies around each particle filled in. The corners must be
/// particles, 0 to particle_count - 1, which is not checked here but by validate().
Volumes build_volumes(int particle_count, std::vector<std::array<int, 4>> corners,
                      std::vector<double> rest_volume, std::vector<double> bulk,
                      double nodal_share = 0.0);

/// A linear solid's table likewise; pushes reach all of its surface.
Elastic build_elastic(int particle_count, std::vector<std::array<int, 4>> corners,
                      std::vector<double> lame, std::vector<double> shear, double nodal_share = 0.0,
                      double damping_time = 0.0);

/// A table of the corotated or the neo-Hookean law likewise.
Hyperelastic build_hyperelastic(int particle_count, std::vector<std::array<int, 4>> corners,
                                std::vector<double> lame, std::vector<double> shear,
                                std::vector<double> viscosity, double nodal_share = 0.0);

/// Tetrahedra of a solid of any law: those of the first of its tables that has some.
inline const std::vector<std::array<int, 4>>& list_tetrahedra(const TissueModel& model) noexcept {
  if (!model.elastic.corners.empty()) return model.elastic.corners;
  for (const Hyperelastic* table : {&model.corotated, &model.neo_hookean}) {
    if (!table->corners.empty()) return table->corners;
  }
  return model.volumes.corners;
}

/// Sets `surface` [m] to where the vertices of a surface are that rides on particles at x [m].
void move_skin(const Skin& skin, std::span<const Vec3> x, std::span<Vec3> surface) noexcept;

/// [m] Where the vertices of the model's surface are with its particles at x [m]: the skin's, or
/// the particles themselves.
Vec3Array compute_surface(const TissueModel& model, std::span<const Vec3> x);

/// [kg] With what mass a vertex of the surface withstands a push when all of the surface is pushed
/// alike: that of its particle, or under a skin 1 / sum of |w_v w_u| / m over all vertices u and
/// the particles that carry both. K_s A, with A the compliance of the vertices, then has no larger
/// an eigenvalue than K_s over these masses, whatever the stiffness K_s of contacts.
std::vector<double> compute_surface_mass(const TissueModel& model);

}  // namespace palpate
