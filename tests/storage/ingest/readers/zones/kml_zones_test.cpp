#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>

#include "engine/core/utc_text.hpp"
#include "storage/repository/features/zone_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::kml_zones_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

const std::string square =
    "<Polygon><outerBoundaryIs><LinearRing><coordinates>-8,52,0 -7,52,0 -7,53,0 -8,53,0 -8,52,0</coordinates>"
    "</LinearRing></outerBoundaryIs></Polygon>";

std::string element(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name + ">";
}

std::string simple_data(const std::string& name, const std::string& text) {
  return "<SimpleData name=\"" + name + "\">" + text + "</SimpleData>";
}

/// A placemark with these attributes, of which the file's schema declares `declared`.
std::string with_schema(const std::string& declared, const std::string& simple) {
  std::string fields;
  for (std::size_t at = 0; at < declared.size();) {
    const std::size_t end = std::min(declared.find(' ', at), declared.size());
    fields += "<SimpleField name=\"" + declared.substr(at, end - at) + "\" type=\"string\"/>";
    at = end + 1;
  }
  return "<Schema id=\"s\">" + fields + "</Schema>" +
         element("Placemark", "<name>A</name><ExtendedData><SchemaData schemaUrl=\"#s\">" + simple +
                                  "</SchemaData></ExtendedData>" + square);
}

class KmlZones : public StoreFixture {
 protected:
  std::filesystem::path kml(const std::string& content) const {
    return write_file("zones.kml",
                      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                      "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>\n" +
                          content + "</Document></kml>");
  }

  /// "no_go 2026-05-01T00:00:00Z/..", or the refusal.
  [[nodiscard]] std::string rule_of(const std::string& content, const IngestOptions& options = {}) {
    const IngestReport report = ingest(kml(content), options);
    if (report.status != IngestStatus::stored) return words(report);
    const auto zones = repository::ZoneRepository{db_}.load(report.dataset->id, {-180.0, -90.0, 180.0, 90.0},
                                                            core::from_unix_seconds(0.0));
    const auto time = [](const auto& moment) { return moment ? core::iso8601(*moment) : ".."; };
    return zones.size() != 1 ? std::to_string(zones.size()) + " zones"
                             : std::string{ocean::zone_kind_name(zones.front().kind)} + " " +
                                   time(zones.front().from) + "/" + time(zones.front().until);
  }

  [[nodiscard]] std::string rule_of_span(const std::string& time, const std::string& around = "") {
    return rule_of(element("Folder", around + element("Placemark", "<name>A</name>" + time + square)),
                   {.zone_kind = "no_go"});
  }
};

TEST_F(KmlZones, KeepAttributesThatNoSchemaDeclares) {
  EXPECT_EQ(
      rule_of(with_schema("kind", simple_data("kind", "no_go") + simple_data("valid_from", "2026/05/01") +
                                      simple_data("valid_to", "2026/05/31"))),
      "no_go 2026-05-01T00:00:00Z/2026-06-01T00:00:00Z");
  EXPECT_EQ(
      rule_of(with_schema("", simple_data("kind", "stay_in") + simple_data("until", "2026-04-01T00:00:00Z")),
              {.zone_kind = "no_go"}),
      "stay_in ../2026-04-01T00:00:00Z")
      << "what the file says is stronger than what is said for all that state nothing";
  EXPECT_EQ(rule_of(element("Placemark",
                            "<ExtendedData xmlns:z=\"u\"><z:rule>keep out</z:rule><z:when><z:until>2026-04"
                            "</z:until></z:when></ExtendedData>" +
                                square)),
            "no_go ../2026-05-01T00:00:00Z");
}

TEST_F(KmlZones, SpanDaysMonthsAndYearsWhole) {
  EXPECT_EQ(rule_of_span("<TimeSpan><begin>2026-05-01</begin><end>2026-06-01</end></TimeSpan>"),
            "no_go 2026-05-01T00:00:00Z/2026-06-02T00:00:00Z");
  EXPECT_EQ(rule_of_span("<TimeSpan><begin>2026-05</begin><end>2026-06</end></TimeSpan>"),
            "no_go 2026-05-01T00:00:00Z/2026-07-01T00:00:00Z");
  EXPECT_EQ(rule_of_span("<TimeSpan><begin>2026</begin></TimeSpan>"), "no_go 2026-01-01T00:00:00Z/..");
  EXPECT_EQ(
      rule_of_span("<TimeSpan><begin>2026-05-01T00:00:00Z</begin><end>2026-06-01T00:00:00Z</end></TimeSpan>"),
      "no_go 2026-05-01T00:00:00Z/2026-06-01T00:00:00Z");
  EXPECT_EQ(rule_of_span("<TimeStamp><when>2026-05</when></TimeStamp>"),
            "no_go 2026-05-01T00:00:00Z/2026-06-01T00:00:00Z");
}

