#include "storage/sql/attachment.hpp"

#include <stdexcept>
#include <utility>

#include "storage/sql/statement.hpp"

namespace floeplan::sql {

Attachment::Attachment(Connection& db, const std::filesystem::path& file, std::string name)
    : db_{db}, name_{std::move(name)} {
  Statement attach{db_, "ATTACH ?1 AS " + name_};
  attach.bind(1, file.string());
  attach.run();
}

Attachment::~Attachment() {
  try {
    execute(db_, "DETACH " + name_);
    // NOLINTNEXTLINE(bugprone-empty-catch): if the file cannot be detached, the connection is still usable
  } catch (const std::runtime_error&) {
  }
}

}  // namespace floeplan::sql
