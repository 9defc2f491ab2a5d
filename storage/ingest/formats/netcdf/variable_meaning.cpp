#include "storage/ingest/formats/netcdf/variable_meaning.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

struct Meaning {
  std::string_view text;
  Statistic statistic;
};

constexpr Meaning modifiers[]{{"standard_error", Statistic::standard_error},
                              {"status_flag", Statistic::flag},
                              {"detection_minimum", Statistic::detection_limit},
                              {"number_of_observations", Statistic::count}};

constexpr Meaning methods[]{{"standard_deviation", Statistic::deviation},
                            {"variance", Statistic::variance},
                            {"maximum", Statistic::maximum},
                            {"maximum_absolute_value", Statistic::maximum},
                            {"minimum", Statistic::minimum},
                            {"minimum_absolute_value", Statistic::minimum},
                            {"range", Statistic::range},
                            {"mid_range", Statistic::mid_range},
                            {"sum", Statistic::sum},
                            {"sum_of_squares", Statistic::sum},
                            {"root_mean_square", Statistic::root_mean_square},
                            {"mean_absolute_value", Statistic::mean_of_sizes},
                            {"mean_of_upper_decile", Statistic::percentile}};

/// Words between the underscores of a name; a word must match entirely ("std" in "uo_std").
constexpr Meaning name_parts[]{{"std", Statistic::deviation},
                               {"stdev", Statistic::deviation},
                               {"stddev", Statistic::deviation},
                               {"stdv", Statistic::deviation},
                               {"stdu", Statistic::deviation},
                               {"erru", Statistic::uncertainty},
                               {"errv", Statistic::uncertainty},
                               {"sd", Statistic::deviation},
                               {"deviation", Statistic::deviation},
                               {"spread", Statistic::deviation},
                               {"stderr", Statistic::standard_error},
                               {"err", Statistic::uncertainty},
                               {"error", Statistic::uncertainty},
                               {"errors", Statistic::uncertainty},
                               {"unc", Statistic::uncertainty},
                               {"uncert", Statistic::uncertainty},
                               {"uncertainty", Statistic::uncertainty},
                               {"variance", Statistic::variance},
                               {"max", Statistic::maximum},
                               {"maximum", Statistic::maximum},
                               {"maxwind", Statistic::maximum},
                               {"min", Statistic::minimum},
                               {"minimum", Statistic::minimum},
                               {"range", Statistic::range},
                               {"rms", Statistic::root_mean_square},
                               {"rmse", Statistic::uncertainty},
                               {"rmsd", Statistic::uncertainty},
                               {"flag", Statistic::flag},
                               {"flags", Statistic::flag},
                               {"qc", Statistic::flag},
                               {"quality", Statistic::flag},
                               {"count", Statistic::count},
                               {"counts", Statistic::count},
                               {"nobs", Statistic::count},
                               {"percentile", Statistic::percentile},
                               {"quantile", Statistic::percentile},
                               {"p01", Statistic::percentile},
                               {"p05", Statistic::percentile},
                               {"p10", Statistic::percentile},
                               {"p90", Statistic::percentile},
                               {"p95", Statistic::percentile},
                               {"p99", Statistic::percentile},
                               {"anom", Statistic::anomaly},
                               {"anomaly", Statistic::anomaly},
                               {"anomalies", Statistic::anomaly},
                               {"bias", Statistic::bias},
                               {"trend", Statistic::trend},
                               {"gust", Statistic::gust},
                               {"gusts", Statistic::gust}};

/// Ends of a part of a name: "uostd".
constexpr Meaning name_ends[]{{"std", Statistic::deviation},
                              {"stdev", Statistic::deviation},
                              {"stddev", Statistic::deviation},
                              {"err", Statistic::uncertainty}};

