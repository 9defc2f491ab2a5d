#include <gmock/gmock.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "storage/sql/driver/failure.hpp"
#include "storage/sql/statement.hpp"
#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"
#include "tests/server/jobs/wait_until.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::cli::nodes_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const char* const bed =
    "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 50\ncellsize 0.5\n-900 -800 70\n-600 -5 4\n";

/// Two servers that run no jobs themselves, at one store. Each test starts its workers.
class Nodes : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("FLOEPLAN_TEST_SERVER") == nullptr)
      GTEST_SKIP() << "nodes share a store only at a database server (at_database_server)";
  }

  [[nodiscard]] support::Node node(const std::string& name, const std::string& command = "serve") const {
    return {.store = program_.store(), .folder = program_.folder() / name, .command = command};
  }
  [[nodiscard]] support::Node worker(const std::string& name) const { return node(name, "worker"); }

  static json job_at(const support::ServedProgram& server, const std::string& id) {
    return server.get("/jobs/" + id).json();
  }
  static bool reaches(const support::ServedProgram& server, const std::string& id,
                      const std::string& status) {
    return support::wait_until([&] { return job_at(server, id).value("status", "") == status; });
  }
  /// Whether a node writes this into its log.
  static bool says(const std::filesystem::path& log, const std::string& words) {
    return support::wait_until([&] { return says_now(log, words); });
  }
  static bool says_now(const std::filesystem::path& log, const std::string& words) {
    std::ifstream in{log};
    const std::string lines{std::istreambuf_iterator<char>{in}, {}};
    return lines.find(words) != std::string::npos;
  }
  /// Queues a job that takes this number of seconds.
  static std::string submit_echo(const support::ServedProgram& server, int seconds) {
    const auto answer = server.submit("echo", {{"text", "ice"}, {"pause", seconds}});
    EXPECT_EQ(answer.status, 201) << answer.body;
    return answer.json().value("jobID", "");
  }

  support::Program program_;
};

TEST_F(Nodes, ShareTheirJobsAndEachSeesThemEnd) {
  const support::ServedProgram first{node("first"), {"--workers", "0"}};
  const support::ServedProgram second{node("second"), {"--workers", "0"}};
  const std::string id = submit_echo(first, 0);
  EXPECT_EQ(job_at(second, id).value("status", ""), "accepted") << "nobody works yet";

  const support::ServedProgram working{worker("working")};

  EXPECT_TRUE(reaches(second, id, "successful"));
  EXPECT_EQ(first.get("/jobs/" + id + "/results").body, second.get("/jobs/" + id + "/results").body);
}

/// A client waits at one node for a job of another node, and gets the answer as soon as the job ends.
TEST_F(Nodes, AnswerAWaitingClientWhenAnotherNodeHasDoneItsJob) {
  const support::ServedProgram server{node("server"), {"--workers", "0"}};
  const support::ServedProgram working{worker("working")};

  const auto answer = server.execute("echo", {{"text", "ice"}, {"pause", 1}});

  EXPECT_EQ(answer.status, 200) << answer.body;
  EXPECT_THAT(answer.body, HasSubstr("ice"));
}

TEST_F(Nodes, IngestAtOneWhatWasSentToAnother) {
  const support::ServedProgram server{node("server"), {"--workers", "0"}};
  const support::ServedProgram working{worker("working"), {"--lanes", "ingest"}};
  const auto sent = server.upload(bed, "?name=bed.asc");
  ASSERT_EQ(sent.status, 201) << sent.body;

  const auto answer = server.execute("ingest", {{"uploads", {sent.json().at("id")}}, {"positive", "up"}});

  EXPECT_EQ(answer.json().at("report").at("datasets").at(0).at("status"), "stored") << answer.body;
  EXPECT_EQ(server.get("/datasets").json().at("datasets").size(), 1U);
}

TEST_F(Nodes, StopAJobThatWasDismissedAtAnother) {
  const support::ServedProgram server{node("server"), {"--workers", "0"}};
  const auto log = program_.folder() / "log";
  const support::ServedProgram working{worker("working"), {}, log};
  const std::string id = submit_echo(server, 10);
  ASSERT_TRUE(reaches(server, id, "running"));

  EXPECT_EQ(server.remove("/jobs/" + id).status, 200);

  EXPECT_TRUE(says(log, "job=" + id + " outcome=stopped"));
  EXPECT_EQ(job_at(server, id).value("status", ""), "dismissed");
}

