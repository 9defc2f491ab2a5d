#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "engine/core/utc_text.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/repository/features/coastline_repository.hpp"
#include "storage/repository/features/zone_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::zones_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

const geo::BoundingBox everywhere{-180.0, -90.0, 180.0, 90.0};
const core::UtcTime long_ago = core::from_unix_seconds(0.0);

/// What one feature of a test file states; empty texts are left out.
struct Feature {
  std::string wkt;
  std::vector<std::pair<std::string, std::string>> texts;
};

/// How a format is written by GDAL itself.
struct Format {
  const char* driver;
  const char* file;
};

constexpr std::array formats{Format{"GeoJSON", "zones.geojson"}, Format{"LIBKML", "zones.kml"},
                             Format{"GPKG", "zones.gpkg"}, Format{"ESRI Shapefile", "zones.shp"}};

class Zones : public StoreFixture {
 protected:
  /// Writes the features with all their attributes as texts; `epsg` 0 states no reference system.
  std::filesystem::path write(const Format& format, const std::vector<Feature>& features,
                              int epsg = 4326) const {
    register_writers();
    const std::filesystem::path file = path(format.file);
    GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName(format.driver);
    const std::unique_ptr<GDALDataset> dataset{driver.Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr)};
    OGRSpatialReference crs;
    if (epsg != 0) crs.importFromEPSG(epsg);
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRLayer& layer = *dataset->CreateLayer("zones", epsg != 0 ? &crs : nullptr, wkbUnknown, nullptr);
    for (const Feature& feature : features)
      for (const auto& [name, text] : feature.texts)
        if (layer.GetLayerDefn()->GetFieldIndex(name.c_str()) < 0) {
          OGRFieldDefn field{name.c_str(), OFTString};
          layer.CreateField(&field);
        }
    for (const Feature& feature : features) {
      OGRFeature row{layer.GetLayerDefn()};
      OGRGeometry* geometry = nullptr;
      OGRGeometryFactory::createFromWkt(feature.wkt.c_str(), nullptr, &geometry);
      row.SetGeometryDirectly(geometry);
      for (const auto& [name, text] : feature.texts) row.SetField(name.c_str(), text.c_str());
      EXPECT_EQ(layer.CreateFeature(&row), OGRERR_NONE);
    }
    return file;
  }

  [[nodiscard]] std::vector<ocean::Zone> stored(const IngestReport& report) {
    return repository::ZoneRepository{db_}.load(report.dataset->id, everywhere, long_ago);
  }
};

const Feature harbour{
    "POLYGON ((-53.4 69.0,-53.0 69.0,-53.0 69.3,-53.4 69.3,-53.4 69.0),"
    "(-53.3 69.1,-53.1 69.1,-53.1 69.2,-53.3 69.1))",
    {{"name", "Harbour"},
     {"kind", "no_go"},
     {"from", "2026-11-20T06:00:00Z"},
     {"until", "2026-11-21"},
     {"top_m", "10"},
     {"bottom_m", "150.5"}}};
const Feature range{"MULTIPOLYGON (((-52 68,-51 68,-51 69,-52 69,-52 68)),((-50 68,-49 68,-49 69,-50 68)))",
                    {{"name", "Range"}, {"kind", "stay_in"}}};

