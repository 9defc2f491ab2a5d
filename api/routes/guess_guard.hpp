#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <set>
#include <string>

#include "engine/core/units.hpp"

namespace floeplan::routes {

/// Slows down whoever guesses credentials. An address may be wrong `burst` times; then nothing it shows is looked at
/// until it has been quiet for a while, one more try for every `interval`. What was right from there before is looked
/// at all the same: nobody is locked out by a neighbour behind the same address.
/// Memory   bounded; the addresses that were wrong longest ago are forgotten first
/// Threads  any number at once
class GuessGuard {
 public:
  static constexpr double burst = 10.0;
  static constexpr core::Seconds interval{6.0};
  static constexpr std::size_t most_addresses = 10'000;
  static constexpr std::size_t most_proven = 64;  // of one address

  /// How long the address must wait before what it shows is looked at; zero: not at all.
  [[nodiscard]] core::Seconds wait(const std::string& address, const std::string& digest, core::UtcTime now);
  void note_wrong(const std::string& address, core::UtcTime now);
  void note_right(const std::string& address, const std::string& digest, core::UtcTime now);

 private:
  struct Record {
    double wrong{};  // tries, less what time has forgiven
    core::UtcTime as_of;
    std::set<std::string> proven;
  };

  Record& record_of(const std::string& address, core::UtcTime now);

  std::mutex mutex_;
  std::map<std::string, Record> records_;
};

}  // namespace floeplan::routes
