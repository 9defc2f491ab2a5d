#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <ostream>

#include "engine/core/utc_text.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::real_files_test {
namespace {

using testing::HasSubstr;

const geo::BoundingBox whole_world{-180.0, -90.0, 180.0, 90.0};

/// What is expected of one sample file.
struct Sample {
  std::string file;     // below the sample folder
  std::string outcome;  // "stored", or a fragment of the reason for the refusal
  std::string start;    // first and last time of what was stored
  std::string end;
  std::int64_t rows{};
  std::string warning;  // a fragment that must be among the warnings
  std::optional<std::string> positive;
  std::optional<repository::DatasetKind> kind{};  // of a file that holds several
};

void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.file; }

class SampleFile : public StoreFixture, public testing::WithParamInterface<Sample> {};

TEST_P(SampleFile, IsStoredOrRefusedAsItsContentDemands) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const Sample& sample = GetParam();
  const auto file = sample_folder() / sample.file;
  const IngestOptions options{.name = {}, .kind = sample.kind, .crs = {}, .positive = sample.positive};
  if (sample.outcome != "stored") {
    expect_refused(file, sample.outcome, options);
    return;
  }

  const auto report = ingest(file, options);

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->rows_accepted, sample.rows);
  EXPECT_EQ(report.dataset->time_start ? core::iso8601(*report.dataset->time_start) : "", sample.start);
  EXPECT_EQ(report.dataset->time_end ? core::iso8601(*report.dataset->time_end) : "", sample.end);
  EXPECT_THAT(words(report), HasSubstr(sample.warning));
  EXPECT_EQ(ingest(file, options).status, IngestStatus::unchanged);
}

INSTANTIATE_TEST_SUITE_P(
    Currents, SampleFile,
    testing::Values(
        Sample{"currents/cmems_global-analysis-forecast-phy-001-024.nc",
               "stored",
               "2020-01-07T00:30:00Z",
               "2020-01-07T02:30:00Z",
               43621,
               "",
               {}},
        Sample{"currents/gnome_gridded_current.nc",
               "stored",
               "2023-03-02T12:00:00Z",
               "2023-03-04T12:00:00Z",
               1352,
               "",
               {}},
        Sample{"currents/gofs_derived_hycom_packed_int16.nc",
               "stored",
               "2023-03-02T12:00:00Z",
               "2023-03-04T12:00:00Z",
               1352,
               "",
               {}},
        Sample{"currents/nrt_global_allsat_phy_l4_20190223_20190226.nc",
               "stored",
               "2019-02-23T00:00:00Z",
               "2019-02-23T00:00:00Z",
               1036800,
               "geostrophic",
               {}},
        Sample{"currents/wrt_reduced_weather.nc",
               "stored",
               "2023-07-20T10:00:00Z",
               "2023-07-21T13:00:00Z",
               144,
               "already include the tide",
               {},
               repository::DatasetKind::currents},
        Sample{"currents/test_hycom.nc", "only one component", "", "", 0, "", {}},
        Sample{"currents/ORCA025-N06_20000104d05U_sub.nc", "only one component", "", "", 0, "", {}},
        Sample{"currents/ORCA025-N06_20000104d05V_sub.nc", "only one component", "", "", 0, "", {}},
        Sample{
            "currents/ORCA025_coordinates_sub.nc", "no currents, depths, sea ice or wind", "", "", 0, "", {}},
        Sample{"currents/test_leofs_fvcom.nc",
               "stored",
               "2022-07-20T18:00:00Z",
               "2022-07-20T18:00:00Z",
               11509,
               "the faces of a mesh",
               {}},
        Sample{"currents/UGRIDv0.9_eleven_points_with_depth.nc",
               "stored",
               "2023-10-06T12:59:02Z",
               "2023-10-06T12:59:02Z",
               13,
               "the faces of a mesh",
               {}},
        Sample{"currents/access-om2-01_u.nc", "only one component", "", "", 0, "", {}},
        Sample{"currents/access-om2-01_v.nc", "only one component", "", "", 0, "", {}},
        Sample{"currents/t.x1_SAMOC_flux.169000.nc", "dimension \"k\"", "", "", 0, "", {}},
        Sample{"currents/20020101000000-GLOBCURRENT-L4-CUReul_hs-ALT_SUM-v02.0-fv01.0.nc",
               "no units",
               "",
               "",
               0,
               "",
               {}},
        Sample{"currents/20020102000000-GLOBCURRENT-L4-CUReul_hs-ALT_SUM-v02.0-fv01.0.nc",
               "no units",
               "",
               "",
               0,
               "",
               {}},
        Sample{"currents/cmems_derived_uv_latlon.grb2",
               "stored",
               "2020-01-07T00:30:00Z",
               "2020-01-07T00:30:00Z",
               43621,
               "",
               {}}));

