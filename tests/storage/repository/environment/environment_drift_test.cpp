#include <gtest/gtest.h>

#include <limits>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/environment/environment_parts.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"
#include "tests/support/property.hpp"

namespace floeplan::repository::environment_drift_test {
namespace {

constexpr geo::BoundingBox bay{-56.0, 67.0, -48.0, 71.0};
constexpr std::size_t steps = 10;
constexpr std::size_t without_bound = std::numeric_limits<std::size_t>::max();

class DriftBox : public testing::Test {
 protected:
  DriftBox() {
    query_.area = {-52.5, 68.9, -52.0, 69.1};
    query_.depart = sample_time;
    query_.dive_depth = core::Metres{1000.0};
    DatasetRepository{db_}.insert(flow_);
    FieldRepository{db_}.create(
        flow_.id, {{geo::GeographicFrame{}, axis(bay.west_deg, 0.05, 161), axis(bay.south_deg, 0.05, 81)},
                   ocean::Axis{{0.0, 20.0, 60.0, 150.0, 400.0}},
                   axis(core::unix_seconds(sample_time), 3600.0, steps)});
    ocean::Iceberg shallow = sample_berg("a", {-52.1, 69.0});
    shallow.draft = core::Metres{10.0};
    ocean::Iceberg deep = sample_berg("b", {-52.2, 69.0});
    deep.draft = core::Metres{100.0};
    draft_.environment.icebergs = {shallow, deep};
  }

  static ocean::Axis axis(double first, double step, std::size_t count) {
    std::vector<double> nodes;
    for (std::size_t i = 0; i < count; ++i) nodes.push_back(first + step * static_cast<double>(i));
    return ocean::Axis{std::move(nodes)};
  }

  /// Nodes, levels and steps of the dataset that fill the box.
  std::size_t samples_in(const CurrentsBox& box) {
    const auto read = FieldRepository{db_}.load_currents(flow_.id, box.area, std::nullopt, box.deepest);
    return read->samples().u.size();
  }

  sql::Connection db_ = support::empty_store();
  Dataset flow_ = sample_dataset("flow", DatasetKind::currents, bay);
  EnvironmentQuery query_;
  Reading reading_;
  EnvironmentDraft draft_{
      .db = db_, .query = query_, .reading = reading_, .stored = {}, .environment = {}, .violations = {}};
};

TEST_F(DriftBox, ReachesAsFarAsIcebergsDriftAndDownToTheDeepestKeel) {
  const auto box = drift_box(draft_, flow_, steps, without_bound);

  ASSERT_TRUE(box);
  EXPECT_EQ(box->area, geo::grown(query_.area, reach_of_drift));
  EXPECT_EQ(box->deepest, core::Metres{100.0});
}

TEST_F(DriftBox, IsNeededWhereIcebergsDriftAlone) {
  query_.iceberg_drift = false;
  EXPECT_FALSE(drift_box(draft_, flow_, steps, without_bound));
  query_.iceberg_drift = true;
  draft_.environment.icebergs.clear();
  EXPECT_FALSE(drift_box(draft_, flow_, steps, without_bound));
}

TEST_F(DriftBox, IsReadWithTheAreaIfThatNeedsFewMoreSamples) {
  const CurrentsBox of_drift = *drift_box(draft_, flow_, steps, without_bound);
  const auto both_with = [&](const geo::BoundingBox& area, std::optional<core::Metres> deepest) {
    return box_of_both(draft_, flow_, {area, deepest}, of_drift);
  };

  EXPECT_FALSE(both_with(query_.area, std::nullopt));
  const auto both = both_with(of_drift.area, core::Metres{150.0});
  ASSERT_TRUE(both);
  EXPECT_EQ(both->area, of_drift.area);
  EXPECT_EQ(both->deepest, core::Metres{150.0}) << "deeper than the keels";
  EXPECT_EQ(both_with(of_drift.area, core::Metres{50.0})->deepest, of_drift.deepest);
  EXPECT_EQ(both_with(of_drift.area, std::nullopt)->deepest, std::nullopt);
  EXPECT_FALSE(both_with(of_drift.area, core::Metres{0.0})) << "most levels are for the keels alone";
}

TEST_F(DriftBox, IsReadAloneWhereATideIsLaidOnTheArea) {
  const CurrentsBox of_drift = *drift_box(draft_, flow_, steps, without_bound);
  query_.tides = TidesQuery{.choice = {.how = DatasetChoice::How::newest, .ids = {}}, .mode = TidesMode::add};
  EXPECT_FALSE(box_of_both(draft_, flow_, of_drift, of_drift));
}

/// Law: it keeps to the bound as long as it is larger than the area, and never leaves out a part of the area or a keel.
TEST_F(DriftBox, KeepsToTheBoundOfSamples) {
  const std::size_t all = samples_in(*drift_box(draft_, flow_, steps, without_bound));
  support::for_each_seed(12, [&](std::mt19937_64& rng) {
    const auto most = static_cast<std::size_t>(support::uniform(rng, 0.0, 1.1) * static_cast<double>(all));

    const auto box = drift_box(draft_, flow_, steps, most);

    ASSERT_TRUE(box);
    EXPECT_EQ(box->deepest, core::Metres{100.0});
    EXPECT_EQ(geo::united(box->area, query_.area), box->area);
    if (box->area != query_.area) {
      EXPECT_LE(samples_in(*box), most);
    }
  });
}

}  // namespace
}  // namespace floeplan::repository::environment_drift_test
