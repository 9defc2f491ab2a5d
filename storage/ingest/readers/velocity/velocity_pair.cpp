#include "storage/ingest/readers/velocity/velocity_pair.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "storage/ingest/formats/netcdf/variable_meaning.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/velocity/velocity_candidates.hpp"
#include "storage/ingest/readers/velocity/velocity_hints.hpp"
#include "storage/ingest/readers/velocity/velocity_names.hpp"

namespace floeplan::ingest {
namespace {

NetcdfFiles borrowed(const NetcdfFile& file) { return {{std::shared_ptr<const NetcdfFile>{}, &file}}; }

/// The best of one file, not yet checked.
std::optional<CandidatePair> best_of(const std::vector<VelocityCandidate>& candidates,
                                     const WantedVariables& wanted) {
  const auto pairs = pairs_to_store(candidates, wanted_names(wanted));
  if (pairs.empty()) return std::nullopt;
  return pairs.front();
}

/// What a variable that is not stored holds; empty: it could be stored.
std::string left_out_words(const VelocityMeaning& meaning, Moving what) {
  if (!meaning.instead.empty()) return meaning.instead;
  if (what == Moving::sea && meaning.part == WaterPart::bed) return "the current at the sea bed";
  return meaning.on_request ? content_words(meaning.content) : std::string{};
}

/// `"uo_std" and "vo_std" hold a standard deviation; ...`: of all that cannot be stored, by what it is.
std::string left_out(const std::vector<VelocityCandidate>& candidates, Moving what) {
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
  if (groups.empty()) return {};
  std::string text;
  for (const auto& [words, names] : groups)
    text +=
        (text.empty() ? "" : ", ") + enumeration(names) + (names.size() > 1 ? " hold " : " holds ") + words;
  text += what == Moving::sea
              ? "; this is not the current that a vehicle meets; give the file of the current itself"
              : "; this is not the wind 10 m above the sea, which moves icebergs; give the file of that wind";
  if (!on_request.empty())
    text += ", or store a part of the current on its own with --variable " + on_request;
  return text;
}

/// Files whose components say one thing by their names and another by their standard names.
std::string both_the_same(const std::vector<CandidatePair>& pairs) {
  for (const CandidatePair& a : pairs)
    for (const CandidatePair& b : pairs)
      if (a.first != b.first && a.second == nullptr && b.second == nullptr &&
          name_one_pair(a.first->variable->name(), b.first->variable->name()))
        return "\"" + a.first->variable->name() + "\" and \"" + b.first->variable->name() +
               "\" both say that they are the " +
               (a.meaning().component == Component::first ? "eastward" : "northward") +
               " component; which of them is the other one is not known, and a wrong guess would turn the "
               "drift; "
               "correct the attributes of the one that is wrong";
  return {};
}

std::string described_differently(const CandidatePair& pair, const std::string& how,
                                  const std::string& consequence) {
  return "the components " + pair.names() + " are described differently: " + how + "; used together, " +
         consequence + "; ask the producer for a file that describes both";
}

/// Two that are the only ones left although their names say that each belongs to another: "uo_a" and "vo_b".
bool belong_to_others(const CandidatePair& pair) {
  const std::string& first = pair.first->variable->name();
  const std::string& second = pair.second->variable->name();
  return component_in_name(first) && component_in_name(second) && !name_one_pair(first, second);
}

/// Why a pair cannot be used although both components are there.
std::optional<std::string> fault_of(const CandidatePair& pair, const std::vector<std::string>& wanted) {
  if (belong_to_others(pair) && !(is_wanted(*pair.first, wanted) && is_wanted(*pair.second, wanted)))
    return "the components " + pair.names() +
           " do not belong together by their names, and the file holds no others; a pair of two models or "
           "times "
           "is no current; name both with --variable, with a comma between, if they are one pair all the "
           "same";
  const VelocityMeaning& first = pair.first->meaning;
  const VelocityMeaning& second = pair.second->meaning;
  for (const VelocityMeaning* meaning : {&first, &second})
    if (!meaning->contradiction.empty()) return meaning->contradiction;
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

std::string one_component_alone(const CandidatePair& pair, const std::vector<VelocityCandidate>& candidates,
                                Moving what) {
  const std::string& name = pair.first->variable->name();
  const bool first = pair.meaning().component == Component::first;
  const std::string others = left_out(candidates, what);
  return "the file holds only one component of the " + std::string{what == Moving::sea ? "current" : "wind"} +
         " (\"" + name + "\"); the " + (first ? "northward" : "eastward") + " one is missing; " +
         (!others.empty()       ? others
          : what == Moving::sea ? "give the file of the other component in the same command"
                                : "merge both components into one file");
}

std::string nothing_to_store(const std::vector<VelocityCandidate>& candidates, Moving what) {
  if (const std::string others = left_out(candidates, what); !others.empty()) return others;
  return what == Moving::sea
             ? "the file holds no velocity of sea water; there are no currents to store; give a "
               "file with, for example, the variables uo and vo"
             : "the file holds no wind near the sea; there is nothing to store; give a file "
               "with, for example, the variables u10 and v10";
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
      warnings.push_back(remark(std::string{"these currents already hold "} + (tide ? "the tide" : "") +
                                (tide && waves ? " and " : "") + (waves ? "the drift by waves" : "") +
                                (tide ? "; add no tide to them" : "")));
      break;
    }
    case CurrentContent::without_tide:
      warnings.push_back(remark("these currents are without the tide; add it from a dataset of tides"));
      break;
    case CurrentContent::geostrophic:
      warnings.push_back(remark(
          "these are geostrophic currents from sea level: no tide, no wind drift, near the surface only"));
      break;
    case CurrentContent::tide:
    case CurrentContent::wave_drift:
    case CurrentContent::other_part:
      warnings.push_back(
          remark(pair.names() + " hold " + content_words(pair.meaning().content) +
                 (pair.meaning().on_request ? ", as --variable asks for" : ", as their long names say") +
                 "; a plan in them leaves out the rest of the current"));
      break;
  }
}

/// What else could have been taken. Not the same currents at fewer depths or along other axes.
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
  warnings.push_back(remark(
      "of several pairs of components " + taken.names() + " were stored; the file also holds " + others +
      (what == Moving::sea ? "; name one component with --variable to store its pair instead" : "")));
}

