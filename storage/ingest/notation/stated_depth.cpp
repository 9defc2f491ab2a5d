#include "storage/ingest/notation/stated_depth.hpp"

#include <string>

#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double deepest_m = 11'000.0;

struct NumberAndUnit {
  std::string number;
  std::string unit;
};

NumberAndUnit parts_of(std::string_view text) {
  const std::size_t end = text.find_last_of("0123456789.");
  const std::size_t length = end == std::string_view::npos ? 0 : end + 1;
  return {trimmed(text.substr(0, length)), trimmed(text.substr(length))};
}

}  // namespace

std::optional<core::Metres> stated_depth(std::string_view text, std::string_view unit) {
  const NumberAndUnit parts = parts_of(text);
  const auto number = parse_number(parts.number);
  const std::string_view own = parts.unit.empty() ? unit : std::string_view{parts.unit};
  const auto factor = own.empty() ? std::optional{1.0} : length_factor(own == "fm" ? "fathoms" : own);
  if (!number || !factor || *number < 0.0 || *number * *factor > deepest_m) return std::nullopt;
  return core::Metres{*number * *factor};
}

std::optional<StatedDepths> stated_depths(std::string_view text, std::string_view unit) {
  for (const std::string_view between : {" to ", "–", "-"}) {
    const std::size_t at = text.find(between);
    if (at == std::string_view::npos || at == 0) continue;
    const std::string first = trimmed(text.substr(0, at));
    const std::string second = trimmed(text.substr(at + between.size()));
    const std::string unit_behind = parts_of(second).unit;
    const auto top = stated_depth(first, unit_behind.empty() ? unit : unit_behind);
    const auto bottom = stated_depth(second, unit);
    if (top && bottom) return StatedDepths{*top, *bottom};
  }
  return std::nullopt;
}

}  // namespace floeplan::ingest
