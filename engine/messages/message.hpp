#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::messages {

/// How much a message matters, the gravest first.
enum class Rank {
  danger,   // the vehicle may be lost
  caution,  // the plan may not hold
  note      // good to know
};

[[nodiscard]] std::string_view rank_name(Rank rank);
[[nodiscard]] std::optional<Rank> parse_rank(std::string_view name);

using core::NamedValue;
using core::Value;

/// Something that a person is told. Programs go by the code and the values, which stay; the text may be worded better.
/// Made of a row of the catalogue (catalogue.hpp), or read back from where it was stored.
struct Message {
  std::string code;
  Rank rank{Rank::note};
  std::optional<geo::LonLat> place{};  // where on the map; empty: all over, or nowhere
  std::vector<NamedValue> values{};
  std::string text{};  // what is the matter and what it means
  std::string hint{};  // what to do; empty where nothing can be done, and where the text says it

  [[nodiscard]] Message at(geo::LonLat where) &&;

  friend bool operator==(const Message&, const Message&) = default;
};

/// Whether it tells of a danger.
[[nodiscard]] bool is_grave(const Message& message);

/// The gravest first, each rank in its order.
[[nodiscard]] std::vector<Message> by_rank(std::vector<Message> messages);

}  // namespace floeplan::messages
