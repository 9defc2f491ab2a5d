#include <gmock/gmock.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "storage/ingest/process/guarded_ingest.hpp"
#include "tests/storage/ingest/support/s100_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/places.hpp"

namespace floeplan::ingest::lying_s100_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double huge = 1e300;
constexpr std::size_t nodes = 64;
constexpr hid_t all = 0;  // H5S_ALL, which is a cast of C

/// A change of a good file, whose paths begin with the name of its feature.
using Lie = std::function<void(hid_t file, const std::string& feature)>;

void set_number(hid_t file, const std::string& path, const std::string& attribute, double value) {
  const hid_t object = H5Oopen(file, path.c_str(), H5P_DEFAULT);
  if (H5Aexists(object, attribute.c_str()) > 0) H5Adelete(object, attribute.c_str());
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t added = H5Acreate2(object, attribute.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(added, H5T_NATIVE_DOUBLE, &value);
  H5Aclose(added);
  H5Sclose(space);
  H5Oclose(object);
}

/// Puts a dataset of another shape in place of the one at the path. No value of it is written, so that it may be as
/// large as it likes.
void reshape(hid_t file, const std::string& path, const std::vector<hsize_t>& shape, hid_t type = -1) {
  const hid_t old = H5Dopen2(file, path.c_str(), H5P_DEFAULT);
  const hid_t of_old = H5Dget_type(old);
  H5Dclose(old);
  H5Ldelete(file, path.c_str(), H5P_DEFAULT);
  const int dimensions = static_cast<int>(shape.size());
  const hid_t space = H5Screate_simple(dimensions, shape.data(), nullptr);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  std::vector<hsize_t> chunk;
  for (const hsize_t length : shape) chunk.push_back(std::min<hsize_t>(length, 64));
  if (std::ranges::find(shape, 0U) == shape.end()) H5Pset_chunk(creation, dimensions, chunk.data());
  const hid_t put =
      H5Dcreate2(file, path.c_str(), type < 0 ? of_old : type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  ASSERT_GE(put, 0);
  H5Dclose(put);
  H5Pclose(creation);
  H5Sclose(space);
  H5Tclose(of_old);
}

void put_corners(hid_t file, const std::string& feature, std::array<std::int64_t, 3> corners) {
  const std::string path = feature + "/" + feature + ".01/Positioning/triangles";
  H5Ldelete(file, path.c_str(), H5P_DEFAULT);
  const std::array<hsize_t, 2> size{1, 3};
  const hid_t space = H5Screate_simple(2, size.data(), nullptr);
  const hid_t table =
      H5Dcreate2(file, path.c_str(), H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(table, H5T_NATIVE_INT64, all, all, H5P_DEFAULT, corners.data());
  H5Dclose(table);
  H5Sclose(space);
}

Lie in_area(const std::string& attribute, double value) {
  return [=](hid_t file, const std::string& feature) {
    set_number(file, feature + "/" + feature + ".01", attribute, value);
  };
}
Lie in_first_record(const std::string& attribute, double value) {
  return [=](hid_t file, const std::string& feature) {
    set_number(file, feature + "/" + feature + ".01/Group_001", attribute, value);
  };
}
Lie in_feature(const std::string& attribute, double value) {
  return [=](hid_t file, const std::string& feature) { set_number(file, feature, attribute, value); };
}
Lie in_file(const std::string& attribute, double value) {
  return [=](hid_t file, const std::string&) { set_number(file, "/", attribute, value); };
}
/// `path`  below the area
Lie without(const std::string& path) {
  return [=](hid_t file, const std::string& feature) {
    H5Ldelete(file, (feature + "/" + feature + ".01" + path).c_str(), H5P_DEFAULT);
  };
}
Lie with_shape(const std::string& path, const std::vector<hsize_t>& shape) {
  return [=](hid_t file, const std::string& feature) {
    reshape(file, feature + "/" + feature + ".01" + path, shape);
  };
}
Lie with_corners(std::array<std::int64_t, 3> corners) {
  return [=](hid_t file, const std::string& feature) { put_corners(file, feature, corners); };
}

/// The lies that a file with any layout of values can tell.
std::vector<std::pair<std::string, Lie>> lies_of_all() {
  std::vector<std::pair<std::string, Lie>> lies{
      {"no feature",
       [](hid_t file, const std::string& feature) { H5Ldelete(file, feature.c_str(), H5P_DEFAULT); }},
      {"no descriptions", [](hid_t file, const std::string&) { H5Ldelete(file, "Group_F", H5P_DEFAULT); }},
      {"no area", without("")},
      {"no values", without("/Group_001/values")},
      {"a record that is missing", without("/Group_001")},
      {"a record twice",
       [](hid_t file, const std::string& feature) {
         const std::string area = feature + "/" + feature + ".01";
         H5Ldelete(file, (area + "/Group_002").c_str(), H5P_DEFAULT);
         H5Lcreate_soft(("/" + area + "/Group_001").c_str(), file, (area + "/Group_002").c_str(), H5P_DEFAULT,
                        H5P_DEFAULT);
         set_number(file, area, "numGRP", 3.0);
       }},
      {"values that are their own link",
       [](hid_t file, const std::string& feature) {
         const std::string path = "/" + feature + "/" + feature + ".01/Group_001/values";
         H5Ldelete(file, path.c_str(), H5P_DEFAULT);
         H5Lcreate_soft(path.c_str(), file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
       }},
      {"values that are bare numbers",
       [](hid_t file, const std::string& feature) {
         reshape(file, feature + "/" + feature + ".01/Group_001/values", {2, 3}, H5T_NATIVE_FLOAT);
       }},
      {"no value", with_shape("/Group_001/values", {0})},
      {"values of three dimensions", with_shape("/Group_001/values", {2, 3, 4})},
      {"more values than memory", with_shape("/Group_001/values", {10'000'000, 10'000'000})},
      {"more values in a row than memory", with_shape("/Group_001/values", {1'000'000'000'000})}};
  for (const double code : {-1.0, 0.0, 255.0, nan, huge})
    lies.emplace_back("dataCodingFormat " + std::to_string(code), in_feature("dataCodingFormat", code));
  for (const double count : {-1.0, 0.0, 3.0, 1e18, nan, infinite})
    lies.emplace_back("numGRP " + std::to_string(count), in_area("numGRP", count));
  for (const double code : {-1.0, 0.0, 5.0, 1e18, nan, infinite})
    lies.emplace_back("horizontalCRS " + std::to_string(code), in_file("horizontalCRS", code));
  return lies;
}

std::vector<std::pair<std::string, Lie>> lies_of_grids() {
  std::vector<std::pair<std::string, Lie>> lies{
      {"a million columns and rows",
       [](hid_t file, const std::string& feature) {
         const std::string area = feature + "/" + feature + ".01";
         for (const char* const axis : {"Longitudinal", "Latitudinal"}) {
           set_number(file, area, std::string{"numPoints"} + axis, 1e6);
           set_number(file, area, std::string{"gridSpacing"} + axis, 1e-6);
         }
         for (const char* const record : {"/Group_001", "/Group_002"})
           reshape(file, area + record + "/values", {1'000'000, 1'000'000});
       }},
  };
  for (const std::string axis : {"Longitudinal", "Latitudinal"}) {
    for (const double count : {-3.0, 0.0, 1.0, 4.0, 1e6, 1e18, nan, infinite, -infinite})
      lies.emplace_back("numPoints" + axis + " " + std::to_string(count), in_area("numPoints" + axis, count));
    for (const double step : {-0.1, 0.0, 400.0, huge, 1e-320, nan, infinite})
      lies.emplace_back("gridSpacing" + axis + " " + std::to_string(step),
                        in_area("gridSpacing" + axis, step));
  }
  for (const std::string direction : {"Longitude", "Latitude"})
    for (const double origin : {1000.0, -huge, nan, infinite})
      lies.emplace_back("gridOrigin" + direction + " " + std::to_string(origin),
                        in_area("gridOrigin" + direction, origin));
  for (const double code : {0.0, 6.0, nan, -huge})
    lies.emplace_back("dataOffsetCode " + std::to_string(code), in_feature("dataOffsetCode", code));
  return lies;
}

std::vector<std::pair<std::string, Lie>> lies_of_places() {
  return {{"no places", without("/Positioning")},
          {"no table of places", without("/Positioning/geometryValues")},
          {"one place more than values", with_shape("/Positioning/geometryValues", {nodes + 1})},
          {"no place", with_shape("/Positioning/geometryValues", {0})},
          {"more places than memory", with_shape("/Positioning/geometryValues", {1'000'000'000'000})},
          {"all at the same place", with_shape("/Positioning/geometryValues", {nodes})}};
}

std::vector<std::pair<std::string, Lie>> lies_of_meshes() {
  std::vector<std::pair<std::string, Lie>> lies = lies_of_places();
  lies.insert(lies.end(),
              {{"more triangles than memory", with_shape("/Positioning/triangles", {1'000'000'000'000, 3})},
               {"triangles of four corners", with_shape("/Positioning/triangles", {2, 4})},
               {"triangles in a row", with_shape("/Positioning/triangles", {6})},
               {"triangles without corners", with_shape("/Positioning/triangles", {2, 0})},
               {"triangles without area", with_shape("/Positioning/triangles", {2, 3})}});
  constexpr auto most = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t corner : {std::int64_t{-1}, static_cast<std::int64_t>(nodes), std::int64_t{1} << 32,
                                    (std::int64_t{1} << 32) + 1, most, -most})
    lies.emplace_back("corner " + std::to_string(corner), with_corners({0, 1, corner}));
  return lies;
}

std::vector<std::pair<std::string, Lie>> lies_of_stations() {
  std::vector<std::pair<std::string, Lie>> lies = lies_of_places();
  lies.pop_back();  // stations may share a place
  for (const double step_s : {-1200.0, 0.0, 1e-9, 1e12, huge, nan, infinite})
    lies.emplace_back("timeRecordInterval " + std::to_string(step_s),
                      in_first_record("timeRecordInterval", step_s));
  lies.emplace_back("times that are not listed", in_first_record("timeIntervalIndex", 0.0));
  lies.emplace_back("endless series", [](hid_t file, const std::string& feature) {
    for (const char* const record : {"/Group_001", "/Group_002"})
      reshape(file, feature + "/" + feature + ".01" + record + "/values", {10'000'000});
  });
  return lies;
}

/// The sample with its values at 64 places instead of a grid.
S100Sample at_places(S100Sample sample, double data_coding_format, const std::vector<float>& values) {
  sample.feature_numbers["dataCodingFormat"] = data_coding_format;
  for (int node = 0; node < static_cast<int>(nodes); ++node)
    sample.places.emplace_back(-50.0 + 0.1 * (node % 8), 60.0 + 0.05 * (node / 8));
  for (S100Sample::Record& record : sample.records) record.values = {values, std::vector<float>(nodes, 3.0F)};
  return sample;
}

S100Sample on_a_mesh(const S100Sample& good) {
  S100Sample mesh = at_places(good, 7.0, std::vector<float>(nodes, 0.5F));
  mesh.triangles = {{0, 1, 8}, {1, 9, 8}};
  return mesh;
}

S100Sample levels() {
  return s104_sample([](std::size_t, std::size_t, std::size_t) { return 0.5F; });
}
S100Sample currents() {
  return s111_sample([](std::size_t, std::size_t, std::size_t) { return std::pair{0.5F, 60.0F}; });
}

/// S-104 and S-111 whose counts, shapes and numbers are not what their values are.
class LyingS100 : public StoreFixture {
 protected:
  std::vector<IngestReport> read(const S100Sample& sample, const Lie& lie) {
    const auto file = sample.write(path("liar.h5"));
    const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    if (lie) lie(opened, sample.feature);
    H5Fclose(opened);
    return guarded_ingest(db_, guard_, {file}, {}, core::from_unix_seconds(1.8e9), {}, {}, {});
  }

  /// Expects that the good file is stored, and that with every lie it is refused for what it says: within the
  /// bounds of its reader, which does not die of it.
  void expect_refused(const S100Sample& sample, std::vector<std::pair<std::string, Lie>> lies) {
    const auto good = read(sample, {});
    ASSERT_EQ(good.front().status, IngestStatus::stored) << words(good.front());
    for (auto& common : lies_of_all()) lies.push_back(std::move(common));
    for (const auto& [name, lie] : lies) {
      SCOPED_TRACE(sample.feature + ", " + name);
      const auto reports = read(sample, lie);
      ASSERT_EQ(reports.size(), 1U);
      const std::string told = words(reports.front());
      EXPECT_EQ(reports.front().status, IngestStatus::refused) << told;
      for (const char* const bad : {"stopped the program", "reading the file took", "reading the file needs"})
        EXPECT_THAT(told, testing::Not(testing::HasSubstr(bad)));
    }
    EXPECT_EQ(stored_datasets(), 1U);
  }

  Guard guard_{.program = support::program_folder() + "/ingest_reader", .staging = path("incoming")};
};

TEST_F(LyingS100, OfLevelsOnAGridIsRefused) { expect_refused(levels(), lies_of_grids()); }

TEST_F(LyingS100, OfCurrentsOnAGridIsRefused) { expect_refused(currents(), lies_of_grids()); }

TEST_F(LyingS100, OfLevelsAtPlacesIsRefused) {
  expect_refused(at_places(levels(), 3.0, std::vector<float>(nodes, 0.5F)), lies_of_places());
}

TEST_F(LyingS100, WithPlacesOrValuesThatAreNoNumbersIsRefused) {
  for (const double number : {nan, infinite, -infinite, huge, 91.0}) {
    for (const S100Sample& good : {levels(), currents()}) {
      SCOPED_TRACE(good.feature + " with " + std::to_string(number));
      S100Sample misplaced = at_places(good, 3.0, std::vector<float>(nodes, 0.5F));
      misplaced.places[5].second = number;
      EXPECT_EQ(read(misplaced, {}).front().status, IngestStatus::refused);
      if (number == 91.0) continue;
      const auto value = static_cast<float>(std::clamp(number, -1e38, 1e38));
      const auto report = read(at_places(good, 3.0, std::vector<float>(nodes, value)), {}).front();
      EXPECT_EQ(report.status, IngestStatus::refused);
      EXPECT_THAT(words(report), testing::Not(testing::HasSubstr("stopped the program")));
    }
  }
}

TEST_F(LyingS100, OfLevelsOnAMeshIsRefused) { expect_refused(on_a_mesh(levels()), lies_of_meshes()); }

TEST_F(LyingS100, OfCurrentsOnAMeshIsRefused) { expect_refused(on_a_mesh(currents()), lies_of_meshes()); }

TEST_F(LyingS100, OfLevelsAtStationsIsRefused) { expect_refused(s104_stations(), lies_of_stations()); }

}  // namespace
}  // namespace floeplan::ingest::lying_s100_test