TEST_F(KmlZones, AreHeldByTheTimeSpanOfTheirFolderToo) {
  const std::string may = "<TimeSpan><begin>2026-05</begin><end>2026-05</end></TimeSpan>";
  EXPECT_EQ(rule_of_span("", may), "no_go 2026-05-01T00:00:00Z/2026-06-01T00:00:00Z");
  EXPECT_EQ(rule_of_span("<TimeSpan><begin>2026-05-20</begin></TimeSpan>", may),
            "no_go 2026-05-20T00:00:00Z/2026-06-01T00:00:00Z");
  EXPECT_EQ(rule_of("<TimeSpan><end>2026-05-10</end></TimeSpan>" +
                        element("Folder", may + element("Placemark", square)),
                    {.zone_kind = "stay_in"}),
            "stay_in 2026-05-01T00:00:00Z/2026-05-11T00:00:00Z");
}

TEST_F(KmlZones, WhosePeriodIsNotThatOfTheirFolderAreRefusedWithBoth) {
  const std::string refusal =
      rule_of_span("<TimeSpan><begin>2026-05-01</begin><end>2026-06-01</end></TimeSpan>",
                   "<TimeSpan><begin>2026-01-01</begin><end>2026-03-01</end></TimeSpan>");
  EXPECT_THAT(refusal, HasSubstr("its own period (2026-05-01T00:00:00Z to 2026-06-02T00:00:00Z)"));
  EXPECT_THAT(refusal, HasSubstr("the period of its folder (2026-01-01T00:00:00Z to 2026-03-02T00:00:00Z)"));
}

/// The report names words that suggest the other rule, wherever they stand, but not words of the own rule of
/// the zone.
TEST_F(KmlZones, TellWordsOfTheOtherRule) {
  const auto told = [&](const std::string& around, const std::string& name, const std::string& text,
                        const char* kind) {
    return words(ingest(
        kml(element("Folder",
                    element("name", around) +
                        element("Placemark", element("name", name) + element("description", text) + square))),
        {.zone_kind = kind}));
  };
  EXPECT_THAT(told("stay_in", "A", "", "no_go"),
              HasSubstr("\"names of the folders around\" is \"stay_in\". These words suggest stay_in"));
  EXPECT_THAT(told("zones", "Stay-In box until June", "", "no_go"), HasSubstr("words suggest stay_in"));
  EXPECT_THAT(told("zones", "A", "Vehicle must stay inside this box", "no_go"),
              HasSubstr("words suggest stay_in"));
  EXPECT_THAT(told("zones", "Cable: keep out", "", "stay_in"), HasSubstr("words suggest no_go"));
  EXPECT_THAT(told("stay_in", "A", "Must stay inside", "stay_in"), testing::Not(HasSubstr("words suggest")));
  EXPECT_THAT(told("fishing banks", "mainstay inlet", "", "no_go"), testing::Not(HasSubstr("words suggest")));
}

TEST_F(KmlZones, AreRefusedWithWhatTheFileHolds) {
  const std::string stamp = rule_of_span("<TimeStamp><when>2026-05-01T06:00:00</when></TimeStamp>");
  EXPECT_THAT(stamp, HasSubstr("\"when of the TimeStamp\" is \"2026-05-01T06:00:00\""));
  EXPECT_THAT(stamp, testing::Not(HasSubstr("\"begin\"")));
  EXPECT_THAT(stamp, testing::Not(HasSubstr("\"end\"")));
  EXPECT_THAT(rule_of_span("<TimeSpan><begin>01.05.2026</begin></TimeSpan>"),
              HasSubstr("\"begin\" is \"01.05.2026\""));
  EXPECT_THAT(rule_of_span("", "<TimeSpan><end>soon</end></TimeSpan>"), HasSubstr("is \"soon\""));
  EXPECT_THAT(rule_of_span("<TimeStamp><when>2026-05-01T06:00:00Z</when></TimeStamp>"),
              HasSubstr("only at the moment"));
  EXPECT_THAT(
      rule_of_span("", "<ExtendedData><Data name=\"kind\"><value>stay_in</value></Data></ExtendedData>"),
      HasSubstr("line 3: the Folder states \"kind\""));
  EXPECT_THAT(rule_of_span("", "<NetworkLink><Link><href>more.kml</href></Link></NetworkLink>"),
              HasSubstr("NetworkLink"));
  EXPECT_THAT(rule_of(element("Placemark", "<Point><coordinates>1;2</coordinates></Point>")),
              HasSubstr("\"1;2\", which is not longitude,latitude"));
  EXPECT_THAT(rule_of(element("Folder", "")), HasSubstr("no placemarks"));
  const IngestReport cut =
      ingest(write_file("cut.kml", "<kml><Document><Placemark>" + square + "</Placemark>"));
  EXPECT_THAT(messages::sentences(cut.errors), Contains(HasSubstr("cut short")));
}

