#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

#include "tests/api/routes/api_fixture.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::routes::resources_test {
namespace {

using support::header_of;
using support::json_of;
using ResourcesTest = support::ApiTest;

TEST_F(ResourcesTest, EveryPlainPathAnswers) {
  for (const char* path :
       {"/", "/conformance", "/api", "/collections", "/collections/icebergs", "/collections/plans",
        "/collections/icebergs/items", "/collections/plans/items", "/processes", "/processes/plan-route",
        "/processes/evaluate-route", "/processes/reach", "/jobs", "/datasets", "/vehicles", "/healthz",
        "/version", "/map/coast?bbox=-54,68,-50,70", "/probe?lon=-53&lat=69"}) {
    EXPECT_EQ(ask("GET", path).status, 200) << path;
  }
}

TEST_F(ResourcesTest, UnknownPathsIdsAndParametersAreRefused) {
  EXPECT_EQ(ask("GET", "/nope").status, 404);
  EXPECT_EQ(ask("GET", "/jobs/nope").status, 404);
  EXPECT_EQ(ask("GET", "/collections/plans/items/nope/mission.gpx").status, 404);
  EXPECT_EQ(ask("GET", "/map/bathymetry?bbox=0,0,1,1&nx=2&ny=2&dataset=nope").status, 404);
  EXPECT_EQ(ask("GET", "/collections/icebergs/items?dataset=nope").status, 404);
  EXPECT_EQ(ask("GET", "/collections/icebergs/items?unknown=1").status, 400);
}

TEST_F(ResourcesTest, OtherMethodsAreRefusedWithTheAllowedOnes) {
  const auto response = ask("PUT", "/jobs/x");
  EXPECT_EQ(response.status, 405);
  EXPECT_EQ(header_of(response, "Allow"), "OPTIONS, GET, HEAD, DELETE");
  EXPECT_EQ(ask("OPTIONS", "/jobs").status, 204);
}

TEST_F(ResourcesTest, QueryParametersAreChecked) {
  const std::string items = "/collections/icebergs/items?";
  EXPECT_EQ(ask("GET", items + "limit=unlimited").status, 400);
  EXPECT_EQ(ask("GET", items + "limit=0").status, 400);
  EXPECT_EQ(ask("GET", items + "limit=99999").status, 200) << "clamped";
  EXPECT_EQ(ask("GET", items + "bbox=1,2,3").status, 400);
  EXPECT_EQ(ask("GET", items + "bbox=nan,0,1,1").status, 400);
  EXPECT_EQ(ask("GET", items + "bbox=-.2500000,50,.5000000,53").status, 200);
  EXPECT_EQ(ask("GET", items + "bbox=177,65,-177,70").status, 200);
  EXPECT_EQ(ask("GET", items + "datetime=2026-11-20T00:00:00Z/..").status, 200);
  EXPECT_EQ(ask("GET", items + "datetime=0000-01-01T00:00:00Z%2F2026-11-20").status, 200);
  EXPECT_EQ(ask("GET", items + "datetime=yesterday").status, 400);
}

TEST_F(ResourcesTest, TheOpenApiDocumentNamesThePublicAddressAndEveryPath) {
  const auto document = json_of(ask("GET", "/api"));
  EXPECT_EQ(document.at("servers").at(0).at("url"), "http://127.0.0.1:8080");
  for (const auto& route : router_.routes()) {
    std::string pattern = route.pattern;
    if (const auto dots = pattern.find("..."); dots != std::string::npos) pattern.erase(dots, 3);
    if (pattern == "/processes/{process_id}/execution") pattern = "/processes/plan-route/execution";
    std::string method = route.method;
    std::ranges::transform(method, method.begin(), [](unsigned char c) { return std::tolower(c); });
    EXPECT_TRUE(document.at("paths").contains(pattern) && document.at("paths").at(pattern).contains(method))
        << route.method << " " << pattern;
  }
}

TEST_F(ResourcesTest, ProblemsComeAsPlainJsonToWhoeverTakesNothingElse) {
  EXPECT_EQ(ask("GET", "/nope").content_type, "application/problem+json");
  EXPECT_EQ(ask("GET", "/nope", "", {{"accept", "application/json"}}).content_type, "application/json");
}

TEST_F(ResourcesTest, AssetNamesCannotLeaveTheirFolder) {
  service_.web = support::source_folder() + "/api/routes/request";
  EXPECT_EQ(ask("GET", "/app/router.cpp").status, 200);
  EXPECT_EQ(ask("GET", "/app/../all_routes.cpp").status, 404);
  EXPECT_EQ(ask("GET", "/app/%2e%2e/all_routes.cpp").status, 404);
}

class GuideTest : public ResourcesTest {
 protected:
  void SetUp() override {
    ResourcesTest::SetUp();
    std::filesystem::create_directories(folder_.path() / "guide/pictures");
    for (const char* name : {"index.html", "guide/index.html", "guide/data.html", "guide/pictures/jet.svg"})
      std::ofstream{folder_.path() / name} << name;
    service_.web = folder_.path();
  }

 private:
  support::TemporaryFolder folder_;
};

TEST_F(GuideTest, IsServedByTheNamesOfItsPages) {
  EXPECT_EQ(ask("GET", "/guide").body, "guide/index.html");
  EXPECT_EQ(ask("GET", "/guide/").body, "guide/index.html");
  EXPECT_EQ(ask("GET", "/guide/data").body, "guide/data.html");
  EXPECT_EQ(ask("GET", "/guide/data").content_type, "text/html; charset=utf-8");
  EXPECT_EQ(ask("GET", "/guide/pictures/jet.svg").content_type, "image/svg+xml");
  EXPECT_EQ(header_of(ask("GET", "/guide/data"), "Cache-Control"), "no-cache");
}

TEST_F(GuideTest, HasNoPageOutsideItsFolder) {
  for (const char* path : {"/guide/none", "/guide/../index", "/guide/%2e%2e/index", "/guide/..%2findex"})
    EXPECT_EQ(ask("GET", path).status, 404) << path;
}

TEST_F(ResourcesTest, TheGuideIsNotThereWhereTheClientWasNotBuilt) {
  EXPECT_EQ(ask("GET", "/guide").status, 404);
}

}  // namespace
}  // namespace floeplan::routes::resources_test
