#pragma once

#include <string>
#include <vector>

#include "storage/ingest/netcdf_file.hpp"

namespace floeplan::ingest {

/// Flags that say of each value of a variable what it is worth.
struct QualityFlags {
  const NetcdfVariable* variable{};
  std::vector<double> bad;  // values of the flag that forbid the use of what is flagged

  [[nodiscard]] bool forbids(double flag) const;
};

/// The flags of a variable along its own dimensions: those named after it, as lat_qc, or in its ancillary_variables.
/// Bad is what the flag's own meanings call bad, failed or missing; of flags without meanings 3, 4 and 9.
/// Source   OceanSITES data format reference manual 1.4, table 2: 3 bad but correctable, 4 bad, 9 missing
[[nodiscard]] std::vector<QualityFlags> quality_flags_of(const NetcdfFile& file,
                                                         const NetcdfVariable& variable);

}  // namespace floeplan::ingest