INSTANTIATE_TEST_SUITE_P(
    Bathymetry, SampleFile,
    testing::Values(
        Sample{"bathymetry/topo_30min.nc", "stored", "", "", 259200, "can only be elevation", {}},
        Sample{"bathymetry/etopo60.cdf", "stored", "", "", 64800, "", {}},
        Sample{"bathymetry/wrt_reduced_depth.nc", "stored", "", "", 28800, "", {}},
        Sample{"bathymetry/emodnet_test.nc", "stored", "", "", 3840, "", {}},
        Sample{"bathymetry/F00788_SR_8m.tif", "stored", "", "", 32041, "", {}},
        Sample{"bathymetry/etopo20_derived_epsg3413_20km.tif", "stored", "", "", 9000, "", "up"},
        Sample{"bathymetry/nw_atlantic_etopo1_4min.xyz", "stored", "", "", 9706, "look like degrees", "up"},
        Sample{"bathymetry/wrt_depth_window.asc", "stored", "", "", 4800, "", "up"},
        Sample{"bathymetry/sample-2.0.1.bag", "stored", "", "", 10000, "", "up"},
        Sample{"bathymetry/etopo20_derived_epsg3413_20km.tif", "--positive", "", "", 0, "", {}},
        Sample{"bathymetry/nw_atlantic_etopo1_4min.xyz", "--positive", "", "", 0, "", {}},
        Sample{"bathymetry/wrt_depth_window.asc", "--positive", "", "", 0, "", {}},
        Sample{"bathymetry/sample-2.0.1.bag", "--positive", "", "", 0, "", {}},
        Sample{"bathymetry/wrt_depth_window.prj", "not recognised", "", "", 0, "", {}},
        Sample{"bathymetry/Sample_VR_BAG-gzip.bag", "stored", "", "", 10000, "", {}},
        Sample{"bathymetry/NZ52201_truncated.KAP", "picture of a chart", "", "", 0, "", {}},
        Sample{"bathymetry/s57/US4MD81M.000", "stored", "", "", 2226654, "3 updates were applied", {}},
        Sample{"bathymetry/s57/US4MD81M.001", "is an update of a chart", "", "", 0, "", {}}));

INSTANTIATE_TEST_SUITE_P(Icebergs, SampleFile,
                         testing::Values(Sample{"icebergs/IIP_2014IcebergSeason_a.csv",
                                                "stored",
                                                "2013-10-07T21:39:00Z",
                                                "2014-09-25T12:21:00Z",
                                                10146,
                                                "",
                                                {}},
                                         Sample{"icebergs/cis_beacon_1997_12995.csv",
                                                "stored",
                                                "1997-08-16T07:07:00Z",
                                                "1997-10-03T19:41:00Z",
                                                639,
                                                "line 641 was left out",
                                                {}},
                                         Sample{"icebergs/usnic_sample_rows.csv",
                                                "stored",
                                                "2026-08-27T00:00:00Z",
                                                "2026-08-27T00:00:00Z",
                                                5,
                                                "",
                                                {}},
                                         Sample{"icebergs/usnic_sample_rows_old_schema.csv",
                                                "stored",
                                                "2014-11-07T00:00:00Z",
                                                "2022-12-09T00:00:00Z",
                                                3,
                                                "",
                                                {}},
                                         Sample{"icebergs/byu_latest_20260818.json",
                                                "stored",
                                                "2026-07-30T00:00:00Z",
                                                "2026-08-16T00:00:00Z",
                                                38,
                                                "states no sizes",
                                                {}},
                                         Sample{"icebergs/byu_consol_v5/a01.csv",
                                                "stored",
                                                "1978-07-23T00:00:00Z",
                                                "1979-05-06T00:00:00Z",
                                                100,
                                                "does not name its iceberg",
                                                {}}));

