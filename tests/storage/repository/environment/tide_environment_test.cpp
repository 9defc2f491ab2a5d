#include "storage/repository/environment/tide_environment.hpp"

#include <gmock/gmock.h>

#include "engine/messages/sentence.hpp"
#include "engine/ocean/iceberg_drift.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/environment/environment_loader.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/fields/tide_repository.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::repository::tide_environment_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr geo::BoundingBox bay{-54.0, 68.0, -50.0, 70.0};

class TideEnvironment : public testing::Test {
 protected:
  TideEnvironment() {
    query_.area = {-53.0, 68.5, -51.0, 69.5};
    query_.depart = sample_time + hour;
  }

  static ocean::HorizontalGrid grid(double step_deg) {
    const auto nodes = [&](double from, double to) {
      std::vector<double> result;
      for (int i = 0; from + step_deg * i <= to; ++i) result.push_back(from + step_deg * i);
      return ocean::Axis{result};
    };
    return {geo::GeographicFrame{}, nodes(-54.0, -50.0), nodes(68.0, 70.0)};
  }

  void add(const std::string& id, DatasetKind kind, const std::string& name) {
    Dataset dataset = sample_dataset(id, kind, bay);
    dataset.name = name;
    if (kind == DatasetKind::currents) {
      dataset.time_start = sample_time;
      dataset.time_end = sample_time + 2.0 * day;
    }
    DatasetRepository{db_}.insert(dataset);
  }

  /// A current of 0.1 m/s towards east for two days, by the hour.
  void add_currents(const std::string& name) {
    add("currents-a", DatasetKind::currents, name);
    std::vector<double> times;
    for (int i = 0; i <= 48; ++i) times.push_back(core::unix_seconds(sample_time + i * hour));
    const FieldShape shape{grid(0.5), {}, ocean::Axis{times}};
    FieldRepository fields{db_};
    fields.create({"currents-a"}, shape);
    for (std::size_t t = 0; t < times.size(); ++t) {
      fields.write_slice({"currents-a"}, "u_m_s", t, 0, std::vector(shape.grid.size(), 0.1F));
      fields.write_slice({"currents-a"}, "v_m_s", t, 0, std::vector(shape.grid.size(), 0.0F));
    }
  }

  /// A tide towards east and west everywhere alike.
  void add_tide(const std::string& id, const std::string& line, std::complex<float> east) {
    add(id, DatasetKind::tides, "tide of " + line);
    TideRepository tides{db_};
    const ocean::HorizontalGrid nodes = grid(1.0);
    tides.create({id}, nodes);
    const auto constituent = tide::find_constituent(line).value();
    tides.write({id}, constituent, ocean::TideQuantity::east, ocean::TideGrid::Field(nodes.size(), east));
    tides.write({id}, constituent, ocean::TideQuantity::north, ocean::TideGrid::Field(nodes.size()));
  }

  void ask(const std::vector<std::string>& ids, std::optional<TidesMode> mode) {
    query_.tides.choice.how = DatasetChoice::How::named;
    for (const std::string& id : ids) query_.tides.choice.ids.push_back({id});
    query_.tides.mode = mode;
  }

  double eastward(const ocean::Environment& environment, core::UtcTime time) {
    return environment.currents->at({-52.0, 69.0}, core::Metres{10.0}, time).value().east.value;
  }

  std::vector<std::string> faults() {
    std::vector<std::string> fields;
    const auto environment = load_environment(db_, query_);
    if (!environment)
      for (const core::Violation& violation : environment.error()) fields.push_back(violation.field);
    return fields;
  }

  static double predicted(const std::string& line, std::complex<double> value, core::UtcTime time) {
    return tide::predict(std::vector{tide::HarmonicConstant{tide::find_constituent(line).value(), value}},
                         time);
  }

  sql::Connection db_ = support::empty_store();
  EnvironmentQuery query_;
};

TEST_F(TideEnvironment, AddsTheTideToTheCurrentsAndWarnsThatTheyMayHoldItAlready) {
  add_currents("bay model");
  add_tide("tides-m2", "M2", {0.3F, -0.2F});
  ask({"tides-m2"}, TidesMode::add);

  const auto environment = load_environment(db_, query_).value();

  for (const double hours : {1.0, 5.3, 30.0}) {
    const core::UtcTime time = sample_time + hours * hour;
    EXPECT_NEAR(eastward(environment, time), 0.1 + predicted("M2", {0.3, -0.2}, time), 0.006);
  }
  EXPECT_FALSE(environment.steady_currents);
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(HasSubstr("If those currents already include the tide")));
  EXPECT_EQ(environment.datasets.front().id, "currents-a");
  EXPECT_EQ(environment.datasets[1].id, "tides-m2");
}

TEST_F(TideEnvironment, BelievesANameThatSaysDetided) {
  add_currents("bay model, detided");
  add_tide("tides-m2", "M2", {0.3F, -0.2F});
  ask({"tides-m2"}, TidesMode::add);

  const auto environment = load_environment(db_, query_).value();

  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(HasSubstr("are added to the currents bay model, detided")));
  EXPECT_THAT(messages::sentences(environment.messages), testing::Not(Contains(HasSubstr("counts twice"))));
}

