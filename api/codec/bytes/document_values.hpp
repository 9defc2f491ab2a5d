#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/messages/message.hpp"

/// Notation of values that all documents of Floeplan share.
namespace floeplan::codec {

/// The name of a waypoint for people: S for the start, then 1, 2, ... These numbers are also the indices in
/// the JSON documents, and the row numbers of waypoint lists, which do not contain the start.
[[nodiscard]] std::string waypoint_label(std::size_t index);

/// A longitude or latitude rounded to 1e-7 degrees (1 cm).
[[nodiscard]] double document_degrees(double degrees);
/// The time in ISO 8601; null if there is none.
[[nodiscard]] nlohmann::json optional_time(const std::optional<core::UtcTime>& time);
/// The time under `key`, which a stored document must have.
/// Errors   throws std::runtime_error naming `key`
[[nodiscard]] core::UtcTime stored_time(const nlohmann::json& object, const char* key);

/// The faults of a request, at most as many as `core::note` collects: each with its place in the request, and
/// with code and values if it is in the catalogue. Texts may contain input of a client, so long words are cut
/// and credentials hidden.
[[nodiscard]] nlohmann::json errors_json(const core::Violations& violations);

[[nodiscard]] nlohmann::json messages_json(const std::vector<messages::Message>& messages);
/// Adds the member "messages", the gravest first; and their sentences as "warnings" (all messages) and
/// "dangers" (only the dangers).
void tell(nlohmann::json& document, std::vector<messages::Message> messages);
/// The messages of a stored plan document. A document of a version without message codes gives its warnings,
/// by their rank.
/// Errors   nlohmann::json::exception when a required member is missing
[[nodiscard]] std::vector<messages::Message> stored_messages(const nlohmann::json& document);

}  // namespace floeplan::codec
