#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>

#include "engine/core/utc_text.hpp"
#include "storage/ingest/process/guarded_ingest.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/fields/tide_repository.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/places.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::tide_test {
namespace {

using ocean::TideQuantity;
using testing::ElementsAre;
using testing::HasSubstr;

class TideFile : public StoreFixture {
 protected:
  std::optional<std::vector<tide::HarmonicConstant>> constants(const IngestReport& report,
                                                               TideQuantity quantity, geo::LonLat place) {
    const auto model = repository::TideRepository{db_}.load(
        report.dataset->id, {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg});
    return model ? model->constants(quantity, place) : std::nullopt;
  }
};

NetcdfWriter::Variable field(const std::string& name, const std::vector<std::string>& dimensions,
                             const std::vector<double>& values, const std::string& unit) {
  return {.name = name,
          .dimensions = dimensions,
          .values = values,
          .texts = {{"units", unit}},
          .numbers = {},
          .fill = {},
          .type = NetcdfWriter::Type::float64};
}

void place_nodes(NetcdfWriter& writer, const std::string& suffix, const std::vector<double>& lons,
                 const std::vector<double>& lats) {
  writer.variable(field("lon_" + suffix, {"nx"}, lons, "degree_east"));
  writer.variable(field("lat_" + suffix, {"ny"}, lats, "degree_north"));
}

/// Writes elevations as the TPXO atlas stores them: dimensions nx, ny; longitudes from 0 to 360; the west first.
void write_tpxo_elevation(const std::filesystem::path& file, const std::string& unit = "millimeter") {
  NetcdfWriter writer{file};
  writer.dimension("nx", 3);
  writer.dimension("ny", 2);
  place_nodes(writer, "z", {306.0, 306.5, 307.0}, {69.0, 69.5});
  writer.variable(field("hRe", {"nx", "ny"}, {100, 200, 300, 400, 500, 0}, unit));
  writer.variable(field("hIm", {"nx", "ny"}, {-10, -20, -30, -40, -50, 0}, unit));
}

TEST_F(TideFile, OfTpxoHoldsTheConjugateOfThePhaseLagAtItsNodes) {
  write_tpxo_elevation(path("h_m2_tpxo9_atlas_30.nc"));

  const IngestReport report = ingest(path("h_m2_tpxo9_atlas_30.nc"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->kind, repository::DatasetKind::tides);
  EXPECT_THAT(report.dataset->variables, ElementsAre("M2"));
  EXPECT_EQ(report.dataset->rows_accepted, 5);
  const auto node = constants(report, TideQuantity::elevation, {-53.5, 69.5});
  ASSERT_TRUE(node);
  EXPECT_LT(std::abs(node->front().value - std::complex<double>{0.4, -0.04}), 1e-6);
  EXPECT_FALSE(constants(report, TideQuantity::elevation, {-53.0, 69.5})) << "zero is land";
}

TEST_F(TideFile, IsRefusedWhenItsNameIsNoConstituentAndNothingElseTells) {
  write_tpxo_elevation(path("elevation.nc"));
  expect_refused(path("elevation.nc"), "which constituent");
}

TEST_F(TideFile, IsRefusedWhenNoTideIsThatHigh) {
  write_tpxo_elevation(path("m2.nc"), "meter");
  expect_refused(path("m2.nc"), "no tide has more than 20 m");
}

TEST_F(TideFile, IsRefusedWithAUnitThatIsNone) {
  write_tpxo_elevation(path("m2.nc"), "furlong");
  expect_refused(path("m2.nc"), "furlong");
}

/// Transports of a C-grid, 0.25 degrees west and south of the nodes, over 100 m and 200 m of water.
void write_tpxo_transport(const std::filesystem::path& file, bool with_depths) {
  NetcdfWriter writer{file};
  writer.attribute("title", file.stem().string());
  writer.dimension("nx", 3);
  writer.dimension("ny", 2);
  place_nodes(writer, "u", {305.75, 306.25, 306.75}, {69.0, 69.5});
  place_nodes(writer, "v", {306.0, 306.5, 307.0}, {68.75, 69.25});
  // cm2/s: 100 m of water at 0.1, 0.2, 0.3 m/s is 1e5 cm2/s and so on.
  writer.variable(field("uRe", {"nx", "ny"}, {1e5, 1e5, 2e5, 2e5, 3e5, 3e5}, "centimeter^2/sec"));
  writer.variable(field("uIm", {"nx", "ny"}, {1e4, 1e4, 1e4, 1e4, 1e4, 1e4}, "centimeter^2/sec"));
  writer.variable(field("vRe", {"nx", "ny"}, {-2e5, -4e5, -2e5, -4e5, -2e5, -4e5}, "centimeter^2/sec"));
  writer.variable(field("vIm", {"nx", "ny"}, {2e4, 2e4, 2e4, 2e4, 2e4, 2e4}, "centimeter^2/sec"));
  if (!with_depths) return;
  writer.variable(field("hu", {"nx", "ny"}, {100, 100, 100, 100, 100, 100}, "meter"));
  writer.variable(field("hv", {"nx", "ny"}, {200, 200, 200, 200, 200, 200}, "meter"));
}

/// The depths at the nodes of those transports, the first longitude at `west`.
void write_tpxo_grid(const std::filesystem::path& file, double west) {
  NetcdfWriter writer{file};
  writer.dimension("nx", 3);
  writer.dimension("ny", 2);
  place_nodes(writer, "z", {west + 0.25, west + 0.75, west + 1.25}, {69.0, 69.5});
  place_nodes(writer, "u", {west, west + 0.5, west + 1.0}, {69.0, 69.5});
  place_nodes(writer, "v", {west + 0.25, west + 0.75, west + 1.25}, {68.75, 69.25});
  writer.variable(field("hz", {"nx", "ny"}, {150, 150, 150, 150, 150, 150}, "meter"));
  writer.variable(field("hu", {"nx", "ny"}, {100, 100, 100, 100, 100, 100}, "meter"));
  writer.variable(field("hv", {"nx", "ny"}, {200, 200, 200, 200, 200, 200}, "meter"));
}

TEST_F(TideFile, OfTransportsIsDividedByTheDepthAndBroughtToTheNodes) {
  write_tpxo_transport(path("u_k1_tpxo.nc"), true);

  const IngestReport report = ingest(path("u_k1_tpxo.nc"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(report.dataset->variables, ElementsAre("K1"));
  const auto east = constants(report, TideQuantity::east, {-54.0, 69.0});
  ASSERT_TRUE(east);
  EXPECT_LT(std::abs(east->front().value - std::complex<double>{0.15, 0.01}), 1e-6);
  const auto north = constants(report, TideQuantity::north, {-54.0, 69.0});
  ASSERT_TRUE(north);
  EXPECT_LT(std::abs(north->front().value - std::complex<double>{-0.15, 0.01}), 1e-6);
}

TEST_F(TideFile, WhoseComponentSaysThatItIsTheOtherOneIsRefused) {
  {
    NetcdfWriter writer{path("u_m2.nc")};
    writer.dimension("nx", 3);
    writer.dimension("ny", 2);
    place_nodes(writer, "u", {306.0, 306.5, 307.0}, {69.0, 69.5});
    for (const char* const name : {"uRe", "uIm"}) {
      NetcdfWriter::Variable part = field(name, {"nx", "ny"}, {1, 2, 3, 4, 5, 6}, "cm/s");
      part.texts["standard_name"] = "northward_sea_water_velocity_due_to_tides";
      writer.variable(part);
    }
  }
  expect_refused(path("u_m2.nc"), "says the other component");
}

TEST_F(TideFile, OfTransportsWithoutDepthsIsRefused) {
  write_tpxo_transport(path("u_k1_tpxo.nc"), false);
  expect_refused(path("u_k1_tpxo.nc"), "depths that make it a speed are missing");
}

TEST_F(TideFile, OfTransportsTakesTheDepthsOfTheGridFileThatIsGivenWithAllConstituents) {
  write_tpxo_transport(path("u_k1_tpxo.nc"), false);
  write_tpxo_transport(path("u_m2_tpxo.nc"), false);
  write_tpxo_elevation(path("h_m2_tpxo.nc"));
  write_tpxo_grid(path("grid_tpxo.nc"), 305.75);

  const auto reports = guarded_ingest(
      db_, {.program = support::program_folder() + "/ingest_reader", .staging = path("incoming")},
      {path("grid_tpxo.nc"), path("u_k1_tpxo.nc"), path("h_m2_tpxo.nc"), path("u_m2_tpxo.nc")}, {},
      core::from_unix_seconds(1.8e9), {}, {}, {});

  ASSERT_EQ(reports.size(), 3U);
  for (const IngestReport& report : reports) EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(reports[0].dataset->variables, ElementsAre("K1"));
  EXPECT_THAT(reports[2].dataset->variables, ElementsAre("M2"));
  for (const IngestReport& report : {reports[0], reports[2]}) {
    const auto east = constants(report, TideQuantity::east, {-54.0, 69.0});
    ASSERT_TRUE(east);
    EXPECT_LT(std::abs(east->front().value - std::complex<double>{0.15, 0.01}), 1e-6);
    const auto north = constants(report, TideQuantity::north, {-54.0, 69.0});
    ASSERT_TRUE(north);
    EXPECT_LT(std::abs(north->front().value - std::complex<double>{-0.15, 0.01}), 1e-6);
  }
}

/// TPXO before the atlas has its nodes in tables of two dimensions, which are no model's grid for want of a current.
TEST_F(TideFile, OfTransportsTakesTheDepthsWhereNodesAreInTables) {
  for (const bool is_grid : {false, true}) {
    NetcdfWriter writer{path(is_grid ? "grid_tpxo9.nc" : "u_k1_tpxo9.nc")};
    writer.dimension("nx", 3);
    writer.dimension("ny", 2);
    for (const char* const nodes : {"u", "v"}) {
      const double west = *nodes == 'u' ? 305.75 : 306.0;
      const double south = *nodes == 'u' ? 69.0 : 68.75;
      writer.variable(field("lon_" + std::string{nodes}, {"nx", "ny"},
                            {west, west, west + 0.5, west + 0.5, west + 1.0, west + 1.0}, "degree_east"));
      writer.variable(field("lat_" + std::string{nodes}, {"nx", "ny"},
                            {south, south + 0.5, south, south + 0.5, south, south + 0.5}, "degree_north"));
      for (const char* const part : {"Re", "Im"})
        if (!is_grid)
          writer.variable(
              field(nodes + std::string{part}, {"nx", "ny"}, {20, 20, 20, 20, 20, 20}, "meter^2/s"));
      if (is_grid)
        writer.variable(
            field("h" + std::string{nodes}, {"nx", "ny"}, {100, 100, 100, 100, 100, 100}, "meter"));
    }
  }

  const IngestReport report = ingest_together({path("u_k1_tpxo9.nc"), path("grid_tpxo9.nc")});

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  for (const TideQuantity quantity : {TideQuantity::east, TideQuantity::north}) {
    const auto value = constants(report, quantity, {-54.0, 69.0});
    ASSERT_TRUE(value);
    EXPECT_LT(std::abs(value->front().value - std::complex<double>{0.2, 0.2}), 1e-6);
  }
}

TEST_F(TideFile, OfTransportsIsRefusedBesideTheGridFileOfAnotherModel) {
  write_tpxo_transport(path("u_k1_tpxo.nc"), false);
  write_tpxo_grid(path("grid_tpxo.nc"), 305.5);

  const IngestReport report = ingest_together({path("u_k1_tpxo.nc"), path("grid_tpxo.nc")});

  EXPECT_EQ(report.status, IngestStatus::refused);
  EXPECT_THAT(words(report), HasSubstr("depths that make it a speed are missing"));
}

/// Writes a tide as FES does: amplitude and phase, latitude and longitude, one constituent a file.
void write_fes(const std::filesystem::path& file, const std::vector<std::string>& names) {
  NetcdfWriter writer{file};
  writer.attribute("title", file.stem().string());  // without it files of two constituents would be the same
  writer.axis("lat", {70.0, 69.0}, {{"units", "degrees_north"}});
  writer.axis("lon", {350.0, 351.0, 352.0}, {{"units", "degrees_east"}});
  for (std::size_t i = 0; i < names.size(); i += 2) {
    auto amplitude = field(names[i], {"lat", "lon"}, {50.0, 60.0, 1e10, 10.0, 20.0, 30.0},
                           names[i] == "amplitude" ? "cm" : "cm/s");
    amplitude.fill = 1e10;
    auto phase = field(names[i + 1], {"lat", "lon"}, {0.0, 90.0, 1e10, 180.0, 270.0, 45.0}, "degrees");
    phase.fill = 1e10;
    writer.variable(amplitude);
    writer.variable(phase);
  }
}

TEST_F(TideFile, OfFesHoldsAmplitudesAndPhases) {
  write_fes(path("2n2_fes2014c.nc"), {"amplitude", "phase"});

  const IngestReport report = ingest(path("2n2_fes2014c.nc"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(report.dataset->variables, ElementsAre("2N2"));
  const auto lag_of_90 = constants(report, TideQuantity::elevation, {-9.0, 70.0});
  ASSERT_TRUE(lag_of_90);
  EXPECT_LT(std::abs(lag_of_90->front().value - std::complex<double>{0.0, -0.6}), 1e-6);
  EXPECT_FALSE(constants(report, TideQuantity::elevation, {-8.0, 70.0}));
}

TEST_F(TideFile, OfOneComponentOfTheCurrentIsRefused) {
  write_fes(path("m2.nc"), {"Ua", "Ug"});
  expect_refused(path("m2.nc"), "only the eastward component");
}

TEST_F(TideFile, OfOneComponentTakesTheOtherFromTheFileOfTheSameConstituent) {
  for (const char* const folder : {"eastward_velocity", "northward_velocity"})
    std::filesystem::create_directories(path(folder));
  for (const char* const name : {"k1.nc", "m2.nc"}) {
    write_fes(path("eastward_velocity") / name, {"Ua", "Ug"});
    write_fes(path("northward_velocity") / name, {"Va", "Vg"});
  }

  const auto reports =
      ingest_all_together({path("eastward_velocity") / "k1.nc", path("eastward_velocity") / "m2.nc",
                           path("northward_velocity") / "k1.nc", path("northward_velocity") / "m2.nc"});

  ASSERT_EQ(reports.size(), 2U);
  for (const IngestReport& report : reports) {
    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    for (const TideQuantity quantity : {TideQuantity::east, TideQuantity::north}) {
      const auto lag_of_90 = constants(report, quantity, {-9.0, 70.0});
      ASSERT_TRUE(lag_of_90);
      EXPECT_LT(std::abs(lag_of_90->front().value - std::complex<double>{0.0, -0.6}), 1e-6);
    }
  }
  EXPECT_THAT(reports[0].dataset->variables, ElementsAre("K1"));
  EXPECT_THAT(reports[1].dataset->variables, ElementsAre("M2"));
}

TEST_F(TideFile, OfOneComponentIsRefusedBesideTheOtherOfAnotherConstituent) {
  write_fes(path("k1.nc"), {"Ua", "Ug"});
  write_fes(path("m2.nc"), {"Va", "Vg"});

  for (const IngestReport& report : ingest_all_together({path("k1.nc"), path("m2.nc")}))
    EXPECT_THAT(words(report), HasSubstr("the other component of the same constituent"));
}

TEST_F(TideFile, IsNoneWhereOnlyTheNamesAreAlike) {
  NetcdfWriter writer{path("m2.nc")};
  writer.axis("lat", {69.0, 70.0}, {{"units", "degrees_north"}});
  writer.axis("lon", {-54.0, -53.0}, {{"units", "degrees_east"}});
  for (const char* name : {"ua", "ug", "va", "vg"})
    writer.variable(field(name, {"lat", "lon"}, {0.1, 0.2, 0.3, 0.4}, "m s-1"));

  const IngestReport report = ingest(path("m2.nc"));

  EXPECT_EQ(report.status, IngestStatus::refused);
  EXPECT_THAT(words(report), testing::Not(HasSubstr("tide")));
}

TEST_F(TideFile, OfTmdNamesItsConstituentsAndItsProjection) {
  NetcdfWriter writer{path("cats.nc")};
  writer.dimension("constituents", 2);
  writer.axis("y", {-1000.0, -1002.0}, {{"units", "kilometer"}});
  writer.axis("x", {500.0, 502.0, 504.0}, {{"units", "kilometer"}});
  NetcdfWriter::Variable order = field("constituents", {"constituents"}, {1, 2}, "");
  order.texts = {{"constituent_order", "m2 k1"}};
  writer.variable(order);
  NetcdfWriter::Variable mapping = field("mapping", {}, {0}, "");
  mapping.texts = {
      {"spatial_proj4",
       "+proj=stere +lat_0=-90 +lat_ts=-71 +lon_0=-70 +x_0=0 +y_0=0 +datum=WGS84 +units=km +no_defs"}};
  writer.variable(mapping);
  const std::vector<double> values{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  for (const char* name : {"hRe", "hIm"})
    writer.variable(field(name, {"constituents", "y", "x"}, values, "m"));
  for (const char* name : {"URe", "UIm", "VRe", "VIm"})
    writer.variable(field(name, {"constituents", "y", "x"}, values, "m^2/s"));
  writer.variable(field("wct", {"y", "x"}, {100, 100, 100, 100, 100, 0}, "meters"));

  const IngestReport report = ingest(path("cats.nc"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(report.dataset->variables, ElementsAre("M2", "K1"));
  const auto shape = repository::FieldRepository{db_}.shape(report.dataset->id);
  const ocean::HorizontalGrid& grid = shape->grid;
  const geo::LonLat inside = grid.projection().to_lon_lat({500'500.0, -1'000'500.0});
  const auto east = constants(report, TideQuantity::east, inside);
  ASSERT_TRUE(east);
  ASSERT_EQ(east->size(), 2U);
  // A quarter of the way from the northern row 1, 2 to the southern one 4, 5, and along it: 1 + 0.25 + 0.75.
  // K1 comes before M2 in the catalogue, and has 6 more at every node.
  EXPECT_LT(std::abs(east->at(0).value - std::complex<double>{0.08, 0.08}), 1e-6)
      << "the first row is the north";
  EXPECT_LT(std::abs(east->at(1).value - std::complex<double>{0.02, 0.02}), 1e-6);
  const geo::LonLat by_land = grid.projection().to_lon_lat({503'999.0, -1'001'999.0});
  EXPECT_NEAR(constants(report, TideQuantity::elevation, by_land)->front().value.real(), 12.0, 0.01);
  EXPECT_NEAR(constants(report, TideQuantity::east, by_land)->front().value.real(), 0.10, 0.01)
      << "no water there";
}

TEST_F(TideFile, ThatForcesARomsModelIsRefusedBecauseItsPhasesAndPlacesAreElsewhere) {
  NetcdfWriter writer{path("tides.nc")};
  writer.dimension("tide_period", 1);
  writer.dimension("eta_rho", 2);
  writer.dimension("xi_rho", 2);
  for (const char* name : {"tide_Eamp", "tide_Ephase"})
    writer.variable(field(name, {"tide_period", "eta_rho", "xi_rho"}, {1, 2, 3, 4}, "meter"));
  expect_refused(path("tides.nc"), "forcing of a ROMS model");
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

TEST_F(TideFile, ThatWasCutShortIsRefused) {
  write_tpxo_transport(path("u_k1_tpxo.nc"), true);
  const std::string whole = bytes_of(path("u_k1_tpxo.nc"));
  for (std::size_t twentieth = 0; twentieth < 20; ++twentieth) {
    const auto file = write_file("k1.nc", whole.substr(0, whole.size() * twentieth / 20));
    EXPECT_EQ(ingest(file).status, IngestStatus::refused) << twentieth;
    EXPECT_EQ(stored_datasets(), 0U);
  }
}

/// In the confined reader process, because the HDF5 library may crash on a damaged file.
TEST_F(TideFile, WithFlippedBytesIsRefusedOrHoldsPlausibleConstants) {
  write_tpxo_transport(path("u_k1_tpxo.nc"), true);
  const std::string whole = bytes_of(path("u_k1_tpxo.nc"));
  const Guard guard{.program = support::program_folder() + "/ingest_reader", .staging = path("incoming")};
  support::for_each_seed(10, [&](std::mt19937_64& rng) {
    std::string flipped = whole;
    for (int i = 0; i < 3; ++i) flipped[rng() % flipped.size()] ^= static_cast<char>(1U << (rng() % 8));
    const auto file = write_file("k1.nc", flipped);
    for (const IngestReport& report :
         guarded_ingest(db_, guard, {file}, {}, core::from_unix_seconds(1.8e9), {}, {}, {})) {
      if (report.status != IngestStatus::stored) continue;
      const auto model =
          repository::TideRepository{db_}.load(report.dataset->id, {-180.0, -90.0, 180.0, 90.0});
      ASSERT_TRUE(model);
      for (const auto& line : model->samples().lines)
        for (const auto& value : line.east) EXPECT_FALSE(std::abs(value) > 10.0F);
    }
  });
}

class TideStations : public StoreFixture {
 protected:
  std::vector<repository::TideStation> stations(const IngestReport& report) {
    return repository::TideRepository{db_}.stations(report.dataset->id);
  }
};

const std::string noaa = R"({"units":"feet","HarmonicConstituents":[
  {"number":1,"name":"M2","amplitude":1.0,"phase_GMT":60.0,"phase_local":10.0,"speed":28.984104},
  {"number":2,"name":"S2","amplitude":0.5,"phase_GMT":-30.0,"phase_local":1.0,"speed":30.0},
  {"number":3,"name":"S6","amplitude":0.0,"phase_GMT":0.0,"phase_local":0.0,"speed":90.0}]})";

TEST_F(TideStations, OfNoaaNeedAPlaceAndAreConvertedFromFeet) {
  const auto file = write_file("harcon.json", noaa);
  expect_refused(file, "--at LON,LAT");

  const IngestReport report = ingest(file, {.at = geo::LonLat{-157.9, 21.3}});

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  ASSERT_EQ(stations(report).size(), 1U);
  const repository::TideStation station = stations(report).front();
  EXPECT_EQ(station.place, (geo::LonLat{-157.9, 21.3}));
  ASSERT_EQ(station.constants.size(), 2U);
  EXPECT_LT(std::abs(station.constants[0].value - tide::harmonic_value(0.3048, 60.0)), 1e-12);
}

TEST_F(TideStations, WhoseLabelsDoNotFitTheirSpeedsAreRefused) {
  std::string swapped = noaa;
  swapped.replace(swapped.find("28.984104"), 9, "28.439730");
  expect_refused(write_file("harcon.json", swapped), "names in the file do not fit",
                 {.at = geo::LonLat{0.0, 0.0}});
}

TEST_F(TideStations, ThatWereCutShortAreRefused) {
  for (std::size_t twentieth = 1; twentieth < 20; ++twentieth) {
    const auto file = write_file("cut.json", noaa.substr(0, noaa.size() * twentieth / 20));
    EXPECT_EQ(ingest(file, {.at = geo::LonLat{0.0, 0.0}}).status, IngestStatus::refused) << twentieth;
  }
}

TEST_F(TideStations, InATableNeedAUnit) {
  const auto file = write_file(
      "table.tsv", "Constituent #\tName\tAmplitude\tPhase\tSpeed\n1\tM2\t0.171\t59.4\t28.984104\n");
  expect_refused(file, "--unit", {.at = geo::LonLat{-157.9, 21.3}});

  const IngestReport report = ingest(file, {.at = geo::LonLat{-157.9, 21.3}, .unit = "m"});

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_LT(std::abs(stations(report).front().constants.front().value - tide::harmonic_value(0.171, 59.4)),
            1e-12);
}

TEST_F(TideStations, OfTheRealSamplesAreReadWhole) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  const IngestReport honolulu = ingest(sample_folder() / "tides/noaa_honolulu.json");
  ASSERT_EQ(honolulu.status, IngestStatus::stored) << words(honolulu);
  EXPECT_NEAR(stations(honolulu).front().place.lon_deg, -157.8645, 1e-4);
  EXPECT_EQ(stations(honolulu).front().constants.front().value, tide::harmonic_value(0.171, 59.4));

  const IngestReport anchorage = ingest(sample_folder() / "tides/noaa_anchorage-knik-arm.json");
  ASSERT_EQ(anchorage.status, IngestStatus::stored) << words(anchorage);
  EXPECT_TRUE(anchorage.warnings.empty()) << words(anchorage) << "every constituent is known";

  const IngestReport otps = ingest(sample_folder() / "tides/otps_tpxo9v2a_extract_HC_sample_out.txt");
  ASSERT_EQ(otps.status, IngestStatus::stored) << words(otps);
  ASSERT_EQ(stations(otps).size(), 3U);
  EXPECT_NEAR(stations(otps)[1].place.lat_deg, -29.676001, 1e-9);
  EXPECT_EQ(stations(otps)[2].constants[2].value, tide::harmonic_value(0.138, -11.1));

  const IngestReport utide =
      ingest(sample_folder() / "tides/utide_HNL2010_coef_matlab.csv", {.at = geo::LonLat{-157.87, 21.3}});
  ASSERT_EQ(utide.status, IngestStatus::stored) << words(utide);
  EXPECT_EQ(stations(utide).front().constants.size(), 59U);
  EXPECT_NEAR(std::abs(stations(utide).front().constants.front().value), 0.176922, 1e-6);

  const IngestReport oce = ingest(sample_folder() / "tides/oce_noaa_harmonics_sample.tsv",
                                  {.at = geo::LonLat{-157.87, 21.3}, .unit = "m"});
  ASSERT_EQ(oce.status, IngestStatus::stored) << words(oce);
  EXPECT_EQ(std::abs(stations(oce).front().constants.front().value), 0.171);
  expect_refused(sample_folder() / "tides/aviso_fes2014_v12_fes_slev.txt", "");
  expect_refused(sample_folder() / "tides/roms_tidal_forcing_v3.zarr", "forcing of a ROMS model");
}

const std::string m2_row = "M2,1.0,120,28.9841042\n";

TEST_F(TideStations, WhosePhasesCountFromLocalTimeIsRefused) {
  const IngestOptions at_nuuk{.at = geo::LonLat{-51.7, 64.2}, .unit = "m"};
  for (const char* const head :
       {"name,amplitude_m,phase local (deg),speed\n", "name,amplitude_m,phase (LST),speed\n",
        "# Local standard time\nname,amplitude_m,phase,speed\n",
        "# time zone: UTC-3\nname,amplitude_m,phase,speed\n",
        "# Timezone=-5\nname,amplitude_m,phase,speed\n"})
    expect_refused(write_file("station.csv", head + m2_row), "count from local time", at_nuuk);
}

TEST_F(TideStations, AreNotDoubtedWhereTheyNameGreenwich) {
  const IngestOptions at_nuuk{.at = geo::LonLat{-51.7, 64.2}, .unit = "m"};
  for (const std::string& table :
       std::vector<std::string>{"name,amplitude_m,phase_GMT,speed\n" + m2_row,
                                "# time zone: UTC\nname,amplitude_m,phase,speed\n" + m2_row,
                                "# local datum\n# time zone: "
                                "0\nname,amplitude_m,phase_UTC,speed,phase_local\nM2,1.0,120,28.9841042,30\n",
                                "name,amplitude_m,phase_local,phase_GMT\nM2,1.0,30,120\n"}) {
    const IngestReport report = ingest(write_file("station.csv", table), at_nuuk);

    ASSERT_EQ(report.status, IngestStatus::stored) << table << words(report);
    EXPECT_THAT(words(report), testing::Not(HasSubstr("Greenwich"))) << table;
    const std::complex<double> value = stations(report).at(0).constants.at(0).value;
    EXPECT_LT(std::abs(value - std::polar(1.0, -120.0 * 3.14159265358979323846 / 180.0)), 1e-9) << table;
  }
}

}  // namespace
}  // namespace floeplan::ingest::tide_test