INSTANTIATE_TEST_SUITE_P(
    Tides, SampleFile,
    testing::Values(
        Sample{"tides/noaa_anchorage-knik-arm.json", "stored", "", "", 1, "", {}},
        Sample{"tides/noaa_san-francisco-golden-gate.json", "stored", "", "", 1, "", {}},
        Sample{"tides/otps_tpxo9v2a_extract_HC_sample_out.txt", "stored", "", "", 3, "", {}},
        Sample{"tides/oce_noaa_harmonics_sample.tsv", "--unit", "", "", 0, "", {}},
        Sample{"tides/utide_HNL2010_coef_matlab.csv", "--at LON,LAT", "", "", 0, "", {}},
        Sample{"tides/otps_tpxo9v2a_predict_tide_sample_out.txt", "not recognised", "", "", 0, "", {}},
        Sample{"tides/roms_tidal_forcing_v3.zarr", "forcing of a ROMS model", "", "", 0, "", {}}));

INSTANTIATE_TEST_SUITE_P(ZarrStores, SampleFile,
                         testing::Values(Sample{"seaice/sic_daily_sample.zarr",
                                                "stored",
                                                "2021-01-09T00:00:00Z",
                                                "2021-01-09T00:00:00Z",
                                                4151520,
                                                "",
                                                {}}));

/// One node of a current file, read with netCDF4-python.
struct CurrentNode {
  std::string file;
  std::size_t time;
  double lon_deg;
  double lat_deg;
  std::optional<geo::VelocityEn> expected;  // empty: missing
};

class StoredCurrents : public StoreFixture {};

std::size_t nearest(const ocean::Axis& axis, double value) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < axis.size(); ++i)
    if (std::abs(axis[i] - value) < std::abs(axis[best] - value)) best = i;
  return best;
}

TEST_F(StoredCurrents, AreThoseThatAnotherReaderSees) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const auto velocity = [](double east, double north) { return geo::VelocityEn{{east}, {north}}; };
  const std::string cmems = "currents/cmems_global-analysis-forecast-phy-001-024.nc";
  const std::string gnome = "currents/gnome_gridded_current.nc";
  const std::string hycom = "currents/gofs_derived_hycom_packed_int16.nc";
  const std::string duacs = "currents/nrt_global_allsat_phy_l4_20190223_20190226.nc";
  const std::string baltic = "currents/wrt_reduced_weather.nc";
  const std::vector<CurrentNode> nodes{
      {cmems, 0, -51.0, -30.0, {}},
      {cmems, 2, -34.33333206176758, -21.66666603088379, velocity(0.051757812, 0.0029296875)},
      {cmems, 1, -41.0, -22.5, velocity(-0.41210938, -0.7216797)},
      {gnome, 0, -125.52001953125, 47.400001525878906, velocity(0.425, -0.129)},
      {gnome, 16, -125.67999267578125, 47.79999923706055, velocity(0.028, 0.035)},
      {gnome, 0, -123.91998291015625, 49.040000915527344, {}},
      {hycom, 0, 234.47998046875, 47.400001525878906, velocity(0.425, -0.129)},
      {hycom, 16, 234.32000732421875, 47.79999923706055, velocity(0.028, 0.035)},
      {duacs, 0, 25.125, 60.125, {}},
      {duacs, 0, 325.125, -39.875, velocity(0.3082, 0.2077)},
      {duacs, 0, 0.125, 0.125, velocity(-0.0551, -0.0799)},
      {baltic, 5, 13.494, 54.494, {}},
      {baltic, 9, 13.992, 54.992, velocity(-0.041348212906728424, -0.1005634027406321)},
      {baltic, 3, 13.66, 54.245, velocity(0.06172836805890493, -0.037251108496954205)},
  };
  std::map<std::string, ocean::CurrentGrid::Samples> files;
  for (const auto& name : {cmems, gnome, hycom, duacs, baltic}) {
    const auto report = ingest(sample_folder() / name, {.kind = repository::DatasetKind::currents});
    files.emplace(name, currents_of(report).samples());
  }

  for (const CurrentNode& node : nodes) {
    const auto& samples = files.at(node.file);
    const std::size_t x = nearest(samples.grid.x(), node.lon_deg);
    const std::size_t y = nearest(samples.grid.y(), node.lat_deg);
    EXPECT_NEAR(samples.grid.x()[x], node.lon_deg, 1e-9) << node.file;
    EXPECT_NEAR(samples.grid.y()[y], node.lat_deg, 1e-9) << node.file;
    const std::size_t i = (node.time * samples.grid.y().size() + y) * samples.grid.x().size() + x;
    if (!node.expected) {
      EXPECT_TRUE(std::isnan(samples.u[i])) << node.file;
      continue;
    }
    EXPECT_NEAR(samples.u[i], node.expected->east.value, 1e-7) << node.file;
    EXPECT_NEAR(samples.v[i], node.expected->north.value, 1e-7) << node.file;
  }
}

