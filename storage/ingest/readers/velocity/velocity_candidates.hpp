#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/readers/velocity/velocity_kind.hpp"
#include "storage/ingest/readers/velocity/velocity_meaning.hpp"

namespace floeplan::ingest {

/// A variable that seems to be a component of a velocity.
struct VelocityCandidate {
  const NetcdfVariable* variable{nullptr};
  const NetcdfFile* file{nullptr};
  VelocityMeaning meaning;
};

/// Two components that belong together, or a single one.
struct CandidatePair {
  const VelocityCandidate* first{nullptr};
  const VelocityCandidate* second{nullptr};  // null: a single component

  [[nodiscard]] const VelocityMeaning& meaning() const { return first->meaning; }
  /// The names of both components: `"uo" and "vo"`. Precondition: a pair.
  [[nodiscard]] std::string names() const {
    return "\"" + first->variable->name() + "\" and \"" + second->variable->name() + "\"";
  }
};

/// All variables of the files that seem to be components, in the files' order.
[[nodiscard]] std::vector<VelocityCandidate> velocity_candidates(const NetcdfFiles& files, Moving what);

/// The names of variables in the user's request.
[[nodiscard]] std::vector<std::string> wanted_names(const WantedVariables& wanted);
[[nodiscard]] bool is_wanted(const VelocityCandidate& candidate, const std::vector<std::string>& wanted);

/// Whether a variable is only a part of the current, so that any whole current is preferred.
[[nodiscard]] bool is_part_alone(const VelocityMeaning& meaning);

/// Joins components to pairs: by their names, or, if the names do not tell, the only two of a kind.
[[nodiscard]] std::vector<CandidatePair> pairs_of(const std::vector<const VelocityCandidate*>& candidates);

/// All pairs and single components that can be stored, best first.
[[nodiscard]] std::vector<CandidatePair> pairs_to_store(const std::vector<VelocityCandidate>& candidates,
                                                        const std::vector<std::string>& wanted);

/// Whether two pairs have the same rank, so that neither is preferred.
[[nodiscard]] bool are_of_one_rank(const CandidatePair& a, const CandidatePair& b);

}  // namespace floeplan::ingest
