#include "storage/ingest/files/archive.hpp"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogrsf_frmts.h>

#include <array>
#include <fstream>
#include <iterator>

#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/process/guarded_ingest.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "tests/storage/ingest/support/archive_writer.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/places.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::archive_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

const std::string berg = R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties":
    {"id": "a", "observed": "2026-11-20T06:00:00Z", "length_m": 120}, "geometry": {"type": "Point",
    "coordinates": [-52.0, 69.0]}}]})";

class Archives : public StoreFixture {
 protected:
  std::filesystem::path pack(const std::string& name, Packing packing, const ArchiveMembers& members) const {
    write_archive(path(name), packing, members);
    return path(name);
  }

  static void write_shapefile(const std::filesystem::path& file) {
    register_drivers();
    GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("ESRI Shapefile");
    const GDALDatasetUniquePtr written{driver.Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr)};
    OGRSpatialReference wgs84;
    wgs84.importFromEPSG(4326);
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRLayer* const layer = written->CreateLayer("bergs", &wgs84, wkbPoint, nullptr);
    OGRFeatureDefn& columns = *layer->GetLayerDefn();
    OGRFieldDefn id{"id", OFTString};
    OGRFieldDefn observed{"observed", OFTString};
    ASSERT_EQ(layer->CreateField(&id), OGRERR_NONE);
    ASSERT_EQ(layer->CreateField(&observed), OGRERR_NONE);
    OGRFeature feature{&columns};
    feature.SetField("id", "b");
    feature.SetField("observed", "2026-11-20T06:30:00Z");
    OGRPoint place{-50.0, 60.0};
    feature.SetGeometry(&place);
    ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
  }

  std::vector<IngestReport> guarded(const std::vector<std::filesystem::path>& files,
                                    const IngestOptions& options = {}) {
    return guarded_ingest(db_, guard_, files, options, core::from_unix_seconds(1.8e9), {}, {}, {});
  }

  void expect_unpack_refused(const std::filesystem::path& file, const std::string& reason) {
    const auto reports = guarded({file});
    ASSERT_THAT(reports, SizeIs(1));
    EXPECT_EQ(reports.front().status, IngestStatus::refused);
    EXPECT_THAT(words(reports.front()), HasSubstr(reason));
    EXPECT_THAT(words(reports.front()), testing::Not(HasSubstr(path("").string())));
    EXPECT_THAT(reports.front().files, ElementsAre(file));
    EXPECT_EQ(stored_datasets(), 0U);
    EXPECT_TRUE(std::filesystem::is_empty(guard_.staging));
  }

  const Guard guard_{.program = support::program_folder() + "/ingest_reader", .staging = path("incoming")};
};

TEST_F(Archives, OfEveryPackingHoldTheSameDatasetAsTheFileAlone) {
  const auto plain = guarded({write_file("bergs.geojson", berg)}).front();
  ASSERT_EQ(plain.status, IngestStatus::stored) << words(plain);
  const ArchiveMembers members{{"bergs.geojson", berg}};
  for (const auto& [name, packing] :
       std::to_array<std::pair<const char*, Packing>>({{"bergs.zip", Packing::zip},
                                                       {"bergs.tar.gz", Packing::tar_gz},
                                                       {"bergs.geojson.gz", Packing::gzip},
                                                       {"bergs.geojson.bz2", Packing::bzip2},
                                                       {"bergs.geojson.xz", Packing::xz},
                                                       {"bergs.geojson.zst", Packing::zstd}})) {
    const auto reports = guarded({pack(name, packing, members)});
    ASSERT_THAT(reports, SizeIs(1)) << name;
    EXPECT_EQ(reports.front().status, IngestStatus::unchanged) << name << words(reports.front());
    EXPECT_EQ(reports.front().dataset->id, plain.dataset->id) << name;
    EXPECT_EQ(reports.front().file, name + std::string{": bergs.geojson"});
    EXPECT_THAT(reports.front().files, ElementsAre(path(name)));
  }
  EXPECT_TRUE(std::filesystem::is_empty(guard_.staging));
}

TEST_F(Archives, KeepTheirNameForTheOneDatasetInThem) {
  const auto kmz =
      pack("sightings.kmz", Packing::zip,
           {{"doc.kml",
             "<?xml version=\"1.0\"?><kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Placemark>"
             "<name>A99</name><TimeStamp><when>2026-11-20T06:30:00Z</when></TimeStamp><Point>"
             "<coordinates>-49.5,-60.25,0</coordinates></Point></Placemark></Document></kml>"},
            {"files/icon.png", "\x89PNG\r\n"},
            {"__MACOSX/._doc.kml", "finder"}});

  const auto reports = guarded({kmz});

  ASSERT_EQ(reports.front().status, IngestStatus::stored) << words(reports.front());
  EXPECT_EQ(reports.front().dataset->name, "sightings");
  EXPECT_EQ(repository::DatasetRepository{db_}.list().front().provenance.file_name, "sightings.kmz: doc.kml");
  EXPECT_THAT(messages::sentences(reports.front().warnings), Contains(HasSubstr("files/icon.png")));
}

