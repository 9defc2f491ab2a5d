#include <hdf5.h>

#include <array>
#include <fstream>
#include <iterator>

#include "tests/storage/ingest/hostile/makers.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"

namespace floeplan::ingest {
namespace {

namespace fs = std::filesystem;

void add_external_values(hid_t place, const std::string& name, const std::string& file) {
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(creation, file.c_str(), 0, 40);
  const hsize_t size = 40;
  const hid_t space = H5Screate_simple(1, &size, nullptr);
  H5Dclose(H5Dcreate2(place, name.c_str(), H5T_NATIVE_UCHAR, space, H5P_DEFAULT, creation, H5P_DEFAULT));
  H5Sclose(space);
  H5Pclose(creation);
}

void add_virtual_values(hid_t place, const std::string& file) {
  const std::array<hsize_t, 2> size{3, 4};
  const hid_t space = H5Screate_simple(2, size.data(), nullptr);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_virtual(creation, space, file.c_str(), "/uo", space);
  H5Dclose(H5Dcreate2(place, "elevation", H5T_NATIVE_FLOAT, space, H5P_DEFAULT, creation, H5P_DEFAULT));
  H5Pclose(creation);
  H5Sclose(space);
}

/// Adds an array of side * side nodes, so large that no value of it is stored.
void add_endless_values(hid_t place, hsize_t side) {
  const std::array<hsize_t, 2> size{side, side};
  const std::array<hsize_t, 2> chunk{64, 64};
  const hid_t space = H5Screate_simple(2, size.data(), nullptr);
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(creation, 2, chunk.data());
  H5Dclose(H5Dcreate2(place, "elevation", H5T_NATIVE_FLOAT, space, H5P_DEFAULT, creation, H5P_DEFAULT));
  H5Pclose(creation);
  H5Sclose(space);
}

hid_t add_group(hid_t place, const std::string& name) {
  return H5Gcreate2(place, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
}

using Change = std::function<void(hid_t file)>;

/// Good currents that something is added to.
HostileFile changed_netcdf(const std::string& wants, Change change) {
  return {"NetCDF-4", wants, [change = std::move(change)](const fs::path& folder) {
            CurrentFile{}.write(folder / "a.nc");
            const hid_t file = H5Fopen((folder / "a.nc").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
            change(file);
            H5Fclose(file);
            return std::vector{folder / "a.nc"};
          }};
}

/// A file with a group BAG_root; `spoil` is a text in it whose first letter is changed afterwards, or empty.
HostileFile bag(const std::string& wants, Change change, const std::string& spoil = "") {
  return {"BAG", wants, [change = std::move(change), spoil](const fs::path& folder) {
            const fs::path place = folder / "bed.bag";
            const hid_t file = H5Fcreate(place.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
            change(file);
            H5Fclose(file);
            if (spoil.empty()) return std::vector{place};
            std::ifstream in{place, std::ios::binary};
            std::string bytes{std::istreambuf_iterator<char>{in}, {}};
            if (const auto at = bytes.find(spoil); at != std::string::npos) bytes[at] = '\x7f';
            std::ofstream{place, std::ios::binary} << bytes;
            return std::vector{place};
          }};
}

}  // namespace

void add_hostile_hdf5(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  const std::string file = picked(rng, std::vector{aims.secret.string(), std::string{"/etc/passwd"},
                                                   (aims.store / "floeplan.sqlite").string()});
  const int depth = static_cast<int>(number_in(rng, 10, 60));
  const auto side = static_cast<hsize_t>(number_in(rng, 1 << 24, 1 << 30));
  const auto link_out = [file](hid_t place, const std::string& name) {
    H5Lcreate_external(file.c_str(), "/", place, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  };

  gallery.push_back(
      changed_netcdf("another file by a link", [link_out](hid_t out) { link_out(out, "out"); }));
  gallery.push_back(changed_netcdf("another file by a link deep in groups", [link_out, depth](hid_t out) {
    for (int i = 0; i < depth; ++i) out = add_group(out, "g");
    link_out(out, "out");
  }));
  gallery.push_back(changed_netcdf("values of another file",
                                   [file](hid_t out) { add_external_values(out, "elevation", file); }));
  gallery.push_back(changed_netcdf("values put together from another file",
                                   [file](hid_t out) { add_virtual_values(out, file); }));
  gallery.push_back(changed_netcdf("more memory than any machine has",
                                   [side](hid_t out) { add_endless_values(out, side); }));
  gallery.push_back(bag("another file by a link",
                        [link_out](hid_t out) { link_out(add_group(out, "BAG_root"), "elevation"); }));
  gallery.push_back(bag(
      "values of another file behind a group that cannot be read",
      [file](hid_t out) {
        for (int i = 0; i < 3; ++i) add_group(add_group(out, "A" + std::to_string(i)), "broken");
        add_external_values(add_group(out, "BAG_root"), "elevation", file);
      },
      "SNOD"));
  gallery.push_back(bag(
      "values of another file behind a heap that cannot be read",
      [file](hid_t out) {
        add_group(out, "A");
        add_external_values(add_group(out, "BAG_root"), "elevation", file);
      },
      "HEAP"));
  gallery.push_back(bag("more memory than any machine has",
                        [side](hid_t out) { add_endless_values(add_group(out, "BAG_root"), side); }));
}

}  // namespace floeplan::ingest
