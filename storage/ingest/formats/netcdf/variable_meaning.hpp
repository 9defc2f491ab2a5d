#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// A standard name without the modifier behind it, lower case: "sea_ice_area_fraction" of "sea_ice_area_fraction
/// standard_error".
[[nodiscard]] std::string standard_name_of(const NetcdfVariable& variable);

/// One statement of cell_methods, lower case: "time: lat: mean" is {time, lat}, mean.
struct CellMethod {
  std::vector<std::string> axes;
  std::string method;
  std::vector<std::string> where;  // the words behind the method: "over years", "where sea"
};

/// Comments in brackets are left out.
/// Source  CF conventions 1.11, section 7.3
[[nodiscard]] std::vector<CellMethod> cell_methods_of(const NetcdfVariable& variable);

/// What numbers may be in place of the quantity that their variable names.
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

/// "a standard deviation", "a quality flag"; empty of none.
[[nodiscard]] std::string in_words(Statistic statistic);

/// What the numbers of a variable are where they are not the quantity itself; none where they are: at an instant, as a
/// mean or as a median. Told by the modifier of the standard name, by cell_methods, by the name, by the long name, in
/// this order; any of them is enough.
/// Source  CF conventions 1.11, appendix C (modifiers) and appendix E (cell methods)
[[nodiscard]] Statistic statistic_of(const NetcdfVariable& variable);

/// The same of a name alone, such as that of a group.
[[nodiscard]] Statistic statistic_in_name(std::string_view name);

/// The same of a text alone, such as the description of a band.
[[nodiscard]] Statistic statistic_in_words(std::string_view text);

/// The parts of a name between signs that are neither letters nor digits, lower case.
[[nodiscard]] std::vector<std::string> parts_of_name(std::string_view name);

}  // namespace floeplan::ingest
