#pragma once

#include <string>

#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::ingest {

/// What tells the datasets of files apart: the digest of the content, and of what the user said that changes how data
/// of the kind are read, such as a unit. A name, or an option that the kind does not use, changes nothing.
/// Returns  the digest of the content itself where nothing of that was said
[[nodiscard]] std::string identity_of(const std::string& sha256, repository::DatasetKind kind,
                                      const IngestOptions& options);

/// Each way of keeping takes other digits of the identity, so that a file that is stored in two ways has two ids: an older
/// program may have stored it in its own way, and plans name the id of what they were made from.
[[nodiscard]] repository::DatasetId id_of(repository::DatasetKind kind, const std::string& identity,
                                          Keeping keeping);

}  // namespace floeplan::ingest
