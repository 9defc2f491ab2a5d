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

  /// Time that `who` has to wait; zero: no wait.
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

/// Slows down whoever guesses credentials, and whoever logs in again and again.
/// An address may be wrong `burst` times, and a token may be guessed at as often from all addresses together; then nothing
/// is looked at until there has been quiet for a while, one more try for every `interval`. What was right from an address
/// before is looked at all the same: nobody is locked out by a neighbour behind the same address, or by one who knows the
/// public part of a token.
/// Memory   bounded; whoever did nothing for longest is forgotten first
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
  static constexpr std::size_t most_proven = 64;  // largest number for one address

  std::mutex mutex_;
  RateLimit wrong_from_{burst, interval};
  RateLimit wrong_of_{burst, interval};
  RateLimit logins_from_{logins_of_address, login_interval};
  RateLimit logins_of_{logins_of_token, login_interval};
  std::map<std::string, std::set<std::string>> proven_;  // digests of right credentials, by address
};

}  // namespace floeplan::routes
