#include "storage/repository/environment/environment_loader.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <random>

#include "engine/messages/sentence.hpp"
#include "engine/ocean/iceberg_drift.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/coastline_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/features/zone_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/sql/statement.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"
#include "tests/support/property.hpp"

namespace floeplan::repository::environment_loader_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

constexpr geo::BoundingBox bay{-54.0, 68.0, -50.0, 70.0};
constexpr geo::BoundingBox elsewhere{10.0, 40.0, 12.0, 42.0};

class EnvironmentLoaderTest : public testing::Test {
 protected:
  EnvironmentLoaderTest() {
    query_.area = {-53.0, 68.5, -51.0, 69.5};
    query_.depart = sample_time;
  }

  Dataset add(const std::string& id, DatasetKind kind, const geo::BoundingBox& bounds,
              std::optional<core::UtcTime> from = {}, std::optional<core::UtcTime> to = {}) {
    Dataset dataset = sample_dataset(id, kind, bounds);
    dataset.time_start = from;
    dataset.time_end = to;
    dataset.provenance.ingested += core::Seconds{static_cast<double>(++added_)};
    DatasetRepository{db_}.insert(dataset);
    return dataset;
  }

  static ocean::HorizontalGrid grid(const geo::BoundingBox& box, double step_deg) {
    const auto nodes = [&](double from, double to) {
      std::vector<double> result;
      for (int i = 0; from + step_deg * i <= to; ++i) result.push_back(from + step_deg * i);
      return ocean::Axis{result};
    };
    return {geo::GeographicFrame{}, nodes(box.west_deg, box.east_deg), nodes(box.south_deg, box.north_deg)};
  }

  /// Eastward currents whose strength in m/s is the number of the step.
  void add_currents(const std::string& id, core::UtcTime from, int steps, std::optional<ocean::Axis> depths_m,
                    const geo::BoundingBox& box = bay) {
    add(id, DatasetKind::currents, box, from, from + (steps - 1) * hour);
    std::vector<double> times;
    for (int i = 0; i < steps; ++i) times.push_back(core::unix_seconds(from + i * hour));
    store_currents(id, box, ocean::Axis{times}, depths_m);
  }

  void store_currents(const std::string& id, const geo::BoundingBox& box,
                      const std::optional<ocean::Axis>& times, const std::optional<ocean::Axis>& depths_m) {
    const FieldShape shape{grid(box, 0.5), depths_m, times};
    FieldRepository fields{db_};
    fields.create({id}, shape);
    for (std::size_t time = 0; time < (times ? times->size() : 1); ++time) {
      for (std::size_t depth = 0; depth < (depths_m ? depths_m->size() : 1); ++depth) {
        fields.write_slice({id}, "u_m_s", time, depth,
                           std::vector(shape.grid.size(), static_cast<float>(time)));
        fields.write_slice({id}, "v_m_s", time, depth, std::vector(shape.grid.size(), 0.0F));
      }
    }
  }

  void add_bathymetry(const std::string& id, double step_deg) {
    add(id, DatasetKind::bathymetry, bay);
    const ocean::HorizontalGrid nodes = grid(bay, step_deg);
    FieldRepository fields{db_};
    fields.create({id}, {nodes, {}, {}});
    fields.write_slice({id}, "depth_m", 0, 0, std::vector(nodes.size(), 300.0F));
  }

  /// Ice of one metre whose concentration is a tenth of the number of the day.
  void add_ice(const std::string& id, core::UtcTime from, int days, bool with_thickness = true) {
    add(id, DatasetKind::ice, bay, from, from + (days - 1) * day);
    std::vector<double> times;
    for (int i = 0; i < days; ++i) times.push_back(core::unix_seconds(from + i * day));
    const FieldShape shape{grid(bay, 0.5), {}, ocean::Axis{times}};
    FieldRepository fields{db_};
    fields.create({id}, shape);
    for (std::size_t time = 0; time < times.size(); ++time) {
      fields.write_slice({id}, "concentration", time, 0,
                         std::vector(shape.grid.size(), 0.1F * static_cast<float>(time)));
      if (with_thickness)
        fields.write_slice({id}, "thickness_m", time, 0, std::vector(shape.grid.size(), 1.0F));
    }
  }

  void add_icebergs(const std::string& id, const std::vector<ocean::Iceberg>& bergs) {
    core::UtcTime from = bergs.front().observed;
    core::UtcTime to = from;
    for (const ocean::Iceberg& berg : bergs) {
      from = std::min(from, berg.observed);
      to = std::max(to, berg.observed);
    }
    add(id, DatasetKind::icebergs, bay, from, to);
    IcebergRepository{db_}.insert({id}, bergs);
  }

  ocean::Environment load() {
    auto environment = load_environment(db_, query_);
    if (environment) return *environment;
    for (const core::Violation& violation : environment.error()) {
      ADD_FAILURE() << violation.field << ": " << violation.rule;
    }
    return {};
  }

  std::vector<std::string> violations() {
    std::vector<std::string> result;
    const auto environment = load_environment(db_, query_);
    if (environment) return result;
    for (const core::Violation& violation : environment.error())
      result.push_back(violation.field + " " + violation.rule);
    return result;
  }

  static std::vector<std::string> cited(const ocean::Environment& environment) {
    std::vector<std::string> result;
    for (const ocean::DatasetRef& dataset : environment.datasets) result.push_back(dataset.id);
    return result;
  }

  static DatasetChoice named(const std::vector<std::string>& ids) {
    DatasetChoice choice{.how = DatasetChoice::How::named, .ids = {}};
    for (const std::string& id : ids) choice.ids.push_back({id});
    return choice;
  }

  static DatasetChoice none() { return {.how = DatasetChoice::How::none, .ids = {}}; }

  sql::Connection db_ = support::empty_store();
  EnvironmentQuery query_;
  int added_ = 0;
  const ocean::Axis levels_{{0.0, 50.0, 300.0}};
};

TEST_F(EnvironmentLoaderTest, WarnsOfEverythingThatIsMissing) {
  const ocean::Environment environment = load();

  EXPECT_EQ(environment.currents, nullptr);
  EXPECT_EQ(environment.bathymetry, nullptr);
  EXPECT_THAT(environment.datasets, IsEmpty());
  EXPECT_THAT(messages::sentences(environment.messages),
              ElementsAre(AllOf(HasSubstr("no currents are stored"), HasSubstr("made in still water")),
                          HasSubstr("no bathymetry is stored"),
                          AllOf(HasSubstr("no sea ice is stored for"), HasSubstr("open water is assumed")),
                          HasSubstr("no icebergs are stored"), HasSubstr("no coastline is stored")));
}

TEST_F(EnvironmentLoaderTest, RefusesToPlanInStillWaterWhereItHasCurrentsOfOtherWatersOnly) {
  add_currents("currents-far", sample_time, 5, levels_, elsewhere);
  const auto refused = load_environment(db_, query_);
  query_.currents = none();
  const auto still = load_environment(db_, query_);

  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error(),
              ElementsAre(AllOf(Field(&core::Violation::field, "/currents"),
                                Field(&core::Violation::rule, HasSubstr("currents-far")),
                                Field(&core::Violation::rule, HasSubstr("--currents none")))));
  ASSERT_TRUE(still);
  EXPECT_EQ(still->currents, nullptr);
}

