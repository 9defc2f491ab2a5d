#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "engine/core/utc_text.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::current_traps_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class CurrentTraps : public StoreFixture {
 protected:
  /// Stores the file and gives back everything that was stored.
  ocean::CurrentGrid::Samples stored(const CurrentFile& content) {
    content.write(path("currents.nc"));
    report_ = ingest(path("currents.nc"));
    EXPECT_EQ(report_.status, IngestStatus::stored) << words(report_);
    if (!report_.dataset) throw std::runtime_error{"nothing was stored"};
    const auto grid = repository::FieldRepository{db_}.load_currents(
        report_.dataset->id, {-180.0, -90.0, 180.0, 90.0}, std::nullopt, std::nullopt);
    return grid.value().samples();
  }

  IngestReport report_;
};

TEST_F(CurrentTraps, LatitudesThatDescendAreTurnedWithTheirData) {
  CurrentFile file;
  file.lats = {52.0, 51.0, 50.0};

  const auto samples = stored(file);

  EXPECT_THAT(samples.grid.y().nodes(), ElementsAre(50.0, 51.0, 52.0));
  EXPECT_FLOAT_EQ(samples.u[0], static_cast<float>(file.value('u', 0, 0, 2, 0)));
  EXPECT_FLOAT_EQ(samples.v[2 * 4 + 3], static_cast<float>(file.value('v', 0, 0, 0, 3)));
}

TEST_F(CurrentTraps, ValuesOutsideTheValidRangeAreMissingPackedOrNot) {
  for (const double end : {2000.0, 2.0}) {
    CurrentFile file;
    file.type = NetcdfWriter::Type::int16;
    file.numbers = {{"scale_factor", 0.001}, {"valid_min", -end}, {"valid_max", end}};
    file.value = [](char, std::size_t, std::size_t, std::size_t y, std::size_t x) {
      return y == 0 && x == 1 ? 3000.0 : 100.0 + static_cast<double>(x);
    };

    const auto samples = stored(file);

    EXPECT_FLOAT_EQ(samples.u[0], 0.1F);
    EXPECT_TRUE(std::isnan(samples.u[1]));
    EXPECT_THAT(words(report_), HasSubstr("outside the valid range that the file states"));
    db_ = repository::open_store_in_memory();
  }
}

TEST_F(CurrentTraps, LongitudesFromZeroTo360StayAndWrap) {
  CurrentFile file;
  file.lons = {0.0, 90.0, 180.0, 270.0, 360.0};

  const auto samples = stored(file);

  EXPECT_THAT(samples.grid.x().nodes(), ElementsAre(0.0, 90.0, 180.0, 270.0));
  EXPECT_TRUE(samples.grid.wraps());
  EXPECT_FLOAT_EQ(samples.u[3], static_cast<float>(file.value('u', 0, 0, 0, 3)));
}

TEST_F(CurrentTraps, ASeamInsideTheFileIsUnrolled) {
  CurrentFile file;
  file.lons = {178.0, 179.0, -180.0, -179.0};

  const auto samples = stored(file);

  EXPECT_THAT(samples.grid.x().nodes(), ElementsAre(178.0, 179.0, 180.0, 181.0));
  EXPECT_EQ(report_.dataset->bounds, (geo::BoundingBox{178.0, 50.0, -179.0, 52.0}));
}

TEST_F(CurrentTraps, PackedIntegersAreComparedWithTheirFillBeforeTheyAreScaled) {
  CurrentFile file;
  file.type = NetcdfWriter::Type::int16;
  file.fill = -30000.0;
  file.numbers = {{"scale_factor", 0.001}, {"add_offset", 0.5}};
  file.value = [](char component, std::size_t, std::size_t, std::size_t y, std::size_t x) {
    if (x == 0 && y == 0) return -30000.0;
    return component == 'u' ? 250.0 : -500.0;
  };

  const auto samples = stored(file);

  EXPECT_TRUE(std::isnan(samples.u[0]));
  EXPECT_FLOAT_EQ(samples.u[1], 0.75F);
  EXPECT_FLOAT_EQ(samples.v[1], 0.0F);
}

