#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/utc_text.hpp"
#include "storage/repository/features/ice_chart_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::s411_test {
namespace {

using testing::HasSubstr;

/// Charts as the ice services encode S-411 of edition 1.1.0 (clause 9.3): all areas with the same name, corners in
/// EPSG:4326 with the latitude first, several stages as a list.
class S411 : public StoreFixture {
 protected:
  static std::string area(const std::string& iceact, const std::string& icesod, const std::string& corners,
                          const std::string& crs = "http://www.opengis.net/def/crs/EPSG/0/4326") {
    return "<ice:IceFeatureMember><ice:seaice gml:id=\"seaice.None\">" +
           (iceact.empty() ? "" : "<ice:iceact>" + iceact + "</ice:iceact>") +
           (icesod.empty() ? "" : "<ice:icesod>" + icesod + "</ice:icesod>") +
           "<ice:iceflz>[7, 6]</ice:iceflz>" + "<gml:Polygon gml:id=\"g\"" +
           (crs.empty() ? "" : " srsName=\"" + crs + "\"") + "><gml:exterior><gml:LinearRing><gml:posList>" +
           corners +
           "</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon></ice:seaice></ice:IceFeatureMember>";
  }
  std::filesystem::path chart(const std::string& members) {
    return write_file(
        "S411_BSH_" + std::to_string(++charts_) + "_20261120.gml",
        "<?xml version='1.0' encoding='utf-8'?>\n<ice:IceDataSet "
        "xmlns:gml=\"http://www.opengis.net/gml/3.2\" xmlns:ice=\"http://www.jcomm.info/ice\">" +
            members + "</ice:IceDataSet>\n");
  }
  std::optional<ocean::IceState> ice_at(geo::LonLat place) {
    const auto ice = repository::FieldRepository{db_}.load_ice(report_.dataset->id,
                                                               {-70.0, 60.0, -40.0, 89.0}, std::nullopt);
    return ice ? ice->at(place, report_.dataset->time_start.value()) : std::nullopt;
  }
  std::optional<ocean::IceState> ice_of(const std::string& iceact, const std::string& icesod) {
    report_ = ingest(chart(area(iceact, icesod, "65 -60 65 -58 66 -58 66 -60 65 -60")));
    EXPECT_EQ(report_.status, IngestStatus::stored) << words(report_);
    return report_.dataset ? ice_at({-59.0, 65.5}) : std::nullopt;
  }

