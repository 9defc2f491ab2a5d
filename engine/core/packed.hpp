#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "engine/core/units.hpp"

/// Values as bytes, for another process of the same version on a machine of the same kind: numbers keep every bit.
/// A structure is packed by its members, which `members_of(structure)`, a function of its namespace, returns as a
/// tuple of references.
namespace floeplan::core {

namespace packing {

template <class T>
concept HasMembers = requires(T& value) { members_of(value); };

template <class T>
inline constexpr bool is_number = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <class Rep, class Period>
inline constexpr bool is_number<std::chrono::duration<Rep, Period>> = true;
template <class Clock, class Duration>
inline constexpr bool is_number<std::chrono::time_point<Clock, Duration>> = true;
template <class Tag>
inline constexpr bool is_number<Quantity<Tag>> = true;

template <class T>
  requires is_number<T>
void write(std::string& bytes, const T& number) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), &number, sizeof(T));
  bytes.append(raw.data(), raw.size());
}

template <class T>
  requires is_number<T>
void read(std::string_view& bytes, T& number) {
  if (bytes.size() < sizeof(T)) throw std::runtime_error{"the packed bytes end too early"};
  std::memcpy(&number, bytes.data(), sizeof(T));
  bytes.remove_prefix(sizeof(T));
}

inline void write(std::string& bytes, std::monostate) { (void)bytes; }
inline void read(std::string_view& bytes, std::monostate) { (void)bytes; }

// Containers may hold each other, so that all are declared before the first is defined.
inline void write(std::string& bytes, const std::string& text);
inline void read(std::string_view& bytes, std::string& text);
template <class T>
void write(std::string& bytes, const std::vector<T>& list);
template <class T>
void read(std::string_view& bytes, std::vector<T>& list);
template <class T, std::size_t count>
void write(std::string& bytes, const std::array<T, count>& list);
template <class T, std::size_t count>
void read(std::string_view& bytes, std::array<T, count>& list);
template <class T>
void write(std::string& bytes, const std::optional<T>& value);
template <class T>
void read(std::string_view& bytes, std::optional<T>& value);
template <class... Ts>
void write(std::string& bytes, const std::variant<Ts...>& value);
template <class... Ts>
void read(std::string_view& bytes, std::variant<Ts...>& value);
template <class T, class E>
void write(std::string& bytes, const tl::expected<T, E>& value);
template <class T, class E>
void read(std::string_view& bytes, tl::expected<T, E>& value);

template <HasMembers T>
void write(std::string& bytes, const T& value) {
  // The members are only read; one function of a structure serves both directions.
  std::apply([&](auto&... member) { (write(bytes, member), ...); }, members_of(const_cast<T&>(value)));
}

template <HasMembers T>
void read(std::string_view& bytes, T& value) {
  std::apply([&](auto&... member) { (read(bytes, member), ...); }, members_of(value));
}

void write(std::string& bytes, const std::string& text) {
  write(bytes, std::uint64_t{text.size()});
  bytes += text;
}

void read(std::string_view& bytes, std::string& text) {
  std::uint64_t size{};
  read(bytes, size);
  if (bytes.size() < size) throw std::runtime_error{"the packed bytes end too early"};
  text = bytes.substr(0, size);
  bytes.remove_prefix(size);
}

template <class T>
void write(std::string& bytes, const std::vector<T>& list) {
  write(bytes, std::uint64_t{list.size()});
  for (const T& value : list) write(bytes, value);
}

template <class T>
void read(std::string_view& bytes, std::vector<T>& list) {
  std::uint64_t size{};
  read(bytes, size);
  list.clear();
  for (std::uint64_t i = 0; i < size; ++i) read(bytes, list.emplace_back());
}

template <class T, std::size_t count>
void write(std::string& bytes, const std::array<T, count>& list) {
  for (const T& value : list) write(bytes, value);
}

template <class T, std::size_t count>
void read(std::string_view& bytes, std::array<T, count>& list) {
  for (T& value : list) read(bytes, value);
}

template <class T>
void write(std::string& bytes, const std::optional<T>& value) {
  write(bytes, value.has_value());
  if (value) write(bytes, *value);
}

template <class T>
void read(std::string_view& bytes, std::optional<T>& value) {
  bool has_value{};
  read(bytes, has_value);
  value.reset();
  if (has_value) read(bytes, value.emplace());
}

template <class... Ts>
void write(std::string& bytes, const std::variant<Ts...>& value) {
  write(bytes, std::uint64_t{value.index()});
  std::visit([&](const auto& held) { write(bytes, held); }, value);
}

template <class... Ts>
void read(std::string_view& bytes, std::variant<Ts...>& value) {
  std::uint64_t index{};
  read(bytes, index);
  const auto read_as = [&]<class T>(std::uint64_t of, std::type_identity<T>) {
    if (of == index) read(bytes, value.template emplace<T>());
  };
  std::uint64_t of = 0;
  (read_as(of++, std::type_identity<Ts>{}), ...);
  if (index >= sizeof...(Ts)) throw std::runtime_error{"the packed bytes are of another kind"};
}

template <class T, class E>
void write(std::string& bytes, const tl::expected<T, E>& value) {
  write(bytes, value.has_value());
  if (value) {
    write(bytes, *value);
  } else {
    write(bytes, value.error());
  }
}

template <class T, class E>
void read(std::string_view& bytes, tl::expected<T, E>& value) {
  bool has_value{};
  read(bytes, has_value);
  if (has_value) {
    T held{};
    read(bytes, held);
    value = std::move(held);
  } else {
    E error{};
    read(bytes, error);
    value = tl::unexpected(std::move(error));
  }
}

}  // namespace packing

template <class T>
[[nodiscard]] std::string packed(const T& value) {
  std::string bytes;
  packing::write(bytes, value);
  return bytes;
}

/// Errors  std::runtime_error for bytes that `packed` did not make from such a value
template <class T>
[[nodiscard]] T unpacked(std::string_view bytes) {
  T value{};
  packing::read(bytes, value);
  if (!bytes.empty()) throw std::runtime_error{"the packed bytes are of another kind"};
  return value;
}

}  // namespace floeplan::core