TEST_F(CurrentTraps, AFloatFillIsComparedAsFloat) {
  CurrentFile file;
  file.depths = {0.0};
  file.type = NetcdfWriter::Type::float32;
  file.numbers = {{"missing_value", 1e20}};
  file.value = [](char, std::size_t, std::size_t, std::size_t, std::size_t x) { return x == 1 ? 1e20 : 0.1; };

  const auto samples = stored(file);

  EXPECT_TRUE(std::isnan(samples.u[1]));
  EXPECT_FLOAT_EQ(samples.u[0], 0.1F);
  EXPECT_TRUE(report_.warnings.empty()) << words(report_);
}

/// Law: a mean stands in the middle of its interval, whichever moment of it the file states.
TEST_F(CurrentTraps, MeansStandInTheMiddleOfTheirIntervals) {
  support::for_each_seed(12, [&](std::mt19937_64& rng) {
    const double length_h = support::uniform_int(rng, 1, 24);
    const double stated = support::uniform_int(rng, 0, 2) / 2.0;  // at which share of the interval
    const bool is_mean = support::uniform_int(rng, 0, 2) > 0;
    std::filesystem::remove(path("means.nc"));
    db_ = repository::open_store_in_memory();
    {
      NetcdfWriter writer{path("means.nc")};
      const std::vector<double> begins{0.0, length_h, 2.0 * length_h};
      std::vector<double> times;
      std::vector<double> edges;
      for (const double begin : begins) {
        times.push_back(begin + stated * length_h);
        edges.insert(edges.end(), {begin, begin + length_h});
      }
      writer.axis("time", times, {{"units", "hours since 2026-11-20 00:00:00"}, {"bounds", "time_bnds"}});
      writer.axis("lat", {50.0, 51.0}, {{"units", "degrees_north"}});
      writer.axis("lon", {0.0, 1.0}, {{"units", "degrees_east"}});
      writer.dimension("nv", 2);
      writer.variable({.name = "time_bnds",
                       .dimensions = {"time", "nv"},
                       .values = edges,
                       .texts = {},
                       .numbers = {},
                       .fill = {},
                       .type = NetcdfWriter::Type::float64});
      for (const char* const name : {"uo", "vo"})
        writer.variable(
            {.name = name,
             .dimensions = {"time", "lat", "lon"},
             .values = std::vector<double>(12, 0.1),
             .texts = {{"units", "m s-1"}, {"cell_methods", is_mean ? "time: mean" : "time: point"}},
             .numbers = {},
             .fill = {},
             .type = NetcdfWriter::Type::float64});
    }

    const auto report = ingest(path("means.nc"));

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    const double first_h = (is_mean ? 0.5 : stated) * length_h;
    EXPECT_EQ(report.dataset->time_start,
              core::parse_iso8601("2026-11-20T00:00:00Z").value() + core::Seconds{3600.0 * first_h});
    EXPECT_EQ(words(report).find("counts for the middle of its interval") != std::string::npos,
              is_mean && stated != 0.5);
  });
}

TEST_F(CurrentTraps, CurrentsWithoutADepthAreToldToCountForAll) {
  (void)stored(CurrentFile{});
  EXPECT_THAT(words(report_), testing::HasSubstr("\"uo\" and \"vo\" state no depth"));
}

TEST_F(CurrentTraps, AnUndeclaredFillIsLeftOutWithAWarning) {
  CurrentFile file;
  file.value = [](char, std::size_t, std::size_t, std::size_t, std::size_t x) {
    return x == 1 ? 999.0 : 0.1;
  };

  const auto samples = stored(file);

  EXPECT_TRUE(std::isnan(samples.u[1]));
  EXPECT_THAT(words(report_), HasSubstr("they stand for a missing current"));
}

TEST_F(CurrentTraps, DepthsThatCountUpwardsBecomePositiveDownAndAscend) {
  CurrentFile file;
  file.depths = {-100.0, -50.0, 0.0};
  file.depth_texts = {{"units", "m"}, {"positive", "up"}};

  const auto samples = stored(file);

  EXPECT_THAT(samples.depths_m->nodes(), ElementsAre(0.0, 50.0, 100.0));
  EXPECT_FLOAT_EQ(samples.u[0], static_cast<float>(file.value('u', 0, 2, 0, 0)));
}

