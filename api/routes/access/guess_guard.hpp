#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <set>
#include <string>

#include "engine/core/units.hpp"

namespace floeplan::routes {

/// Limits how often each of many callers may do something: `burst` times at once, then once in every
/// `interval`.
/// Memory   bounded; the caller inactive for longest is dropped first
/// Threads  one at a time
class RateLimit {
 public:
  RateLimit(double burst, core::Seconds interval) : burst_{burst}, interval_{interval} {}

  /// Time for which `who` must wait; zero if it need not wait.
  [[nodiscard]] core::Seconds wait(const std::string& who, core::UtcTime now) const;
  void note(const std::string& who, core::UtcTime now);

 private:
  static constexpr std::size_t most_known = 10'000;
  struct Record {
    double done{};  // number of events, reduced as time passes
    core::UtcTime as_of;
  };

  [[nodiscard]] double done_by(const Record& record, core::UtcTime now) const;

  double burst_;
  core::Seconds interval_;
  std::map<std::string, Record> records_;
};

/// Slows down clients that guess credentials or log in again and again.
/// An address may send `burst` wrong tokens. All addresses together may send `burst` wrong secrets for one token.
/// Then no try is looked at for a while; one more try is allowed for every `interval` without tries. A token that
/// was right from an address before is always looked at. So nobody is locked out by a neighbour behind the same
/// address, or by somebody who knows the public part of a token.
/// Memory   bounded; the entry without tries for the longest time is forgotten first
/// Threads  any number at once
class GuessGuard {
 public:
  static constexpr double burst = 10.0;
  static constexpr core::Seconds interval{6.0};
  /// Successful logins: a crew of sixty may log in at once from one address, each with three browsers.
  static constexpr double logins_of_address = 60.0;
  static constexpr double logins_of_token = 20.0;
  static constexpr core::Seconds login_interval{3.0};

  /// A credential and its sender. `key` identifies the token; `key` and `digest` are empty for an invalid
  /// credential.
  struct Shown {
    std::string address;
    std::string key;
    std::string digest;
  };

  /// Time to wait before this credential is checked; zero: no wait.
  [[nodiscard]] core::Seconds wait(const Shown& shown, core::UtcTime now);
  void note_wrong(const Shown& shown, core::UtcTime now);
  void note_right(const Shown& shown, core::UtcTime now);

  /// Time to wait before another login; zero: no wait, and this login is counted.
  [[nodiscard]] core::Seconds wait_to_log_in(const Shown& shown, core::UtcTime now);

 private:
  static constexpr std::size_t most_addresses = 10'000;
  static constexpr std::size_t most_proven = 64;  // right credentials remembered for one address

  std::mutex mutex_;
  RateLimit wrong_from_{burst, interval};
  RateLimit wrong_of_{burst, interval};
  RateLimit logins_from_{logins_of_address, login_interval};
  RateLimit logins_of_{logins_of_token, login_interval};
  std::map<std::string, std::set<std::string>> proven_;  // digests of right credentials, by address
};

}  // namespace floeplan::routes
