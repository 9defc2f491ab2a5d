#include "storage/ingest/readers/velocity/velocity_pair.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "engine/messages/ingest_velocity_messages.hpp"
#include "engine/messages/sentence.hpp"
#include "storage/ingest/formats/netcdf/variable_meaning.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/velocity/velocity_candidates.hpp"
#include "storage/ingest/readers/velocity/velocity_hints.hpp"
#include "storage/ingest/readers/velocity/velocity_names.hpp"

namespace floeplan::ingest {
namespace {

NetcdfFiles borrowed(const NetcdfFile& file) { return {{std::shared_ptr<const NetcdfFile>{}, &file}}; }

/// The best pair or single component of one file; not yet checked.
std::optional<CandidatePair> best_of(const std::vector<VelocityCandidate>& candidates,
                                     const WantedVariables& wanted) {
  const auto pairs = pairs_to_store(candidates, wanted_names(wanted));
  if (pairs.empty()) return std::nullopt;
  return pairs.front();
}

/// The content of a variable that is not stored, in words; empty if it could be stored.
std::string left_out_words(const VelocityMeaning& meaning, Moving what) {
  if (!meaning.instead.empty()) return meaning.instead;
  if (what == Moving::sea && meaning.part == WaterPart::bed) return "the current at the sea bed";
  return meaning.on_request ? content_words(meaning.content) : std::string{};
}

/// A message with all variables that cannot be stored, grouped by their content: `"uo_std" and "vo_std" hold
/// a standard deviation; ...`.
std::optional<messages::Message> left_out(const std::vector<VelocityCandidate>& candidates, Moving what) {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;
  std::string on_request;
  for (const VelocityCandidate& candidate : candidates) {
    const std::string words = left_out_words(candidate.meaning, what);
    if (words.empty()) continue;
    const std::string name = "\"" + candidate.variable->name() + "\"";
    const auto group = std::ranges::find(groups, words, &decltype(groups)::value_type::first);
    if (group == groups.end()) {
      groups.push_back({words, {name}});
    } else {
      group->second.push_back(name);
    }
    const bool is_part = candidate.meaning.instead.empty() && candidate.meaning.part != WaterPart::bed;
    if (is_part && on_request.empty()) on_request = candidate.variable->name();
  }
  if (groups.empty()) return std::nullopt;
  std::string text;
  for (const auto& [words, names] : groups)
    text +=
        (text.empty() ? "" : ", ") + enumeration(names) + (names.size() > 1 ? " hold " : " holds ") + words;
  if (what == Moving::air) return messages::ingest_velocity_message<"not-the-wind">(text);
  return messages::ingest_velocity_message<"not-the-current">(
      text,
      on_request.empty() ? "" : ", or store a part of the current on its own with --variable " + on_request);
}

/// The fault if two variables are a pair by their names, but the same component by their standard names.
std::optional<messages::Message> both_the_same(const std::vector<CandidatePair>& pairs) {
  for (const CandidatePair& a : pairs)
    for (const CandidatePair& b : pairs)
      if (a.first != b.first && a.second == nullptr && b.second == nullptr &&
          name_one_pair(a.first->variable->name(), b.first->variable->name()))
        return messages::ingest_velocity_message<"same-component-twice">(
            a.first->variable->name(), b.first->variable->name(),
            a.meaning().component == Component::first ? "eastward" : "northward");
  return std::nullopt;
}

messages::Message described_differently(const CandidatePair& pair, const std::string& how,
                                        const std::string& consequence) {
  return messages::ingest_velocity_message<"components-described-differently">(pair.names(), how,
                                                                               consequence);
}

/// Whether the names of the two remaining components show that each belongs to another pair: "uo_a" and
/// "vo_b".
bool belong_to_others(const CandidatePair& pair) {
  const std::string& first = pair.first->variable->name();
  const std::string& second = pair.second->variable->name();
  return component_in_name(first) && component_in_name(second) && !name_one_pair(first, second);
}

/// Why a pair cannot be used although it has both components.
std::optional<messages::Message> fault_of(const CandidatePair& pair, const std::vector<std::string>& wanted) {
  if (belong_to_others(pair) && !(is_wanted(*pair.first, wanted) && is_wanted(*pair.second, wanted)))
    return messages::ingest_velocity_message<"components-do-not-belong">(pair.names());
  const VelocityMeaning& first = pair.first->meaning;
  const VelocityMeaning& second = pair.second->meaning;
  for (const VelocityMeaning* meaning : {&first, &second})
    if (meaning->contradiction) return meaning->contradiction;
  if (first.axes != second.axes)
    return described_differently(pair, "one along the model's grid, the other not",
                                 "the drift would be turned");
  const std::string no_current = "they would make a current that never ran";
  if (first.content != second.content)
    return described_differently(
        pair, "one as " + content_words(first.content) + ", the other as " + content_words(second.content),
        no_current);
  if (first.part != second.part || first.depth_m != second.depth_m)
    return described_differently(pair, "not of the same depth", no_current);
  return std::nullopt;
}

messages::Message one_component_alone(const CandidatePair& pair,
                                      const std::vector<VelocityCandidate>& candidates, Moving what) {
  const std::string& name = pair.first->variable->name();
  const bool first = pair.meaning().component == Component::first;
  std::optional<messages::Message> others = left_out(candidates, what);
  const std::string advice = others ? messages::whole_text(*others)
                             : what == Moving::sea
                                 ? "Give the file of the other component in the same command"
                                 : "Merge both components into one file";
  return messages::ingest_velocity_message<"component-missing">(
      what == Moving::sea ? "current" : "wind", name, first ? "northward" : "eastward", advice);
}

messages::Message nothing_to_store(const std::vector<VelocityCandidate>& candidates, Moving what) {
  if (auto others = left_out(candidates, what)) return std::move(*others);
  return what == Moving::sea ? messages::ingest_velocity_message<"velocity-not-found">()
                             : messages::ingest_velocity_message<"wind-not-found">();
}

void warn_of_content(const CandidatePair& pair, Messages& warnings) {
  const NetcdfVariable& first = *pair.first->variable;
  const std::string words = lower(first.name() + " " + first.attribute("long_name"));
  switch (pair.meaning().content) {
    case CurrentContent::whole: break;
    case CurrentContent::total: {
      const bool both = contains_any(words, {"utotal"});
      const bool waves = both || contains_any(words, {"wave", "stokes"});
      const bool tide = both || !waves || contains_any(words, {"tide", "tidal"});
      warnings.push_back(messages::ingest_velocity_message<"currents-hold-the-tide">(
          std::string{tide ? "the tide" : ""} + (tide && waves ? " and " : "") +
              (waves ? "the drift by waves" : ""),
          tide ? "; add no tide to them" : ""));
      break;
    }
    case CurrentContent::without_tide:
      warnings.push_back(messages::ingest_velocity_message<"currents-without-the-tide">());
      break;
    case CurrentContent::geostrophic:
      warnings.push_back(messages::ingest_velocity_message<"geostrophic-currents">());
      break;
    case CurrentContent::tide:
    case CurrentContent::wave_drift:
    case CurrentContent::other_part:
      warnings.push_back(messages::ingest_velocity_message<"part-of-the-current">(
          pair.names(), content_words(pair.meaning().content),
          pair.meaning().on_request ? "as --variable asks for" : "as their long names say"));
      break;
  }
}

/// Warns of other pairs that could be chosen, except the same currents at fewer depths or along other axes.
void warn_of_others(const std::vector<CandidatePair>& pairs, Moving what, Messages& warnings) {
  const CandidatePair& taken = pairs.front();
  std::string others;
  for (const CandidatePair& pair : pairs) {
    const bool same = pair.first == taken.first || pair.second == nullptr;
    const bool fewer_depths =
        taken.meaning().part == WaterPart::unstated && pair.meaning().part != WaterPart::unstated;
    const bool lesser = pair.meaning().content == taken.meaning().content &&
                        (fewer_depths || pair.meaning().axes != taken.meaning().axes);
    if (same || lesser) continue;
    others += (others.empty() ? "" : ", ") + pair.names();
    if (what == Moving::sea) others += " (" + content_words(pair.meaning().content) + ")";
  }
  if (others.empty()) return;
  warnings.push_back(messages::ingest_velocity_message<"one-pair-of-several">(
      taken.names(), others,
      what == Moving::sea ? "; name one component with --variable to store its pair instead" : ""));
}

void warn_of_meaning(const CandidatePair& pair, Moving what, Messages& warnings) {
  for (const VelocityCandidate* candidate : {pair.first, pair.second})
    if (candidate->meaning.remark) warnings.push_back(*candidate->meaning.remark);
  const NetcdfVariable& first = *pair.first->variable;
  for (const CellMethod& cell : cell_methods_of(first))
    if (cell.where.size() > 1 && cell.where[0] == "over" && cell.where[1] == "years")
      warnings.push_back(messages::ingest_velocity_message<"climatology">(pair.names()));
  if (what == Moving::sea && first.attribute("standard_name").empty() && first.attribute("long_name").empty())
    warnings.push_back(messages::ingest_velocity_message<"taken-as-currents-by-name">(pair.names()));
}

/// The fault if several pairs have the same rank.
std::optional<messages::Message> ambiguity(const std::vector<CandidatePair>& pairs, Moving what) {
  std::vector<std::string> names;
  for (const CandidatePair& pair : pairs)
    if (are_of_one_rank(pair, pairs.front())) names.push_back(pair.names());
  if (names.size() < 2) return std::nullopt;
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", or ") + name;
  return messages::ingest_velocity_message<"several-pairs">(
      list, what == Moving::sea ? "Name one component with --variable, for example --variable " +
                                      pairs.front().first->variable->name()
                                : "Give a file with one of them");
}

}  // namespace