/// xmitgcm writes the levels of MITgcm so.
TEST_F(CurrentTraps, DepthsBelowZeroThatClaimToCountDownwardsAreHeights) {
  CurrentFile file;
  file.depths = {-2.0, -5.0, -9.0};
  file.depth_texts = {{"units", "m"}, {"positive", "down"}, {"standard_name", "depth"}};

  const auto samples = stored(file);

  EXPECT_THAT(samples.depths_m->nodes(), ElementsAre(2.0, 5.0, 9.0));
  EXPECT_FLOAT_EQ(samples.u[0], static_cast<float>(file.value('u', 0, 0, 0, 0)));
  EXPECT_THAT(words(report_), HasSubstr("They were read as heights"));
}

/// The state files of MITgcm's own package for NetCDF.
TEST_F(CurrentTraps, TimesWithoutAStartAreNamed) {
  {
    NetcdfWriter file{path("state.nc")};
    file.axis("T", {0.0, 86400.0}, {{"units", "s"}, {"long_name", "model_time"}});
    file.axis("Y", {50.0, 50.1, 50.2}, {{"units", "degrees_north"}});
    file.axis("X", {-52.0, -51.9, -51.8}, {{"units", "degrees_east"}});
    for (const char* const name : {"UVEL", "VVEL"})
      file.variable({.name = name,
                     .dimensions = {"T", "Y", "X"},
                     .values = std::vector<double>(18, 0.25),
                     .texts = {{"units", "m/s"}},
                     .numbers = {},
                     .fill = {}});
  }

  expect_refused(path("state.nc"), "counts in \"s\" from a start that the file does not state");
}

TEST_F(CurrentTraps, DimensionsMayComeInAnyOrder) {
  CurrentFile file;
  file.depths = {0.0, 10.0};
  file.order = {"lon", "depth", "lat", "time"};

  const auto samples = stored(file);

  for (std::size_t t = 0; t < 2; ++t)
    for (std::size_t z = 0; z < 2; ++z)
      for (std::size_t y = 0; y < 3; ++y)
        for (std::size_t x = 0; x < 4; ++x)
          ASSERT_FLOAT_EQ(samples.v[((t * 2 + z) * 3 + y) * 4 + x],
                          static_cast<float>(file.value('v', t, z, y, x)));
}

TEST_F(CurrentTraps, CoordinatesMayHaveOtherNamesThanTheirDimensions) {
  {
    NetcdfWriter writer{path("currents.nc")};  // as OSCAR 2.0 writes them
    writer.axis("time", {0.0}, {{"units", "days since 2026-11-20 00:00:00"}});
    writer.dimension("longitude", 2);
    writer.dimension("latitude", 3);
    writer.variable({"lon", {"longitude"}, {300.0, 301.0}, {{"units", "degrees_east"}}, {}, {}});
    writer.variable({"lat", {"latitude"}, {50.0, 51.0, 52.0}, {{"units", "degrees_north"}}, {}, {}});
    for (const auto& [name, standard_name, sign] :
         {std::tuple{"u", "eastward_sea_water_velocity", 0.1}, {"v", "northward_sea_water_velocity", -0.1}})
      writer.variable({name,
                       {"time", "longitude", "latitude"},
                       {sign, 2.0 * sign, 3.0 * sign, 4.0 * sign, 5.0 * sign, 6.0 * sign},
                       {{"units", "m s-1"}, {"standard_name", standard_name}},
                       {},
                       {}});
  }

  report_ = ingest(path("currents.nc"));

  ASSERT_EQ(report_.status, IngestStatus::stored) << words(report_);
  const auto grid = repository::FieldRepository{db_}.load_currents(
      report_.dataset->id, {-180.0, -90.0, 180.0, 90.0}, std::nullopt, std::nullopt);
  const auto current = grid.value().at({-59.0, 51.0}, {0.0}, *report_.dataset->time_start);
  ASSERT_TRUE(current.has_value());
  EXPECT_FLOAT_EQ(static_cast<float>(current->east.value), 0.5F);
  EXPECT_FLOAT_EQ(static_cast<float>(current->north.value), -0.5F);
}

TEST_F(CurrentTraps, TimesInDisorderAreSortedWithTheirData) {
  CurrentFile file;
  file.times = {6.0, 0.0};

  const auto samples = stored(file);

  EXPECT_EQ(core::iso8601(*report_.dataset->time_start), "2026-11-20T00:00:00Z");
  EXPECT_FLOAT_EQ(samples.u[0], static_cast<float>(file.value('u', 1, 0, 0, 0)));
}

