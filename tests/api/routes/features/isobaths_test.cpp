#include <gmock/gmock.h>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::isobaths_test {
namespace {

using nlohmann::json;
using support::json_of;

constexpr const char* items = "/collections/isobaths/items";

class IsobathsTest : public support::ApiTest {
 protected:
  /// From 0 m in the west to 400 m in the east, over 4 by 1 degrees.
  void store_slope() {
    repository::Dataset dataset;
    dataset.id = {"bathymetry-00000000"};
    dataset.kind = repository::DatasetKind::bathymetry;
    dataset.bounds = {-54.0, 69.0, -50.0, 70.0};
    repository::DatasetRepository{db_}.insert(dataset);
    repository::FieldRepository fields{db_};
    fields.create(
        dataset.id,
        {{geo::GeographicFrame{}, ocean::Axis{{-54.0, -52.0, -50.0}}, ocean::Axis{{69.0, 70.0}}}, {}, {}});
    fields.write_slice(dataset.id, "depth_m", 0, 0,
                       std::vector<float>{0.0F, 200.0F, 400.0F, 0.0F, 200.0F, 400.0F});
  }
  json depths(const std::string& query) {
    const auto response = ask("GET", items + query);
    EXPECT_EQ(response.status, 200) << response.body;
    json found = json::array();
    const json page = json_of(response);
    for (const auto& feature : page.at("features")) found.push_back(feature.at("properties").at("depth_m"));
    return found;
  }
};

TEST_F(IsobathsTest, RunWhereTheSeaIsThatDeep) {
  store_slope();
  const json line = json_of(ask("GET", items + std::string{"/100"}));
  EXPECT_EQ(line.at("geometry"), json::parse(R"({"type":"MultiLineString",
    "coordinates":[[[-53.0,70.0],[-53.0,69.0]]]})"));
  EXPECT_EQ(line.at("properties").at("dataset_ids"), json::parse(R"(["bathymetry-00000000"])"));
}

TEST_F(IsobathsTest, AreThoseOfTheUsualDepthsOrTheOneThatIsAskedFor) {
  store_slope();
  EXPECT_EQ(depths(""), json::parse("[5,10,20,30,50,75,100,150,200,300,400]"));
  EXPECT_EQ(depths("?depth_m=123"), json::parse("[123]"));
  EXPECT_EQ(depths("?depth_m=500"), json::array());
  EXPECT_EQ(ask("GET", items + std::string{"?depth_m=-5"}).status, 400);
  EXPECT_EQ(ask("GET", items + std::string{"?depth_m=5.5"}).status, 400);
  EXPECT_EQ(ask("GET", items + std::string{"/999"}).status, 404);
  EXPECT_EQ(ask("GET", items + std::string{"/deep"}).status, 404);
}

TEST_F(IsobathsTest, ComeInPagesAndByArea) {
  store_slope();
  const json first = json_of(ask("GET", items + std::string{"?limit=4"}));
  EXPECT_EQ(first.at("numberMatched"), 11);
  std::string next;
  for (const auto& link : first.at("links"))
    if (link.at("rel") == "next") next = link.at("href");
  ASSERT_NE(next, "");
  const json second = json_of(ask("GET", next.substr(std::string{"http://127.0.0.1:8080"}.size())));
  EXPECT_EQ(second.at("features").at(0).at("id"), 50);
  EXPECT_EQ(depths("?bbox=10,10,11,11"), json::array());
}

TEST_F(IsobathsTest, AreNoneInAnEmptyStore) { EXPECT_EQ(depths(""), json::array()); }

}  // namespace
}  // namespace floeplan::routes::isobaths_test
