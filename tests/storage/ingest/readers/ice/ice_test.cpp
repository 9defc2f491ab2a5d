#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/utc_text.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::ice_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A file of sea ice as test after test varies it: two days, two latitudes, three longitudes.
struct IceFile {
  std::string name{"siconc"};
  std::vector<double> values{0.0, 0.1, 0.2, 0.3, 0.4, 1.0, 0.0, 0.2, 0.4, 0.6, 0.8, 1.0};
  std::map<std::string, std::string> texts{{"standard_name", "sea_ice_area_fraction"}, {"units", "1"}};
  std::map<std::string, double> numbers{};
  std::map<std::string, std::vector<double>> lists{};
  std::optional<double> fill{};
  NetcdfWriter::Type type{NetcdfWriter::Type::float32};
  std::vector<NetcdfWriter::Variable> others{};
  bool with_time{true};

  void write(const std::filesystem::path& file) const {
    NetcdfWriter writer{file};
    std::vector<std::string> dimensions{"lat", "lon"};
    if (with_time) {
      writer.axis("time", {0.0, 24.0}, {{"units", "hours since 2026-11-20 00:00:00"}});
      dimensions.insert(dimensions.begin(), "time");
    }
    writer.axis("lat", {69.0, 70.0}, {{"units", "degrees_north"}});
    writer.axis("lon", {-54.0, -53.0, -52.0}, {{"units", "degrees_east"}});
    writer.variable({.name = name,
                     .dimensions = dimensions,
                     .values = values,
                     .texts = texts,
                     .numbers = numbers,
                     .fill = fill,
                     .type = type,
                     .lists = lists});
    for (NetcdfWriter::Variable other : others) {
      other.dimensions = dimensions;
      writer.variable(other);
    }
  }
};

NetcdfWriter::Variable another(const std::string& name, const std::map<std::string, std::string>& texts,
                               const std::vector<double>& values) {
  return {.name = name,
          .dimensions = {},
          .values = values,
          .texts = texts,
          .numbers = {},
          .fill = {},
          .type = NetcdfWriter::Type::float32};
}

class IceTest : public StoreFixture {
 protected:
  ocean::IceField::Samples stored(const IceFile& content, const IngestOptions& options = {}) {
    content.write(path("ice.nc"));
    return stored(path("ice.nc"), options);
  }
  ocean::IceField::Samples stored(const std::filesystem::path& file, const IngestOptions& options = {}) {
    report_ = ingest(file, options);
    EXPECT_EQ(report_.status, IngestStatus::stored) << words(report_);
    if (!report_.dataset) throw std::runtime_error{"nothing was stored"};
    EXPECT_EQ(report_.dataset->kind, repository::DatasetKind::ice);
    const auto field = repository::FieldRepository{db_}.load_ice(report_.dataset->id,
                                                                 {-180.0, -90.0, 180.0, 90.0}, std::nullopt);
    return field.value().samples();
  }
  void expect_refused_ice(const IceFile& content, const std::string& reason) {
    content.write(path("ice.nc"));
    expect_refused(path("ice.nc"), reason);
  }

  IngestReport report_;
};

