#include "storage/repository/fields/field_repository.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/sql/statement.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"
#include "tests/support/property.hpp"

namespace floeplan::repository::field_repository_test {
namespace {

constexpr geo::BoundingBox everywhere{-180.0, -90.0, 180.0, 90.0};
constexpr float missing = std::numeric_limits<float>::quiet_NaN();

ocean::Axis axis(double first, double step, int count) {
  std::vector<double> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(first + step * i);
  return ocean::Axis{nodes};
}

/// Noise with gaps, so that no two samples are alike.
std::vector<float> noise(std::mt19937_64& rng, std::size_t count) {
  std::vector<float> values(count);
  for (float& value : values) {
    value = support::uniform_int(rng, 0, 19) == 0 ? missing
                                                  : static_cast<float>(support::uniform(rng, -2.0, 2.0));
  }
  return values;
}

bool same_bits(std::span<const float> a, std::span<const float> b) {
  return std::ranges::equal(
      a, b, {}, [](float value) { return std::bit_cast<std::uint32_t>(value); },
      [](float value) { return std::bit_cast<std::uint32_t>(value); });
}

/// Half of the places lie on the rim, where a window that is too small fails first.
geo::LonLat place_in(std::mt19937_64& rng, const geo::BoundingBox& area) {
  const double lat = support::uniform(rng, area.south_deg, area.north_deg);
  return {area.west_deg + support::uniform(rng, 0.0, geo::width_deg(area)),
          std::vector{area.south_deg, area.north_deg, lat, lat}[rng() % 4]};
}

class FieldRepositoryTest : public testing::Test {
 protected:
  /// A dataset with one slice of noise as its depths.
  ocean::Bathymetry store_noise(std::mt19937_64& rng, const ocean::HorizontalGrid& grid) {
    DatasetRepository{db_}.remove(id_);
    DatasetRepository{db_}.insert(sample_dataset(id_.value, DatasetKind::bathymetry));
    fields_.create(id_, {grid, {}, {}});
    std::vector<float> depths_m = noise(rng, grid.size());
    fields_.write_slice(id_, "depth_m", 0, 0, depths_m);
    return {grid, std::move(depths_m)};
  }

  /// Law: anywhere in the area the window answers as the whole array does.
  void expect_same_inside(std::mt19937_64& rng, const ocean::Bathymetry& whole,
                          const geo::BoundingBox& area) {
    const auto window = fields_.load_bathymetry(id_, area);
    for (int i = 0; i < 50; ++i) {
      const geo::LonLat place = place_in(rng, area);
      const auto expected = whole.depth(place);
      const auto found = window ? window->depth(place) : std::nullopt;
      ASSERT_EQ(found.has_value(), expected.has_value()) << place.lon_deg << ' ' << place.lat_deg;
      if (expected) {
        ASSERT_NEAR(found->value, expected->value, 1e-5);
      }
    }
  }

