#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "tests/storage/ingest/support/choice_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::variable_level_test {
namespace {

using testing::HasSubstr;

class LevelChoice : public Choice {};

/// Names of producers for currents without levels, and the depth at which they are stored; NaN: at every depth.
struct NoLevels {
  const char* first;
  const char* second;
  Texts first_texts;
  Texts second_texts;
  double depth_m;
  const char* warning;
};

TEST_F(LevelChoice, OfCurrentsWithoutLevelsLeavesThemWhereTheyAre) {
  const double all = std::nan("");
  const char* const surface = "surface alone";
  const char* const mean = "means over the whole water column";
  const std::vector<NoLevels> files{
      {"u_sur", "v_sur", {}, {}, 0.0, surface},
      {"u_sur_eastward", "v_sur_northward", {}, {}, 0.0, surface},
      {"ssu", "ssv", {}, {}, 0.0, surface},
      {"a",
       "b",
       {{"standard_name", "surface_" + eastward_current}},
       {{"standard_name", "surface_" + northward_current}},
       0.0,
       surface},
      {"uo",
       "vo",
       {{"standard_name", eastward_current}, {"long_name", "Eastward surface current"}},
       {{"standard_name", northward_current}, {"long_name", "Northward surface current"}},
       0.0,
       surface},
      {"ubar", "vbar", {}, {}, all, mean},
      {"depthAverageVelX", "depthAverageVelY", {}, {}, all, mean},
      {"ubar_eastward", "vbar_northward", {}, {}, all, mean},
      {"ubar",
       "vbar",
       {{"long_name", "vertically integrated u-momentum component"}},
       {{"long_name", "vertically integrated v-momentum component"}},
       all,
       mean},
      {"a",
       "b",
       {{"standard_name", "barotropic_" + eastward_current}},
       {{"standard_name", "barotropic_" + northward_current}},
       all,
       mean},
      {"u-vel",
       "v-vel",
       {{"standard_name", "eastward_water_velocity"},
        {"long_name", "water column vertically averaged east/west velocity"}},
       {{"standard_name", "northward_water_velocity"},
        {"long_name", "water column vertically averaged north/south velocity"}},
       all,
       mean},
      {"uo",
       "vo",
       {{"standard_name", eastward_current}, {"cell_methods", "depth: mean time: mean"}},
       {{"standard_name", northward_current}, {"cell_methods", "depth: mean time: mean"}},
       all,
       mean},
      {"u_15m",
       "v_15m",
       {{"standard_name", eastward_current}},
       {{"standard_name", northward_current}},
       15.0,
       "at a depth of 15 m"},
      {"ua",
       "va",
       {{"long_name", "Vertically Averaged x-velocity"}},
       {{"long_name", "Vertically Averaged y-velocity"}},
       all,
       mean},
      {"ua",
       "va",
       {{"standard_name", eastward_current}, {"long_name", "velocity at 15 m"}},
       {{"standard_name", northward_current}, {"long_name", "velocity at 15 m"}},
       15.0,
       "at a depth of 15 m"},
  };
  for (const NoLevels& file : files) {
    const auto report =
        outcome(write({{file.first, 0.25, file.first_texts}, {file.second, -0.25, file.second_texts}}));
    expect_pair(stored(report), 0.25, report);
    EXPECT_THAT(words(report), HasSubstr(file.warning)) << file.first;
    const auto depths = currents_of(report).samples().depths_m;
    EXPECT_EQ(depths.has_value(), !std::isnan(file.depth_m)) << file.first;
    if (depths) {
      EXPECT_EQ(depths->nodes(), std::vector{file.depth_m}) << file.first;
    }
  }
}

TEST_F(LevelChoice, PrefersLevelsToTheSurfaceAndTheSurfaceToTheMean) {
  std::vector<Field> fields = pair_of("ubar", "vbar", 0.2);
  for (const Field& field : pair_of("u_sur", "v_sur", 0.3)) fields.push_back(field);
  const auto surface = outcome(write(fields));
  expect_pair(stored(surface), 0.3, surface);

  for (const Field& field : pair_of("u", "v", 0.4)) fields.push_back(field);
  const auto whole = outcome(write(fields));
  expect_pair(stored(whole), 0.4, whole);
  EXPECT_THAT(words(whole), testing::Not(HasSubstr("were stored, but")));
}

/// A level of currents and the depth that it is at, in any unit of length; positive up or down.
TEST_F(LevelChoice, OfALevelBesideTheVariableIsThatOfALevelAlongADimension) {
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    const double depth_m = support::uniform_int(rng, 0, 400);
    const bool up = support::uniform_int(rng, 0, 1) == 1;
    const bool centimetres = support::uniform_int(rng, 0, 1) == 1;
    Level level{.name = support::uniform_int(rng, 0, 1) == 1 ? "depth" : "z",
                .value = depth_m * (centimetres ? 100.0 : 1.0) * (up ? -1.0 : 1.0),
                .texts = {{"units", centimetres ? "cm" : "m"},
                          {"positive", up ? "up" : "down"},
                          {"standard_name", up ? "height" : "depth"}}};
    for (const bool is_dimension : {false, true}) {
      level.is_dimension = is_dimension;
      const auto report = outcome(write(pair_of("uo", "vo", 0.25), level));
      expect_pair(stored(report), 0.25, report);
      const auto depths = currents_of(report).samples().depths_m;
      ASSERT_TRUE(depths) << is_dimension << words(report);
      EXPECT_NEAR(depths->front(), depth_m, 1e-9) << is_dimension;
    }
  });
}

