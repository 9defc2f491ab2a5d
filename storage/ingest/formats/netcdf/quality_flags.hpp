#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// One meaning of a flag: what it equals, or of several in one number what its bits under the mask equal.
struct FlagMark {
  double value{};
  std::optional<std::int64_t> mask{};
};

/// Flags that say of each value of a variable what it is worth.
struct QualityFlags {
  const NetcdfVariable* variable{};
  std::vector<FlagMark> bad{};                // forbid the use of what is flagged
  std::vector<FlagMark> doubtful{};           // leave it in use
  std::optional<messages::Message> remark{};  // why the marks are doubtful themselves

  [[nodiscard]] bool forbids(double flag) const;
  [[nodiscard]] bool doubts(double flag) const;
};

/// Flags that a variable says belong to it, on whatever dimensions they lie: those named after it (lat_qc), those of
/// its ancillary_variables that are called or describe themselves as flags, and the overall flag of a radar's file.
/// Bad is what the flag's own meanings call bad, failed or missing; doubtful what they call suspect. Of flags without
/// meanings 3 (by QARTOD doubtful), 4 and 9 are bad, and the remark says so.
/// Source   OceanSITES data format reference manual 1.4, table 2: 3 bad but correctable, 4 bad, 9 missing; IOOS QARTOD
///          data flags manual 1.2: 3 suspect, 4 fail, 9 missing; CF conventions 1.8, section 3.5: values and masks;
///          European HF radar node data model 3.0: QCflag
[[nodiscard]] std::vector<QualityFlags> flags_named_by(const NetcdfFile& file,
                                                       const NetcdfVariable& variable);

/// The flags that lie along the variable's own dimensions.
[[nodiscard]] std::vector<QualityFlags> quality_flags_of(const NetcdfFile& file,
                                                         const NetcdfVariable& variable);

}  // namespace floeplan::ingest