TEST_F(KmlZones, MayHavePrefixesAndUtf16) {
  const std::string prefixed =
      "<?xml version=\"1.0\"?><k:kml "
      "xmlns:k=\"http://www.opengis.net/kml/2.2\"><k:Placemark><k:name>A</k:name>"
      "<k:ExtendedData><k:Data name=\"kind\"><k:value>no_go</k:value></k:Data></k:ExtendedData><k:Polygon>"
      "<k:outerBoundaryIs><k:LinearRing><k:coordinates>0,50 1,50 1,51 0,50</k:coordinates></k:LinearRing>"
      "</k:outerBoundaryIs></k:Polygon></k:Placemark></k:kml>";
  std::string utf16 = "\xFF\xFE";
  for (const char c : prefixed) utf16 += std::string{c, '\0'};
  for (const std::string& bytes : {prefixed, utf16}) {
    const IngestReport report = ingest(write_file("zones.kml", bytes));
    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    EXPECT_THAT(report.dataset->variables, testing::ElementsAre("no_go"));
    std::filesystem::remove(path("zones.kml"));
    ASSERT_EQ(stored_datasets(), 1U);
    db_ = repository::open_store_in_memory();
  }
}

TEST_F(KmlZones, OfATextInUtf16ThatIsNoKmlAreRefusedForThat) {
  std::string utf16 = "\xFE\xFF";
  for (const char c : std::string{"id,lat,lon,time,length_m\n"}) utf16 += std::string{'\0', c};
  expect_refused(write_file("bergs.csv", utf16), "UTF-16");
}

/// The outlines that GDAL's own driver reads from the same file.
TEST_F(KmlZones, HaveTheOutlinesThatLibkmlReads) {
  register_writers();
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    std::string parts;
    for (int i = support::uniform_int(rng, 1, 4); i > 0; --i) {
      const double lon = support::uniform(rng, -170.0, 170.0);
      const double lat = support::uniform(rng, -70.0, 70.0);
      const auto ring = [&](double size, const std::string& separator) {
        std::string text;
        for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}})
          text += std::to_string(lon + size * x) + "," + std::to_string(lat + size * y) + separator;
        return "<LinearRing><coordinates>\n " + text + "</coordinates></LinearRing>";
      };
      parts += "<Polygon><outerBoundaryIs>" + ring(1.0, ",7\t") + "</outerBoundaryIs>" +
               (support::uniform_int(rng, 0, 1) == 0
                    ? ""
                    : "<innerBoundaryIs>" + ring(0.5, "\n") + "</innerBoundaryIs>") +
               "</Polygon>";
    }
    const auto file = kml(
        element("Placemark", "<ExtendedData><Data name=\"kind\"><value>no_go</value></Data></ExtendedData>" +
                                 element("MultiGeometry", parts)));
    const char* const drivers[] = {"LIBKML", nullptr};
    const std::unique_ptr<GDALDataset> peer{GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR, drivers)};
    ASSERT_NE(peer, nullptr);
    const std::unique_ptr<OGRFeature> feature{peer->GetLayer(0)->GetNextFeature()};

    const IngestReport report = ingest(file);

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    const auto zones = repository::ZoneRepository{db_}.load(report.dataset->id, {-180.0, -90.0, 180.0, 90.0},
                                                            core::from_unix_seconds(0.0));
    for (int i = 0; i < 200; ++i) {
      const OGRPoint place{support::uniform(rng, -172.0, 172.0), support::uniform(rng, -72.0, 72.0)};
      const bool is_inside = std::ranges::any_of(zones, [&](const ocean::Zone& zone) {
        return geo::contains(zone.area, {place.getX(), place.getY()});
      });
      ASSERT_EQ(is_inside, feature->GetGeometryRef()->Contains(&place) != 0);
    }
  });
}

