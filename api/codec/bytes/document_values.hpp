#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/messages/message.hpp"

/// Values as all documents of Floeplan write them.
namespace floeplan::codec {

/// The name of a waypoint in everything that a person reads: S for the start, then 1, 2, ... These numbers are also the
/// indices of the JSON documents, and the row numbers of waypoint lists, which do not contain the start.
[[nodiscard]] std::string waypoint_label(std::size_t index);

/// "2 h 40 min", "12 min": to whole minutes.
[[nodiscard]] std::string hours_minutes(core::Seconds time);

/// A longitude or latitude to 1e-7 degrees, which is a centimetre.
[[nodiscard]] double document_degrees(double degrees);
/// ISO 8601, or null.
[[nodiscard]] nlohmann::json optional_time(const std::optional<core::UtcTime>& time);
/// A time that a stored document must have.
/// Errors   throws std::runtime_error naming `key`
[[nodiscard]] core::UtcTime stored_time(const nlohmann::json& object, const char* key);

/// What is wrong with a request, each with its place, and with code and values where the catalogue has a row for it; as
/// far as `core::note` goes. Texts may hold what a client sent: long words are cut to their beginning, and credentials
/// are hidden.
[[nodiscard]] nlohmann::json errors_json(const core::Violations& violations);

[[nodiscard]] nlohmann::json messages_json(const std::vector<messages::Message>& messages);
/// Gives a document "messages", the gravest first, and beside them their sentences: "warnings", all of them, and
/// "dangers".
void tell(nlohmann::json& document, std::vector<messages::Message> messages);
/// The messages of a stored document of ours. Of one from before there were codes, its warnings by their rank.
/// Errors   nlohmann::json::exception where a part that each has is missing
[[nodiscard]] std::vector<messages::Message> stored_messages(const nlohmann::json& document);

}  // namespace floeplan::codec
