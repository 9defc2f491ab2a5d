#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "storage/repository/work/job_repository.hpp"

namespace floeplan::codec {

/// A job as statusInfo of OGC API - Processes. Links are absolute and begin with `public_url`.
[[nodiscard]] nlohmann::json job_document(const repository::JobRecord& job, const std::string& public_url);

[[nodiscard]] bool is_finished(repository::JobStatus status);

}  // namespace floeplan::codec
