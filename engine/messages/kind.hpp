#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/messages/message.hpp"

/// The rows of the catalogue, and how a message is made from one. All texts are in the rows.
namespace floeplan::messages {

/// A value in every message of a kind, with an example; the example's type is the type of the value.
struct Slot {
  std::string_view name;
  std::variant<double, std::int64_t, std::string_view> example;
};

/// A row of the catalogue.
/// Text, hint  what is the matter, and what to do about it. They contain their values in braces, with the
/// format of {fmt}. Horizontal distances and durations have one form: "ice at {ice_km:distance}",
/// "{late_h:duration} later". For a count with its noun: "{legs} {legs:leg|legs}"; for a
/// waypoint's name, S for the start: "{waypoint:label}"
struct Kind {
  std::string_view code;  // never changes: programs and stored plans use it
  Rank rank{Rank::caution};
  std::string_view text;
  std::string_view hint{};
  std::array<Slot, 7> slots{};  // unused ones have no name

  [[nodiscard]] constexpr std::size_t values() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(slots, [](const Slot& slot) { return !slot.name.empty(); }));
  }
};

/// The message of a kind with these values. Number and types must be those of its slots.
[[nodiscard]] Message message_of(const Kind& kind, std::vector<Value> values);

/// The message with the examples of the catalogue as values.
[[nodiscard]] Message example_of(const Kind& kind);

/// A code as a template argument, so that a code missing in the catalogue does not compile.
template <std::size_t size>
struct Code {
  consteval Code(const char (&text)[size]) { std::ranges::copy(text, characters.begin()); }
  [[nodiscard]] constexpr std::string_view view() const { return {characters.data(), size - 1}; }
  std::array<char, size> characters{};
};

consteval const Kind& kind_among(std::span<const Kind> kinds, std::string_view code) {
  for (const Kind& kind : kinds)
    if (kind.code == code) return kind;
  throw std::logic_error{"no message has this code"};
}

template <class T>
Value value_from(const T& given) {
  if constexpr (std::is_same_v<T, core::UtcTime>) {
    return core::iso8601(given);
  } else if constexpr (std::floating_point<T>) {
    return double{given};
  } else if constexpr (std::integral<T>) {
    return static_cast<std::int64_t>(given);
  } else {
    return std::string{given};
  }
}

/// Whether the kind's slots have exactly these types.
template <class... Given>
consteval bool takes(const Kind& kind) {
  if (kind.values() != sizeof...(Given)) return false;
  const std::array<std::size_t, sizeof...(Given)> types{
      (std::floating_point<Given> ? 0U : (std::integral<Given> ? 1U : 2U))...};
  for (std::size_t i = 0; i < types.size(); ++i)
    if (kind.slots[i].example.index() != types[i]) return false;
  return true;
}

/// The message with this code among these kinds. An unknown code, or values of other types, do not compile.
template <const auto& kinds, Code code, class... Given>
[[nodiscard]] Message make_message(const Given&... given) {
  constexpr const Kind& kind = kind_among(kinds, code.view());
  static_assert(takes<std::decay_t<Given>...>(kind), "these are not the values that the catalogue names");
  return message_of(kind, {value_from(given)...});
}

}  // namespace floeplan::messages
