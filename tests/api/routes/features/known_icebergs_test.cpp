#include <algorithm>
#include <set>
#include <string>
#include <tuple>

#include "engine/core/utc_text.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/environment/environment_loader.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"
#include "tests/support/empty_store.hpp"
#include "tests/support/property.hpp"

namespace floeplan::routes::known_icebergs_test {
namespace {

using nlohmann::json;
using repository::DatasetChoice;
using repository::DatasetKind;
using support::json_of;
using support::uniform;
using support::uniform_int;

constexpr core::UtcTime departure = core::from_unix_seconds(1.8e9);  // 2027-01-15T08:00:00Z
constexpr double hour_s = 3600.0;

/// The values that identify a sighting.
using Seen = std::tuple<std::string, double, double, std::string>;

/// The sightings that the map requests, and those that a plan uses.
class KnownIcebergsTest : public support::ApiTest {
 protected:
  void add(const std::string& id, const std::vector<ocean::Iceberg>& sightings) {
    repository::Dataset dataset;
    dataset.id = {id};
    dataset.kind = DatasetKind::icebergs;
    dataset.name = id;
    std::vector<geo::LonLat> places;
    for (const ocean::Iceberg& sighting : sightings) {
      places.push_back(sighting.place);
      dataset.time_start = std::min(dataset.time_start.value_or(sighting.observed), sighting.observed);
      dataset.time_end = std::max(dataset.time_end.value_or(sighting.observed), sighting.observed);
    }
    dataset.bounds = geo::bounding_box(places);
    repository::DatasetRepository{db_}.insert(dataset);
    repository::IcebergRepository{db_}.insert({id}, sightings);
  }

  static ocean::Iceberg berg(std::string id, geo::LonLat place, core::UtcTime observed) {
    ocean::Iceberg berg;
    berg.id = std::move(id);
    berg.place = place;
    berg.observed = observed;
    return berg;
  }

  void report_by_hand(const std::string& id, geo::LonLat place, core::UtcTime observed) {
    const json feature{{"type", "Feature"},
                       {"geometry", {{"type", "Point"}, {"coordinates", {place.lon_deg, place.lat_deg}}}},
                       {"properties", {{"berg_id", id}, {"observed", core::iso8601(observed)}}}};
    const Response made = ask("POST", "/collections/icebergs/items", feature.dump(),
                              {{"content-type", "application/geo+json"}});
    ASSERT_EQ(made.status, 201) << made.body;
  }

  std::set<Seen> on_the_map(const std::string& more = "") {
    const json page = json_of(ask("GET", "/collections/icebergs/items?limit=10000&latest=true&datetime=" +
                                             core::iso8601(departure) + more));
    std::set<Seen> seen;
    for (const json& feature : page.at("features")) {
      const json& place = feature["geometry"]["coordinates"];
      const json& stated = feature["properties"];
      seen.emplace(stated["berg_id"], place[0], place[1], stated["observed"]);
      cited_.insert(stated["dataset_id"].get<std::string>());
    }
    return seen;
  }

  std::set<Seen> in_the_plan(const repository::EnvironmentQuery& query) {
    const auto sea = repository::load_environment(db_, query);
    std::set<Seen> seen;
    for (const ocean::Iceberg& iceberg : sea->icebergs)
      seen.emplace(iceberg.id, iceberg.place.lon_deg, iceberg.place.lat_deg, core::iso8601(iceberg.observed));
    for (const ocean::DatasetRef& used : sea->datasets) obeyed_.insert(used.id);
    return seen;
  }

  /// The query of a plan over the whole sea of these tests.
  static repository::EnvironmentQuery everywhere() {
    repository::EnvironmentQuery query;
    query.area = {-60.0, 60.0, -40.0, 75.0};
    query.depart = departure;
    return query;
  }

