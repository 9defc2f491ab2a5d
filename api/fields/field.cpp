#include "api/fields/field.hpp"

#include <array>
#include <utility>

namespace floeplan::fields {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> unit_words{
    {{"m", "metres"}, {"s", "seconds"}, {"deg", "degrees"}, {"J", "joules"}, {"share", ""}}};

}  // namespace

std::string pointer_of(const Field& field) {
  std::string pointer{"/"};
  if (!field.object.empty()) pointer.append(field.object).append("/");
  return pointer.append(field.name);
}

std::string_view unit_in_words(const Field& field) {
  for (const auto& [unit, words] : unit_words)
    if (unit == field.unit) return words;
  return field.unit;
}

}  // namespace floeplan::fields
