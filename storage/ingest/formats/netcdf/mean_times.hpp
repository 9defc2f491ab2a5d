#pragma once

#include <string>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_axis.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// The times of a variable that holds means over intervals: the middle of each interval, whether the file
/// states its begin, middle or end. Times of other variables, and of files without intervals, stay unchanged.
/// `stated`  the times that time_nodes reads from `coordinate`
/// Errors    intervals that cannot be decoded, or that are not in the order of the times
/// Source    CF conventions 1.8, sections 7.1 (bounds) and 7.3 (cell methods)
[[nodiscard]] Checked<AxisNodes> times_of_means(const NetcdfFile& file, const NetcdfVariable& variable,
                                                const NetcdfVariable& coordinate, AxisNodes stated,
                                                Messages& warnings);

}  // namespace floeplan::ingest