TEST_F(Zones, AreReadAlikeFromEveryFormat) {
  for (const Format& format : formats) {
    SCOPED_TRACE(format.driver);
    const auto report = ingest(write(format, {harbour, range}));

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    EXPECT_EQ(report.dataset->kind, repository::DatasetKind::zones);
    EXPECT_EQ(report.dataset->rows_accepted, 3);
    EXPECT_THAT(report.dataset->variables, ElementsAre("no_go", "stay_in"));
    const auto zones = stored(report);
    ASSERT_EQ(zones.size(), 3U);
    EXPECT_EQ(zones[0].name, "Harbour");
    EXPECT_EQ(zones[0].kind, ocean::ZoneKind::no_go);
    EXPECT_EQ(core::iso8601(zones[0].from.value()), "2026-11-20T06:00:00Z");
    EXPECT_EQ(core::iso8601(zones[0].until.value()), "2026-11-22T00:00:00Z") << "to the end of that day";
    EXPECT_EQ(zones[0].top, core::Metres{10.0});
    EXPECT_EQ(zones[0].bottom, core::Metres{150.5});
    EXPECT_EQ(zones[0].area.outer.size(), 4U);
    ASSERT_EQ(zones[0].area.holes.size(), 1U);
    EXPECT_EQ(zones[1].kind, ocean::ZoneKind::stay_in);
    EXPECT_EQ(zones[1].name, "Range");
    EXPECT_FALSE(zones[1].from || zones[1].until);
    EXPECT_TRUE(std::isinf(zones[2].bottom.value));
  }
}

TEST_F(Zones, HoldThePlacesThatGeosFindsInThem) {
  for (const Format& format : formats) {
    SCOPED_TRACE(format.driver);
    const auto report = ingest(write(format, {harbour}));
    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    const auto zones = stored(report);
    OGRGeometry* geometry = nullptr;
    OGRGeometryFactory::createFromWkt(harbour.wkt.c_str(), nullptr, &geometry);
    const std::unique_ptr<OGRGeometry> original{geometry};

    support::for_each_seed(300, [&](std::mt19937_64& rng) {
      const OGRPoint point{support::uniform(rng, -53.5, -52.9), support::uniform(rng, 68.9, 69.4)};
      ASSERT_EQ(geo::contains(zones.front().area, {point.getX(), point.getY()}),
                original->Contains(&point) != 0);
    });
  }
}

TEST_F(Zones, OfAProjectionKeepToItsStraightEdges) {
  // 400 km a side in the polar stereographic projection of the NSIDC, whose edges bend in longitude and latitude.
  const Feature ice_camp{
      "POLYGON ((-800000 -1600000,-400000 -1600000,-400000 -1200000,-800000 -1200000,"
      "-800000 -1600000))",
      {{"kind", "no_go"}}};
  OGRSpatialReference polar;
  polar.importFromEPSG(3413);
  polar.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRSpatialReference wgs84;
  wgs84.importFromEPSG(4326);
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> to_wgs84{
      OGRCreateCoordinateTransformation(&polar, &wgs84)};
  for (const Format& format : {formats[2], formats[3]}) {
    SCOPED_TRACE(format.driver);
    const auto report = ingest(write(format, {ice_camp}, 3413));

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    const auto zones = stored(report);
    EXPECT_GT(zones.front().area.outer.size(), 20U);
    EXPECT_LT(zones.front().area.outer.size(), 2000U);
    constexpr double near_m = 25.0;  // the distance of 10 m times the scale of the projection, with room
    support::for_each_seed(300, [&](std::mt19937_64& rng) {
      const double along = support::uniform(rng, -799'000.0, -401'000.0);
      const double offset = support::uniform(rng, 0.0, 1.0) < 0.5 ? -near_m : near_m;
      double x = along;
      double y = -1'600'000.0 + offset;
      ASSERT_EQ(to_wgs84->Transform(1, &x, &y), 1);
      ASSERT_EQ(geo::contains(zones.front().area, {x, y}), offset > 0.0) << along;
    });
  }
}

TEST_F(Zones, AcceptTheNamesOfOthers) {
  const Feature spelled{"POLYGON ((0 50,1 50,1 51,0 50))",
                        {{"TITLE", "Wind farm"},
                         {"Rule", "Keep-Out"},
                         {"VALID_FROM", "2026-11-20T08:00:00+02:00"},
                         {"valid_to", "2026-12-01T00:00:00Z"},
                         {"Min_Depth", "5"},
                         {"MAX_DEPTH", "80"}}};
  for (const Format& format : formats) {
    SCOPED_TRACE(format.driver);
    const auto report = ingest(write(format, {spelled}), {.kind = repository::DatasetKind::zones});

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    const auto zones = stored(report);
    EXPECT_EQ(zones.front().name, "Wind farm");
    EXPECT_EQ(zones.front().kind, ocean::ZoneKind::no_go);
    EXPECT_EQ(core::iso8601(zones.front().from.value()), "2026-11-20T06:00:00Z");
    EXPECT_EQ(zones.front().top, core::Metres{5.0});
    EXPECT_EQ(zones.front().bottom, core::Metres{80.0});
  }
}