std::vector<double> times(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

TEST_F(IceTest, SharesOfOneAreStoredAsTheyAre) {
  const auto samples = stored(IceFile{});

  EXPECT_FLOAT_EQ(samples.concentration[1], 0.1F);
  EXPECT_FLOAT_EQ(samples.concentration[11], 1.0F);
  EXPECT_TRUE(samples.thickness_m.empty());
  EXPECT_EQ(core::iso8601(*report_.dataset->time_start), "2026-11-20T00:00:00Z");
  EXPECT_EQ(core::iso8601(*report_.dataset->time_end), "2026-11-21T00:00:00Z");
  EXPECT_THAT(report_.dataset->variables, ElementsAre("siconc"));
  EXPECT_TRUE(report_.dataset->id.value.starts_with("ice-"));
  EXPECT_EQ(stored_datasets(), 1U);
}

TEST_F(IceTest, PercentAndTenthsBecomeSharesOfOne) {
  IceFile percent;
  percent.values = times(percent.values, 100.0);
  percent.texts["units"] = "%";
  EXPECT_FLOAT_EQ(stored(percent).concentration[4], 0.4F);

  IceFile tenths;
  tenths.values = times(tenths.values, 10.0);
  tenths.texts["units"] = "tenths";
  EXPECT_FLOAT_EQ(stored(tenths).concentration[4], 0.4F);
}

/// ERA5 writes its unit so.
TEST_F(IceTest, SharesMayBeStatedAsARange) {
  IceFile file;
  file.texts["units"] = "(0 - 1)";
  EXPECT_FLOAT_EQ(stored(file).concentration[4], 0.4F);
}

/// NOAA's OISST: hundredths that are scaled to shares, and "%".
TEST_F(IceTest, PercentWhoseGreatestValidValueIsOneAreShares) {
  IceFile file;
  file.values = times(file.values, 100.0);
  file.values[5] = file.values[11] = 96.0;
  file.texts["units"] = "%";
  file.type = NetcdfWriter::Type::int16;
  file.numbers = {{"scale_factor", 0.01}, {"valid_min", 0.0}, {"valid_max", 100.0}};
  EXPECT_FLOAT_EQ(stored(file).concentration[4], 0.4F);
  EXPECT_THAT(words(report_), HasSubstr("read as shares of 1"));

  file.numbers["valid_max"] = 10000.0;
  expect_refused_ice(file, "closed ice counts as open water");
}

/// GMT writes the ice maps of Bremen as a variable z that does not say what it is.
TEST_F(IceTest, AVariableThatTheUserNamesIsIceWhereIceIsAskedFor) {
  IceFile file;
  file.name = "z";
  file.texts = {};
  file.values = times(file.values, 100.0);
  file.write(path("ice.nc"));

  const auto samples = stored(path("ice.nc"), {.kind = repository::DatasetKind::ice, .variable = "z"});

  EXPECT_FLOAT_EQ(samples.concentration[4], 0.4F);
}

TEST_F(IceTest, AVariableThatSaysNothingOfItselfIsNotTakenForDepths) {
  {
    NetcdfWriter file{path("ice.nc")};
    file.axis("lat", {70.0, 70.1}, {{"units", "degrees_north"}});
    file.axis("lon", {-52.0, -51.9, -51.8}, {{"units", "degrees_east"}});
    file.variable({.name = "z",
                   .dimensions = {"lat", "lon"},
                   .values = {0.0, 35.5, 100.0, 80.0, 15.0, 0.0},
                   .texts = {{"long_name", "z"}},
                   .numbers = {},
                   .fill = {}});
  }

  expect_refused(path("ice.nc"), "If they are sea ice, give --kind ice --variable z");
  expect_refused(path("ice.nc"), "If \"z\" is one, give --variable z",
                 {.kind = repository::DatasetKind::ice});
}

TEST_F(IceTest, AThicknessAloneIsRefusedAsSuch) {
  IceFile file;
  file.name = "sea_ice_thickness";
  file.texts = {{"standard_name", "sea_ice_thickness"}, {"units", "m"}};
  expect_refused_ice(file, "thickness of sea ice but no concentration");
}

/// CryoSat-2 and SMOS merged: the analysis and the first guess that it began with.
TEST_F(IceTest, TheThicknessIsNeverTheFirstGuess) {
  IceFile file;
  file.others = {
      another("background_sea_ice_thickness", {{"standard_name", "sea_ice_thickness"}, {"units", "m"}},
              std::vector<double>(12, 9.0)),
      another("analysis_sea_ice_thickness", {{"standard_name", "sea_ice_thickness"}, {"units", "m"}},
              std::vector<double>(12, 2.0))};
  EXPECT_FLOAT_EQ(stored(file).thickness_m[3], 2.0F);
}

TEST_F(IceTest, WithoutAUnitOnlyValuesAbove1Point5TellPercent) {
  IceFile file;
  file.texts.erase("units");
  EXPECT_FLOAT_EQ(stored(file).concentration[5], 1.0F);
  EXPECT_THAT(words(report_), HasSubstr("read as shares of 1"));

  file.values = times(file.values, 100.0);
  EXPECT_FLOAT_EQ(stored(file).concentration[5], 1.0F);
  EXPECT_THAT(words(report_), HasSubstr("read as percent"));

  file.values.assign(12, 0.1);
  expect_refused_ice(file, "may be shares of 1 or percent");
  file.values.assign(12, 1.2);
  expect_refused_ice(file, "may be shares of 1 or percent");
}

TEST_F(IceTest, WithoutAUnitTheUserMayGiveIt) {
  IceFile file;
  file.texts.erase("units");
  file.values.assign(12, 0.1);
  EXPECT_FLOAT_EQ(stored(file, {.unit = "share"}).concentration[5], 0.1F);

  file.values.assign(12, 0.12);
  EXPECT_FLOAT_EQ(stored(file, {.unit = "percent"}).concentration[5], 0.0012F);
}

TEST_F(IceTest, AUnitOfTheUserThatTheValuesContradictIsRefused) {
  IceFile file;
  file.texts.erase("units");
  file.values.assign(12, 98.0);
  file.write(path("ice.nc"));

  const IngestReport report = ingest(path("ice.nc"), {.unit = "share"});

  EXPECT_EQ(report.status, IngestStatus::refused);
  EXPECT_THAT(words(report), HasSubstr("impossible for --unit share"));
}

TEST_F(IceTest, AUnitThatTheFileStatesIsNotOverruled) {
  EXPECT_FLOAT_EQ(stored(IceFile{}, {.unit = "percent"}).concentration[5], 1.0F);
}

TEST_F(IceTest, AUnitThatTheValuesContradictIsRefused) {
  IceFile file;
  file.texts["units"] = "1";
  file.values = times(file.values, 97.0);
  expect_refused_ice(file, "states the unit \"1\" but runs from 0 to 97");

  IceFile shares;
  shares.texts["units"] = "%";
  expect_refused_ice(shares, "as shares of 1 would");

  shares.texts["units"] = "kg m-2";
  expect_refused_ice(shares, "has the unknown unit");
}

TEST_F(IceTest, FlagsForLandCoastAndTheHoleRoundThePoleAreLeftOut) {
  IceFile file;
  file.type = NetcdfWriter::Type::int16;
  file.numbers = {{"scale_factor", 0.004}};
  file.values = {0.0, 251.0, 250.0, 253.0, 254.0, 255.0, 25.0, 50.0, 75.0, 100.0, 125.0, 150.0};
  file.lists = {{"flag_values", {251.0, 252.0, 253.0, 254.0, 255.0}}};
  file.texts["flag_meanings"] = "pole_hole_mask unused coast land missing_data";

  const auto samples = stored(file);

  EXPECT_FLOAT_EQ(samples.concentration[0], 0.0F);
  EXPECT_FLOAT_EQ(samples.concentration[2], 1.0F);
  EXPECT_FLOAT_EQ(samples.concentration[6], 0.1F);
  for (const std::size_t i : {1U, 3U, 4U, 5U}) EXPECT_TRUE(std::isnan(samples.concentration[i])) << i;
  EXPECT_THAT(words(report_), HasSubstr("4 values of \"siconc\" stand for land"));
}

TEST_F(IceTest, TheFillIsComparedBeforeScaleAndOffset) {
  IceFile file;
  file.type = NetcdfWriter::Type::int16;
  file.fill = -32767.0;
  file.numbers = {{"scale_factor", 3.814813680946827e-05}, {"add_offset", -3.814813680946827e-05}};
  file.values = {1.0, -32767.0, 26215.0, 0.0, 13108.0, 2.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};

  const auto samples = stored(file);

  EXPECT_FLOAT_EQ(samples.concentration[0], 0.0F);
  EXPECT_TRUE(std::isnan(samples.concentration[1]));
  EXPECT_NEAR(samples.concentration[2], 1.0, 1e-4);
  EXPECT_FLOAT_EQ(samples.concentration[3], 0.0F);  // a rounding below nothing is nothing
  EXPECT_NEAR(samples.concentration[4], 0.5, 1e-4);
}

TEST_F(IceTest, AValidRangeInTheOtherUnitRemovesNoPossibleValue) {
  IceFile file;
  file.type = NetcdfWriter::Type::int16;
  file.numbers = {{"scale_factor", 0.01}};
  file.texts["units"] = "%";
  file.lists = {{"valid_range", {0.0, 100.0}}};  // of the unpacked values, against the convention
  file.values = {0.0, 5000.0, 10000.0, -10000.0, 2500.0, 10.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0};

  const auto samples = stored(file);

  EXPECT_FLOAT_EQ(samples.concentration[1], 0.5F);
  EXPECT_FLOAT_EQ(samples.concentration[2], 1.0F);
  EXPECT_TRUE(std::isnan(samples.concentration[3]));
}

TEST_F(IceTest, OfSeveralEstimatesTheGreatestCountsUnlessOneIsNamed) {
  IceFile file;
  std::vector<double> more(12, 0.5);
  more[0] = std::nan("");
  file.others = {another("bootstrap", file.texts, more)};

  auto samples = stored(file);

  EXPECT_FLOAT_EQ(samples.concentration[0], 0.0F);
  EXPECT_FLOAT_EQ(samples.concentration[1], 0.5F);
  EXPECT_FLOAT_EQ(samples.concentration[5], 1.0F);
  EXPECT_THAT(words(report_), HasSubstr("siconc and bootstrap"));

  file.values[0] = 0.05;  // another content, another dataset
  samples = stored(file, {.variable = "siconc"});
  EXPECT_FLOAT_EQ(samples.concentration[1], 0.1F);
  EXPECT_THAT(report_.dataset->variables, ElementsAre("siconc"));

  file.values[0] = 0.06;
  file.write(path("ice.nc"));
  expect_refused(path("ice.nc"), "no grid of values called \"sic\"; it holds the concentrations",
                 {.variable = "sic"});
}

TEST_F(IceTest, UncertaintiesAndFlagsAreNeverTakenForConcentrations) {
  IceFile file;
  file.others = {another("total_uncertainty", {{"standard_name", "sea_ice_area_fraction standard_error"}},
                         std::vector<double>(12, 0.9)),
                 another("raw_ice_conc_values",
                         {{"standard_name", "sea_ice_area_fraction"}, {"long_name", "raw estimates"}},
                         std::vector<double>(12, 1.2))};

  const auto samples = stored(file);

  EXPECT_FLOAT_EQ(samples.concentration[1], 0.1F);
  EXPECT_THAT(report_.dataset->variables, ElementsAre("siconc"));
}

TEST_F(IceTest, ThicknessIsStoredInMetresAndADraftAsTheThicknessThatFloatsSo) {
  IceFile file;
  file.others = {another("sithick", {{"standard_name", "sea_ice_thickness"}, {"units", "cm"}},
                         std::vector<double>(12, 150.0))};
  EXPECT_FLOAT_EQ(stored(file).thickness_m.at(3), 1.5F);
  EXPECT_THAT(report_.dataset->variables, ElementsAre("siconc", "sithick"));

  file.others = {
      another("draft", {{"standard_name", "sea_ice_draft"}, {"units", "m"}}, std::vector<double>(12, 0.915))};
  EXPECT_NEAR(stored(file).thickness_m.at(3), 1.025, 1e-6);
  EXPECT_THAT(words(report_), HasSubstr("is a draft"));

  file.others = {another("sithick", {{"standard_name", "sea_ice_thickness"}, {"units", "m"}},
                         std::vector<double>(12, 150.0))};
  expect_refused_ice(file, "thicker than any sea ice");
}

TEST_F(IceTest, TheUserMaySayWhenAFileWithoutTimeWasSeen) {
  IceFile file;
  file.with_time = false;
  file.values.resize(6);
  IngestOptions options;
  options.time = core::parse_iso8601("2026-11-22T12:00:00Z");

  EXPECT_EQ(stored(file, options).times_s.nodes(), std::vector{core::unix_seconds(*options.time)});
  EXPECT_EQ(report_.dataset->time_start, options.time);
}

TEST_F(IceTest, AFilesOwnTimesAreNotReplaced) {
  IngestOptions options;
  options.time = core::parse_iso8601("2026-11-30T12:00:00Z");

  EXPECT_EQ(stored(IceFile{}, options).times_s.size(), 2U);
  EXPECT_EQ(core::iso8601(*report_.dataset->time_start), "2026-11-20T00:00:00Z");
  EXPECT_THAT(words(report_), HasSubstr("--time was not used"));
}

TEST_F(IceTest, AFileWithoutTimeOrWithoutValuesIsRefused) {
  IceFile file;
  file.with_time = false;
  file.values.resize(6);
  expect_refused_ice(file, "State it with --time");

  IceFile empty;
  empty.fill = -1.0;
  empty.values.assign(12, -1.0);
  expect_refused_ice(empty, "every value of \"siconc\" is missing");
}

TEST_F(IceTest, AFileOfCurrentsAndIceIsStoredAsBoth) {
  const CurrentFile currents;
  IceFile ice;
  ice.others = {another("uo", currents.u_texts, std::vector<double>(12, 0.1)),
                another("vo", currents.v_texts, std::vector<double>(12, 0.1))};
  ice.write(path("both.nc"));

  const auto reports = ingest_all(path("both.nc"));

  ASSERT_EQ(reports.size(), 2U);
  EXPECT_EQ(reports[0].dataset.value().kind, repository::DatasetKind::currents) << words(reports[0]);
  EXPECT_EQ(reports[1].dataset.value().kind, repository::DatasetKind::ice) << words(reports[1]);
}

class ProjectedIceTest : public IceTest {
 protected:
  /// Four by three nodes of 25 km below the pole, with the projection that products of NSIDC and OSI SAF use.
  void write_projected(const std::map<std::string, double>& ellipsoid, const std::string& unit_of_axes) {
    NetcdfWriter writer{path("polar.nc")};
    const double step = unit_of_axes == "km" ? 25.0 : 25000.0;
    writer.axis("time", {0.0}, {{"units", "days since 2026-11-20 12:00:00"}});
    writer.axis("yc", {-10.0 * step, -11.0 * step, -12.0 * step},
                {{"standard_name", "projection_y_coordinate"}, {"units", unit_of_axes}});
    writer.axis("xc", {0.0, step, 2.0 * step, 3.0 * step},
                {{"standard_name", "projection_x_coordinate"}, {"units", unit_of_axes}});
    std::map<std::string, double> numbers{{"latitude_of_projection_origin", 90.0},
                                          {"standard_parallel", 70.0},
                                          {"straight_vertical_longitude_from_pole", -45.0},
                                          {"false_easting", 0.0},
                                          {"false_northing", 0.0}};
    numbers.insert(ellipsoid.begin(), ellipsoid.end());
    writer.variable({.name = "crs",
                     .dimensions = {},
                     .values = {1.0},
                     .texts = {{"grid_mapping_name", "polar_stereographic"}},
                     .numbers = numbers,
                     .fill = {},
                     .type = NetcdfWriter::Type::int32});
    writer.variable(
        {.name = "ice_conc",
         .dimensions = {"time", "yc", "xc"},
         .values = {0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 90.0, 100.0, 5.0},
         .texts = {{"standard_name", "sea_ice_area_fraction"}, {"units", "%"}, {"grid_mapping", "crs"}},
         .numbers = {},
         .fill = {},
         .type = NetcdfWriter::Type::float32});
  }
};

TEST_F(ProjectedIceTest, IsStoredOnItsOwnGridRowsAscending) {
  write_projected({{"semi_major_axis", 6378273.0}, {"semi_minor_axis", 6356889.449}}, "km");

  const auto samples = stored(path("polar.nc"));

  const auto* frame = std::get_if<geo::PolarStereographicFrame>(&samples.grid.frame());
  ASSERT_NE(frame, nullptr);
  EXPECT_EQ(frame->ellipsoid, geo::hughes_1980);
  EXPECT_EQ(frame->lat_ts_deg, 70.0);
  EXPECT_EQ(frame->lon_0_deg, -45.0);
  EXPECT_THAT(samples.grid.y().nodes(), ElementsAre(-300000.0, -275000.0, -250000.0));
  EXPECT_FLOAT_EQ(samples.concentration[0], 0.8F);
  EXPECT_FLOAT_EQ(samples.concentration[8], 0.0F);
  // Polar stereographic (EPSG:3411) to geographic by PROJ 9.1.1: echo 25000 -250000 | cs2cs EPSG:3411 +to
  // +proj=longlat +a=6378273 +b=6356889.449
  const geo::LonLat place = samples.grid.place(1, 2);
  EXPECT_NEAR(place.lon_deg, -39.2894, 1e-4);
}

TEST_F(ProjectedIceTest, OnAnEllipsoidThatIsNotKnownItIsRefused) {
  write_projected({{"semi_major_axis", 6378206.4}, {"semi_minor_axis", 6356583.8}}, "m");

  expect_refused(path("polar.nc"), "projection that this program does not read");
}

/// The nodes' latitudes on a sphere: tan((90 - latitude) / 2) = distance / (radius (1 + sin 70)).
TEST_F(ProjectedIceTest, OnASphereItIsStoredOnItsOwnGridAtLatitudesOnTheSphere) {
  write_projected({{"earth_radius", 6371000.0}}, "m");

  const auto report = ingest(path("polar.nc"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto ice = repository::FieldRepository{db_}
                       .load_ice(report.dataset->id, {-180.0, -90.0, 180.0, 90.0}, std::nullopt)
                       .value();
  constexpr double radians = 3.14159265358979323846 / 180.0;
  const double from_pole_deg =
      2.0 / radians * std::atan(std::hypot(25e3, 275e3) / (6371000.0 * (1.0 + std::sin(70.0 * radians))));
  const double lon_deg = -45.0 + std::atan(25.0 / 275.0) / radians;
  const auto seen = ice.at({lon_deg, 90.0 - from_pole_deg}, *report.dataset->time_start);
  ASSERT_TRUE(seen);
  EXPECT_EQ(ice.samples().grid.size(), 12U);
  EXPECT_NEAR(seen->concentration, 0.5, 1e-6) << "the middle node of the second row";
}

/// One node of the real sample, read with a reader of the classic NetCDF format of our own (struct and numpy on the
/// bytes of the file, no NetCDF library); the greatest of the three estimates.
struct RealNode {
  double x_m;
  double y_m;
  std::optional<double> concentration;
};

TEST_F(IceTest, TheRealArcticSampleIsWhatAnotherReaderSees) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";

  const auto samples = stored(sample_folder() / "seaice/arctic_sic_nersc.nc");

  EXPECT_EQ(core::iso8601(*report_.dataset->time_start), "1978-11-01T00:00:00Z");
  EXPECT_THAT(report_.dataset->variables, ElementsAre("UMass_AES", "Bootstrap", "Bristol"));
  std::int64_t valid = 0;
  double sum = 0.0;
  for (const float value : samples.concentration) {
    if (std::isnan(value)) continue;
    ++valid;
    sum += static_cast<double>(value);
  }
  EXPECT_EQ(valid, 28146);
  EXPECT_NEAR(sum, 17759.51, 0.01);
  for (const RealNode& node : {RealNode{1787500.0, 1012500.0, 0.87}, RealNode{2012500.0, 2887500.0, 1.0},
                               RealNode{3087500.0, 437500.0, 0.0}, RealNode{1637500.0, 887500.0, 0.91},
                               RealNode{687500.0, 437500.0, {}}}) {
    const auto x = samples.grid.x().locate(node.x_m);
    const auto y = samples.grid.y().locate(node.y_m);
    ASSERT_TRUE(x && y);
    const float value = samples.concentration[y->lower * samples.grid.x().size() + x->lower];
    if (node.concentration) {
      EXPECT_FLOAT_EQ(value, static_cast<float>(*node.concentration));
    } else {
      EXPECT_TRUE(std::isnan(value));
    }
  }
  // Known land and water, by the projection's own formulas: Greenland, the Norwegian Sea, north of Siberia.
  const ocean::IceField field{samples};
  const core::UtcTime then = *report_.dataset->time_start;
  EXPECT_FALSE(field.at({-40.0, 72.0}, then));
  EXPECT_NEAR(field.at({0.0, 67.0}, then)->concentration, 0.0, 1e-6);
  EXPECT_NEAR(field.at({180.0, 82.0}, then)->concentration, 1.0, 1e-6);
}

}  // namespace
}  // namespace floeplan::ingest::ice_test
