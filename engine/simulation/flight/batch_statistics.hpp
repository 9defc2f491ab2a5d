#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "engine/simulation/flight/flight_record.hpp"

namespace floeplan::simulation {

/// Key figures of one flight.
struct RunSummary {
  std::uint64_t seed{};
  FlightEnd end{};
  core::Seconds travel_time{};      // to the end of the flight, whatever it was
  double final_position_error_m{};  // at the end, horizontal, from the true to the believed place
  double worst_position_error_m{};  // the largest such distance on the track
  std::optional<double>
      clearance_m;  // the least of all closest approaches; empty if nothing was ever within reach
  core::Joules energy{};
  double distance_m{};
  std::string why;  // not arrived, for a person: the reason, and the last action of the avoidance
  std::optional<bool>
      could_be_saved;  // by full knowledge; only if a flight with onboard avoidance touched something

  friend bool operator==(const RunSummary&, const RunSummary&) = default;
  /// For core::packed.
  friend auto members_of(RunSummary& run) {
    auto& [seed, end, travel_time, final_error, worst_error, clearance, energy, distance, why,
           could_be_saved] = run;
    return std::tie(seed, end, travel_time, final_error, worst_error, clearance, energy, distance, why,
                    could_be_saved);
  }
};

/// All figures except `could_be_saved`, which needs the world.
[[nodiscard]] RunSummary summary_of(const FlightRecord& record);

/// An interval that contains the true value with a probability of 95 %.
struct Interval {
  double low{};
  double high{};

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// Distribution of a quantity over the runs that have it.
struct Distribution {
  struct Quantile {
    double share{};  // share of the runs below the value
    double value{};
    std::optional<Interval> interval;  // empty if there are too few runs
  };
  std::size_t runs{};
  double mean{};
  std::optional<Interval> mean_interval;     // empty for a single run
  std::optional<double> standard_deviation;  // empty for a single run
  std::vector<Quantile> quantiles;           // 5, 25, 50, 75 and 95 %
  double least{};
  double most{};
};

/// The distribution of the values; empty for no values.
/// Quantile between the two values next to share * (n - 1), linearly (type 7 of Hyndman and Fan 1996, Am.
/// Stat. 50) Interval of a quantile: order statistics by the binomial distribution, valid for any
/// distribution (David and Nagaraja 2003, Order statistics, 3rd ed., section 7.1); of the mean: Student's t,
/// by the expansion of Abramowitz and Stegun 1964, 26.7.5, cut off at 0 if no value is negative, as of distances
[[nodiscard]] std::optional<Distribution> distribution_of(std::vector<double> values);

/// Share of the runs with a property.
struct Share {
  std::size_t runs{};
  double share{};
  Interval interval{};  // Wilson 1927, J. Am. Stat. Assoc. 22
};

[[nodiscard]] Share share_of(std::size_t runs, std::size_t all);

/// Statistics of a batch of runs.
struct BatchStatistics {
  struct End {
    FlightEnd end{};
    Share share{};
  };
  std::size_t runs{};
  std::vector<End> ends;                               // kinds that occurred, in the order of FlightEnd
  std::optional<Distribution> travel_time_s;           // of the runs that arrived
  std::optional<Distribution> final_position_error_m;  // of all
  std::optional<Distribution> worst_position_error_m;
  std::optional<Distribution> clearance_m;
  std::optional<Distribution> energy_j;  // of the runs that arrived
};

[[nodiscard]] BatchStatistics statistics_of(std::span<const RunSummary> runs);

}  // namespace floeplan::simulation
