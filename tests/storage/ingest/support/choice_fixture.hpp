#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest {

using Texts = std::map<std::string, std::string>;

inline const std::string eastward_current = "eastward_sea_water_velocity";
inline const std::string northward_current = "northward_sea_water_velocity";
inline const geo::BoundingBox everywhere{-180.0, -90.0, 180.0, 90.0};

/// A variable with the same value everywhere, in m/s unless stated otherwise.
struct Field {
  std::string name;
  double value{};
  Texts texts{};
};

/// A level as a separate variable or as a dimension of the variables.
struct Level {
  std::string name;
  double value{};
  Texts texts{};
  bool is_dimension{false};
};

/// Writes files from which a reader has to choose, and returns the result.
class Choice : public StoreFixture {
 protected:
  std::filesystem::path write(const std::vector<Field>& fields,
                              const std::optional<Level>& level = std::nullopt, bool with_time = true) const {
    NetcdfWriter writer{path("choice.nc")};
    std::vector<std::string> dimensions{"lat", "lon"};
    if (with_time) {
      writer.axis("time", {0.0, 6.0}, {{"units", "hours since 2026-11-20 00:00:00"}});
      dimensions.insert(dimensions.begin(), "time");
    }
    writer.axis("lat", {50.0, 51.0, 52.0}, {{"units", "degrees_north"}});
    writer.axis("lon", {0.0, 1.0}, {{"units", "degrees_east"}});
    if (level && level->is_dimension) {
      writer.axis(level->name, {level->value}, level->texts);
      dimensions.insert(dimensions.begin() + 1, level->name);
    } else if (level) {
      writer.variable({.name = level->name,
                       .dimensions = {},
                       .values = {level->value},
                       .texts = level->texts,
                       .numbers = {},
                       .fill = {},
                       .type = NetcdfWriter::Type::float64});
    }
    for (const Field& field : fields) {
      Texts texts{{"units", "m s-1"}};
      for (const auto& [name, text] : field.texts) texts[name] = text;
      if (level && !level->is_dimension) texts["coordinates"] = level->name;
      writer.variable({.name = field.name,
                       .dimensions = dimensions,
                       .values = std::vector<double>(with_time ? 12 : 6, field.value),
                       .texts = std::move(texts),
                       .numbers = {},
                       .fill = {},
                       .type = NetcdfWriter::Type::float64});
    }
    return path("choice.nc");
  }

  /// The report on the only dataset of a file, which is ingested into a new store.
  IngestReport outcome(const std::filesystem::path& file, const IngestOptions& options = {}) {
    db_ = repository::open_store_in_memory();
    const auto reports = ingest_all(file, options);
    return reports.empty() ? IngestReport{} : reports.front();
  }

  /// The stored current as one number for each component; empty if nothing was stored.
  std::optional<std::pair<double, double>> stored(const IngestReport& report) {
    if (report.status != IngestStatus::stored) return std::nullopt;
    const ocean::CurrentGrid field = currents_of(report);
    return std::pair{static_cast<double>(field.samples().u.front()),
                     static_cast<double>(field.samples().v.front())};
  }
};

inline std::vector<Field> pair_of(const std::string& first, const std::string& second, double value,
                                  const Texts& more = {}, const std::string& behind = "") {
  Texts u = more;
  Texts v = more;
  u["standard_name"] = eastward_current + behind;
  v["standard_name"] = northward_current + behind;
  return {{first, value, u}, {second, -value, v}};
}

inline void expect_pair(const std::optional<std::pair<double, double>>& found, double value,
                        const IngestReport& report) {
  ASSERT_TRUE(found) << words(report);
  EXPECT_NEAR(found->first, value, 1e-6) << words(report);
  EXPECT_NEAR(found->second, -value, 1e-6) << words(report);
}

}  // namespace floeplan::ingest