TEST_F(TideEnvironment, AloneGoesOnForThirtyDaysAndLeavesTheCurrentsOut) {
  add_currents("bay model");
  add_tide("tides-m2", "M2", {0.3F, -0.2F});
  add_tide("tides-k1", "K1", {0.1F, 0.0F});
  ask({"tides-m2", "tides-k1"}, TidesMode::only);

  const auto environment = load_environment(db_, query_).value();

  const core::UtcTime time = sample_time + 20.0 * day;
  EXPECT_NEAR(eastward(environment, time),
              predicted("M2", {0.3, -0.2}, time) + predicted("K1", {0.1, 0.0}, time), 0.006);
  EXPECT_THAT(messages::sentences(environment.messages),
              Contains(HasSubstr("alone, the same at every depth")));
}

/// Law: a berg that is seen outside the area drifts with the same tide as one inside.
TEST_F(TideEnvironment, CarriesIcebergsFromOutsideTheArea) {
  add_currents("bay model, detided");
  add_tide("tides-m2", "M2", {0.3F, -0.2F});
  add("bergs", DatasetKind::icebergs, "bergs");
  IcebergRepository{db_}.insert({"bergs"}, {sample_berg("a", {-52.6, 69.0})});
  for (const TidesMode mode : {TidesMode::add, TidesMode::only}) {
    query_.tides.choice.ids.clear();
    ask({"tides-m2"}, mode);
    const auto carried = [&](const geo::BoundingBox& area) {
      query_.area = area;
      const ocean::Environment environment = load_environment(db_, query_).value();
      return ocean::forecast_drift(environment.icebergs.at(0), environment, sample_time + 40.0 * hour)
          .back()
          .place;
    };

    const geo::LonLat expected = carried({-53.0, 68.5, -51.0, 69.5});
    const geo::LonLat place = carried({-51.4, 68.9, -51.2, 69.1});

    EXPECT_NEAR(place.lon_deg, expected.lon_deg, 1e-4) << "steps of the tide may differ";
    EXPECT_NEAR(place.lat_deg, expected.lat_deg, 1e-4);
    EXPECT_GT(std::abs(place.lon_deg + 52.6), 1e-3);
  }
}

TEST_F(TideEnvironment, AddsTheTideToSteadyCurrentsAndSoMakesThemChange) {
  add_currents("mean, geostrophic");
  add_tide("tides-m2", "M2", {0.3F, -0.2F});
  ask({"tides-m2"}, TidesMode::add);
  query_.steady = true;

  const auto environment = load_environment(db_, query_).value();

  const core::UtcTime time = sample_time + 10.0 * day;
  EXPECT_NEAR(eastward(environment, time), 0.1 + predicted("M2", {0.3, -0.2}, time), 0.006);
}

TEST_F(TideEnvironment, AsksForTheModeAndForTides) {
  add_tide("tides-m2", "M2", {0.3F, -0.2F});
  query_.tides.mode = TidesMode::only;
  EXPECT_THAT(faults(), ElementsAre("/tides_mode"));

  ask({"tides-m2"}, std::nullopt);
  EXPECT_THAT(faults(), ElementsAre("/tides_mode"));
}

TEST_F(TideEnvironment, RefusesWhatHasNoTidalCurrents) {
  add_currents("bay model");
  ask({"currents-a", "nothing"}, TidesMode::add);
  EXPECT_THAT(faults(), ElementsAre("/tides", "/tides"));
}

TEST_F(TideEnvironment, RefusesToAddTidesToNoCurrents) {
  add_tide("tides-m2", "M2", {0.3F, -0.2F});
  ask({"tides-m2"}, TidesMode::add);
  EXPECT_THAT(faults(), ElementsAre("/tides"));
}

TEST(TideRepositoryTest, KeepsStationsInTheirOrder) {
  sql::Connection db = support::empty_store();
  DatasetRepository{db}.insert(sample_dataset("tides-s", DatasetKind::tides));
  const std::vector<TideStation> stations{{"b",
                                           {1.0, 2.0},
                                           ocean::TideQuantity::elevation,
                                           {{tide::find_constituent("M2").value(), {0.5, -0.25}}}},
                                          {"a",
                                           {3.0, 4.0},
                                           ocean::TideQuantity::north,
                                           {{tide::find_constituent("K1").value(), {1.0, 0.0}},
                                            {tide::find_constituent("2MS6").value(), {0.0, 2.0}}}}};

  TideRepository{db}.insert({"tides-s"}, stations);
  const auto stored = TideRepository{db}.stations({"tides-s"});

  ASSERT_EQ(stored.size(), 2U);
  EXPECT_EQ(stored[1].name, "a");
  EXPECT_EQ(stored[1].quantity, ocean::TideQuantity::north);
  ASSERT_EQ(stored[1].constants.size(), 2U);
  EXPECT_EQ(stored[1].constants[1].constituent, tide::find_constituent("2MS6").value());
  EXPECT_EQ(stored[1].constants[1].value, (std::complex<double>{0.0, 2.0}));
  DatasetRepository{db}.remove({"tides-s"});
  EXPECT_TRUE(TideRepository{db}.stations({"tides-s"}).empty());
}

}  // namespace
}  // namespace floeplan::repository::tide_environment_test
