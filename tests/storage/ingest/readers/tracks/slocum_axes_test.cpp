#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <ostream>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/glider_track_repository.hpp"
#include "storage/sql/statement.hpp"
#include "tests/engine/simulation/logged.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::slocum_axes_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using Row = std::vector<std::optional<double>>;

struct Sensor {
  const char* name;
  std::size_t bytes;
  const char* unit;
};

/// The log of a vehicle that dives once and tells the current of that dive in its own axes.
struct DiveLog {
  geo::LonLat from;
  geo::LonLat to;
  double x_m_s{0.10};
  double y_m_s{0.20};
  geo::VelocityLmc before{{0.4}, {-0.1}};  // the current that is known before
  std::optional<double> variation_rad{};   // m_gps_mag_var
  std::optional<double> matrix_rad{};      // what x_utm_to_lmc_00 and _01 turn by
  std::optional<int> zone{};               // x_lmc_utm_zone_digit
  double start_s{1.795e9};
  bool zero_first{false};  // a variation of exactly 0 until the receiver has told one

  [[nodiscard]] std::vector<Sensor> sensors() const {
    std::vector<Sensor> all{{"m_present_time", 8, "timestamp"},
                            {"m_gps_lat", 8, "lat"},
                            {"m_gps_lon", 8, "lon"},
                            {"m_depth", 4, "m"},
                            {"x_dr_state", 1, "enum"},
                            {"m_initial_water_vx", 4, "m/s"},
                            {"m_initial_water_vy", 4, "m/s"}};
    if (variation_rad) all.push_back({"m_gps_mag_var", 4, "rad"});
    if (matrix_rad) all.push_back({"x_utm_to_lmc_00", 4, "nodim"});
    if (matrix_rad) all.push_back({"x_utm_to_lmc_01", 4, "nodim"});
    if (zone) all.push_back({"x_lmc_utm_zone_digit", 1, "byte"});
    return all;
  }

  [[nodiscard]] std::vector<Row> rows() const {
    const double no_fix = 69'696'969.0;
    const auto [old_x, old_y] = std::pair{before.x.value, before.y.value};
    const auto row = [&](double after_s, std::optional<geo::LonLat> fix, double depth_m, int state, double x,
                         double y, bool first) {
      Row values{start_s + after_s,
                 fix ? support::packed(fix->lat_deg) : no_fix,
                 fix ? support::packed(fix->lon_deg) : no_fix,
                 depth_m,
                 state,
                 x,
                 y};
      if (variation_rad) values.push_back(first && zero_first ? 0.0 : *variation_rad);
      if (matrix_rad) values.push_back(first ? std::optional{std::cos(*matrix_rad)} : std::nullopt);
      if (matrix_rad) values.push_back(first ? std::optional{std::sin(*matrix_rad)} : std::nullopt);
      if (zone) values.push_back(first ? std::optional{static_cast<double>(*zone)} : std::nullopt);
      return values;
    };
    return {row(0.0, zero_first ? std::nullopt : std::optional{from}, 0.1, 4, old_x, old_y, true),
            row(60.0, from, 0.1, 4, old_x, old_y, false),
            row(1'000.0, std::nullopt, 40.0, 1, old_x, old_y, false),
            row(4'600.0, std::nullopt, 0.2, 2, old_x, old_y, false),
            row(4'700.0, to, 0.1, 3, x_m_s, y_m_s, false)};
  }

  [[nodiscard]] std::string text() const {
    std::string names;
    std::string units;
    for (const Sensor& sensor : sensors()) {
      names += (names.empty() ? "" : ",") + std::string{sensor.name};
      units += (units.empty() ? "" : ",") + std::string{sensor.unit};
    }
    std::string text = names + "\n" + units + "\n";
    for (const Row& row : rows()) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        char field[40] = "";
        if (row[i]) std::snprintf(field, sizeof field, "%.12g", *row[i]);
        text += (i == 0 ? "" : ",") + std::string{field};
      }
      text += "\n";
    }
    return text;
  }

  [[nodiscard]] std::string binary() const {
    const auto number = [](auto bits) {
      std::string bytes;
      for (std::size_t i = 0; i < sizeof bits; ++i) bytes += static_cast<char>((bits >> (8 * i)) & 0xff);
      return bytes;
    };
    const auto value = [&](double each, std::size_t bytes) {
      if (bytes == 1) return std::string(1, static_cast<char>(each));
      if (bytes == 4) return number(std::bit_cast<std::uint32_t>(static_cast<float>(each)));
      return number(std::bit_cast<std::uint64_t>(each));
    };
    const auto all = sensors();
    const std::size_t state_bytes = (all.size() + 3) / 4;
    const std::string count = std::to_string(all.size());
    std::string log =
        "dbd_label:    DBD(dinkum_binary_data)file\nnum_ascii_tags:    8\nfull_filename:    "
        "second-2026-320-1-7\nfilename_extension:    dbd\ntotal_num_sensors:    " +
        count + "\nsensors_per_cycle:    " + count +
        "\nstate_bytes_per_cycle:    " + std::to_string(state_bytes) + "\nsensor_list_factored:    0\n";
    for (std::size_t i = 0; i < all.size(); ++i)
      log += "s: T " + std::to_string(i) + " " + std::to_string(i) + " " + std::to_string(all[i].bytes) +
             " " + all[i].name + " " + all[i].unit + "\n";
    log += "sa" + number(std::uint16_t{0x1234}) + value(123.456, 4) + value(123456789.12345, 8);
    for (const Row& row : rows()) {
      std::string states(state_bytes, '\0');
      std::string values;
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (!row[i]) continue;
        states[i / 4] = static_cast<char>(states[i / 4] | (2 << (6 - 2 * (i % 4))));
        values += value(*row[i], all[i].bytes);
      }
      log += "d" + states + values;
    }
    return log + "X";
  }
};

class SlocumAxes : public StoreFixture {
 protected:
  ocean::GliderTrack track_of(const std::string& name, const std::string& bytes) {
    db_ = repository::open_store_in_memory();
    return track_of(ingest(write_file(name, bytes)));
  }