/// Attributes of one meaning in the ways in which services and map programs write them.
struct Spelling {
  const char* name;
  const char* text;
};

const std::string triangle = "POLYGON ((0 50,1 50,1 51,0 50))";

/// In every format, under names of many makers, beside the ordinary attributes of theirs.
TEST_F(Zones, NeverLoseWhatTheirAttributesSay) {
  const std::vector<Spelling> rules{{"kind", "stay_in"},       {"type", "stay in"},
                                    {"zone_type", "keep_in"},  {"ZoneType", "STAY IN"},
                                    {"class", "stay-in zone"}, {"policy", "KeepIn"}};
  const std::vector<Spelling> begins{{"start_date", "2026-05-01"}, {"DateStart", "2026/05/01"},
                                     {"effective", "2026-05-01"},  {"valid_from", "2026-05-01T00:00:00Z"},
                                     {"DATSTA", "20260501"},       {"BeginDate", "2026-05"}};
  const std::vector<Spelling> ends{
      {"end_date", "2026-05-31"},   {"DateEnd", "2026/05/31"},           {"EXPDATE", "2026-05"},
      {"validUntil", "2026-05-31"}, {"expires", "2026-06-01T00:00:00Z"}, {"DATEND", "20260531"}};
  const std::vector<Spelling> periods{
      {"period", "2026-05-01/2026-05-31"}, {"validity", "2026-05"}, {"active", "2026-05-01 to 2026-05-31"}};
  const std::vector<Spelling> tops{
      {"top_m", "20"}, {"depth_from", "20 m"}, {"UPPER", "20"}, {"MinDepth", "20.0"}};
  const std::vector<Spelling> bottoms{{"bottom_m", "150"}, {"depth_to", "150"}, {"lower", "150 m"}};
  const std::vector<Spelling> ordinary{
      {"OBJECTID", "7"},    {"Shape_Area", "0.5"}, {"edit_date", "2024-01-05"}, {"date_added", "2024-01-05"},
      {"created_us", "me"}, {"COUNTRY", "DK"},     {"start_lat", "50.25"},      {"NAME_E", "Somewhere"}};
  const auto one_of = [](const std::vector<Spelling>& spellings, std::mt19937_64& rng) {
    const auto last = static_cast<int>(spellings.size()) - 1;
    return spellings[static_cast<std::size_t>(support::uniform_int(rng, 0, last))];
  };
  support::for_each_seed(80, [&](std::mt19937_64& rng) {
    std::vector<Spelling> said{one_of(rules, rng)};
    if (support::uniform_int(rng, 0, 2) == 0) {
      said.push_back(one_of(periods, rng));
    } else {
      said.push_back(one_of(begins, rng));
      said.push_back(one_of(ends, rng));
    }
    said.push_back(one_of(tops, rng));
    said.push_back(one_of(bottoms, rng));
    for (const Spelling& other : ordinary)
      if (support::uniform_int(rng, 0, 1) == 0) said.push_back(other);
    std::ranges::shuffle(said, rng);
    Feature feature{triangle, {}};
    std::string trace;
    for (const auto& [name, text] : said) {
      feature.texts.emplace_back(name, text);
      trace += std::string{name} + "=" + text + " ";
    }
    const Format& format = formats[static_cast<std::size_t>(support::uniform_int(rng, 0, 3))];
    SCOPED_TRACE(format.driver + (" " + trace));

    const auto report = ingest(write(format, {feature}), {.zone_kind = "no_go"});

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    EXPECT_TRUE(report.warnings.empty()) << words(report);
    const auto zones = stored(report);
    ASSERT_EQ(zones.size(), 1U);
    EXPECT_EQ(zones.front().kind, ocean::ZoneKind::stay_in);
    EXPECT_EQ(core::iso8601(zones.front().from.value()), "2026-05-01T00:00:00Z");
    EXPECT_EQ(core::iso8601(zones.front().until.value()), "2026-06-01T00:00:00Z");
    EXPECT_EQ(zones.front().top, core::Metres{20.0});
    EXPECT_EQ(zones.front().bottom, core::Metres{150.0});
    db_ = repository::open_store_in_memory();
    for (const auto& file : std::filesystem::directory_iterator{path("")})
      if (file.path().stem() == "zones") std::filesystem::remove(file.path());
  });
}

