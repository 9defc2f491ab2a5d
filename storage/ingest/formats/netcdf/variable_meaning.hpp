#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// A standard name in lower case without its modifier: "sea_ice_area_fraction" for "sea_ice_area_fraction
/// standard_error".
[[nodiscard]] std::string standard_name_of(const NetcdfVariable& variable);

/// One statement of cell_methods, lower case: "time: lat: mean" has the axes {time, lat} and the method mean.
struct CellMethod {
  std::vector<std::string> axes;
  std::string method;
  std::vector<std::string> where;  // the words after the method: "over years", "where sea"
};

/// The statements of cell_methods, without comments in brackets.
/// Source  CF conventions 1.11, section 7.3
[[nodiscard]] std::vector<CellMethod> cell_methods_of(const NetcdfVariable& variable);

/// What the values of a variable may be instead of the quantity in its name.
enum class Statistic {
  none,
  deviation,
  standard_error,
  uncertainty,
  maximum,
  minimum,
  range,
  mid_range,
  variance,
  sum,
  root_mean_square,
  mean_of_sizes,
  percentile,
  anomaly,
  bias,
  trend,
  gust,
  flag,
  count,
  detection_limit
};

/// "a standard deviation", "a quality flag"; empty for none.
[[nodiscard]] std::string in_words(Statistic statistic);

/// The statistic that a variable holds instead of the quantity itself. An instantaneous value, a mean and a
/// median count as the quantity: none. Checked in this order: the modifier of the standard name,
/// cell_methods, the name, the long name; the first that names a statistic decides.
/// Source  CF conventions 1.11, appendix C (modifiers) and appendix E (cell methods)
[[nodiscard]] Statistic statistic_of(const NetcdfVariable& variable);

/// The statistic in a name alone, such as that of a group.
[[nodiscard]] Statistic statistic_in_name(std::string_view name);

/// The statistic in a text alone, such as the description of a band.
[[nodiscard]] Statistic statistic_in_words(std::string_view text);

/// The parts of a name, lower case; signs that are neither letters nor digits separate them.
[[nodiscard]] std::vector<std::string> parts_of_name(std::string_view name);

}  // namespace floeplan::ingest
