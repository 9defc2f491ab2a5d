#include "engine/messages/kind.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <cassert>

namespace floeplan::messages {
namespace {

/// A count, formatted as a number or, if the text gives two words, as the word for one or for several.
struct Count {
  std::int64_t value;
};

}  // namespace
}  // namespace floeplan::messages

/// "{legs}" gives a number; "{legs:leg|legs}" gives "leg" for one and "legs" for any other number.
template <>
struct fmt::formatter<floeplan::messages::Count> {
  std::string_view words{};

  constexpr auto parse(format_parse_context& context) {
    const auto* const end = std::find(context.begin(), context.end(), '}');
    words = {context.begin(), end};
    return end;
  }

  auto format(const floeplan::messages::Count& count, format_context& context) const {
    if (words.empty()) return fmt::format_to(context.out(), "{}", count.value);
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
      arguments.push_back(fmt::arg(name.c_str(), *number));
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
