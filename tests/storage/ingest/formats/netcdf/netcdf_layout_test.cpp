#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "storage/ingest/common/gdal_guard.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::ingest::netcdf_layout_test {
namespace {

TEST(NetcdfLayout, ReadsRowsAsTheSliceHasThemInWhateverOrderTheFileHasThem) {
  const support::TemporaryFolder folder;
  register_drivers();
  for (const bool from_the_north : {false, true}) {
    for (const auto& order : {std::vector<std::string>{"time", "lat", "lon"}, {"lon", "time", "lat"}}) {
      CurrentFile content;
      content.lats = {50.0, 51.0, 52.0, 53.0, 54.0};
      if (from_the_north) std::ranges::reverse(content.lats);
      content.order = order;
      content.write(folder.path() / "sea.nc");
      const auto file = NetcdfFile::open(folder.path() / "sea.nc");
      ASSERT_TRUE(file) << reason_of(file.error());
      const NetcdfVariable& u = *file->find("uo");
      const auto layout = layout_of(*file, u);
      ASSERT_TRUE(layout) << reason_of(layout.error());
      const auto slice = read_slice(u, *layout, 1, 0);
      ASSERT_EQ(slice->size(), 20U);
      for (std::size_t first = 0; first < 5; ++first) {
        for (std::size_t count = 1; first + count <= 5; ++count) {
          const auto begin = slice->begin() + static_cast<std::ptrdiff_t>(4 * first);
          EXPECT_EQ(read_rows(u, *layout, 1, 0, first, count).value(),
                    (std::vector<double>{begin, begin + static_cast<std::ptrdiff_t>(4 * count)}));
        }
      }
    }
  }
}

}  // namespace
}  // namespace floeplan::ingest::netcdf_layout_test
