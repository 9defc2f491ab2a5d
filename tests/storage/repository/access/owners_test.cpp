#include "storage/repository/access/owners.hpp"

#include <gtest/gtest.h>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/repository/work/simulation_repository.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::repository::owners_test {
namespace {

class OwnersTest : public testing::Test {
 protected:
  void note(const DatasetId& id, const std::string& owner) { owners_.note_dataset(id.value, owner); }

  DatasetId add(const std::string& id, std::int64_t bytes) {
    Dataset dataset;
    dataset.id = {id};
    dataset.kind = DatasetKind::bathymetry;
    dataset.provenance.file_size_bytes = bytes;
    datasets_.insert(dataset);
    return dataset.id;
  }

  sql::Connection db_ = support::empty_store();
  DatasetRepository datasets_{db_};
  Owners owners_{db_};
};

TEST_F(OwnersTest, AddUpTheBytesOfEachAlone) {
  note(add("a", 10), "ann");
  note(add("b", 200), "ann");
  note(add("c", 3000), "");
  add("d", 40'000);  // of the operator

  EXPECT_EQ(owners_.bytes_of("ann"), 210U);
  EXPECT_EQ(owners_.bytes_of(""), 3000U);
  EXPECT_EQ(owners_.bytes_of("bob"), 0U);
}

TEST_F(OwnersTest, StayWhoTheyAre) {
  const DatasetId id = add("a", 10);
  note(id, "ann");

  note(id, "bob");

  EXPECT_EQ(owners_.bytes_of("ann"), 10U);
  EXPECT_EQ(owners_.bytes_of("bob"), 0U);
}

TEST_F(OwnersTest, FreeTheirBytesWithTheDataset) {
  const DatasetId id = add("a", 10);
  note(id, "ann");

  ASSERT_TRUE(datasets_.remove(id));

  EXPECT_EQ(owners_.bytes_of("ann"), 0U);
}

/// Plans and simulations count with all that is kept of them, from the moment that they are somebody's.
TEST_F(OwnersTest, HavePlansAndSimulationsBesideTheirDatasets) {
  PlanRepository plans{db_};
  SimulationRepository simulations{db_};
  note(add("a", 10), "ann");
  const core::UtcTime made = core::from_unix_seconds(1.8e9);
  PlanRecord plan;
  plan.id = {"p"};
  plan.created = made;
  plan.request_json = "{}";
  plan.document_json = std::string(500, ' ');
  plans.insert(plan);
  SimulationRecord simulation;
  simulation.id = {"s"};
  simulation.created = made;
  simulation.request_json = "[]";
  simulation.document_json = std::string(6000, ' ');
  simulations.insert(simulation, {{.run = 0, .document_json = std::string(70'000, ' ')}});
  EXPECT_EQ(owners_.bytes_of("ann"), 10U);

  owners_.note_made(plan_table, "p", made + core::Seconds{1.0}, "ann");
  EXPECT_EQ(owners_.bytes_of("ann"), 10U) << "a plan that was stored earlier does not become hers";
  owners_.note_made(plan_table, "p", made, "ann");
  owners_.note_made(plan_table, "p", made, "bob");
  owners_.note_made(simulation_table, "s", made, "ann");
  EXPECT_EQ(owners_.bytes_of("ann"), 10U + 502U + 76'002U);
  EXPECT_EQ(owners_.bytes_of("bob"), 0U);

  ASSERT_TRUE(simulations.remove({"s"}));
  EXPECT_EQ(owners_.bytes_of("ann"), 10U + 502U);
  ASSERT_TRUE(plans.remove({"p"}));
  EXPECT_EQ(owners_.bytes_of("ann"), 10U);
}

}  // namespace
}  // namespace floeplan::repository::owners_test