TEST_F(Zones, WithWhatCannotBeReadAreRefusedByItsName) {
  for (const auto& [name, text] : std::initializer_list<Spelling>{{"start_date", "1 May 2026"},
                                                                  {"end_mo", "5"},
                                                                  {"PERSTA", "--0501"},
                                                                  {"period", "May to June"},
                                                                  {"opening_date", "2026-05-01"},
                                                                  {"project_end", "31.5.2026"},
                                                                  {"effective_", "2026-05-01"},
                                                                  {"upper", "shallow"},
                                                                  {"depth_to", "-100"},
                                                                  {"policy", "stay in"}}) {
    SCOPED_TRACE(name);
    const auto report = ingest(write(formats[2], {{triangle, {{"kind", "no_go"}, {name, text}}}}));
    EXPECT_EQ(report.status, IngestStatus::refused);
    EXPECT_THAT(messages::sentences(report.errors), Contains(HasSubstr("\"" + std::string{name} + "\"")));
    std::filesystem::remove(path(formats[2].file));
  }
}

TEST_F(Zones, TellWhatTheirAttributesSeemToSayAndIsNotObeyed) {
  const Feature park{triangle, {{"type", "Reserve"}, {"mean_depth", "40"}, {"fecha_fin", "31/05/2026"}}};
  const auto report = ingest(write(formats[2], {park, park}), {.zone_kind = "no_go"});

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(report.warnings, SizeIs(3));
  EXPECT_THAT(messages::sentences(report.warnings),
              Contains(testing::AllOf(
                  HasSubstr("feature 1 (one of 2 features with \"type\"): \"type\" is \"Reserve\""),
                  HasSubstr("2 features with \"type\""))));
  EXPECT_THAT(messages::sentences(report.warnings), Contains(HasSubstr("\"mean_depth\" is \"40\"")));
  EXPECT_THAT(messages::sentences(report.warnings), Contains(HasSubstr("\"fecha_fin\" is \"31/05/2026\"")));
}

TEST_F(Zones, AreToldOfATruthValueAsTheFileWritesIt) {
  const auto told = words(ingest(
      write_file(
          "active.geojson",
          R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"type": false},
               "geometry": {"type": "Polygon", "coordinates": [[[-8,52],[-7,52],[-7,53],[-8,53],[-8,52]]]}}]})"),
      {.zone_kind = "no_go"}));
  EXPECT_THAT(told, HasSubstr("\"type\" is \"false\""));
}

TEST_F(Zones, TellOfFreeTextThatNamesADateUnlessTheyStateTheirPeriod) {
  const std::string text = "Trawling, nets to 60 m. Closed from 1 May 2026 until further notice.";
  const auto told = ingest(write(formats[2], {{triangle, {{"kind", "no_go"}, {"remarks", text}}}}));
  ASSERT_EQ(told.status, IngestStatus::stored) << words(told);
  EXPECT_THAT(messages::sentences(told.warnings),
              Contains(HasSubstr("a text with a date that is not obeyed")));
  std::filesystem::remove(path(formats[2].file));

  const Feature plain{triangle, {{"kind", "no_go"}, {"remarks", text}, {"from", "2026-05-01"}}};
  EXPECT_THAT(ingest(write(formats[2], {plain})).warnings, testing::IsEmpty());
}