/// Lanes decide which jobs a worker takes.
TEST_F(Nodes, TakeOnlyJobsOfTheirLanes) {
  const support::ServedProgram server{node("server"), {"--workers", "0"}};
  const support::ServedProgram ingesting{worker("ingesting"), {"--lanes", "ingest,batch"}};
  const std::string id = submit_echo(server, 0);
  const auto sent = server.upload(bed, "?name=bed.asc");
  const auto ingested = server.execute("ingest", {{"uploads", {sent.json().at("id")}}, {"positive", "up"}});
  EXPECT_EQ(ingested.status, 200) << ingested.body;

  EXPECT_EQ(job_at(server, id).value("status", ""), "accepted");
}

/// The jobs of a node that was killed go on at another one when their leases have expired.
TEST_F(Nodes, DoTheJobsOfAKilledOne) {
  const support::ServedProgram server{node("server"), {"--workers", "0"}};
  support::ServedProgram killed{worker("killed")};
  const std::string id = submit_echo(server, 3);
  ASSERT_TRUE(reaches(server, id, "running"));
  killed.end(SIGKILL);
  EXPECT_EQ(job_at(server, id).value("status", ""), "running");

  const support::ServedProgram working{worker("working")};

  EXPECT_TRUE(reaches(server, id, "successful"));
}

/// A window of departures in still water, of some seconds of work.
json window() {
  return {{"from", {-53, 69}},
          {"to", {-50, 67}},
          {"depart", "2026-11-20T06:00:00Z"},
          {"depart_until", "2026-11-24T06:00:00Z"},
          {"depart_step", "PT1H"},
          {"spacing_m", 1200},
          {"refine", false}};
}

/// What a plan says of its route and its departures.
json route_and_departures(const json& plan) {
  return {plan.at("waypoints"), plan.at("departures"), plan.at("plan_id")};
}

TEST_F(Nodes, DoTheDeparturesOfOneWindowTogetherAsOneAlone) {
  const support::ServedProgram server{node("server"), {"--workers", "0"}};
  const auto logs = std::array{program_.folder() / "log 0", program_.folder() / "log 1"};
  const support::ServedProgram first{worker("first"), {"--workers", "1"}, logs[0]};
  const support::ServedProgram second{worker("second"), {"--workers", "1"}, logs[1]};
  const std::string id = server.submit("plan-route", window()).json().value("jobID", "");
  ASSERT_TRUE(reaches(server, id, "running"));
  const bool first_leads = says_now(logs[0], "job=" + id + " process=plan-route attempt=1 begins");

  EXPECT_TRUE(says(logs[first_leads ? 1 : 0], "job=" + id + " process=plan-route is helped"));
  EXPECT_TRUE(says(logs[first_leads ? 1 : 0], "job=" + id + " parts="));
  ASSERT_TRUE(reaches(server, id, "successful")) << job_at(server, id);

  const support::Program alone;
  const support::ServedProgram by_itself{alone.store()};
  const json plan = server.get("/jobs/" + id + "/results").json().at("plan");
  const json same = by_itself.execute("plan-route", window()).json().at("plan");
  EXPECT_EQ(route_and_departures(plan), route_and_departures(same));
  EXPECT_EQ(plan.at("departures").size(), 97U);
}

/// A helper that is killed costs its part, and no more.
TEST_F(Nodes, EndAWindowWhoseHelperWasKilled) {
  const support::ServedProgram server{node("server"), {"--workers", "0"}};
  const auto logs = std::array{program_.folder() / "log 0", program_.folder() / "log 1"};
  support::ServedProgram first{worker("first"), {"--workers", "1"}, logs[0]};
  support::ServedProgram second{worker("second"), {"--workers", "1"}, logs[1]};
  const std::string id = server.submit("plan-route", window()).json().value("jobID", "");
  const std::string helped = "job=" + id + " process=plan-route is helped";
  ASSERT_TRUE(support::wait_until([&] { return says_now(logs[0], helped) || says_now(logs[1], helped); }));

  (says_now(logs[0], helped) ? first : second).end(SIGKILL);

  EXPECT_TRUE(reaches(server, id, "successful")) << job_at(server, id);
  EXPECT_EQ(server.get("/jobs/" + id + "/results").json().at("plan").at("departures").size(), 97U);
}

