#include "storage/ingest/quality_flags.hpp"

#include <algorithm>
#include <sstream>

#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

/// Of the meanings, parted by blanks, each belongs to the value at the same position.
std::vector<double> bad_values(const NetcdfVariable& flags) {
  const std::vector<double> values = flags.numbers("flag_values");
  std::istringstream meanings{lower(flags.attribute("flag_meanings"))};
  std::vector<double> bad;
  std::string meaning;
  for (std::size_t i = 0; i < values.size() && meanings >> meaning; ++i)
    if (contains_any(meaning, {"bad", "fail", "missing"})) bad.push_back(values[i]);
  return bad.empty() ? std::vector{3.0, 4.0, 9.0} : bad;
}

bool has_the_same_dimensions(const NetcdfVariable& a, const NetcdfVariable& b) {
  return std::ranges::equal(a.dimensions(), b.dimensions(), {}, &NetcdfDimension::name,
                            &NetcdfDimension::name);
}

}  // namespace

bool QualityFlags::forbids(double flag) const { return std::ranges::find(bad, flag) != bad.end(); }

std::vector<QualityFlags> quality_flags_of(const NetcdfFile& file, const NetcdfVariable& variable) {
  std::istringstream words{lower(variable.attribute("ancillary_variables"))};
  std::vector<std::string> names{lower(variable.name()) + "_qc"};
  for (std::string word; words >> word;)
    if (word.ends_with("_qc") || word.ends_with("_flag")) names.push_back(word);
  std::vector<QualityFlags> found;
  for (const NetcdfVariable& candidate : file.variables()) {
    if (!candidate.is_numeric() || !has_the_same_dimensions(candidate, variable)) continue;
    if (std::ranges::find(names, lower(candidate.name())) != names.end())
      found.push_back({&candidate, bad_values(candidate)});
  }
  return found;
}

}  // namespace floeplan::ingest
