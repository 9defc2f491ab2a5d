#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/progress.hpp"
#include "storage/repository/store/stored_things.hpp"

namespace floeplan::repository {

/// What of a store cannot be read any more, or is not what was written.
struct Damage {
  std::vector<StoredThing> things;   // as users know them
  std::vector<std::string> tables;   // with rows that belong to no thing, such as "audit"
  std::vector<std::uint32_t> pages;  // of the database, from 1: every one that has changed, whatever it holds
  std::string structure;  // what the database's own check says where no page has changed; empty: nothing

  [[nodiscard]] bool is_none() const {
    return things.empty() && tables.empty() && pages.empty() && structure.empty();
  }
};

/// Reads all of a store: every page with its checksum, everything that users know by name, every block of samples. Others
/// may use the store meanwhile.
/// Errors  sql::Failure when the store cannot be opened, its schema is damaged, or it fails otherwise
[[nodiscard]] Damage find_damage(sql::Connection& db, const core::ProgressCallback& progress = {});

}  // namespace floeplan::repository
