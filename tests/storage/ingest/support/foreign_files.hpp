#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace floeplan::ingest {

/// Texts that make a library open what they name if it interprets them as a coordinate reference system.
/// `secret`  a file that no reader may open; `port`: of a listener on 127.0.0.1
[[nodiscard]] std::vector<std::string> hostile_crs_texts(const std::filesystem::path& secret, int port);

/// Writes five icebergs with a GDAL driver, then runs the SQL statements on the file.
void write_points(const char* driver, const std::filesystem::path& file,
                  const std::vector<std::string>& statements = {});

}  // namespace floeplan::ingest
