#include <archive.h>
#include <archive_entry.h>

#include <fstream>
#include <memory>
#include <utility>

#include "tests/storage/ingest/hostile/makers.hpp"
#include "tests/storage/ingest/support/archive_writer.hpp"

namespace floeplan::ingest {
namespace {

namespace fs = std::filesystem;

const std::string berg =
    R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"id": "a",
    "observed": "2026-11-20T06:00:00Z"}, "geometry": {"type": "Point", "coordinates": [-52.0, 69.0]}}]})";

HostileFile packed(const std::string& wants, const std::string& name, Packing packing, ArchiveMembers members,
                   const std::string& format = "archive") {
  return {format, wants, [name, packing, members = std::move(members)](const fs::path& folder) {
            write_archive(folder / name, packing, members);
            return std::vector{folder / name};
          }};
}

/// A tar archive with a link, and behind it a file that would be written through the link.
HostileFile linked(const std::string& target, bool hard) {
  return {"archive", hard ? "another name for a file" : "a link out of its folder",
          [target, hard](const fs::path& folder) {
            const std::unique_ptr<archive, int (*)(archive*)> writer{archive_write_new(), archive_write_free};
            archive_write_set_format_pax_restricted(writer.get());
            archive_write_open_filename(writer.get(), (folder / "a.tar").c_str());
            const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry{archive_entry_new(),
                                                                                 archive_entry_free};
            archive_entry_set_pathname(entry.get(), "bergs.geojson");
            if (hard)
              archive_entry_set_hardlink(entry.get(), target.c_str());
            else
              archive_entry_set_symlink(entry.get(), target.c_str());
            archive_entry_set_filetype(entry.get(), hard ? AE_IFREG : AE_IFLNK);
            archive_write_header(writer.get(), entry.get());
            archive_entry_clear(entry.get());
            archive_entry_set_pathname(entry.get(), "bergs.geojson");
            archive_entry_set_filetype(entry.get(), AE_IFREG);
            archive_entry_set_size(entry.get(), static_cast<la_int64_t>(berg.size()));
            archive_write_header(writer.get(), entry.get());
            archive_write_data(writer.get(), berg.data(), berg.size());
            archive_write_close(writer.get());
            return std::vector{folder / "a.tar"};
          }};
}

std::string array_of(const std::string& shape) {
  return R"({"zarr_format": 2, "shape": )" + shape +
         R"(, "chunks": [2, 2], "dtype": "<f4", "order": "C", "compressor": null, "filters": null, "fill_value": 0})";
}

void add_zarr(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  const std::string place = json_escaped(picked(rng, places_to_open(aims)));
  const std::string attributes =
      R"({"standard_name": "sea_ice_area_fraction", "units": "1", "_ARRAY_DIMENSIONS": ["y", "x"],
      "_CRS": {"url": ")" +
      place + R"("}})";
  const std::string group = R"({"zarr_format": 2})";
  const std::string side = std::to_string(number_in(rng, 1'000'000'000, 4'000'000'000'000));
  gallery.push_back(packed("more memory than any machine has", "ice.zip", Packing::zip,
                           {{"ice.zarr/.zgroup", group},
                            {"ice.zarr/siconc/.zarray", array_of("[" + side + ", " + side + "]")},
                            {"ice.zarr/siconc/.zattrs", attributes}},
                           "Zarr"));
  gallery.push_back(packed("arrays outside its folder", "ice.zip", Packing::zip,
                           {{"ice.zarr/.zgroup", group},
                            {"ice.zarr/.zmetadata", R"({"zarr_consolidated_format": 1, "metadata": {")" +
                                                        repeated("../", number_in(rng, 2, 9)) +
                                                        R"(store/.zarray": )" + array_of("[2, 2]") + "}}"}},
                           "Zarr"));
  gallery.push_back(packed("a reference system from elsewhere", "ice.zip", Packing::zip,
                           {{"ice.zarr/.zgroup", group},
                            {"ice.zarr/siconc/.zarray", array_of("[2, 2]")},
                            {"ice.zarr/siconc/.zattrs", attributes},
                            {"ice.zarr/siconc/0.0", std::string(16, '\0')}},
                           "Zarr"));
  gallery.push_back(packed(
      "codecs without end", "ice.zip", Packing::zip,
      {{"ice.zarr/zarr.json", R"({"zarr_format": 3, "node_type": "array", "shape": [2, 2],
      "data_type": "float32", "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [)" +
                                  side + R"(, 1]}}, "fill_value": 0, "codecs": )" +
                                  repeated(R"([{"name": "sharding_indexed", "configuration": {"codecs": )",
                                           number_in(rng, 1000, 20'000))}},
      "Zarr"));
}

}  // namespace

void add_hostile_archives(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  const std::string live = (aims.store / "floeplan.sqlite").string();
  const std::string up = repeated("../", number_in(rng, 1, 12));
  for (const std::string& name :
       std::vector<std::string>{up + live.substr(1), live, "a/" + up + "../x.geojson",
                                "..\\..\\store\\x.geojson", std::string{"/tmp/floeplan-escaped.geojson"}})
    gallery.push_back(packed("a place outside its folder", "a.zip", Packing::zip, {{name, berg}}));
  gallery.push_back(
      packed("a place outside its folder", "a.kmz", Packing::zip, {{up + "doc.kml", "<kml></kml>"}}));
  // Archives that unpack to about a thousand times their size.
  for (const auto& [packing, least] :
       {std::pair{Packing::zip, 140'000'000}, {Packing::gzip, 20'000'000}, {Packing::zstd, 20'000'000}})
    gallery.push_back(
        {"archive", "a thousand times its size",
         [packing = packing, bytes = number_in(rng, least, least + 10'000'000)](const fs::path& folder) {
           write_archive(folder / "bed.xyz.z", packing,
                         {{"bed.xyz", std::string(static_cast<std::size_t>(bytes), '0')}});
           return std::vector{folder / "bed.xyz.z"};
         }});
  ArchiveMembers many;
  for (std::int64_t i = number_in(rng, 10, 20); i > 0; --i)
    many.emplace_back("f" + std::to_string(i) + ".xyz", "");
  gallery.push_back(packed("empty files by the dozen", "a.tar.gz", Packing::tar_gz, std::move(many)));
  gallery.push_back(packed("folders in folders", "a.zip", Packing::zip,
                           {{repeated("d/", number_in(rng, 40, 400)) + "bergs.geojson", berg}}));
  gallery.push_back(
      packed("the same name twice", "a.zip", Packing::zip, {{"a.geojson", berg}, {"a.geojson", "{}"}}));
  for (const bool hard : {false, true})
    gallery.push_back(
        linked(picked(rng, std::vector{live, aims.secret.string(), std::string{"/etc/passwd"}}), hard));
  add_zarr(gallery, aims, rng);
}

}  // namespace floeplan::ingest