void warn_of_meaning(const CandidatePair& pair, Moving what, Messages& warnings) {
  for (const VelocityCandidate* candidate : {pair.first, pair.second})
    if (!candidate->meaning.remark.empty()) warnings.push_back(remark(candidate->meaning.remark));
  const NetcdfVariable& first = *pair.first->variable;
  for (const CellMethod& cell : cell_methods_of(first))
    if (cell.where.size() > 1 && cell.where[0] == "over" && cell.where[1] == "years")
      warnings.push_back(
          remark(pair.names() +
                 " are means over many years (a climatology); at no single time is the sea like that"));
  if (what == Moving::sea && first.attribute("standard_name").empty() && first.attribute("long_name").empty())
    warnings.push_back(remark("the variables " + pair.names() +
                              " do not describe themselves; taken as currents by their names"));
}

/// Pairs that are equal in all that decides.
std::optional<std::string> ambiguity(const std::vector<CandidatePair>& pairs, Moving what) {
  std::vector<std::string> names;
  for (const CandidatePair& pair : pairs)
    if (are_of_one_rank(pair, pairs.front())) names.push_back(pair.names());
  if (names.size() < 2) return std::nullopt;
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", or ") + name;
  return "the file holds several pairs of components, " + list + "; which of them is meant is not known; " +
         (what == Moving::sea ? "name one component with --variable, for example --variable " +
                                    pairs.front().first->variable->name()
                              : "give a file with one of them");
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

std::string velocities_left_out(const NetcdfFile& file, Moving what) {
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
    if (std::string same = both_the_same(pairs); !same.empty()) return refuse(std::move(same));
    if (!best.meaning().contradiction.empty()) return refuse(best.meaning().contradiction);
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
          doubt_in_title(pair.first_file->attribute("title"), best.names(), what, best.meaning().content);
      !doubt.empty())
    pair.warnings.push_back(remark(std::move(doubt)));
  if (what == Moving::sea) warn_of_content(best, pair.warnings);
  // Parts that are stored on request alone are told, too.
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