  ocean::GliderTrack track_of(const IngestReport& report) {
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    told_ = words(report);
    return stored();
  }

  ocean::GliderTrack stored() {
    const repository::GliderTrackRepository tracks{db_};
    const auto page = tracks.list({}, 0, 2);
    EXPECT_EQ(page.tracks.size(), 1U);
    return page.tracks.empty() ? ocean::GliderTrack{} : tracks.find(page.tracks[0].row)->track;
  }

  std::string told_;
};

struct Turned {
  const char* what;
  DiveLog log;
  int zone;
  ocean::VariationSource source;
  double east_m_s;
  double north_m_s;
};

void PrintTo(const Turned& turned, std::ostream* out) { *out << turned.what; }

DiveLog dive_at(double lat_deg, double lon_deg) {
  return {.from = {geo::wrap_longitude(lon_deg - 0.02), lat_deg - 0.01},
          .to = {geo::wrap_longitude(lon_deg + 0.02), lat_deg + 0.01}};
}

DiveLog with_variation(DiveLog log, double variation_rad, std::optional<int> zone = {}) {
  log.variation_rad = variation_rad;
  log.zone = zone;
  return log;
}

DiveLog with_matrix(DiveLog log, double matrix_rad, std::optional<int> zone = {}) {
  log.matrix_rad = matrix_rad;
  log.variation_rad = matrix_rad + 0.1;
  log.zone = zone;
  return log;
}

DiveLog of_current(DiveLog log, double x_m_s, double y_m_s) {
  log.x_m_s = x_m_s;
  log.y_m_s = y_m_s;
  return log;
}

/// A vehicle that set out in one zone and dives beyond its edge.
DiveLog across_the_antimeridian(double lat_deg, double variation_rad) {
  return {.from = {179.99, lat_deg}, .to = {-179.79, lat_deg}, .variation_rad = variation_rad};
}

class CurrentOfADive : public SlocumAxes, public testing::WithParamInterface<Turned> {};

TEST_P(CurrentOfADive, IsTurnedToTrueEastAndNorth) {
  const Turned& expected = GetParam();

  for (const bool binary : {false, true}) {
    const auto track =
        binary ? track_of("log.dbd", expected.log.binary()) : track_of("log.csv", expected.log.text());

    ASSERT_EQ(track.currents.size(), 1U) << told_;
    EXPECT_NEAR(track.currents[0].current.east.value, expected.east_m_s, 1e-4) << told_;
    EXPECT_NEAR(track.currents[0].current.north.value, expected.north_m_s, 1e-4) << told_;
    EXPECT_EQ(track.frame, ocean::CurrentFrame::turned);
    ASSERT_TRUE(track.turned_from);
    EXPECT_EQ(track.turned_from->axes.utm_zone(), expected.zone);
    EXPECT_EQ(track.turned_from->source, expected.source);
    EXPECT_THAT(told_, HasSubstr("UTM zone " + std::to_string(expected.zone)));
  }
}

// Worked out with the meridian convergence of proj 9 and the declination of pygeomag 1.1.0.
INSTANTIATE_TEST_SUITE_P(
    All, CurrentOfADive,
    testing::Values(Turned{"Disko Bay, a current along y",
                           of_current(with_variation(dive_at(69.2, -52.5), 0.4750), 0.0, 0.20), 22,
                           ocean::VariationSource::log_variation, -0.0958, 0.1756},
                    Turned{"Disko Bay", with_variation(dive_at(69.2, -52.5), 0.4750), 22,
                           ocean::VariationSource::log_variation, -0.008009, 0.223463},
                    Turned{"Disko Bay, by the matrix", with_matrix(dive_at(69.2, -52.5), 0.4750), 22,
                           ocean::VariationSource::log_axes, -0.008009, 0.223463},
                    Turned{"Disko Bay, without a word", dive_at(69.2, -52.5), 22,
                           ocean::VariationSource::magnetic_model, -0.008067, 0.223461},
                    Turned{"Svalbard, at the edge of its zone", with_variation(dive_at(78.0, 5.9), -0.09), 31,
                           ocean::VariationSource::log_variation, 0.126840, 0.184151},
                    Turned{"Svalbard, from a zone that the log names",
                           with_matrix(dive_at(78.0, 5.9), -0.09, 32), 32, ocean::VariationSource::log_axes,
                           0.107345, 0.196156},
                    Turned{"Svalbard, without a word", dive_at(78.0, 5.9), 31,
                           ocean::VariationSource::magnetic_model, 0.128856, 0.182746},
                    Turned{"Wrangel Island", with_variation(dive_at(71.0, 179.9), 0.003), 60,
                           ocean::VariationSource::log_variation, 0.108869, 0.195314},
                    Turned{"Wrangel Island, across the antimeridian", across_the_antimeridian(71.0, 0.003),
                           60, ocean::VariationSource::log_variation, 0.109513, 0.194954},
                    Turned{"Ross Sea", with_variation(dive_at(-65.0, 179.9), -1.0856), 60,
                           ocean::VariationSource::log_variation, 0.223099, 0.015066},
                    Turned{"Ross Sea, across the antimeridian", across_the_antimeridian(-65.0, -1.0856), 60,
                           ocean::VariationSource::log_variation, 0.223050, 0.015772},
                    Turned{"Ross Sea, without a word", dive_at(-65.0, 179.9), 60,
                           ocean::VariationSource::magnetic_model, 0.223499, 0.006937}));

/// Redfearn's series of the meridian convergence, to the third power of the longitude from the central meridian.
double convergence_rad(geo::LonLat place, int zone) {
  const double from_meridian = core::degrees_to_radians(
      geo::longitude_difference(-183.0 + 6.0 * zone, geo::wrap_longitude(place.lon_deg)));
  const double lat = core::degrees_to_radians(place.lat_deg);
  const double cosine = std::cos(lat);
  const double eta2 = 0.00673949674 * cosine * cosine;
  return from_meridian * std::sin(lat) *
         (1.0 + std::pow(from_meridian * cosine, 2) / 3.0 * (1.0 + 3.0 * eta2 + 2.0 * eta2 * eta2));
}

TEST_F(SlocumAxes, GiveTheCurrentBackWhereverAndHoweverItsLogTellsThem) {
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    DiveLog log = dive_at(support::uniform(rng, -75.0, 80.0), support::uniform(rng, -180.0, 180.0));
    const geo::LonLat middle{geo::wrap_longitude(log.from.lon_deg + 0.02), log.from.lat_deg + 0.01};
    const int own_zone = 1 + static_cast<int>((log.from.lon_deg + 180.0) / 6.0);
    const int zone = support::uniform_int(rng, 0, 1) == 0 ? own_zone : 1 + own_zone % 60;
    if (zone != own_zone || support::uniform_int(rng, 0, 1) == 0) log.zone = zone;
    const double variation_rad = support::uniform(rng, -1.5, 1.5);
    const bool matrix = support::uniform_int(rng, 0, 1) == 0;
    (matrix ? log.matrix_rad : log.variation_rad) = variation_rad;
    log.zero_first = support::uniform_int(rng, 0, 1) == 0;
    const double east_m_s = support::uniform(rng, -1.0, 1.0);
    const double north_m_s = support::uniform(rng, -1.0, 1.0);
    const double y_bears_rad = convergence_rad(middle, zone) - variation_rad;
    log.x_m_s = east_m_s * std::cos(y_bears_rad) - north_m_s * std::sin(y_bears_rad);
    log.y_m_s = east_m_s * std::sin(y_bears_rad) + north_m_s * std::cos(y_bears_rad);

    const bool binary = support::uniform_int(rng, 0, 1) == 0;
    const auto track = binary ? track_of("log.dbd", log.binary()) : track_of("log.csv", log.text());

    ASSERT_EQ(track.currents.size(), 1U) << told_;
    EXPECT_NEAR(track.currents[0].current.east.value, east_m_s, 1e-5) << told_;
    EXPECT_NEAR(track.currents[0].current.north.value, north_m_s, 1e-5) << told_;
  });
}