TEST_F(Zones, MayHaveTheirDepthsInFeetAndFathoms) {
  const auto report = ingest(
      write(formats[2], {{triangle, {{"kind", "no_go"}, {"top_ft", "100"}, {"lower", "20 fathoms"}}}}));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_NEAR(stored(report).front().top.value, 30.48, 1e-9);
  EXPECT_NEAR(stored(report).front().bottom.value, 36.576, 1e-9);
}

TEST_F(Zones, TellEveryFaultOfEveryFeature) {
  const std::vector<Feature> faulty{
      {"POLYGON ((0 50,1 50,1 51,0 50))", {{"name", "A"}, {"kind", "maybe"}, {"from", "tomorrow"}}},
      {"POLYGON ((0 50,1 50,1 51,0 50))", {{"name", "B"}}},
      {"POLYGON ((0 50,2 52,2 50,0 52,0 50))", {{"name", "C"}, {"kind", "no_go"}}},
      {"POLYGON ((0 50,1 50,1 51,0 50))", {{"kind", "no_go"}, {"top_m", "90"}, {"bottom_m", "-5"}}},
      {"POLYGON ((0 50,1 50,1 51,0 50))",
       {{"kind", "no_go"}, {"from", "2026-11-21T00:00:00Z"}, {"until", "2026-11-20T00:00:00Z"}}},
      {"LINESTRING (0 50,1 50)", {{"kind", "no_go"}}},
      {"POLYGON ((0 50,1 50,1 51,0 50))", {{"kind", "no_go"}, {"from", "2026-11-21T00:00:00"}}}};
  const auto report = ingest(write(formats[2], faulty));

  EXPECT_EQ(report.status, IngestStatus::refused);
  EXPECT_EQ(stored_datasets(), 0U);
  EXPECT_THAT(report.errors, SizeIs(8)) << words(report);
  EXPECT_THAT(messages::sentences(report.errors),
              Contains(HasSubstr("feature 1 \"A\": \"kind\" is \"maybe\"")));
  EXPECT_THAT(messages::sentences(report.errors),
              Contains(HasSubstr("feature 1 \"A\": \"from\" is \"tomorrow\"")));
  EXPECT_THAT(messages::sentences(report.errors), Contains(HasSubstr("feature 2 \"B\": states no kind")));
  EXPECT_THAT(messages::sentences(report.errors),
              Contains(HasSubstr("feature 3 \"C\": crosses or touches itself")));
  EXPECT_THAT(messages::sentences(report.errors), Contains(HasSubstr("feature 4: \"bottom_m\" is \"-5\"")));
  EXPECT_THAT(messages::sentences(report.errors),
              Contains(HasSubstr("feature 5: ends at 2026-11-20T00:00:00Z, before it begins")));
  EXPECT_THAT(messages::sentences(report.errors), Contains(HasSubstr("feature 6: it is not a polygon")));
  EXPECT_THAT(messages::sentences(report.errors),
              Contains(HasSubstr("feature 7: \"from\" is \"2026-11-21T00:00:00\"")));
}

TEST_F(Zones, WithoutAKindTakeTheOneThatIsStatedForThem) {
  const Feature silent{"POLYGON ((0 50,1 50,1 51,0 50))", {{"name", "A"}}};
  const auto file = write(formats[1], {silent});
  expect_refused(file, "--zone-kind");

  const auto report = ingest(file, {.zone_kind = "stay_in"});

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(stored(report).front().kind, ocean::ZoneKind::stay_in);
}

TEST_F(Zones, WithoutAReferenceSystemAreRefusedUnlessOneIsStated) {
  const auto file = write(formats[3], {harbour}, 0);
  expect_refused(file, "--crs");

  EXPECT_EQ(ingest(file, {.crs = "EPSG:4326"}).status, IngestStatus::stored);
}