TEST_F(EnvironmentLoaderTest, WarnsOfWhatWasLeftOutAsRequested) {
  add_bathymetry("depths", 0.02);
  query_.bathymetry = none();

  const ocean::Environment environment = load();

  EXPECT_EQ(environment.bathymetry, nullptr);
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(HasSubstr("bathymetry was left out as requested")));
}

TEST_F(EnvironmentLoaderTest, TakesTheNewestOfEachKindThatMeetsTheArea) {
  add_currents("currents-old", sample_time, 5, levels_);
  add_currents("currents-new", sample_time, 5, levels_);
  add_currents("currents-far", sample_time, 5, levels_, elsewhere);
  add_bathymetry("depths", 0.02);
  add_ice("ice", sample_time, 5);
  add_icebergs("bergs", {sample_berg("a", {-52.0, 69.0})});
  add("coast", DatasetKind::coastline, bay);
  CoastlineRepository{db_}.insert({"coast"}, {{{{-53.0, 69.0}, {-52.9, 69.0}, {-52.9, 69.1}}, {}}});

  const ocean::Environment environment = load();

  EXPECT_THAT(cited(environment), ElementsAre("currents-new", "depths", "ice", "bergs", "coast"));
  EXPECT_EQ(environment.datasets[0].kind, "currents");
  EXPECT_EQ(environment.datasets[0].sha256, "0123currents-new");
  EXPECT_EQ(environment.icebergs.size(), 1U);
  EXPECT_EQ(environment.land.size(), 1U);
  EXPECT_THAT(messages::sentences(environment.messages), IsEmpty());
}

TEST_F(EnvironmentLoaderTest, TakesAnOlderDatasetWhenTheNewestDoesNotCoverTheDeparture) {
  add_currents("currents-covers", sample_time, 5, levels_);
  add_currents("currents-later", sample_time + day, 5, levels_);

  EXPECT_THAT(cited(load()), ElementsAre("currents-covers"));
}

TEST_F(EnvironmentLoaderTest, ReadsCurrentsFromTheLastStepBeforeDepartureToTheEnd) {
  add_currents("currents", sample_time - 3 * hour, 10, levels_);
  query_.depart = sample_time + 0.5 * hour;

  const ocean::Environment environment = load();

  const ocean::Axis& times = environment.currents->samples().times_s;

  EXPECT_EQ(times.front(), core::unix_seconds(sample_time));
  EXPECT_EQ(times.back(), core::unix_seconds(sample_time + 6 * hour));
}

TEST_F(EnvironmentLoaderTest, RefusesADepartureOutsideTheCurrents) {
  add_currents("currents", sample_time + day, 5, levels_);

  EXPECT_THAT(violations(), ElementsAre(AllOf(HasSubstr("/depart"),
                                              HasSubstr("2027-01-16T08:00:00Z to 2027-01-16T12:00:00Z"),
                                              HasSubstr("--steady"))));
  query_.currents = named({"currents"});
  EXPECT_THAT(violations(), ElementsAre(HasSubstr("/depart")));
}

TEST_F(EnvironmentLoaderTest, FollowsAnOlderRunBeyondTheEndOfTheNewest) {
  add_currents("currents-long", sample_time, 10, levels_);
  add_currents("currents-short", sample_time, 3, levels_);
  query_.until = {"depart_until", sample_time + 5 * hour};

  EXPECT_THAT(cited(load()), ElementsAre("currents-short", "currents-long"));
}

TEST_F(EnvironmentLoaderTest, RefusesAWindowThatRunsOutOfTheCurrents) {
  add_currents("currents", sample_time, 5, levels_);
  query_.until = {"depart_until", sample_time + 5 * hour};

  EXPECT_THAT(violations(), ElementsAre(AllOf(HasSubstr("/depart_until"), HasSubstr("Stay within"))));
}

TEST_F(EnvironmentLoaderTest, ReadsCurrentsFromTheirBeginningForAWantedArrival) {
  add_currents("currents", sample_time, 5, levels_);
  query_.depart = sample_time - day;
  query_.until = {"arrive_by", sample_time + 4 * hour};
  query_.may_begin_later = true;

  EXPECT_EQ(load().currents->samples().times_s.front(), core::unix_seconds(sample_time));

  query_.until = {"arrive_by", sample_time + 5 * hour};
  EXPECT_THAT(violations(), ElementsAre(HasSubstr("/arrive_by")));
}

TEST_F(EnvironmentLoaderTest, HoldsCurrentsSteadyAtTheirMeanAtAnyTime) {
  add_currents("currents", sample_time + day, 5, levels_);
  query_.steady = true;

  const ocean::Environment environment = load();

  EXPECT_TRUE(environment.steady_currents);
  EXPECT_EQ(environment.currents->samples().times_s.size(), 1U);
  EXPECT_THAT(environment.currents->samples().u, testing::Each(2.0F));
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(AllOf(HasSubstr("held steady"), HasSubstr("mean of 5 time steps"))));
}

TEST_F(EnvironmentLoaderTest, HoldsTheOneStepSteady) {
  add_currents("currents", sample_time - day, 1, levels_);
  query_.steady = true;

  const ocean::Environment environment = load();

  EXPECT_TRUE(environment.steady_currents);
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(HasSubstr("the currents of 2027-01-14T08:00:00Z at all times")));
}

TEST_F(EnvironmentLoaderTest, WarnsOfSteadyCurrentsOfAnotherTime) {
  constexpr core::Seconds year = 365.0 * day;
  add_currents("currents", sample_time - year, 5, levels_);
  query_.steady = true;
  EXPECT_THAT(messages::sentences(load().messages), Contains(HasSubstr("days from that time")));

  query_.depart = sample_time - year + hour;
  EXPECT_THAT(messages::sentences(load().messages), testing::Not(Contains(HasSubstr("days from that time"))));
}

TEST_F(EnvironmentLoaderTest, HoldsCurrentsWithoutTimeSteady) {
  add("currents", DatasetKind::currents, bay);
  store_currents("currents", bay, std::nullopt, levels_);

  const ocean::Environment environment = load();

  EXPECT_TRUE(environment.steady_currents);
  EXPECT_NE(environment.currents, nullptr);
  EXPECT_THAT(messages::sentences(environment.messages), Contains(HasSubstr("state no time")));
}

TEST_F(EnvironmentLoaderTest, WarnsOfCurrentsThatSayLittleOfDepth) {
  add_currents("currents", sample_time, 2, std::nullopt);
  EXPECT_THAT(messages::sentences(load().messages), Contains(HasSubstr("state no depth")));

  add_currents("currents-surface", sample_time, 2, ocean::Axis{{0.5}});
  EXPECT_THAT(messages::sentences(load().messages), Contains(HasSubstr("one level (1 m)")));

  add_currents("currents-shallow", sample_time, 2, ocean::Axis{{0.0, 50.0}});
  EXPECT_THAT(messages::sentences(load().messages),
              Contains(AllOf(HasSubstr("end at a depth of 50 m"), HasSubstr("dives go to 200 m"))));
}

