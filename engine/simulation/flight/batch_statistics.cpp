#include "engine/simulation/flight/batch_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace floeplan::simulation {
namespace {

constexpr double two_sided_95 = 1.959963984540054;  // of the standard normal distribution

double position_error_m(const TrackPoint& point) {
  return std::hypot(point.position.east - point.believed.east, point.position.north - point.believed.north);
}

/// 97.5 % quantile of Student's t distribution.
double student_t(double freedom) {
  if (freedom == 1.0) return 12.706204736;  // the expansion below needs at least two degrees
  if (freedom == 2.0) return 4.302652730;
  const double x = two_sided_95;
  const double g1 = (std::pow(x, 3) + x) / 4.0;
  const double g2 = (5.0 * std::pow(x, 5) + 16.0 * std::pow(x, 3) + 3.0 * x) / 96.0;
  const double g3 = (3.0 * std::pow(x, 7) + 19.0 * std::pow(x, 5) + 17.0 * std::pow(x, 3) - 15.0 * x) / 384.0;
  const double g4 = (79.0 * std::pow(x, 9) + 776.0 * std::pow(x, 7) + 1482.0 * std::pow(x, 5) -
                     1920.0 * std::pow(x, 3) - 945.0 * x) /
                    92160.0;
  return x + g1 / freedom + g2 / std::pow(freedom, 2) + g3 / std::pow(freedom, 3) + g4 / std::pow(freedom, 4);
}

double quantile_of(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double fraction = place - static_cast<double>(below);
  return (1.0 - fraction) * sorted[below] + fraction * sorted[above];
}

/// For every k from 0 to n: probability of at most k of n events, each with probability p.
std::vector<double> binomial_sums(std::size_t n, double p) {
  std::vector<double> sums;
  double sum = 0.0;
  double log_term = static_cast<double>(n) * std::log1p(-p);
  for (std::size_t k = 0; k <= n; ++k) {
    sum += std::exp(log_term);
    sums.push_back(sum);
    log_term += std::log(static_cast<double>(n - k) / static_cast<double>(k + 1) * p / (1.0 - p));
  }
  return sums;
}

/// Two order statistics that enclose the quantile: on either side it lies outside with at most 2.5 %
/// probability.
std::optional<Interval> quantile_interval(const std::vector<double>& sorted, double share) {
  const std::size_t n = sorted.size();
  const std::vector<double> sums = binomial_sums(n, share);
  const auto low = std::ranges::count_if(sums, [](double sum) { return sum <= 0.025; });
  const auto high = std::ranges::count_if(sums, [](double sum) { return sum < 0.975; });
  if (low < 1 || high >= std::ssize(sorted)) return std::nullopt;
  return Interval{sorted[static_cast<std::size_t>(low - 1)], sorted[static_cast<std::size_t>(high)]};
}

template <class Value, class Wanted>
std::optional<Distribution> distribution_over(std::span<const RunSummary> runs, const Value& value,
                                              const Wanted& wanted) {
  std::vector<double> values;
  for (const RunSummary& run : runs) {
    if (wanted(run)) values.push_back(value(run));
  }
  return distribution_of(std::move(values));
}

std::string why_not_there(const FlightRecord& record) {
  if (record.end == FlightEnd::arrived) return {};
  std::string why = record.end_reason;
  const auto guided = std::ranges::find(record.events.rbegin(), record.events.rend(), EventKind::guidance,
                                        &FlightEvent::kind);
  if (guided != record.events.rend()) {
    const auto since_s = static_cast<long>((record.finished - guided->time).count());
    why += " The system on board had been in " + guided->text + ", for " + std::to_string(since_s) + " s.";
  }
  return why;
}

}  // namespace

RunSummary summary_of(const FlightRecord& record) {
  RunSummary summary{.seed = record.seed,
                     .end = record.end,
                     .travel_time = record.duration(),
                     .clearance_m = std::nullopt,
                     .energy = record.energy,
                     .distance_m = record.distance_m,
                     .why = why_not_there(record),
                     .could_be_saved = std::nullopt};
  if (!record.track.empty()) summary.final_position_error_m = position_error_m(record.track.back());
  for (const TrackPoint& point : record.track)
    summary.worst_position_error_m = std::max(summary.worst_position_error_m, position_error_m(point));
  for (const ClosestApproach& approach : record.approaches) {
    // A flight ends within the step in which it touches: a vehicle is then a little inside.
    const double clearance_m = std::max(0.0, approach.distance_m);
    if (!summary.clearance_m || clearance_m < *summary.clearance_m) summary.clearance_m = clearance_m;
  }
  return summary;
}

std::optional<Distribution> distribution_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  const auto n = static_cast<double>(values.size());
  Distribution found;
  found.runs = values.size();
  found.least = values.front();
  found.most = values.back();
  double sum = 0.0;
  for (const double value : values) sum += value;
  found.mean = sum / n;
  if (values.size() > 1) {
    double squares = 0.0;
    for (const double value : values) squares += (value - found.mean) * (value - found.mean);
    found.standard_deviation = std::sqrt(squares / (n - 1.0));
    const double half = student_t(n - 1.0) * *found.standard_deviation / std::sqrt(n);
    const double low = found.mean - half;
    found.mean_interval = Interval{found.least >= 0.0 ? std::max(0.0, low) : low, found.mean + half};
  }
  for (const double share : {0.05, 0.25, 0.5, 0.75, 0.95})
    found.quantiles.push_back({share, quantile_of(values, share), quantile_interval(values, share)});
  return found;
}

Share share_of(std::size_t runs, std::size_t all) {
  const auto n = static_cast<double>(all);
  const double share = static_cast<double>(runs) / n;
  const double z2 = two_sided_95 * two_sided_95;
  const double middle = (share + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half =
      two_sided_95 / (1.0 + z2 / n) * std::sqrt(share * (1.0 - share) / n + z2 / (4.0 * n * n));
  return {runs, share, {std::max(0.0, middle - half), std::min(1.0, middle + half)}};
}

BatchStatistics statistics_of(std::span<const RunSummary> runs) {
  BatchStatistics found;
  found.runs = runs.size();
  if (runs.empty()) return found;
  for (const FlightEnd end :
       {FlightEnd::arrived, FlightEnd::collided, FlightEnd::grounded, FlightEnd::gave_up, FlightEnd::time_up,
        FlightEnd::battery, FlightEnd::left_data, FlightEnd::stopped}) {
    const auto ended = static_cast<std::size_t>(std::ranges::count(runs, end, &RunSummary::end));
    if (ended > 0) found.ends.push_back({end, share_of(ended, runs.size())});
  }
  const auto all = [](const RunSummary&) { return true; };
  const auto arrived = [](const RunSummary& run) { return run.end == FlightEnd::arrived; };
  found.travel_time_s =
      distribution_over(runs, [](const RunSummary& run) { return run.travel_time.count(); }, arrived);
  found.final_position_error_m =
      distribution_over(runs, [](const RunSummary& run) { return run.final_position_error_m; }, all);
  found.worst_position_error_m =
      distribution_over(runs, [](const RunSummary& run) { return run.worst_position_error_m; }, all);
  found.clearance_m = distribution_over(
      runs, [](const RunSummary& run) { return *run.clearance_m; },
      [](const RunSummary& run) { return run.clearance_m.has_value(); });
  found.energy_j = distribution_over(runs, [](const RunSummary& run) { return run.energy.value; }, arrived);
  return found;
}

}  // namespace floeplan::simulation
