#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/simulation/flight/flight_record.hpp"

namespace floeplan::simulation {

/// A flight in a few numbers.
struct RunSummary {
  std::uint64_t seed{};
  FlightEnd end{};
  core::Seconds travel_time{};  // until the end, whatever it was
  double
      final_position_error_m{};  // between where the vehicle is and where it believes to be, horizontally, at the end
  double worst_position_error_m{};  // the same, the worst of the track
  std::optional<double>
      clearance_m;  // the least of all approaches; empty where there was nothing to come near to
  core::Joules energy{};
  double distance_m{};
  std::string why;  // it did not arrive, for a person: the reason, and what the system on board did last
  std::optional<bool>
      could_be_saved;  // by full knowledge; of flights with that system that touched something

  friend bool operator==(const RunSummary&, const RunSummary&) = default;
};

/// All but `could_be_saved`, which takes the world.
[[nodiscard]] RunSummary summary_of(const FlightRecord& record);

/// An interval that holds the true value with a probability of 95 %.
struct Interval {
  double low{};
  double high{};

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// How a quantity is spread over the runs that have it.
struct Distribution {
  struct Quantile {
    double share{};  // of the runs below it
    double value{};
    std::optional<Interval> interval;  // empty where so few runs cannot hold it
  };
  std::size_t runs{};
  double mean{};
  std::optional<Interval> mean_interval;     // empty for a single run
  std::optional<double> standard_deviation;  // the same
  std::vector<Quantile> quantiles;           // 5, 25, 50, 75 and 95 %
  double least{};
  double most{};
};

/// Nothing for no values.
/// Quantile between the two values next to share * (n - 1), linearly (type 7 of Hyndman and Fan 1996, Am. Stat. 50)
/// Interval of a quantile: order statistics by the binomial distribution, whatever the quantity's own is (David and
/// Nagaraja
///          2003, Order statistics, 3rd ed., section 7.1); of the mean: Student's t, by the expansion of Abramowitz and
///          Stegun 1964, 26.7.5
[[nodiscard]] std::optional<Distribution> distribution_of(std::vector<double> values);

/// A share of the runs.
struct Share {
  std::size_t runs{};
  double share{};
  Interval interval{};  // Wilson 1927, J. Am. Stat. Assoc. 22
};

[[nodiscard]] Share share_of(std::size_t runs, std::size_t all);

/// What a batch of runs tells.
struct BatchStatistics {
  struct End {
    FlightEnd end{};
    Share share{};
  };
  std::size_t runs{};
  std::vector<End> ends;                               // those that happened, in the order of FlightEnd
  std::optional<Distribution> travel_time_s;           // of the runs that arrived
  std::optional<Distribution> final_position_error_m;  // of all
  std::optional<Distribution> worst_position_error_m;
  std::optional<Distribution> clearance_m;
  std::optional<Distribution> energy_j;  // of the runs that arrived
};

[[nodiscard]] BatchStatistics statistics_of(std::span<const RunSummary> runs);

}  // namespace floeplan::simulation
