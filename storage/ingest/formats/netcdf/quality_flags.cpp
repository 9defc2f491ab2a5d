#include "storage/ingest/formats/netcdf/quality_flags.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

#include "engine/messages/ingest_netcdf_messages.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

enum class Worth { good, doubtful, bad, unknown };

/// Whether a meaning contains one of the words without "not", "no" or "non" before it.
bool says(std::string_view meaning, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) {
    const std::size_t at = meaning.find(word);
    if (at == std::string_view::npos) return false;
    const std::string_view before = meaning.substr(0, at);
    return !before.ends_with("not_") && !before.ends_with("no_") && !before.ends_with("non_");
  });
}

/// How good a value with a flag of this meaning ("probably_bad_data") is. A value that was not checked counts
/// as good.
Worth worth_of(std::string_view meaning) {
  if (says(meaning, {"bad", "fail", "missing", "reject", "invalid", "incorrect", "erroneous", "unusable",
                     "unacceptable", "masked"}) ||
      meaning == "land")
    return Worth::bad;
  if (says(meaning, {"suspect", "questionable", "doubtful", "suspicious"})) return Worth::doubtful;
  const bool is_judged_good = says(meaning, {"good", "pass", "valid", "correct", "acceptable", "usable"}) ||
                              meaning == "ok" || meaning == "okay";
  const bool is_open =
      contains_any(meaning,
                   {"unknown", "not_eval", "not_checked", "not_used", "unchecked", "no_qc", "no_bad",
                    "not_bad", "no_quality", "no_error", "not_applied", "not_validated", "not_performed"}) ||
      contains_any(meaning, {"nominal", "interpolated", "estimated", "changed", "excess", "below_detection"});
  return is_judged_good || is_open ? Worth::good : Worth::unknown;
}

/// Words separated by blanks or, against the conventions, by commas or semicolons.
std::vector<std::string> words_in(std::string text) {
  std::ranges::replace_if(text, [](char c) { return c == ',' || c == ';'; }, ' ');
  return words_between_blanks(text);
}

/// Numbers of an attribute. Some producers write them as a text.
std::vector<double> numbers_in(const NetcdfVariable& flags, const char* name) {
  std::vector<double> numbers = flags.numbers(name);
  if (!numbers.empty()) return numbers;
  for (const std::string& word : words_in(flags.attribute(name)))
    if (const auto number = parse_number(word)) numbers.push_back(*number);
  return numbers;
}

/// The mark for each meaning; empty if the numbers of values, masks and meanings differ.
std::vector<FlagMark> marks_of(const NetcdfVariable& flags, std::size_t meanings) {
  const std::vector<double> values = numbers_in(flags, "flag_values");
  const std::vector<double> masks = numbers_in(flags, "flag_masks");
  const bool fits = (values.empty() || values.size() == meanings) &&
                    (masks.empty() || masks.size() == meanings) && !(values.empty() && masks.empty());
  std::vector<FlagMark> marks;
  for (std::size_t i = 0; fits && i < meanings; ++i) {
    FlagMark mark{.value = values.empty() ? masks[i] : values[i]};
    if (!masks.empty()) mark.mask = static_cast<std::int64_t>(masks[i]);
    marks.push_back(mark);
  }
  return marks;
}

bool is_of_qartod(const NetcdfVariable& flags) {
  std::string words = flags.name();
  for (const char* attribute : {"long_name", "standard_name", "references", "comment"})
    words += " " + flags.attribute(attribute);
  return contains_any(lower(words), {"qartod"});
}

QualityFlags by_convention(const NetcdfVariable& variable) {
  QualityFlags flags{.variable = &variable};
  flags.bad = {{4.0}, {9.0}};
  (is_of_qartod(variable) ? flags.doubtful : flags.bad).push_back({3.0});
  flags.remark = messages::ingest_netcdf_message<"flags-taken-as-usual">(
      variable.name(), flags.doubtful.empty() ? "bad" : "suspect");
  return flags;
}

