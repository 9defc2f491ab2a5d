#include "storage/ingest/formats/netcdf/model_run.hpp"

#include <algorithm>
#include <cstdint>

#include "storage/ingest/notation/cf_time.hpp"

namespace floeplan::ingest {

std::optional<core::UtcTime> model_run_of(const NetcdfFile& file) {
  constexpr std::uint64_t most_values = 100'000;  // some files repeat the time for each time step
  const auto& variables = file.variables();
  const auto stated = std::ranges::find_if(variables, [](const NetcdfVariable& variable) {
    return variable.attribute("standard_name") == "forecast_reference_time" && variable.is_numeric();
  });
  if (stated == variables.end()) return std::nullopt;
  std::uint64_t count = 1;
  for (const NetcdfDimension& dimension : stated->dimensions()) {
    if (dimension.size == 0 || dimension.size > most_values / count) return std::nullopt;
    count *= dimension.size;
  }
  const auto time = CfTime::parse(stated->attribute("units"), stated->attribute("calendar"));
  const auto values = stated->read_all();
  if (!time || !values || values->empty()) return std::nullopt;
  const double first = values->front();
  if (std::ranges::any_of(*values, [&](double value) { return value != first; })) return std::nullopt;
  const auto run = time->at(first);
  return run ? std::optional{*run} : std::nullopt;
}

}  // namespace floeplan::ingest
