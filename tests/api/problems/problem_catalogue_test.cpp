#include "api/problems/problem_catalogue.hpp"

#include <gmock/gmock.h>

#include <set>

#include "tests/support/golden.hpp"

namespace floeplan::problems::problem_catalogue_test {
namespace {

TEST(Problems, AreListed) {
  std::string text;
  for (const ProblemKind& kind : problem_kinds) {
    text += std::to_string(kind.status) + ' ' + std::string{kind.slug()} + ": " + std::string{kind.title} +
            "\n  " + messages::example_of(kind.words()).text + '\n';
  }
  support::expect_golden("problems.txt", text);
}

TEST(Problems, HaveOneKindForACode) {
  std::set<std::string_view> codes;
  for (const ProblemKind& kind : problem_kinds) EXPECT_TRUE(codes.insert(kind.code).second) << kind.code;
}

TEST(Problems, ThatShareATypeShareItsTitle) {
  for (const ProblemKind& kind : problem_kinds) {
    for (const ProblemKind& other : problem_kinds) {
      if (kind.slug() == other.slug()) {
        EXPECT_EQ(kind.title, other.title) << kind.code << " and " << other.code;
      }
    }
  }
}

TEST(Problems, AreFaultsOfTheClientOrOfTheServer) {
  for (const ProblemKind& kind : problem_kinds) {
    EXPECT_GE(kind.status, 400) << kind.code;
    EXPECT_LT(kind.status, 600) << kind.code;
  }
}

TEST(Problem, TellsItsValuesAndFaults) {
  const Problem problem = problems::problem<"unknown-dataset">("ice-{1}").with({{"/ice", "is not stored"}});

  EXPECT_EQ(problem.status, 404);
  EXPECT_EQ(problem.slug, "unknown-dataset");
  EXPECT_EQ(problem.detail, "No dataset has the id ice-{1}.");
  EXPECT_EQ(problem.violations, (core::Violations{{"/ice", "is not stored"}}));
}

}  // namespace
}  // namespace floeplan::problems::problem_catalogue_test