TEST_F(Zones, MayCrossTheAntimeridian) {
  const Feature strait{"POLYGON ((179 60,-179 60,-179 61,179 61,179 60))", {{"kind", "no_go"}}};
  const auto report = ingest(write(formats[0], {strait}));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(messages::sentences(report.warnings),
              Contains(HasSubstr("crosses the antimeridian and is 2 degrees")));
  const auto zones = stored(report);
  EXPECT_TRUE(geo::contains(zones.front().area, {179.9, 60.5}));
  EXPECT_TRUE(geo::contains(zones.front().area, {-179.9, 60.5}));
  EXPECT_FALSE(geo::contains(zones.front().area, {0.0, 60.5}));
  EXPECT_THAT(repository::ZoneRepository{db_}.at(report.dataset->id, {-179.5, 60.5}), SizeIs(1));
  EXPECT_THAT(repository::ZoneRepository{db_}.at(report.dataset->id, {178.5, 60.5}), SizeIs(0));
}

/// However a chart counts its longitudes on beyond 180 degrees.
TEST_F(Zones, MayCountTheirLongitudesOn) {
  for (const char* const wkt : {"POLYGON ((178 70,182 70,182 71,178 71,178 70))",
                                "POLYGON ((-182 70,-178 70,-178 71,-182 71,-182 70))"}) {
    const auto report = ingest(write(formats[2], {{wkt, {{"kind", "no_go"}}}}));

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    const repository::ZoneRepository zones{db_};
    EXPECT_THAT(zones.at(report.dataset->id, {179.0, 70.5}), SizeIs(1));
    EXPECT_THAT(zones.at(report.dataset->id, {-179.0, 70.5}), SizeIs(1));
    EXPECT_THAT(zones.at(report.dataset->id, {0.0, 70.5}), SizeIs(0));
    std::filesystem::remove(path(formats[2].file));
  }
}

/// Between the corners of such a zone there is no gap, however far apart they are.
TEST_F(Zones, MayLeadAllTheWayRound) {
  const Feature of_corners{"POLYGON ((-180 60,180 60,180 80,-180 80,-180 60))", {{"kind", "no_go"}}};
  const Feature of_pieces{
      "POLYGON ((0 60,60 60,120 60,180 60,240 60,300 60,360 60,360 80,300 80,240 80,180 80,120 80,60 80,0 "
      "80,0 "
      "60))",
      {{"kind", "no_go"}}};
  const Feature cap{"POLYGON ((-180 60,-120 60,-60 60,0 60,60 60,120 60,180 60,180 90,-180 90,-180 60))",
                    {{"kind", "no_go"}}};
  for (const Feature& band : {of_corners, of_pieces, cap}) {
    const auto report = ingest(write(formats[2], {band}));

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    EXPECT_EQ(geo::width_deg(report.dataset->bounds), 360.0);
    const repository::ZoneRepository zones{db_};
    for (double lon = -179.0; lon < 180.0; lon += 17.0) {
      EXPECT_THAT(zones.at(report.dataset->id, {lon, 70.0}), SizeIs(1)) << lon;
      EXPECT_THAT(zones.at(report.dataset->id, {lon, 59.0}), SizeIs(0)) << lon;
    }
    std::filesystem::remove(path(formats[2].file));
  }
}

/// On the polar stereographic plane, whose outlines have no seam. EPSG:3413 has 86.4 N at 395 km from the pole.
TEST_F(Zones, MayHoldAPoleOnAProjection) {
  const Feature round_the_pole{
      "POLYGON ((-400000 -400000,400000 -400000,400000 400000,-400000 400000,-400000 -400000))",
      {{"kind", "no_go"}}};
  const auto report = ingest(write(formats[2], {round_the_pole}, 3413));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const repository::ZoneRepository zones{db_};
  for (double lon = -179.5; lon < 180.0; lon += 23.0) {
    EXPECT_THAT(zones.at(report.dataset->id, {lon, 86.5}), SizeIs(1)) << lon;
    EXPECT_THAT(zones.at(report.dataset->id, {lon, 89.9}), SizeIs(1)) << lon;
    EXPECT_THAT(zones.at(report.dataset->id, {lon, 84.5}), SizeIs(0)) << lon;
  }
}

