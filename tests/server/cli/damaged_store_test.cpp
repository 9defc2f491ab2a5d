#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"

namespace floeplan::cli::damaged_store_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

const char* const zones = R"({"type": "FeatureCollection", "features": [{"type": "Feature",
  "properties": {"name": "Range", "kind": "no_go"}, "geometry": {"type": "Polygon",
  "coordinates": [[[-53.1, 68.9], [-52.8, 68.9], [-52.8, 69.1], [-53.1, 68.9]]]}}]})";

class DamagedStore : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream{program_.folder() / "zones.geojson"} << zones;
    const auto stored = program_.run({"ingest", "--json", (program_.folder() / "zones.geojson").string()});
    ASSERT_EQ(stored.exit_code, 0) << stored.err;
    for (const char* const goal : {"-52.10,69.10", "-52.20,69.20", "-52.30,69.30"}) {
      const auto planned =
          program_.run({"plan", "--json", "--from=-52.0,69.0", std::string{"--to="} + goal, "--depart",
                        "2026-11-22T06:00:00Z", "--currents", "none", "--bathymetry", "none", "--no-refine"});
      ASSERT_EQ(planned.exit_code, 0) << planned.err;
      plans_.push_back(planned.json().at("plan_id"));
    }
  }

  [[nodiscard]] fs::path database() const { return program_.store() / "floeplan.sqlite"; }

  /// Changes one bit of the text of a plan where it is stored.
  void damage(const std::string& plan) const {
    std::ifstream in{database(), std::ios::binary};
    std::ostringstream text;
    text << in.rdbuf();
    std::string bytes = text.str();
    const std::size_t at = bytes.rfind("\"plan_id\":\"" + plan);
    ASSERT_NE(at, std::string::npos);
    bytes[at + 3] = static_cast<char>(bytes[at + 3] ^ 1);
    std::ofstream{database(), std::ios::binary} << bytes;
  }

  static std::vector<std::string> ids_of(const json& things) {
    std::vector<std::string> ids;
    for (const json& thing : things) ids.push_back(thing.at("id"));
    return ids;
  }

  support::Program program_;
  std::vector<std::string> plans_;
};

TEST_F(DamagedStore, IsNamedServedAroundAndRepaired) {
  EXPECT_EQ(program_.run({"verify"}).exit_code, 0);
  damage(plans_[1]);

  const auto verified = program_.run({"verify", "--json"});
  EXPECT_EQ(verified.exit_code, 3);
  EXPECT_THAT(verified.out, HasSubstr(plans_[1]));
  {
    const support::ServedProgram served{program_.store()};
    const auto damaged = served.get("/collections/plans/items/" + plans_[1]);
    EXPECT_EQ(damaged.status, 503) << damaged.body;
    EXPECT_THAT(damaged.body, HasSubstr("store-damaged"));
    EXPECT_EQ(served.get("/readyz").json().at("damaged_pages"), 1);
    const json listed = served.get("/collections/plans/items").json();
    EXPECT_EQ(ids_of(listed.at("features")), (std::vector{plans_[0], plans_[2]}));
    EXPECT_EQ(ids_of(listed.at("damaged")), std::vector{plans_[1]});
    EXPECT_EQ(listed.at("damaged").at(0).at("type"), "/problems/store-damaged");
    const json legs = served.get("/collections/plan-legs/items").json();
    EXPECT_FALSE(legs.at("features").empty());
    EXPECT_EQ(ids_of(legs.at("damaged")), std::vector{plans_[1]});
    EXPECT_EQ(served.get("/collections/plan-legs/items?plan_id=" + plans_[1]).status, 503);
    EXPECT_EQ(served.get("/datasets").json().contains("damaged"), false);
    EXPECT_EQ(served.get("/collections/nogo-zones/items").status, 200);
  }
  const auto repaired = program_.run({"repair", "--json"});
  ASSERT_EQ(repaired.exit_code, 0) << repaired.err;
  for (const json& lost : repaired.json().at("lost")) EXPECT_THAT(plans_, testing::Contains(lost.at("id")));
  EXPECT_THAT(repaired.out, HasSubstr(plans_[1]));
  EXPECT_EQ(program_.run({"verify"}).exit_code, 0);
  const support::ServedProgram served{program_.store()};
  EXPECT_EQ(served.get("/collections/plans/items/" + plans_[1]).status, 404);
  EXPECT_EQ(served.get("/collections/nogo-zones/items").status, 200);
}

/// SQLite removes the log with the last connection, and another program must not count as the last one.
TEST_F(DamagedStore, IsLeftAsItIsByProgramsThatComeAndGoBesideItsServer) {
  const support::ServedProgram served{program_.store()};
  for (const char* const command : {"datasets", "verify"}) {
    EXPECT_EQ(served.get("/readyz").status, 200);
    EXPECT_EQ(program_.run({command}).exit_code, 0);
    EXPECT_TRUE(fs::exists(database().string() + "-wal")) << command;
  }
  EXPECT_FALSE(served.ends_within(std::chrono::seconds{3})) << "it looks at its files once a second";
  EXPECT_EQ(served.get("/healthz").status, 200);
}

TEST_F(DamagedStore, WhoseFilesAreTakenAwayEndsItsServer) {
  for (const char* const ending : {"", "-wal"}) {
    const fs::path file = database().string() + ending;
    const fs::path aside = program_.folder() / "aside";
    {
      const support::ServedProgram served{program_.store()};
      ASSERT_EQ(served.get("/readyz").status, 200);
      fs::rename(file, aside);
      EXPECT_TRUE(served.ends_within(std::chrono::seconds{20})) << file;
    }
    fs::rename(aside, file);
    EXPECT_EQ(program_.run({"verify"}).exit_code, 0) << file;
  }
}

}  // namespace
}  // namespace floeplan::cli::damaged_store_test