TEST_F(Archives, HoldSeveralDatasetsWithThePartsOfEachTogether) {
  write_shapefile(path("drift.shp"));
  CurrentFile{}.write(path("model.nc"));
  const auto chart =
      members_of({path("drift.shp"), path("drift.shx"), path("drift.dbf"), path("drift.prj")}, "week 47\\");
  ArchiveMembers members = members_of({path("model.nc")});
  members.insert(members.end(), chart.begin(), chart.end());
  members.emplace_back("readme.txt", "A letter.");
  members.emplace_back("week 47\\drift.shp.xml", "<metadata/>");

  const auto reports = guarded({pack("sea.zip", Packing::zip, members)});

  ASSERT_THAT(reports, SizeIs(2));
  EXPECT_EQ(reports[0].file, "sea.zip: model.nc");
  EXPECT_EQ(reports[0].status, IngestStatus::stored) << words(reports[0]);
  EXPECT_THAT(messages::sentences(reports[0].warnings), Contains(HasSubstr("readme.txt")));
  EXPECT_EQ(reports[1].file, "sea.zip: drift.shp");
  EXPECT_EQ(reports[1].status, IngestStatus::stored) << words(reports[1]);
  EXPECT_EQ(reports[1].dataset->name, "drift");
}

TEST_F(Archives, AreNotNeededForTheFilesOfAShapefile) {
  write_shapefile(path("drift.shp"));

  const auto reports = guarded({path("drift.dbf"), path("drift.prj"), path("drift.shp"), path("drift.shx")});

  ASSERT_THAT(reports, SizeIs(1));
  EXPECT_EQ(reports.front().status, IngestStatus::stored) << words(reports.front());
  EXPECT_EQ(reports.front().file, "drift.shp");
}

TEST_F(Archives, ThatLeadOutOfTheirFolderAreRefused) {
  for (const char* name :
       {"../escaped.geojson", "/escaped.geojson", "a/../../escaped.geojson", "C:\\escaped.geojson"})
    expect_unpack_refused(pack("bad.zip", Packing::zip, {{name, berg}}), "leads out of the archive");
}

TEST_F(Archives, WithOneNameTwiceAreRefused) {
  expect_unpack_refused(pack("twice.zip", Packing::zip, {{"a.geojson", berg}, {"a.geojson", berg + " "}}),
                        "two files of the name a.geojson");
}

TEST_F(Archives, WithoutDataAreRefused) {
  expect_unpack_refused(pack("letter.zip", Packing::zip, {{"readme.txt", "A letter."}}), "only readme.txt");
}

TEST_F(Archives, InsideArchivesAreRefusedByName) {
  const auto inner = pack("inner.zip", Packing::zip, {{"a.geojson", berg}});
  const auto reports = guarded({pack("outer.zip", Packing::zip, members_of({inner}))});
  EXPECT_THAT(words(reports.front()), HasSubstr("compressed archive"));
}

TEST_F(Archives, ThatUnpackToFarMoreThanTheirSizeAreRefused) {
  const std::string bytes(150'000'000, 'x');  // in 150 kB
  for (const auto& [name, packing] : std::to_array<std::pair<const char*, Packing>>(
           {{"bomb.zip", Packing::zip}, {"bomb.nc.gz", Packing::gzip}}))
    expect_unpack_refused(pack(name, packing, {{"depths.nc", bytes}}), "unpacks to far more than its size");
}

TEST_F(Archives, CutShortOrWithBytesChangedAreNeverReadWrongly) {
  const ArchiveMembers members{{"bergs.geojson", berg}};
  for (const auto& [name, packing] : std::to_array<std::pair<const char*, Packing>>(
           {{"a.zip", Packing::zip}, {"a.geojson.gz", Packing::gzip}, {"a.geojson.xz", Packing::xz}})) {
    const std::string whole = members_of({pack(name, packing, members)}).front().second;
    support::for_each_seed(3, [&](std::mt19937_64& rng) {
      std::string bytes = whole;
      const auto at = std::uniform_int_distribution<std::size_t>{0, bytes.size() - 1}(rng);
      if (support::uniform(rng, 0.0, 1.0) < 0.5) {
        bytes.resize(at);
      } else {
        bytes[at] = static_cast<char>(bytes[at] ^ support::uniform_int(rng, 1, 255));
      }
      for (const IngestReport& report : guarded({write_file(name, bytes)})) {
        if (!report.dataset) continue;
        const auto stored = repository::IcebergRepository{db_}.list({}, 0, 10);
        ASSERT_THAT(stored, SizeIs(1));
        EXPECT_EQ(stored.front().iceberg.id, "a") << "a byte that means nothing was changed";
        EXPECT_EQ(stored.front().iceberg.place, (geo::LonLat{-52.0, 69.0}));
        repository::DatasetRepository{db_}.remove(report.dataset->id);
      }
    });
  }
}

TEST_F(Archives, OfALogWithoutAFixAreRefusedWithItsReason) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  expect_unpack_refused(sample_folder() / "glider/sea035.6.pld1.sub.1.gz", "no position of the glider");
}

}  // namespace
}  // namespace floeplan::ingest::archive_test