TEST_F(EnvironmentLoaderTest, TellsOfIcebergsOnLand) {
  add_icebergs("bergs", {sample_berg("afloat", {-52.0, 69.0}), sample_berg("ashore", {-51.5, 69.0})});
  add("coast", DatasetKind::coastline, bay);
  CoastlineRepository{db_}.insert({"coast"},
                                  {{{{-51.6, 68.9}, {-51.4, 68.9}, {-51.4, 69.1}, {-51.6, 69.1}}, {}}});

  const ocean::Environment environment = load();

  EXPECT_EQ(environment.icebergs.size(), 2U) << "it is avoided all the same";
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(AllOf(HasSubstr("1 iceberg lies on land"), HasSubstr("ashore"))));
}

TEST_F(EnvironmentLoaderTest, PrefersTheFinestBathymetryThatCoversTheArea) {
  add_bathymetry("fine", 0.02);
  add_bathymetry("coarse-but-newer", 0.5);

  EXPECT_THAT(cited(load()), ElementsAre("fine"));
}

TEST_F(EnvironmentLoaderTest, PutsBathymetryTogetherInTheOrderOfTheNames) {
  add_bathymetry("fine", 0.02);
  add("survey", DatasetKind::bathymetry, {-52.5, 68.8, -52.0, 69.2});
  const ocean::HorizontalGrid nodes = grid({-52.5, 68.8, -52.0, 69.2}, 0.05);
  FieldRepository fields{db_};
  fields.create({"survey"}, {nodes, {}, {}});
  fields.write_slice({"survey"}, "depth_m", 0, 0, std::vector(nodes.size(), 20.0F));
  query_.bathymetry = named({"survey", "fine"});

  const ocean::Environment environment = load();

  EXPECT_THAT(cited(environment), ElementsAre("survey", "fine"));
  EXPECT_EQ(environment.bathymetry->depth({-52.2, 69.0})->value, 20.0);
  EXPECT_EQ(environment.bathymetry->depth({-51.5, 69.0})->value, 300.0);
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(HasSubstr("bathymetry comes from several datasets")));
}

TEST_F(EnvironmentLoaderTest, WarnsOfCoarseBathymetry) {
  add_bathymetry("depths", 0.5);
  EXPECT_THAT(messages::sentences(load().messages), Contains(AllOf(HasSubstr("coarse"), HasSubstr("20 km"))));
}

TEST_F(EnvironmentLoaderTest, SaysHowManyBergsWereSeenTooLongAgo) {
  add_icebergs("bergs", {sample_berg("old", {-52.0, 69.0}, sample_time - 4 * day),
                         sample_berg("young", {-52.0, 69.1}, sample_time - 2 * day),
                         sample_berg("later", {-52.0, 69.2}, sample_time + hour)});

  const ocean::Environment environment = load();

  ASSERT_EQ(environment.icebergs.size(), 1U);
  EXPECT_EQ(environment.icebergs[0].id, "young");
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(AllOf(testing::StartsWith("Danger: 1 of 3 icebergs"),
                             HasSubstr("ignored, not seen since"), testing::EndsWith(": old"))));
}

/// Law: the bergs used, those ignored for their age and those only seen later add up to the bergs known, even if a
/// berg was seen too long ago and again after the departure.
TEST_F(EnvironmentLoaderTest, CountsEveryBergOnce) {
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    db_ = support::empty_store();
    std::vector<ocean::Iceberg> sightings;
    std::int64_t bergs = 0;
    for (int i = 0; i < 12; ++i) {
      const auto add = [&](core::Seconds after) {
        sightings.push_back(
            sample_berg("berg" + std::to_string(i), {-52.0, 69.0 + 0.01 * i}, sample_time + after));
      };
      const int when = support::uniform_int(rng, 1, 7);  // one bit for each time at which it was seen
      if (when & 1) add(-10 * day);
      if (when & 2) add(-1 * day);
      if (when & 4) add(1 * day);
      ++bergs;
    }
    add_icebergs("bergs", sightings);

    const ocean::Environment environment = load();

    auto counted = std::ssize(environment.icebergs);
    for (const messages::Message& message : environment.messages) {
      if (!message.code.starts_with("sightings-")) continue;
      for (const auto& [name, value] : message.values) {
        if (name == "ignored") counted += std::get<std::int64_t>(value);
        if (name == "known") {
          EXPECT_EQ(std::get<std::int64_t>(value), bergs);
        } else if (name == "used") {
          EXPECT_EQ(std::get<std::int64_t>(value), std::ssize(environment.icebergs));
        }
      }
    }
    EXPECT_EQ(counted, bergs);
  });
}

/// Law: the message about sightings left out for their age is the same, in however many lists the sightings
/// came.
TEST_F(EnvironmentLoaderTest, TellsOfBergsSeenTooLongAgoHoweverTheyWereListed) {
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    db_ = support::empty_store();
    const int lists = support::uniform_int(rng, 1, 4);
    std::vector<std::vector<ocean::Iceberg>> of_lists(static_cast<std::size_t>(lists));
    int too_old = 0;
    for (int i = 0; i < 8; ++i) {
      const double age_days = support::uniform(rng, 0.1, 29.0);
      if (age_days > 3.0 && age_days < 5.0) continue;  // the rule's own day counts as young
      too_old += age_days > 3.0;
      of_lists[static_cast<std::size_t>(support::uniform_int(rng, 0, lists - 1))].push_back(
          sample_berg("berg" + std::to_string(i), {-52.0, 69.0 + 0.01 * i}, sample_time - age_days * day));
    }
    for (std::size_t i = 0; i < of_lists.size(); ++i)
      if (!of_lists[i].empty()) add_icebergs("list" + std::to_string(i), of_lists[i]);

    const auto warnings = messages::sentences(load().messages);

    const auto told = std::ranges::find_if(warnings, [](const std::string& text) {
      return text.find("ignored, not seen since") != std::string::npos;
    });
    ASSERT_EQ(told != warnings.end(), too_old > 0);
    if (too_old > 0) {
      EXPECT_THAT(*told, testing::StartsWith("Danger: " + std::to_string(too_old) + " of "));
    }
  });
}

TEST_F(EnvironmentLoaderTest, TellsOfABergThatWasOnlySeenAfterTheDeparture) {
  add_icebergs("bergs", {sample_berg("later", {-52.0, 69.2}, sample_time + core::Seconds{1.0})});

  const ocean::Environment environment = load();

  EXPECT_THAT(environment.icebergs, IsEmpty());
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(AllOf(
                  testing::StartsWith("Danger: 1 of 1 iceberg was ignored, because its only recent sightings "
                                      "are later than the departure"),
                  HasSubstr("--icebergs-as-of"), HasSubstr(": later at "))));
  EXPECT_THAT(messages::sentences(environment.messages), Not(Contains(HasSubstr("no icebergs are stored"))));
}

TEST_F(EnvironmentLoaderTest, LeavesOutLaterSightingsWithoutADangerWhereTheUserSaidSo) {
  add_icebergs("bergs", {sample_berg("now", {-52.0, 69.0}, sample_time - hour),
                         sample_berg("later", {-52.0, 69.2}, sample_time + hour)});
  query_.icebergs_as_of = sample_time;

  const auto warnings = messages::sentences(load().messages);

  EXPECT_THAT(
      warnings,
      Contains(testing::StartsWith("1 of 2 icebergs was left out as requested, because its only recent")));
  EXPECT_THAT(warnings, Not(Contains(testing::StartsWith("Danger"))));
}