TEST_F(StoredCurrents, HaveAsManyValidValuesAsAnotherReaderSees) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const std::map<std::string, std::int64_t> expected{
      {"cmems_global-analysis-forecast-phy-001-024.nc", 83820},
      {"gnome_gridded_current.nc", 15096},
      {"gofs_derived_hycom_packed_int16.nc", 15096},
      {"nrt_global_allsat_phy_l4_20190223_20190226.nc", 584839},
      {"wrt_reduced_weather.nc", 960}};
  for (const auto& [name, count] : expected) {
    const auto report =
        ingest(sample_folder() / "currents" / name, {.kind = repository::DatasetKind::currents});
    const ocean::CurrentGrid::Samples samples = currents_of(report).samples();
    std::int64_t valid = 0;
    for (std::size_t i = 0; i < samples.u.size(); ++i)
      valid += std::isnan(samples.u[i]) || std::isnan(samples.v[i]) ? 0 : 1;
    EXPECT_EQ(valid, count) << name;
  }
}

/// One node of a bathymetry file, read with netCDF4-python or gdallocationinfo and placed with cs2cs.
struct DepthNode {
  std::string file;
  geo::LonLat place;
  double depth_m;
  double tolerance_m;
};

class StoredBathymetry : public StoreFixture {};

TEST_F(StoredBathymetry, IsThatWhichAnotherReaderSees) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const std::vector<DepthNode> nodes{
      {"topo_30min.nc", {-129.75, 10.25}, 4752.0, 0.0},
      {"topo_30min.nc", {-179.75, -89.75}, -2776.0, 0.0},
      {"topo_30min.nc", {179.75, 60.25}, 1932.0, 0.0},
      {"etopo60.cdf", {320.5, 30.5}, 3421.5833, 1e-3},
      {"etopo60.cdf", {20.5, -89.5}, -2814.3333, 1e-3},
      {"etopo60.cdf", {0.5, 60.5}, 133.9375, 1e-3},
      {"wrt_reduced_depth.nc", {2.004166666666663, 51.00416666666666}, 1.0, 1e-4},
      {"wrt_reduced_depth.nc", {2.42083333333332, 51.837500000000006}, 41.029057, 1e-4},
      {"emodnet_test.nc", {0.2187499999997179, 54.010937499998626}, 49.393, 1e-3},
      {"emodnet_test.nc", {0.11458333333305158, 54.10468749999854}, 48.333, 1e-3},
      {"nw_atlantic_etopo1_4min.xyz", {-50.0, 43.0}, 85.0, 1e-2},
      {"nw_atlantic_etopo1_4min.xyz", {-50.0, 42.0}, 3492.0, 0.5},
      {"etopo20_derived_epsg3413_20km.tif", {-50.992527447879, 73.3137534062824}, -2176.0, 0.01},
      {"etopo20_derived_epsg3413_20km.tif", {3.43363036245052, 70.5633122039917}, 3190.0, 0.01},
      {"F00788_SR_8m.tif", {-122.677644589006, 48.1503882893653}, 65.89882, 0.01},
      {"F00788_SR_8m.tif", {-122.671739550455, 48.1487161348445}, 51.89650, 0.01},
      {"wrt_depth_window.asc", {2.2541666666635, 52.4958333333135}, 42.570892, 1e-4},
  };
  std::map<std::string, ocean::Bathymetry> files;
  for (const DepthNode& node : nodes) {
    if (!files.contains(node.file)) {
      const auto report = ingest(sample_folder() / "bathymetry" / node.file,
                                 {.name = {}, .kind = {}, .crs = {}, .positive = "up"});
      ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
      files.emplace(
          node.file,
          repository::FieldRepository{db_}.load_bathymetry(report.dataset->id, whole_world).value());
    }
    const auto depth = files.at(node.file).depth(node.place);
    ASSERT_TRUE(depth.has_value()) << node.file << " " << node.place.lon_deg;
    EXPECT_NEAR(depth->value, node.depth_m, node.tolerance_m) << node.file << " " << node.place.lon_deg;
  }
}

