#include "storage/repository/datasets/dataset_repository.hpp"

#include <gmock/gmock.h>

#include "storage/repository/datasets/resampled.hpp"
#include "storage/repository/features/coastline_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::repository::dataset_repository_test {
namespace {

class DatasetRepositoryTest : public testing::Test {
 protected:
  std::int64_t rows(const std::string& table) {
    sql::Statement query{db_, "SELECT count(*) FROM " + table};
    return query.step() ? query.integer(0) : -1;
  }

  sql::Connection db_ = support::empty_store();
  DatasetRepository datasets_{db_};
};

TEST_F(DatasetRepositoryTest, GivesBackWhatWasInserted) {
  Dataset dataset = sample_dataset("currents-1", DatasetKind::currents, {170.1, -0.3, -170.2, 89.9});
  dataset.time_start = sample_time + core::Seconds{0.1};
  dataset.time_end = sample_time + day;
  datasets_.insert(dataset);

  const auto found = datasets_.find(dataset.id);

  ASSERT_TRUE(found);
  EXPECT_EQ(found->id, dataset.id);
  EXPECT_EQ(found->kind, dataset.kind);
  EXPECT_EQ(found->name, dataset.name);
  EXPECT_EQ(found->variables, dataset.variables);
  EXPECT_EQ(found->bounds, dataset.bounds);
  EXPECT_EQ(found->time_start, dataset.time_start);
  EXPECT_EQ(found->time_end, dataset.time_end);
  EXPECT_EQ(found->rows_accepted, dataset.rows_accepted);
  EXPECT_EQ(found->rows_refused, dataset.rows_refused);
  EXPECT_EQ(found->warnings, dataset.warnings);
  EXPECT_EQ(found->provenance.file_name, dataset.provenance.file_name);
  EXPECT_EQ(found->provenance.file_size_bytes, dataset.provenance.file_size_bytes);
  EXPECT_EQ(found->provenance.sha256, dataset.provenance.sha256);
  EXPECT_EQ(found->provenance.ingested, dataset.provenance.ingested);
  EXPECT_EQ(found->provenance.tool_version, dataset.provenance.tool_version);
}

TEST_F(DatasetRepositoryTest, KnowsWhenDataHaveNoTime) {
  datasets_.insert(sample_dataset("a", DatasetKind::bathymetry));
  EXPECT_EQ(datasets_.find({"a"})->time_start, std::nullopt);
  EXPECT_FALSE(datasets_.find({"b"}));
}

TEST_F(DatasetRepositoryTest, ListsTheNewestFirstAndTiesById) {
  for (const char* id : {"b", "a", "new"}) {
    Dataset dataset = sample_dataset(id, DatasetKind::bathymetry);
    if (dataset.id.value == "new") dataset.provenance.ingested += hour;
    datasets_.insert(dataset);
  }

  std::vector<std::string> ids;
  for (const Dataset& dataset : datasets_.list()) ids.push_back(dataset.id.value);
  EXPECT_THAT(ids, testing::ElementsAre("new", "a", "b"));
}

TEST_F(DatasetRepositoryTest, RemovesEverythingThatBelongsToADataset) {
  const geo::Polygon triangle{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, {}};
  for (const char* id : {"kept", "removed"}) {
    datasets_.insert(sample_dataset(id, DatasetKind::currents));
    FieldRepository fields{db_};
    fields.create({id}, {{geo::GeographicFrame{}, ocean::Axis{{0.0, 1.0}}, ocean::Axis{{0.0}}}, {}, {}});
    fields.write_slice({id}, "u_m_s", 0, 0, std::vector<float>{1.0F, 2.0F});
    IcebergRepository{db_}.insert({id}, {sample_berg("berg", {1.0, 2.0})});
    CoastlineRepository{db_}.insert({id}, {triangle});
  }

  EXPECT_TRUE(datasets_.remove({"removed"}));
  EXPECT_FALSE(datasets_.remove({"removed"}));

  for (const char* table :
       {"dataset", "grid", "field_chunk", "sighting", "sighting_box", "land_polygon", "land_polygon_box"}) {
    EXPECT_EQ(rows(table), 1) << table;
  }
  EXPECT_EQ(rows("dataset_text"), 4);
}

TEST_F(DatasetRepositoryTest, RefusesDataOfAnUnknownDataset) {
  EXPECT_THROW(IcebergRepository{db_}.insert({"unknown"}, {}), std::invalid_argument);
  EXPECT_THROW(CoastlineRepository{db_}.insert({"unknown"}, {}), std::invalid_argument);
  EXPECT_THROW(FieldRepository{db_}.write_slice({"unknown"}, "u_m_s", 0, 0, {}), std::invalid_argument);
}

TEST(DatasetRepository, KeepsNothingOfAnIngestionThatDidNotFinish) {
  const support::TemporaryFolder folder;
  {
    sql::Connection db = open_store(folder.path());
    const sql::Transaction ingestion{db};
    DatasetRepository{db}.insert(sample_dataset("a", DatasetKind::icebergs));
    IcebergRepository{db}.insert({"a"}, {sample_berg("berg", {1.0, 2.0})});
  }

  sql::Connection db = open_store(folder.path());
  EXPECT_TRUE(DatasetRepository{db}.list().empty());
  EXPECT_EQ(IcebergRepository{db}.count({}), 0);
}

TEST(DatasetKind, HasANameThatLeadsBackToItAndAWordForItsRows) {
  for (const auto kind : {DatasetKind::bathymetry, DatasetKind::currents, DatasetKind::wind, DatasetKind::ice,
                          DatasetKind::icebergs, DatasetKind::coastline, DatasetKind::tides,
                          DatasetKind::water_levels, DatasetKind::zones, DatasetKind::glider_tracks}) {
    EXPECT_EQ(parse_kind(kind_name(kind)), kind);
    EXPECT_EQ(rows_text(kind, 2), rows_text(kind, 1).replace(0, 1, "2") + "s");
  }
  EXPECT_EQ(parse_kind("weather"), std::nullopt);
  EXPECT_EQ(rows_text(DatasetKind::icebergs, 1), "1 sighting");
}

/// The sentences of earlier versions; a store keeps them as they were.
TEST(Resampled, IsKnownByTheWordsOfEarlierVersions) {
  const auto says = [](std::string warning) {
    return was_resampled(std::vector<std::string>{"another warning", std::move(warning)});
  };
  EXPECT_TRUE(says("resampled from a bent grid to a regular grid of 0.05 x 0.05 degrees"));
  EXPECT_TRUE(says("\"h\" was resampled from a bent grid of 30 x 40 points to a regular grid of 0.09 x 0.2"));
  EXPECT_TRUE(
      says("the grid was resampled from \"NAD83 / Alaska Albers\" to longitude and latitude. Beside"));
  EXPECT_FALSE(says("every depth is kept at its own place (1200 points, a bent grid)"));
}

TEST(NewestRunFirst, TakesOfOneRunTheDataThatNoOlderVersionResampled) {
  Dataset resampled = sample_dataset("a", DatasetKind::currents);
  resampled.run = sample_time;
  resampled.warnings = {"resampled from a bent grid to a regular grid of 0.05 x 0.05 degrees"};
  Dataset native = sample_dataset("b", DatasetKind::currents);
  native.run = sample_time;
  Dataset older = sample_dataset("c", DatasetKind::currents);
  older.run = sample_time - day;

  std::vector<Dataset> datasets{older, resampled, native};
  sort_newest_run_first(datasets);

  EXPECT_EQ(datasets[0].id, native.id);
  EXPECT_EQ(datasets[1].id, resampled.id);
  EXPECT_EQ(datasets[2].id, older.id);
}

TEST(NewestRunFirst, TakesOfOneRunAndPeriodWhatWasIngestedLast) {
  Dataset first = sample_dataset("b", DatasetKind::currents);
  first.run = sample_time;
  Dataset second = first;
  second.id = {"a"};
  second.provenance.ingested = first.provenance.ingested + day;

  std::vector<Dataset> datasets{first, second};
  sort_newest_run_first(datasets);

  EXPECT_EQ(datasets[0].id, second.id);
}

}  // namespace
}  // namespace floeplan::repository::dataset_repository_test
