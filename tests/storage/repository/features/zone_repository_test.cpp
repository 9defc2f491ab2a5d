#include "storage/repository/features/zone_repository.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::repository::zone_repository_test {
namespace {

using testing::ElementsAre;

const core::UtcTime noon = core::from_unix_seconds(1'795'176'000.0);

ocean::Zone zone_at(const std::string& name, double west_deg, ocean::ZoneKind kind = ocean::ZoneKind::no_go) {
  ocean::Zone zone;
  zone.name = name;
  zone.kind = kind;
  zone.area.outer = {{west_deg, 60.0}, {west_deg + 1.0, 60.0}, {west_deg + 1.0, 61.0}, {west_deg, 61.0}};
  return zone;
}

std::vector<std::string> names_of(const std::vector<ocean::Zone>& zones) {
  std::vector<std::string> names;
  for (const ocean::Zone& zone : zones) names.push_back(zone.name);
  return names;
}

class ZoneRepositoryTest : public testing::Test {
 protected:
  ZoneRepositoryTest() { DatasetRepository{db_}.insert(sample_dataset("zones", DatasetKind::zones)); }

  sql::Connection db_ = support::empty_store();
  ZoneRepository zones_{db_};
};

TEST_F(ZoneRepositoryTest, GivesBackZonesAsTheyWere) {
  ocean::Zone zone = zone_at("Harbour", -54.0, ocean::ZoneKind::stay_in);
  zone.area.holes = {{{-53.9, 60.4}, {-53.8, 60.4}, {-53.8, 60.5}}};
  zone.from = noon;
  zone.until = noon + core::Seconds{3600.0};
  zone.top = {10.0};
  zone.bottom = {80.0};
  zones_.insert({"zones"}, {zone, zone_at("", 10.0)});

  const auto found = zones_.load({"zones"}, {-55.0, 59.0, 12.0, 62.0}, noon);

  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].name, zone.name);
  EXPECT_EQ(found[0].kind, zone.kind);
  EXPECT_EQ(found[0].area.outer, zone.area.outer);
  EXPECT_EQ(found[0].area.holes, zone.area.holes);
  EXPECT_EQ(found[0].from, zone.from);
  EXPECT_EQ(found[0].until, zone.until);
  EXPECT_EQ(found[0].top, zone.top);
  EXPECT_EQ(found[0].bottom, zone.bottom);
  EXPECT_FALSE(found[1].from || found[1].until);
  EXPECT_TRUE(std::isinf(found[1].bottom.value));
}

TEST_F(ZoneRepositoryTest, FindsNoGoZonesOfTheAreaAndEveryStayInZone) {
  zones_.insert({"zones"}, {zone_at("near", 0.0), zone_at("far", 50.0),
                            zone_at("far range", 60.0, ocean::ZoneKind::stay_in)});

  EXPECT_THAT(names_of(zones_.load({"zones"}, {0.5, 60.5, 2.0, 70.0}, noon)),
              ElementsAre("near", "far range"));
}

TEST_F(ZoneRepositoryTest, LeavesOutWhatIsOver) {
  ocean::Zone over = zone_at("over", 0.0);
  over.until = noon - core::Seconds{1.0};
  ocean::Zone just_now = zone_at("just now", 0.0);
  just_now.until = noon;
  zones_.insert({"zones"}, {over, just_now});

  EXPECT_THAT(names_of(zones_.load({"zones"}, {-180.0, -90.0, 180.0, 90.0}, noon)), ElementsAre("just now"));
}

TEST_F(ZoneRepositoryTest, TellsTheZonesOfAPlaceAndForgetsThemWithTheirDataset) {
  zones_.insert({"zones"}, {zone_at("here", 0.0), zone_at("beside", 1.5)});

  EXPECT_THAT(names_of(zones_.at({"zones"}, {0.5, 60.5})), ElementsAre("here"));
  EXPECT_TRUE(DatasetRepository{db_}.remove({"zones"}));
  EXPECT_TRUE(zones_.at({"zones"}, {0.5, 60.5}).empty());
  DatasetRepository{db_}.insert(sample_dataset("zones", DatasetKind::zones));
  zones_.insert({"zones"}, {zone_at("new", 0.0)});
  EXPECT_THAT(names_of(zones_.at({"zones"}, {0.5, 60.5})), ElementsAre("new"));
}

}  // namespace
}  // namespace floeplan::repository::zone_repository_test
