#include "tests/storage/ingest/hostile/makers.hpp"
#include "tests/storage/ingest/support/foreign_files.hpp"

namespace floeplan::ingest {
namespace {

const std::string small_grid = "-9 -8 -7\n-6 -5 -4\n";

std::string grid_head(const std::string& columns, const std::string& rows, const std::string& cell) {
  return "ncols " + columns + "\nnrows " + rows + "\nxllcorner 0\nyllcorner 50\ncellsize " + cell + "\n";
}

void add_grids(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  const std::string many = std::to_string(number_in(rng, 1'000'000'000, 4'000'000'000'000));
  gallery.push_back(hostile_text("ASCII grid", "memory for more nodes than there are", "bed.asc",
                                 grid_head(many, many, "1e-9") + small_grid));
  gallery.push_back(
      hostile_text("ASCII grid", "a grid of no size", "bed.asc", grid_head("-3", "0", "nan") + small_grid));
  gallery.push_back(
      hostile_text("ASCII grid", "a line without end", "bed.asc",
                   grid_head("3", "2", "0.5") + repeated("-9 ", number_in(rng, 300'000, 600'000))));
  gallery.push_back(
      {"ASCII grid", "a reference system from elsewhere beside it",
       [text = picked(rng, hostile_crs_texts(aims.secret, aims.port))](const std::filesystem::path& folder) {
         const auto grid = hostile_text("", "", "bed.asc", grid_head("3", "2", "9000") + small_grid);
         auto files = grid.write(folder);
         files.push_back(hostile_text("", "", "bed.prj", text).write(folder).front());
         return files;
       }});
  for (int i = 0; i < 2; ++i) {
    HostileFile grid = hostile_text("CRS text", "what is named in place of a reference system", "bed.asc",
                                    grid_head("3", "2", "9000") + small_grid);
    grid.crs = picked(rng, hostile_crs_texts(aims.secret, aims.port));
    gallery.push_back(std::move(grid));
  }
  gallery.push_back(hostile_text(
      "XYZ", "a grid over all the world in steps of nothing", "bed.xyz",
      "0 50 -9\n1e-13 50 -9\n" + std::to_string(number_in(rng, 1, 179)) + " 89 -9\n-180 -90 -9\n"));
  gallery.push_back(hostile_text("XYZ", "numbers beyond all", "bed.xyz",
                                 "1e308 1e308 -1e308\n1e309 -1e309 nan\ninf -inf 1e-400\n"));
  gallery.push_back(
      hostile_text("depth table", "a field without end", "bed.csv",
                   "lon,lat,depth_m\n-53,69,\"" + repeated("\"\"x", number_in(rng, 100'000, 200'000))));
  gallery.push_back(hostile_text(
      "depth table", "what a column names", "bed.csv",
      "lon,lat,depth_m\n-53,69," + picked(rng, places_to_open(aims)) + "\n-52.99,69,=cmd|'/c id'!A1\n"));
}

void add_icebergs(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  const std::string place = picked(rng, places_to_open(aims));
  gallery.push_back(hostile_text("ice patrol", "what is named in place of a number", "bergs.csv",
                                 "ICEBERG_YEAR,ICEBERG_NUMBER,SIGHTING_DATE,SIGHTING_TIME,SIGHTING_LATITUDE,"
                                 "SIGHTING_LONGITUDE,SIGHTING_METHOD,SIZE,SHAPE\n2021," +
                                     place +
                                     ",02/11/2021,1230,48.5,-49.2,R,MED,NTB\n2021,99999999999999999999,"
                                     "99/99/9999,9999,1e400,-1e400,\x01,\xff,\n"));
  gallery.push_back(hostile_text(
      "iceberg table", "rows that never end", "bergs.csv",
      "Iceberg,Length (NM),Width (NM),Latitude,Longitude,Remarks,Last Update\n" +
          repeated("A23A,1e99,-1,91,181," + place + ",13/32/0000\n", number_in(rng, 5000, 20'000))));
  gallery.push_back(hostile_text("own table", "a name of a megabyte", "bergs.csv",
                                 "id,lat,lon,observed,length_m,draft_m,position_uncertainty_m\n" +
                                     repeated("../", number_in(rng, 200'000, 400'000)) +
                                     "etc/passwd,69.2,-52.5,2026-11-22T06:00:00Z,-1,1e308,nan\n"));
  gallery.push_back(hostile_text("iceberg list", "depth of a hundred thousand", "bergs.json",
                                 R"([{"name":"a23a","lat":"54 30S","lon":"38 12W","date":)" +
                                     repeated("[", number_in(rng, 100'000, 200'000))));
  gallery.push_back(hostile_text("iceberg list", "what it names", "bergs.json",
                                 R"([{"name":")" + json_escaped(place) +
                                     R"(","lat":"54 99999999999S","lon":"NaN W","date":"99/99/99"}])"));
}

void add_tides_and_logs(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  const std::string place = picked(rng, places_to_open(aims));
  gallery.push_back(hostile_text("tide JSON", "numbers beyond all", "tide.json",
                                 R"({"units":"meters","HarmonicConstituents":[{"name":")" +
                                     json_escaped(place) +
                                     R"(","amplitude":1e999,"phase_GMT":-1e308,"speed":28.984104}],)"
                                     R"("lat":1e308,"lng":-51.1})"));
  gallery.push_back(
      hostile_text("tide JSON", "depth of a hundred thousand", "tide.json",
                   R"({"HarmonicConstituents":)" + repeated(R"({"a":)", number_in(rng, 50'000, 100'000))));
  gallery.push_back(
      hostile_text("tide table", "what a row names", "tide.csv",
                   "constituent,amplitude_m,phase_deg\nM2,1e308,1e308\n" + place + ",nan,inf\n"));
  gallery.push_back(hostile_text(
      "OTPS", "more constituents than there are", "tide.txt",
      "Model: " + place + "\n Constituents included: " + repeated("m2 s2 ", number_in(rng, 20'000, 50'000)) +
          "\n     Lat       Lon     |  m2_amp  m2_ph\n   69.200   -51.100   1e999  nan\n"));
  gallery.push_back(
      hostile_text("Slocum text", "more sensors than there are", "log.asc",
                   "dbd_label: DBD_ASC(dinkum_binary_data_ascii)file\nencoding_ver: 2\nnum_ascii_tags: " +
                       std::to_string(number_in(rng, 1 << 30, 0x7fffffff)) + "\nfilename: " + place +
                       "\nsensors_per_cycle: 4294967295\nnum_label_lines: -1\nnum_segments: "
                       "2147483647\nsegment_filename_0: ../../" +
                       place +
                       "\nm_present_time m_lat m_lon m_depth\ntimestamp lat lon m\n8 8 8 4\n"
                       "1e308 6912.0 -5300.0 0\n"));
}

}  // namespace

void add_hostile_texts(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  add_grids(gallery, aims, rng);
  add_icebergs(gallery, aims, rng);
  add_tides_and_logs(gallery, aims, rng);
}

}  // namespace floeplan::ingest