  std::set<std::string> cited_;   // the datasets of what the map shows
  std::set<std::string> obeyed_;  // and of what plans are made on
};

TEST_F(KnownIcebergsTest, TheMapShowsTheBergsOfEveryFileThatAPlanJoins) {
  add("list", {berg("a", {-52.0, 69.0}, departure - core::Seconds{30.0 * hour_s}),
               berg("b", {-52.5, 69.2}, departure - core::Seconds{30.0 * hour_s})});
  add("update", {berg("a", {-52.1, 69.0}, departure - core::Seconds{2.0 * hour_s})});
  report_by_hand("c", {-53.0, 69.1}, departure - core::Seconds{hour_s});

  const auto shown = on_the_map();

  EXPECT_EQ(shown.size(), 3U);
  EXPECT_EQ(shown, in_the_plan(everywhere()));
  EXPECT_EQ(cited_, obeyed_);
}

TEST_F(KnownIcebergsTest, APlanObeysWhatWasReportedByHandJustBesideItsArea) {
  report_by_hand("c", {-53.0, 69.1}, departure - core::Seconds{hour_s});
  repository::EnvironmentQuery query = everywhere();
  query.area = {-52.8, 69.0, -52.0, 69.3};

  EXPECT_EQ(in_the_plan(query).size(), 1U) << "it may drift into the way, as a berg of a file may";
  query.iceberg_drift = false;
  EXPECT_TRUE(in_the_plan(query).empty());
}

TEST_F(KnownIcebergsTest, TheMapFollowsTheDatasetsAndTheAgeOfARequest) {
  add("list", {berg("a", {-52.0, 69.0}, departure - core::Seconds{30.0 * hour_s})});
  add("other", {berg("b", {-52.5, 69.2}, departure - core::Seconds{100.0 * hour_s})});
  add("third", {berg("c", {-52.5, 69.3}, departure - core::Seconds{1.0 * hour_s})});
  repository::EnvironmentQuery query = everywhere();
  query.icebergs = {DatasetChoice::How::named, {{"list"}, {"other"}}};
  EXPECT_EQ(on_the_map("&dataset=list,other"), in_the_plan(query));

  query.max_sighting_age = core::Seconds{10.0 * 24.0 * hour_s};
  EXPECT_EQ(in_the_plan(query).size(), 2U);
  EXPECT_EQ(on_the_map("&dataset=list,other&max_sighting_age_days=10"), in_the_plan(query));
}

/// Law: while the map shows a plan that is being flown, it shows every berg that the plan avoids, however
/// many days after the departure. The same holds for a probe.
TEST_F(KnownIcebergsTest, WhatAPlanObeysIsDrawnWhileItIsUnderWay) {
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    db_ = support::empty_store();
    std::vector<ocean::Iceberg> sightings;
    for (int i = 0; i < 8; ++i)
      sightings.push_back(berg(std::to_string(i), {-52.0 - 0.1 * i, 69.0},
                               departure - core::Seconds{hour_s * uniform_int(rng, 0, 140)}));
    add("file", sightings);
    repository::EnvironmentQuery query = everywhere();
    const int age_days = uniform_int(rng, 0, 6);
    query.max_sighting_age = core::Seconds{age_days * 86400.0};
    const auto obeyed = in_the_plan(query);
    const std::string later = core::iso8601(departure + core::Seconds{hour_s * uniform_int(rng, 0, 200)});
    const std::string rule =
        "&departure=" + core::iso8601(departure) + "&max_sighting_age_days=" + std::to_string(age_days);

    const json page =
        json_of(ask("GET", "/collections/icebergs/items?limit=10000&latest=true&datetime=" + later + rule));
    const json near = json_of(ask("GET", "/probe?lon=-52.4&lat=69&time=" + later + rule));

    EXPECT_EQ(page["numberMatched"].get<std::size_t>(), obeyed.size());
    EXPECT_EQ(near["icebergs_within"].size(), obeyed.size());
  });
}

TEST_F(KnownIcebergsTest, ParametersThatMakeNoSenseAreRefusedTogether) {
  const Response refused =
      ask("GET", "/collections/icebergs/items?max_sighting_age_days=31&dataset=one,other");
  EXPECT_EQ(refused.status, 400);
  EXPECT_EQ(json_of(refused)["errors"].size(), 3U) << refused.body;
  EXPECT_EQ(
      ask("GET", "/collections/icebergs/items?latest=true&datetime=2027-01-15T08:00:00Z&dataset=gone").status,
      404);
}

TEST_F(KnownIcebergsTest, MapAndPlansAgreeOnEveryStore) {
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    db_ = support::empty_store();
    cited_.clear();
    obeyed_.clear();
    const auto place = [&] { return geo::LonLat{uniform(rng, -54.0, -51.0), uniform(rng, 68.0, 70.0)}; };
    const auto moment = [&] { return departure + core::Seconds{hour_s * uniform_int(rng, -110, 10)}; };
    for (int file = uniform_int(rng, 1, 4); file > 0; --file) {
      std::vector<ocean::Iceberg> sightings;
      for (int i = uniform_int(rng, 1, 6); i > 0; --i) {
        const int name = uniform_int(rng, 0, 5);
        sightings.push_back(berg(name == 0 ? "" : std::to_string(name), place(), moment()));
      }
      add("file-" + std::to_string(file), sightings);
    }
    for (int i = uniform_int(rng, 0, 2); i > 0; --i) report_by_hand(std::to_string(i), place(), moment());

    EXPECT_EQ(on_the_map(), in_the_plan(everywhere()));
    EXPECT_TRUE(std::ranges::includes(obeyed_, cited_));
  });
}

}  // namespace
}  // namespace floeplan::routes::known_icebergs_test