/// Whatever form the rule and its times have, and wherever they stand.
TEST_F(KmlZones, NeverLoseTheirRuleOrTheirPeriod) {
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    const bool is_stay_in = support::uniform_int(rng, 0, 1) == 0;
    const int first_day = support::uniform_int(rng, 1, 20);
    const int last_day = support::uniform_int(rng, first_day, 27);
    const auto day = [&](int number, const char* separator) {
      std::string text = "2026" + std::string{separator} + "05" + separator;
      return text + (number < 10 ? "0" : "") + std::to_string(number);
    };
    const char* const separator = support::uniform_int(rng, 0, 1) == 0 ? "-" : "/";
    const std::string from = day(first_day, separator);
    const std::string until = day(last_day, separator);
    const std::string kind = is_stay_in ? "keep in" : "no-go";

    std::string data;
    std::string schema;
    std::string own_time;
    std::string around;
    const auto state = [&](const std::string& name, const std::string& text) {
      switch (support::uniform_int(rng, 0, 3)) {
        case 0:
          data += element("ExtendedData", "<Data name=\"" + name + "\"><value>" + text + "</value></Data>");
          break;
        case 1: schema += "<SimpleField name=\"" + name + "\" type=\"string\"/>"; [[fallthrough]];
        case 2: data += element("ExtendedData", element("SchemaData", simple_data(name, text))); break;
        default:
          data += element("ExtendedData", "<q:" + name + " xmlns:q=\"u\">" + text + "</q:" + name + ">");
          break;
      }
    };
    state("kind", kind);
    const std::string span =
        element("TimeSpan", element("begin", day(first_day, "-")) + element("end", day(last_day, "-")));
    switch (support::uniform_int(rng, 0, 2)) {
      case 0: own_time = span; break;
      case 1: around = span; break;
      default: state("valid_from", from); state("valid_to", until);
    }

    const std::string found = rule_of(
        "<Schema id=\"s\">" + schema + "</Schema>" +
            element("Folder", around + element("Placemark", "<name>A</name>" + own_time + data + square)),
        {.zone_kind = is_stay_in ? "no_go" : "stay_in"});

    EXPECT_EQ(found, std::string{is_stay_in ? "stay_in " : "no_go "} + day(first_day, "-") + "T00:00:00Z/" +
                         day(last_day + 1, "-") + "T00:00:00Z");
  });
}

class ZonesOfTables : public StoreFixture {
 protected:
  /// A GeoPackage with one zone whose columns of dates GDAL types; `change` is done to it in SQL.
  std::filesystem::path table(const std::string& change) const {
    register_writers();
    const std::filesystem::path file = path("zones.gpkg");
    GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("GPKG");
    const std::unique_ptr<GDALDataset> dataset{driver.Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr)};
    OGRSpatialReference crs;
    crs.importFromEPSG(4326);
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRLayer& layer = *dataset->CreateLayer("zones", &crs, wkbPolygon, nullptr);
    for (const auto& [name, type] :
         {std::pair{"kind", OFTString}, {"from", OFTDate}, {"until", OFTDateTime}}) {
      OGRFieldDefn field{name, type};
      layer.CreateField(&field);
    }
    OGRFeature row{layer.GetLayerDefn()};
    OGRGeometry* area = nullptr;
    OGRGeometryFactory::createFromWkt("POLYGON ((0 50,1 50,1 51,0 50))", nullptr, &area);
    row.SetGeometryDirectly(area);
    row.SetField("kind", "stay_in");
    row.SetField("from", 2026, 5, 1, 0, 0, 0.0F, 0);
    row.SetField("until", 2026, 5, 31, 6, 30, 0.0F, 100);
    EXPECT_EQ(layer.CreateFeature(&row), OGRERR_NONE);
    if (!change.empty()) dataset->ReleaseResultSet(dataset->ExecuteSQL(change.c_str(), nullptr, nullptr));
    return file;
  }
};

TEST_F(ZonesOfTables, KeepTheDatesOfTheirColumns) {
  const IngestReport report = ingest(table(""));
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(core::iso8601(report.dataset->time_start.value()), "2026-05-01T00:00:00Z");
  EXPECT_EQ(core::iso8601(report.dataset->time_end.value()), "2026-05-31T06:30:00Z");
}

TEST_F(ZonesOfTables, AreRefusedWhereAColumnHoldsWhatIsNoDate) {
  expect_refused(table("UPDATE zones SET \"from\" = 'soon'"), "soon");
  std::filesystem::remove(path("zones.gpkg"));
  expect_refused(table("UPDATE zones SET until = '2026-05-31T06:30:00'"), "2026-05-31T06:30:00");
}

}  // namespace
}  // namespace floeplan::ingest::kml_zones_test
