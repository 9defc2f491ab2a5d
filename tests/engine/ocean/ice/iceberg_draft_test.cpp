#include "engine/ocean/ice/iceberg_draft.hpp"

#include <gtest/gtest.h>

namespace floeplan::ocean::iceberg_draft_test {
namespace {

Iceberg berg_of_length(double length_m) {
  Iceberg berg;
  berg.length = core::Metres{length_m};
  return berg;
}

TEST(IcebergDraft, IsTheStatedOneWhateverTheLength) {
  Iceberg berg = berg_of_length(200.0);
  berg.draft = core::Metres{61.0};

  EXPECT_EQ(safe_draft(berg).value, 61.0);
  EXPECT_EQ(drift_draft(berg).value, 61.0);
}

TEST(IcebergDraft, HasTheValuesOfTheRelations) {
  // Barker et al. 2004, C-CORE, Hotzel and Miller 1983, worked out by hand to the metre.
  EXPECT_NEAR(safe_draft(berg_of_length(60.0)).value, 53.0, 0.5);
  EXPECT_NEAR(drift_draft(berg_of_length(60.0)).value, 32.6, 0.5);
  EXPECT_NEAR(safe_draft(berg_of_length(120.0)).value, 87.1, 0.5);
  EXPECT_NEAR(drift_draft(berg_of_length(120.0)).value, 53.3, 0.5);
  EXPECT_NEAR(safe_draft(berg_of_length(300.0)).value, 137.4, 0.5);
}

TEST(IcebergDraft, GrowsWithTheLengthAndIsNeverLessThanTheOneOfTheDrift) {
  double last_m = 0.0;
  for (double length_m = 5.0; length_m < 1000.0; length_m += 1.0) {
    const double draft_m = safe_draft(berg_of_length(length_m)).value;
    EXPECT_GE(draft_m, last_m);
    EXPECT_GE(draft_m, drift_draft(berg_of_length(length_m)).value);
    last_m = draft_m;
  }
}

TEST(IcebergDraft, OfAnUnknownSizeIsThatOfAVeryLargeBerg) {
  EXPECT_EQ(safe_draft(Iceberg{}).value, safe_draft(berg_of_length(300.0)).value);
}

}  // namespace
}  // namespace floeplan::ocean::iceberg_draft_test
