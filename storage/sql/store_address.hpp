#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace floeplan::sql {

/// How the address of a store is written, for a person.
inline constexpr const char* store_address_forms = "sqlite:FOLDER or postgresql://USER@HOST/DATABASE";

/// Where the database of a store is: one of the two.
struct StoreAddress {
  std::optional<std::filesystem::path> folder;
  std::optional<std::string> server;  // as `Connection::open_at_server` takes it
};

/// Empty for a text of another form.
[[nodiscard]] std::optional<StoreAddress> parse_store_address(const std::string& text);

}  // namespace floeplan::sql
