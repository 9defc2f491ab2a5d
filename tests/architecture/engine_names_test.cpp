#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>

#include "tests/support/places.hpp"

namespace floeplan::support::engine_names_test {
namespace {

namespace fs = std::filesystem;

/// Code outside storage/sql that names a database engine or uses its SQL dialect, with the number of lines:
/// formats that are databases of that engine, and tests that inspect its files. The list and its numbers must
/// only shrink.
const std::map<std::string, int> known{
    {"server/manual/command_help.cpp", 2},
    {"storage/ingest/format_of.cpp", 1},
    {"storage/ingest/formats/vector/vector_file.cpp", 1},
    {"storage/ingest/formats/vector/vector_files.hpp", 2},
    {"tests/bench/store_bench.cpp", 1},
    {"tests/browser/support/server.ts", 1},
    {"tests/server/cli/damaged_store_test.cpp", 2},
    {"tests/server/cli/doors_test.cpp", 1},
    {"tests/server/cli/faults_test.cpp", 1},
    {"tests/server/cli/nodes_test.cpp", 6},
    {"tests/server/cli/upgrade_test.cpp", 3},
    {"tests/server/jobs/worker_pool_test.cpp", 1},
    {"tests/storage/ingest/data_formats_test.cpp", 1},
    {"tests/storage/ingest/formats/vector/geopackage_test.cpp", 1},
    {"tests/storage/ingest/hostile/archives.cpp", 1},
    {"tests/storage/ingest/hostile/databases.cpp", 5},
    {"tests/storage/ingest/hostile/gallery.cpp", 1},
    {"tests/storage/ingest/hostile/gallery_test.cpp", 3},
    {"tests/storage/ingest/hostile/hdf5.cpp", 1},
    {"tests/storage/ingest/process/guarded_ingest_test.cpp", 4},
    {"tests/storage/ingest/process/hostile_content_test.cpp", 7},
    {"tests/storage/repository/datasets/dataset_rows_test.cpp", 1},
    {"tests/storage/repository/store/damage_test.cpp", 2},
    {"tests/storage/repository/store/killed_replacement_test.cpp", 1},
    {"tests/storage/repository/store/migrations_test.cpp", 10},
    {"tests/storage/sandbox/attempts.hpp", 1},
};

/// Number of lines in each code file that name an engine.
std::map<std::string, int> lines_that_name_an_engine(const fs::path& root) {
  static const std::regex name{"sqlite|postgres|pragma (?!once)|pragma_", std::regex::icase};
  std::map<std::string, int> lines;
  for (const char* layer : {"engine", "storage", "api", "server", "web/src", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator{root / layer}) {
      const fs::path file = entry.path().lexically_relative(root);
      const fs::path ending = file.extension();
      const bool is_code = ending == ".cpp" || ending == ".hpp" || ending == ".ts" || ending == ".tsx";
      const std::string path = file.generic_string();
      if (!is_code || path.starts_with("storage/sql/") || path.starts_with("tests/storage/sql/") ||
          path.starts_with("tests/architecture/"))
        continue;
      std::ifstream in{entry.path()};
      for (std::string line; std::getline(in, line);)
        if (std::regex_search(line, name)) ++lines[path];
    }
  }
  return lines;
}

TEST(NamesOfEngines, StandOnlyInTheFolderThatKnowsThem) {
  EXPECT_THAT(lines_that_name_an_engine(source_folder()), testing::ContainerEq(known))
      << "ask storage/sql for it by a name that says what it does; take from the list what is gone";
}

TEST(NamesOfEngines, AreFoundInAnyCase) {
  const fs::path root = fs::path{testing::TempDir()} / "names_of_engines";
  fs::remove_all(root);
  for (const char* folder : {"engine", "storage/sql", "api", "server", "web/src", "tests"})
    fs::create_directories(root / folder);
  std::ofstream{root / "api/spoilt.cpp"}
      << "#pragma once\n\"PRAGMA user_version\"\n// SQLite does\nsqlite3* db;\n";
  std::ofstream{root / "storage/sql/engine.cpp"} << "\"PRAGMA user_version\"\n";
  EXPECT_THAT(lines_that_name_an_engine(root), testing::ElementsAre(testing::Pair("api/spoilt.cpp", 3)));
  fs::remove_all(root);
}

}  // namespace
}  // namespace floeplan::support::engine_names_test
