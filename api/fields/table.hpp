#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "api/fields/field.hpp"

/// Connects the rows of a table with the members of the structs that they describe.
namespace floeplan::fields {

/// A field and the member of `Values` that holds it.
template <class Values>
struct Bound {
  Field field;
  std::function<void(Values&, const Value&)> set;
  std::function<std::optional<Value>(const Values&)> get;  // empty if the member is empty
};

template <class Values>
using Table = std::vector<Bound<Values>>;

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

inline constexpr double cm3_per_m3 = 1e6;

/// The kind of field for a member of this type.
template <class T>
constexpr Kind kind_of() {
  if constexpr (is_optional<T>) {
    return kind_of<typename T::value_type>();
  } else if constexpr (std::same_as<T, bool>) {
    return Kind::boolean;
  } else if constexpr (std::integral<T>) {
    return Kind::whole_number;
  } else if constexpr (std::same_as<T, std::string>) {
    return Kind::text;
  } else if constexpr (std::same_as<T, core::UtcTime>) {
    return Kind::time;
  } else {
    return Kind::number;
  }
}

/// Stores a request's value in a member. Requests have angles in degrees, volumes in cubic centimetres, other
/// numbers in SI units.
template <class T>
void store(const Value& value, T& member) {
  if constexpr (is_optional<T>) {
    store(value, member.emplace());
  } else if constexpr (std::same_as<T, core::Radians>) {
    member.value = core::degrees_to_radians(std::get<double>(value));
  } else if constexpr (std::same_as<T, core::CubicMetres>) {
    member.value = std::get<double>(value) / cm3_per_m3;
  } else if constexpr (std::same_as<T, core::Seconds>) {
    member = core::Seconds{std::get<double>(value)};
  } else if constexpr (std::same_as<T, std::uint64_t>) {
    member = static_cast<std::uint64_t>(std::get<int>(value));
  } else if constexpr (requires { member.value; }) {
    member.value = std::get<double>(value);
  } else {
    member = std::get<T>(value);
  }
}

template <class T>
std::optional<Value> stored(const T& member) {
  if constexpr (is_optional<T>) {
    return member ? stored(*member) : std::nullopt;
  } else if constexpr (std::same_as<T, core::Radians>) {
    return core::radians_to_degrees(member.value);
  } else if constexpr (std::same_as<T, core::CubicMetres>) {
    return member.value * cm3_per_m3;
  } else if constexpr (std::same_as<T, core::Seconds>) {
    return member.count();
  } else if constexpr (std::same_as<T, std::uint64_t>) {
    return static_cast<int>(member);
  } else if constexpr (requires { member.value; }) {
    return member.value;
  } else {
    return member;
  }
}

/// A row for the member access(values) of `Values`. Its default is the value that `Values` has when
/// constructed.
template <class Values, class Access>
Bound<Values> bound(Field field, Access access) {
  using Member = std::remove_reference_t<decltype(access(std::declval<Values&>()))>;
  if (field.kind == Kind::structure) field.kind = kind_of<Member>();
  const Values usual{};
  field.usual = stored(access(usual));
  return {std::move(field), [access](Values& values, const Value& value) { store(value, access(values)); },
          [access](const Values& values) { return stored(access(values)); }};
}

/// A word of a request, and the value of the member for it.
template <class T>
struct Choice {
  Word word;
  T value;
};

/// Binds a field to a member with a few values, each with its word. Any other value of the member has no word.
template <class Values, class T, class Access>
Bound<Values> worded(Field field, std::vector<Choice<T>> choices, Access access) {
  field.kind = Kind::word;
  for (const Choice<T>& choice : choices) field.words.push_back(choice.word);
  const auto get = [access, choices](const Values& values) -> std::optional<Value> {
    for (const Choice<T>& choice : choices)
      if (access(values) == choice.value) return std::string{choice.word.name};
    return std::nullopt;
  };
  field.usual = get(Values{});
  const auto set = [access, choices](Values& values, const Value& value) {
    for (const Choice<T>& choice : choices)
      if (choice.word.name == std::get<std::string>(value)) access(values) = choice.value;
  };
  return {std::move(field), set, get};
}

/// The rows of a table with their group set, unless they already have one.
template <class Values>
Table<Values> in_group(std::string_view group, Table<Values> table) {
  for (Bound<Values>& row : table)
    if (row.field.group.empty()) row.field.group = group;
  return table;
}

/// The rows of a table without defaults, because the profile gives the value or the field is required.
template <class Values>
Table<Values> without_usual(Table<Values> table) {
  for (Bound<Values>& row : table) row.field.usual.reset();
  return table;
}

}  // namespace floeplan::fields
