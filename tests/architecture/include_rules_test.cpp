#include "tests/architecture/include_rules.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "tests/support/places.hpp"

namespace floeplan::support::include_rules_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A copy of the four layers that a test may change; removed at the end of the test.
class SpoiltTree : public testing::Test {
 protected:
  SpoiltTree() {
    for (const char* layer : {"engine", "storage", "api", "server"}) {
      fs::create_directories(root_ / layer);
      fs::copy(fs::path{support::source_folder()} / layer, root_ / layer, fs::copy_options::recursive);
    }
  }
  ~SpoiltTree() override { fs::remove_all(root_); }

  void append(const fs::path& file, const std::string& line) const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream{root_ / file, std::ios::app} << line << '\n';
  }

  /// The faults that the test has caused; another test reports those of the tree itself.
  [[nodiscard]] std::vector<std::string> new_faults() const {
    const std::vector<std::string> known = broken_include_rules(support::source_folder());
    std::vector<std::string> faults = broken_include_rules(root_);
    std::erase_if(faults, [&](const std::string& fault) { return std::ranges::count(known, fault) > 0; });
    return faults;
  }

  const fs::path root_ = fs::path{testing::TempDir()} / ("include_rules_" + std::to_string(::getpid()));
};

TEST(IncludeRules, HoldInThisTree) { EXPECT_THAT(broken_include_rules(support::source_folder()), IsEmpty()); }

TEST_F(SpoiltTree, ShowsAnArrowThatPointsBack) {
  append("engine/core/units.hpp", "#include \"engine/geo/lon_lat.hpp\"");
  append("engine/graph/grid_graph.hpp", "#include \"engine/ocean/ice/iceberg.hpp\"");

  EXPECT_THAT(new_faults(),
              ElementsAre(HasSubstr("engine/core must not use \"engine/geo/lon_lat.hpp\""),
                          HasSubstr("engine/graph must not use \"engine/ocean/ice/iceberg.hpp\"")));
}

TEST_F(SpoiltTree, ShowsStorageInTheEngineAndAvoidanceThatSeesTheOcean) {
  append("engine/avoidance/spoilt.cpp", "#include \"engine/ocean/currents/current_field.hpp\"");
  append("engine/planning/problem/plan.hpp", "#include \"storage/repository/datasets/dataset.hpp\"");

  EXPECT_THAT(new_faults(), ElementsAre(HasSubstr("engine/avoidance/spoilt.cpp:1: "),
                                        HasSubstr("engine/planning/problem must not use")));
}

TEST_F(SpoiltTree, ShowsRoomsOfReadersThatLeanOnEachOther) {
  append("storage/ingest/grids/row_mesh.hpp",
         "#include \"storage/ingest/readers/velocity/velocity_pair.hpp\"");
  append("storage/ingest/readers/icebergs/iceberg_rows.hpp",
         "#include \"storage/ingest/readers/zones/zone_reader.hpp\"");

  EXPECT_THAT(new_faults(), ElementsAre(HasSubstr("storage/ingest/grids must not use"),
                                        HasSubstr("storage/ingest/readers/icebergs must not use")));
}

TEST_F(SpoiltTree, ShowsJobsAndHttpThatSeeEachOther) {
  append("server/http/message.hpp", "#pragma once");
  append("server/http/spoilt.cpp", "#include \"server/jobs/spoilt.cpp\"");
  append("server/jobs/spoilt.cpp", "#include \"server/http/message.hpp\"");

  EXPECT_THAT(new_faults(),
              ElementsAre(HasSubstr("server/http must not use"), HasSubstr("server/jobs must not use")));
}

TEST_F(SpoiltTree, ShowsALibraryInTheWrongFolder) {
  append("engine/core/units.hpp", "  # include <iostream> // why not");
  append("engine/core/units.hpp", "#include <nlohmann/json.hpp>");
  append("engine/core/units.hpp", "#include <thread>");
  append("engine/core/units.hpp", "#include <gdal_priv.h>");
  append("engine/core/units.hpp", "#include <boost/beast.hpp>");
  append("engine/core/units.hpp", "#include <fstream>");
  append("engine/core/units.hpp", "#include <sqlite3.h>");
  append("storage/repository/datasets/dataset.hpp", "#include <SQLiteCpp/Database.h>");

  const std::vector<std::string> faults = new_faults();

  EXPECT_EQ(faults.size(), 8u);
  EXPECT_THAT(faults, testing::Each(HasSubstr("must not know <")));
}

TEST_F(SpoiltTree, ShowsAnIncludeThatDoesNotStartAtTheRoot) {
  append("engine/geo/bearing.hpp", "#include \"lon_lat.hpp\"");
  append("engine/geo/bearing.hpp", "#include \"../geo/lon_lat.hpp\"");

  const std::vector<std::string> faults = new_faults();

  EXPECT_EQ(faults.size(), 2u);
  EXPECT_THAT(faults, testing::Each(HasSubstr("is no path from the root")));
}

TEST_F(SpoiltTree, ShowsAFolderWithoutRules) {
  append("engine/misc/spoilt.hpp", "#pragma once");

  EXPECT_THAT(new_faults(), ElementsAre(HasSubstr("engine/misc is not in the list")));
}

}  // namespace
}  // namespace floeplan::support::include_rules_test
