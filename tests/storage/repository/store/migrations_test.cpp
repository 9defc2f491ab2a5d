#include "storage/repository/store/migrations.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <latch>
#include <thread>
#include <vector>

#include "storage/repository/access/audit_repository.hpp"
#include "storage/repository/access/token_repository.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/glider_track_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/features/zone_repository.hpp"
#include "storage/repository/store/schema.hpp"
#include "storage/repository/work/job_repository.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/storage/repository/store/older_stores.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::repository::migrations_test {
namespace {

std::string reason_why_not_opened(const std::filesystem::path& store) {
  try {
    const sql::Connection db = open_store(store);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(OpenStore, KeepsWhatIsThereWhenOpenedAgain) {
  const support::TemporaryFolder folder;
  {
    sql::Connection db = open_store(folder.path());
    DatasetRepository{db}.insert(sample_dataset("a", DatasetKind::icebergs));
  }

  sql::Connection db = open_store(folder.path());

  EXPECT_TRUE(DatasetRepository{db}.find({"a"}));
}

/// Takes a store back to the first schema, whose list of kinds was part of the table.
void return_to_first_schema(sql::Connection& db) {
  sql::execute(db, "PRAGMA foreign_keys = OFF");
  sql::execute(db, R"sql(
CREATE TABLE first_dataset (
  row INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  kind TEXT NOT NULL CHECK (kind IN ('bathymetry', 'currents', 'icebergs', 'coastline')),
  name TEXT NOT NULL,
  west_deg REAL NOT NULL,
  south_deg REAL NOT NULL,
  east_deg REAL NOT NULL,
  north_deg REAL NOT NULL,
  time_start_s REAL,
  time_end_s REAL,
  rows_accepted INTEGER NOT NULL,
  rows_refused INTEGER NOT NULL,
  file_name TEXT NOT NULL,
  file_size_bytes INTEGER NOT NULL,
  sha256 TEXT NOT NULL,
  ingested_s REAL NOT NULL,
  tool_version TEXT NOT NULL
) STRICT;
DROP INDEX dataset_by_owner;
ALTER TABLE dataset DROP COLUMN owner;
ALTER TABLE dataset DROP COLUMN arriving_s;
ALTER TABLE dataset DROP COLUMN run_s;
ALTER TABLE dataset DROP COLUMN outdated;
INSERT INTO first_dataset SELECT * FROM dataset;
DROP TABLE tide_constant;
DROP TABLE tide_station;
DROP TABLE water_level_station;
DROP TABLE water_level;
DROP TABLE dataset;
ALTER TABLE first_dataset RENAME TO dataset;
DROP TABLE zone;
DROP TABLE zone_box;
DROP TABLE glider_current;
DROP TABLE glider_track;
DROP TABLE glider_track_box;
DROP TABLE mesh_block;
DROP TABLE mesh;
DROP TABLE chart_polygon;
DROP TABLE chart_polygon_box;
DROP TABLE simulation_flight;
DROP TABLE simulation;
DROP INDEX plan_by_owner;
ALTER TABLE plan DROP COLUMN owner;
ALTER TABLE plan DROP COLUMN stored_bytes;
DROP TABLE login;
DROP TABLE token;
DROP TABLE first_token;
DROP TABLE audit;
DROP TABLE kept_answer;
DROP TABLE job_clock;
DROP TRIGGER job_added;
DROP TRIGGER job_changed;
DROP INDEX job_by_owner;
ALTER TABLE job DROP COLUMN class;
DROP INDEX job_by_digest;
DROP INDEX job_by_change;
ALTER TABLE job DROP COLUMN owner;
ALTER TABLE job DROP COLUMN digest;
ALTER TABLE job DROP COLUMN reply_json;
ALTER TABLE job DROP COLUMN change;
PRAGMA user_version = 1;
)sql");
}

TEST(OpenStore, BringsAnOlderStoreUpToDateWithEverythingInIt) {
  const support::TemporaryFolder folder;
  {
    sql::Connection db = open_store(folder.path());
    DatasetRepository{db}.insert(sample_dataset("a", DatasetKind::icebergs));
    IcebergRepository{db}.insert({"a"}, {sample_berg("berg", {-52.0, 69.0})});
    return_to_first_schema(db);
  }

  sql::Connection db = open_store(folder.path());

  EXPECT_EQ(DatasetRepository{db}.find({"a"}).value().warnings.size(), 2U);
  EXPECT_EQ(IcebergRepository{db}.count({}), 1);
  DatasetRepository{db}.insert(sample_dataset("b", DatasetKind::ice));
  DatasetRepository{db}.insert(sample_dataset("c", DatasetKind::zones));
  ocean::Zone zone;
  zone.area.outer = {{0.0, 60.0}, {1.0, 60.0}, {1.0, 61.0}};
  ZoneRepository{db}.insert({"c"}, {zone});
  EXPECT_TRUE(DatasetRepository{db}.remove({"a"}));
  EXPECT_EQ(IcebergRepository{db}.count({}), 0) << "foreign keys are obeyed again";
}

TEST(OpenStore, TellsTheClassesOfJobsThatWereAcceptedBeforeThereWereAny) {
  const support::TemporaryFolder folder;
  {
    sql::Connection db = open_store(folder.path());
    for (const char* process : {"plan-route", "simulate-plan", "fly-scenario", "ingest"}) {
      JobRecord job;
      job.id = {process};
      job.process = process;
      JobRepository{db}.submit(job);
    }
    sql::execute(db, "PRAGMA user_version = 12" + before_classes_of_jobs);
  }

  sql::Connection db = open_store(folder.path());

  const auto class_of = [&](const char* id) { return JobRepository{db}.find({id})->job_class; };
  EXPECT_EQ(class_of("plan-route"), JobClass::interactive);
  EXPECT_EQ(class_of("simulate-plan"), JobClass::batch);
  EXPECT_EQ(class_of("fly-scenario"), JobClass::batch);
  EXPECT_EQ(class_of("ingest"), JobClass::ingest);
}

TEST(OpenStore, KnowsOfTokensThatWereRevokedBeforeThatWasKept) {
  for (const char* caller : {"ship", "local"}) {
    const support::TemporaryFolder folder;
    {
      sql::Connection db = open_store(folder.path());
      AuditEntry planned;
      planned.caller = caller;
      planned.action = "plan-route";
      AuditRepository{db}.add(planned);
      sql::execute(db, "DROP TRIGGER note_first_token");
      sql::execute(db, "DROP TABLE first_token");
      sql::execute(db, "PRAGMA user_version = 13" + before_owners_of_plans);
    }
    sql::Connection db = open_store(folder.path());
    EXPECT_EQ(TokenRepository{db}.ever_any(), std::string{caller} == "ship") << caller;
  }
}

TEST(OpenStore, KnowsNoRunOfWhatWasStoredBeforeRunsWereKept) {
  const support::TemporaryFolder folder;
  {
    sql::Connection db = open_store(folder.path());
    DatasetRepository{db}.insert(sample_dataset("a", DatasetKind::currents));
    sql::execute(db,
                 "DROP TABLE glider_current; DROP TABLE glider_track; DROP TABLE glider_track_box;"
                 "ALTER TABLE dataset DROP COLUMN arriving_s; ALTER TABLE dataset DROP COLUMN run_s;"
                 "ALTER TABLE dataset DROP COLUMN outdated;"
                 "PRAGMA user_version = 7" +
                     before_classes_of_jobs);
  }

  sql::Connection db = open_store(folder.path());

  EXPECT_EQ(DatasetRepository{db}.list().size(), 1U);
  EXPECT_FALSE(DatasetRepository{db}.find({"a"}).value().run);
}

TEST(OpenStore, TakesTracksOfGlidersIntoAStoreThatWasMadeBeforeThem) {
  const support::TemporaryFolder folder;
  {
    sql::Connection db = open_store(folder.path());
    DatasetRepository{db}.insert(sample_dataset("a", DatasetKind::icebergs));
    sql::execute(db,
                 "DROP TABLE glider_current; DROP TABLE glider_track; DROP TABLE glider_track_box;"
                 "ALTER TABLE dataset DROP COLUMN outdated; PRAGMA user_version = 8" +
                     before_classes_of_jobs);
  }

  sql::Connection db = open_store(folder.path());

  DatasetRepository{db}.insert(sample_dataset("b", DatasetKind::glider_tracks));
  GliderTrackRepository{db}.insert(
      {"b"}, {{.glider = "amadeus", .points = {{.time = {}, .place = {}}}, .currents = {}}});
  EXPECT_EQ(GliderTrackRepository{db}.count({}), 1);
  EXPECT_EQ(DatasetRepository{db}.list().size(), 2U);
}

/// A dataset of one track, with the variables and the currents that it was read with.
void store_track(sql::Connection& db, const std::string& id, std::vector<std::string> variables,
                 bool current) {
  Dataset dataset = sample_dataset(id, DatasetKind::glider_tracks);
  dataset.variables = std::move(variables);
  dataset.warnings = {"seen from afar"};
  DatasetRepository{db}.insert(dataset);
  ocean::GliderTrack track{.glider = "amadeus", .points = {{.time = {}, .place = {}}}, .currents = {}};
  if (current) track.currents.push_back({{}, {}, {{0.1}, {0.2}}});
  GliderTrackRepository{db}.insert({id}, {track});
}

TEST(OpenStore, MarksTheCurrentsOfSlocumsThatWereStoredInTheirOwnAxes) {
  const support::TemporaryFolder folder;
  {
    sql::Connection db = open_store(folder.path());
    store_track(db, "slocum", {"m_present_time", "m_gps_lat", "m_water_vx"}, true);
    store_track(db, "without", {"m_present_time", "m_gps_lat"}, false);
    store_track(db, "netcdf", {"time", "lat", "lon", "u", "v"}, true);
    sql::execute(db,
                 "ALTER TABLE dataset DROP COLUMN outdated; ALTER TABLE glider_track DROP COLUMN frame;"
                 "ALTER TABLE glider_track DROP COLUMN variation_source;"
                 "ALTER TABLE glider_track DROP COLUMN variation_west_rad;"
                 "ALTER TABLE glider_track DROP COLUMN utm_zone; PRAGMA user_version = 10" +
                     before_classes_of_jobs);
  }

  sql::Connection db = open_store(folder.path());

  const DatasetRepository datasets{db};
  EXPECT_TRUE(datasets.find({"slocum"})->outdated);
  EXPECT_THAT(datasets.find({"slocum"})->warnings,
              testing::ElementsAre("seen from afar", testing::HasSubstr("own axes")));
  for (const char* id : {"without", "netcdf"}) {
    EXPECT_FALSE(datasets.find({id})->outdated);
    EXPECT_THAT(datasets.find({id})->warnings, testing::ElementsAre("seen from afar"));
  }
  const GliderTrackRepository tracks{db};
  EXPECT_EQ(tracks.list({.dataset = DatasetId{"slocum"}}, 0, 1).tracks.at(0).track.frame,
            ocean::CurrentFrame::vehicle);
  EXPECT_EQ(tracks.list({.dataset = DatasetId{"netcdf"}}, 0, 1).tracks.at(0).track.frame,
            ocean::CurrentFrame::stated);
}

TEST(OpenStore, RefusesTheStoreOfANewerProgram) {
  const support::TemporaryFolder folder;
  {
    sql::Connection db = open_store(folder.path());
    sql::execute(db, "PRAGMA user_version = 1000");
  }

  EXPECT_THAT(reason_why_not_opened(folder.path()),
              testing::AllOf(testing::HasSubstr("newer Floeplan"), testing::HasSubstr("1000")));
}

TEST(OpenStore, RefusesTheDatabaseOfAnotherProgram) {
  const support::TemporaryFolder folder;
  {
    sql::Connection db = sql::Connection::open(folder.path());
    sql::execute(db, "PRAGMA application_id = 12345; CREATE TABLE bookmark (url TEXT)");
  }

  EXPECT_THAT(reason_why_not_opened(folder.path()), testing::HasSubstr("another program"));
}

TEST(OpenStore, IsCreatedOnceWhenManyOpenItAtTheSameTime) {
  const support::TemporaryFolder folder;
  constexpr int openers = 6;
  std::latch together{openers};
  std::vector<std::string> reasons(openers);
  {
    std::vector<std::jthread> threads;
    for (std::string& reason : reasons) {
      threads.emplace_back([&] {
        together.arrive_and_wait();
        reason = reason_why_not_opened(folder.path());
      });
    }
  }
  EXPECT_THAT(reasons, testing::Each(""));
}

TEST(OpenStore, FailsWithAClearReasonWhenTheFileIsDamaged) {
  const support::TemporaryFolder folder;
  const auto file = folder.path() / "floeplan.sqlite";
  {
    sql::Connection db = open_store(folder.path());
    sql::Transaction transaction{db};
    for (int i = 0; i < 200; ++i) {
      PlanRecord plan;
      plan.id = {std::to_string(i)};
      plan.document_json = std::string(2000, 'x');
      PlanRepository{db}.insert(plan);
    }
    transaction.commit();
  }
  {
    std::fstream damage{file, std::ios::in | std::ios::out | std::ios::binary};
    damage.seekp(8192);
    damage << std::string(std::filesystem::file_size(file) - 8192, '\x5a');
  }

  try {
    sql::Connection db = open_store(folder.path());
    (void)PlanRepository{db}.list({}, 0, 1000);
    (void)JobRepository{db}.list(0, 1000);
    (void)DatasetRepository{db}.list();
    FAIL() << "the damage was not noticed";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::HasSubstr("damaged"), testing::HasSubstr(file.string())));
  }
}

}  // namespace
}  // namespace floeplan::repository::migrations_test
