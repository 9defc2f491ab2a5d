#pragma once

#include <optional>
#include <tl/expected.hpp>
#include <vector>

#include "engine/motion/edge_closed.hpp"
#include "engine/motion/edge_time.hpp"
#include "engine/planning/cost/overhead.hpp"

namespace floeplan::planning::cost {

/// Watches a drive for ice above it. Closes it where there is no room below the ice, and where the last
/// possible surfacing is too long ago. Called with each piece of an edge in order.
/// Accuracy  the ice is checked every `Overhead::look()` metres. The time between two checks counts as time
///           without surfacing unless the vehicle may surface at both. So the counted time is never too
///           short, except for ice or an iceberg narrower than that distance
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
  std::optional<ice::IceWatch> ice_{};  // set at the first piece if anything is known of ice
  double since_s_;
};

/// Watches a drive from its end backwards: the time from its beginning to the next possible surfacing. The
/// times without surfacing equal those that `SurfacingWatch` finds forwards.
class SurfacingOutlook {
 public:
  /// `overhead` and `edge` are borrowed.
  SurfacingOutlook(const Overhead& overhead, const motion::PlaneEdge& edge, core::Seconds depart);

  std::optional<motion::EdgeClosed> operator()(const motion::EdgePiece& piece);
  /// The time from the beginning of the drive to the next possible surfacing. `at_end`: that time at the end
  /// of the drive. no_surfacing: the time without surfacing exceeds the limit of the overhead.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> until_surfacing(core::Seconds at_end) const;

 private:
  struct Look {
    double time_s;
    bool may_surface;
  };

  const Overhead& overhead_;
  const motion::PlaneEdge& edge_;
  std::optional<ice::IceWatch> ice_{};  // if anything is known of ice
  std::vector<Look> looks_;             // from the beginning of the drive to its end
};

/// Time since the last possible surfacing, at the end of a hold at one place. Empty if it exceeds the limit
/// of the request during the hold. Zero without ice data or without a limit.
/// `since_surfacing`: at the beginning of the hold
/// Accuracy  the ice is checked every quarter of an hour, and at the end
[[nodiscard]] std::optional<core::Seconds> since_surfacing_after_wait(const Overhead& overhead,
                                                                      geo::PlanePoint place,
                                                                      core::Seconds from, core::Seconds until,
                                                                      core::Seconds since_surfacing);

}  // namespace floeplan::planning::cost