/// Phrases that have only one meaning, wherever they stand in a text.
constexpr Meaning phrases[]{{"standard deviation", Statistic::deviation},
                            {"standard_deviation", Statistic::deviation},
                            {"std dev", Statistic::deviation},
                            {"std. dev", Statistic::deviation},
                            {"stddev", Statistic::deviation},
                            {"stdev", Statistic::deviation},
                            {"ensemble spread", Statistic::deviation},
                            {"standard error", Statistic::standard_error},
                            {"standard_error", Statistic::standard_error},
                            {"root mean square", Statistic::root_mean_square},
                            {"root-mean-square", Statistic::root_mean_square},
                            {"variance", Statistic::variance},
                            {"uncertaint", Statistic::uncertainty},
                            {"error of ", Statistic::uncertainty},
                            {"error on ", Statistic::uncertainty},
                            {"error in ", Statistic::uncertainty},
                            {"errors of ", Statistic::uncertainty},
                            {"error estimate", Statistic::uncertainty},
                            {"formal error", Statistic::uncertainty},
                            {"mapping error", Statistic::uncertainty},
                            {"estimated error", Statistic::uncertainty},
                            {"percentile", Statistic::percentile},
                            {"quantile", Statistic::percentile},
                            {"number of observations", Statistic::count},
                            {"number_of_observations", Statistic::count},
                            {"maximum of ", Statistic::maximum},
                            {"daily max", Statistic::maximum},
                            {"hourly max", Statistic::maximum},
                            {"monthly max", Statistic::maximum},
                            {"annual max", Statistic::maximum},
                            {"minimum of ", Statistic::minimum},
                            {"daily min", Statistic::minimum},
                            {"hourly min", Statistic::minimum},
                            {"monthly min", Statistic::minimum},
                            {"annual min", Statistic::minimum},
                            {"anomal", Statistic::anomaly},
                            {"wind gust", Statistic::gust}};

/// Words that count only as the first or the last word of a text; elsewhere they may describe how the values
/// were made.
constexpr Meaning outer_words[]{{"maximum", Statistic::maximum},   {"max", Statistic::maximum},
                                {"max.", Statistic::maximum},      {"minimum", Statistic::minimum},
                                {"min", Statistic::minimum},       {"min.", Statistic::minimum},
                                {"error", Statistic::uncertainty}, {"errors", Statistic::uncertainty},
                                {"range", Statistic::range},       {"spread", Statistic::deviation},
                                {"std", Statistic::deviation},     {"rms", Statistic::root_mean_square},
                                {"rmse", Statistic::uncertainty},  {"flag", Statistic::flag},
                                {"flags", Statistic::flag},        {"quality", Statistic::flag},
                                {"trend", Statistic::trend},       {"gust", Statistic::gust},
                                {"gusts", Statistic::gust},        {"bias", Statistic::bias},
                                {"count", Statistic::count}};

Statistic find_whole(std::span<const Meaning> meanings, std::string_view word) {
  const auto found = std::ranges::find(meanings, word, &Meaning::text);
  return found != meanings.end() ? found->statistic : Statistic::none;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : text) {
    if (c != ' ' && c != '\t' && c != '\n' && c != ',' && c != ';' && c != '(' && c != ')') {
      word += c;
      continue;
    }
    if (!word.empty()) words.push_back(std::move(word));
    word.clear();
  }
  if (!word.empty()) words.push_back(std::move(word));
  return words;
}

bool is_digits(const std::string& part) {
  return !part.empty() && std::ranges::all_of(part, [](char c) { return c >= '0' && c <= '9'; });
}

/// Whether a part of a name says that something was removed: "bias_corrected_u" holds no bias.
bool undoes(const std::string& part) {
  return contains_any(part, {"correct", "adjust", "remov"}) || part == "free";
}

/// The statistic in a standard name: its modifier, or words that producers append against the CF conventions.
Statistic statistic_in_standard_name(const NetcdfVariable& variable) {
  const std::vector<std::string> words = words_of(lower(variable.attribute("standard_name")));
  for (std::size_t i = 1; i < words.size(); ++i)
    if (const Statistic found = find_whole(modifiers, words[i]); found != Statistic::none) return found;
  return statistic_in_name(variable.attribute("standard_name"));
}

/// The statistic that the cell methods state for any axis: a spatial mean of a maximum over time is not the
/// quantity itself, either.
Statistic statistic_in_cell_methods(const NetcdfVariable& variable) {
  for (const CellMethod& cell : cell_methods_of(variable)) {
    Statistic found = find_whole(methods, cell.method);
    if (found == Statistic::none) found = find_whole(name_parts, cell.method);  // not in CF, but clear
    if (found != Statistic::none) return found;
  }
  return Statistic::none;
}

}  // namespace

