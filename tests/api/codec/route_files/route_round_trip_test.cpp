#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/codec/documents/plan_document.hpp"
#include "api/codec/exports/plan_files.hpp"
#include "api/codec/features/plan_feature.hpp"
#include "api/codec/inputs/plan_inputs.hpp"
#include "api/codec/route_files/route_file.hpp"
#include "engine/mission/writing/goto_lists.hpp"
#include "engine/mission/writing/nmea_route.hpp"
#include "tests/engine/mission/random_plan.hpp"

namespace floeplan::codec::route_round_trip_test {
namespace {

using nlohmann::json;

constexpr double of_csv_deg = 0.51e-7;           // seven decimals of a degree
constexpr double of_minutes_deg = 0.51e-4 / 60;  // four decimals of a minute
constexpr double of_a_double_deg = 1e-9;

/// Places a few kilometres apart, often on the antimeridian and across it.
std::vector<geo::LonLat> random_way(std::mt19937_64& rng, int most) {
  geo::LonLat place{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -80.0, 80.0)};
  if (support::uniform_int(rng, 0, 1) == 0) place.lon_deg = support::uniform(rng, -1.0, 1.0) + 180.0;
  std::vector<geo::LonLat> way;
  for (int left = support::uniform_int(rng, 2, most); left > 0; --left) {
    geo::LonLat written{geo::wrap_longitude(place.lon_deg), place.lat_deg};
    if (std::abs(written.lon_deg) > 179.0 && support::uniform_int(rng, 0, 3) == 0) written.lon_deg = -180.0;
    way.push_back(written);
    place.lon_deg += support::uniform(rng, -0.8, 0.8);
    place.lat_deg += support::uniform(rng, 0.01, 0.2);
  }
  return way;
}

void expect_same(const std::string& name, const std::string& text, std::span<const geo::LonLat> way,
                 double tolerance_deg) {
  const auto read = read_route_file(name, text);
  ASSERT_TRUE(read.has_value()) << name << ": " << read.error().front().field << " "
                                << read.error().front().rule;
  EXPECT_TRUE(read->warnings.empty()) << name << ": " << read->warnings.front();
  ASSERT_EQ(read->places.size(), way.size()) << name << "\n" << text;
  for (std::size_t i = 0; i < way.size(); ++i) {
    EXPECT_LE(std::abs(geo::longitude_difference(way[i].lon_deg, read->places[i].lon_deg)), tolerance_deg)
        << name << " " << i;
    EXPECT_LE(std::abs(way[i].lat_deg - read->places[i].lat_deg), tolerance_deg) << name << " " << i;
  }
}

repository::PlanRecord record_of(const planning::Plan& plan) {
  repository::PlanRecord record;
  record.id = {"p-01"};
  record.name = "a <plan>";
  record.document_json = plan_document(plan, "p-01", "a <plan>").dump();
  return record;
}

TEST(RouteFiles, OfAPlanGiveItsWaypointsBack) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const std::vector<geo::LonLat> way = random_way(rng, 12);
    const planning::Plan plan = support::plan_of(way);

    expect_same("a.gpx", plan_gpx(plan, "p-01", "a <plan>"), way, of_csv_deg);
    expect_same("a.kml", plan_kml(plan, "p-01", "a <plan>"), way, of_csv_deg);
    expect_same("a.csv", plan_csv(plan), way, of_csv_deg);
    expect_same("a.nmea", mission::write_nmea_route(plan, "p-01").text, way, of_minutes_deg);
    expect_same("a.json", plan_imc(plan, {}, {}, {500.0}, "p-01", "", plan.departure),
                std::span{way}.subspan(1), of_a_double_deg);
    expect_same("a.geojson", plan_geojson(record_of(plan)).dump(), way, of_csv_deg);
    expect_same("a.geojson", plan_feature(record_of(plan)).dump(), way, of_csv_deg);
    expect_same("a.geojson", plan_feature(record_of(plan)).at("geometry").dump(), way, of_csv_deg);
  });
}

TEST(RouteFiles, OfAMissionGiveItsWaypointsBack) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const std::vector<geo::LonLat> way = random_way(rng, 8);

    const auto lists = mission::write_goto_lists(support::plan_of(way), {});

    ASSERT_TRUE(lists.has_value()) << lists.error().front().rule;
    ASSERT_EQ(lists->files.size(), 1U);
    expect_same(lists->files.front().name, lists->files.front().text, std::span{way}.subspan(1),
                of_minutes_deg);
  });
}

/// The parts of a plan come from /collections/plan-legs and plan-waypoints, here in any order.
TEST(RouteFiles, OfThePartsOfAPlanGiveItsWaypointsBack) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const std::vector<geo::LonLat> way = random_way(rng, 12);
    const repository::PlanRecord record = record_of(support::plan_of(way));
    for (std::vector<PlanPart> parts : {plan_legs(record), plan_waypoints(record)}) {
      std::ranges::shuffle(parts, rng);
      json collection{{"type", "FeatureCollection"}, {"features", json::array()}};
      for (const PlanPart& part : parts) collection["features"].push_back(part.feature);

      expect_same("legs.geojson", collection.dump(), way, of_csv_deg);

      if (parts.size() < 3) continue;
      const auto is_inner = [&](const json& feature) {
        const auto index = feature.at("properties").at("index").get<std::size_t>();
        return index > 0 && index + 1 < parts.size();
      };
      json lacking = collection;
      lacking["features"].erase(std::ranges::find_if(lacking["features"], is_inner));
      EXPECT_FALSE(read_route_file("legs.geojson", lacking.dump()).has_value());
      collection["numberReturned"] = parts.size();
      collection["numberMatched"] = parts.size() + 1;
      EXPECT_FALSE(read_route_file("legs.geojson", collection.dump()).has_value()) << "one page of several";
    }
  });
}

/// A request accepts GeoJSON in the same way as a file.
TEST(RouteFiles, OfAPlanMayStandInARequest) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const std::vector<geo::LonLat> way = random_way(rng, 12);

    const auto parsed = parse_evaluate_inputs(
        {{"depart", "2026-11-20T06:00:00Z"}, {"route", plan_geojson(record_of(support::plan_of(way)))}});

    ASSERT_TRUE(parsed.has_value()) << parsed.error().front().rule;
    EXPECT_EQ(parsed->route.size(), way.size());
  });
}

}  // namespace
}  // namespace floeplan::codec::route_round_trip_test
