#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "engine/core/violation_list.hpp"
#include "engine/messages/request_messages.hpp"
#include "engine/messages/sentence.hpp"

namespace floeplan::messages {

/// The violation of a field, with the text of a row of the request messages.
template <Code code, class... Given>
[[nodiscard]] core::Violation fault(std::string field, const Given&... values) {
  return violation_of(std::move(field), make_message<request_kinds, code>(values...));
}

/// Collects the violations of an object, up to the limit of `core::note`.
class Faults {
 public:
  /// `place`: path of the object in the whole request; the fields' paths begin with it.
  explicit Faults(std::string place = "") : place_{std::move(place)} {}

  /// Adds a violation unless the rule holds. Returns whether it holds.
  template <Code code, class... Given>
  bool require(bool holds, const std::string& field, const Given&... values) {
    if (!holds) refuse<code>(field, values...);
    return holds;
  }

  template <Code code, class... Given>
  void refuse(const std::string& field, const Given&... values) {
    core::note(found_, fault<code>(place_ + field, values...));
  }

  /// Adds a violation if `value` is outside [low, high]. `least` and `most`: these limits as text.
  void within(double value, double low, double high, const char* field, std::string_view least,
              std::string_view most) {
    require<"not-between">(value >= low && value <= high, field, least, most);
  }

  /// Adds the violations of a part of the object, with the part's path before their fields.
  void take(core::Violations of_part, const std::string& part = "") {
    for (core::Violation& violation : of_part) {
      violation.field = place_ + part + violation.field;
      core::note(found_, std::move(violation));
    }
  }

  [[nodiscard]] bool is_full() const { return core::is_full(found_); }
  [[nodiscard]] const core::Violations& found() const { return found_; }

 private:
  std::string place_;
  core::Violations found_;
};

}  // namespace floeplan::messages
