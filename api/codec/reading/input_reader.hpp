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

/// Both ends included.
struct NumberRange {
  double from{};
  double to{};
};

/// Reads the members of one JSON object and collects what is wrong with them. A member that is absent or null
/// is empty; a wrong one is empty and noted, as far as `core::note` goes.
class InputReader {
 public:
  /// `pointer` is the place of the object inside the whole document, "" for the document itself.
  explicit InputReader(const nlohmann::json& object, std::string pointer = "");

  [[nodiscard]] const nlohmann::json* member(const std::string& key);
  [[nodiscard]] std::optional<std::string> text(const std::string& key, std::size_t max_length = 200);
  [[nodiscard]] std::optional<bool> boolean(const std::string& key);
  [[nodiscard]] std::optional<double> number(const std::string& key, NumberRange range);
  [[nodiscard]] std::optional<int> integer(const std::string& key, int from, int to);
  /// ISO 8601 with a zone, rounded to the whole second.
  [[nodiscard]] std::optional<core::UtcTime> time(const std::string& key);
  /// An ISO 8601 duration of days and time, as "PT1H".
  [[nodiscard]] std::optional<core::Seconds> duration(const std::string& key);
  /// [longitude, latitude]. A third number, the height that GeoJSON allows (RFC 7946, 3.1.1), is ignored.
  [[nodiscard]] std::optional<geo::LonLat> place(const std::string& key);
  /// An array of places with `least` to `most` elements.
  [[nodiscard]] std::optional<std::vector<geo::LonLat>> places(const std::string& key, std::size_t least,
                                                               std::size_t most);
  [[nodiscard]] std::optional<std::vector<geo::LonLat>> places(const nlohmann::json& value,
                                                               const std::string& pointer, std::size_t least,
                                                               std::size_t most);

  /// Notes that a member must be there, unless something is noted for it already.
  void require(const std::string& key, std::string_view what);
  /// Notes that member `key` must be there because member `other` is.
  void require_with(const std::string& other, const std::string& key, std::string_view what);
  template <messages::Code code, class... Given>
  void refuse_member(const std::string& key, const Given&... values) {
    refuse<code>(pointer_to(key), values...);
  }
  /// `pointer` is that of the whole document; the values are those of the row of `messages::request_kinds`.
  template <messages::Code code, class... Given>
  void refuse(const std::string& pointer, const Given&... values) {
    faults_.refuse<code>(pointer, values...);
  }
  /// Notes what is wrong with the members of the object at `pointer`.
  void refuse_all(const std::string& pointer, const core::Violations& violations) {
    faults_.take(violations, pointer);
  }
  /// The same, of those about which nothing is noted yet.
  void refuse_rest(const core::Violations& violations);
  /// Notes every member that nobody asked for, the first with the known ones.
  void refuse_unknown();
  [[nodiscard]] bool refused(const std::string& pointer) const;
  /// Whether nothing more is noted: a reader of many elements may leave the rest.
  [[nodiscard]] bool is_full() const { return faults_.is_full(); }
  [[nodiscard]] const core::Violations& violations() const { return faults_.found(); }
  /// What was left out of what was read, for the pilot.
  [[nodiscard]] std::vector<std::string> remarks() const;

 private:
  [[nodiscard]] std::optional<geo::LonLat> to_place(const nlohmann::json& value, const std::string& pointer);

  /// Whether the object is one, and has no such member.
  [[nodiscard]] bool lacks(const std::string& key);
  /// JSON pointer to a member of this object.
  [[nodiscard]] std::string pointer_to(const std::string& key) const;

  const nlohmann::json& object_;  // borrowed
  std::string pointer_;
  std::set<std::string> known_;
  messages::Faults faults_;
  std::size_t heights_{};  // other than 0, of places
};

/// The remark on so many places whose heights are left out.
[[nodiscard]] std::string heights_left_out(std::size_t places);

/// The value as a short text for a message.
[[nodiscard]] std::string shown(const nlohmann::json& value);

}  // namespace floeplan::codec
