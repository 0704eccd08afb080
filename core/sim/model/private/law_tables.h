// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <tuple>

#include "palpate/sim/base/private/refuse.h"
#include "palpate/sim/model/tissue_model.h"

// The one table of laws: which columns each law has, in which unit, and what may stand in them.
// validate() and describe() walk it, and so do file format, bindings, packing order and tests. A
// law is added by a struct in tissue_model.h and its entry here; how it pulls stands in
// dynamics/private/laws.h.

namespace palpate::laws {

/// What a number must be for a model to be valid.
enum class Limit { finite, not_negative, positive, within_one, share };

/// Particles that a row joins, all different; two of them ascend.
template <class T, std::size_t N>
struct Corners {
  const char* name;
  std::vector<std::array<int, N>> T::*rows;
  const char* doc;
};

/// Particles beside the rows, ascending.
template <class T>
struct Particles {
  const char* name;
  std::vector<int> T::*rows;
  const char* doc;
};

/// One number a row, or an array of them; files allow `least` to `most`.
template <class T, class Row>
struct Numbers {
  const char* name;
  std::vector<Row> T::*rows;
  const char* unit;
  Limit limit;
  double least, most;
  const char* doc;
};

/// A number of the whole law. `field` is its name among a tissue's in a file.
template <class T>
struct Scalar {
  const char* name;
  double T::*value;
  const char* field;
  const char* unit;
  Limit limit;
  double least, most;
  const char* doc;
};

/// What follows from the other columns: in no file.
template <class T>
struct Derived {
  const char* name;
  std::vector<int> T::*rows;
  const char* doc;
};

/// Names of a table: of itself in TissueModel, files and Python; of its class in Python; of what a
/// row is; and of what tissue has it.
struct Names {
  const char *table, *type, *row, *tissue;
};

/// Why no part of a tissue with this law may sleep (packed/private/active_set.h), as a refusal puts
/// it; null where some may.
struct Whole {
  const char *got = nullptr, *expected = nullptr;
};

/// A law of TissueModel, or another of its tables.
template <class T, class... Columns>
struct Table {
  using Rows = T;

