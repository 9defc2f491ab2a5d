#pragma once

#include <string>

#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::ingest {

/// The identity of a dataset from a file: a digest of the content and of the options that change how data of
/// the kind are read, such as a unit. A name, or an option that the kind does not use, is not included.
/// Returns  the digest of the content itself if none of these options is given
[[nodiscard]] std::string identity_of(const std::string& sha256, repository::DatasetKind kind,
                                      const IngestOptions& options);

/// The id takes other digits of the identity for each `Keeping`, so the same file has another id when it is
/// stored in another way. Older programs stored files in other ways, and plans refer to the ids of their data.
[[nodiscard]] repository::DatasetId id_of(repository::DatasetKind kind, const std::string& identity,
                                          Keeping keeping);

}  // namespace floeplan::ingest
