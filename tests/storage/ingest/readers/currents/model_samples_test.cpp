#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "engine/core/utc_text.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::model_samples_test {
namespace {

/// One current of a model's output, brought to a centre of its grid and to east and north with numpy and
/// netCDF4-python: means of the two points beside the centre, the angle from the mesh file or the file's own, the depth
/// from the formula of its levels.
struct KnownCurrent {
  std::string files;  // below the sample folder's currents, separated by a blank
  std::string time;
  geo::LonLat place;
  double depth_m;
  double east_m_s;
  double north_m_s;
  double tolerance_m_s;
};

class ModelSamples : public StoreFixture {
 protected:
  const ocean::CurrentGrid& sample(const std::string& names) {
    if (const auto known = grids_.find(names); known != grids_.end()) return known->second;
    std::vector<std::filesystem::path> files;
    std::istringstream words_of{names};
    for (std::string name; words_of >> name;) files.push_back(sample_folder() / "currents" / name);
    return grids_.emplace(names, currents_of(ingest_together(files))).first->second;
  }

 private:
  std::map<std::string, ocean::CurrentGrid> grids_;
};

TEST_F(ModelSamples, HoldTheCurrentsThatAnotherReaderSees) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const std::string orca = "ORCA025-N06_20000104d05U_sub.nc ORCA025-N06_20000104d05V_sub.nc";
  const std::string access = "access-om2-01_u.nc access-om2-01_v.nc";
  const std::string nordic = "Nordic_subset.nc";
  const std::string fjord = "ladim_forcing.nc";
  const std::string arctic = "arctic20km_polarstereo_sub.nc";
  const std::string lake = "test_leofs_fvcom.nc";
  const std::vector<KnownCurrent> known{
      {orca, "2000-01-02T12:00:00Z", {-13.418766, 56.901917}, 0.5058, 0.164074, 0.070807, 0.02},
      {orca, "2000-01-02T12:00:00Z", {-6.710742, 61.069267}, 0.5058, 0.058333, -0.004468, 0.02},
      {orca, "2000-01-02T12:00:00Z", {-13.338808, 64.444435}, 6.5430, -0.011039, -0.063406, 0.02},
      {nordic, "2016-02-02T12:00:00Z", {13.340858, 67.356484}, 0.0, -0.089266, 0.138955, 0.02},
      {nordic, "2016-02-03T12:00:00Z", {13.898307, 67.669109}, 50.0, -0.188249, -0.022080, 0.03},
      {nordic, "2016-02-04T12:00:00Z", {13.000055, 67.383120}, 200.0, -0.026214, -0.029849, 0.02},
      {fjord, "2015-09-07T02:00:00Z", {5.674508, 59.028714}, 10.0, 0.145405, -0.017254, 0.02},
      {arctic, "2016-02-01T12:00:00Z", {8.292149, 72.683128}, 0.0, 0.021285, -0.042859, 0.02},
      {arctic, "2016-02-03T12:00:00Z", {-0.453239, 72.261353}, 25.0, 0.036582, 0.029831, 0.02},
      {arctic, "2016-02-02T12:00:00Z", {24.309933, 73.084023}, 0.0, 0.041567, 0.042748, 0.02},
      {access,
       "1950-01-01T12:00:00Z",
       {112.6, -64.26596910349781},
       0.5412807653916101,
       -0.25244138,
       0.0075778957,
       1e-6},
      {access,
       "1950-01-03T12:00:00Z",
       {113.6, -63.960356076159165},
       4.331521485149508,
       0.009273528,
       -0.0201416,
       1e-6},
  };
  for (const KnownCurrent& current : known) {
    const auto water =
        sample(current.files).at(current.place, {current.depth_m}, core::parse_iso8601(current.time).value());
    ASSERT_TRUE(water.has_value()) << current.files << " " << current.place.lon_deg;
    EXPECT_NEAR(water->east.value, current.east_m_s, current.tolerance_m_s)
        << current.files << " " << current.place.lon_deg;
    EXPECT_NEAR(water->north.value, current.north_m_s, current.tolerance_m_s)
        << current.files << " " << current.place.lon_deg;
  }
}

TEST_F(ModelSamples, AMeshFileGivenWithTheComponentsIsReadWithThem) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const auto folder = sample_folder() / "currents";
  const auto report =
      ingest_together({folder / "ORCA025_coordinates_sub.nc", folder / "ORCA025-N06_20000104d05V_sub.nc",
                       folder / "ORCA025-N06_20000104d05U_sub.nc"});

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.file,
            "ORCA025-N06_20000104d05V_sub.nc + ORCA025-N06_20000104d05U_sub.nc + ORCA025_coordinates_sub.nc");
}

}  // namespace
}  // namespace floeplan::ingest::model_samples_test