TEST_F(LevelChoice, OfWindIsTheOneAtTenMetresWhereverItsLevelIsStated) {
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    const double height_m =
        std::array{2.0, 10.0, 80.0, 100.0}[static_cast<std::size_t>(support::uniform_int(rng, 0, 3))];
    const Level level{.name = "height",
                      .value = height_m,
                      .texts = {{"units", "m"}, {"positive", "up"}, {"standard_name", "height"}},
                      .is_dimension = support::uniform_int(rng, 0, 1) == 1};
    const auto report = outcome(write({{"uwnd", 5.0, {{"standard_name", "eastward_wind"}}},
                                       {"vwnd", -5.0, {{"standard_name", "northward_wind"}}}},
                                      level));
    if (height_m == 10.0) {
      expect_pair(stored(report), 5.0, report);
      return;
    }
    EXPECT_FALSE(stored(report));
    EXPECT_THAT(words(report), HasSubstr("not at 10 m"));
  });
}

TEST_F(LevelChoice, OfLevelsOfPressureIsRefusedBesideAVariableAndAlongADimension) {
  for (const bool is_dimension : {false, true}) {
    const Level level{.name = "plev",
                      .value = 850.0,
                      .texts = {{"units", "hPa"}, {"standard_name", "air_pressure"}},
                      .is_dimension = is_dimension};
    for (const auto& fields : {std::vector<Field>{{"u", 5.0, {{"standard_name", "eastward_wind"}}},
                                                  {"v", -5.0, {{"standard_name", "northward_wind"}}}},
                               pair_of("uo", "vo", 0.25)}) {
      const auto report = outcome(write(fields, level));
      EXPECT_FALSE(stored(report)) << is_dimension;
      EXPECT_THAT(words(report), HasSubstr("are pressures")) << is_dimension;
    }
  }
}

/// Levels that are no depths, and what is said of them.
TEST_F(LevelChoice, OfLevelsThatAreNotInMetresIsRefusedForWhatTheyAre) {
  struct Unplaced {
    const char* standard_name;
    const char* unit;
    const char* words;
  };
  for (const Unplaced& unplaced :
       {Unplaced{"model_level_number", "1", "numbers of the model's levels"},
        Unplaced{"model_level_number", "level", "numbers of the model's levels"},
        Unplaced{"hybrid_sigma_pressure", "level", "numbers of the model's levels"},
        Unplaced{"height_above_sea_floor", "m", "heights above the sea bed"},
        Unplaced{"sea_water_pressure", "dbar", "pressures"},
        Unplaced{"", "K", "in the unit \"K\", not in metres"}}) {
    for (const bool is_dimension : {false, true}) {
      const Level level{
          .name = "lev",
          .value = 2.0,
          .texts = {{"units", unplaced.unit}, {"standard_name", unplaced.standard_name}, {"axis", "Z"}},
          .is_dimension = is_dimension};
      const auto report = outcome(write(pair_of("uo", "vo", 0.25), level));
      EXPECT_FALSE(stored(report)) << unplaced.words << is_dimension;
      EXPECT_THAT(words(report), HasSubstr(unplaced.words)) << is_dimension;
    }
  }
}

TEST_F(LevelChoice, TellsWhatIsTakenForTheWaterAboveADeepFirstLevel) {
  for (const auto& [depth_m, is_told] : {std::pair{0.5, false}, {5.0, false}, {50.0, true}}) {
    const Level level{.name = "depth", .value = depth_m, .texts = {{"units", "m"}, {"positive", "down"}}};
    const auto report = outcome(write(pair_of("uo", "vo", 0.25), level));
    expect_pair(stored(report), 0.25, report);
    EXPECT_EQ(words(report).find("begin at a depth of 50 m. Above this depth the same current is used") !=
                  std::string::npos,
              is_told)
        << depth_m;
  }
}

