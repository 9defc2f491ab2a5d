#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "engine/core/utc_text.hpp"
#include "storage/repository/fields/field_repository.hpp"
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

/// A value of a mesh at one of its own points and levels, as netCDF4-python reads it; the depth by the file's own formula.
struct OwnValue {
  std::string file;  // beside the sample folder
  std::string time;
  geo::LonLat place;
  double depth_m;
  double east_m_s;
  double north_m_s;
};

TEST_F(ModelSamples, OfMeshesHaveTheModelsOwnValuesAtItsPoints) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const std::string cases = "../cases/16-mesh-models-refused/";
  const std::string adcirc = cases + "adcirc_fort64.nc";       // at nodes, no depths
  const std::string schism = cases + "schism_hvel.nc";         // at nodes, a table of depths
  const std::string delft = cases + "delft3dfm_sigma_map.nc";  // in faces, sigma in faces
  const std::string fvcom = "currents/test_leofs_fvcom.nc";    // in faces, sigma at nodes
  const std::vector<OwnValue> known{
      {adcirc, "2026-03-01T12:00:00Z", {-9.0, 54.0}, 0.0, 0.22499999999999998, 0.0},
      {adcirc, "2026-03-01T12:00:00Z", {-9.75, 53.25}, 0.0, 0.1875, -0.037500000000000006},
      {adcirc, "2026-03-01T12:00:00Z", {-9.5, 50.5}, 0.0, 0.19999999999999998, -0.17500000000000002},
      {adcirc, "2026-03-01T00:00:00Z", {-9.75, 53.5}, 0.0, 0.1875, -0.024999999999999994},
      {schism, "2026-03-01T00:00:00Z", {-7.75, 53.5}, 100.0, 0.08749999850988388, -0.02500000037252903},
      {schism, "2026-03-01T00:00:00Z", {-7.0, 54.0}, 50.0, 0.22499999403953552, 0.0},
      {schism, "2026-03-01T12:00:00Z", {-8.75, 52.5}, 100.0, 0.03750000149011612, -0.07500000298023224},
      {schism, "2026-03-01T00:00:00Z", {-7.5, 52.0}, 50.0, 0.20000000298023224, -0.10000000149011612},
      {delft,
       "2026-03-01T12:00:00Z",
       {-6.333333333333333, 52.833333333333336},
       60.0,
       0.3583333194255829,
       -0.05833333358168602},
      {delft,
       "2026-03-01T12:00:00Z",
       {-6.416666666666667, 51.666666666666664},
       60.0,
       0.3541666567325592,
       -0.11666666716337204},
      {delft,
       "2026-03-01T00:00:00Z",
       {-5.583333333333333, 51.583333333333336},
       100.0,
       0.3958333432674408,
       -0.12083332985639572},
      {delft,
       "2026-03-01T12:00:00Z",
       {-6.666666666666667, 52.666666666666664},
       20.0,
       0.34166666865348816,
       -0.06666667014360428},
      {fvcom,
       "2022-07-20T18:00:00Z",
       {278.2269287109375, 42.3978157043457},
       7.413427462452091,
       -0.00495147705078125,
       0.006649017333984375},
      {fvcom,
       "2022-07-20T18:00:00Z",
       {280.6673889160156, 42.499183654785156},
       6.569735489372391,
       0.02338409423828125,
       0.01284027099609375},
      {fvcom,
       "2022-07-20T18:00:00Z",
       {279.86334228515625, 42.53085708618164},
       8.278295633534434,
       -0.02864837646484375,
       0.007294654846191406},
      {fvcom,
       "2022-07-20T18:00:00Z",
       {279.60406494140625, 42.36445999145508},
       16.5135977815371,
       -0.0880584716796875,
       0.02524566650390625},
  };
  std::map<std::string, repository::DatasetId> ids;
  for (const OwnValue& value : known) {
    if (!std::filesystem::exists(sample_folder() / value.file))
      GTEST_SKIP() << value.file << " is not on this machine";
    if (!ids.contains(value.file)) {
      const auto report = ingest(sample_folder() / value.file);
      ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
      ids.emplace(value.file, report.dataset->id);
    }
    const auto [lon_deg, lat_deg] = value.place;
    const auto currents = repository::FieldRepository{db_}.load_currents(
        ids.at(value.file), {lon_deg, lat_deg, lon_deg, lat_deg}, std::nullopt, std::nullopt);
    ASSERT_TRUE(currents.has_value()) << value.file;
    const auto water = currents->at(value.place, {value.depth_m}, core::parse_iso8601(value.time).value());
    ASSERT_TRUE(water.has_value()) << value.file << " " << lon_deg << " " << lat_deg << " " << value.depth_m;
    EXPECT_NEAR(water->east.value, value.east_m_s, 1e-6)
        << value.file << " " << lon_deg << " " << value.depth_m;
    EXPECT_NEAR(water->north.value, value.north_m_s, 1e-6)
        << value.file << " " << lon_deg << " " << value.depth_m;
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