QualityFlags understood(const NetcdfVariable& variable) {
  const std::vector<std::string> meanings = words_in(lower(variable.attribute("flag_meanings")));
  const std::vector<FlagMark> marks = marks_of(variable, meanings.size());
  const bool has_masks = !numbers_in(variable, "flag_masks").empty();
  if (marks.empty() && !has_masks) return by_convention(variable);

  QualityFlags flags{.variable = &variable};
  std::vector<std::string> unknown;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Worth worth = worth_of(meanings[i]);
    if (worth == Worth::bad) flags.bad.push_back(marks[i]);
    if (worth == Worth::doubtful) flags.doubtful.push_back(marks[i]);
    if (worth == Worth::unknown) unknown.push_back("\"" + meanings[i] + "\"");
  }
  if (marks.empty())
    flags.remark = messages::ingest_netcdf_message<"flag-bits-unknown">(variable.name());
  else if (!unknown.empty())
    flags.remark =
        messages::ingest_netcdf_message<"flag-meanings-unknown">(variable.name(), enumeration(unknown));
  return flags;
}

bool has_the_same_dimensions(const NetcdfVariable& a, const NetcdfVariable& b) {
  return std::ranges::equal(a.dimensions(), b.dimensions(), {}, &NetcdfDimension::name,
                            &NetcdfDimension::name);
}

/// Whether a variable named beside another one holds its quality flags. Errors and numbers of observations
/// are no flags.
bool is_flag(const NetcdfVariable& variable) {
  const std::string name = lower(variable.name());
  const std::string standard_name = lower(variable.attribute("standard_name"));
  return name.ends_with("_qc") || name.starts_with("qc_") || contains_any(name, {"flag", "qartod"}) ||
         standard_name.ends_with("status_flag") || standard_name.ends_with("quality_flag") ||
         !variable.attribute("flag_meanings").empty();
}

bool any_covers(const std::vector<FlagMark>& marks, double flag) {
  return std::ranges::any_of(marks, [flag](const FlagMark& mark) {
    if (!mark.mask) return flag == mark.value;
    if (!(std::abs(flag) < 9e15)) return false;  // NaN, or too large to be a whole number
    return (static_cast<std::int64_t>(flag) & *mark.mask) == static_cast<std::int64_t>(mark.value);
  });
}

}  // namespace

bool QualityFlags::forbids(double flag) const { return any_covers(bad, flag); }
bool QualityFlags::doubts(double flag) const { return any_covers(doubtful, flag); }

std::vector<QualityFlags> flags_named_by(const NetcdfFile& file, const NetcdfVariable& variable) {
  const std::string name = lower(variable.name());
  const std::vector<std::string> named = words_in(lower(variable.attribute("ancillary_variables")));
  const std::string standard_name = lower(variable.attribute("standard_name"));
  const auto belongs = [&](const NetcdfVariable& candidate) {
    const std::string its_name = lower(candidate.name());
    const bool is_named_after = its_name == name + "_qc" || its_name == "qc_" + name ||
                                its_name == name + "_flag" || its_name == "qcflag";
    const bool is_listed = std::ranges::find(named, its_name) != named.end() && is_flag(candidate);
    const bool modifies = !standard_name.empty() &&
                          lower(candidate.attribute("standard_name")) == standard_name + " status_flag";
    return is_named_after || is_listed || modifies;
  };
  std::vector<QualityFlags> found;
  for (const NetcdfVariable& candidate : file.variables())
    if (&candidate != &variable && belongs(candidate)) found.push_back(understood(candidate));
  return found;
}

std::vector<QualityFlags> quality_flags_of(const NetcdfFile& file, const NetcdfVariable& variable) {
  std::vector<QualityFlags> flags = flags_named_by(file, variable);
  std::erase_if(flags, [&](const QualityFlags& each) {
    return !each.variable->is_numeric() || !has_the_same_dimensions(*each.variable, variable);
  });
  return flags;
}

}  // namespace floeplan::ingest
