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

/// A variable that claims to be a component of a velocity.
struct VelocityCandidate {
  const NetcdfVariable* variable{nullptr};
  const NetcdfFile* file{nullptr};
  VelocityMeaning meaning;
};

/// Two components that belong together, or one that stands alone.
struct CandidatePair {
  const VelocityCandidate* first{nullptr};
  const VelocityCandidate* second{nullptr};  // null: alone

  [[nodiscard]] const VelocityMeaning& meaning() const { return first->meaning; }
  /// `"uo" and "vo"`, of a pair.
  [[nodiscard]] std::string names() const {
    return "\"" + first->variable->name() + "\" and \"" + second->variable->name() + "\"";
  }
};

/// Everything in the files that claims to be a component, in their order.
[[nodiscard]] std::vector<VelocityCandidate> velocity_candidates(const NetcdfFiles& files, Moving what);

/// The names that the user wants.
[[nodiscard]] std::vector<std::string> wanted_names(const WantedVariables& wanted);
[[nodiscard]] bool is_wanted(const VelocityCandidate& candidate, const std::vector<std::string>& wanted);

/// Whether it is a part of the current, and less worth than any whole one.
[[nodiscard]] bool is_part_alone(const VelocityMeaning& meaning);

/// Puts components together: by their names, and where these tell nothing the only two of a kind.
[[nodiscard]] std::vector<CandidatePair> pairs_of(const std::vector<const VelocityCandidate*>& candidates);

/// All that can be stored, the best first.
[[nodiscard]] std::vector<CandidatePair> pairs_to_store(const std::vector<VelocityCandidate>& candidates,
                                                        const std::vector<std::string>& wanted);

/// Whether nothing decides which of two pairs is taken first.
[[nodiscard]] bool are_of_one_rank(const CandidatePair& a, const CandidatePair& b);

}  // namespace floeplan::ingest
