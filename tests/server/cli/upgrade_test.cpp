#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"
#include "tests/support/places.hpp"

namespace floeplan::cli::upgrade_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const char* const plan_of_the_store = "p36a25e5aab0e";
const char* const job_that_was_accepted = "0f66c365e8070cec1";  // how its id begins
/// The store's own administrator, made up with it.
const char* const key =
    "Authorization: Bearer "
    "floeplan_c0107d8ecd690781_56b9eac36c9e80af70d35e6ca909310b42091c24ab763d263869b38a89648f3b\r\n";

/// A store as release 0.1.0 left it.
class Upgrade : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("python3 --version > /dev/null 2>&1") != 0)
      GTEST_SKIP() << "install the package python3 to run this test";
    ASSERT_EQ(
        python("import lzma, sys; open(sys.argv[2], 'wb').write(lzma.open(sys.argv[1]).read())",
               support::source_folder() + "/tests/server/cli/stores/floeplan_0_1_0.sqlite.xz " + database()),
        0);
  }

  [[nodiscard]] std::string database() const { return (program_.store() / "floeplan.sqlite").string(); }

  /// Every plan and flight with its inputs, as the store holds them.
  [[nodiscard]] std::string documents() const {
    const std::string out = (program_.folder() / "documents").string();
    EXPECT_EQ(
        python("import sqlite3, sys; db = sqlite3.connect('file:' + sys.argv[1] + '?mode=ro', uri=True); "
               "open(sys.argv[2], 'w').write(repr("
               "db.execute('SELECT id, request_json, document_json FROM plan WHERE row <= 3 ORDER BY id')"
               ".fetchall() + db.execute('SELECT id, plan_id, request_json, document_json FROM simulation')"
               ".fetchall()))",
               database() + ' ' + out),
        0);
    std::ifstream stream{out};
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }

  static int python(const std::string& code, const std::string& words) {
    return std::system(("python3 -c \"" + code + "\" " + words).c_str());
  }

  support::Program program_;
};

TEST_F(Upgrade, KeepsEveryStoredPlanAndFlightByteForByte) {
  const std::string before = documents();
  ASSERT_THAT(before, HasSubstr(plan_of_the_store));

  const support::Outcome datasets = program_.run({"datasets", "--json"});

  EXPECT_EQ(datasets.exit_code, 0) << datasets.err;
  EXPECT_EQ(datasets.json().at("datasets").size(), 4U);
  EXPECT_EQ(documents(), before);
}

TEST_F(Upgrade, LetsAStoredPlanBeJudgedAndExported) {
  const support::Outcome checked = program_.run({"recheck", plan_of_the_store, "--json"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  const support::Outcome exported =
      program_.run({"export", plan_of_the_store, "--out", (program_.folder() / "mission").string()});
  EXPECT_EQ(exported.exit_code, 0) << exported.err;
  EXPECT_TRUE(std::filesystem::exists(program_.folder() / "mission" / "goto_l10.ma")) << exported.out;
}

TEST_F(Upgrade, KnowsItsTokensAndRunsTheJobThatWasAccepted) {
  const support::ServedProgram served{program_.store()};
  EXPECT_EQ(served.ask("GET", "/datasets", "").status, 401) << "the store has tokens";
  const auto jobs = [&] { return served.ask("GET", "/jobs", key).json().at("jobs"); };
  ASSERT_EQ(jobs().size(), 2U);

  json accepted;
  const auto last = std::chrono::steady_clock::now() + std::chrono::minutes{2};
  while (std::chrono::steady_clock::now() < last) {
    for (const json& job : jobs())
      if (job.at("jobID").get<std::string>().starts_with(job_that_was_accepted)) accepted = job;
    if (accepted.at("status") != "accepted" && accepted.at("status") != "running") break;
    std::this_thread::yield();
  }

  EXPECT_EQ(accepted.at("status"), "successful") << accepted;
}

/// Earlier versions stated this only among the warnings of the dataset.
TEST_F(Upgrade, MarksWhatAnEarlierVersionResampled) {
  repository::Dataset resampled{.id = {"bathymetry-0badcafe"}, .kind = repository::DatasetKind::bathymetry};
  resampled.provenance.sha256 = "0badcafe";
  resampled.warnings = {"the grid was resampled from \"NAD83 / Alaska Albers\" to longitude and latitude"};
  const auto insert = [&](const repository::Dataset& dataset) {
    sql::Connection store = repository::open_store(program_.store());
    repository::DatasetRepository{store}.insert(dataset);
  };

  insert(resampled);
  EXPECT_THAT(
      program_.run({"datasets"}).out,
      HasSubstr("resampled by an earlier version: ingest the file again for the values at its own points"));

  const auto listed = [&] { return json::parse(program_.run({"datasets", "--json"}).out).at("datasets"); };
  for (const json& dataset : listed())
    EXPECT_EQ(dataset.value("stale", ""),
              dataset.at("id") == "bathymetry-0badcafe"
                  ? "resampled by an earlier version: ingest the file again for the values at its own points"
                  : "");

  repository::Dataset native = resampled;
  native.id = {"bathymetry-0badcaff"};
  native.warnings = {};
  insert(native);
  EXPECT_THAT(
      program_.run({"datasets"}).out,
      HasSubstr(
          "resampled by an earlier version: bathymetry-0badcaff has the values at the file's own points"));
  for (const json& dataset : listed()) {
    const bool is_stale = dataset.at("id") == "bathymetry-0badcafe";
    EXPECT_EQ(dataset.contains("stale"), is_stale);
    EXPECT_EQ(dataset.value("better_id", ""), is_stale ? "bathymetry-0badcaff" : "");
  }
}

}  // namespace
}  // namespace floeplan::cli::upgrade_test
