#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <tuple>

namespace floeplan::routes {

/// How many requests were answered, how and how fast, since the start.
/// Memory   bounded: by operations and status codes, never by what clients write
/// Threads  any number at once
class RequestCounts {
 public:
  /// Upper bounds in seconds; the defaults of the Prometheus client libraries, with finer ones below.
  static constexpr std::array bounds_s{0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1,
                                       0.25,  0.5,    1.0,   2.5,  5.0,   10.0};

  /// `route`: the pattern of the operation; empty when none answered.
  void add(const std::string& method, const std::string& route, int status,
           std::chrono::duration<double> taken);
  /// In the text format of Prometheus, version 0.0.4.
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