/// Law: messages name exactly those bergs near the area that were seen within a month after the departure,
/// and of which no sighting counts.
TEST_F(EnvironmentLoaderTest, TellsOfEveryBergThatOnlyLaterSightingsKnow) {
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    db_ = support::empty_store();
    std::vector<std::vector<ocean::Iceberg>> of_lists(
        static_cast<std::size_t>(support::uniform_int(rng, 1, 3)));
    const auto add = [&](const ocean::Iceberg& berg) {
      of_lists[static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(of_lists.size()) - 1))]
          .push_back(berg);
    };
    int told = 0;
    for (int i = 0; i < 8; ++i) {
      const std::string name = "berg" + std::to_string(i);
      const geo::LonLat place{-52.0, 69.0 + 0.01 * i};
      const bool counts = support::uniform_int(rng, 0, 1) == 1;
      const double first_days = support::uniform(rng, 0.01, 40.0);
      if (counts) add(sample_berg(name, place, sample_time - hour));
      add(sample_berg(name, place, sample_time + first_days * day));
      add(sample_berg(name, place, sample_time + (first_days + 1.0) * day));
      told += !counts && first_days <= 30.0;
    }
    for (std::size_t i = 0; i < of_lists.size(); ++i)
      if (!of_lists[i].empty()) add_icebergs("list" + std::to_string(i), of_lists[i]);

    const auto warnings = messages::sentences(load().messages);

    const auto found = std::ranges::find_if(warnings, [](const std::string& text) {
      return text.find("later than the departure") != std::string::npos;
    });
    ASSERT_EQ(found != warnings.end(), told > 0);
    if (told > 0) {
      EXPECT_THAT(*found, testing::StartsWith("Danger: " + std::to_string(told) + " of "));
    }
  });
}

TEST_F(EnvironmentLoaderTest, LeavesOutIcebergsOlderThanAsked) {
  add_icebergs("bergs", {sample_berg("a", {-52.0, 69.0}, sample_time - 2 * day),
                         sample_berg("b", {-52.1, 69.0}, sample_time - 8 * day)});

  query_.max_sighting_age = 10 * day;
  EXPECT_EQ(load().icebergs.size(), 2U);
  query_.max_sighting_age = 1 * day;
  EXPECT_EQ(load().icebergs.size(), 0U);
}

TEST_F(EnvironmentLoaderTest, AdvisesALargerAgeOfSightingsOnlyIfThatHelps) {
  const auto advice = HasSubstr("raise the maximum sighting age");
  add_icebergs("bergs", {sample_berg("a", {-52.0, 69.0}, sample_time - 20 * day)});
  EXPECT_THAT(messages::sentences(load().messages), Contains(advice));

  db_ = support::empty_store();
  add_icebergs("bergs", {sample_berg("a", {-52.0, 69.0}, sample_time - 40 * day)});
  query_.max_sighting_age = ocean::largest_sighting_age;
  const auto told = messages::sentences(load().messages);
  EXPECT_THAT(told, Contains(HasSubstr("Ingest newer sightings. Ignored: a")));
  EXPECT_THAT(told, Not(Contains(advice)));
}

TEST_F(EnvironmentLoaderTest, KnowsWhereADriftingBergWasSeenBefore) {
  add_icebergs("bergs", {sample_berg("a", {-52.0, 69.0}, sample_time - 20 * hour),
                         sample_berg("a", {-52.1, 69.1}, sample_time - 8 * hour),
                         sample_berg("a", {-52.2, 69.2}, sample_time - 2 * hour),
                         sample_berg("a", {-52.3, 69.3}, sample_time - 200 * hour),
                         sample_berg("b", {-52.4, 69.0}, sample_time - 30 * hour)});

  const ocean::Environment environment = load();

  ASSERT_EQ(environment.icebergs.size(), 2U);
  const auto& a = environment.icebergs[0];
  ASSERT_EQ(a.id, "a");
  EXPECT_EQ(a.place.lon_deg, -52.2);
  ASSERT_EQ(a.earlier.size(), 2U);
  EXPECT_EQ(a.earlier[0].place.lon_deg, -52.0);
  EXPECT_EQ(a.earlier[0].time, sample_time - 20 * hour);
  EXPECT_EQ(a.earlier[1].place.lon_deg, -52.1);
  EXPECT_THAT(environment.icebergs[1].earlier, IsEmpty());

  query_.iceberg_drift = false;
  EXPECT_THAT(load().icebergs[0].earlier, IsEmpty());
}

TEST_F(EnvironmentLoaderTest, ReadsCurrentsFromTheOldestDriftingBergOn) {
  add_currents("flow", sample_time - 40 * hour, 60, levels_);
  const auto first_step = [&] { return core::from_unix_seconds(load().currents->samples().times_s.front()); };
  EXPECT_EQ(first_step(), sample_time);

  add_icebergs("bergs", {sample_berg("a", {-52.0, 69.0}, sample_time - 30 * hour),
                         sample_berg("b", {-52.1, 69.0}, sample_time - 75 * hour)});

  EXPECT_EQ(first_step(), sample_time - 40 * hour);
  query_.max_sighting_age = core::Seconds{0.0};
  query_.icebergs_as_of = sample_time - 30 * hour;
  EXPECT_EQ(first_step(), sample_time - 30 * hour);
  query_.iceberg_drift = false;
  EXPECT_EQ(first_step(), sample_time);
}

/// The drift of a berg relative to the water between two sightings can be computed only with the currents of
/// that time. This holds whatever other icebergs are stored.
TEST_F(EnvironmentLoaderTest, ReadsCurrentsFromTheSightingOnThatTellsOfADrift) {
  add_currents("flow", sample_time - 40 * hour, 60, levels_);
  add_icebergs("bergs", {sample_berg("a", {-52.0, 69.0}, sample_time - 14 * hour),
                         sample_berg("a", {-52.02, 69.01}, sample_time - 2 * hour)});
  EXPECT_EQ(core::from_unix_seconds(load().currents->samples().times_s.front()), sample_time - 14 * hour);
  EXPECT_THAT(messages::sentences(load().messages),
              Not(Contains(HasSubstr("first seen before the currents begin"))));

  DatasetRepository{db_}.remove({"flow"});
  add_currents("late", sample_time - 10 * hour, 30, levels_);
  EXPECT_THAT(messages::sentences(load().messages),
              Contains(HasSubstr("1 of 1 iceberg was first seen before the currents begin")));
}

TEST_F(EnvironmentLoaderTest, TakesDriftingBergsFromBeyondTheArea) {
  add_icebergs("bergs", {sample_berg("near", {-52.0, 69.9}, sample_time - hour),
                         sample_berg("far", {-52.0, 71.0}, sample_time - hour)});

  ASSERT_EQ(load().icebergs.size(), 1U);
  EXPECT_EQ(load().icebergs[0].id, "near");
  query_.iceberg_drift = false;
  EXPECT_THAT(load().icebergs, IsEmpty());
}