  const DatasetId id_{"field"};
  sql::Connection db_ = support::empty_store();
  FieldRepository fields_{db_};
};

TEST_F(FieldRepositoryTest, KeepsTheShapeExactly) {
  DatasetRepository{db_}.insert(sample_dataset(id_.value, DatasetKind::currents));
  const geo::GridFrame frame = geo::PolarStereographicFrame{true, 70.0, -45.1, 0.1, 1e7 / 3.0};
  const ocean::Axis x{{-0.1, 0.2, 1.0 / 3.0}};
  const ocean::Axis y{{1e6 / 7.0}};
  const ocean::Axis depths{{0.494025, 1.541375}};
  const ocean::Axis times{{1.8e9 + 0.1, 1.8e9 + 3600.0}};
  fields_.create(id_, {{frame, x, y}, depths, times});

  const auto shape = fields_.shape(id_);

  ASSERT_TRUE(shape);
  EXPECT_EQ(shape->grid.frame(), frame);
  EXPECT_EQ(shape->grid.x().nodes(), x.nodes());
  EXPECT_EQ(shape->grid.y().nodes(), y.nodes());
  EXPECT_EQ(shape->depths_m->nodes(), depths.nodes());
  EXPECT_EQ(shape->times_s->nodes(), times.nodes());
  EXPECT_FALSE(fields_.shape({"unknown"}));
}

TEST_F(FieldRepositoryTest, KeepsEverySampleToTheBit) {
  std::mt19937_64 rng{1};
  DatasetRepository{db_}.insert(sample_dataset(id_.value, DatasetKind::currents));
  const ocean::HorizontalGrid grid{geo::GeographicFrame{}, axis(-60.0, 0.1, 131), axis(60.0, 0.1, 67)};
  fields_.create(id_, {grid, axis(0.5, 10.0, 3), axis(1.8e9, 3600.0, 2)});
  std::vector<float> u;
  std::vector<float> v;
  for (std::size_t time = 0; time < 2; ++time) {
    for (std::size_t depth = 0; depth < 3; ++depth) {
      for (auto* all : {&u, &v}) {
        const std::vector<float> slice = noise(rng, grid.size());
        fields_.write_slice(id_, all == &u ? "u_m_s" : "v_m_s", time, depth, slice);
        all->insert(all->end(), slice.begin(), slice.end());
      }
    }
  }

  const auto loaded = fields_.load_currents(id_, everywhere, std::nullopt, std::nullopt);

  ASSERT_TRUE(loaded);
  EXPECT_TRUE(same_bits(loaded->samples().u, u));
  EXPECT_TRUE(same_bits(loaded->samples().v, v));
  EXPECT_EQ(loaded->samples().grid.x().nodes(), grid.x().nodes());
}

/// Law: at its place and depth a block answers as the nodes around it do, to the bit, on a grid with an end and on one
/// that goes round the globe.
TEST_F(FieldRepositoryTest, ABlockAnswersAtAPlaceAsTheNodesAroundItDo) {
  std::mt19937_64 rng{1};
  for (const auto& x : {axis(-60.0, 0.1, 131), axis(-180.0, 4.0, 90)}) {
    DatasetRepository{db_}.remove(id_);
    DatasetRepository{db_}.insert(sample_dataset(id_.value, DatasetKind::currents));
    const ocean::HorizontalGrid grid{geo::GeographicFrame{}, x, axis(60.0, 0.1, 67)};
    fields_.create(id_, {grid, axis(0.0, 10.0, 3), axis(1.8e9, 3600.0, 2)});
    for (std::size_t i = 0; i < 6; ++i) {
      fields_.write_slice(id_, "u_m_s", i / 3, i % 3, noise(rng, grid.size()));
      fields_.write_slice(id_, "v_m_s", i / 3, i % 3, noise(rng, grid.size()));
    }
    CurrentBlocks kept{std::size_t{4} << 20};
    const geo::BoundingBox area{x.front() - 0.2, 59.9, x.back() + 0.2, 66.8};
    for (int i = 0; i < 300; ++i) {
      const geo::LonLat place = place_in(rng, area);
      const core::Metres depth{support::uniform(rng, 0.0, 20.0)};
      const auto around = fields_.load_currents(
          id_, {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg}, std::nullopt, depth, depth);
      const auto block = fields_.load_currents_at(id_, place, std::nullopt, depth, depth, kept);
      ASSERT_EQ(around.has_value(), block != nullptr) << place.lon_deg << ' ' << place.lat_deg;
      if (!around) continue;
      const core::UtcTime when = core::from_unix_seconds(1.8e9 + support::uniform(rng, 0.0, 3600.0));
      const auto expected = around->at(place, depth, when);
      const auto found = block->at(place, depth, when);
      ASSERT_EQ(expected.has_value(), found.has_value()) << place.lon_deg << ' ' << place.lat_deg;
      if (expected) {
        ASSERT_EQ(found->east.value, expected->east.value);
        ASSERT_EQ(found->north.value, expected->north.value);
      }
    }
  }
}

TEST_F(FieldRepositoryTest, ABlockIsReadOnceForThePlacesInIt) {
  DatasetRepository{db_}.insert(sample_dataset(id_.value, DatasetKind::currents));
  const ocean::HorizontalGrid grid{geo::GeographicFrame{}, axis(-60.0, 0.1, 131), axis(60.0, 0.1, 67)};
  fields_.create(id_, {grid, axis(0.0, 10.0, 2), axis(1.8e9, 3600.0, 2)});
  CurrentBlocks kept{std::size_t{4} << 20};
  const auto at = [&](geo::LonLat place, double depth_m, CurrentBlocks& blocks) {
    return fields_.load_currents_at(id_, place, std::nullopt, core::Metres{depth_m}, core::Metres{depth_m},
                                    blocks);
  };

  const auto first = at({-59.5, 60.5}, 0.0, kept);

  EXPECT_EQ(at({-57.0, 63.0}, 0.0, kept), first);
  EXPECT_EQ(first->samples().grid.size(), 64U * 64U);
  EXPECT_NE(at({-50.0, 63.0}, 0.0, kept), first) << "in the next block";
  EXPECT_NE(at({-59.5, 60.5}, 5.0, kept), first) << "between two levels";
  CurrentBlocks too_small{1000};
  EXPECT_LT(at({-59.5, 60.5}, 0.0, too_small)->samples().grid.size(), 64U);
}

TEST_F(FieldRepositoryTest, WritesASliceAgain) {
  std::mt19937_64 rng{1};
  const ocean::HorizontalGrid grid{geo::GeographicFrame{}, axis(0.0, 1.0, 70), axis(0.0, 1.0, 3)};
  store_noise(rng, grid);
  const std::vector<float> second(grid.size(), 7.0F);

  fields_.write_slice(id_, "depth_m", 0, 0, second);

  EXPECT_EQ(fields_.load_bathymetry(id_, everywhere)->depth_m(), second);
}

TEST_F(FieldRepositoryTest, WritesRowsAsItWritesTheSliceTheyAreOf) {
  std::mt19937_64 rng{1};
  const ocean::HorizontalGrid grid{geo::GeographicFrame{}, axis(0.0, 0.1, 70), axis(0.0, 0.1, 150)};
  const ocean::Bathymetry whole = store_noise(rng, grid);
  const std::span<const float> all{whole.depth_m()};
  const std::size_t band = 2 * FieldRepository::rows_together * 70;
  fields_.write_slice(id_, "depth_m", 0, 0, std::vector<float>(grid.size()));

  fields_.write_rows(id_, "depth_m", 2 * FieldRepository::rows_together, all.subspan(band));
  fields_.write_rows(id_, "depth_m", 0, all.first(band));

  EXPECT_TRUE(same_bits(fields_.load_bathymetry(id_, everywhere)->depth_m(), all));
  EXPECT_THROW(fields_.write_rows(id_, "depth_m", 1, all.first(band)), std::invalid_argument);
  EXPECT_THROW(fields_.write_rows(id_, "depth_m", 0, all.first(70)), std::invalid_argument);
  EXPECT_THROW(fields_.write_rows(id_, "depth_m", 0, all.first(71)), std::invalid_argument);
  EXPECT_THROW(fields_.write_rows(id_, "depth_m", 2 * FieldRepository::rows_together, all),
               std::invalid_argument);
}

TEST_F(FieldRepositoryTest, LeavesWhatWasNeverWrittenMissing) {
  DatasetRepository{db_}.insert(sample_dataset(id_.value, DatasetKind::bathymetry));
  fields_.create(id_, {{geo::GeographicFrame{}, axis(0.0, 1.0, 3), axis(0.0, 1.0, 3)}, {}, {}});

  EXPECT_EQ(fields_.load_bathymetry(id_, everywhere)->depth({1.0, 1.0}), std::nullopt);
}

TEST_F(FieldRepositoryTest, RefusesSlicesThatDoNotFit) {
  std::mt19937_64 rng{1};
  store_noise(rng, {geo::GeographicFrame{}, axis(0.0, 1.0, 4), axis(0.0, 1.0, 4)});
  const std::vector<float> slice(16);

  EXPECT_THROW(fields_.write_slice(id_, "depth_m", 0, 0, std::span{slice}.first(15)), std::invalid_argument);
  EXPECT_THROW(fields_.write_slice(id_, "depth_m", 1, 0, slice), std::invalid_argument);
  EXPECT_THROW(fields_.write_slice(id_, "depth_m", 0, 1, slice), std::invalid_argument);
}

TEST_F(FieldRepositoryTest, ReadsOnlyTheNodesAroundTheArea) {
  std::mt19937_64 rng{1};
  store_noise(rng, {geo::GeographicFrame{}, axis(0.0, 1.0, 200), axis(-50.0, 1.0, 100)});

  const auto window = fields_.load_bathymetry(id_, {62.5, 12.5, 66.5, 14.5});

  EXPECT_EQ(window->grid().x().nodes(), axis(62.0, 1.0, 6).nodes());
  EXPECT_EQ(window->grid().y().nodes(), axis(12.0, 1.0, 4).nodes());
}

TEST_F(FieldRepositoryTest, ReadsTheNodesAroundAnAreaSmallerThanACell) {
  std::mt19937_64 rng{1};
  store_noise(rng, {geo::GeographicFrame{}, axis(0.0, 1.0, 20), axis(0.0, 1.0, 20)});

  const auto window = fields_.load_bathymetry(id_, {5.4, 5.4, 5.6, 5.6});

  EXPECT_EQ(window->grid().x().nodes(), (std::vector{5.0, 6.0}));
  EXPECT_EQ(window->grid().y().nodes(), (std::vector{5.0, 6.0}));
}

TEST_F(FieldRepositoryTest, JoinsBothSidesOfTheSeamOfAGlobalGrid) {
  std::mt19937_64 rng{1};
  store_noise(rng, {geo::GeographicFrame{}, axis(0.0, 1.0, 360), axis(-10.0, 1.0, 21)});

  const auto window = fields_.load_bathymetry(id_, {-2.5, 0.0, 1.5, 1.0});

  EXPECT_EQ(window->grid().x().nodes(), axis(357.0, 1.0, 6).nodes());
}

TEST_F(FieldRepositoryTest, AnswersInAnyWindowAsTheWholeGridDoes) {
  support::for_each_seed(40, [&](std::mt19937_64& rng) {
    const double west = std::round(support::uniform(rng, -180.0, 300.0));
    const double south = support::uniform(rng, -80.0, 40.0);
    const ocean::HorizontalGrid grid{geo::GeographicFrame{}, axis(west, support::uniform(rng, 0.1, 2.0), 150),
                                     axis(south, 0.5, support::uniform_int(rng, 2, 90))};
    const ocean::Bathymetry whole = store_noise(rng, grid);
    for (int i = 0; i < 10; ++i) {
      const double area_south = support::uniform(rng, -90.0, 89.0);
      expect_same_inside(
          rng, whole,
          {support::uniform(rng, -180.0, 180.0), area_south, support::uniform(rng, -180.0, 180.0),
           std::min(90.0, area_south + support::uniform(rng, 0.0, 40.0))});
    }
  });
}

TEST_F(FieldRepositoryTest, AnswersInAnyWindowAsAGlobalGridDoes) {
  support::for_each_seed(40, [&](std::mt19937_64& rng) {
    const double west = std::vector{-180.0, 0.0, -179.5, 0.25, -280.0, 73.0}[rng() % 6];
    const ocean::HorizontalGrid grid{geo::GeographicFrame{}, axis(west, 2.0, 180), axis(-80.0, 4.0, 41)};
    const ocean::Bathymetry whole = store_noise(rng, grid);
    for (int i = 0; i < 10; ++i) {
      const double area_west = support::uniform(rng, -180.0, 180.0);
      const double area_south = support::uniform(rng, -85.0, 80.0);
      expect_same_inside(
          rng, whole,
          {area_west, area_south, geo::wrap_longitude(area_west + support::uniform(rng, 0.0, 359.0)),
           area_south + support::uniform(rng, 0.0, 10.0)});
    }
    expect_same_inside(rng, whole, everywhere);
  });
}

TEST_F(FieldRepositoryTest, AnswersInAnyWindowAsAGlobalGridWithItsSeamTwiceDoes) {
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    const ocean::HorizontalGrid grid{geo::GeographicFrame{}, axis(0.0, 3.0, 121), axis(-80.0, 4.0, 41)};
    std::vector<float> depths_m = noise(rng, grid.size());
    for (std::size_t row = 0; row < 41; ++row) depths_m[row * 121 + 120] = depths_m[row * 121];
    store_noise(rng, grid);
    fields_.write_slice(id_, "depth_m", 0, 0, depths_m);
    const ocean::Bathymetry whole{grid, depths_m};

    for (int i = 0; i < 10; ++i) {
      const double area_west = support::uniform(rng, -30.0, 30.0);
      expect_same_inside(rng, whole, {area_west, -20.0, area_west + support::uniform(rng, 0.0, 50.0), 20.0});
    }
  });
}

