#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <tuple>

namespace floeplan::routes {

/// Numbers and durations of the requests answered since the start.
/// Memory   bounded by operations and status codes, independent of what clients send
/// Threads  any number at once
class RequestCounts {
 public:
  /// Upper bounds of the histogram, seconds; the defaults of the Prometheus client libraries, with additional
  /// smaller ones.
  static constexpr std::array bounds_s{0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1,
                                       0.25,  0.5,    1.0,   2.5,  5.0,   10.0};

  /// `route`: pattern of the operation; empty if none answered.
  void add(const std::string& method, const std::string& route, int status,
           std::chrono::duration<double> taken);
  /// The counts in Prometheus' text format, version 0.0.4.
  [[nodiscard]] std::string text() const;

 private:
  struct Histogram {
    std::array<std::uint64_t, bounds_s.size()> within{};  // cumulative
    std::uint64_t count{};
    double sum_s{};
  };

  mutable std::mutex mutex_;
  std::map<std::tuple<std::string, std::string, int>, std::uint64_t> requests_;
  std::map<std::string, Histogram> durations_;
};

}  // namespace floeplan::routes