TEST_F(Nodes, AnswerHealthReadinessAndMetricsAloneAsWorkers) {
  const support::ServedProgram working{worker("working")};
  EXPECT_EQ(working.get("/healthz").status, 200);
  EXPECT_EQ(working.get("/readyz").status, 200);
  EXPECT_THAT(working.get("/metrics").body, HasSubstr("floeplan_jobs{state=\"accepted\"} 0"));
  EXPECT_EQ(working.get("/datasets").status, 404);
  EXPECT_EQ(working.submit("echo", {{"text", "ice"}}).status, 404);
}

/// A whole store goes to the server and back, while nobody uses it.
TEST_F(Nodes, HaveTheWholeStoreThatIsCopiedFromAFolder) {
  const support::Program elsewhere;
  std::ofstream{elsewhere.folder() / "bed.asc"} << bed;
  const std::string folder = (elsewhere.folder() / "before").string();
  const std::string back = (elsewhere.folder() / "back").string();
  const std::string there = support::store_words(program_.store()).at(3);
  ASSERT_EQ(elsewhere
                .run_alone({"--store", "sqlite:" + folder, "ingest", "--positive", "up",
                            (elsewhere.folder() / "bed.asc").string()})
                .exit_code,
            0);

  const auto copied = elsewhere.run_alone({"store", "copy", "sqlite:" + folder, there});

  EXPECT_EQ(copied.exit_code, 0) << copied.err;
  EXPECT_THAT(copied.out, HasSubstr("copied 1 datasets"));
  {
    const support::ServedProgram server{node("server")};
    EXPECT_EQ(server.get("/datasets").json().at("datasets").size(), 1U);
    const auto used = elsewhere.run_alone({"store", "copy", there, "sqlite:" + back});
    EXPECT_EQ(used.exit_code, 1);
    EXPECT_THAT(used.err, HasSubstr("servers or workers use the store"));
  }
  EXPECT_EQ(elsewhere.run_alone({"store", "copy", there, "sqlite:" + back}).exit_code, 0);
  const auto again = elsewhere.run_alone({"store", "copy", there, "sqlite:" + back});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_THAT(again.err, HasSubstr("the store to copy into is not empty"));
  const auto list = [&](const std::string& store) {
    return elsewhere.run_alone({"--store", "sqlite:" + store, "datasets", "--json"}).out;
  };
  EXPECT_EQ(list(folder), list(back));
}

/// A role that may not change tables can use a store that its owner has prepared.
TEST_F(Nodes, WorkByARoleThatChangesNoTable) {
  const std::string role = "node_" + std::to_string(getpid());
  auto owner = sql::Connection::open_at_server(std::getenv("FLOEPLAN_TEST_SERVER"));
  sql::execute(owner, "CREATE ROLE " + role + " LOGIN");
  std::string address = support::store_words(program_.store()).at(3);
  const std::string of_owner = address;
  address.replace(address.find("//floeplan@"), 11, "//" + role + "@");

  const auto unprepared = program_.run_alone({"--store", address, "datasets"});
  EXPECT_EQ(unprepared.exit_code, 1);
  EXPECT_THAT(unprepared.err, HasSubstr("store prepare"));
  ASSERT_EQ(program_.run_alone({"--store", of_owner, "store", "prepare", "--for", role}).exit_code, 0);

  std::ofstream{program_.folder() / "bed.asc"} << bed;
  const auto ingested = program_.run_alone(
      {"--store", address, "ingest", "--positive", "up", (program_.folder() / "bed.asc").string()});
  EXPECT_EQ(ingested.exit_code, 0) << ingested.err;
  auto db = sql::Connection::open_at_server(address);
  EXPECT_THROW(sql::execute(db, "CREATE TABLE another (row bigint)"), sql::Failure);
  EXPECT_THROW(sql::execute(db, "ALTER TABLE job ADD another bigint"), sql::Failure);
}

TEST(NodesOfAFolder, AreNone) {
  if (std::getenv("FLOEPLAN_TEST_SERVER") != nullptr) GTEST_SKIP() << "the stores of this run are shared";
  const support::Program program;
  const auto worker = program.run({"worker"});
  EXPECT_EQ(worker.exit_code, 2);
  EXPECT_THAT(worker.err, HasSubstr("a worker needs a store that several machines share"));
  const auto idle = program.run({"serve", "--workers", "0"});
  EXPECT_EQ(idle.exit_code, 2);
  EXPECT_THAT(idle.err, HasSubstr("0 workers are not possible"));
}

}  // namespace
}  // namespace floeplan::cli::nodes_test