TEST_F(SlocumAxes, AreNotThoseOfAReceiverThatHasToldNothingYet) {
  DiveLog log = with_variation(dive_at(69.2, -52.5), 0.4750);
  log.zero_first = true;

  const auto track = track_of("log.csv", log.text());

  ASSERT_EQ(track.currents.size(), 1U);
  EXPECT_NEAR(track.currents[0].current.east.value, -0.008009, 1e-4);
}

TEST_F(SlocumAxes, OfALogOfTwoMissionsChangeWithTheMatrix) {
  const DiveLog first = with_matrix(dive_at(69.2, -52.5), 0.4750, 22);
  DiveLog second = with_matrix(dive_at(78.0, 5.9), -0.09, 32);
  second.start_s = first.start_s + 30.0 * 86'400.0;
  second.before = {{first.x_m_s}, {first.y_m_s}};
  second = of_current(second, 0.20, 0.40);
  const std::string rows = second.text();

  const auto track = track_of("log.csv", first.text() + rows.substr(rows.find("nodim,byte\n") + 11));

  ASSERT_EQ(track.currents.size(), 2U) << told_;
  EXPECT_NEAR(track.currents[0].current.east.value, -0.008009, 1e-4);
  EXPECT_NEAR(track.currents[1].current.east.value, 2.0 * 0.107345, 1e-4);
  EXPECT_NEAR(track.currents[1].current.north.value, 2.0 * 0.196156, 1e-4);
  EXPECT_EQ(track.turned_from->axes.utm_zone(), 22);
}

