#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::grid_flags_test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::size_t times = 2;
constexpr std::size_t rows = 4;
constexpr std::size_t columns = 5;
constexpr double wrong_m_s = 2.2;
constexpr double right_m_s = 0.3;

/// A producer's way to say what a flag means: numbers for good, suspect and bad values.
struct Convention {
  const char* name;
  std::vector<double> values;  // flag_values; empty: none
  std::vector<double> masks;   // flag_masks; empty: none
  const char* meanings;
  std::vector<double> good;
  std::vector<double> doubtful;
  std::vector<double> bad;
};

const std::vector<Convention> conventions{
    {"qartod_u", {1, 2, 3, 4, 9}, {}, "pass not_evaluated suspect fail missing", {1, 2}, {3}, {4, 9}},
    {"u_flag",
     {0, 1, 2, 3, 4, 9},
     {},
     "no_qc_performed good_data probably_good_data probably_bad_data bad_data missing_value",
     {0, 1, 2},
     {},
     {3, 4, 9}},
    {"QCflag",
     {0, 1, 2, 3, 4, 7, 8, 9},
     {},
     "unknown good_data probably_good_data potentially_correctable_bad_data bad_data nominal_value "
     "interpolated_value missing_value",
     {0, 1, 2, 7, 8},
     {},
     {3, 4, 9}},
    {"uo_qc", {}, {}, "", {0, 1, 2}, {}, {3, 4, 9}},
    {"uo_qartod", {}, {}, "", {1, 2}, {3}, {4, 9}},
    {"bits_flag",
     {},
     {1, 2, 4},
     "range_test_failed questionable_signal manually_rejected",
     {0},
     {2},
     {1, 4, 5, 7}},
    {"fields_flag", {1, 2, 3}, {3, 3, 3}, "good suspect bad", {1, 5}, {2, 6}, {3, 7}},
};

double one_of(std::mt19937_64& rng, const std::vector<double>& all) {
  return all[static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(all.size()) - 1))];
}

class FlagsOfGrids : public StoreFixture {
 protected:
  /// Currents whose flags may lie along fewer dimensions than they, or the same in another order.
  void write(const std::vector<double>& u, NetcdfWriter::Variable flags, const std::string& ancillary) {
    NetcdfWriter writer{path("flagged.nc")};
    writer.axis("time", {0.0, 6.0}, {{"units", "hours since 2026-11-20 00:00:00"}});
    writer.axis("lat", {50.0, 51.0, 52.0, 53.0}, {{"units", "degrees_north"}});
    writer.axis("lon", {0.0, 1.0, 2.0, 3.0, 4.0}, {{"units", "degrees_east"}});
    for (const char* name : {"uo", "vo"}) {
      const bool east = std::string{name} == "uo";
      NetcdfWriter::Variable component{
          .name = name,
          .dimensions = {"time", "lat", "lon"},
          .values = east ? u : std::vector<double>(u.size(), 0.1),
          .texts = {{"units", "m s-1"},
                    {"standard_name", east ? "eastward_sea_water_velocity" : "northward_sea_water_velocity"}},
          .numbers = {},
          .fill = std::nullopt};
      if (east && !ancillary.empty()) component.texts["ancillary_variables"] = ancillary;
      writer.variable(component);
    }
    flags.type = NetcdfWriter::Type::int16;
    writer.variable(flags);
  }

  std::vector<float> stored() {
    report_ = ingest(path("flagged.nc"));
    EXPECT_EQ(report_.status, IngestStatus::stored) << words(report_);
    if (!report_.dataset) throw std::runtime_error{"nothing was stored"};
    const auto grid = repository::FieldRepository{db_}.load_currents(
        report_.dataset->id, {-180.0, -90.0, 180.0, 90.0}, std::nullopt, std::nullopt);
    return grid.value().samples().u;
  }

  static NetcdfWriter::Variable flags_by(const Convention& convention) {
    NetcdfWriter::Variable flags{.name = convention.name,
                                 .dimensions = {"time", "lat", "lon"},
                                 .values = {},
                                 .texts = {},
                                 .numbers = {},
                                 .fill = std::nullopt};
    if (*convention.meanings != '\0') flags.texts["flag_meanings"] = convention.meanings;
    if (!convention.values.empty()) flags.lists["flag_values"] = convention.values;
    if (!convention.masks.empty()) flags.lists["flag_masks"] = convention.masks;
    return flags;
  }

  IngestReport report_;
};

