#include "api/codec/json_text.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

/// Walks the text without building anything; stops at the first fault.
class Checker : public nlohmann::json_sax<json> {
 public:
  std::string fault;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return deeper(); }
  bool start_array(std::size_t) override { return deeper(); }
  bool end_object() override { return --depth_, true; }
  bool end_array() override { return --depth_, true; }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    const bool too_large = error.id == 406;
    fault = too_large ? "A number is larger than a double can hold" : "The text is not JSON";
    fault += ", near byte " + std::to_string(position) + ".";
    return false;
  }

 private:
  bool deeper() {
    if (++depth_ <= max_json_depth) return true;
    fault = "The JSON is nested deeper than " + std::to_string(max_json_depth) + " levels.";
    return false;
  }

  int depth_{0};
};

}  // namespace

tl::expected<json, std::string> parse_json(std::string_view text) {
  Checker checker;
  if (!json::sax_parse(text, &checker)) return tl::unexpected(checker.fault);
  return json::parse(text);
}

}  // namespace floeplan::codec