bool holds_velocity(const NetcdfFile& file, Moving what, const WantedVariables& wanted) {
  const auto candidates = velocity_candidates(borrowed(file), what);
  return best_of(candidates, wanted).has_value();
}

bool names_velocity(const NetcdfFile& file, const WantedVariables& wanted) {
  const auto names = wanted_names(wanted);
  return std::ranges::any_of(velocity_candidates(borrowed(file), Moving::sea),
                             [&](const VelocityCandidate& candidate) { return is_wanted(candidate, names); });
}

VelocityParts velocity_parts(const NetcdfFile& file) {
  const auto candidates = velocity_candidates(borrowed(file), Moving::sea);
  const auto pair = best_of(candidates, std::nullopt);
  if (!pair) return VelocityParts::none;
  if (pair->second != nullptr) return VelocityParts::both;
  return pair->meaning().component == Component::first ? VelocityParts::first_alone
                                                       : VelocityParts::second_alone;
}

const NetcdfVariable* find_some_velocity(const NetcdfFile& file) {
  const auto candidates = velocity_candidates(borrowed(file), Moving::sea);
  const auto pair = best_of(candidates, std::nullopt);
  return pair ? pair->first->variable : nullptr;
}

std::optional<messages::Message> velocities_left_out(const NetcdfFile& file, Moving what) {
  return left_out(velocity_candidates(borrowed(file), what), what);
}

