#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include "engine/core/utc_text.hpp"
#include "tests/storage/ingest/support/choice_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::velocity_pair_test {
namespace {

using testing::HasSubstr;

/// A file of the public cases, whose field at 7.25 W, 52.25 N is 0.3125 towards east and -0.0875 towards north.
struct PublicCase {
  const char* file;
  std::optional<double> east;  // empty: refused
  const char* words;           // of the refusal or among the warnings
};

void PrintTo(const PublicCase& one, std::ostream* out) { *out << one.file; }

class PublicFile : public Choice, public testing::WithParamInterface<PublicCase> {};

TEST_P(PublicFile, IsStoredAsItsProducerMeansItOrRefused) {
  const auto file = sample_folder().parent_path() / "cases" / GetParam().file;
  if (sample_folder().empty() || !std::filesystem::exists(file))
    GTEST_SKIP() << "the cases are not on this machine";

  const auto report = outcome(file);

  EXPECT_THAT(words(report), HasSubstr(GetParam().words));
  if (!GetParam().east) {
    EXPECT_EQ(report.status, IngestStatus::refused);
    return;
  }
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto current =
      currents_of(report).at({-7.25, 52.25}, core::Metres{0.0}, *report.dataset->time_start).value();
  EXPECT_NEAR(current.east.value, *GetParam().east, 1e-6);
  EXPECT_NEAR(current.north.value, *GetParam().east - 0.4, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(
    WordsOfLongNames, PublicFile,
    testing::Values(
        PublicCase{"01-cmems-merged-total/total_and_tide.nc", 0.3825,
                   "include the tide and the drift by waves"},
        PublicCase{"01-cmems-merged-total/total_only.nc", 0.3825, "include the tide and the drift by waves"},
        PublicCase{"01-cmems-merged-total/tide_only.nc", {}, "\"utide\" and \"vtide\" hold the tide alone"},
        PublicCase{"01-cmems-merged-total/all.nc", 0.3125,
                   "\"utotal\" and \"vtotal\" (currents with the tide)"},
        PublicCase{"01-cmems-merged-total/uo_wave_in_long_name.nc", 0.3125, ""}));

INSTANTIATE_TEST_SUITE_P(
    Statistics, PublicFile,
    testing::Values(PublicCase{"02-statistics-as-currents/std_then_mean.nc", 0.3125, ""},
                    PublicCase{"02-statistics-as-currents/mean_then_std.nc", 0.3125, ""},
                    PublicCase{"02-statistics-as-currents/std_only.nc", {}, "hold a standard deviation"},
                    PublicCase{"02-statistics-as-currents/standard_error_modifier.nc",
                               {},
                               "\"uo\" and \"vo\" hold a standard error"},
                    PublicCase{"02-statistics-as-currents/time_maximum.nc", {}, "hold a maximum"},
                    PublicCase{"02-statistics-as-currents/two_systems.nc",
                               {},
                               "\"uo_glor\" and \"vo_glor\", or \"uo_oras\" and \"vo_oras\""}));

INSTANTIATE_TEST_SUITE_P(
    NamesAgainstStandardNames, PublicFile,
    testing::Values(PublicCase{"03-names-against-standard-names/u_says_northward.nc", 0.3125,
                               "as its standard name says"},
                    PublicCase{"03-names-against-standard-names/uo_says_northward.nc", 0.3125,
                               "as its standard name says"},
                    PublicCase{"03-names-against-standard-names/u_long_name_northward.nc", 0.3125,
                               "as its long name says"},
                    PublicCase{"03-names-against-standard-names/other_names.nc", 0.3125, ""}));

/// The two components of one kind of numbers, and where that kind stands among those that may be stored.
struct Kind {
  std::string first;
  std::string second;
  Texts texts;
  std::string behind_standard_name;
  int place;  // the least is stored; two of the same place are refused; 0: never stored
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"uo", "vo", {}, "", 1},
      {"utotal", "vtotal", {{"long_name", "Total velocity (Eulerian + Waves + Tide)"}}, "", 2},
      {"u_daily", "v_daily", {{"cell_methods", "time: mean"}}, "", 3},
      {"uo_b", "vo_b", {{"cell_methods", "time: point area: mean (interval: 1 km)"}}, "", 3},
      {"u_hourly_max", "v_hourly_max", {}, "", 0},
      {"uo_sd", "vo_sd", {{"cell_methods", "area: mean time: standard_deviation"}}, "", 0},
      {"u_a", "v_a", {{"cell_methods", "time:maximum"}}, "", 0},
      {"u_c", "v_c", {{"cell_methods", "time: lat: lon: range (comment: mean)"}}, "", 0},
      {"u_d", "v_d", {{"cell_methods", "time: sum"}}, "", 0},
      {"u_e", "v_e", {}, " standard_error", 0},
      {"u_f", "v_f", {}, " status_flag", 0},
      {"u_g", "v_g", {}, " number_of_observations", 0},
      {"u_h", "v_h", {}, " detection_minimum", 0},
      {"u_i", "v_i", {{"long_name", "Standard deviation of the velocity"}}, "", 0},
      {"utide", "vtide", {{"long_name", "tide-induced velocity (Tide current)"}}, "", 0},
      {"u_j", "v_j", {{"long_name", "velocity due to tides"}}, "", 0},
      {"u_k", "v_k", {}, "_due_to_ekman_drift", 0},
      {"u_l", "v_l", {}, "_at_sea_floor", 0},
      {"u_bottom", "v_bottom", {}, "", 0},
      {"u_m", "v_m", {{"long_name", "velocity anomaly"}}, "", 0},
  };
  return all;
}

TEST_F(Choice, IsTheSameInWhateverOrderTheFileHasItsVariablesAndNeverAStatistic) {
  support::for_each_seed(150, [&](std::mt19937_64& rng) {
    std::vector<std::size_t> chosen(kinds().size());
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = i;
    std::ranges::shuffle(chosen, rng);
    chosen.resize(static_cast<std::size_t>(support::uniform_int(rng, 1, 6)));
    std::vector<Field> fields;
    std::map<int, std::vector<double>> by_place;
    for (const std::size_t i : chosen) {
      const Kind& kind = kinds()[i];
      const double value = 0.1 + 0.01 * static_cast<double>(i);
      if (kind.place > 0) by_place[kind.place].push_back(value);
      for (Field& field : pair_of(kind.first, kind.second, value, kind.texts, kind.behind_standard_name))
        fields.push_back(std::move(field));
    }
    std::ranges::shuffle(fields, rng);

    const auto report = outcome(write(fields));
    const auto found = stored(report);

    if (by_place.empty() || by_place.begin()->second.size() > 1) {
      EXPECT_FALSE(found) << words(report);
      EXPECT_EQ(report.errors.size(), 1U) << words(report);
      return;
    }
    expect_pair(found, by_place.begin()->second.front(), report);
    for (const auto& [place, values] : by_place)
      if (place > by_place.begin()->first) {
        EXPECT_THAT(words(report), HasSubstr("were stored, but"));
      }
  });
}

/// The verdict on a name, a standard name and a long name together: as the name says, the reverse, or refused
/// because they contradict each other.
enum class Verdict { as_named, swapped, refused };
enum class Says { nothing, the_same, the_contrary };

struct Witness {
  Says standard_name;
  Says long_name;
  Verdict verdict;
};

constexpr std::array witnesses{
    Witness{Says::nothing, Says::nothing, Verdict::as_named},
    Witness{Says::nothing, Says::the_same, Verdict::as_named},
    Witness{Says::nothing, Says::the_contrary, Verdict::swapped},
    Witness{Says::the_same, Says::nothing, Verdict::as_named},
    Witness{Says::the_same, Says::the_same, Verdict::as_named},
    Witness{Says::the_same, Says::the_contrary, Verdict::as_named},
    Witness{Says::the_contrary, Says::nothing, Verdict::swapped},
    Witness{Says::the_contrary, Says::the_contrary, Verdict::swapped},
    Witness{Says::the_contrary, Says::the_same, Verdict::refused},
};

struct Names {
  std::string first;
  std::string second;
  std::string standard_first;
  std::string standard_second;
};

TEST_F(Choice, OfComponentsIsWhatTheyStateAndNeverSwappedInSilence) {
  const std::vector<Names> all{{"u", "v", eastward_current, northward_current},
                               {"uo", "vo", eastward_current, northward_current},
                               {"water_u", "water_v", eastward_current, northward_current},
                               {"u_velocity", "v_velocity", eastward_current, northward_current},
                               {"u10", "v10", "eastward_wind", "northward_wind"}};
  for (const Names& names : all) {
    for (const Witness& witness : witnesses) {
      for (const bool second_first : {false, true}) {
        const auto texts = [&](bool first) {
          Texts said;
          const bool standard_is_first = (witness.standard_name == Says::the_same) == first;
          if (witness.standard_name != Says::nothing)
            said["standard_name"] = standard_is_first ? names.standard_first : names.standard_second;
          const bool long_is_first = (witness.long_name == Says::the_same) == first;
          if (witness.long_name != Says::nothing)
            said["long_name"] = long_is_first ? "Eastward component" : "Northward component";
          return said;
        };
        std::vector<Field> fields{{names.first, 0.25, texts(true)}, {names.second, -0.5, texts(false)}};
        if (second_first) std::ranges::reverse(fields);

        const auto report = outcome(write(fields));
        const auto found = stored(report);

        const std::string label = names.first + " " +
                                  std::to_string(static_cast<int>(witness.standard_name)) +
                                  std::to_string(static_cast<int>(witness.long_name)) + words(report);
        if (witness.verdict == Verdict::refused) {
          EXPECT_FALSE(found) << label;
          EXPECT_THAT(words(report), HasSubstr("contradicts itself")) << label;
          continue;
        }
        ASSERT_TRUE(found) << label;
        const bool swapped = witness.verdict == Verdict::swapped;
        EXPECT_NEAR(found->first, swapped ? -0.5 : 0.25, 1e-6) << label;
        EXPECT_NEAR(found->second, swapped ? 0.25 : -0.5, 1e-6) << label;
        if (swapped) {
          EXPECT_THAT(words(report), HasSubstr("name says")) << label;
        }
      }
    }
  }
}

TEST_F(Choice, OfTwoEastwardComponentsIsRefused) {
  const auto report = outcome(write({{"uo", 0.25, {{"standard_name", eastward_current}}},
                                     {"vo", 0.5, {{"standard_name", eastward_current}}}}));

  EXPECT_FALSE(stored(report));
  EXPECT_THAT(words(report), HasSubstr("both say that they are the eastward component"));
}

TEST_F(Choice, OfAComponentThatCountsWestwardIsRefused) {
  const auto report = outcome(write(
      {{"u", 0.25, {{"long_name", "Westward current"}}}, {"v", 0.5, {{"long_name", "Northward current"}}}}));

  EXPECT_FALSE(stored(report));
  EXPECT_THAT(words(report), HasSubstr("counts westward"));
}

TEST_F(Choice, OfComponentsOfTwoModelsIsRefused) {
  const auto report = outcome(write({{"uo_a", 0.25, {{"standard_name", eastward_current}}},
                                     {"vo_b", 0.5, {{"standard_name", northward_current}}}}));

  EXPECT_FALSE(stored(report));
  EXPECT_THAT(words(report), HasSubstr("do not fit together"));
}

TEST_F(Choice, IsLeftToTheUserWhoNamesAComponent) {
  std::vector<Field> fields = pair_of("uo_a", "vo_a", 0.2);
  for (const Field& field : pair_of("uo_b", "vo_b", 0.3)) fields.push_back(field);
  for (const Field& field : pair_of("utide", "vtide", 0.4)) fields.push_back(field);
  for (const Field& field : pair_of("u_std", "v_std", 0.5)) fields.push_back(field);
  const auto file = write(fields);

  for (const auto& [wanted, value] :
       {std::pair{"uo_a", 0.2}, {"vo_a", 0.2}, {"uo_b", 0.3}, {"uo_b,vo_b", 0.3}, {"utide", 0.4}}) {
    const auto report = outcome(file, {.variable = wanted});
    expect_pair(stored(report), value, report);
  }
  EXPECT_THAT(words(outcome(file, {.variable = "utide"})),
              HasSubstr("hold the tide alone, as --variable asks"));
  EXPECT_FALSE(stored(outcome(file)));
  EXPECT_FALSE(stored(outcome(file, {.variable = "u_std"})));
}

TEST_F(Choice, OfAVariableIsNotOverturnedByWordsOfHowItWasMade) {
  for (const char* const said :
       {"Eastward velocity (ocean-wave coupled run)",
        "Eastward current driven by wind, checked with tide gauges",
        "Eastward current, sea ice model forced by wind stress", "Eastward velocity, bias corrected",
        "Eastward velocity from a tidal model", "Eastward velocity, wave-induced drift excluded",
        "Eastward velocity (baroclinic model)", "Eastward velocity, shear by wind stress resolved",
        "Eastward current with quality control, errors removed"}) {
    std::string other = said;
    other.replace(0, 4, "North");
    const auto report =
        outcome(write({{"uo", 0.25, {{"standard_name", eastward_current}, {"long_name", said}}},
                       {"vo", -0.25, {{"standard_name", northward_current}, {"long_name", other}}}}));
    expect_pair(stored(report), 0.25, report);
  }
}

/// Names that producers put together themselves, with what such a pair says of itself.
struct ComposedNames {
  const char* east;
  const char* north;
  const char* long_name;  // before the name of the component
  const char* words;      // among the warnings
};

TEST_F(Choice, KnowsNamesThatProducersPutTogether) {
  const ComposedNames all[]{
      {"surface_eastward_sea_water_velocity", "surface_northward_sea_water_velocity", "", "surface alone"},
      {"current_u", "current_v", "", "state no depth"},
      {"ucurr", "vcurr", "", "state no depth"},
      {"CURR_EAST", "CURR_NORTH", "", "state no depth"},
      {"U_sfc", "V_sfc", "sea water velocity", "surface alone"},
      {"depth_averaged_u", "depth_averaged_v", "water velocity", "means over the whole water column"},
      {"east_vel", "north_vel", "current", "state no depth"},
      {"u_residual", "v_residual", "residual current", "do not include the tide"}};
  for (const ComposedNames& names : all) {
    auto pair = pair_of(names.east, names.north, 0.25);
    for (auto& variable : pair) {
      variable.texts.erase("standard_name");
      variable.texts["long_name"] = std::string{names.long_name} + " " + variable.name;
    }
    const auto report = outcome(write(pair));
    ASSERT_EQ(report.status, IngestStatus::stored) << names.east << ": " << words(report);
    expect_pair(stored(report), 0.25, report);
    EXPECT_THAT(words(report), HasSubstr(names.words));
  }
}

TEST_F(Choice, TakesNoOtherQuantityForACurrentByItsName) {
  const std::pair<const char*, const char*> all[]{{"current_u_error", "current_v_error"},
                                                  {"ice_u_vel", "ice_v_vel"},
                                                  {"u_bottom_stress", "v_bottom_stress"},
                                                  {"x", "y"}};
  for (const auto& [east, north] : all) {
    auto pair = pair_of(east, north, 0.25);
    for (auto& variable : pair) variable.texts.erase("standard_name");
    EXPECT_EQ(outcome(write(pair)).status, IngestStatus::refused) << east;
  }
}

TEST_F(Choice, IsRefusedWithWhatIsStoredUnderTheNamesOfACurrent) {
  const auto tendency = outcome(
      write({{"uo", 0.25, {{"standard_name", "tendency_of_" + eastward_current}, {"units", "m s-2"}}},
             {"vo", 0.25, {{"standard_name", "tendency_of_" + northward_current}, {"units", "m s-2"}}}}));
  EXPECT_FALSE(stored(tendency));
  EXPECT_THAT(words(tendency), HasSubstr("\"uo\" has the name of a current but holds another quantity "
                                         "(tendency_of_eastward_sea_water_velocity in m s-2)"));
  const auto amplitude = outcome(write(pair_of("u_amp", "v_amp", 0.25, {{"long_name", "M2 amplitude"}})));
  EXPECT_FALSE(stored(amplitude));
  EXPECT_THAT(words(amplitude), HasSubstr("\"u_amp\" and \"v_amp\" hold the amplitude of a tide"));
}

/// cfgrib writes forecasts so: along the lengths of the forecasts, with the valid times beside them.
TEST_F(Choice, OfAForecastStandsAtTheTimesBesideItsLengths) {
  NetcdfWriter writer{path("forecast.nc")};
  writer.axis("step", {6.0, 12.0}, {{"units", "hours"}, {"standard_name", "forecast_period"}});
  writer.axis("lat", {50.0, 51.0}, {{"units", "degrees_north"}});
  writer.axis("lon", {0.0, 1.0}, {{"units", "degrees_east"}});
  const auto add = [&](const std::string& name, std::vector<std::string> dimensions,
                       std::vector<double> values, const Texts& texts) {
    writer.variable({.name = name,
                     .dimensions = std::move(dimensions),
                     .values = std::move(values),
                     .texts = texts,
                     .numbers = {},
                     .fill = {},
                     .type = NetcdfWriter::Type::float64});
  };
  const std::string unit = "hours since 2026-11-20 00:00:00";
  add("time", {}, {0.0}, {{"units", unit}, {"standard_name", "forecast_reference_time"}});
  add("valid_time", {"step"}, {6.0, 12.0}, {{"units", unit}, {"standard_name", "time"}});
  for (const auto& [name, standard] : {std::pair{"uoe", eastward_current}, {"von", northward_current}})
    add(name, {"step", "lat", "lon"}, std::vector<double>(8, 0.25),
        {{"units", "m s-1"}, {"standard_name", standard}});

  const auto report = outcome(path("forecast.nc"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->time_start, core::parse_iso8601("2026-11-20T06:00:00Z"));
  EXPECT_EQ(report.dataset->time_end, core::parse_iso8601("2026-11-20T12:00:00Z"));
}

TEST_F(Choice, TellsOfTheSurfaceBesideAMeanAndOfATotalBesideTheRest) {
  auto surface = pair_of("u_surf", "v_surf", 0.25);
  for (auto& field : surface) field.texts["standard_name"] = "surface_" + field.texts["standard_name"];
  auto mean = pair_of("ubar", "vbar", 0.5);
  for (auto& field : mean) field.texts["standard_name"] = "barotropic_" + field.texts["standard_name"];
  surface.insert(surface.end(), mean.begin(), mean.end());
  EXPECT_THAT(words(outcome(write(surface))), HasSubstr("were stored, but"));

  auto plain = pair_of("u", "v", 0.25);
  for (auto& field : pair_of("u_total", "v_total", 0.5)) plain.push_back(field);
  EXPECT_THAT(words(outcome(write(plain))), HasSubstr("were stored, but"));
}

TEST_F(Choice, TakesAPartOfTheCurrentForNoWhole) {
  const auto eddies = outcome(write(pair_of("u", "v", 0.25, {{"long_name", "eddy velocity"}})));
  EXPECT_THAT(words(eddies), HasSubstr("ignores the rest of the current"));
  const auto upper = outcome(write(pair_of("u", "v", 0.25, {{"long_name", "velocity averaged 0-300 m"}})));
  EXPECT_THAT(words(upper), HasSubstr("means over the whole water column or a part of it"));
}

TEST_F(Choice, SaysWhatThePairHolds) {
  const auto report_of = [&](const std::string& standard_end, const std::string& long_name) {
    Texts more;
    if (!long_name.empty()) more["long_name"] = long_name;
    return outcome(write(pair_of("uo", "vo", 0.25, more, standard_end)));
  };
  const auto total = report_of("", "velocity including tides");
  expect_pair(stored(total), 0.25, total);
  EXPECT_THAT(words(total), HasSubstr("already include the tide; add no tide"));
  const auto without = report_of("_assuming_no_tide", "");
  expect_pair(stored(without), 0.25, without);
  EXPECT_THAT(words(without), HasSubstr("do not include the tide"));
  const auto detided = report_of("", "detided velocity");
  EXPECT_THAT(words(detided), HasSubstr("do not include the tide"));
  const auto tide = report_of("", "tidal current");
  expect_pair(stored(tide), 0.25, tide);
  EXPECT_THAT(words(tide), HasSubstr("hold the tide alone, as their long names say"));
  const auto waves = report_of("", "Eulerian velocity and drift by waves");
  EXPECT_THAT(words(waves), HasSubstr("already include the drift by waves"));
  const auto sum = report_of("", "Eulerian current plus Stokes drift");
  EXPECT_THAT(words(sum), HasSubstr("already include the drift by waves"));
  const auto climatology = outcome(
      write(pair_of("uo", "vo", 0.25, {{"cell_methods", "time: mean within years time: mean over years"}})));
  EXPECT_THAT(words(climatology), HasSubstr("climatology"));
}

}  // namespace
}  // namespace floeplan::ingest::velocity_pair_test
