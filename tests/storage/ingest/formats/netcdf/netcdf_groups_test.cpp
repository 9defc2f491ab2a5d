#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::netcdf_groups_test {
namespace {

using repository::DatasetKind;
using testing::HasSubstr;

const std::vector<double> lons{1.0, 2.0, 3.0};
const std::vector<double> lats{50.0, 51.0, 52.0};

void write_axes(NetcdfWriter& writer) {
  writer.axis("time", {0.0}, {{"units", "hours since 2026-11-20 00:00:00"}});
  writer.axis("lat", lats, {{"units", "degrees_north"}});
  writer.axis("lon", lons, {{"units", "degrees_east"}});
}

void write_pair(NetcdfWriter& writer, const std::string& first, const std::string& second, double scale) {
  for (const std::string& name : {first, second}) {
    std::vector<double> values;
    for (int i = 1; i <= 9; ++i) values.push_back(scale * i * (name == first ? 1.0 : -1.0));
    writer.variable({.name = name,
                     .dimensions = {"time", "lat", "lon"},
                     .values = values,
                     .texts = {{"units", "m s-1"}},
                     .numbers = {},
                     .fill = {},
                     .type = NetcdfWriter::Type::float64});
  }
}

class NetcdfGroups : public StoreFixture {
 protected:
  float first_value(const IngestReport& report) { return currents_of(report).samples().u.front(); }
};

TEST_F(NetcdfGroups, AreLookedIntoHoweverDeepTheDataLie) {
  support::for_each_seed(16, [&](std::mt19937_64& rng) {
    const int depth = support::uniform_int(rng, 1, 4);
    const int axes_at = support::uniform_int(rng, 0, depth);
    const double scale = 0.01 * support::uniform_int(rng, 1, 9);
    std::filesystem::remove(path("groups.nc"));
    std::string group;
    {
      NetcdfWriter writer{path("groups.nc")};
      for (int level = 0; level <= depth; ++level) {
        const std::string name{static_cast<char>('a' + level)};
        if (level > 0) writer.enter(name);
        if (level > 0) group += "/" + name;
        if (level == axes_at) write_axes(writer);
      }
      write_pair(writer, "uo", "vo", scale);
    }

    const auto report = ingest(path("groups.nc"));

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    EXPECT_NEAR(first_value(report), scale, 1e-6);
    EXPECT_THAT(words(report), HasSubstr("the data were read from the group " + group + " of the file"));
  });
}

TEST_F(NetcdfGroups, AreFoundAmongManyBesideAndBelowEachOther) {
  support::for_each_seed(16, [&](std::mt19937_64& rng) {
    const int outer = support::uniform_int(rng, 1, 6);
    const int inner = support::uniform_int(rng, 2, 6);
    const int chosen = support::uniform_int(rng, 0, outer * inner - 1);
    const auto name = [](const char* kind, int number) {
      return "a_long_name_of_the_" + std::string{kind} + "_group_" + std::to_string(number);
    };
    std::filesystem::remove(path("groups.nc"));
    {
      NetcdfWriter writer{path("groups.nc")};
      write_axes(writer);
      for (int i = 0; i < outer * inner; ++i) {
        writer.leave_groups();
        writer.enter(name("outer", i / inner));
        writer.enter(name("inner", i % inner));
        if (i == chosen) write_pair(writer, "uo", "vo", 0.01);
      }
    }

    const auto report = ingest(path("groups.nc"));

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    EXPECT_NEAR(first_value(report), 0.01, 1e-6);
    EXPECT_THAT(words(report),
                HasSubstr("the data were read from the group /" + name("outer", chosen / inner) + "/" +
                          name("inner", chosen % inner) + " of the file"));
  });
}

TEST_F(NetcdfGroups, WithDataOfTheSameKindHaveToBeChosenFrom) {
  {
    NetcdfWriter writer{path("groups.nc")};
    write_axes(writer);
    writer.enter("daily");
    write_pair(writer, "uo", "vo", 0.01);
    writer.leave_groups();
    writer.enter("monthly");
    write_pair(writer, "uo", "vo", 0.02);
  }
  expect_refused(path("groups.nc"), "/daily (currents) and /monthly (currents)");
}

TEST_F(NetcdfGroups, BesideTheTopLevelAreToldAndReadWhereTheirKindIsWanted) {
  {
    NetcdfWriter writer{path("groups.nc")};
    write_axes(writer);
    write_pair(writer, "u10", "v10", 0.5);
    writer.enter("ocean");
    write_pair(writer, "uo", "vo", 0.01);
  }
  const auto wind = ingest(path("groups.nc"));
  const auto currents = ingest(path("groups.nc"), {.kind = DatasetKind::currents});

  ASSERT_EQ(wind.dataset.value().kind, DatasetKind::wind) << words(wind);
  EXPECT_THAT(words(wind), HasSubstr("Its groups /ocean"));
  ASSERT_EQ(currents.status, IngestStatus::stored) << words(currents);
  EXPECT_NEAR(first_value(currents), 0.01, 1e-6);
}

TEST_F(NetcdfGroups, WithDataOfTheSameKindAsTheTopLevelAreTold) {
  {
    NetcdfWriter writer{path("groups.nc")};
    write_axes(writer);
    write_pair(writer, "uo", "vo", 0.01);
    writer.enter("monthly");
    write_pair(writer, "uo", "vo", 0.02);
    writer.leave_groups();
    writer.enter("notes");
    write_pair(writer, "chl", "phyc", 0.03);
  }
  const auto report = ingest(path("groups.nc"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_NEAR(first_value(report), 0.01, 1e-6);
  EXPECT_THAT(words(report), HasSubstr("Its groups /monthly (currents) were not"));
}

TEST_F(NetcdfGroups, BelowAGroupWithDataOfTheSameKindHaveToBeChosenFrom) {
  {
    NetcdfWriter writer{path("groups.nc")};
    write_axes(writer);
    writer.enter("ocean");
    write_pair(writer, "uo", "vo", 0.01);
    writer.enter("monthly");
    write_pair(writer, "uo", "vo", 0.02);
  }
  expect_refused(path("groups.nc"), "/ocean (currents) and /ocean/monthly (currents)");
}

/// The only group with data, called `group`.
void write_sole_group(const std::filesystem::path& file, const std::string& group) {
  std::filesystem::remove(file);
  NetcdfWriter writer{file};
  write_axes(writer);
  writer.enter(group);
  write_pair(writer, "uo", "vo", 0.01);
}

TEST_F(NetcdfGroups, WhoseNamesSpeakOfStatisticsAreRefused) {
  for (const auto& [group, what] : {std::pair{"std", "a standard deviation"},
                                    {"uv_rmse", "an uncertainty"},
                                    {"daily_max", "a maximum"},
                                    {"anomaly", "an anomaly"}}) {
    write_sole_group(path("named.nc"), group);
    expect_refused(path("named.nc"), std::string{"By its name the group holds "} + what);
  }
}

TEST_F(NetcdfGroups, WhoseNamesSpeakOfAPartAreTold) {
  for (const auto& [group, what] : {std::pair{"tide", "holds the tide alone"},
                                    {"bottom", "holds the current at the sea bed"},
                                    {"surface", "holds the surface alone"},
                                    {"quality_controlled", ""},
                                    {"ocean", ""}}) {
    db_ = repository::open_store_in_memory();
    write_sole_group(path("named.nc"), group);
    const auto report = ingest(path("named.nc"));
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    EXPECT_EQ(words(report).find("By its name the group") != std::string::npos, *what != '\0') << group;
    EXPECT_THAT(words(report), HasSubstr(what));
  }
}

TEST_F(NetcdfGroups, WhoseCoordinatesLieInAnotherAreRefusedForThat) {
  {
    NetcdfWriter writer{path("beside.nc")};
    writer.dimension("time", 1);
    writer.dimension("lat", lats.size());
    writer.dimension("lon", lons.size());
    writer.enter("places");
    for (const auto& [name, values, unit] :
         {std::tuple{"time", std::vector{0.0}, "hours since 2026-11-20 00:00:00"},
          std::tuple{"lat", lats, "degrees_north"}, std::tuple{"lon", lons, "degrees_east"}})
      writer.variable({.name = name,
                       .dimensions = {name},
                       .values = values,
                       .texts = {{"units", unit}},
                       .numbers = {},
                       .fill = {},
                       .type = NetcdfWriter::Type::float64});
    writer.leave_groups();
    writer.enter("data");
    write_pair(writer, "uo", "vo", 0.01);
  }
  expect_refused(path("beside.nc"), "lie in another group of the file (/places)");
}

TEST_F(NetcdfGroups, WithoutAnythingKnownAreRefusedWithTheirNames) {
  {
    NetcdfWriter writer{path("groups.nc")};
    write_axes(writer);
    writer.enter("biology");
    write_pair(writer, "chl", "phyc", 0.01);
  }
  expect_refused(path("groups.nc"), "its groups (/biology)");
}

TEST_F(NetcdfGroups, HideCoordinatesOfAnotherLength) {
  {
    NetcdfWriter writer{path("groups.nc")};
    write_axes(writer);
    writer.enter("nest");
    writer.dimension("lat", 5);
    writer.dimension("lon", 4);
    for (const char* const name : {"uo", "vo"})
      writer.variable({.name = name,
                       .dimensions = {"time", "lat", "lon"},
                       .values = std::vector<double>(20, 0.1),
                       .texts = {{"units", "m s-1"}},
                       .numbers = {},
                       .fill = {},
                       .type = NetcdfWriter::Type::float64});
  }
  expect_refused(path("groups.nc"), "has no coordinates");
}

}  // namespace
}  // namespace floeplan::ingest::netcdf_groups_test
