#include "storage/ingest/hdf5_references.hpp"

#include <hdf5.h>

#include <optional>
#include <string>

namespace floeplan::ingest {
namespace {

/// A handle of the library, closed with this object.
template <herr_t (*Close)(hid_t)>
class Handle {
 public:
  explicit Handle(hid_t id) : id_{id} {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) Close(id_);
  }
  [[nodiscard]] hid_t get() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

 private:
  hid_t id_;
};

/// The library prints each of its errors unless it is told not to.
class QuietLibrary {
 public:
  QuietLibrary() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  QuietLibrary(const QuietLibrary&) = delete;
  QuietLibrary& operator=(const QuietLibrary&) = delete;
  ~QuietLibrary() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

 private:
  H5E_auto2_t print_{};
  void* data_{};
};

/// What a dataset takes from other files; empty: nothing.
std::optional<std::string> foreign_part_of(hid_t parent, const char* name) {
  const Handle<H5Oclose> object{H5Oopen(parent, name, H5P_DEFAULT)};
  if (!object || H5Iget_type(object.get()) != H5I_DATASET) return std::nullopt;
  const Handle<H5Pclose> creation{H5Dget_create_plist(object.get())};
  if (!creation) return std::nullopt;
  if (H5Pget_layout(creation.get()) == H5D_VIRTUAL)
    return "is put together from other files (a virtual dataset)";
  if (H5Pget_external_count(creation.get()) > 0) return "has its values in another file";
  return std::nullopt;
}

/// Looks at one link; `found` is a Checked<bool>. Stops at the first that leads out of the file.
herr_t visit(hid_t parent, const char* name, const H5L_info_t* link, void* found) {
  std::optional<std::string> reason;
  if (link->type == H5L_TYPE_EXTERNAL) reason = "is a link to another file";
  if (link->type == H5L_TYPE_HARD) reason = foreign_part_of(parent, name);
  if (!reason) return 0;
  *static_cast<Checked<bool>*>(found) = refuse(
      "\"" + std::string{name} + "\" " + *reason +
      "; what stands there would be read unseen, and what is missing taken as no data; copy everything into "
      "one file, for example with nccopy, and give that");
  return 1;
}

}  // namespace

Checked<bool> check_hdf5_references(const std::filesystem::path& file) {
  const QuietLibrary quiet;
  const Handle<H5Fclose> opened{H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)};
  Checked<bool> found = true;
  if (opened) H5Lvisit(opened.get(), H5_INDEX_NAME, H5_ITER_NATIVE, visit, &found);
  return found;
}

}  // namespace floeplan::ingest