TEST_F(FieldRepositoryTest, AnswersInAnyWindowAsAPolarGridDoes) {
  support::for_each_seed(40, [&](std::mt19937_64& rng) {
    const bool north = rng() % 2 == 0;
    const geo::GridFrame frame = geo::PolarStereographicFrame{north, north ? 70.0 : -71.0, -45.0, 0.0, 0.0};
    const double first = support::uniform(rng, -4e6, -1e5);
    const ocean::HorizontalGrid grid{frame, axis(first, 40'000.0, 140), axis(first, 40'000.0, 140)};
    const ocean::Bathymetry whole = store_noise(rng, grid);
    for (int i = 0; i < 20; ++i) {
      // Every second area has the pole in it, some go all the way round it.
      const double edge = support::uniform(rng, 60.0, 88.0);
      const double inner = i % 2 == 0 ? 90.0 : support::uniform(rng, edge, 90.0);
      geo::BoundingBox area{support::uniform(rng, -180.0, 180.0), north ? edge : -inner,
                            support::uniform(rng, -180.0, 180.0), north ? inner : -edge};
      if (i % 4 == 0) area = {-180.0, area.south_deg, 180.0, area.north_deg};
      expect_same_inside(rng, whole, area);
    }
  });
}

TEST_F(FieldRepositoryTest, AnswersInAnyWindowAsATransverseMercatorGridDoes) {
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    const geo::GridFrame frame = geo::TransverseMercatorFrame{-51.0, 0.0, 0.9996, 500'000.0, 0.0};
    const ocean::HorizontalGrid grid{frame, axis(300'000.0, 2'000.0, 150), axis(7'600'000.0, 2'000.0, 120)};
    const ocean::Bathymetry whole = store_noise(rng, grid);
    for (int i = 0; i < 10; ++i) {
      const double west = support::uniform(rng, -57.0, -46.0);
      const double south = support::uniform(rng, 68.0, 71.0);
      expect_same_inside(
          rng, whole,
          {west, south, west + support::uniform(rng, 0.0, 5.0), south + support::uniform(rng, 0.0, 2.0)});
    }
    expect_same_inside(rng, whole, everywhere);
  });
}

TEST_F(FieldRepositoryTest, AnswersInAnyWindowAsAConicOrAzimuthalGridDoes) {
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    const geo::GridFrame frames[] = {
        geo::LambertConformalFrame{
            .lat_1_deg = 60.0, .lat_2_deg = 75.0, .lat_0_deg = 69.0, .lon_0_deg = -51.0},
        geo::AlbersFrame{.lat_1_deg = 60.0, .lat_2_deg = 75.0, .lat_0_deg = 69.0, .lon_0_deg = -51.0},
        geo::AzimuthalEqualAreaFrame{.lat_0_deg = 69.0, .lon_0_deg = -51.0}};
    const ocean::HorizontalGrid grid{frames[rng() % 3], axis(-150'000.0, 2'000.0, 150),
                                     axis(-120'000.0, 2'000.0, 120)};
    const ocean::Bathymetry whole = store_noise(rng, grid);
    for (int i = 0; i < 10; ++i) {
      const double west = support::uniform(rng, -57.0, -46.0);
      const double south = support::uniform(rng, 67.0, 70.5);
      expect_same_inside(
          rng, whole,
          {west, south, west + support::uniform(rng, 0.0, 5.0), south + support::uniform(rng, 0.0, 2.0)});
    }
    expect_same_inside(rng, whole, everywhere);
  });
}