/// Law: what carries an iceberg is the same whatever the area and the vehicle, wherever the iceberg counts.
TEST_F(EnvironmentLoaderTest, CarriesABergByTheWaterAllAlongItsKeelFromOutsideTheArea) {
  add("flow", DatasetKind::currents, bay, sample_time, sample_time + 24 * hour);
  std::vector<double> times;
  for (int i = 0; i <= 24; ++i) times.push_back(core::unix_seconds(sample_time + i * hour));
  const ocean::Axis depths{{0.0, 20.0, 60.0, 150.0, 400.0}};
  const FieldShape shape{grid(bay, 0.05), depths, ocean::Axis{times}};
  FieldRepository fields{db_};
  fields.create({"flow"}, shape);
  std::mt19937_64 rng{7};
  for (std::size_t time = 0; time < times.size(); ++time) {
    for (std::size_t depth = 0; depth < depths.size(); ++depth) {
      for (const char* component : {"u_m_s", "v_m_s"}) {
        std::vector<float> values(shape.grid.size());
        for (float& value : values) value = static_cast<float>(support::uniform(rng, -0.3, 0.3));
        fields.write_slice({"flow"}, component, time, depth, values);
      }
    }
  }
  ocean::Iceberg berg = sample_berg("a", {-52.45, 69.0});
  berg.draft = core::Metres{170.0};
  add_icebergs("bergs", {berg});
  const auto carried = [&](const geo::BoundingBox& area, double dive_m) {
    query_.area = area;
    query_.dive_depth = core::Metres{dive_m};
    const ocean::Environment environment = load();
    EXPECT_THAT(messages::sentences(environment.messages),
                Not(Contains(HasSubstr("the current is not known"))));
    return ocean::forecast_drift(environment.icebergs.at(0), environment, sample_time + 20 * hour)
        .back()
        .place;
  };

  const geo::LonLat expected = carried({-53.0, 68.5, -51.0, 69.5}, 1000.0);

  support::for_each_seed(4, [&](std::mt19937_64& seeded) {
    const double west_deg = support::uniform(seeded, -52.3, -51.0);
    const geo::LonLat place =
        carried({west_deg, 68.9, west_deg + 0.25, 69.1}, support::uniform(seeded, 5.0, 300.0));
    EXPECT_NEAR(place.lon_deg, expected.lon_deg, 1e-9);
    EXPECT_NEAR(place.lat_deg, expected.lat_deg, 1e-9);
  });
}

TEST_F(EnvironmentLoaderTest, KeepsTheCurrentsToPlanInToTheAreaAndTheDives) {
  add_currents("flow", sample_time, 5, levels_);
  query_.area = {-52.0, 68.9, -51.8, 69.1};
  query_.dive_depth = core::Metres{30.0};
  const auto alone = load().currents;

  ocean::Iceberg berg = sample_berg("a", {-52.45, 69.0});
  berg.draft = core::Metres{170.0};
  add_icebergs("bergs", {berg});
  const ocean::Environment environment = load();

  EXPECT_EQ(environment.currents->samples().u, alone->samples().u);
  ASSERT_TRUE(environment.drift_currents);
  EXPECT_GT(environment.drift_currents->samples().grid.size(), alone->samples().grid.size());
  EXPECT_EQ(environment.drift_currents->samples().depths_m->back(), 300.0);
  query_.iceberg_drift = false;
  EXPECT_EQ(load().drift_currents, nullptr);
}

TEST_F(EnvironmentLoaderTest, CarriesIcebergsBySteadyCurrentsAndByEachMember) {
  add_currents("member-1", sample_time, 5, levels_);
  add_currents("member-2", sample_time, 5, levels_);
  add_icebergs("bergs", {sample_berg("a", {-52.45, 69.0})});
  query_.currents = named({"member-1", "member-2"});

  const ocean::Environment environment = load();

  ASSERT_EQ(environment.drift_members.size(), 2U);
  EXPECT_EQ(environment.drift_currents, environment.drift_members.front());
  query_.currents = named({"member-1"});
  query_.steady = true;
  EXPECT_THAT(load().drift_currents->samples().u, testing::Each(2.0F));
}

TEST_F(EnvironmentLoaderTest, NamesTheIcebergsWhoseCurrentIsNotKnown) {
  add_currents("flow", sample_time - 5 * hour, 30, levels_, {-52.5, 68.0, -50.0, 70.0});
  add_icebergs("bergs", {sample_berg("carried", {-52.0, 69.0}, sample_time - 2 * hour),
                         sample_berg("beyond", {-53.5, 69.0}, sample_time - 2 * hour),
                         sample_berg("before", {-52.2, 69.0}, sample_time - 9 * hour)});

  const auto warnings = messages::sentences(load().messages);
  EXPECT_THAT(warnings, Contains(AllOf(HasSubstr("1 of 3 icebergs drifts beyond the current data"),
                                       HasSubstr("beyond"), Not(HasSubstr("carried")))));
  EXPECT_THAT(warnings, Contains(HasSubstr("1 of 3 icebergs was last seen before the currents begin")));
}

TEST_F(EnvironmentLoaderTest, CountsTheAgeOfSightingsBeforeTheEarliestDeparture) {
  add_icebergs("bergs", {sample_berg("fresh", {-52.0, 69.0}, sample_time - 10 * hour),
                         sample_berg("old", {-52.1, 69.0}, sample_time - 5 * day),
                         sample_berg("later", {-52.2, 69.0}, sample_time + 2 * day)});
  query_.currents = none();
  query_.until = {"arrive_by", sample_time + 6 * day};
  query_.may_begin_later = true;

  const ocean::Environment environment = load();

  std::vector<std::string> names;
  for (const ocean::Iceberg& berg : environment.icebergs) names.push_back(berg.id);
  EXPECT_THAT(names, UnorderedElementsAre("fresh", "later"));
}

/// Law: a sighting that counts for a span of departures counts for each of them as in a request for this
/// departure alone.
TEST_F(EnvironmentLoaderTest, TellsFromWhichDepartureOnASightingIsTooOld) {
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    const core::UtcTime observed = sample_time + core::Seconds{support::uniform(rng, -2.0, 2.0) * 86'400.0};
    const std::string name = "bergs-" + std::to_string(added_);
    add_icebergs(name, {sample_berg("a", {-52.0, 69.0}, observed)});
    query_.depart = sample_time;
    query_.icebergs = named({name});
    query_.max_sighting_age = core::Seconds{support::uniform(rng, 2.0, 4.0) * 86'400.0};
    query_.until = {"arrive_by", sample_time + 8 * day};
    query_.may_begin_later = true;
    const auto together = load().icebergs;
    ASSERT_EQ(together.size(), 1U);
    query_.until.reset();
    query_.may_begin_later = false;
    for (int i = 0; i < 10; ++i) {
      query_.depart = observed + core::Seconds{support::uniform(rng, 0.0, 6.0) * 86'400.0};
      EXPECT_EQ(load().icebergs.empty(), ocean::is_too_old(together[0], query_.depart));
    }
  });
}

TEST_F(EnvironmentLoaderTest, TakesIcebergsAsOfTheTimeAskedFor) {
  add_icebergs("bergs-then", {sample_berg("a", {-52.0, 69.0}, sample_time - 30 * day)});
  add_icebergs("bergs-now", {sample_berg("b", {-52.0, 69.0}, sample_time - hour)});
  EXPECT_THAT(cited(load()), ElementsAre("bergs-now"));

  query_.icebergs_as_of = sample_time - 29 * day;

  EXPECT_THAT(cited(load()), ElementsAre("bergs-then"));
}

TEST_F(EnvironmentLoaderTest, KeepsTheBergsOfAnEarlierListThatALaterOneDoesNotName) {
  std::vector<ocean::Iceberg> sixty;
  for (int i = 0; i < 60; ++i)
    sixty.push_back(
        sample_berg("berg " + std::to_string(i), {-52.4 + 0.01 * i, 69.0}, sample_time - 30 * hour));
  add_icebergs("list", sixty);
  add_icebergs("update", {sample_berg("berg 7", {-52.30, 69.05}, sample_time - 2 * hour),
                          sample_berg("new", {-52.0, 69.1}, sample_time - 2 * hour)});

  const ocean::Environment environment = load();

  ASSERT_EQ(environment.icebergs.size(), 61U);
  const auto moved = std::ranges::find(environment.icebergs, "berg 7", &ocean::Iceberg::id);
  EXPECT_EQ(moved->place.lat_deg, 69.05);
  ASSERT_EQ(moved->earlier.size(), 1U) << "its track leads through both lists";
  EXPECT_EQ(moved->earlier.front().time, sample_time - 30 * hour);
  EXPECT_THAT(cited(environment), UnorderedElementsAre("list", "update"));
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(AllOf(HasSubstr("several datasets"), HasSubstr("59 of"), HasSubstr("2 of"))));
}

