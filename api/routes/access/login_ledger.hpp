#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

#include "api/routes/request/context.hpp"
#include "api/routes/request/message.hpp"
#include "engine/core/units.hpp"

namespace floeplan::routes {

/// Writes logins, and what was shown in vain, into the audit log: one entry for each address, action and period, which says
/// how often. However often somebody tries, the log of what else was done stays.
/// Counts are written when they reach a power of two: "at least 64 times" may have been 127.
/// Memory   bounded: addresses beyond the first `most_addresses` of a period share one entry
/// Threads  any number at once
class LoginLedger {
 public:
  static constexpr core::Seconds period{600.0};
  static constexpr std::size_t most_addresses = 200;

  /// `caller`  name of the token that it was done with or that was guessed at; empty: of none that is known
  void note(const Context& context, const Request& request, const std::string& action,
            const std::string& caller);

 private:
  struct Tally {
    std::int64_t row{};  // in the audit log
    std::uint64_t times{};
  };

  std::mutex mutex_;
  core::UtcTime began_{};  // of the period
  std::map<std::string, Tally> tallies_;
};

}  // namespace floeplan::routes
