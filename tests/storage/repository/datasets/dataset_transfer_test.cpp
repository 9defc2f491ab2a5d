#include "storage/repository/datasets/dataset_transfer.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::repository::dataset_transfer_test {
namespace {

Dataset named(const std::string& id) {
  Dataset dataset = sample_dataset(id, DatasetKind::icebergs);
  dataset.warnings = {"seen from afar"};
  return dataset;
}

void store(sql::Connection& db, const std::string& id, double lon_deg) {
  DatasetRepository{db}.insert(named(id));
  ocean::Iceberg sighting;
  sighting.id = id + "-berg";
  sighting.place = {lon_deg, 70.0};
  IcebergRepository{db}.insert({id}, {sighting});
}

std::int64_t count(sql::Connection& db, const std::string& rows) {
  sql::Statement query{db, "SELECT count(*) FROM " + rows};
  return query.step() ? query.integer(0) : -1;
}

TEST(DatasetTransfer, TakesOverWhatIsNewAndLeavesTheRestAsItWas) {
  const support::TemporaryFolder arrived;
  auto db = support::empty_store();
  store(db, "icebergs-here", -50.0);
  {
    auto scratch = open_scratch_store(arrived.path());
    DatasetRepository{scratch}.insert(named("icebergs-here"));  // listed there, its data are here alone
    store(scratch, "icebergs-new", -55.0);
  }

  const auto ids = take_over_datasets(db, arrived.path());

  EXPECT_EQ(ids, std::vector{DatasetId{"icebergs-new"}});
  EXPECT_EQ(count(db, "dataset"), 2);
  EXPECT_EQ(DatasetRepository{db}.find({"icebergs-new"})->warnings,
            std::vector<std::string>{"seen from afar"});
  EXPECT_EQ(count(db, "sighting JOIN dataset ON dataset.row = dataset_row WHERE berg_id = id || '-berg'"), 2);
  EXPECT_EQ(
      count(db, "sighting JOIN sighting_box USING (row) WHERE west_deg BETWEEN lon_deg - 1 AND lon_deg"), 2);
}

TEST(DatasetTransfer, ReplacesWhatIsOutdatedByWhatWasReadAnew) {
  const support::TemporaryFolder arrived;
  auto here = support::empty_store();
  for (const char* id : {"mended", "still", "good"}) store(here, id, 10.0);
  sql::execute(here, "UPDATE dataset SET outdated = 1 WHERE id <> 'good'");
  {
    auto there = open_scratch_store(arrived.path());
    for (const char* id : {"mended", "still", "good"}) store(there, id, 20.0);
    sql::execute(there, "UPDATE dataset SET outdated = 1 WHERE id = 'still'");
  }

  EXPECT_EQ(take_over_datasets(here, arrived.path()), std::vector{DatasetId{"mended"}});

  const auto lon_deg_of = [&](const char* id) {
    sql::Statement query{
        here, "SELECT lon_deg FROM sighting WHERE dataset_row = (SELECT row FROM dataset WHERE id = ?1)"};
    query.bind(1, std::string{id});
    return query.step() ? query.real(0) : 0.0;
  };
  EXPECT_EQ(lon_deg_of("mended"), 20.0);
  EXPECT_EQ(lon_deg_of("still"), 10.0);
  EXPECT_EQ(lon_deg_of("good"), 10.0);
  EXPECT_FALSE(DatasetRepository{here}.find({"mended"})->outdated);
  EXPECT_TRUE(DatasetRepository{here}.find({"still"})->outdated);
  EXPECT_EQ(DatasetRepository{here}.list().size(), 3U);
}

TEST(DatasetTransfer, TakesOverNothingTwice) {
  const support::TemporaryFolder arrived;
  auto db = support::empty_store();
  {
    auto scratch = open_scratch_store(arrived.path());
    store(scratch, "icebergs-new", -55.0);
  }
  EXPECT_EQ(take_over_datasets(db, arrived.path()).size(), 1U);
  EXPECT_EQ(take_over_datasets(db, arrived.path()).size(), 0U);
  EXPECT_EQ(count(db, "sighting"), 1);
}

/// A grid of 2 x 2 nodes with enough steps that their samples are copied in several transactions.
TEST(DatasetTransfer, TakesOverEverySampleOfALargeDataset) {
  constexpr std::size_t steps = 2500;
  const support::TemporaryFolder arrived;
  auto db = support::empty_store();
  store(db, "icebergs-here", -50.0);
  {
    auto scratch = open_scratch_store(arrived.path());
    std::vector<double> times;
    for (std::size_t step = 0; step < steps; ++step) times.push_back(3600.0 * static_cast<double>(step));
    sql::Transaction one_commit{scratch};
    for (const char* id : {"currents-a", "currents-b"}) {
      Dataset dataset = named(id);
      dataset.kind = DatasetKind::currents;
      DatasetRepository{scratch}.insert(dataset);
      FieldRepository fields{scratch};
      fields.create({id}, {{geo::GeographicFrame{}, ocean::Axis{{-55.0, -54.0}}, ocean::Axis{{65.0, 66.0}}},
                           std::nullopt,
                           ocean::Axis{times}});
      for (std::size_t step = 0; step < steps; ++step)
        for (const char* variable : {"u_m_s", "v_m_s"})
          fields.write_slice({id}, variable, step, 0, std::vector(4, static_cast<float>(step)));
    }
    one_commit.commit();
  }

  EXPECT_EQ(take_over_datasets(db, arrived.path()).size(), 2U);

  for (const char* id : {"currents-a", "currents-b"}) {
    const auto currents = FieldRepository{db}.load_currents({id}, {-55.0, 65.0, -54.0, 66.0}, {}, {});
    ASSERT_TRUE(currents) << id;
    for (std::size_t step = 0; step < steps; ++step) {
      ASSERT_EQ(currents->samples().u[4 * step], static_cast<float>(step));
      ASSERT_EQ(currents->samples().v[4 * step + 3], static_cast<float>(step));
    }
  }
}

TEST(DatasetTransfer, ShowsNothingOfWhatIsStillArrivingAndRemovesWhatNobodyCopiesAnyMore) {
  const support::TemporaryFolder arrived;
  auto db = support::empty_store();
  if (db.engine() == sql::Engine::server)
    GTEST_SKIP() << "at a server nobody sees what arrives before it is whole, and nothing of the dead stays";
  for (const char* id : {"currents-now~7", "currents-left~8"}) DatasetRepository{db}.insert(named(id));
  sql::execute(db,
               "UPDATE dataset SET arriving_s = unixepoch();"
               "UPDATE dataset SET arriving_s = arriving_s - 7200 WHERE id = 'currents-left~8'");
  {
    const auto scratch = open_scratch_store(arrived.path());
  }

  EXPECT_TRUE(DatasetRepository{db}.list().empty());
  EXPECT_FALSE(DatasetRepository{db}.find({"currents-now~7"}));
  EXPECT_TRUE(take_over_datasets(db, arrived.path()).empty());

  EXPECT_EQ(count(db, "dataset"), 1);
}

TEST(DatasetTransfer, RefusesAStoreThatHoldsAViewOrATriggerOfItsOwn) {
  for (const char* foreign : {"CREATE VIEW extra AS SELECT 1 AS row",
                              "CREATE TRIGGER extra AFTER INSERT ON dataset BEGIN SELECT 1; END",
                              "DROP TABLE zone; CREATE VIEW zone AS SELECT 1 AS row"}) {
    const support::TemporaryFolder arrived;
    auto db = support::empty_store();
    {
      auto scratch = open_scratch_store(arrived.path());
      store(scratch, "icebergs-new", -55.0);
      sql::execute(scratch, foreign);
    }
    EXPECT_THROW(take_over_datasets(db, arrived.path()), std::runtime_error) << foreign;
    EXPECT_EQ(count(db, "dataset"), 0) << foreign;
  }
}

}  // namespace
}  // namespace floeplan::repository::dataset_transfer_test