TEST_F(SlocumAxes, ThatNothingTellsCostTheCurrentsAloneAndTheLogIsTold) {
  DiveLog log = dive_at(69.2, -52.5);
  log.start_s = 1.2e9;  // 2008, before the model

  const auto track = track_of("log.csv", log.text());

  EXPECT_EQ(track.points.size(), 5U);
  EXPECT_TRUE(track.currents.empty());
  EXPECT_THAT(told_, HasSubstr("vehicle's own axes, whose direction is not known"));
  EXPECT_THAT(told_, HasSubstr("m_gps_mag_var"));
}

TEST_F(SlocumAxes, AreDoubtedWhereTheVariationIsFarFromTheModelsOrTheZoneMayBeAnother) {
  (void)track_of("log.csv", with_variation(dive_at(69.2, -52.5), 0.4750).text());
  EXPECT_THAT(told_, Not(HasSubstr("doubtful")));
  EXPECT_THAT(told_, Not(HasSubstr("Norway and Svalbard")));
  (void)track_of("log.csv", with_variation(dive_at(69.2, -52.5), -0.4750).text());
  EXPECT_THAT(told_, HasSubstr("27.2 degrees east"));
  EXPECT_THAT(told_, HasSubstr("doubtful"));
  (void)track_of("log.csv", with_variation(dive_at(78.0, 10.0), -0.15).text());
  EXPECT_THAT(told_, HasSubstr("zone 32 was taken; if the vehicle uses zone 33"));
  EXPECT_THAT(told_, HasSubstr("5.9 degrees off"));
  (void)track_of("log.csv", with_variation(dive_at(78.0, 10.0), -0.15, 33).text());
  EXPECT_THAT(told_, Not(HasSubstr("Norway and Svalbard")));
}

