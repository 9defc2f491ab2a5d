#include "engine/messages/kind.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <cassert>

#include "engine/core/shown_text.hpp"

namespace floeplan::messages {
namespace {

/// A number with its factor to metres or seconds, from the unit in its name.
struct Number {
  double value;
  double to_base;
};

double factor_of_unit(std::string_view name) {
  if (name.ends_with("_km")) return 1000.0;
  if (name.ends_with("_h")) return 3600.0;
  return 1.0;
}

/// "14 h 44 min", and "2 h" for whole hours.
std::string duration_text(core::Seconds time) {
  std::string text = core::hours_minutes(time);
  if (const auto whole = text.find(" 00 min"); whole != std::string::npos) text.resize(whole);
  return text;
}

/// A count, formatted as a number or, if the text gives two words, as the word for one or for several.
struct Count {
  std::int64_t value;
};

}  // namespace
}  // namespace floeplan::messages

/// "{ice_km:distance}" gives "812 m" or "3.2 km", "{late_h:duration}" gives "2 h 40 min"; otherwise the
/// format of a double.
template <>
struct fmt::formatter<floeplan::messages::Number> : fmt::formatter<double> {
  enum class As { figure, distance, duration } as{As::figure};

  constexpr auto parse(format_parse_context& context) {
    const auto* const end = std::find(context.begin(), context.end(), '}');
    const std::string_view words{context.begin(), end};
    if (words == "distance") as = As::distance;
    if (words == "duration") as = As::duration;
    return as == As::figure ? fmt::formatter<double>::parse(context) : end;
  }

  auto format(const floeplan::messages::Number& number, format_context& context) const {
    namespace core = floeplan::core;
    const double base = number.value * number.to_base;
    switch (as) {
      case As::distance: return fmt::format_to(context.out(), "{}", core::distance_text(core::Metres{base}));
      case As::duration:
        return fmt::format_to(context.out(), "{}", floeplan::messages::duration_text(core::Seconds{base}));
      case As::figure: break;
    }
    return fmt::formatter<double>::format(number.value, context);
  }
};

/// "{legs}" gives a number; "{legs:leg|legs}" gives "leg" for one and "legs" for any other number;
/// "{waypoint:label}" gives the number as a waypoint's name, "S" for the start.
template <>
struct fmt::formatter<floeplan::messages::Count> {
  std::string_view words{};

  constexpr auto parse(format_parse_context& context) {
    const auto* const end = std::find(context.begin(), context.end(), '}');
    words = {context.begin(), end};
    return end;
  }

  auto format(const floeplan::messages::Count& count, format_context& context) const {
    if (words == "label" && count.value == 0) return fmt::format_to(context.out(), "S");
    if (words.empty() || words == "label") return fmt::format_to(context.out(), "{}", count.value);
    const std::size_t bar = words.find('|');
    return fmt::format_to(context.out(), "{}",
                          count.value == 1 ? words.substr(0, bar) : words.substr(bar + 1));
  }
};

namespace floeplan::messages {
namespace {

std::string filled(std::string_view text, const std::vector<NamedValue>& values) {
  fmt::dynamic_format_arg_store<fmt::format_context> arguments;
  for (const auto& [name, value] : values) {
    if (const auto* count = std::get_if<std::int64_t>(&value)) {
      arguments.push_back(fmt::arg(name.c_str(), Count{*count}));
    } else if (const auto* number = std::get_if<double>(&value)) {
      arguments.push_back(fmt::arg(name.c_str(), Number{*number, factor_of_unit(name)}));
    } else {
      arguments.push_back(fmt::arg(name.c_str(), std::get<std::string>(value)));
    }
  }
  return fmt::vformat(fmt::string_view{text.data(), text.size()}, arguments);
}

}  // namespace

Message message_of(const Kind& kind, std::vector<Value> values) {
  assert(values.size() == kind.values());
  Message message{.code = std::string{kind.code}, .rank = kind.rank};
  for (std::size_t i = 0; i < values.size(); ++i)
    message.values.push_back({std::string{kind.slots[i].name}, std::move(values[i])});
  message.text = filled(kind.text, message.values);
  message.hint = filled(kind.hint, message.values);
  return message;
}

Message example_of(const Kind& kind) {
  std::vector<Value> values;
  for (std::size_t i = 0; i < kind.values(); ++i)
    values.push_back(std::visit(
        []<class Example>(const Example& example) -> Value {
          if constexpr (std::is_same_v<Example, std::string_view>) {
            return std::string{example};
          } else {
            return example;
          }
        },
        kind.slots[i].example));
  return message_of(kind, std::move(values));
}

}  // namespace floeplan::messages
