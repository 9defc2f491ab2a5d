#include "storage/sql/store_address.hpp"

#include <string_view>

namespace floeplan::sql {

std::optional<StoreAddress> parse_store_address(const std::string& text) {
  constexpr std::string_view in_folder = "sqlite:";
  if (text.starts_with("postgresql://") || text.starts_with("postgres://")) return StoreAddress{{}, text};
  if (text.starts_with(in_folder) && text.size() > in_folder.size())
    return StoreAddress{text.substr(in_folder.size()), {}};
  return std::nullopt;
}

}  // namespace floeplan::sql
