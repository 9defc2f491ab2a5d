#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"

namespace floeplan::cli::uploads_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const char* const bed =
    "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 50\ncellsize 0.5\n-900 -800 70\n-600 -5 4\n";
const char* const cut_bed = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 50\ncellsize 0.5\n-900 -800 70\n-6\n";
const char* const unsigned_bed = "0 50 10\n0.5 50 11\n0 50.5 12\n0.5 50.5 13\n";
const char* const zone = R"({"type": "FeatureCollection", "features": [{"type": "Feature",
  "properties": {"name": "Range"}, "geometry": {"type": "Polygon",
  "coordinates": [[[-53.1, 68.9], [-52.8, 68.9], [-52.8, 69.1], [-53.1, 68.9]]]}}]})";

/// The report on the data, without the time of storing.
json without_moment(json report) {
  for (json& file : report.at("datasets")) file.erase("ingested");
  return report;
}

/// The same files, ingested over HTTP and from the command line into stores of their own.
class Uploads : public testing::Test {
 protected:
  std::string send(const std::string& content, const std::string& name) {
    const auto answer = served_.upload(content, "?name=" + name);
    EXPECT_EQ(answer.status, 201) << answer.body;
    return answer.json().at("id");
  }

  support::Program over_http_;
  support::Program from_command_line_;
  support::ServedProgram served_{over_http_.folder() / "store"};
};

TEST_F(Uploads, AreReportedAsTheCommandLineReportsTheSameFiles) {
  const std::map<std::string, std::string> files{{"bed.asc", bed},
                                                 {"cut.asc", cut_bed},
                                                 {"letter.txt", "Dear pilot"},
                                                 {"points.xyz", unsigned_bed},
                                                 {"zone.geojson", zone}};
  std::vector<std::string> words{"ingest", "--json", "--positive", "down", "--zone-kind", "stay_in"};
  json ids = json::array();
  for (const auto& [name, content] : files) {
    std::ofstream{from_command_line_.folder() / name} << content;
    words.push_back((from_command_line_.folder() / name).string());
    ids.push_back(send(content, name));
  }

  const json printed = from_command_line_.run(words).json();
  const auto answered =
      served_.execute("ingest", {{"uploads", ids}, {"positive", "down"}, {"zone_kind", "stay_in"}});

  ASSERT_EQ(answered.status, 200) << answered.body;
  EXPECT_EQ(without_moment(answered.json().at("report")), without_moment(printed));
  EXPECT_EQ(served_.get("/datasets").json().at("datasets").size(), 3U);
}

TEST_F(Uploads, KeepTheirBytesUntilTheyAreRemoved) {
  const std::string id = send(bed, "..%2F..%2Fbed.asc");
  const json upload = served_.get("/uploads/" + id).json();
  EXPECT_EQ(upload.at("name"), "bed.asc");
  EXPECT_EQ(upload.at("bytes"), std::string{bed}.size());

  EXPECT_EQ(served_.remove("/uploads/" + id).status, 204);
  EXPECT_EQ(served_.get("/uploads/" + id).status, 404);
  EXPECT_EQ(served_.remove("/uploads/" + id).status, 404);
  const auto refused = served_.execute("ingest", {{"uploads", {id}}});
  EXPECT_EQ(refused.status, 400);
  EXPECT_THAT(refused.body, HasSubstr("/inputs/uploads/0"));
}

TEST_F(Uploads, ThatTheDiskHasChangedAreNotIngested) {
  if (std::getenv("FLOEPLAN_TEST_SERVER") != nullptr) GTEST_SKIP() << "uploads are files only in a folder";
  const std::string id = send(bed, "bed.asc");
  std::ofstream{over_http_.folder() / "store" / "uploads" / id / "data", std::ios::in | std::ios::out}
      << "NCOLS 9";

  const auto refused = served_.execute("ingest", {{"uploads", {id}}, {"positive", "up"}});

  EXPECT_THAT(refused.body, HasSubstr("no longer as it arrived"));
  EXPECT_TRUE(served_.get("/datasets").json().at("datasets").empty());
}

TEST_F(Uploads, ThatArriveWithAnotherDigestAreRefusedAndLeaveNothing) {
  const auto refused = served_.upload(bed, "?name=bed.asc&sha256=" + std::string(64, '0'));
  EXPECT_EQ(refused.status, 400);
  EXPECT_THAT(refused.body, HasSubstr("another digest"));
  EXPECT_EQ(served_.upload(bed, "?sha256=abc").status, 400);
  EXPECT_TRUE(std::filesystem::is_empty(over_http_.folder() / "store" / "uploads"));
}

TEST_F(Uploads, NeedNotFitIntoTheLimitOfOtherBodies) {
  std::string points;
  for (int i = 0; i < 500'000; ++i) points += "# nothing\n";
  EXPECT_EQ(served_.upload(points, "").status, 201);
  EXPECT_EQ(served_.execute("ingest", {{"uploads", json::array()}, {"name", points}}).status, 413);
}

TEST_F(Uploads, OfTheSameNameAreNotIngestedTogether) {
  const auto refused = served_.execute("ingest", {{"uploads", {send(bed, "a.asc"), send(cut_bed, "a.asc")}}});
  EXPECT_EQ(refused.status, 400);
  EXPECT_THAT(refused.body, HasSubstr("one after the other"));
}

TEST(UploadLimit, IsWhatTheServerWasTold) {
  const support::Program program;
  const support::ServedProgram served{program.folder() / "store", {"--max-upload-mb", "2"}};
  EXPECT_EQ(served.upload(std::string(1'900'000, ' '), "").status, 201);
  EXPECT_EQ(served.upload(std::string(2'100'000, ' '), "").status, 413);
}

TEST_F(Uploads, CountInTheQuotaOfStoredBytesAsTheirDatasetsDo) {
  const std::string id = send(bed, "bed.asc");
  ASSERT_EQ(served_.execute("ingest", {{"uploads", {id}}, {"positive", "up"}}).status, 200);
  const auto used = [&] { return served_.get("/uploads").json().at("quotas").at("stored_bytes").at("used"); };

  EXPECT_EQ(used(), 2 * std::string{bed}.size());
  EXPECT_EQ(served_.remove("/uploads/" + id).status, 204);
  EXPECT_EQ(used(), std::string{bed}.size());
  const std::string dataset = served_.get("/datasets").json().at("datasets").at(0).at("id");
  EXPECT_EQ(served_.remove("/datasets/" + dataset).status, 204);
  EXPECT_EQ(used(), 0);
}

TEST(LargeUploads, AreRefusedBeforeTheirBodyIsThereWhereTheQuotaLeavesNoRoom) {
  const support::Program program;
  const support::ServedProgram served{program.folder() / "store",
                                      {"--max-stored-mb", "2", "--max-uploads", "2"}};

  EXPECT_EQ(served.upload(std::string(1'500'000, ' '), "").status, 201);
  const auto too_large = served.upload(std::string(600'000, ' '), "");
  EXPECT_EQ(too_large.status, 403);
  EXPECT_EQ(too_large.json().at("type"), "/problems/quota-stored-bytes");
  EXPECT_EQ(served.upload(std::string(400'000, ' '), "").status, 201);
  EXPECT_EQ(served.upload("", "").json().at("type"), "/problems/quota-uploads");
}

}  // namespace
}  // namespace floeplan::cli::uploads_test