/// SCHISM writes vectors so: east and north along a last dimension "two".
TEST_F(LevelChoice, OfAVectorInOneVariableIsThatOfItsName) {
  const auto write_vector = [&](const char* name, double value) {
    NetcdfWriter writer{path("vector.nc")};
    writer.axis("time", {0.0, 6.0}, {{"units", "hours since 2026-11-20 00:00:00"}});
    writer.axis("lat", {50.0, 51.0}, {{"units", "degrees_north"}});
    writer.axis("lon", {0.0, 1.0}, {{"units", "degrees_east"}});
    writer.dimension("two", 2);
    std::vector<double> values;
    for (int i = 0; i < 8; ++i) values.insert(values.end(), {value, -value});
    writer.variable({.name = name,
                     .dimensions = {"time", "lat", "lon", "two"},
                     .values = values,
                     .texts = {},
                     .numbers = {},
                     .fill = {},
                     .type = NetcdfWriter::Type::float64});
    return outcome(path("vector.nc"));
  };
  const auto mean = write_vector("dahv", 0.25);
  expect_pair(stored(mean), 0.25, mean);
  EXPECT_THAT(words(mean), HasSubstr("means over the whole water column"));
  const auto wind = write_vector("wind_speed", 5.0);
  expect_pair(stored(wind), 5.0, wind);
  EXPECT_EQ(wind.dataset->kind, repository::DatasetKind::wind);
}

TEST_F(LevelChoice, OfWindGoesByTheLevelThatNamesState) {
  struct Named {
    const char* first;
    const char* second;
    Texts texts;
    bool at_10_m;
  };
  for (const Named& named :
       {Named{"u10", "v10", {}, true}, Named{"u100", "v100", {}, false}, Named{"ua850", "va850", {}, false},
        Named{"ugrd_850mb", "vgrd_850mb", {}, false}, Named{"wind_u_80m", "wind_v_80m", {}, false},
        Named{"wind_u_10m", "wind_v_10m", {}, true}, Named{"windx", "windy", {}, true},
        Named{"wu", "wv", {{"long_name", "100 metre wind component"}}, false},
        Named{"wu", "wv", {{"long_name", "10 metre wind component"}}, true},
        Named{"wu", "wv", {{"GRIB_typeOfLevel", "isobaricInhPa"}}, false},
        Named{"wu", "wv", {{"cell_methods", "time: maximum"}}, false},
        Named{"wu", "wv", {{"long_name", "wind gust"}}, false}}) {
    Texts u = named.texts;
    Texts v = named.texts;
    u["standard_name"] = "eastward_wind";
    v["standard_name"] = "northward_wind";
    const auto report = outcome(write({{named.first, 5.0, u}, {named.second, -5.0, v}}));
    if (named.at_10_m)
      expect_pair(stored(report), 5.0, report);
    else
      EXPECT_FALSE(stored(report)) << named.first << named.texts.begin()->second;
  }
}

TEST_F(LevelChoice, OfWindElsewhereIsRefusedWithTheLevelThatItsNameStates) {
  for (const auto& [first, second, level] : {std::tuple{"u100", "v100", "the wind at level 100"},
                                             {"ugrd_850mb", "vgrd_850mb", "the wind at 850 hPa"},
                                             {"u_80m", "v_80m", "the wind at 80 m"}}) {
    const auto report = outcome(write({{first, 5.0, {{"standard_name", "eastward_wind"}}},
                                       {second, -5.0, {{"standard_name", "northward_wind"}}}}));
    EXPECT_FALSE(stored(report));
    EXPECT_THAT(words(report), HasSubstr(level));
  }
}

TEST_F(LevelChoice, OfWindIsTheOneAtTenMetresInWhateverOrder) {
  std::vector<Field> fields{{"u100", 9.0, {{"standard_name", "eastward_wind"}}},
                            {"v100", -9.0, {{"standard_name", "northward_wind"}}},
                            {"u10", 5.0, {{"standard_name", "eastward_wind"}}},
                            {"v10", -5.0, {{"standard_name", "northward_wind"}}},
                            {"u10_std", 1.0, {{"standard_name", "eastward_wind"}}},
                            {"v10_std", -1.0, {{"standard_name", "northward_wind"}}}};
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    std::ranges::shuffle(fields, rng);
    const auto report = outcome(write(fields));
    expect_pair(stored(report), 5.0, report);
  });
}

}  // namespace
}  // namespace floeplan::ingest::variable_level_test
