#include "api/codec/bytes/json_text.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "engine/core/violation_list.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr std::size_t longest_place = 200;  // longest place in a message, bytes

/// Checks the text without building a document; stops at the first fault.
class Checker : public nlohmann::json_sax<json> {
 public:
  std::string fault;

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool key(string_t& name) override {
    Level& level = levels_.back();
    level.place = name;
    if (level.keys.insert(name).second) return true;
    fault = "A key stands more than once: " + core::cut_short(place(), longest_place) + ".";
    return false;
  }
  bool start_object(std::size_t) override { return deeper(false); }
  bool start_array(std::size_t) override { return deeper(true); }
  bool end_object() override { return levels_.pop_back(), true; }
  bool end_array() override { return levels_.pop_back(), true; }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    const bool too_large = error.id == 406;
    fault = too_large ? "A number is larger than a double can hold" : "The text is not JSON";
    fault += ", near byte " + std::to_string(position) + ".";
    return false;
  }

 private:
  /// An object or a list whose end has not been reached yet.
  struct Level {
    bool is_list{};
    std::set<std::string> keys{};  // keys read so far, of an object
    std::string place{};           // the last key of an object
    std::size_t values{};          // number of values read so far, of a list
  };

  bool value() {
    if (!levels_.empty() && levels_.back().is_list) ++levels_.back().values;
    return true;
  }
  bool deeper(bool is_list) {
    value();
    levels_.push_back({.is_list = is_list});
    if (levels_.size() <= static_cast<std::size_t>(max_json_depth)) return true;
    fault = "The JSON is nested deeper than " + std::to_string(max_json_depth) + " levels.";
    return false;
  }
  /// The place of the last value, as a JSON pointer.
  [[nodiscard]] std::string place() const {
    std::string text;
    for (const Level& level : levels_)
      text += "/" + (level.is_list ? std::to_string(level.values - 1) : level.place);
    return text;
  }

  std::vector<Level> levels_;
};

}  // namespace

tl::expected<json, std::string> parse_json(std::string_view text) {
  Checker checker;
  if (!json::sax_parse(text, &checker)) return tl::unexpected(checker.fault);
  return json::parse(text);
}

}  // namespace floeplan::codec