TEST_F(FieldRepositoryTest, ReadsOnlyAPartOfAProjectedGrid) {
  for (const geo::GridFrame& frame :
       {geo::GridFrame{geo::PolarStereographicFrame{true, 70.0, -45.0, 0.0, 0.0}},
        geo::GridFrame{geo::AlbersFrame{90.0, 90.0, 90.0, -45.0}}}) {
    std::mt19937_64 rng{1};
    store_noise(rng, {frame, axis(-3e6, 10'000.0, 600), axis(-3e6, 10'000.0, 600)});

    const auto window = fields_.load_bathymetry(id_, {-54.0, 68.5, -50.0, 70.0});

    EXPECT_LT(window->grid().size(), 600U);
  }
}

TEST_F(FieldRepositoryTest, FindsTheNodesOnTheRimOfAGridInDegrees) {
  for (const double west : {-54.0 + 0.5 / 240.0, 179.9, 10.0 / 3.0}) {
    std::mt19937_64 rng{1};
    const ocean::HorizontalGrid grid{geo::GeographicFrame{}, axis(west, 1.0 / 240.0, 40),
                                     axis(69.0, 1.0 / 240.0, 30)};
    store_noise(rng, grid);
    for (std::size_t iy = 0; iy < 30; ++iy)
      for (const std::size_t ix : {std::size_t{0}, std::size_t{39}}) {
        const geo::LonLat node = grid.place(ix, iy);
        const geo::LonLat place{geo::wrap_longitude(node.lon_deg), node.lat_deg};
        EXPECT_TRUE(
            fields_.load_bathymetry(id_, {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg}))
            << ix << " " << iy;
      }
  }
}