TEST_F(EnvironmentLoaderTest, FollowsABergThatLeftTheArea) {
  add_icebergs("list", {sample_berg("a", {-52.0, 69.0}, sample_time - 60 * hour)});
  add("update", DatasetKind::icebergs, elsewhere, sample_time - hour, sample_time - hour);
  IcebergRepository{db_}.insert({"update"}, {sample_berg("a", {-52.0, 71.0}, sample_time - hour)});

  EXPECT_THAT(load().icebergs, IsEmpty());
}

TEST_F(EnvironmentLoaderTest, TakesOneNameForTwoBergsWhereNoBergDriftsSoFast) {
  add_icebergs("monday", {sample_berg("1", {-52.0, 69.0}, sample_time - 26 * hour)});
  add_icebergs("tuesday", {sample_berg("1", {-51.0, 69.8}, sample_time - 25 * hour)});

  EXPECT_EQ(load().icebergs.size(), 2U);
}

TEST_F(EnvironmentLoaderTest, JoinsSeveralNamedDatasetsOfIcebergs) {
  add_icebergs("bergs-1", {sample_berg("a", {-52.0, 69.0})});
  add_icebergs("bergs-2", {sample_berg("b", {-52.0, 69.0})});
  query_.icebergs = named({"bergs-1", "bergs-2"});

  const ocean::Environment environment = load();

  EXPECT_EQ(environment.icebergs.size(), 2U);
  EXPECT_THAT(cited(environment), ElementsAre("bergs-1", "bergs-2"));
}

TEST_F(EnvironmentLoaderTest, ReportsEveryNamedDatasetThatCannotBeUsed) {
  add_currents("currents-far", sample_time, 5, levels_, elsewhere);
  add_bathymetry("depths", 0.02);
  query_.currents = named({"currents-far"});
  query_.bathymetry = named({"unknown"});
  query_.icebergs = named({"depths"});

  EXPECT_THAT(violations(),
              ElementsAre(AllOf(HasSubstr("/currents"), HasSubstr("does not overlap the area")),
                          AllOf(HasSubstr("/bathymetry"), HasSubstr("unknown")),
                          AllOf(HasSubstr("/icebergs"), HasSubstr("holds bathymetry, not icebergs"))));
}

TEST_F(EnvironmentLoaderTest, TakesSeveralNamedCurrentsAsTheMembersOfAnEnsemble) {
  add_currents("currents-1", sample_time, 5, levels_);
  add_currents("currents-2", sample_time, 5, levels_);
  query_.currents = named({"currents-1"});
  EXPECT_THAT(cited(load()), ElementsAre("currents-1"));
  EXPECT_TRUE(load().members.empty());

  query_.currents = named({"currents-1", "currents-2"});

  const auto environment = load();
  EXPECT_THAT(cited(environment), ElementsAre("currents-1", "currents-2"));
  ASSERT_EQ(environment.members.size(), 2U);
  EXPECT_EQ(environment.currents, environment.members.front());
}

TEST_F(EnvironmentLoaderTest, RefusesAnEnsembleWhoseMembersDoNotAllCoverTheDeparture) {
  add_currents("currents-1", sample_time, 5, levels_);
  add_currents("currents-2", sample_time + core::Seconds{1e7}, 5, levels_);
  query_.currents = named({"currents-1", "currents-2"});

  EXPECT_THAT(violations(), ElementsAre(AllOf(HasSubstr("/depart"), HasSubstr("currents-2"))));
}

TEST_F(EnvironmentLoaderTest, LoadsTheIceFromTheStepBeforeTheDepartureOn) {
  add_ice("ice", sample_time - 2.5 * day, 6);

  const ocean::Environment environment = load();

  ASSERT_NE(environment.ice, nullptr);
  EXPECT_EQ(environment.ice->samples().times_s.size(), 4U);
  const auto state = environment.ice->at({-52.0, 69.0}, sample_time);
  ASSERT_TRUE(state);
  EXPECT_NEAR(state->concentration, 0.25, 1e-6);
  EXPECT_EQ(state->thickness, core::Metres{1.0});
}

TEST_F(EnvironmentLoaderTest, HoldsTheIceForThreeDaysBeyondItsPeriodAndSaysSo) {
  add_ice("ice", sample_time - 3.9 * day, 2, false);

  const ocean::Environment environment = load();

  ASSERT_NE(environment.ice, nullptr);
  EXPECT_EQ(environment.ice->samples().times_s.size(), 1U);
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(AllOf(HasSubstr("at 2027-01-12T"), HasSubstr("one state of the sea ice"))));
  EXPECT_THAT(messages::sentences(environment.messages), Contains(HasSubstr("no thickness")));
}

/// Data of the hour itself have priority over newer data that begin later or were made earlier. Data of a
/// part of the area leave the rest to other datasets.
TEST_F(EnvironmentLoaderTest, TakesIceOfOtherDatasetsWhereOrWhenTheNewestTellsNothing) {
  add_ice("full", sample_time - 2.0 * day, 10);
  add_ice("later", sample_time + 2.0 * day, 10);

  ocean::Environment environment = load();

  EXPECT_EQ(environment.further_ice.size(), 1U);
  EXPECT_THAT(cited(environment), testing::IsSupersetOf({"later", "full"}));
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(HasSubstr("sea ice comes from several datasets")));
  EXPECT_THAT(messages::sentences(environment.messages),
              Not(Contains(HasSubstr("one state of the sea ice"))));

  add_ice("newest", sample_time - 2.0 * day, 40);
  environment = load();
  EXPECT_THAT(environment.further_ice, IsEmpty()) << "the newest tells all that they could";
  EXPECT_THAT(cited(environment), Not(Contains("full")));
}

TEST_F(EnvironmentLoaderTest, TakesOlderIceWhereTheNewestHasAGapOrEnds) {
  add_ice("full", sample_time - day, 10);
  add_ice("gaps", sample_time - day, 10);
  std::vector<float> with_a_gap(grid(bay, 0.5).size(), 0.0F);
  with_a_gap[with_a_gap.size() / 2] = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t time = 0; time < 10; ++time)
    FieldRepository{db_}.write_slice({"gaps"}, "concentration", time, 0, with_a_gap);
  query_.area = bay;

  EXPECT_EQ(load().further_ice.size(), 1U);
  EXPECT_THAT(cited(load()), testing::IsSupersetOf({"gaps", "full"}));
}

