#include "storage/ingest/notation/cf_units.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

using Word = std::pair<std::string_view, double>;

constexpr std::array lengths_m{
    Word{"m", 1.0},
    Word{"meter", 1.0},
    Word{"meters", 1.0},
    Word{"metre", 1.0},
    Word{"metres", 1.0},
    Word{"km", 1000.0},
    Word{"kilometer", 1e3},
    Word{"kilometers", 1e3},
    Word{"kilometre", 1e3},
    Word{"kilometres", 1e3},
    Word{"cm", 0.01},
    Word{"centimeter", 0.01},
    Word{"centimeters", 0.01},
    Word{"centimetre", 0.01},
    Word{"centimetres", 0.01},
    Word{"mm", 0.001},
    Word{"ft", 0.3048},
    Word{"foot", 0.3048},
    Word{"feet", 0.3048},
    Word{"internationalfoot", 0.3048},
    Word{"internationalfeet", 0.3048},
    Word{"fathom", 1.8288},
    Word{"fathoms", 1.8288},
    Word{"yard", 0.9144},
    Word{"yards", 0.9144},
    Word{"nauticalmile", 1852.0},
    Word{"nauticalmiles", 1852.0},
    Word{"nmi", 1852.0},
    Word{"dm", 0.1},
};

constexpr std::array times_s{
    Word{"s", 1.0},     Word{"sec", 1.0},     Word{"second", 1.0},   Word{"seconds", 1.0},
    Word{"h", 3600.0},  Word{"hr", 3600.0},   Word{"hour", 3600.0},  Word{"hours", 3600.0},
    Word{"d", 86400.0}, Word{"day", 86400.0}, Word{"days", 86400.0},
};

constexpr std::array<std::string_view, 7> knots{"knot", "knots",          "kt",   "kts",
                                                "kn",   "nauticalmile/h", "nmi/h"};

template <std::size_t N>
std::optional<double> find(const std::array<Word, N>& words, std::string_view text) {
  const auto* found =
      std::find_if(words.begin(), words.end(), [&](const Word& word) { return word.first == text; });
  if (found == words.end()) return std::nullopt;
  return found->second;
}

/// The unit in lower case without separators: "m.s^-1", "m s**-1" and "m_s-1" all become "ms-1".
std::string bare(std::string_view unit) {
  std::string text = lower(unit);
  std::erase_if(text,
                [](char c) { return c == ' ' || c == '.' || c == '*' || c == '^' || c == '_' || c == '\t'; });
  if (const std::size_t per = text.find("per"); per != std::string::npos) {
    text[per] = '/';
    text.erase(per + 1, 2);
  }
  return text;
}

}  // namespace

std::optional<double> speed_factor(std::string_view unit) {
  const std::string text = bare(unit);
  if (std::find(knots.begin(), knots.end(), text) != knots.end()) return 1852.0 / 3600.0;

  for (std::size_t split = 1; split < text.size(); ++split) {
    const auto length = find(lengths_m, std::string_view{text}.substr(0, split));
    if (!length) continue;
    std::string_view rest = std::string_view{text}.substr(split);
    if (rest.starts_with('/')) {
      rest.remove_prefix(1);
    } else if (rest.ends_with("-1")) {
      rest.remove_suffix(2);
    } else {
      continue;
    }
    if (const auto time = find(times_s, rest)) return *length / *time;
  }
  return std::nullopt;
}

std::optional<double> length_factor(std::string_view unit) {
  const std::string text = bare(unit);
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const auto length = find(lengths_m, std::string_view{text}.substr(digits));
  if (!length || digits == 0) return length;
  const auto multiple = parse_number(text.substr(0, digits));
  if (!multiple || *multiple <= 0.0) return std::nullopt;
  return *multiple * *length;
}

bool is_pressure_unit(std::string_view unit) {
  constexpr std::string_view pressures[]{"pa",       "hpa",       "kpa",    "mb",      "mbar",
                                         "millibar", "millibars", "bar",    "dbar",    "db",
                                         "decibar",  "decibars",  "pascal", "pascals", "hectopascal"};
  return std::ranges::find(pressures, lower(unit)) != std::end(pressures);
}

bool is_degrees_east(std::string_view unit) {
  const std::string text = bare(unit);
  return text == "degreeseast" || text == "degreeeast" || text == "degreese" || text == "degreee";
}

bool is_degrees_north(std::string_view unit) {
  const std::string text = bare(unit);
  return text == "degreesnorth" || text == "degreenorth" || text == "degreesn" || text == "degreen";
}

}  // namespace floeplan::ingest