TEST_F(StoredBathymetry, KeepsTheGridOfAPolarProjection) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const auto report = ingest(sample_folder() / "bathymetry/etopo20_derived_epsg3413_20km.tif",
                             {.name = {}, .kind = {}, .crs = {}, .positive = "up"});

  const auto sea = repository::FieldRepository{db_}.load_bathymetry(report.dataset->id, whole_world).value();

  EXPECT_EQ(sea.grid().frame(), (geo::GridFrame{geo::PolarStereographicFrame{.north = true,
                                                                             .lat_ts_deg = 70.0,
                                                                             .lon_0_deg = -45.0,
                                                                             .false_easting_m = 0.0,
                                                                             .false_northing_m = 0.0}}));
  EXPECT_EQ(sea.grid().x().front(), -390000.0);
  EXPECT_EQ(sea.grid().y().back(), -1410000.0);
}

class StoredIcebergs : public StoreFixture {};

TEST_F(StoredIcebergs, OfTheIcePatrolAreCountedByClassAsInTheTable) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  ASSERT_EQ(ingest(sample_folder() / "icebergs/IIP_2014IcebergSeason_a.csv").status, IngestStatus::stored);

  std::map<ocean::IcebergSize, int> count;
  for (const auto& row : repository::IcebergRepository{db_}.list({}, 0, 20000)) ++count[row.iceberg.size];

  using ocean::IcebergSize;
  const std::map<IcebergSize, int> expected{{IcebergSize::growler, 709},  {IcebergSize::bergy_bit, 70},
                                            {IcebergSize::small, 1543},   {IcebergSize::medium, 1683},
                                            {IcebergSize::large, 1100},   {IcebergSize::very_large, 184},
                                            {IcebergSize::unknown, 4848}, {IcebergSize::radar_target, 9}};
  EXPECT_EQ(count, expected);
}

class StoredRuns : public StoreFixture {};

/// By ncdump -v forecast_reference_time, 1454328000 s since 1970, and by GRIB_REF_TIME of gdalinfo.
TEST_F(StoredRuns, KnowWhenTheirModelRunBegan) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const IngestOptions currents{
      .name = {}, .kind = repository::DatasetKind::currents, .crs = {}, .positive = {}};
  const auto run_of = [&](const std::string& file) {
    const auto report = ingest(sample_folder() / "currents" / file, currents);
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    return repository::DatasetRepository{db_}.find(report.dataset->id)->run;
  };

  EXPECT_EQ(run_of("arctic20km_polarstereo_sub.nc"), core::parse_iso8601("2016-02-01T12:00:00Z"));
  EXPECT_EQ(run_of("cmems_derived_uv_latlon.grb2"), core::parse_iso8601("2020-01-07T00:30:00Z"));
  EXPECT_FALSE(run_of("cmems_global-analysis-forecast-phy-001-024.nc").has_value());
}

}  // namespace
}  // namespace floeplan::ingest::real_files_test
