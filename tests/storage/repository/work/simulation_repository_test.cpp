#include "storage/repository/work/simulation_repository.hpp"

#include <gmock/gmock.h>

#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::repository::simulation_repository_test {
namespace {

using testing::SizeIs;

SimulationRecord simulation(const std::string& id, const std::string& plan_id = "p1") {
  return {.row = 0,
          .id = {id},
          .plan_id = plan_id,
          .name = "runs of " + plan_id,
          .created = sample_time,
          .request_json = R"({"seed":"1"})",
          .document_json = R"({"status":"ok"})"};
}

class SimulationRepositoryTest : public testing::Test {
 protected:
  sql::Connection db_ = support::empty_store();
  SimulationRepository simulations_{db_};
};

TEST_F(SimulationRepositoryTest, GivesBackWhatWasInserted) {
  const auto row = simulations_.insert(simulation("a"), {{0, R"({"run":0})"}, {4, R"({"run":4})"}});

  const auto found = simulations_.find({"a"});

  ASSERT_TRUE(found);
  EXPECT_EQ(found->row, row);
  EXPECT_EQ(found->plan_id, "p1");
  EXPECT_EQ(found->created, sample_time);
  EXPECT_EQ(found->document_json, R"({"status":"ok"})");
  EXPECT_EQ(simulations_.find_flight({"a"}, 4)->document_json, R"({"run":4})");
  EXPECT_FALSE(simulations_.find_flight({"a"}, 1));
  EXPECT_THAT(simulations_.flights({"a"}), SizeIs(2));
}

TEST_F(SimulationRepositoryTest, LeavesAStoredSimulationAsItIs) {
  const auto row = simulations_.insert(simulation("a"), {{0, "first"}});
  SimulationRecord other = simulation("a");
  other.document_json = "other";

  EXPECT_EQ(simulations_.insert(other, {{0, "second"}, {1, "more"}}), row);

  EXPECT_EQ(simulations_.find({"a"})->document_json, R"({"status":"ok"})");
  EXPECT_EQ(simulations_.find_flight({"a"}, 0)->document_json, "first");
  EXPECT_THAT(simulations_.flights({"a"}), SizeIs(1));
}

TEST_F(SimulationRepositoryTest, ListsThoseOfAPlanPageByPage) {
  for (const char* id : {"a", "b", "c"}) simulations_.insert(simulation(id), {});
  simulations_.insert(simulation("d", "p2"), {});

  const auto first = simulations_.list("p1", 0, 2);
  const auto second = simulations_.list("p1", first.back().row, 2);

  EXPECT_THAT(first, SizeIs(2));
  ASSERT_THAT(second, SizeIs(1));
  EXPECT_EQ(second[0].id.value, "c");
  EXPECT_EQ(simulations_.count("p1"), 3);
  EXPECT_EQ(simulations_.count({}), 4);
  EXPECT_THAT(simulations_.list({}, 0, 100), SizeIs(4));
}

TEST_F(SimulationRepositoryTest, TakesTheFlightsAwayWithTheirSimulation) {
  simulations_.insert(simulation("a"), {{0, "flight"}});

  EXPECT_TRUE(simulations_.remove({"a"}));

  EXPECT_FALSE(simulations_.find({"a"}));
  EXPECT_TRUE(simulations_.flights({"a"}).empty());
  EXPECT_FALSE(simulations_.remove({"a"}));
}

}  // namespace
}  // namespace floeplan::repository::simulation_repository_test