/// The plan may last until the ice begins.
TEST_F(EnvironmentLoaderTest, TakesIceThatBeginsWhileTheMissionMayLast) {
  add_ice("later", sample_time + 9.0 * day, 5);

  EXPECT_NE(load().ice, nullptr);
  EXPECT_THAT(
      messages::sentences(load().messages),
      Contains(AllOf(HasSubstr("the stored sea ice begins at 2027-01-24T"), HasSubstr("Until 2027-01-21T"))));

  query_.ice = named({"later"});
  EXPECT_THAT(violations(), ElementsAre(HasSubstr("/ice has no sea ice for")));
}

TEST_F(EnvironmentLoaderTest, TakesTheIceOfTheLatestDepartureToo) {
  add_ice("later", sample_time + 40.0 * day, 5);
  EXPECT_EQ(load().ice, nullptr);
  EXPECT_THAT(messages::sentences(load().messages),
              Contains(HasSubstr("no stored sea ice covers the time of departure")));

  query_.steady = true;
  query_.until = CoveredUntil{"arrive_by", sample_time + 30.0 * day};
  EXPECT_NE(load().ice, nullptr);
}

TEST_F(EnvironmentLoaderTest, TakesAChartThatWasFilledInLaterBesideTheDataOfTheTime) {
  add_ice("daily", sample_time - 2.0 * day, 10);
  add_ice("chart", sample_time - 0.75 * day, 1);

  EXPECT_EQ(load().ice->samples().times_s.size(), 1U);
  EXPECT_EQ(load().further_ice.size(), 1U);
  EXPECT_THAT(messages::sentences(load().messages), Not(Contains(HasSubstr("one state of the sea ice"))));
}

TEST_F(EnvironmentLoaderTest, TakesOlderIceInALongGapOfTheNewest) {
  add_ice("daily", sample_time - 2.0 * day, 10);
  add(std::string{"gap"}, DatasetKind::ice, bay, sample_time - 10.0 * day, sample_time + 10.0 * day);
  const ocean::Axis times_s{
      {core::unix_seconds(sample_time - 10.0 * day), core::unix_seconds(sample_time + 10.0 * day)}};
  const FieldShape shape{grid(bay, 0.5), {}, times_s};
  FieldRepository fields{db_};
  fields.create({"gap"}, shape);
  for (const std::size_t time : {0U, 1U})
    fields.write_slice({"gap"}, "concentration", time, 0, std::vector(shape.grid.size(), 0.0F));

  EXPECT_EQ(load().further_ice.size(), 1U);
  query_.ice = named({"gap"});
  EXPECT_THAT(messages::sentences(load().messages),
              Contains(HasSubstr("the sea ice at the departure is unknown")));
}

TEST_F(EnvironmentLoaderTest, TakesOlderIceForItsThicknessWhereTheNewestHasNone) {
  add_ice("older", sample_time - day, 5, false);
  add_ice("model", sample_time - day, 5);
  add_ice("satellite", sample_time - day, 5, false);

  EXPECT_THAT(cited(load()), testing::IsSupersetOf({"satellite", "model"}));
  EXPECT_THAT(cited(load()), Not(Contains("older")));
  EXPECT_THAT(messages::sentences(load().messages),
              Contains(HasSubstr("has no thickness. Where other datasets")));
}

TEST_F(EnvironmentLoaderTest, TakesAreasOfFastIceOnlyWhereThereIsNoOtherIce) {
  add_ice("ice", sample_time - day, 3);
  Dataset fast = sample_dataset("fast", DatasetKind::ice, bay);
  fast.variables = {"ice"};
  fast.time_start = fast.time_end = sample_time;
  fast.provenance.ingested += core::Seconds{1000.0};
  DatasetRepository{db_}.insert(fast);
  const FieldShape shape{grid(bay, 0.5), {}, ocean::Axis{{core::unix_seconds(sample_time)}}};
  FieldRepository{db_}.create({"fast"}, shape);
  FieldRepository{db_}.write_slice({"fast"}, "concentration", 0, 0, std::vector(shape.grid.size(), 1.0F));

  const ocean::Environment both = load();
  EXPECT_NEAR(both.ice->at({-52.0, 69.0}, sample_time)->concentration, 0.1, 1e-6);
  EXPECT_THAT(messages::sentences(both.messages),
              Contains(HasSubstr("does not say whether the water outside")));

  DatasetRepository{db_}.remove({"ice"});
  EXPECT_EQ(load().ice->at({-52.0, 69.0}, sample_time)->concentration, 1.0);
}

/// The ice at the departure is not known. That the data have ended is no reason to assume open water.
TEST_F(EnvironmentLoaderTest, TakesIceThatEndedBeforeTheDepartureForTheKeelsThatWereKnownLast) {
  add_ice("ice", sample_time - 9.0 * day, 2);

  const ocean::Environment environment = load();

  ASSERT_NE(environment.ice, nullptr);
  EXPECT_EQ(environment.ice->samples().times_s.size(), 1U);
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(AllOf(HasSubstr("the sea ice at the departure is unknown"), HasSubstr("2027-01-07T"),
                             HasSubstr("last known keels"))));

  add_ice("newer", sample_time - day, 5);
  EXPECT_THAT(load().further_ice, IsEmpty()) << "newer keels are known";
}

TEST_F(EnvironmentLoaderTest, TakesNoIceOfAnotherTime) {
  add_ice("ice", sample_time - 39.0 * day, 2);

  const ocean::Environment environment = load();

  EXPECT_EQ(environment.ice, nullptr);
  EXPECT_THAT(
      messages::sentences(environment.messages),
      Contains(AllOf(HasSubstr("no stored sea ice covers the time of departure"), HasSubstr("open water"))));
  query_.ice = named({"ice"});
  EXPECT_THAT(violations(),
              ElementsAre(AllOf(HasSubstr("/ice has no sea ice for"), HasSubstr("3 days before and after"))));
}

ocean::Zone zone_of(const std::string& name, const geo::BoundingBox& box) {
  ocean::Zone zone;
  zone.name = name;
  zone.area.outer = {{box.west_deg, box.south_deg},
                     {box.east_deg, box.south_deg},
                     {box.east_deg, box.north_deg},
                     {box.west_deg, box.north_deg}};
  return zone;
}

TEST_F(EnvironmentLoaderTest, ObeysEveryZoneThatIsStoredForTheArea) {
  add("zones-1", DatasetKind::zones, bay);
  ZoneRepository{db_}.insert({"zones-1"}, {zone_of("a", bay), zone_of("b", elsewhere)});
  add("zones-2", DatasetKind::zones, bay);
  ZoneRepository{db_}.insert({"zones-2"}, {zone_of("c", bay)});
  add("zones-3", DatasetKind::zones, elsewhere);
  ZoneRepository{db_}.insert({"zones-3"}, {zone_of("d", elsewhere)});

  const auto environment = load_environment(db_, query_);

  ASSERT_TRUE(environment);
  ASSERT_EQ(environment->zones.size(), 2U);
  EXPECT_EQ(environment->zones[0].name, "c") << "the newest first";
  EXPECT_EQ(environment->zones[1].name, "a");
  EXPECT_EQ(environment->datasets.size(), 2U);
  EXPECT_THAT(messages::sentences(environment->messages), Not(Contains(HasSubstr("zones"))));
}

