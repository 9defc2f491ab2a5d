#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/progress.hpp"
#include "storage/repository/store/stored_things.hpp"

namespace floeplan::repository {

/// The parts of a store that cannot be read, or whose bytes have changed.
struct Damage {
  std::vector<StoredThing> things;   // damaged things, by the names that users know
  std::vector<std::string> tables;   // tables with damaged rows of no thing, such as "audit"
  std::vector<std::uint32_t> pages;  // changed pages of the database, counted from 1, whatever they contain
  std::string structure;  // fault found by the database's own check although no page has changed; empty: none

  [[nodiscard]] bool is_none() const {
    return things.empty() && tables.empty() && pages.empty() && structure.empty();
  }
};

/// Reads the whole store: every page with its checksum, everything that users know by name, every block of
/// samples. Others may use the store at the same time.
/// Errors  sql::Failure when the store cannot be opened, its schema is damaged, or it fails otherwise
[[nodiscard]] Damage find_damage(sql::Connection& db, const core::ProgressCallback& progress = {});

}  // namespace floeplan::repository