  const char *name, *type, *row, *tissue;  ///< as Names has them
  T TissueModel::*of;                      ///< where it stands
  int version;                             ///< of the file format, the first that has it
  std::size_t most_rows;                   ///< in a file
  Whole whole;
  std::string (*words)(const T&);  ///< for describe(); empty where there is nothing to say
  const char* doc;
  std::tuple<Columns...> columns;
};

template <class T, class... Columns>
constexpr Table<T, Columns...> make_table(const Names& names, T TissueModel::*of, int version,
                                          std::size_t most_rows, const Whole& whole,
                                          std::string (*words)(const T&), const char* doc,
                                          Columns... columns) {
  return {names.table, names.type, names.row, names.tissue, of,          version,
          most_rows,   whole,      words,     doc,          {columns...}};
}

using Triple = std::array<double, 3>;

template <class T>
std::string count_rows(const T& table, std::size_t times, const char* noun) {
  return write_text(times * table.corners.size(), " ", noun, ", ");
}

template <class T>
std::string count_some(const T& table, const char* noun) {
  return table.corners.empty() ? "" : count_rows(table, 1, noun);
}

constexpr auto make_links(const Names& names, Links TissueModel::*of, Limit stiffness,
                          std::string (*words)(const Links&)) {
  return make_table(
      names, of, 1, 60'000, {}, words,
      "Pairs of particles that resist a change of distance: springs of the mass-spring model and "
      "bonds of the molecular model.",
      Corners<Links, 2>{"ends", &Links::ends, "particle indices, ends[l, 0] < ends[l, 1]"},
      Numbers<Links, double>{"rest_length", &Links::rest_length, "m", Limit::positive, 1e-9, 10.0,
                             ""},
      Numbers<Links, double>{"stiffness", &Links::stiffness, "N/m", stiffness, -1e12, 1e12,
                             "a bond's may be negative"},
      Numbers<Links, double>{"damping", &Links::damping, "N·s/m", Limit::not_negative, -1e9, 1e9,
                             ""});
}

inline constexpr auto kSprings = make_links(
    {"springs", "Links", "links", "mass-spring model"}, &TissueModel::springs, Limit::not_negative,
    [](const Links& links) { return write_text(links.ends.size(), " springs, "); });

inline constexpr auto kBonds =
    make_links({"bonds", "Links", "links", "molecular model"}, &TissueModel::bonds, Limit::finite,
               [](const Links& links) { return write_text(links.ends.size(), " bonds, "); });

inline constexpr auto kAngles = make_table(
    {"angles", "Angles", "triangles", "molecular model"}, &TissueModel::angles, 1, 40'000, {},
    +[](const Angles& angles) { return count_rows(angles, 3, "angles"); },
    "Triangles whose three corners resist a change of angle (molecular model, Eq 9 and 11). Row a "
    "is one triangle; column c belongs to its corner c, or to the side opposite corner c.",
    Corners<Angles, 3>{"corners", &Angles::corners, "particle indices"},
    Numbers<Angles, Triple>{"rest_cosine", &Angles::rest_cosine, "-", Limit::within_one, -1.0, 1.0,
                            "of the angle at the corner"},
    Numbers<Angles, Triple>{"rest_length", &Angles::rest_length, "m", Limit::positive, 1e-9, 10.0,
                            "of the side opposite the corner"},
    Numbers<Angles, Triple>{"bend_stiffness", &Angles::bend_stiffness, "J", Limit::finite, -1e9,
                            1e9, "K_theta of the corner, [N] under AngleLaw.eq10"},
    Numbers<Angles, Triple>{"stretch_coupling", &Angles::stretch_coupling, "N", Limit::finite, -1e9,
                            1e9, "K_btheta of the corner"},
    Numbers<Angles, Triple>{"bond_share", &Angles::bond_share, "N/m", Limit::finite, -1e12, 1e12,
                            "this triangle's part of the bond opposite the corner"});

inline constexpr auto kPrisms = make_table(
    {"prisms", "Prisms", "prisms", "walls that bend"}, &TissueModel::prisms, 2, 40'000,
    {"a tissue with prisms",
     "0: walls of prisms are moved whole, for what may sleep follows from how far springs carry a "
     "pull, which is not how far a wall bends"},
    +[](const Prisms& prisms) { return count_some(prisms, "prisms"); },
    "Triangular prisms of a wall that resist transverse shear, which is what makes a wall bend. "
    "Row p joins a triangle of the inner face to the one above it; column c is the side opposite "
    "corner c.",
    Corners<Prisms, 6>{"corners", &Prisms::corners,
                       "particles: three inner, then the three above them"},
    Numbers<Prisms, Triple>{"rest_difference", &Prisms::rest_difference, "m", Limit::finite, -10.0,
                            10.0, "first diagonal less the second"},
    Numbers<Prisms, Triple>{"shear_stiffness", &Prisms::shear_stiffness, "N/m", Limit::not_negative,
                            -1e12, 1e12, "of that difference"},
    Numbers<Prisms, Triple>{"shear_damping", &Prisms::shear_damping, "N·s/m", Limit::not_negative,
                            -1e9, 1e9, "likewise"});

inline constexpr auto kVolumes = make_table(
    {"volumes", "Volumes", "tetrahedra", "solids"}, &TissueModel::volumes, 2, 40'000,
    {"a tissue with volumes",
     "0: solids are moved whole, for they have no home springs, and without those a push is felt "
     "with one over its distance"},
    +[](const Volumes& volumes) { return count_some(volumes, "tetrahedra"); },
    "Tetrahedra that resist a change of volume, and with it being turned inside out. With J the "
    "volume over that at rest, the part 1 - nodal_share of each tetrahedron's bulk acts on its own "
    "J, the part nodal_share on the mean J around each of its particles.",
    Corners<Volumes, 4>{"corners", &Volumes::corners, "particle indices"},
    Numbers<Volumes, double>{"rest_volume", &Volumes::rest_volume, "m³", Limit::positive, 1e-20,
                             10.0, "positive"},
    Numbers<Volumes, double>{"bulk", &Volumes::bulk, "Pa", Limit::not_negative, -1e13, 1e13,
                             "lambda - mu: what springs leave to be done"},
    Derived<Volumes>{"first_around", &Volumes::first_around,
                     "of each particle in around, and the end, shape (n + 1,)"},
    Derived<Volumes>{"around", &Volumes::around,
                     "the rows around particle 0, those around 1, ... each ascending, shape (k,)"},
    Scalar<Volumes>{"nodal_share", &Volumes::nodal_share, "nodal_share", "-", Limit::share, 0.0,
                    1.0, "0 to 1"});

inline constexpr auto kElastic = make_table(
    // 6000: the response of a linear solid is solved for
    {"elastic", "Elastic", "tetrahedra", "linear solids, which have no other law"},
    &TissueModel::elastic, 3, 6000,
    {"a linear solid", "0: it costs what is touched, so there is nothing to let sleep"},
    +[](const Elastic& elastic) {
      return elastic.corners.empty() ? "" : "linear, " + count_some(elastic, "tetrahedra");
    },
    "Tetrahedra of a linear elastic solid, for shallow presses: constant strain and Hooke's law. "
    "The part nodal_share of lambda acts on the mean trace of the strain around each particle.",
    Corners<Elastic, 4>{"corners", &Elastic::corners, "particle indices"},
    Numbers<Elastic, double>{"lame", &Elastic::lame, "Pa", Limit::not_negative, -1e13, 1e13,
                             "lambda, Lamé's first constant"},
    Numbers<Elastic, double>{"shear", &Elastic::shear, "Pa", Limit::positive, 1e-6, 1e13, "mu"},
    Derived<Elastic>{"first_around", &Elastic::first_around, "as in Volumes, shape (n + 1,)"},
    Derived<Elastic>{"around", &Elastic::around, "as in Volumes, shape (k,)"},
    Particles<Elastic>{
        "reach", &Elastic::reach,
        "particles that pushes may move, ascending; empty for all that carry the surface"},
    Scalar<Elastic>{"nodal_share", &Elastic::nodal_share, "elastic_nodal_share", "-", Limit::share,
                    0.0, 1.0, "0 to 1"},
    Scalar<Elastic>{"damping_time", &Elastic::damping_time, "elastic_damping_time", "s",
                    Limit::not_negative, 0.0, 100.0,
                    "in which strain follows stress (Kelvin-Voigt)"});

constexpr auto make_hyperelastic(const Names& names, Hyperelastic TissueModel::*of,
                                 const char* share, const Whole& whole,
                                 std::string (*words)(const Hyperelastic&)) {
  return make_table(
      names, of, 5, 40'000, whole, words,
      "Tetrahedra of a solid that may be strained and turned far, of the corotated or the "
      "neo-Hookean law. The part nodal_share of lambda acts on the mean J around each particle.",
      Corners<Hyperelastic, 4>{"corners", &Hyperelastic::corners, "particle indices"},
      Numbers<Hyperelastic, double>{"lame", &Hyperelastic::lame, "Pa", Limit::not_negative, -1e13,
                                    1e13, "lambda, Lamé's first constant"},
      Numbers<Hyperelastic, double>{"shear", &Hyperelastic::shear, "Pa", Limit::positive, 1e-6,
                                    1e13, "mu"},
      Numbers<Hyperelastic, double>{"viscosity", &Hyperelastic::viscosity, "Pa·s",
                                    Limit::not_negative, -1e9, 1e9,
                                    "eta: 2 eta times the rate of Green's strain"},
      Derived<Hyperelastic>{"first_around", &Hyperelastic::first_around,
                            "as in Volumes, shape (n + 1,)"},
      Derived<Hyperelastic>{"around", &Hyperelastic::around, "as in Volumes, shape (k,)"},
      Scalar<Hyperelastic>{"nodal_share", &Hyperelastic::nodal_share, share, "-", Limit::share, 0.0,
                           1.0, "0 to 1"});
}

inline constexpr auto kCorotated = make_hyperelastic(
    {"corotated", "Hyperelastic", "tetrahedra", "corotated solids"}, &TissueModel::corotated,
    "corotated_nodal_share",
    {"a corotated solid",
     "0: solids are moved whole, for they have no home springs, and without those a push is felt "
     "with one over its distance"},
    [](const Hyperelastic& its) {
      return its.corners.empty() ? std::string() : "corotated, " + count_some(its, "tetrahedra");
    });

inline constexpr auto kNeoHookean = make_hyperelastic(
    {"neo_hookean", "Hyperelastic", "tetrahedra", "neo-Hookean solids"}, &TissueModel::neo_hookean,
    "neo_hookean_nodal_share",
    {"a neo-Hookean solid",
     "0: solids are moved whole, for they have no home springs, and without those a push is felt "
     "with one over its distance"},
    [](const Hyperelastic& its) {
      return its.corners.empty() ? std::string() : "neo-Hookean, " + count_some(its, "tetrahedra");
    });

inline constexpr auto kMaxwell = make_table(
    {"maxwell", "Maxwell", "numbers", "what of links and angles relaxes"}, &TissueModel::maxwell, 4,
    0, {"a tissue that relaxes", "0: what relaxes is moved whole, for it is never quite at rest"},
    +[](const Maxwell& maxwell) {
      return maxwell.ratio == 0.0
                 ? std::string()
                 : write_text("relaxing by ", 100.0 * maxwell.ratio / (1.0 + maxwell.ratio),
                              " % in ", maxwell.time, " s, ");
    },
    "Linear viscoelasticity: beside every spring, bond, angle and stretch-bend a Maxwell branch of "
    "ratio times its stiffness, whose force fades with time while the tissue holds still.",
    Scalar<Maxwell>{"ratio", &Maxwell::ratio, "maxwell_ratio", "-", Limit::not_negative, 0.0, 100.0,
                    "k_v/k, 0 for none"},
    Scalar<Maxwell>{"time", &Maxwell::time, "maxwell_time", "s", Limit::positive, 1e-4, 1e4,
                    "tau, in which 63 % of the branch's force has faded"});

/// Every law, in the sequence in which forces are summed.
inline constexpr std::tuple kLaws{kSprings, kBonds,     kAngles,     kPrisms, kVolumes,
                                  kElastic, kCorotated, kNeoHookean, kMaxwell};

/// How many members an aggregate has.
struct AnyMember {
  template <class T>
  operator T() const;
};
template <class T, class... Members>
consteval std::size_t count_members() {
  if constexpr (requires { T{Members()..., AnyMember()}; }) {
    return count_members<T, Members..., AnyMember>();
  } else {
    return sizeof...(Members);
  }
}
// beside the laws: particles, mass, fixed, skin, home, pressure, triangles, drag, two choices
static_assert(count_members<TissueModel>() == std::tuple_size_v<decltype(kLaws)> + 10,
              "a table of TissueModel that kLaws does not have");

/// No law, but a table like them.
inline constexpr auto kSkin = make_table(
    {"skin", "Skin", "vertices", "solids under a finer surface"}, &TissueModel::skin, 2, 20'000, {},
    +[](const Skin& skin) {
      return skin.corners.empty() ? ""
                                  : write_text("a skin of ", skin.corners.size(), " vertices, ");
    },
    "How a fine surface rides on coarse tetrahedra: vertex v is at the sum over k of weights[v, k] "
    "times the position of particle corners[v, k]. Empty where the particles themselves are the "
    "surface.",
    Corners<Skin, 4>{"corners", &Skin::corners, "particle indices"},
    Numbers<Skin, std::array<double, 4>>{"weights", &Skin::weights, "-", Limit::finite, -1e3, 1e3,
                                         "sum 1; below 0 outside of the tetrahedron"});

/// visit(table) for every law.
template <class Visit>
constexpr void for_each_law(Visit visit) {
  std::apply([&](const auto&... table) { (visit(table), ...); }, kLaws);
}

/// visit(table) for every law and the skin.
template <class Visit>
constexpr void for_each_table(Visit visit) {
  for_each_law(visit);
  visit(kSkin);
}

/// visit(column) for every column and number of a table, each of the types above.
template <class SomeTable, class Visit>
constexpr void for_each_column(const SomeTable& table, Visit visit) {
  std::apply([&](const auto&... column) { (visit(column), ...); }, table.columns);
}

/// Visitors that take some of the types above and leave out the rest.
template <class... Visits>
struct Overloaded : Visits... {
  using Visits::operator()...;
};
template <class... Visits>
Overloaded(Visits...) -> Overloaded<Visits...>;

/// Whether a table is numbers alone, without rows.
template <class SomeTable>
inline constexpr bool is_numbers = !requires(const SomeTable& table) {
  std::get<0>(table.columns).rows;
};

/// How many rows a table has: those of its first column.
template <class SomeTable>
std::size_t count_rows(const TissueModel& model, const SomeTable& table) {
  if constexpr (is_numbers<SomeTable>) {
    return 0;
  } else {
    return ((model.*table.of).*std::get<0>(table.columns).rows).size();
  }
}

/// Whether a model has this law: rows, or a first number that is not 0.
template <class SomeTable>
bool is_present(const TissueModel& model, const SomeTable& table) {
  if constexpr (is_numbers<SomeTable>) {
    return (model.*table.of).*std::get<0>(table.columns).value != 0.0;
  } else {
    return count_rows(model, table) > 0;
  }
}

}  // namespace palpate::laws