/// Law: in every convention, the values flagged as bad are missing and counted, and all others are kept.
TEST_F(FlagsOfGrids, TakeOutWhatTheyCallBadAndNothingElse) {
  support::for_each_seed(28, [&](std::mt19937_64& rng) {
    db_ = repository::open_store_in_memory();
    const Convention& convention = conventions[static_cast<std::size_t>(support::uniform_int(rng, 0, 6))];
    NetcdfWriter::Variable flags = flags_by(convention);
    std::vector<double> u;
    std::vector<bool> bad;
    int doubtful = 0;
    for (std::size_t i = 0; i < times * rows * columns; ++i) {
      const int kind = i < 2 ? static_cast<int>(2 * i) : support::uniform_int(rng, 0, 2);
      const bool doubts = kind == 1 && !convention.doubtful.empty();
      bad.push_back(kind == 2);
      doubtful += doubts ? 1 : 0;
      u.push_back(kind == 2 ? wrong_m_s : right_m_s);
      flags.values.push_back(one_of(rng, kind == 2 ? convention.bad
                                         : doubts  ? convention.doubtful
                                                   : convention.good));
    }
    write(u, flags, convention.name);

    const std::vector<float> kept = stored();

    ASSERT_EQ(kept.size(), u.size()) << convention.name;
    for (std::size_t i = 0; i < u.size(); ++i) {
      ASSERT_EQ(std::isnan(kept[i]), bad[i]) << convention.name << " at " << i;
      if (!bad[i]) {
        ASSERT_FLOAT_EQ(kept[i], static_cast<float>(right_m_s));
      }
    }
    const auto count = std::ranges::count(bad, true);
    EXPECT_THAT(words(report_),
                HasSubstr(std::to_string(count) + (count == 1 ? " value was" : " values were") +
                          " left out, because the file's own quality flags"));
    if (doubtful > 0) {
      EXPECT_THAT(words(report_),
                  HasSubstr(std::to_string(doubtful) + (doubtful == 1 ? " value was" : " values were") +
                            " kept, although the file's own quality flags"));
    }
    EXPECT_EQ(words(report_).find("do not say what their numbers mean") != std::string::npos,
              *convention.meanings == '\0');
  });
}

/// A current of 2.2 m/s in the first row of latitudes, flagged there.
std::vector<double> wrong_in_the_first_row() {
  std::vector<double> u;
  for (std::size_t i = 0; i < times * rows * columns; ++i)
    u.push_back(i % (rows * columns) < columns ? wrong_m_s : right_m_s);
  return u;
}

std::size_t count_missing(const std::vector<float>& values) {
  return static_cast<std::size_t>(
      std::ranges::count_if(values, [](float value) { return std::isnan(value); }));
}

TEST_F(FlagsOfGrids, MayLieAlongFewerDimensionsOrInAnotherOrder) {
  NetcdfWriter::Variable flags = flags_by(conventions[0]);
  flags.dimensions = {"lon", "lat"};
  for (std::size_t i = 0; i < rows * columns; ++i) flags.values.push_back(i % rows == 0 ? 4.0 : 1.0);
  write(wrong_in_the_first_row(), flags, flags.name);

  const std::vector<float> kept = stored();

  EXPECT_EQ(count_missing(kept), times * columns);
  EXPECT_TRUE(std::ranges::none_of(kept, [](float value) { return value > 2.0F; }));
}

TEST_F(FlagsOfGrids, BelongToAVariableByTheirStandardName) {
  NetcdfWriter::Variable flags = flags_by(conventions[1]);
  flags.name = "worth";
  flags.texts["standard_name"] = "eastward_sea_water_velocity status_flag";
  for (const double u : wrong_in_the_first_row()) flags.values.push_back(u == wrong_m_s ? 4.0 : 1.0);
  write(wrong_in_the_first_row(), flags, "");

  EXPECT_EQ(count_missing(stored()), times * columns);
}

TEST_F(FlagsOfGrids, WithMeaningsThatNobodyKnowsAreTold) {
  NetcdfWriter::Variable flags = flags_by(conventions[0]);
  flags.lists["flag_values"] = {1.0, 2.0};
  flags.texts["flag_meanings"] = "zonk quux";
  flags.values.assign(times * rows * columns, 2.0);
  write(wrong_in_the_first_row(), flags, flags.name);

  EXPECT_EQ(count_missing(stored()), 0U);
  EXPECT_THAT(words(report_), HasSubstr("unknown meanings (\"zonk\" and \"quux\")"));
}

TEST_F(FlagsOfGrids, ThatDoNotLieOnTheNodesAreTold) {
  NetcdfWriter::Variable flags = flags_by(conventions[0]);
  flags.dimensions = {"time"};
  flags.values = {1.0, 4.0};
  write(wrong_in_the_first_row(), flags, flags.name);

  EXPECT_EQ(count_missing(stored()), 0U);
  EXPECT_THAT(words(report_), HasSubstr("do not lie on its nodes"));
}

TEST_F(FlagsOfGrids, AreNotTheErrorsBesideThem) {
  NetcdfWriter::Variable error = flags_by(conventions[3]);
  error.name = "uo_error";
  error.values.assign(times * rows * columns, 4.0);
  write(wrong_in_the_first_row(), error, error.name);

  EXPECT_EQ(count_missing(stored()), 0U);
  EXPECT_THAT(words(report_), Not(HasSubstr("flag")));
}

TEST_F(FlagsOfGrids, ThatCallEverythingBadLeaveNothingToStore) {
  NetcdfWriter::Variable flags = flags_by(conventions[0]);
  flags.values.assign(times * rows * columns, 4.0);
  write(wrong_in_the_first_row(), flags, flags.name);

  expect_refused(path("flagged.nc"), "flagged as bad by the file's own quality flags");
}

}  // namespace
}  // namespace floeplan::ingest::grid_flags_test
