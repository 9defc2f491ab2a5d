#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "engine/core/units.hpp"

namespace floeplan::routes {

/// How often something may be done, for each of many who do it: `burst` times at once, then once for every `interval`.
/// Memory   bounded; who did nothing for longest is forgotten first
/// Threads  one at a time
class RateLimit {
 public:
  RateLimit(double burst, core::Seconds interval) : burst_{burst}, interval_{interval} {}

  /// How long `who` has to wait; zero: not at all.
  [[nodiscard]] core::Seconds wait(const std::string& who, core::UtcTime now) const;
  void note(const std::string& who, core::UtcTime now);

 private:
  static constexpr std::size_t most_known = 10'000;
  struct Record {
    double done{};  // less what time has forgiven
    core::UtcTime as_of;
  };

  [[nodiscard]] double done_by(const Record& record, core::UtcTime now) const;

  double burst_;
  core::Seconds interval_;
  std::map<std::string, Record> records_;
};

}  // namespace floeplan::routes
