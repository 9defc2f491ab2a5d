#include "storage/ingest/formats/hdf5/hdf5_references.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::hdf5_references_test {
namespace {

/// Good currents, to which something is added that lies in another file.
class Hdf5References : public StoreFixture {
 protected:
  Hdf5References() {
    CurrentFile{}.write(file_);
    opened_ = H5Fopen(file_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    EXPECT_GE(opened_, 0);
  }

  void add_dataset(hid_t creation) const {
    const std::array<hsize_t, 2> size{3, 4};
    const hid_t space = H5Screate_simple(2, size.data(), nullptr);
    const hid_t dataset =
        H5Dcreate2(opened_, "outside", H5T_NATIVE_FLOAT, space, H5P_DEFAULT, creation, H5P_DEFAULT);
    EXPECT_GE(dataset, 0);
    H5Dclose(dataset);
    H5Sclose(space);
    H5Pclose(creation);
  }

  void expect_refused_for(const std::string& reason) {
    H5Fclose(opened_);
    expect_refused(file_, reason);
  }

  const std::filesystem::path file_{path("currents.nc")};
  hid_t opened_{-1};
};

TEST_F(Hdf5References, AreNotMissedInALink) {
  ASSERT_GE(H5Lcreate_external("other.nc", "/uo", opened_, "outside", H5P_DEFAULT, H5P_DEFAULT), 0);

  expect_refused_for("\"outside\" is a link to another file");
}

TEST_F(Hdf5References, OfTextsThatGoBeyondTheirHeapAreRefusedBeforeTheyAreFollowed) {
  H5Fclose(opened_);
  std::ifstream in{file_, std::ios::binary};
  std::string bytes{std::istreambuf_iterator<char>{in}, {}};
  const std::size_t heap = bytes.find("GCOL");
  ASSERT_NE(heap, std::string::npos);
  for (const std::size_t byte : {std::size_t{25}, std::size_t{27}, std::size_t{31}}) {  // of the first size
    std::string damaged = bytes;
    damaged[heap + byte] = '\x7F';
    write_file("damaged.nc", damaged);
    expect_refused(path("damaged.nc"), "a text goes beyond its heap");
  }
}

TEST_F(Hdf5References, AreNotMissedInAVirtualDataset) {
  const std::array<hsize_t, 2> size{3, 4};
  const hid_t space = H5Screate_simple(2, size.data(), nullptr);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  ASSERT_GE(H5Pset_virtual(creation, space, "other.nc", "/uo", space), 0);
  H5Sclose(space);
  add_dataset(creation);

  expect_refused_for("\"outside\" is put together from other files");
}

TEST_F(Hdf5References, AreNotMissedInValuesThatLieElsewhere) {
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  ASSERT_GE(H5Pset_external(creation, "/etc/hostname", 0, 48), 0);
  add_dataset(creation);

  expect_refused_for("\"outside\" has its values in another file");
}

TEST_F(Hdf5References, AreNotMissedBelowGroups) {
  hid_t group = opened_;
  for (const char* const name : {"a", "b", "c"})
    group = H5Gcreate2(group, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(H5Lcreate_external("other.nc", "/uo", group, "outside", H5P_DEFAULT, H5P_DEFAULT), 0);

  expect_refused_for("\"a/b/c/outside\" is a link to another file");
}

TEST_F(Hdf5References, AreNotHiddenBehindWhatCannotBeRead) {
  const hid_t group = H5Gcreate2(opened_, "a", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5O_info_t place{};
  ASSERT_GE(H5Oget_info1(group, &place), 0);
  H5Gclose(group);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  ASSERT_GE(H5Pset_external(creation, "/etc/hostname", 0, 48), 0);
  add_dataset(creation);
  H5Fclose(opened_);
  std::ifstream in{file_, std::ios::binary};
  const std::string whole{std::istreambuf_iterator<char>{in}, {}};
  const std::size_t names_of_other_files = whole.find("HEAP");
  ASSERT_LT(std::max(static_cast<std::size_t>(place.addr), names_of_other_files), whole.size());

  for (const std::size_t damage : {static_cast<std::size_t>(place.addr), names_of_other_files}) {
    std::string bytes = whole;
    write_file("damaged.nc", bytes.replace(damage, 4, "GONE"));
    EXPECT_FALSE(check_hdf5_references(path("damaged.nc")).has_value()) << damage;
    expect_refused(path("damaged.nc"), "");
  }
}

TEST_F(Hdf5References, AreNotTakenForWhatASoftLinkLeadsTo) {
  ASSERT_GE(H5Lcreate_soft("/uo", opened_, "inside", H5P_DEFAULT, H5P_DEFAULT), 0);
  H5Fclose(opened_);
  EXPECT_TRUE(check_hdf5_references(file_).has_value());
}

TEST_F(Hdf5References, AreRefusedOfPackingThatIsAPlugin) {
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  const std::array<hsize_t, 2> chunk{3, 4};
  H5Pset_chunk(creation, 2, chunk.data());
  constexpr H5Z_filter_t blosc = 32001;
  ASSERT_GE(H5Pset_filter(creation, blosc, H5Z_FLAG_OPTIONAL, 0, nullptr), 0);
  add_dataset(creation);

  expect_refused_for("\"outside\" is packed by a method that this program does not have");
}

}  // namespace
}  // namespace floeplan::ingest::hdf5_references_test
