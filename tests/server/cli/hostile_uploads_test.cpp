#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"
#include "tests/support/loopback_listener.hpp"
#include "tests/support/places.hpp"

namespace floeplan::cli::hostile_uploads_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr const char* secret_word = "xylophone";

std::string bytes_of(const fs::path& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

/// The gallery of hostile files, uploaded to a server. Some of the files try to reach its own store.
class HostileUploads : public testing::Test {
 protected:
  HostileUploads() {
    std::ofstream{secret_} << secret_word << "\n2026-11-20T06:00:00Z,60,-50," << secret_word << '\n';
  }

  [[nodiscard]] json gallery(int seed) const {
    const fs::path folder = program_.folder() / ("gallery" + std::to_string(seed));
    std::ostringstream command;
    command << support::program_folder() << "/hostile_gallery " << folder << ' ' << secret_ << ' '
            << program_.store() << ' ' << listener_.port() << ' ' << seed;
    EXPECT_EQ(std::system(command.str().c_str()), 0) << command.str();
    return json::parse(bytes_of(folder / "gallery.json"));
  }

  [[nodiscard]] std::set<std::string> files_of_store() const {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator{program_.store()}) names.insert(entry.path());
    return names;
  }

  /// Uploads one of the files and ingests it; a dataset made of it is removed again.
  void send(const support::ServedProgram& served, const json& hostile) const {
    json inputs{{"uploads", json::array()}, {"positive", "up"}};
    for (const std::string file : hostile.at("files")) {
      const auto sent = served.upload(bytes_of(file), "?name=" + fs::path{file}.filename().string());
      ASSERT_EQ(sent.status, 201) << sent.body;
      inputs["uploads"].push_back(sent.json().at("id"));
    }
    if (hostile.contains("crs")) inputs["crs"] = hostile.at("crs");
    const auto began = std::chrono::steady_clock::now();

    const auto answer = served.execute("ingest", inputs);

    EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::minutes{1});
    EXPECT_THAT(answer.status, testing::AnyOf(200, 400)) << answer.body;
    EXPECT_THAT(answer.body, Not(HasSubstr(secret_word)));
    EXPECT_THAT(answer.body, Not(HasSubstr("root:x:0:0")));
    EXPECT_FALSE(listener_.somebody_came());
    EXPECT_EQ(served.get("/readyz").status, 200);
    for (const json& upload : inputs.at("uploads"))
      EXPECT_EQ(served.remove("/uploads/" + upload.get<std::string>()).status, 204);
    for (const json& dataset : served.get("/datasets").json().at("datasets"))
      EXPECT_EQ(served.remove("/datasets/" + dataset.at("id").get<std::string>()).status, 204);
  }

  const support::Program program_;
  const fs::path secret_{program_.folder() / "secret.csv"};
  const support::LoopbackListener listener_;
};

TEST_F(HostileUploads, GetNothingOfTheServerThatReadsThem) {
  const auto planned =
      program_.run({"plan", "--json", "--from=-52.0,69.0", "--to=-52.1,69.1", "--depart",
                    "2026-11-22T06:00:00Z", "--currents", "none", "--bathymetry", "none", "--no-refine"});
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  const std::string plan = planned.json().at("plan_id");
  {
    const support::ServedProgram served{program_.store()};
    std::ofstream{program_.folder() / "letter.txt"} << "Dear pilot";
    send(served,
         {{"files", {(program_.folder() / "letter.txt").string()}}});  // makes the folders that reading needs
    const auto before = files_of_store();
    for (const json& hostile : gallery(1)) {
      const testing::ScopedTrace trace{__FILE__, __LINE__, hostile.dump()};
      send(served, hostile);
      if (testing::Test::HasFailure()) break;
    }
    EXPECT_EQ(files_of_store(), before) << "something was left or taken away";
    EXPECT_EQ(served.get("/collections/plans/items/" + plan).status, 200);
  }
  EXPECT_EQ(program_.run({"verify"}).exit_code, 0);
  EXPECT_THAT(bytes_of(secret_), HasSubstr(secret_word));
  EXPECT_FALSE(fs::exists("/tmp/floeplan-escaped.geojson"));
  for (const auto& entry : fs::directory_iterator{program_.store()})
    if (entry.is_regular_file()) {
      EXPECT_THAT(bytes_of(entry.path()), Not(HasSubstr(secret_word))) << entry.path();
      EXPECT_THAT(bytes_of(entry.path()), Not(HasSubstr("root:x:0:0"))) << entry.path();
    }
}

}  // namespace
}  // namespace floeplan::cli::hostile_uploads_test
