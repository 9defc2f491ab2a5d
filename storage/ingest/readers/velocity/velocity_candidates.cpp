#include "storage/ingest/readers/velocity/velocity_candidates.hpp"

#include <algorithm>
#include <utility>

#include "storage/ingest/formats/netcdf/netcdf_coordinates.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/velocity/velocity_names.hpp"

namespace floeplan::ingest {
namespace {

bool has_levels(const NetcdfFile& file, const NetcdfVariable& variable) {
  return std::ranges::any_of(variable.dimensions(), [&](const NetcdfDimension& dimension) {
    const NetcdfVariable* coordinate = coordinate_of(file, dimension);
    const AxisRole role = coordinate == nullptr ? AxisRole::unknown : role_of(*coordinate);
    return role == AxisRole::depth || role == AxisRole::model_level || role == AxisRole::other_level ||
           contains_any(lower(dimension.name), {"s_rho", "siglay", "sigma", "layer", "depth", "lev"});
  });
}

bool can_be_stored(const VelocityCandidate& candidate, const std::vector<std::string>& wanted) {
  const VelocityMeaning& meaning = candidate.meaning;
  if (!meaning.instead.empty() || meaning.part == WaterPart::bed) return false;
  return !meaning.on_request || !wanted.empty();
}

/// Sort key of a pair; a smaller one is preferred. Pairs with equal keys are ambiguous.
auto order_of(const CandidatePair& pair) {
  const VelocityMeaning& meaning = pair.meaning();
  const int alone = pair.second == nullptr ? 1 : 0;
  const int content = is_part_alone(meaning) ? 2 : meaning.content == CurrentContent::geostrophic ? 1 : 0;
  const int axes = meaning.axes == VelocityAxes::east_north ? 0 : meaning.axes == VelocityAxes::grid ? 2 : 1;
  return std::tuple{alone,
                    content,
                    static_cast<int>(meaning.part),
                    meaning.at_10_m ? 0 : 1,
                    meaning.rank,
                    static_cast<int>(meaning.content),
                    axes};
}

}  // namespace

std::vector<VelocityCandidate> velocity_candidates(const NetcdfFiles& files, Moving what) {
  std::vector<VelocityCandidate> found;
  for (const auto& file : files) {
    for (const NetcdfVariable& variable : file->variables()) {
      auto meaning = velocity_meaning(variable, what);
      if (!meaning) continue;
      if (has_levels(*file, variable)) {  // levels are better evidence than words
        if (meaning->part != WaterPart::bed) meaning->part = WaterPart::unstated;
        meaning->depth_m = std::nullopt;
      }
      found.push_back({&variable, file.get(), std::move(*meaning)});
    }
  }
  return found;
}

std::vector<std::string> wanted_names(const WantedVariables& wanted) {
  std::vector<std::string> names;
  if (!wanted) return names;
  std::string name;
  for (const char c : *wanted + ",") {
    if (c != ',') {
      name += c;
      continue;
    }
    if (!trimmed(name).empty()) names.push_back(trimmed(name));
    name.clear();
  }
  return names;
}

bool is_wanted(const VelocityCandidate& candidate, const std::vector<std::string>& wanted) {
  return std::ranges::find(wanted, candidate.variable->name()) != wanted.end();
}

bool is_part_alone(const VelocityMeaning& meaning) {
  return meaning.content == CurrentContent::tide || meaning.content == CurrentContent::wave_drift ||
         meaning.content == CurrentContent::other_part;
}

std::vector<CandidatePair> pairs_of(const std::vector<const VelocityCandidate*>& candidates) {
  std::vector<const VelocityCandidate*> firsts;
  std::vector<const VelocityCandidate*> seconds;
  for (const VelocityCandidate* candidate : candidates)
    (candidate->meaning.component == Component::first ? firsts : seconds).push_back(candidate);

  std::vector<CandidatePair> pairs;
  const auto join = [&](const VelocityCandidate* first, auto second) {
    pairs.push_back({first, *second});
    seconds.erase(second);
  };
  std::vector<const VelocityCandidate*> left;
  for (const VelocityCandidate* first : firsts) {
    const auto second = std::ranges::find_if(seconds, [&](const VelocityCandidate* other) {
      return name_one_pair(first->variable->name(), other->variable->name());
    });
    if (second == seconds.end()) {
      left.push_back(first);
    } else {
      join(first, second);
    }
  }
  const auto is_like = [](const VelocityCandidate* a) {
    return [a](const VelocityCandidate* b) {
      return a->meaning.content == b->meaning.content && a->meaning.part == b->meaning.part &&
             a->meaning.depth_m == b->meaning.depth_m;
    };
  };
  for (const VelocityCandidate* first : left) {
    const bool only = std::ranges::count_if(left, is_like(first)) == 1 &&
                      std::ranges::count_if(seconds, is_like(first)) == 1;
    if (only)
      join(first, std::ranges::find_if(seconds, is_like(first)));
    else
      pairs.push_back({first, nullptr});
  }
  for (const VelocityCandidate* second : seconds) pairs.push_back({second, nullptr});
  return pairs;
}

std::vector<CandidatePair> pairs_to_store(const std::vector<VelocityCandidate>& candidates,
                                          const std::vector<std::string>& wanted) {
  std::vector<const VelocityCandidate*> usable;
  const bool wants_some =
      std::ranges::any_of(candidates, [&](const auto& candidate) { return is_wanted(candidate, wanted); });
  for (const VelocityCandidate& candidate : candidates)
    if (can_be_stored(candidate, wants_some ? wanted : std::vector<std::string>{}))
      usable.push_back(&candidate);
  std::vector<CandidatePair> pairs = pairs_of(usable);
  if (wants_some)
    std::erase_if(pairs, [&](const CandidatePair& pair) {
      return !is_wanted(*pair.first, wanted) && !(pair.second != nullptr && is_wanted(*pair.second, wanted));
    });
  std::ranges::stable_sort(pairs, {}, order_of);
  return pairs;
}

bool are_of_one_rank(const CandidatePair& a, const CandidatePair& b) { return order_of(a) == order_of(b); }

}  // namespace floeplan::ingest
