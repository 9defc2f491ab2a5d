#include "storage/ingest/formats/vector/sigrid3.hpp"

#include <ogr_feature.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "engine/core/letter_case.hpp"
#include "engine/messages/ingest_ice_messages.hpp"
#include "storage/ingest/formats/vector/feature_texts.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr auto total_names = std::to_array<std::string_view>({"ct"});
constexpr auto polygon_names = std::to_array<std::string_view>({"polytype", "polyty"});

/// The code in an attribute, two digits; empty if the chart leaves it open. A numeric column has lost a
/// leading zero.
std::string code_of(const OGRFeature& feature, std::string_view name) {
  std::string text = text_of_feature(feature, std::array{name}).value_or("");
  if (const auto value = parse_number(text);
      value && *value == std::round(*value) && std::abs(*value) < 100.0)
    text = std::to_string(static_cast<int>(*value));
  if (text.size() == 1) text.insert(0, "0");
  return text == "-9" ? "" : text;
}

/// The greatest concentration that a code stands for; nullopt if the code does not exist.
std::optional<double> most_concentration(const std::string& code) {
  if (code == "00" || code == "55") return 0.0;  // ice free
  if (code == "01" || code == "02") return 0.1;  // open water, bergy water: less than one tenth
  if (code == "92") return 1.0;
  if (code.size() != 2 || code[0] < '1' || code[0] > '9' || code[1] < '0' || code[1] > '9')
    return std::nullopt;
  const int lower_tenths = code[0] - '0';
  const int upper_tenths = code[1] - '0';
  if (upper_tenths == 0) return std::min(1.0, 0.1 * lower_tenths + 0.05);
  if (upper_tenths == 1 && lower_tenths >= 8) return 1.0;  // 81: 8 to 10 tenths, 91: 9 to 10
  if (upper_tenths <= lower_tenths) return std::nullopt;
  return 0.1 * upper_tenths;
}

/// A stage of development and its greatest thickness, metres; infinite if there is no limit.
struct Stage {
  std::string_view code;
  double most_m;
};

constexpr double unbounded = INFINITY;
constexpr auto stages = std::to_array<Stage>({
    {"00", 0.0},        // ice free
    {"55", 0.0},        // ice free
    {"70", unbounded},  // brash ice
    {"80", unbounded},  // no stage of development
    {"81", 0.10},       // new ice
    {"82", 0.10},       // nilas, ice rind
    {"83", 0.30},       // young ice
    {"84", 0.15},       // grey ice
    {"85", 0.30},       // grey-white ice
    {"86", 2.00},       // first-year ice
    {"87", 0.70},       // thin first-year ice
    {"88", 0.50},       // thin first-year ice, first stage
    {"89", 0.70},       // thin first-year ice, second stage
    {"91", 1.20},       // medium first-year ice
    {"93", 2.00},       // thick first-year ice, which is first-year ice: up to 2 m
    {"94", unbounded},  // residual ice
    {"95", unbounded},  // old ice
    {"96", unbounded},  // second-year ice
    {"97", unbounded},  // multi-year ice
    {"98", unbounded},  // glacier ice
    {"99", unbounded},  // undetermined
});

/// The greatest thickness among the polygon's stages, metres; infinite if it names none.
Checked<double> most_thickness(const OGRFeature& feature) {
  double most_m = 0.0;
  bool named = false;
  for (const std::string_view name : {"sa", "sb", "sc", "sd", "so", "cd", "cn"}) {
    const std::string code = code_of(feature, name);
    if (code.empty()) continue;
    const auto stage = std::ranges::find(stages, code, &Stage::code);
    if (stage == stages.end())
      return refuse(messages::ingest_ice_message<"stage-of-ice-unknown">(name, code));
    most_m = std::max(most_m, stage->most_m);
    named = true;
  }
  return named ? most_m : unbounded;
}

/// Attributes of the egg code in SIGRID-3; some charts contain only the first three.
constexpr auto egg_names = std::to_array<std::string_view>(
    {"CT", "CA", "SA", "FA", "CB", "SB", "FB", "CC", "SC", "FC", "SO", "SD", "CN", "CD", "CF"});
constexpr std::size_t longest_code = 4;  // CF names two forms

}  // namespace

bool states_ice_codes(const OGRFeature& feature) {
  bool total = false;
  bool others = false;
  for (int i = 0; i < feature.GetFieldCount(); ++i) {
    const std::string name = core::plain_word(feature.GetFieldDefnRef(i)->GetNameRef());
    total = total || name == total_names.front();
    others = others || name == "sa" || name == "ca" || name == polygon_names.front();
  }
  return total && others;
}

Checked<std::optional<IceOfPolygon>> read_ice_codes(const OGRFeature& feature) {
  const std::string type = core::plain_word(text_of_feature(feature, polygon_names).value_or(""));
  if (type == "l" || type == "n") return std::nullopt;
  if (type == "s") return IceOfPolygon{1.0, ice_shelf_thickness_m};
  if (!type.empty() && type != "i" && type != "w")
    return refuse(messages::ingest_ice_message<"polygon-type-unknown">(type));
  const std::string total = code_of(feature, "ct");
  const bool undetermined = total.empty() || total == "98" || total == "99";
  if (type == "w" && undetermined) return IceOfPolygon{0.0, 0.0};
  const std::optional<double> stated = undetermined ? std::optional{1.0} : most_concentration(total);
  if (!stated) return refuse(messages::ingest_ice_message<"total-concentration-unknown">(total));
  if (*stated == 0.0) return IceOfPolygon{0.0, 0.0};
  const auto thickness_m = most_thickness(feature);
  if (!thickness_m) return refuse(thickness_m.error());
  return IceOfPolygon{*stated, std::isinf(*thickness_m) ? std::nullopt : std::optional{*thickness_m}};
}

std::vector<repository::IceCode> egg_code(const OGRFeature& feature) {
  std::vector<repository::IceCode> codes;
  for (const std::string_view name : egg_names) {
    const std::string code = code_of(feature, core::plain_word(name));
    const bool is_code = !code.empty() && code.size() <= longest_code &&
                         std::ranges::all_of(code, [](char c) { return c >= '0' && c <= '9'; });
    if (is_code) codes.push_back({std::string{name}, code});
  }
  return codes;
}

}  // namespace floeplan::ingest
