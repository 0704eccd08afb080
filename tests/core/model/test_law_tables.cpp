// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <limits>
#include <set>
#include <string>

#include "palpate/sim/model/private/law_tables.h"
#include "scenes/hyperelastic_solids.h"
#include "scenes/linear_solids.h"
#include "scenes/shells.h"
#include "scenes/solids.h"

using namespace palpate;

namespace {

/// A tissue that has the law, by the name of its table.
template <class Law>
TissueModel make_tissue(const Law& law) {
  TissueModel relaxing = scenes::make_spring_organ(1);
  relaxing.maxwell = {.ratio = 0.5, .time = 0.3};
  for (const TissueModel& model :
       {scenes::make_spring_organ(1), scenes::make_molecular_organ(1), scenes::make_shell_organ(1),
        scenes::make_solid_organ(2, 0.9), scenes::make_linear_organ(2, 0.9),
        scenes::make_finite_organ(scenes::kFiniteLaws[0], 2, 0.9),
        scenes::make_finite_organ(scenes::kFiniteLaws[1], 2, 0.9), relaxing}) {
    if (laws::is_present(model, law)) return model;
  }
  FAIL("no tissue here has the law ", law.name);
  return {};
}

std::string refuse(const TissueModel& model) {
  try {
    validate(model);
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "";
}

/// A number that the limit does not allow.
double find_wrong(laws::Limit limit) {
  switch (limit) {
    case laws::Limit::positive:
      return 0.0;
    case laws::Limit::not_negative:
      return -1.0;
    case laws::Limit::within_one:
      return 1.0;
    case laws::Limit::share:
      return 1.5;
    case laws::Limit::finite:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

double& first_of(double& number) { return number; }
template <std::size_t N>
double& first_of(std::array<double, N>& row) {
  return row[0];
}

}  // namespace

TEST_CASE("every column of every law is refused by name where its rows are too few") {
  laws::for_each_law([]<class Law>(const Law& law) {
    using T = typename Law::Rows;
    laws::for_each_column(law,
                          laws::Overloaded{[&]<class Row>(const laws::Numbers<T, Row>& column) {
                                             TissueModel model = make_tissue(law);
                                             ((model.*law.of).*column.rows).pop_back();
                                             const std::string where =
                                                 write_text("model: ", law.name, ".", column.name);
                                             CHECK(refuse(model).find(where + ": got ") == 0);
                                           },
                                           [](const auto&) {}});
  });
}

TEST_CASE("every number of every law is refused by name where its limit does not allow it") {
  laws::for_each_law([]<class Law>(const Law& law) {
    using T = typename Law::Rows;
    laws::for_each_column(
        law, laws::Overloaded{
                 [&]<class Row>(const laws::Numbers<T, Row>& column) {
                   for (const double wrong :
                        {find_wrong(column.limit), std::numeric_limits<double>::quiet_NaN()}) {
                     TissueModel model = make_tissue(law);
                     first_of(((model.*law.of).*column.rows)[1]) = wrong;
                     const std::string where =
                         write_text("model: ", law.name, ".", column.name, ": row 1: got ", wrong);
                     CHECK(refuse(model).find(where) == 0);
                   }
                 },
                 [&](const laws::Scalar<T>& number) {
                   for (const double wrong :
                        {find_wrong(number.limit), std::numeric_limits<double>::quiet_NaN()}) {
                     TissueModel model = make_tissue(law);
                     (model.*law.of).*number.value = wrong;
                     const std::string where =
                         write_text("model: ", law.name, ".", number.name, ": got ", wrong);
                     CHECK(refuse(model).find(where) == 0);
                   }
                 },
                 [](const auto&) {}});
  });
}

TEST_CASE(
    "a row of any law that joins a particle with itself, or one that is not there, is refused") {
  laws::for_each_law([]<class Law>(const Law& law) {
    using T = typename Law::Rows;
    laws::for_each_column(
        law, laws::Overloaded{[&]<std::size_t N>(const laws::Corners<T, N>& column) {
                                TissueModel model = make_tissue(law);
                                auto& row = ((model.*law.of).*column.rows)[1];
                                const auto good = row;
                                const std::string where = write_text("model: ", law.name, ".",
                                                                     column.name, ": row 1: got ");
                                row[N - 1] = row[0];
                                CHECK(refuse(model).find(where) == 0);
                                row = good;
                                row[N - 1] = particle_count(model);
                                CHECK(refuse(model).find(where) == 0);
                                row = good;
                                row[0] = -1;
                                CHECK(refuse(model).find(where) == 0);
                              },
                              [](const auto&) {}});
  });
}

TEST_CASE("names of laws, of their columns and of their numbers in a file are each given once") {
  std::set<std::string> tables, fields;
  laws::for_each_table([&]<class Table>(const Table& table) {
    CHECK(tables.insert(table.name).second);
    std::set<std::string> columns;
    laws::for_each_column(table, [&](const auto& column) {
      CHECK(columns.insert(column.name).second);
      if constexpr (requires { column.field; }) CHECK(fields.insert(column.field).second);
    });
  });
  CHECK(tables.size() == std::tuple_size_v<decltype(laws::kLaws)> + 1);
}

TEST_CASE("a linear solid stands beside no other law") {
  laws::for_each_law([]<class Law>(const Law& law) {
    if constexpr (!std::is_same_v<typename Law::Rows, Elastic>) {
      TissueModel model = scenes::make_linear_organ(2, 0.9);
      TissueModel other = make_tissue(law);
      other.elastic = model.elastic;
      other.rest_position = model.rest_position;
      other.mass = model.mass;
      model.*law.of = other.*law.of;
      const std::string refusal = refuse(model);
      CHECK(refusal.find("model: ") == 0);  // of the law's own rows, or beside the solid
    }
  });
  TissueModel model = scenes::make_linear_organ(2, 0.9);
  model.maxwell.ratio = 0.5;
  CHECK(refuse(model) == "model: elastic: got maxwell beside it, expected no other law");
}

TEST_CASE("relaxation beside tetrahedra at finite strain, which do not relax, is refused") {
  for (const scenes::FiniteLaw& law : scenes::kFiniteLaws) {
    TissueModel model = scenes::make_finite_organ(law, 2, 0.9);
    CHECK(refuse(model).empty());
    model.maxwell.ratio = 0.5;
    CHECK(refuse(model).find("got maxwell beside it, expected a ratio of 0: tetrahedra at finite "
                             "strain do not relax") != std::string::npos);
  }
}
