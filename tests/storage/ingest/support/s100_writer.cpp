#include "tests/storage/ingest/support/s100_writer.hpp"

#include <hdf5.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace floeplan::ingest {
namespace {

constexpr std::size_t text_bytes = 64;

void put_number(hid_t object, const std::string& name, double value) {
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t attribute = H5Acreate2(object, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
  H5Aclose(attribute);
  H5Sclose(space);
}

/// Writes a code as an enumeration of one byte, as S-100 does.
void put_code(hid_t object, const std::string& name, double value) {
  const hid_t type = H5Tenum_create(H5T_NATIVE_UCHAR);
  for (unsigned char member = 0; member < 20; ++member)
    H5Tenum_insert(type, ("member " + std::to_string(member)).c_str(), &member);
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t attribute = H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
  const auto code = static_cast<unsigned char>(value);
  H5Awrite(attribute, type, &code);
  H5Aclose(attribute);
  H5Sclose(space);
  H5Tclose(type);
}

hid_t text_type(bool variable) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, variable ? H5T_VARIABLE : text_bytes);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

void put_text(hid_t object, const std::string& name, const std::string& value, bool variable = true) {
  const hid_t type = text_type(variable);
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t attribute = H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
  const char* pointed = value.c_str();
  std::string fixed = value;
  fixed.resize(text_bytes);
  H5Awrite(attribute, type, variable ? static_cast<const void*>(&pointed) : fixed.data());
  H5Aclose(attribute);
  H5Sclose(space);
  H5Tclose(type);
}

hid_t put_group(hid_t place, const std::string& name) {
  return H5Gcreate2(place, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
}

/// Group_F: code, unit and fill value of every value, as texts of variable length.
void describe(hid_t file, const S100Sample& sample) {
  const hid_t group = put_group(file, "Group_F");
  const hid_t text = text_type(true);
  const hid_t row = H5Tcreate(H5T_COMPOUND, 3 * sizeof(char*));
  std::size_t offset = 0;
  for (const char* column : {"code", "uom.name", "fillValue"}) {
    H5Tinsert(row, column, offset, text);
    offset += sizeof(char*);
  }
  std::vector<const char*> cells;
  for (const S100Sample::Value& value : sample.values)
    for (const std::string* cell : {&value.code, &value.unit, &value.fill}) cells.push_back(cell->c_str());
  const hsize_t count = sample.values.size();
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t table =
      H5Dcreate2(group, sample.feature.c_str(), row, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(table, row, H5S_ALL, H5S_ALL, H5P_DEFAULT, cells.data());
  H5Dclose(table);
  H5Sclose(space);
  H5Tclose(row);
  H5Tclose(text);
  H5Gclose(group);
}

void put_values(hid_t group, const S100Sample& sample, const S100Sample::Record& record) {
  const std::size_t numbers_bytes = sample.values.size() * sizeof(float);
  const std::size_t bytes = numbers_bytes + (record.times.empty() ? 0 : text_bytes);
  const hid_t cell = H5Tcreate(H5T_COMPOUND, bytes);
  for (std::size_t i = 0; i < sample.values.size(); ++i)
    H5Tinsert(cell, sample.values[i].code.c_str(), i * sizeof(float), H5T_IEEE_F32LE);
  const hid_t text = text_type(false);
  if (!record.times.empty()) H5Tinsert(cell, "waterLevelTime", numbers_bytes, text);
  const std::size_t nodes = record.values.front().size();
  std::vector<char> cells(nodes * bytes);
  for (std::size_t node = 0; node < nodes; ++node) {
    for (std::size_t i = 0; i < record.values.size(); ++i)
      std::memcpy(cells.data() + node * bytes + i * sizeof(float), &record.values[i].at(node), sizeof(float));
    if (!record.times.empty())
      record.times.at(node).copy(cells.data() + node * bytes + numbers_bytes, text_bytes);
  }
  H5Tclose(text);
  const std::array<hsize_t, 2> size{sample.rows, sample.columns};
  const hsize_t count = nodes;
  const hid_t space = sample.places.empty() ? H5Screate_simple(2, size.data(), nullptr)
                                            : H5Screate_simple(1, &count, nullptr);
  const hid_t table = H5Dcreate2(group, "values", cell, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(table, cell, H5S_ALL, H5S_ALL, H5P_DEFAULT, cells.data());
  H5Dclose(table);
  H5Sclose(space);
  H5Tclose(cell);
}

void put_triangles(hid_t positioning, const std::vector<std::array<int, 3>>& triangles) {
  const std::array<hsize_t, 2> size{triangles.size(), 3};
  const hid_t space = H5Screate_simple(2, size.data(), nullptr);
  const hid_t table =
      H5Dcreate2(positioning, "triangles", H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(table, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, triangles.data());
  H5Dclose(table);
  H5Sclose(space);
}

void put_places(hid_t area, const S100Sample& sample) {
  const auto& places = sample.places;
  const hid_t group = put_group(area, "Positioning");
  const hid_t place = H5Tcreate(H5T_COMPOUND, 2 * sizeof(double));
  H5Tinsert(place, "longitude", 0, H5T_IEEE_F64LE);
  H5Tinsert(place, "latitude", sizeof(double), H5T_IEEE_F64LE);
  std::vector<double> cells;
  for (const auto& [lon, lat] : places) cells.insert(cells.end(), {lon, lat});
  const hsize_t count = places.size();
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t table =
      H5Dcreate2(group, "geometryValues", place, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(table, place, H5S_ALL, H5S_ALL, H5P_DEFAULT, cells.data());
  H5Dclose(table);
  H5Sclose(space);
  H5Tclose(place);
  if (!sample.triangles.empty()) put_triangles(group, sample.triangles);
  H5Gclose(group);
}

std::string numbered(const std::string& name, const char* pattern, int number) {
  std::array<char, 16> digits{};
  std::snprintf(digits.data(), digits.size(), pattern, number);
  return name + digits.data();
}

void put_area(hid_t feature, const S100Sample& sample, int number) {
  const hid_t area = put_group(feature, numbered(sample.feature, ".%02d", number));
  for (const auto& [name, value] : std::map<std::string, double>{
           {"gridOriginLongitude", sample.west},
           {"gridOriginLatitude", sample.south},
           {"gridSpacingLongitudinal", sample.step},
           {"gridSpacingLatitudinal", sample.step},
           {"numPointsLongitudinal", static_cast<double>(sample.columns)},
           {"numPointsLatitudinal", static_cast<double>(sample.rows)},
           {"numGRP", sample.announced_records < 0.0 ? static_cast<double>(sample.records.size())
                                                     : sample.announced_records}})
    put_number(area, name, value);
  put_text(area, "startSequence", "(0,0)");
  if (!sample.places.empty()) put_places(area, sample);
  int count = 0;
  for (const S100Sample::Record& record : sample.records) {
    const hid_t group = put_group(area, numbered("Group_", "%03d", ++count));
    if (!record.time.empty()) put_text(group, "timePoint", record.time, false);
    for (const auto& [name, text] : record.texts) put_text(group, name, text);
    for (const auto& [name, number] : record.numbers) put_number(group, name, number);
    put_values(group, sample, record);
    H5Gclose(group);
  }
  H5Gclose(area);
}

}  // namespace

std::filesystem::path S100Sample::write(const std::filesystem::path& path) const {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  if (file < 0) throw std::runtime_error{"no file to write to: " + path.string()};
  put_text(file, "productSpecification", product);
  for (const auto& [name, value] : file_numbers) put_number(file, name, value);
  for (const auto& [name, value] : file_texts) put_text(file, name, value);
  describe(file, *this);
  const hid_t group = put_group(file, feature);
  for (const auto& [name, value] : feature_numbers) put_code(group, name, value);
  put_text(group, "sequencingRule.scanDirection", scan_direction);
  for (int number = 1; number <= areas; ++number) put_area(group, *this, number);
  H5Gclose(group);
  H5Fclose(file);
  return path;
}

S100Sample s111_sample(
    const std::function<std::pair<float, float>(std::size_t, std::size_t, std::size_t)>& current) {
  S100Sample sample{.product = "INT.IHO.S-111.2.0",
                    .feature = "SurfaceCurrent",
                    .values = {{"surfaceCurrentSpeed", "knot", "-9999.0"},
                               {"surfaceCurrentDirection", "arc-degree", "-9999.0"}},
                    .west = -50.05,
                    .south = 46.95,
                    .step = 0.1,
                    .columns = 3,
                    .rows = 2,
                    .records = {}};
  sample.file_numbers["depthTypeIndex"] = 1.0;  // a height or a depth
  sample.file_numbers["verticalDatum"] = 48.0;  // from the sea surface
  sample.file_numbers["surfaceCurrentDepth"] = -4.0;
  for (std::size_t time = 0; time < 2; ++time) {
    S100Sample::Record record{time == 0 ? "20260111T000000Z" : "20260111T002000Z", {{}, {}}};
    for (std::size_t row = 0; row < sample.rows; ++row) {
      for (std::size_t column = 0; column < sample.columns; ++column) {
        const auto [speed, direction] = current(column, row, time);
        record.values[0].push_back(speed);
        record.values[1].push_back(direction);
      }
    }
    sample.records.push_back(std::move(record));
  }
  return sample;
}

S100Sample s104_sample(const std::function<float(std::size_t, std::size_t, std::size_t)>& level) {
  S100Sample sample{.product = "INT.IHO.S-104.2.0",
                    .feature = "WaterLevel",
                    .values = {{"waterLevelHeight", "metre", "-9999.00"}, {"waterLevelTrend", "", "0"}},
                    .west = -50.05,
                    .south = 46.95,
                    .step = 0.1,
                    .columns = 3,
                    .rows = 2,
                    .records = {}};
  sample.file_numbers["verticalCS"] = 6499.0;           // heights upwards, metres
  sample.file_numbers["verticalCoordinateBase"] = 2.0;  // above the vertical datum
  sample.file_numbers["verticalDatum"] = 23.0;          // the lowest astronomical tide
  sample.file_numbers["verticalDatumReference"] = 1.0;
  for (std::size_t time = 0; time < 2; ++time) {
    S100Sample::Record record{time == 0 ? "20260111T000000Z" : "20260111T002000Z", {{}, {}}};
    for (std::size_t row = 0; row < sample.rows; ++row) {
      for (std::size_t column = 0; column < sample.columns; ++column) {
        record.values[0].push_back(level(column, row, time));
        record.values[1].push_back(3.0F);  // steady
      }
    }
    sample.records.push_back(std::move(record));
  }
  return sample;
}

S100Sample s104_stations() {
  S100Sample sample = s104_sample([](std::size_t, std::size_t, std::size_t) { return 0.0F; });
  sample.feature_numbers["dataCodingFormat"] = 8.0;
  sample.places = {{-52.7, 47.56}, {-53.4, 47.8}};
  sample.records.clear();
  for (const char* const name : {"St. John's", "Long Cove"}) {
    S100Sample::Record record{"", {{}, {}}};
    for (int time = 0; time < 4; ++time) {  // 0.5, 0.7, 0.9, 1.1 m, and a metre more at the second
      record.values[0].push_back(0.5F + 0.2F * static_cast<float>(time) +
                                 (sample.records.empty() ? 0.0F : 1.0F));
      record.values[1].push_back(2.0F);  // increasing
    }
    record.texts = {{"stationName", name}, {"startDateTime", "20260111T000000Z"}};
    record.numbers = {{"timeIntervalIndex", 1.0}, {"timeRecordInterval", 1200.0}};
    sample.records.push_back(std::move(record));
  }
  return sample;
}

S100Sample s102_sample(const std::vector<float>& depths_m, float uncertainty_m) {
  return {.product = "INT.IHO.S-102.3.0.0",
          .feature = "BathymetryCoverage",
          .values = {{"depth", "metres", "1000000"}, {"uncertainty", "metres", "1000000"}},
          .west = -50.05,
          .south = 46.95,
          .step = 0.1,
          .columns = 3,
          .rows = 2,
          .records = {{"00010101T000000Z", {depths_m, std::vector<float>(depths_m.size(), uncertainty_m)}}}};
}

}  // namespace floeplan::ingest
