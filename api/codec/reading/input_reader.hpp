#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/messages/fault.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

/// A range of numbers, both ends included.
struct NumberRange {
  double from{};
  double to{};
};

/// Reads the members of one JSON object and collects their faults. A member that is absent or null is empty.
/// A wrong member is empty too, and gives a violation (at most as many as `core::note` collects).
class InputReader {
 public:
  /// `pointer` is the JSON pointer of the object in the whole document; "" for the document itself.
  explicit InputReader(const nlohmann::json& object, std::string pointer = "");

  [[nodiscard]] const nlohmann::json* member(const std::string& key);
  [[nodiscard]] std::optional<std::string> text(const std::string& key, std::size_t max_length = 200);
  [[nodiscard]] std::optional<bool> boolean(const std::string& key);
  [[nodiscard]] std::optional<double> number(const std::string& key, NumberRange range);
  [[nodiscard]] std::optional<int> integer(const std::string& key, int from, int to);
  /// A time in ISO 8601 with a zone, rounded to whole seconds.
  [[nodiscard]] std::optional<core::UtcTime> time(const std::string& key);
  /// An ISO 8601 duration of days and time, as "PT1H".
  [[nodiscard]] std::optional<core::Seconds> duration(const std::string& key);
  /// [longitude, latitude]. A third number, the height that GeoJSON allows (RFC 7946, 3.1.1), is ignored.
  [[nodiscard]] std::optional<geo::LonLat> place(const std::string& key);
  /// An array of `least` to `most` positions.
  [[nodiscard]] std::optional<std::vector<geo::LonLat>> places(const std::string& key, std::size_t least,
                                                               std::size_t most);
  [[nodiscard]] std::optional<std::vector<geo::LonLat>> places(const nlohmann::json& value,
                                                               const std::string& pointer, std::size_t least,
                                                               std::size_t most);

  /// Adds a violation if the member is absent, unless it already has one.
  void require(const std::string& key, std::string_view what);
  /// Adds a violation if member `other` is present but member `key` is absent.
  void require_with(const std::string& other, const std::string& key, std::string_view what);
  template <messages::Code code, class... Given>
  void refuse_member(const std::string& key, const Given&... values) {
    refuse<code>(pointer_to(key), values...);
  }
  /// `pointer` is relative to the whole document. `values` fill the text of the message with this code in
  /// `messages::request_kinds`.
  template <messages::Code code, class... Given>
  void refuse(const std::string& pointer, const Given&... values) {
    faults_.refuse<code>(pointer, values...);
  }
  /// Adds the violations of the members of the object at `pointer`.
  void refuse_all(const std::string& pointer, const core::Violations& violations) {
    faults_.take(violations, pointer);
  }
  /// Adds those violations whose members have none yet.
  void refuse_rest(const core::Violations& violations);
  /// Adds a violation for each member that was never read; the first one lists the known members.
  void refuse_unknown();
  [[nodiscard]] bool refused(const std::string& pointer) const;
  /// Whether further violations are not collected; a reader of many elements can then stop.
  [[nodiscard]] bool is_full() const { return faults_.is_full(); }
  [[nodiscard]] const core::Violations& violations() const { return faults_.found(); }
  /// Notes for the pilot about parts of the input that are ignored.
  [[nodiscard]] std::vector<std::string> remarks() const;

 private:
  [[nodiscard]] std::optional<geo::LonLat> to_place(const nlohmann::json& value, const std::string& pointer);

  /// Whether the object is valid and does not have this member.
  [[nodiscard]] bool lacks(const std::string& key);
  /// JSON pointer of a member of this object.
  [[nodiscard]] std::string pointer_to(const std::string& key) const;

  const nlohmann::json& object_;  // borrowed
  std::string pointer_;
  std::set<std::string> known_;
  messages::Faults faults_;
  std::size_t heights_{};  // number of positions with a height other than 0
};

/// The note that the heights of this number of positions are ignored.
[[nodiscard]] std::string heights_left_out(std::size_t places);

/// The value as a short text for messages.
[[nodiscard]] std::string shown(const nlohmann::json& value);

}  // namespace floeplan::codec