TEST_F(CurrentTraps, AScalarTimeHoldsForAllTheData) {
  {
    NetcdfWriter writer{path("scalar.nc")};
    writer.axis("lat", {50.0, 51.0}, {{"units", "degrees_north"}});
    writer.axis("lon", {0.0, 1.0}, {{"units", "degrees_east"}});
    writer.variable({.name = "time",
                     .dimensions = {},
                     .values = {6.0},
                     .texts = {{"units", "hours since 2021-05-04T12:00:00+00:00"}, {"standard_name", "time"}},
                     .numbers = {},
                     .fill = {},
                     .type = NetcdfWriter::Type::float64});
    for (const char* name : {"water_u", "water_v"})
      writer.variable({.name = name,
                       .dimensions = {"lat", "lon"},
                       .values = {0.1, 0.2, 0.3, 0.4},
                       .texts = {{"units", "m/s"}},
                       .numbers = {},
                       .fill = {},
                       .type = NetcdfWriter::Type::float64});
  }

  const auto report = ingest(path("scalar.nc"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(core::iso8601(*report.dataset->time_start), "2021-05-04T18:00:00Z");
}

TEST_F(CurrentTraps, CentimetresPerSecondAreConverted) {
  CurrentFile file;
  file.u_texts["units"] = "cm/s";
  file.value = [](char component, std::size_t, std::size_t, std::size_t, std::size_t) {
    return component == 'u' ? 150.0 : 0.25;
  };

  const auto samples = stored(file);

  EXPECT_FLOAT_EQ(samples.u[0], 1.5F);
  EXPECT_FLOAT_EQ(samples.v[0], 0.25F);
}

TEST_F(CurrentTraps, AMissingUnitIsTakenAsMetresPerSecondWithAWarning) {
  CurrentFile file;
  file.u_texts.erase("units");

  const auto samples = stored(file);

  EXPECT_FLOAT_EQ(samples.u[0], static_cast<float>(file.value('u', 0, 0, 0, 0)));
  EXPECT_THAT(words(report_), HasSubstr("states no unit"));
}

TEST_F(CurrentTraps, TheDatesOfAModelsCalendarAreKeptWithAWarning) {
  CurrentFile file;
  file.times = {18250.5, 18251.5};
  file.time_texts = {{"units", "days since 1900-01-01"}, {"calendar", "NOLEAP"}};

  const auto samples = stored(file);

  EXPECT_EQ(core::iso8601(*report_.dataset->time_start), "1950-01-01T12:00:00Z");
  EXPECT_EQ(samples.times_s[1] - samples.times_s[0], 86400.0);
  EXPECT_THAT(words(report_), HasSubstr("calendar"));
}

/// In the file's own unit, as a reader sees it who unpacks the numbers.
TEST_F(CurrentTraps, AMarkOfMissingValuesThatTheUserNamesIsNoCurrent) {
  for (const bool packed : {false, true}) {
    CurrentFile file;
    file.u_texts["units"] = file.v_texts["units"] = "cm s-1";
    file.type = packed ? NetcdfWriter::Type::int16 : NetcdfWriter::Type::float32;
    if (packed) file.numbers = {{"scale_factor", 0.01}};
    file.value = [&](char, std::size_t, std::size_t, std::size_t, std::size_t x) {
      return (x == 2 ? -99.99 : 25.0) * (packed ? 100.0 : 1.0);
    };
    file.write(path("sea.nc"));

    const auto report = ingest(path("sea.nc"), {.missing = -99.99});

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    const auto currents = repository::FieldRepository{db_}.load_currents(
        report.dataset->id, {-180.0, -90.0, 180.0, 90.0}, std::nullopt, std::nullopt);
    EXPECT_FLOAT_EQ(currents->samples().u[1], 0.25F);
    EXPECT_TRUE(std::isnan(currents->samples().u[2]));
    std::filesystem::remove(path("sea.nc"));
  }
}

TEST_F(CurrentTraps, AMarkThatCouldBeASpeedIsDoubted) {
  CurrentFile file;
  file.u_texts["units"] = file.v_texts["units"] = "cm s-1";
  file.lons = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
  bool marked = true;
  file.value = [&](char component, std::size_t, std::size_t, std::size_t y, std::size_t x) {
    if (marked && x < 3) return -99.99;
    return (component == 'u' ? 10.0 : -4.0) + static_cast<double>(x + y);
  };
  file.write(path("marked.nc"));
  EXPECT_THAT(words(ingest(path("marked.nc"))),
              HasSubstr("at 9 points both components are exactly -0.9999 m/s"));

  marked = false;
  file.write(path("sea.nc"));
  EXPECT_THAT(words(ingest(path("sea.nc"))), testing::Not(HasSubstr("--missing")));
}

TEST_F(CurrentTraps, AMarkThatIsNamedSparesTheAxes) {
  CurrentFile file;
  file.lons = {-1.0, 0.0, 1.0, 2.0};
  file.write(path("sea.nc"));

  const auto report = ingest(path("sea.nc"), {.missing = 0.0});

  EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
}

TEST_F(CurrentTraps, LandWrittenAsStillWaterBecomesMissing) {
  CurrentFile file;
  file.lons = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
  file.lats = {50.0, 51.0, 52.0, 53.0};
  file.value = [](char component, std::size_t t, std::size_t, std::size_t y, std::size_t x) {
    if (x >= 3) return 0.0;                                     // land
    if (x == 0 && y == 0) return component == 'u' ? 0.0 : 0.2;  // one component happens to be zero
    return 0.1 + 0.01 * static_cast<double>(t);
  };

  const auto samples = stored(file);

  EXPECT_TRUE(std::isnan(samples.u[3]));
  EXPECT_FLOAT_EQ(samples.u[0], 0.0F);
  EXPECT_FLOAT_EQ(samples.v[0], 0.2F);
  EXPECT_THAT(words(report_), HasSubstr("count as land"));
}

TEST_F(CurrentTraps, ATitleThatSpeaksOfSomethingElseIsTold) {
  for (const auto& [title, what] :
       {std::pair{"Barotropic tidal currents predicted by TPXO9", "names the tide alone"},
        {"Standard deviation of daily currents", "names a standard deviation"},
        {"Stokes drift from a wave model", "names the drift by waves alone"},
        {"Daily mean currents of a global ocean forecast", ""},
        {"", ""}}) {
    db_ = repository::open_store_in_memory();
    CurrentFile file;
    if (*title != '\0') file.title = title;
    file.write(path("titled.nc"));
    const auto report = ingest(path("titled.nc"));
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    EXPECT_EQ(words(report).find("the title of the file") != std::string::npos, *what != '\0') << title;
    EXPECT_THAT(words(report), HasSubstr(what));
  }
}

TEST_F(CurrentTraps, AFewStillNodesAreNotLand) {
  CurrentFile file;
  file.value = [](char, std::size_t, std::size_t, std::size_t y, std::size_t x) {
    return x == 1 && y == 1 ? 0.0 : 0.1;
  };

  const auto samples = stored(file);

  EXPECT_FLOAT_EQ(samples.u[5], 0.0F);
}

TEST_F(CurrentTraps, AFileStoredTwiceIsUnchanged) {
  stored(CurrentFile{});

  const auto again =
      ingest(path("currents.nc"), {.name = "another name", .kind = {}, .crs = {}, .positive = {}});

  EXPECT_EQ(again.status, IngestStatus::unchanged);
  EXPECT_EQ(again.dataset->id, report_.dataset->id);
  EXPECT_EQ(stored_datasets(), 1U);
}

TEST_F(CurrentTraps, ProvenanceNamesFileSizeChecksumAndTools) {
  stored(CurrentFile{});

  const repository::Provenance& provenance = report_.dataset->provenance;
  EXPECT_EQ(provenance.file_name, "currents.nc");
  EXPECT_EQ(provenance.file_size_bytes,
            static_cast<std::int64_t>(std::filesystem::file_size(path("currents.nc"))));
  EXPECT_EQ(provenance.sha256.size(), 64U);
  EXPECT_EQ(report_.dataset->id.value, "currents-" + provenance.sha256.substr(0, 8));
  EXPECT_THAT(provenance.tool_version, testing::MatchesRegex("floeplan .*, GDAL .*"));
  EXPECT_EQ(report_.dataset->name, "currents");
  EXPECT_THAT(report_.dataset->variables, ElementsAre("uo", "vo"));
}

}  // namespace
}  // namespace floeplan::ingest::current_traps_test
