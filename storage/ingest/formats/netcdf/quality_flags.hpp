#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// A flag value with one meaning. With a mask, only the bits under the mask are compared with the value.
struct FlagMark {
  double value{};
  std::optional<std::int64_t> mask{};
};

/// A variable of flags that judge each value of another variable.
struct QualityFlags {
  const NetcdfVariable* variable{};
  std::vector<FlagMark> bad{};                // values of the flag that forbid the use of the data
  std::vector<FlagMark> doubtful{};           // values that mark data as doubtful; the data are still used
  std::optional<messages::Message> remark{};  // set if the meaning of the flags is itself uncertain

  [[nodiscard]] bool forbids(double flag) const;
  [[nodiscard]] bool doubts(double flag) const;
};

/// The flags that belong to a variable, whatever their dimensions: those named after it (lat_qc), those among
/// its ancillary_variables whose name or attributes make them flags, and the overall flag of a radar file.
/// Meanings such as bad, failed or missing make a value bad, meanings such as suspect make it doubtful. If
/// the flags have no meanings, 3 (doubtful in QARTOD), 4 and 9 are bad, and the remark says so.
/// Source   OceanSITES data format reference manual 1.4, table 2: 3 bad but correctable, 4 bad, 9 missing;
///          IOOS QARTOD data flags manual 1.2: 3 suspect, 4 fail, 9 missing; CF conventions 1.8, section 3.5:
///          values and masks; European HF radar node data model 3.0: QCflag
[[nodiscard]] std::vector<QualityFlags> flags_named_by(const NetcdfFile& file,
                                                       const NetcdfVariable& variable);

/// The flags that lie along the variable's own dimensions.
[[nodiscard]] std::vector<QualityFlags> quality_flags_of(const NetcdfFile& file,
                                                         const NetcdfVariable& variable);

}  // namespace floeplan::ingest