/// Law: the axes of a later segment are those of its mission's start, in whatever zone it dives, and however the
/// segments are given.
TEST_F(SlocumAxes, OfALaterSegmentAreThoseOfItsMissionsStart) {
  support::for_each_seed(12, [&](std::mt19937_64& rng) {
    const double lat_deg = support::uniform(rng, 50.0, 75.0);
    const int zone = support::uniform_int(rng, 2, 28);
    const double edge_deg = -180.0 + 6.0 * zone;  // its eastern one
    const double variation_rad = support::uniform(rng, -0.5, 0.5);
    const double first_deg = edge_deg - support::uniform(rng, 0.1, 1.0);
    const DiveLog first = with_variation(dive_at(lat_deg, first_deg), variation_rad);
    const double later_deg = edge_deg + support::uniform(rng, 0.1, 1.0);
    DiveLog later = of_current(with_variation(dive_at(lat_deg, later_deg), variation_rad), 0.15, -0.25);
    later.start_s = first.start_s + 10.0 * 86'400.0;
    if (support::uniform_int(rng, 0, 1) == 0)  // else the current of a dive between, which is of neither
      later.before = {{first.x_m_s}, {first.y_m_s}};
    const auto begin = write_file("unit_409-2026-323-1-0.csv", first.text());
    const auto end = write_file("unit_409-2026-323-1-41.csv", later.text());
    const bool in_order = support::uniform_int(rng, 0, 1) == 0;

    db_ = repository::open_store_in_memory();
    const auto track =
        track_of(ingest_together(in_order ? std::vector{begin, end} : std::vector{end, begin}));

    ASSERT_EQ(track.glider, "unit_409");
    ASSERT_EQ(track.currents.size(), 2U) << told_;
    const auto expect_current = [&](const geo::VelocityEn& met, double lon_deg, const DiveLog& of) {
      const double y_bears_rad = convergence_rad({lon_deg, lat_deg}, zone) - variation_rad;
      EXPECT_NEAR(met.east.value, of.x_m_s * std::cos(y_bears_rad) + of.y_m_s * std::sin(y_bears_rad), 1e-5);
      EXPECT_NEAR(met.north.value, of.y_m_s * std::cos(y_bears_rad) - of.x_m_s * std::sin(y_bears_rad), 1e-5);
    };
    expect_current(track.currents[0].current, first_deg, first);
    expect_current(track.currents[1].current, later_deg, later);
    EXPECT_THAT(told_, Not(HasSubstr("begins with segment")));
  });
}

TEST_F(SlocumAxes, OfALaterSegmentAloneAreDoubtedNearTheEdgeOfAZone) {
  const DiveLog near = with_variation(dive_at(69.2, -53.9), 0.45);
  (void)track_of("unit_409-2026-323-1-41.csv", near.text());
  EXPECT_THAT(told_, HasSubstr("begins with segment 41 of its mission"));
  EXPECT_THAT(told_, HasSubstr("zone 22, of the first fix, was taken; zone 21 is"));
  EXPECT_THAT(told_, HasSubstr("the currents lie 5.6 degrees off"));
  (void)track_of("unit_409-2026-323-1-0.csv", near.text());
  EXPECT_THAT(told_, Not(HasSubstr("begins with segment")));
  (void)track_of("unit_409-2026-323-1-42.csv", with_variation(dive_at(69.2, -53.9), 0.45, 22).text());
  EXPECT_THAT(told_, Not(HasSubstr("begins with segment")));
  (void)track_of("unit_409-2026-323-1-43.csv", with_variation(dive_at(45.0, -51.0), 0.3).text());
  EXPECT_THAT(told_, Not(HasSubstr("begins with segment")));  // 236 km from either edge
}

TEST_F(SlocumAxes, ByAVariationThatIsImpossibleAreTheModelsAndSaySo) {
  (void)track_of("log.csv", with_variation(dive_at(69.2, -52.5), 27.2).text());
  EXPECT_THAT(told_, HasSubstr("m_gps_mag_var of 27.2 is impossible in radians"));
  EXPECT_THAT(told_, Not(HasSubstr("nor m_gps_mag_var")));
}

TEST_F(SlocumAxes, OfTracksStoredBeforeTheyWereKnownAreMendedByTheSameFile) {
  const std::string text = with_variation(dive_at(69.2, -52.5), 0.4750).text();
  const auto turned = track_of("log.csv", text);
  sql::execute(
      db_,
      "UPDATE dataset SET outdated = 1; UPDATE glider_track SET frame = 'vehicle', variation_source = "
      "NULL, variation_west_rad = NULL, utm_zone = NULL; UPDATE glider_current SET east_m_s = 0.1, "
      "north_m_s = 0.2");
  ASSERT_EQ(stored().frame, ocean::CurrentFrame::vehicle);

  const auto again = ingest(path("log.csv"));

  EXPECT_EQ(again.status, IngestStatus::stored) << words(again);
  EXPECT_EQ(stored(), turned);
  EXPECT_EQ(stored_datasets(), 1U);
  EXPECT_EQ(ingest(path("log.csv")).status, IngestStatus::unchanged);
}

}  // namespace
}  // namespace floeplan::ingest::slocum_axes_test
