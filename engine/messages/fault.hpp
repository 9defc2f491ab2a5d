#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "engine/core/violation_list.hpp"
#include "engine/messages/request_messages.hpp"
#include "engine/messages/sentence.hpp"

namespace floeplan::messages {

/// What a row of requests says of a field.
template <Code code, class... Given>
[[nodiscard]] core::Violation fault(std::string field, const Given&... values) {
  return violation_of(std::move(field), make_message<request_kinds, code>(values...));
}

/// Collects the faults of an object, as far as `core::note` goes.
class Faults {
 public:
  /// `place` is that of the object inside the whole request: fields are named below it.
  explicit Faults(std::string place = "") : place_{std::move(place)} {}

  /// Notes a fault, unless the rule holds, and tells whether it does.
  template <Code code, class... Given>
  bool require(bool holds, const std::string& field, const Given&... values) {
    if (!holds) refuse<code>(field, values...);
    return holds;
  }

  template <Code code, class... Given>
  void refuse(const std::string& field, const Given&... values) {
    core::note(found_, fault<code>(place_ + field, values...));
  }

  /// Notes a number that is not within both ends; `least` and `most` are these as a person writes them.
  void within(double value, double low, double high, const char* field, std::string_view least,
              std::string_view most) {
    require<"not-between">(value >= low && value <= high, field, least, most);
  }

  /// Takes over the faults of a part of the object.
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