std::string standard_name_of(const NetcdfVariable& variable) {
  const std::vector<std::string> words = words_of(lower(variable.attribute("standard_name")));
  return words.empty() ? std::string{} : words.front();
}

std::vector<CellMethod> cell_methods_of(const NetcdfVariable& variable) {
  std::string plain;  // without comments, and with a blank after every colon
  int depth = 0;
  for (const char c : lower(variable.attribute("cell_methods"))) {
    if (c == '(') ++depth;
    if (depth == 0) plain += c;
    if (c == ':' && depth == 0) plain += ' ';
    if (c == ')') --depth;
  }
  std::vector<CellMethod> found;
  for (const std::string& word : words_of(plain)) {
    if (word.back() == ':') {
      if (found.empty() || !found.back().method.empty()) found.emplace_back();
      found.back().axes.push_back(word.substr(0, word.size() - 1));
    } else if (!found.empty() && found.back().method.empty()) {
      found.back().method = word;
    } else if (!found.empty()) {
      found.back().where.push_back(word);
    }
  }
  return found;
}

std::string in_words(Statistic statistic) {
  switch (statistic) {
    case Statistic::none: return {};
    case Statistic::deviation: return "a standard deviation";
    case Statistic::standard_error: return "a standard error";
    case Statistic::uncertainty: return "an uncertainty";
    case Statistic::maximum: return "a maximum";
    case Statistic::minimum: return "a minimum";
    case Statistic::range: return "a range between extremes";
    case Statistic::mid_range: return "a middle between extremes";
    case Statistic::variance: return "a variance";
    case Statistic::sum: return "a sum";
    case Statistic::root_mean_square: return "a root mean square";
    case Statistic::mean_of_sizes: return "a mean of absolute values";
    case Statistic::percentile: return "a percentile";
    case Statistic::anomaly: return "an anomaly";
    case Statistic::bias: return "a bias";
    case Statistic::trend: return "a trend";
    case Statistic::gust: return "a gust";
    case Statistic::flag: return "a quality flag";
    case Statistic::count: return "a number of observations";
    case Statistic::detection_limit: return "a limit of detection";
  }
  return {};
}

Statistic statistic_in_name(std::string_view name) {
  const std::vector<std::string> parts = parts_of_name(name);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool minutes = parts[i] == "min" && i > 0 && is_digits(parts[i - 1]);
    if (minutes || (i + 1 < parts.size() && undoes(parts[i + 1]))) continue;
    if (const Statistic found = find_whole(name_parts, parts[i]); found != Statistic::none) return found;
    if (parts[i] == "var" && i > 0 && i + 1 == parts.size()) return Statistic::variance;
    for (const auto& [end, statistic] : name_ends)
      if (parts[i].ends_with(end)) return statistic;
  }
  return Statistic::none;
}

Statistic statistic_in_words(std::string_view text) {
  const std::string plain = lower(text);
  for (const auto& [phrase, statistic] : phrases)
    if (plain.find(phrase) != std::string::npos) return statistic;
  const std::vector<std::string> words = words_of(plain);
  if (words.empty() || std::ranges::any_of(words, undoes)) return Statistic::none;
  if (const Statistic found = find_whole(outer_words, words.front()); found != Statistic::none) return found;
  return words.size() > 1 ? find_whole(outer_words, words.back()) : Statistic::none;
}

Statistic statistic_of(const NetcdfVariable& variable) {
  for (const Statistic found :
       {statistic_in_standard_name(variable), statistic_in_cell_methods(variable),
        statistic_in_name(variable.name()), statistic_in_words(variable.attribute("long_name"))})
    if (found != Statistic::none) return found;
  return Statistic::none;
}

std::vector<std::string> parts_of_name(std::string_view name) {
  std::vector<std::string> parts;
  std::string part;
  for (const char c : lower(name)) {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
      part += c;
      continue;
    }
    if (!part.empty()) parts.push_back(std::move(part));
    part.clear();
  }
  if (!part.empty()) parts.push_back(std::move(part));
  return parts;
}

}  // namespace floeplan::ingest
