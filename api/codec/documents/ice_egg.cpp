#include "api/codec/documents/ice_egg.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using repository::IceCode;

struct Meaning {
  std::string_view code;
  std::string_view words;
};

constexpr auto stages = std::to_array<Meaning>({
    {"00", "ice free"},
    {"55", "ice free"},
    {"70", "brash ice"},
    {"80", "no stage of development"},
    {"81", "new ice, under 10 cm"},
    {"82", "nilas or ice rind, under 10 cm"},
    {"83", "young ice, 10 to 30 cm"},
    {"84", "grey ice, 10 to 15 cm"},
    {"85", "grey-white ice, 15 to 30 cm"},
    {"86", "first-year ice, 30 to 200 cm"},
    {"87", "thin first-year ice, 30 to 70 cm"},
    {"88", "thin first-year ice, 30 to 50 cm"},
    {"89", "thin first-year ice, 50 to 70 cm"},
    {"91", "medium first-year ice, 70 to 120 cm"},
    {"93", "thick first-year ice, over 120 cm"},
    {"94", "residual ice"},
    {"95", "old ice"},
    {"96", "second-year ice"},
    {"97", "multi-year ice"},
    {"98", "glacier ice"},
    {"99", "stage not determined"},
});

constexpr auto forms = std::to_array<Meaning>({
    {"00", "pancake ice"},
    {"01", "shuga, small ice cake or brash, under 2 m"},
    {"02", "ice cake, under 20 m"},
    {"03", "small floes, 20 to 100 m"},
    {"04", "medium floes, 100 to 500 m"},
    {"05", "big floes, 500 m to 2 km"},
    {"06", "vast floes, 2 to 10 km"},
    {"07", "giant floes, over 10 km"},
    {"08", "fast ice"},
    {"09", "growlers or floebergs"},
    {"10", "icebergs"},
    {"21", "level ice"},
    {"22", "pancake ice"},
    {"99", "form not determined"},
});

template <std::size_t Size>
json words_of(const std::array<Meaning, Size>& table, const std::string& code) {
  if (code.empty()) return nullptr;
  const auto found = std::ranges::find(table, code, &Meaning::code);
  return found == table.end() ? "code " + code : std::string{found->words};
}

std::string code_of(const std::vector<IceCode>& codes, std::string_view name) {
  const auto found = std::ranges::find(codes, name, &IceCode::name);
  return found == codes.end() ? "" : found->code;
}

/// A concentration in words: "8 tenths", "4 to 6 tenths". Two digits are the ends of a range; a second digit
/// 0 means one value.
json concentration_words(const std::string& code) {
  if (code.empty()) return nullptr;
  if (code == "00" || code == "55") return "ice free";
  if (code == "01") return "open water, under 1 tenth";
  if (code == "02") return "bergy water";
  if (code == "92") return "10 tenths";
  if (code == "98" || code == "99") return "concentration not determined";
  const bool is_range =
      code.size() == 2 && code[0] >= '1' && code[0] <= '9' && code[1] >= '0' && code[1] <= '9';
  if (!is_range) return "code " + code;
  const std::string lower{code[0]};
  if (code[1] == '0') return lower + (lower == "1" ? " tenth" : " tenths");
  if (code[1] == '1' && code[0] >= '8') return lower + " to 10 tenths";
  return code[1] > code[0] ? lower + " to " + code[1] + " tenths" : "code " + code;
}

}  // namespace

json ice_egg(const std::vector<IceCode>& codes) {
  json all = json::object();
  for (const auto& [name, code] : codes) all[name] = code;
  json parts = json::array();
  for (const char letter : {'A', 'B', 'C'}) {
    const std::string concentration = code_of(codes, std::string{'C', letter});
    const std::string stage = code_of(codes, std::string{'S', letter});
    const std::string form = code_of(codes, std::string{'F', letter});
    if (concentration.empty() && stage.empty() && form.empty()) continue;
    parts.push_back({{"concentration", concentration_words(concentration)},
                     {"stage", words_of(stages, stage)},
                     {"form", words_of(forms, form)}});
  }
  return {{"codes", std::move(all)},
          {"total", concentration_words(code_of(codes, "CT"))},
          {"parts", std::move(parts)}};
}

}  // namespace floeplan::codec
