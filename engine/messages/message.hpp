#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::messages {

/// The rank of a message, the most serious first.
enum class Rank {
  danger,   // the vehicle may be lost
  caution,  // the plan may not hold
  note      // good to know
};

[[nodiscard]] std::string_view rank_name(Rank rank);
[[nodiscard]] std::optional<Rank> parse_rank(std::string_view name);

using core::NamedValue;
using core::Value;

/// A message to a person. Programs use the code and the values, which never change; the text may be improved.
/// Made from a row of the catalogue (catalogue.hpp), or read back from storage.
struct Message {
  std::string code;
  Rank rank{Rank::note};
  std::optional<geo::LonLat> place{};  // on the map; empty: everywhere, or no place
  std::vector<NamedValue> values{};
  std::string text{};  // what is the matter, and what it means
  std::string hint{};  // what to do; empty if nothing can be done, or if the text says it

  [[nodiscard]] Message at(geo::LonLat where) &&;

  friend bool operator==(const Message&, const Message&) = default;
  /// For core::packed.
  friend auto members_of(Message& message) {
    auto& [code, rank, place, values, text, hint] = message;
    return std::tie(code, rank, place, values, text, hint);
  }
};

/// Whether the message's rank is danger.
[[nodiscard]] bool is_grave(const Message& message);

/// The messages ordered by rank, the most serious first; equal ranks keep their order.
[[nodiscard]] std::vector<Message> by_rank(std::vector<Message> messages);

}  // namespace floeplan::messages