TEST_F(FieldRepositoryTest, FindsTheNodesOnTheRimOfAProjectedGrid) {
  for (const geo::GridFrame& frame :
       {geo::GridFrame{geo::PolarStereographicFrame{true, 75.0, 0.0}},
        geo::GridFrame{geo::TransverseMercatorFrame{.lon_0_deg = -51.0, .false_easting_m = 500'000.0}},
        geo::GridFrame{geo::LambertConformalFrame{.lon_0_deg = -51.0}},
        geo::GridFrame{geo::AzimuthalEqualAreaFrame{.lat_0_deg = 10.0, .lon_0_deg = -51.0}}}) {
    const double north_m = std::holds_alternative<geo::PolarStereographicFrame>(frame) ? -2.2e6 : 7.6e6;
    std::mt19937_64 rng{1};
    const ocean::HorizontalGrid grid{frame, axis(4e5, 200.0, 40), axis(north_m, 200.0, 30)};
    store_noise(rng, grid);
    const geo::BoundingBox box = grid.bounds();
    for (std::size_t iy = 0; iy < 30; ++iy)
      for (std::size_t ix = 0; ix < 40; ix += iy == 0 || iy == 29 ? 1 : 39) {
        const geo::LonLat place = grid.place(ix, iy);
        EXPECT_TRUE(geo::contains(box, place)) << ix << " " << iy;
        EXPECT_TRUE(
            fields_.load_bathymetry(id_, {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg}))
            << ix << " " << iy;
      }
  }
}

TEST_F(FieldRepositoryTest, HasNothingWhereGridAndAreaDoNotMeet) {
  std::mt19937_64 rng{1};
  store_noise(rng, {geo::GeographicFrame{}, axis(-60.0, 1.0, 10), axis(60.0, 1.0, 10)});
  EXPECT_FALSE(fields_.load_bathymetry(id_, {0.0, 60.0, 1.0, 61.0}));
  EXPECT_FALSE(fields_.load_bathymetry(id_, {-60.0, 50.0, -55.0, 59.0}));

  store_noise(rng, {geo::PolarStereographicFrame{true, 70.0, -45.0}, axis(0.0, 1e4, 10), axis(0.0, 1e4, 10)});
  EXPECT_FALSE(fields_.load_bathymetry(id_, {-54.0, 68.5, -50.0, 70.0}));
  EXPECT_FALSE(fields_.load_bathymetry({"unknown"}, everywhere));
}

class CurrentWindow : public FieldRepositoryTest {
 protected:
  /// Each sample tells its time and depth: u = time index, v = depth index.
  CurrentWindow() {
    DatasetRepository{db_}.insert(sample_dataset(id_.value, DatasetKind::currents));
    const ocean::HorizontalGrid grid{geo::GeographicFrame{}, axis(0.0, 1.0, 2), axis(0.0, 1.0, 2)};
    fields_.create(
        id_, {grid, ocean::Axis{{0.0, 10.0, 50.0, 100.0}}, axis(core::unix_seconds(sample_time), 3600.0, 5)});
    for (std::size_t time = 0; time < 5; ++time) {
      for (std::size_t depth = 0; depth < 4; ++depth) {
        fields_.write_slice(id_, "u_m_s", time, depth, std::vector(4, static_cast<float>(time)));
        fields_.write_slice(id_, "v_m_s", time, depth, std::vector(4, static_cast<float>(depth)));
      }
    }
  }

  std::vector<double> times(core::UtcTime from, core::UtcTime to) {
    const auto currents = fields_.load_currents(id_, everywhere, Period{from, to}, std::nullopt);
    return currents ? currents->samples().times_s.nodes() : std::vector<double>{};
  }

  std::vector<double> depths(double deepest_m) {
    return fields_.load_currents(id_, everywhere, std::nullopt, core::Metres{deepest_m})
        ->samples()
        .depths_m->nodes();
  }
};

TEST_F(CurrentWindow, HoldsTheStepsAroundThePeriod) {
  const double first = core::unix_seconds(sample_time);

  EXPECT_THAT(times(sample_time + 1.5 * hour, sample_time + 2.5 * hour),
              testing::ElementsAre(first + 3600.0, first + 7200.0, first + 10800.0));
  EXPECT_THAT(times(sample_time + hour, sample_time + 2 * hour),
              testing::ElementsAre(first + 3600.0, first + 7200.0));
  EXPECT_EQ(times(sample_time - day, sample_time + day).size(), 5U);
}

TEST_F(CurrentWindow, IsNothingOutsideTheStoredPeriod) {
  EXPECT_TRUE(times(sample_time - day, sample_time - hour).empty());
  EXPECT_TRUE(times(sample_time + 5 * hour, sample_time + day).empty());
  EXPECT_EQ(times(sample_time - day, sample_time).size(), 1U);
}

TEST_F(CurrentWindow, HoldsTheLevelsDownToTheFirstAtOrBelowTheDeepest) {
  EXPECT_THAT(depths(30.0), testing::ElementsAre(0.0, 10.0, 50.0));
  EXPECT_THAT(depths(50.0), testing::ElementsAre(0.0, 10.0, 50.0));
  EXPECT_THAT(depths(0.0), testing::ElementsAre(0.0));
  EXPECT_EQ(depths(1000.0).size(), 4U);
}

TEST_F(CurrentWindow, HoldsOnlyTheLevelsAroundTheDepths) {
  const auto depths_between = [&](double shallowest_m, double deepest_m) {
    return fields_
        .load_currents(id_, everywhere, std::nullopt, core::Metres{deepest_m}, core::Metres{shallowest_m})
        ->samples()
        .depths_m->nodes();
  };

  EXPECT_THAT(depths_between(30.0, 40.0), testing::ElementsAre(10.0, 50.0));
  EXPECT_THAT(depths_between(10.0, 60.0), testing::ElementsAre(10.0, 50.0, 100.0));
  EXPECT_THAT(depths_between(-5.0, -1.0), testing::ElementsAre(0.0));
  EXPECT_THAT(depths_between(150.0, 200.0), testing::ElementsAre(100.0));
}

TEST_F(CurrentWindow, AnswersAtADepthAsAllLevelsDo) {
  const auto all = fields_.load_currents(id_, everywhere, std::nullopt, std::nullopt);
  support::for_each_seed(50, [&](std::mt19937_64& rng) {
    const core::Metres depth{support::uniform(rng, -5.0, 110.0)};
    const auto few = fields_.load_currents(id_, everywhere, std::nullopt, depth, depth);
    const auto expected = all->at({0.5, 0.5}, depth, sample_time);
    const auto found = few->at({0.5, 0.5}, depth, sample_time);
    ASSERT_EQ(found.has_value(), expected.has_value()) << depth.value;
    if (!expected) return;
    EXPECT_NEAR(found->north.value, expected->north.value, 1e-6);
  });
}

TEST_F(CurrentWindow, TakesTheRightSlices) {
  const auto currents = fields_.load_currents(
      id_, everywhere, Period{sample_time + 2 * hour, sample_time + 3 * hour}, core::Metres{5.0});

  const auto velocity = currents->at({0.5, 0.5}, {10.0}, sample_time + 2.5 * hour);
  ASSERT_TRUE(velocity);
  EXPECT_NEAR(velocity->east.value, 2.5, 1e-6);
  EXPECT_NEAR(velocity->north.value, 1.0, 1e-6);
}

TEST_F(FieldRepositoryTest, ReadsCurrentsWithoutTimeAndDepth) {
  DatasetRepository{db_}.insert(sample_dataset(id_.value, DatasetKind::currents));
  fields_.create(id_, {{geo::GeographicFrame{}, axis(0.0, 1.0, 2), axis(0.0, 1.0, 2)}, {}, {}});
  for (const char* variable : {"u_m_s", "v_m_s"})
    fields_.write_slice(id_, variable, 0, 0, std::vector(4, 0.5F));

  const auto currents =
      fields_.load_currents(id_, everywhere, Period{sample_time, sample_time}, core::Metres{200.0});

  ASSERT_TRUE(currents);
  EXPECT_FALSE(currents->samples().depths_m);
  EXPECT_EQ(currents->samples().times_s.size(), 1U);
}

TEST_F(FieldRepositoryTest, SaysWhenAChunkIsDamaged) {
  std::mt19937_64 rng{1};
  store_noise(rng, {geo::GeographicFrame{}, axis(0.0, 1.0, 4), axis(0.0, 1.0, 4)});
  const std::vector<std::byte> nonsense(10, std::byte{0x5a});
  sql::Statement spoil{db_, "UPDATE field_chunk SET samples = ?1"};
  spoil.bind(1, std::span{nonsense});
  spoil.run();

  try {
    (void)fields_.load_bathymetry(id_, everywhere);
    FAIL() << "the damage was not noticed";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("damaged"));
  }
}

TEST_F(FieldRepositoryTest, KeepsTheLeastDepthOfACellBesideItsDepth) {
  const ocean::HorizontalGrid grid{geo::GeographicFrame{}, ocean::Axis{{0.0, 1.0}},
                                   ocean::Axis{{60.0, 61.0}}};
  DatasetRepository{db_}.insert(sample_dataset("chart", DatasetKind::bathymetry, {0.0, 60.0, 1.0, 61.0}));
  FieldRepository fields{db_};
  fields.create({"chart"}, {grid, {}, {}});
  fields.write_slice({"chart"}, "depth_m", 0, 0, std::vector(4, 50.0F));
  fields.write_slice({"chart"}, "shoalest_m", 0, 0, std::vector{50.0F, 50.0F, 2.5F, 50.0F});

  const auto chart = fields.load_bathymetry({"chart"}, {0.0, 60.0, 1.0, 61.0});

  ASSERT_TRUE(chart);
  EXPECT_EQ(chart->depth({0.4, 60.4})->value, 50.0);
  EXPECT_EQ(chart->shoalest({0.4, 60.4})->value, 2.5);
}

}  // namespace
}  // namespace floeplan::repository::field_repository_test