  IngestReport report_;
  int charts_{};
};

TEST_F(S411, KeepsTheMostIceThatItsCodesAllow) {
  const auto close_pack = ice_of("91", "[87, 85, 84]");
  ASSERT_TRUE(close_pack);
  EXPECT_NEAR(close_pack->concentration, 1.0, 1e-6);
  EXPECT_NEAR(close_pack->thickness->value, 0.7, 1e-6);
  EXPECT_EQ(core::iso8601(report_.dataset->time_start.value()), "2026-11-20T12:00:00Z");
  EXPECT_NEAR(ice_of("46", "83")->concentration, 0.6, 1e-6);
  EXPECT_FALSE(ice_of("80", "[84, 95]")->thickness) << "old ice has no upper bound";
  EXPECT_FALSE(ice_of("80", "[84, 99]")->thickness) << "nobody looked how thick one of them is";
  EXPECT_NEAR(ice_of("[85, 92]", "84")->concentration, 1.0, 1e-6) << "two totals are none";
  EXPECT_NEAR(ice_of("99", "84")->concentration, 1.0, 1e-6);
  EXPECT_NEAR(ice_of("", "84")->concentration, 1.0, 1e-6);
}

TEST_F(S411, KeepsItsAreasWithTheirEggCodes) {
  ASSERT_TRUE(ice_of("91", "[87, 85]"));
  const auto polygons =
      repository::IceChartRepository{db_}.load(report_.dataset->id, {-70.0, 60.0, -40.0, 89.0});
  ASSERT_EQ(polygons.size(), 1U);
  using repository::IceCode;
  EXPECT_THAT(polygons[0].codes,
              testing::ElementsAre(IceCode{"CT", "91"}, IceCode{"SA", "87"}, IceCode{"FA", "07"},
                                   IceCode{"SB", "85"}, IceCode{"FB", "06"}));
}

TEST_F(S411, CountsEveryNameOfNearlyOpenWaterAsLessThanATenth) {
  for (const char* const iceact : {"1", "01", "2", "3", "04"})
    EXPECT_NEAR(ice_of(iceact, "1")->concentration, 0.1, 1e-6) << iceact;
}

TEST_F(S411, LiesWhereItsCornersAreWithTheLatitudeFirst) {
  ASSERT_TRUE(ice_of("92", "86"));
  EXPECT_FALSE(ice_at({-57.0, 65.5}));
  EXPECT_FALSE(ice_at({-59.0, 67.0}));
}

TEST_F(S411, MayBeInAPolarProjectionWhoseEastingComesFirst) {
  // EPSG:3995 is polar stereographic: 45 degrees west runs along x = -y, and 80 N is 1,085 km from the pole.
  report_ = ingest(chart(
      area("92", "86", "-800000 -800000 -700000 -800000 -700000 -700000 -800000 -700000 -800000 -800000",
           "urn:ogc:def:crs:EPSG::3995")));
  ASSERT_EQ(report_.status, IngestStatus::stored) << words(report_);
  EXPECT_TRUE(ice_at({-45.0, 80.2}));
  EXPECT_FALSE(ice_at({-45.0, 83.0}));
}

TEST_F(S411, HasHolesWhereItsPolygonsHaveSome) {
  std::string holed = area("92", "86", "64 -64 64 -56 68 -56 68 -64 64 -64");
  const std::string end = "</gml:exterior>";
  holed.insert(holed.find(end) + end.size(),
               "<gml:interior><gml:LinearRing><gml:posList>65 -62 65 -58 67 -58 67 -62 65 -62"
               "</gml:posList></gml:LinearRing></gml:interior>");
  report_ = ingest(chart(holed));
  ASSERT_EQ(report_.status, IngestStatus::stored) << words(report_);
  EXPECT_TRUE(ice_at({-63.0, 64.5}));
  EXPECT_FALSE(ice_at({-60.0, 66.0}));
}

TEST_F(S411, NamesWhatItHoldsBesides) {
  report_ =
      ingest(chart(area("92", "86", "65 -60 65 -58 66 -58 66 -60 65 -60") +
                   "<ice:IceFeatureMember><ice:icebrg><ice:icebsz>4</ice:icebsz><gml:Point><gml:pos>65 -59"
                   "</gml:pos></gml:Point></ice:icebrg></ice:IceFeatureMember>"));
  ASSERT_EQ(report_.status, IngestStatus::stored) << words(report_);
  EXPECT_THAT(words(report_), HasSubstr("left out: icebrg"));
}

TEST_F(S411, IsRefusedWhereItsIceWouldBeAGuess) {
  const std::string corners = "65 -60 65 -58 66 -58 66 -60 65 -60";
  expect_refused(chart(area("92", "86", "-120 65 -118 65 -118 66 -120 66 -120 65")), "latitude comes first");
  expect_refused(chart(area("92", "86", "65 -60 65 -58 66")), "not a closed outline of pairs of numbers");
  expect_refused(chart(area("92", "86", "65 -60 65 west 66 -58 66 -60 65 -60")),
                 "not a closed outline of pairs of numbers");
  expect_refused(chart(area("92", "86", corners) + area("92", "86", corners, "EPSG:3995")),
                 "in one coordinate reference system");
  expect_refused(chart(area("92", "86", corners, "EPSG:1")), "EPSG:1");
  expect_refused(chart(area("92", "90", corners)), "90");
  expect_refused(chart("<ice:IceFeatureMember><ice:lacice/></ice:IceFeatureMember>"), "areas of sea ice");
  expect_refused(chart("<ice:IceFeatureMember><ice:seaice/></ice:IceFeatureMember>"), "has no polygon");
  expect_refused(write_file("S411_20261120.gml", "<ice:IceDataSet xmlns:ice=\"http://www.jcomm.info/ice\">"),
                 "cannot be read");
}

TEST_F(S411, OfEdition1_2IsRefusedByName) {
  expect_refused(
      write_file(
          "4112C000TDS02_20261120.gml",
          "<?xml version=\"1.0\"?><Dataset xmlns:S100=\"http://www.iho.int/s100gml/5.0\">"
          "<S100:DatasetIdentificationInformation><S100:productIdentifier>S-411</S100:productIdentifier>"
          "</S100:DatasetIdentificationInformation><members/></Dataset>"),
      "edition 1.2 or later");
}

}  // namespace
}  // namespace floeplan::ingest::s411_test
