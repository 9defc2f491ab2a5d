#include "storage/ingest/readers/currents/current_readers.hpp"
#include "storage/ingest/readers/currents/velocity_input.hpp"

namespace floeplan::ingest {

Checked<PreparedDataset> read_currents(const NetcdfFiles& files, const std::optional<std::string>& stated_crs,
                                       const WantedVariables& wanted,
                                       const core::ProgressCallback& progress) {
  const auto pair = find_velocity_pair(files, Moving::sea, wanted);
  if (!pair) return refuse(pair.error());
  auto input = velocity_input(files, *pair, stated_crs);
  if (!input) return refuse(input.error());
  return prepare_currents(std::move(*input), progress);
}

}  // namespace floeplan::ingest
