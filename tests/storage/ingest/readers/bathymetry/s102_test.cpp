#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/s100_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::s102_test {
namespace {

constexpr float fill = 1'000'000.0F;

class S102 : public StoreFixture {
 protected:
  ocean::Bathymetry stored(const std::filesystem::path& file) {
    const IngestReport report = ingest(file);
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    if (!report.dataset) throw std::runtime_error{"nothing was stored"};
    return repository::FieldRepository{db_}
        .load_bathymetry(report.dataset->id, {-180.0, -90.0, 180.0, 90.0})
        .value();
  }
};

TEST_F(S102, IsStoredPositiveDownAndShoalerByItsUncertainty) {
  const ocean::Bathymetry bed =
      stored(s102_sample({10.0F, 20.0F, fill, 40.0F, -1.5F, 60.0F}, 2.0F).write(path("102.h5")));
  ASSERT_EQ(bed.depth_m().size(), 6U);
  EXPECT_EQ(bed.depth_m()[0], 10.0F);
  EXPECT_EQ(bed.shoalest_m()[0], 8.0F);
  EXPECT_TRUE(std::isnan(bed.depth_m()[2]));
  EXPECT_EQ(bed.depth_m()[4], -1.5F) << "land";
  EXPECT_EQ(bed.depth_m()[5], 60.0F);
  EXPECT_NEAR(bed.grid().place(0, 0).lat_deg, 47.0, 1e-9) << "the first row is the southernmost";
}

TEST_F(S102, InAnotherUnitIsConvertedOrRefused) {
  S100Sample sample = s102_sample({10.0F, 20.0F, 30.0F, 40.0F, 50.0F, 60.0F}, 1.0F);
  sample.values[0].unit = "fathoms";
  EXPECT_NEAR(stored(sample.write(path("fathoms.h5"))).depth_m()[0], 18.288, 1e-4);
  sample.values[0].unit = "knots";
  expect_refused(sample.write(path("knots.h5")), "unit \"knots\"");
}

TEST_F(S102, OfSeveralRecordsIsRefused) {
  S100Sample sample = s102_sample({10.0F, 20.0F, 30.0F, 40.0F, 50.0F, 60.0F}, 1.0F);
  sample.records.push_back(sample.records.front());
  expect_refused(sample.write(path("two.h5")), "2 records of depths");
}

/// Depth and uncertainty of node [row][column] as h5py 3 reads them.
TEST_F(S102, OfTheIhoReadsAsAnIndependentReaderDoes) {
  const auto file = sample_folder() / "s100/102US005MIACB252257.h5";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the sample file is not here";
  const ocean::Bathymetry bed = stored(file);
  const std::size_t columns = bed.grid().x().size();
  ASSERT_EQ(columns, 1909U);
  ASSERT_EQ(bed.grid().y().size(), 2104U);
  EXPECT_NEAR(bed.grid().x()[1500], 581155.7290326257, 1e-6);
  EXPECT_NEAR(bed.grid().y()[300], 2846616.523451329, 1e-6);
  EXPECT_FLOAT_EQ(bed.depth_m()[300 * columns + 1500], 3.14F);
  EXPECT_FLOAT_EQ(bed.shoalest_m()[300 * columns + 1500], 3.14F - 1.08F);
  EXPECT_FLOAT_EQ(bed.depth_m()[2000 * columns + 100], 5.15F);
  EXPECT_TRUE(std::isnan(bed.depth_m()[1000 * columns + 900]));
  std::size_t known = 0;
  for (const float depth_m : bed.depth_m()) known += std::isnan(depth_m) ? 0U : 1U;
  EXPECT_EQ(known, 1'242'492U);
}

}  // namespace
}  // namespace floeplan::ingest::s102_test
