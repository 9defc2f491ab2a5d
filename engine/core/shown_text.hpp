#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"

/// Makes text from outside fit to be shown in logs, answers and lists, and distances fit for people.
namespace floeplan::core {

/// The text with "(hidden)" in place of every credential: tokens and logins ("floeplan_" and hexadecimal
/// digits), what follows "Bearer", and the value of a session cookie.
[[nodiscard]] std::string without_secrets(std::string_view text);

/// A request's target for a log, as it was sent but without secrets, even if percent-encoded several times.
/// Values of parameters whose names suggest secrets ("?token=", "?password=") are hidden. At most `most`
/// bytes.
[[nodiscard]] std::string shown_target(std::string_view target, std::size_t most = 300);

/// The text with every word of more than 100 characters cut short and its length added. The whole is cut
/// after about 2000 characters.
[[nodiscard]] std::string excerpt(std::string_view text);

/// The first ten names, separated by commas, and the number of further ones.
[[nodiscard]] std::string shortened_list(const std::vector<std::string>& names);

/// A distance for people: "812 m" below a kilometre, "3.2 km", "142 km" from 100 km on.
[[nodiscard]] std::string distance_text(Metres distance);

/// A number of things for people: "1 waypoint", "3 waypoints". `thing`: the noun in the singular; its plural ends in s.
[[nodiscard]] std::string counted(std::size_t count, std::string_view thing);

}  // namespace floeplan::core