Checked<VelocityPair> find_velocity_pair(const NetcdfFiles& files, Moving what,
                                         const WantedVariables& wanted) {
  const auto candidates = velocity_candidates(files, what);
  const std::vector<std::string> names = wanted_names(wanted);
  const auto pairs = pairs_to_store(candidates, names);
  if (pairs.empty()) return refuse(nothing_to_store(candidates, what));
  const CandidatePair& best = pairs.front();
  if (best.second == nullptr) {
    if (auto same = both_the_same(pairs)) return refuse(std::move(*same));
    if (best.meaning().contradiction) return refuse(*best.meaning().contradiction);
    return refuse(one_component_alone(best, candidates, what));
  }
  if (auto unclear = ambiguity(pairs, what)) return refuse(std::move(*unclear));
  if (auto fault = fault_of(best, names)) return refuse(std::move(*fault));

  VelocityPair pair{.first = best.first->variable,
                    .second = best.second->variable,
                    .first_file = best.first->file,
                    .second_file = best.second->file,
                    .what = what,
                    .axes = best.meaning().axes,
                    .part = best.meaning().part,
                    .depth_m = best.meaning().depth_m,
                    .warnings = {}};
  warn_of_meaning(best, what, pair.warnings);
  if (auto doubt =
          doubt_in_title(pair.first_file->attribute("title"), best.names(), what, best.meaning().content))
    pair.warnings.push_back(std::move(*doubt));
  if (what == Moving::sea) warn_of_content(best, pair.warnings);
  // Also names parts that are stored only on request.
  std::vector<const VelocityCandidate*> all;
  for (const VelocityCandidate& candidate : candidates)
    if (candidate.meaning.instead.empty() && candidate.meaning.part != WaterPart::bed)
      all.push_back(&candidate);
  std::vector<CandidatePair> told{best};
  for (const CandidatePair& other : pairs_of(all))
    if (other.first != best.first) told.push_back(other);
  warn_of_others(told, what, pair.warnings);
  return pair;
}

}  // namespace floeplan::ingest
