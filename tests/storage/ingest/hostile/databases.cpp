#include <fstream>
#include <iterator>

#include "tests/storage/ingest/hostile/makers.hpp"
#include "tests/storage/ingest/support/foreign_files.hpp"

namespace floeplan::ingest {
namespace {

namespace fs = std::filesystem;

HostileFile geopackage(const std::string& wants, const std::vector<std::string>& statements) {
  return {"GeoPackage", wants, [statements](const fs::path& folder) {
            write_points("GPKG", folder / "bergs.gpkg", statements);
            return std::vector{folder / "bergs.gpkg"};
          }};
}

const std::string expose =
    "INSERT INTO gpkg_contents(table_name, data_type, identifier, srs_id) VALUES ('evil', 'attributes', "
    "'evil', 0)";

std::string view_of(const std::string& call) {
  return "CREATE VIEW evil AS SELECT fid, id, observed || coalesce(" + call + ", '') AS observed FROM bergs";
}

/// Pages of a good file that lead to themselves, or anywhere.
HostileFile looping_geopackage(std::uint64_t page, std::uint64_t leads_to) {
  return {"GeoPackage", "pages that lead in a circle", [page, leads_to](const fs::path& folder) {
            const fs::path file = folder / "bergs.gpkg";
            write_points("GPKG", file);
            std::ifstream in{file, std::ios::binary};
            std::string bytes{std::istreambuf_iterator<char>{in}, {}};
            const std::size_t at = (page % (bytes.size() / 4096)) * 4096;
            // An inner page of a table, whose right-most child is a page above it.
            if (at > 0) bytes.replace(at, 12, "\x05" + big_endian(0, 7) + big_endian(leads_to, 4));
            std::ofstream{file, std::ios::binary} << bytes;
            return std::vector{file};
          }};
}

}  // namespace

void add_hostile_databases(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  const std::string live = (aims.store / "floeplan.sqlite").string();
  const std::string file = picked(rng, std::vector{aims.secret.string(), std::string{"/etc/passwd"}, live});
  const std::string place = picked(rng, places_to_open(aims));
  for (const std::string& call :
       {"PROJ_SetDatabasePath('" + live + "')", "BlobFromFile('" + file + "')",
        "BlobToFile('gone', '" + live + "')", "load_extension('" + file + "')", "readfile('" + file + "')",
        "writefile('" + live + "', 'gone')", "ogr_datasource_load_layers('" + place + "')",
        "ogr_geocode('" + place + "')", "ImportSHP('" + file + "', 'a', 'UTF-8')",
        "ExportGeoJSON2('bergs', 'geom', '" + live + "')",
        "hex(zeroblob(" + std::to_string(number_in(rng, 100'000'000, 2'000'000'000)) + "))"})
    gallery.push_back(
        geopackage("a view that calls " + call.substr(0, call.find('(')), {view_of(call), expose}));
  gallery.push_back(
      geopackage("a table over a file",
                 {"CREATE VIRTUAL TABLE evil USING VirtualText('" + file + "', 'UTF-8', 0)", expose}));
  gallery.push_back(geopackage("a table over a layer",
                               {"CREATE VIRTUAL TABLE evil USING VirtualOGR('" + place + "')", expose}));
  gallery.push_back(
      geopackage("a view that says it is a table",
                 {view_of("BlobFromFile('" + file + "')"), expose, "PRAGMA writable_schema = ON",
                  "UPDATE sqlite_master SET type = 'table' WHERE name = 'evil'"}));
  gallery.push_back(
      geopackage("rows without end",
                 {"CREATE VIEW evil AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) "
                  "SELECT i AS fid, 'a' AS id, 'b' AS observed FROM n",
                  expose}));
  gallery.push_back(geopackage(
      "a trigger",
      {"CREATE TRIGGER evil AFTER UPDATE ON bergs BEGIN SELECT BlobToFile('gone', '" + live + "'); END"}));
  gallery.push_back(
      geopackage("a reference system from elsewhere",
                 {"UPDATE gpkg_spatial_ref_sys SET organization = 'NONE', organization_coordsys_id = 0, "
                  "definition = '" +
                  place + "'"}));
  gallery.push_back(looping_geopackage(static_cast<std::uint64_t>(number_in(rng, 1, 60)),
                                       static_cast<std::uint64_t>(number_in(rng, 1, 60))));
  gallery.push_back(hostile_text("foreign", "a database that is no GeoPackage", "a.sqlite",
                                 std::string{"SQLite format 3\0", 16} + std::string(4080, '\0')));
}

}  // namespace floeplan::ingest