TEST_F(EnvironmentLoaderTest, ObeysNamedZonesAndTellsOfThoseLeftOut) {
  for (const char* const id : {"zones-1", "zones-2"}) {
    add(id, DatasetKind::zones, bay);
    ZoneRepository{db_}.insert({id}, {zone_of(id, bay)});
  }
  query_.zones = {DatasetChoice::How::named, {{"zones-1"}}};
  const auto one = load_environment(db_, query_);
  query_.zones = {DatasetChoice::How::none, {}};
  const auto none = load_environment(db_, query_);
  query_.zones = {DatasetChoice::How::named, {{"zones-9"}}};
  const auto unknown = load_environment(db_, query_);

  ASSERT_TRUE(one && none);
  ASSERT_EQ(one->zones.size(), 1U);
  EXPECT_EQ(one->zones[0].name, "zones-1");
  EXPECT_THAT(messages::sentences(one->messages), Contains(HasSubstr("zones-2")));
  EXPECT_TRUE(none->zones.empty());
  EXPECT_THAT(messages::sentences(none->messages), Contains(HasSubstr("zones-1")));
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().front().field, "/zones");
}

TEST_F(EnvironmentLoaderTest, TakesEachTimeFromTheNewestRunThatCoversIt) {
  add_currents("run-monday", sample_time, 25, levels_);
  add_currents("run-tuesday", sample_time + 12.0 * hour, 25, levels_);
  query_.depart = sample_time + 6.0 * hour;

  const ocean::Environment environment = load();

  const geo::LonLat place{-52.0, 69.0};
  const auto east = [&](double hours) {
    return environment.currents->at(place, core::Metres{0.0}, sample_time + hours * hour)->east.value;
  };
  EXPECT_NEAR(east(11.0), 11.0, 1e-6) << "of Monday's run, which alone speaks of it";
  EXPECT_NEAR(east(12.0), 0.0, 1e-6) << "the first step of Tuesday's";
  EXPECT_NEAR(east(36.0), 24.0, 1e-6);
  EXPECT_THAT(cited(environment), ElementsAre("run-monday", "run-tuesday"));
  EXPECT_EQ(environment.datasets[0].until, sample_time + 11.0 * hour);
  EXPECT_EQ(environment.datasets[1].from, sample_time + 12.0 * hour);
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(HasSubstr("come from several forecast runs")));
}

/// The ids of datasets come from their bytes and say nothing of their order.
TEST_F(EnvironmentLoaderTest, GoesByWhenTheDataBeginWhereFilesWithoutARunWereIngestedTogether) {
  for (const auto& [yesterday, today] :
       {std::pair{"a-yesterday", "b-today"}, std::pair{"d-yesterday", "c-today"}}) {
    add_currents(yesterday, sample_time - day, 49, levels_);
    add_currents(today, sample_time, 25, levels_);
    sql::Statement at_once{db_, "UPDATE dataset SET ingested_s = ?1"};
    at_once.bind_all(sample_time);
    at_once.run();

    const ocean::Environment environment = load();

    const auto current = environment.currents->at({-52.0, 69.0}, core::Metres{0.0}, sample_time + hour);
    EXPECT_NEAR(current->east.value, 1.0, 1e-6) << "the second step of today's, not yesterday's 26th";
    for (const char* const id : {yesterday, today}) DatasetRepository{db_}.remove({id});
  }
}

TEST_F(EnvironmentLoaderTest, GoesByWhenARunBeganAndNotByWhenItArrived) {
  add_currents("later", sample_time, 5, levels_);
  add_currents("earlier", sample_time, 5, levels_);
  sql::Statement dated{db_, "UPDATE dataset SET run_s = ?2 WHERE id = ?1"};
  for (const auto& [id, run] : {std::pair{"later", sample_time}, std::pair{"earlier", sample_time - day}}) {
    dated.bind_all(std::string{id}, run);
    dated.run();
  }

  const ocean::Environment environment = load();

  EXPECT_THAT(cited(environment), Contains("later"));
  EXPECT_EQ(environment.datasets.front().run, sample_time);
}

TEST_F(EnvironmentLoaderTest, NeverBridgesAGapBetweenTwoRuns) {
  add_currents("before", sample_time, 5, levels_);
  add_currents("after", sample_time + 9.0 * hour, 5, levels_);

  const ocean::Environment environment = load();

  EXPECT_THAT(cited(environment), Contains("before"));
  EXPECT_THAT(cited(environment), Not(Contains("after")));
}

TEST_F(EnvironmentLoaderTest, NeverJoinsRunsOfDifferentGrids) {
  add_currents("here", sample_time, 5, levels_);
  add_currents("wider", sample_time + 3.0 * hour, 5, levels_, {-56.0, 67.0, -50.0, 70.0});

  EXPECT_THAT(cited(load()), AllOf(Contains("here"), Not(Contains("wider"))));
}

TEST_F(EnvironmentLoaderTest, GivesTheVeryCurrentsThatWereKept) {
  add_currents("currents-1", sample_time, 5, ocean::Axis{{0.0, 50.0, 300.0}});
  CurrentGridCache kept{1 << 20};

  const auto anew = load_environment(db_, query_);
  const auto first = load_environment(db_, query_, {{}, &kept});
  const auto second = load_environment(db_, query_, {{}, &kept});

  ASSERT_TRUE(anew && first && second);
  EXPECT_EQ(second->currents, first->currents);
  EXPECT_EQ(second->currents->samples().u, anew->currents->samples().u);
  EXPECT_EQ(second->currents->samples().v, anew->currents->samples().v);
  EXPECT_EQ(second->currents->times_s().nodes(), anew->currents->times_s().nodes());
  EXPECT_EQ(second->messages, anew->messages);
}

TEST_F(EnvironmentLoaderTest, ReadsWhatIsStoredNowThoughOthersWereKept) {
  add_currents("currents-1", sample_time, 5, std::nullopt);
  CurrentGridCache kept{1 << 20};
  ASSERT_TRUE(load_environment(db_, query_, {{}, &kept}));

  add_currents("currents-2", sample_time - 3.0 * hour, 9, std::nullopt);
  const auto joined = load_environment(db_, query_, {{}, &kept});
  const auto anew = load_environment(db_, query_);

  ASSERT_TRUE(joined && anew);
  EXPECT_EQ(joined->currents->samples().u, anew->currents->samples().u);
  EXPECT_FLOAT_EQ(joined->currents->samples().u.front(), 3.0F);
}

TEST_F(EnvironmentLoaderTest, KeepsNothingOfAReadingThatWasStopped) {
  add_currents("currents-1", sample_time, 5, std::nullopt);
  CurrentGridCache kept{1 << 20};
  std::stop_source source;
  source.request_stop();

  (void)load_environment(db_, query_, {source.get_token(), &kept});
  const auto later = load_environment(db_, query_, {{}, &kept});

  ASSERT_TRUE(later);
  EXPECT_FLOAT_EQ(later->currents->samples().u.back(), 4.0F);
}

}  // namespace
}  // namespace floeplan::repository::environment_loader_test
