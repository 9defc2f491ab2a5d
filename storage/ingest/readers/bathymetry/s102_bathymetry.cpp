#include <memory>
#include <string>
#include <utility>

#include "engine/messages/ingest_depth_messages.hpp"
#include "storage/ingest/formats/s100/s100_coverage.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/readers/bathymetry/bathymetry_grid.hpp"
#include "storage/ingest/readers/bathymetry/bathymetry_readers.hpp"

namespace floeplan::ingest {
namespace {

constexpr const char* depth_name = "depth";
constexpr const char* uncertainty_name = "uncertainty";

}  // namespace

Checked<PreparedDataset> read_s102_bathymetry(const std::filesystem::path& file) {
  auto opened = s100_coverage(file, "BathymetryCoverage");
  if (!opened) return refuse(opened.error());
  const auto described = opened->values.find(depth_name);
  const std::string unit = described == opened->values.end() ? "" : described->second.unit;
  const auto unit_m = length_factor(unit);
  if (!unit_m)
    return refuse(
        messages::ingest_depth_message<"depth-unit-unknown">("the depths of the S-102 file have", unit));
  if (opened->records.size() != 1)
    return refuse(messages::ingest_depth_message<"depths-of-several-records">(opened->records.size()));
  const auto table = opened->table(0);
  if (!table) return refuse(table.error());

  const auto coverage = std::make_shared<const S100Coverage>(std::move(*opened));
  const auto read = [coverage, table = *table, unit = static_cast<float>(*unit_m)](
                        std::size_t first_row, std::size_t count) -> Checked<RawRows> {
    auto depths = coverage->read(table, depth_name, first_row, count);
    if (!depths) return refuse(depths.error());
    for (float& depth : *depths) depth *= unit;
    RawRows rows{std::move(*depths)};
    if (!table.has(uncertainty_name)) return rows;
    auto uncertainties = coverage->read(table, uncertainty_name, first_row, count);
    if (!uncertainties) return refuse(uncertainties.error());
    for (float& uncertainty : *uncertainties) uncertainty *= unit;
    widen(rows, *uncertainties);
    return rows;
  };
  return prepare_bathymetry(
      {.grid = coverage->grid,
       .description = {.name = depth_name, .standard_name = "", .long_name = "", .positive = "down"},
       .warnings = {},
       .read = read},
      std::nullopt);
}

}  // namespace floeplan::ingest