class Coastlines : public Zones {
 protected:
  [[nodiscard]] bool is_land(const IngestReport& report, geo::LonLat place) {
    const auto land = repository::CoastlineRepository{db_}.load(
        report.dataset->id, {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg});
    return geo::contains(report.dataset->bounds, place) &&
           std::ranges::any_of(land,
                               [&](const geo::Polygon& polygon) { return geo::contains(polygon, place); });
  }
};

/// As the Antarctic Digital Database has it (EPSG:3031), with the seam that files in longitude and latitude have, and
/// without.
TEST_F(Coastlines, HoldAntarcticaDownToThePole) {
  const Feature on_a_plane{
      "POLYGON ((-1500000 -1500000,1500000 -1500000,1500000 1500000,-1500000 1500000,-1500000 -1500000))",
      {{"kind", "land"}}};
  std::string seam = "-180 -90,-180 -72";
  std::string round;
  for (int lon = -179; lon < 180; lon += 2) {
    seam += "," + std::to_string(lon) + " -72";
    round += (round.empty() ? "" : ",") + std::to_string(lon) + " -72";
  }
  const Feature with_seam{"POLYGON ((" + seam + ",180 -72,180 -90,-180 -90))", {{"kind", "land"}}};
  const Feature without_seam{"POLYGON ((" + round + ",-179 -72))", {{"kind", "land"}}};
  for (const auto& [land, epsg] :
       {std::pair{on_a_plane, 3031}, std::pair{with_seam, 4326}, std::pair{without_seam, 4326}}) {
    const auto report = ingest(write(formats[2], {land}, epsg));

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    for (double lon = -179.9; lon < 180.0; lon += 13.0) {
      EXPECT_TRUE(is_land(report, {lon, -76.5})) << lon;
      EXPECT_TRUE(is_land(report, {lon, -89.0})) << lon;
      EXPECT_FALSE(is_land(report, {lon, -69.0})) << lon;
    }
    std::filesystem::remove(path(formats[2].file));
  }
}

TEST_F(Coastlines, WhoseEdgesCouldLeadEitherWayRoundAreRefused) {
  expect_refused(
      write(formats[0], {{"POLYGON ((-100 50,100 50,100 60,-100 60,-100 50))", {{"kind", "land"}}}}),
      "either way");
}

TEST_F(Zones, WhoseOutlineIsNotClearAreRefused) {
  expect_refused(
      write(formats[0], {{"POLYGON ((-100 50,100 50,100 60,-100 60,-100 50))", {{"kind", "no_go"}}}}),
      "either way");
  expect_refused(
      write(formats[2], {{"POLYGON ((0 80,80 80,160 80,-120 80,-40 80,0 80))", {{"kind", "no_go"}}}}),
      "leads round a pole");
}

TEST_F(Zones, OfATableAreTheSameFileOnlyWithTheSameTable) {
  const auto file = write(formats[3], {harbour});
  ASSERT_EQ(ingest(file).status, IngestStatus::stored);
  EXPECT_EQ(ingest(file).status, IngestStatus::unchanged);

  Feature moved = harbour;
  moved.texts[1].second = "stay_in";
  for (const char* const part : {"zones.shp", "zones.shx", "zones.dbf", "zones.prj"})
    std::filesystem::remove(path(part));
  EXPECT_EQ(ingest(write(formats[3], {moved})).status, IngestStatus::stored);
  EXPECT_EQ(stored_datasets(), 2U);
}

TEST_F(Zones, AreNotReadFromDamagedFiles) {
  for (const Format& format : {formats[1], formats[2], formats[3]}) {
    SCOPED_TRACE(format.driver);
    const auto file = write(format, {harbour, range});
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    const auto report = ingest(file);
    EXPECT_EQ(report.status, IngestStatus::refused);
    EXPECT_FALSE(report.errors.empty());
  }
  EXPECT_EQ(stored_datasets(), 0U);
}

}  // namespace
}  // namespace floeplan::ingest::zones_test
