#pragma once

#include <cstdint>
#include <span>

#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Scripts that convert each schema to the next. A released script is never changed; new ones are added at
/// the end. Foreign keys are not enforced while a script runs, so that a table can be rebuilt; they are
/// checked at the end. Longitudes in the box tables increase eastwards from [-180, 180), so a box across the
/// antimeridian ends beyond 180 degrees.
[[nodiscard]] std::span<const char* const> schema_scripts();

/// The same for stores that database servers keep. The first script makes a whole store, with the tables and
/// columns of the files' schema `first_server_schema`; triggers, keys and indices are in the server's own
/// words. From there on, the two lists are numbered independently.
[[nodiscard]] std::span<const char* const> server_scripts();

inline constexpr std::int64_t first_server_schema = 17;

/// A program that knows this schema may work on a server's store of the newest schema, because later scripts
/// only added what it need not know. Whoever writes a script that changes existing tables raises this number.
/// So nodes of two neighbouring versions work together while a new version is rolled out.
inline constexpr std::int64_t server_schema_usable_from = 20;  // a dataset may be of water levels

/// The schema that this program writes. Stores with older schemas are converted to it, newer ones are refused.
[[nodiscard]] std::int64_t newest_schema(sql::Engine engine = sql::Engine::embedded);

/// Since this schema the pages of a database have checksums.
inline constexpr std::int64_t first_schema_with_checksums = 12;

/// Errors  std::runtime_error for a schema that this program does not know yet
void refuse_newer_schema(std::int64_t schema, sql::Engine engine = sql::Engine::embedded);

/// Migrates a database from any older schema, or an empty one, to the newest schema in one transaction. A newer schema
/// of a server's store that this program may work on stays as it is.
/// Errors  std::runtime_error for another newer schema, and when rows refer to rows that do not exist
void bring_to_newest_schema(sql::Connection& db);

}  // namespace floeplan::repository
