#include <array>
#include <fstream>

#include "tests/storage/ingest/hostile/makers.hpp"
#include "tests/storage/ingest/support/foreign_files.hpp"
#include "tests/storage/ingest/support/grib_writer.hpp"

namespace floeplan::ingest {
namespace {

namespace fs = std::filesystem;

// Classic NetCDF: tags of its lists, and of type double.
constexpr int dimension_list = 10;
constexpr int variable_list = 11;
constexpr int double_type = 6;

std::string netcdf_name(const std::string& name) {
  return big_endian(name.size(), 4) + name + std::string((4 - name.size() % 4) % 4, '\0');
}

/// A header with one variable over `dimensions`, and a few bytes of data.
std::string classic_netcdf(int version, const std::vector<std::uint64_t>& dimensions, std::uint64_t begin) {
  const std::string nothing = big_endian(0, 8);
  std::string text = "CDF" + std::string(1, static_cast<char>(version)) + big_endian(0, 4);
  text += big_endian(dimension_list, 4) + big_endian(dimensions.size(), 4);
  for (std::size_t i = 0; i < dimensions.size(); ++i)
    text += netcdf_name("d" + std::to_string(i)) + big_endian(dimensions[i], 4);
  text += nothing + big_endian(variable_list, 4) + big_endian(1, 4) + netcdf_name("uo") +
          big_endian(dimensions.size(), 4);
  for (std::size_t i = 0; i < dimensions.size(); ++i) text += big_endian(i, 4);
  text += nothing + big_endian(double_type, 4) + big_endian(0xFFFFFFFF, 4) +
          big_endian(begin, version == 1 ? 4 : 8);
  return text + std::string(64, '\1');
}

void add_netcdf(std::vector<HostileFile>& gallery, std::mt19937_64& rng) {
  const auto large = static_cast<std::uint64_t>(number_in(rng, 0x10000, 0x7fffffff));
  const int version = static_cast<int>(number_in(rng, 1, 2));
  gallery.push_back(hostile_text("NetCDF classic", "more memory than any machine has", "a.nc",
                                 classic_netcdf(version, {large, large, large}, 200)));
  gallery.push_back(hostile_text("NetCDF classic", "bytes behind the end of the file", "a.nc",
                                 classic_netcdf(version, {2, 2, 2}, 0xFFFFFF00)));
  gallery.push_back(hostile_text("NetCDF classic", "a name of two gigabytes", "a.nc",
                                 "CDF\x01" + big_endian(0, 4) + big_endian(dimension_list, 4) +
                                     big_endian(large, 4) + big_endian(0x7fffffff, 4) + "lat"));
}

void add_grib(std::vector<HostileFile>& gallery, std::mt19937_64& rng) {
  GribMessage message;
  message.value = [](double, double) { return 0.1; };
  const std::string good = message.octets();
  const auto with = [&](std::size_t at, const std::string& octets) {
    std::string bad = good;
    return bad.replace(at, octets.size(), octets);
  };
  const std::size_t grid = good.find(std::string("\0\0\0\x48\x03", 5));  // section 3 with 72 octets
  const auto large = static_cast<std::uint64_t>(number_in(rng, 1 << 20, 0x7fffffff));
  gallery.push_back(
      hostile_text("GRIB", "a message of exabytes", "a.grb2", with(8, big_endian(1ULL << 62, 8))));
  gallery.push_back(hostile_text("GRIB", "a section that never ends", "a.grb2", with(16, big_endian(0, 4))));
  gallery.push_back(
      hostile_text("GRIB", "a section beyond the file", "a.grb2", with(16, big_endian(large, 4))));
  if (grid != std::string::npos)
    gallery.push_back(hostile_text("GRIB", "a grid larger than its values", "a.grb2",
                                   with(grid + 30, big_endian(large, 4) + big_endian(large, 4))));
  gallery.push_back(
      hostile_text("GRIB", "thousands of messages", "a.grb2",
                   repeated(good.substr(0, static_cast<std::size_t>(number_in(rng, 20, 100))), 5000)));
}

/// A little-endian TIFF with these entries (tag, type, count, value) in its one directory, which `next` follows.
std::string tiff(const std::vector<std::array<std::uint64_t, 4>>& entries, std::uint64_t next,
                 const std::string& tail) {
  std::string text = "II*" + std::string(1, '\0') + little_endian(8, 4) + little_endian(entries.size(), 2);
  for (const auto& entry : entries)
    text += little_endian(entry[0], 2) + little_endian(entry[1], 2) + little_endian(entry[2], 4) +
            little_endian(entry[3], 4);
  return text + little_endian(next, 4) + tail;
}

void add_geotiff(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  const auto large = static_cast<std::uint64_t>(number_in(rng, 1 << 20, 0x7fffffff));
  const auto entries = [&](std::uint64_t width, std::uint64_t strips) {
    return std::vector<std::array<std::uint64_t, 4>>{
        {256, 4, 1, width},    {257, 4, 1, width}, {258, 3, 1, 32},    {259, 3, 1, 1},        {262, 3, 1, 1},
        {273, 4, strips, 200}, {277, 3, 1, 1},     {278, 4, 1, width}, {279, 4, strips, 200}, {339, 3, 1, 3}};
  };
  gallery.push_back(hostile_text("GeoTIFF", "more memory than any machine has", "bed.tif",
                                 tiff(entries(large, 1), 0, std::string(400, '\1'))));
  gallery.push_back(hostile_text("GeoTIFF", "directories that follow themselves", "bed.tif",
                                 tiff(entries(8, 1), 8, std::string(400, '\1'))));
  gallery.push_back(hostile_text("GeoTIFF", "strips without number", "bed.tif",
                                 tiff(entries(8, 0xFFFFFFFF), 0, std::string(400, '\1'))));
  // 42112: GDAL's own metadata, which may name a file of overviews.
  auto with_metadata = entries(8, 1);
  const std::string metadata = "<GDALMetadata><Item name=\"OVERVIEW_FILE\" domain=\"OVERVIEWS\">" +
                               picked(rng, places_to_open(aims)) + "</Item></GDALMetadata>" +
                               std::string(1, '\0');
  with_metadata.push_back({42112, 2, metadata.size(), 600});
  std::string tail(600 - tiff(with_metadata, 0, "").size(), '\1');
  gallery.push_back(hostile_text("GeoTIFF", "overviews in another file", "bed.tif",
                                 tiff(with_metadata, 0, tail + metadata)));
}

/// A shapefile's header, in 16-bit words.
std::string shape_header(std::uint64_t words, std::uint64_t type) {
  return big_endian(9994, 4) + std::string(20, '\0') + big_endian(words, 4) + little_endian(1000, 4) +
         little_endian(type, 4) + std::string(64, '\0');
}

void add_shapefiles(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  const auto large = static_cast<std::uint64_t>(number_in(rng, 1 << 20, 0x7fffffff));
  gallery.push_back(
      {"shapefile", "points without number and records beyond the file", [large](const fs::path& folder) {
         const std::string record = big_endian(1, 4) + big_endian(large, 4) + little_endian(5, 4) +
                                    std::string(32, '\0') + little_endian(large, 4) + little_endian(large, 4);
         std::ofstream{folder / "bergs.shp", std::ios::binary} << shape_header(large, 5) + record;
         std::ofstream{folder / "bergs.shx", std::ios::binary}
             << shape_header(large, 5) + big_endian(50, 4) + big_endian(large, 4);
         std::ofstream{folder / "bergs.dbf", std::ios::binary}
             << "\x03\x1a\x01\x01" + little_endian(large, 4) + little_endian(65, 2) +
                    little_endian(65535, 2) + std::string(52, '\0') + "\r";
         return std::vector{folder / "bergs.shp", folder / "bergs.shx", folder / "bergs.dbf"};
       }});
  for (int i = 0; i < 2; ++i)
    gallery.push_back({"shapefile", "a reference system and an encoding from elsewhere",
                       [text = picked(rng, hostile_crs_texts(aims.secret, aims.port)),
                        place = picked(rng, places_to_open(aims))](const fs::path& folder) {
                         write_points("ESRI Shapefile", folder / "bergs.shp");
                         std::ofstream{folder / "bergs.prj", std::ios::binary} << text;
                         std::ofstream{folder / "bergs.cpg", std::ios::binary} << place;
                         return std::vector{folder / "bergs.shp", folder / "bergs.shx", folder / "bergs.dbf",
                                            folder / "bergs.prj", folder / "bergs.cpg"};
                       }});
}

void add_charts(std::vector<HostileFile>& gallery, std::mt19937_64& rng) {
  const std::string far = std::to_string(number_in(rng, 50'000, 99'999));
  const auto leader = [](const std::string& length, const std::string& area, const std::string& map) {
    return length + "3LE1 09" + area + " ! " + map;
  };
  gallery.push_back(hostile_text("S-57", "a record beyond the file", "A.000",
                                 leader(far, far, "3404") + repeated("0000123000000000000", 20) + "\x1e"));
  gallery.push_back(hostile_text("S-57", "a directory of entries of no size", "A.000",
                                 leader("00240", "00201", "0000") + std::string(216, '0') + "\x1e"));
  gallery.push_back(hostile_text("S-57", "records of no length", "A.000",
                                 repeated(leader("00000", "00024", "3404"), number_in(rng, 1000, 5000))));
}

void add_glider_logs(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  const auto head = [](const std::string& tags, const std::string& sensors, const std::string& crc) {
    return "dbd_label:    DBD(dinkum_binary_data)file\nencoding_ver:    5\nnum_ascii_tags:    " + tags +
           "\nfull_filename:    ../../etc/passwd\nfilename_extension:    dbd\ntotal_num_sensors:    " +
           sensors + "\nsensors_per_cycle:    " + sensors + "\nstate_bytes_per_cycle:    " + sensors +
           "\nsensor_list_crc:    " + crc + "\nsensor_list_factored:    1\n";
  };
  const std::string many = std::to_string(number_in(rng, 1 << 30, 0x7fffffff));
  gallery.push_back(hostile_text("Slocum binary", "more sensors than there are", "a.dbd",
                                 head("10", many, "0a1b2c3d") + std::string(200, 'd')));
  gallery.push_back(
      hostile_text("Slocum binary", "tags without number", "a.dbd", head(many, "6", "0a1b2c3d")));
  gallery.push_back(hostile_text(
      "Slocum binary", "a list of sensors from elsewhere", "a.dbd",
      head("10", "6", "../../../" + picked(rng, places_to_open(aims))) + "sa" + std::string(64, '\2')));
  // Compressed logs: blocks of a length in two octets and LZ4; the letters are copied over and over.
  gallery.push_back(hostile_text(
      "Slocum binary", "gigabytes out of a few blocks", "a.dcd",
      repeated(big_endian(8, 2) + "\x1f" + "d" + little_endian(1, 2) + std::string(4, '\xff'), 5000)));
}

}  // namespace

void add_hostile_octets(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  add_netcdf(gallery, rng);
  add_grib(gallery, rng);
  add_geotiff(gallery, aims, rng);
  add_shapefiles(gallery, aims, rng);
  add_charts(gallery, rng);
  add_glider_logs(gallery, aims, rng);
}

}  // namespace floeplan::ingest
