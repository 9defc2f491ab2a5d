#pragma once

#include <optional>
#include <tl/expected.hpp>
#include <vector>

#include "engine/motion/edge_closed.hpp"
#include "engine/motion/edge_time.hpp"
#include "engine/planning/cost/overhead.hpp"

namespace floeplan::planning::cost {

/// Watches a drive for what is above: closes it where there is no room below the ice, and where the last possible
/// surfacing lies too far back. A visitor of the pieces of an edge.
/// Accuracy  looked at every `look()` of the overhead; the time between two looks counts as without a surfacing
///           unless the vehicle may surface at both, so that what counts is never shorter than the truth but for ice,
///           or an iceberg, narrower than that
class SurfacingWatch {
 public:
  /// `overhead` and `edge` are borrowed.
  SurfacingWatch(const Overhead& overhead, const motion::PlaneEdge& edge, core::Seconds since_surfacing)
      : overhead_{overhead}, edge_{edge}, since_s_{since_surfacing.count()} {}

  std::optional<motion::EdgeClosed> operator()(const motion::EdgePiece& piece);
  [[nodiscard]] core::Seconds since_surfacing() const { return core::Seconds{since_s_}; }

 private:
  const Overhead& overhead_;
  const motion::PlaneEdge& edge_;
  std::optional<ice::IceWatch> ice_{};  // from the first piece on, where anything is known of ice
  double since_s_;
};

/// The same drive seen from its end: how long it is from its beginning to the next possible surfacing. Whoever goes
/// there and is watched meanwhile finds the same times without one.
class SurfacingOutlook {
 public:
  /// `overhead` and `edge` are borrowed.
  SurfacingOutlook(const Overhead& overhead, const motion::PlaneEdge& edge, core::Seconds depart);

  std::optional<motion::EdgeClosed> operator()(const motion::EdgePiece& piece);
  /// For a vehicle that may surface so long after the drive's end; no_surfacing where the time without one becomes
  /// longer than the overhead allows.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> until_surfacing(core::Seconds at_end) const;

 private:
  struct Look {
    double time_s;
    bool may_surface;
  };

  const Overhead& overhead_;
  const motion::PlaneEdge& edge_;
  std::optional<ice::IceWatch> ice_{};  // where anything is known of ice
  std::vector<Look> looks_;             // from the drive's beginning to its end
};

}  // namespace floeplan::planning::cost
