#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <map>

#include "engine/tide/ellipse.hpp"
#include "engine/tide/minor_constituents.hpp"
#include "engine/tide/prediction.hpp"
#include "tests/engine/tide/published.hpp"

namespace floeplan::tide::published_predictions_test {
namespace {

using test::largest;
using test::published;
using test::rms;
using test::rows_of;

HarmonicConstant constant(const std::string& name, double amplitude, double phase_deg) {
  return {find_constituent(name).value(), harmonic_value(amplitude, phase_deg)};
}

/// Constants of M2, S2, K1 and O1 that OTPS drew from TPXO9, by latitude, and its own predictions there.
TEST(PublishedPredictions, OfOtpsAreMetWithinTwoMillimetres) {
  const auto constants_file = published("otps_tpxo9v2a_extract_HC_sample_out.txt");
  const auto predictions_file = published("otps_tpxo9v2a_predict_tide_sample_out.txt");
  if (!constants_file || !predictions_file) GTEST_SKIP() << "the published samples are not on this machine";
  std::map<std::string, std::vector<HarmonicConstant>> places;
  for (const auto& row : rows_of(*constants_file, " ")) {
    if (row.size() != 10 || row[0] == "Lat") continue;
    const std::array names{"M2", "S2", "K1", "O1"};
    for (std::size_t i = 0; i < 4; ++i)
      places[row[0]].push_back(constant(names[i], std::stod(row[2 + 2 * i]), std::stod(row[3 + 2 * i])));
  }

  std::vector<double> residuals;
  for (const auto& row : rows_of(*predictions_file, " ")) {
    if (row.size() != 6 || row[2].find_first_not_of("0123456789.") != std::string::npos) continue;
    const auto time = test::utc(std::stoi(row[2].substr(6)), static_cast<unsigned>(std::stoi(row[2])),
                                static_cast<unsigned>(std::stoi(row[2].substr(3))), std::stoi(row[3]),
                                std::stoi(row[3].substr(3)), std::stoi(row[3].substr(6)));
    residuals.push_back(predict(places.at(row[0]), time) - std::stod(row[4]));
  }

  ASSERT_EQ(residuals.size(), 29U);
  testing::Test::RecordProperty("largest_mm", std::to_string(1000.0 * largest(residuals)));
  EXPECT_LT(largest(residuals), 0.002);
}

std::vector<HarmonicConstant> honolulu(const std::filesystem::path& file) {
  std::vector<HarmonicConstant> constants;
  for (const auto& row : rows_of(file, ",")) {
    if (row.size() != 4 || row[0] == "name" || row[0].starts_with('"')) continue;
    constants.push_back(constant(row[0], 0.001 * std::stod(row[2]), std::stod(row[3])));
  }
  return constants;
}

/// UTide adds the year's mean and its trend from the middle of the year on, and knows nodal corrections for a latitude;
/// the constants are for 59 lines.
void expect_utide(const std::string& month, double bound_m) {
  const auto constants_file = published("utide_HNL2010_coef_matlab.csv");
  const auto predictions_file = published("utide_HNL2010_prediction_a_" + month + ".csv");
  if (!constants_file || !predictions_file) GTEST_SKIP() << "the published samples are not on this machine";
  const std::vector<HarmonicConstant> constants = honolulu(*constants_file);
  ASSERT_EQ(constants.size(), 59U);
  const core::UtcTime reference = test::utc(2010, 7, 2, 11, 30);

  std::vector<double> residuals;
  for (const auto& row : rows_of(*predictions_file, ",TZ")) {
    if (row.size() != 3) continue;
    const auto time = test::utc(std::stoi(row[0]), static_cast<unsigned>(std::stoi(row[0].substr(5))),
                                static_cast<unsigned>(std::stoi(row[0].substr(8))), std::stoi(row[1]));
    const double mean_and_trend_mm =
        1417.3429499310 + 0.610325868321 * ((time - reference).count() / 86'400.0);
    residuals.push_back(predict(constants, time) - 0.001 * (std::stod(row[2]) - mean_and_trend_mm));
  }

  ASSERT_EQ(residuals.size(), 240U);
  testing::Test::RecordProperty("rms_mm", std::to_string(1000.0 * rms(residuals)));
  EXPECT_LT(rms(residuals), bound_m);
}

TEST(PublishedPredictions, OfUtideInsideTheYearAreMetWithinFiveMillimetres) {
  expect_utide("2010-03", 0.005);
}

TEST(PublishedPredictions, OfUtideSixYearsLaterAreMetWithinFiveMillimetres) {
  expect_utide("2016-07", 0.005);
}

/// Ellipses that TMD drew from CATS2008 at six stations, and its own currents at each midnight of the year 2000.
struct Cats {
  std::vector<std::string> lines{"M2", "S2", "N2", "K2", "K1", "O1", "P1", "Q1", "MF", "MM"};
  std::vector<std::vector<std::string>> ellipses;
  std::vector<std::vector<std::string>> east;
  std::vector<std::vector<std::string>> north;

  /// Constants of one component at a station in cm/s, with the minor lines if they are wanted.
  [[nodiscard]] std::vector<HarmonicConstant> constants(std::size_t station, bool northward,
                                                        bool with_minors) const {
    std::vector<HarmonicConstant> result;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto value = [&](std::size_t axis) {
        return std::stod(ellipses[1 + 10 * axis + i][1 + station]);
      };
      const auto both = constants_of({value(0), value(1), value(2), value(3)});
      result.push_back({find_constituent(lines[i]).value(), northward ? both.north : both.east});
    }
    return with_minors ? tide::with_minors(std::move(result)) : result;
  }
};

std::optional<Cats> cats() {
  const auto ellipses = published("tmd25_cats2008_ellipse_relabelled_a.csv");
  const auto east = published("tmd25_cats2008_U_cms_a.csv");
  const auto north = published("tmd25_cats2008_V_cms_a.csv");
  if (!ellipses || !east || !north) return std::nullopt;
  Cats result;
  result.ellipses = rows_of(*ellipses, ",");
  result.east = rows_of(*east, ",");
  result.north = rows_of(*north, ",");
  return result;
}

double largest_error_of(const Cats& sample, bool with_minors) {
  double worst = 0.0;
  for (std::size_t station = 0; station < 6; ++station) {
    for (const bool northward : {false, true}) {
      const auto constants = sample.constants(station, northward, with_minors);
      std::vector<double> residuals;
      for (std::size_t day = 0; day < 366; ++day) {
        const auto time = test::utc(2000, 1, 1) + core::Seconds{86'400.0 * static_cast<double>(day)};
        const auto& row = (northward ? sample.north : sample.east)[1 + day];
        residuals.push_back(predict(constants, time) - std::stod(row[1 + station]));
      }
      worst = std::max(worst, largest(residuals));
    }
  }
  return worst;
}

TEST(PublishedPredictions, OfCurrentsByTmdAreMetWithinOneCentimetreASecondAtEveryStationAndDay) {
  const auto sample = cats();
  if (!sample) GTEST_SKIP() << "the published samples are not on this machine";

  const double worst_cm_s = largest_error_of(*sample, true);

  testing::Test::RecordProperty("largest_cm_s", std::to_string(worst_cm_s));
  EXPECT_LT(worst_cm_s, 1.0);
}

TEST(PublishedPredictions, OfCurrentsByTmdAreMissedByCentimetresASecondWithoutTheMinorLines) {
  const auto sample = cats();
  if (!sample) GTEST_SKIP() << "the published samples are not on this machine";

  EXPECT_GT(largest_error_of(*sample, false), 5.0);
}

TEST(PublishedConstants, OfNoaaStateTheSpeedsOfTheCatalogue) {
  for (const char* name :
       {"noaa_anchorage-knik-arm.json", "noaa_honolulu.json", "noaa_san-francisco-golden-gate.json"}) {
    const auto file = published(name);
    if (!file) GTEST_SKIP() << "the published samples are not on this machine";
    std::string constituent;
    int found = 0;
    for (const auto& row : rows_of(*file, " \",:")) {
      if (row.size() == 2 && row[0] == "name") constituent = row[1];
      if (row.size() != 2 || row[0] != "speed") continue;
      const auto line = find_constituent(constituent);
      ASSERT_TRUE(line) << constituent;
      const double deg_h = core::radians_to_degrees(angular_speed(*line)) * 3600.0;
      EXPECT_NEAR(deg_h, std::stod(row[1]), 2e-5) << constituent;
      ++found;
    }
    EXPECT_GE(found, 37) << name;
  }
}

}  // namespace
}  // namespace floeplan::tide::published_predictions_test
