#include "storage/ingest/formats/hdf5/hdf5_group.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "engine/messages/ingest_hdf5_messages.hpp"
#include "storage/ingest/formats/hdf5/hdf5_library.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

using Attribute = Hdf5Handle<H5Aclose>;
using Type = Hdf5Handle<H5Tclose>;
using Space = Hdf5Handle<H5Sclose>;

constexpr std::size_t longest_text = 65'536;   // bytes; texts lie in an object header, which is no larger
constexpr hssize_t most_numbers = 10'000'000;  // the largest number of points of a grid
constexpr hssize_t most_texts =
    100'000;  // chosen: such as the times of a station, minute by minute for two months
constexpr std::size_t most_column_bytes = 16'000'000;  // chosen: of all texts of a column, if of fixed length
constexpr std::size_t largest_number = 16;     // bytes of one number

tl::unexpected<Messages> unreadable_part(const std::string& name) {
  return refuse(messages::ingest_hdf5_message<"hdf-part-unreadable">(name));
}

/// The attribute with this name if it holds a single value; otherwise an invalid handle.
Attribute single_attribute(hid_t object, const std::string& name) {
  if (H5Aexists(object, name.c_str()) <= 0) return Attribute{H5I_INVALID_HID};
  Attribute attribute{H5Aopen(object, name.c_str(), H5P_DEFAULT)};
  if (!attribute) return attribute;
  const Space space{H5Aget_space(attribute.get())};
  if (!space || H5Sget_simple_extent_npoints(space.get()) != 1) return Attribute{H5I_INVALID_HID};
  return attribute;
}

/// A text in a buffer of `most` bytes, which the library fills up with zeros or blanks.
std::string bounded_text(const char* bytes, std::size_t most) {
  return trimmed({bytes, strnlen(bytes, most)});
}

/// The type in memory for a text of this type of a file; it keeps length, character set and padding.
Type text_in_memory(hid_t in_file) {
  Type type{H5Tcopy(H5T_C_S1)};
  const bool variable = H5Tis_variable_str(in_file) > 0;
  H5Tset_size(type.get(), variable ? H5T_VARIABLE : H5Tget_size(in_file));
  H5Tset_cset(type.get(), H5Tget_cset(in_file));
  if (!variable) H5Tset_strpad(type.get(), H5Tget_strpad(in_file));
  return type;
}

/// The type of one part of a table's elements; an invalid handle if there is no such part.
Type type_of_part(hid_t compound, const std::string& part) {
  const int index = H5Tget_member_index(compound, part.c_str());
  return Type{index < 0 ? H5I_INVALID_HID : H5Tget_member_type(compound, static_cast<unsigned>(index))};
}

/// Whether every part lies inside an element of a table. The library would copy a part from outside without a
/// check.
bool parts_lie_inside(hid_t compound) {
  const std::size_t size = H5Tget_size(compound);
  const int parts = H5Tget_nmembers(compound);
  for (int i = 0; i < parts; ++i) {
    const auto number = static_cast<unsigned>(i);
    const Type part{H5Tget_member_type(compound, number)};
    const std::size_t offset = H5Tget_member_offset(compound, number);
    if (!part || offset > size || H5Tget_size(part.get()) > size - offset) return false;
  }
  return true;
}

/// A compound type in memory with only this one member.
Type part_alone(const std::string& part, hid_t type) {
  Type compound{H5Tcreate(H5T_COMPOUND, H5Tget_size(type))};
  H5Tinsert(compound.get(), part.c_str(), 0, type);
  return compound;
}

herr_t add_member_name(hid_t /*group*/, const char* name, const H5L_info_t* /*link*/, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

}  // namespace

struct Hdf5Table::Open {
  std::string name;
  Hdf5Handle<H5Dclose> dataset;
  Type type;
};

struct Hdf5Group::Open {
  Hdf5Handle<H5Oclose> object;
};

bool Hdf5Table::has(const std::string& part) const {
  const QuietHdf5 quiet;
  return H5Tget_member_index(open_->type.get(), part.c_str()) >= 0;
}

Checked<std::vector<float>> Hdf5Table::numbers(const std::string& part, std::size_t first_row,
                                               std::size_t rows) const {
  const QuietHdf5 quiet;
  const Type in_file = type_of_part(open_->type.get(), part);
  if (!in_file || shape_.size() != 2) return unreadable_part(open_->name);
  const H5T_class_t kind = H5Tget_class(in_file.get());
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) return unreadable_part(part);
  const std::array<hsize_t, 2> start{first_row, 0};
  const std::array<hsize_t, 2> count{rows, shape_[1]};
  const Space all{H5Dget_space(open_->dataset.get())};
  const Space wanted{H5Screate_simple(2, count.data(), nullptr)};
  if (!all || !wanted ||
      H5Sselect_hyperslab(all.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) < 0)
    return unreadable_part(open_->name);
  std::vector<float> values(rows * shape_[1]);
  const Type in_memory = part_alone(part, H5T_NATIVE_FLOAT);
  if (H5Dread(open_->dataset.get(), in_memory.get(), wanted.get(), all.get(), H5P_DEFAULT, values.data()) < 0)
    return unreadable_part(open_->name);
  return values;
}

Checked<std::vector<double>> Hdf5Table::all_numbers(const std::string& part) const {
  const QuietHdf5 quiet;
  const Type in_file = type_of_part(open_->type.get(), part);
  const Space space{H5Dget_space(open_->dataset.get())};
  const hssize_t count = space ? H5Sget_simple_extent_npoints(space.get()) : -1;
  if (!in_file || count < 0 || count > most_numbers) return unreadable_part(open_->name);
  const H5T_class_t kind = H5Tget_class(in_file.get());
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) return unreadable_part(part);
  std::vector<double> values(static_cast<std::size_t>(count));
  const Type in_memory = part_alone(part, H5T_NATIVE_DOUBLE);
  if (H5Dread(open_->dataset.get(), in_memory.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    return unreadable_part(open_->name);
  return values;
}

Checked<std::vector<std::string>> Hdf5Table::texts(const std::string& part) const {
  const QuietHdf5 quiet;
  const Type in_file = type_of_part(open_->type.get(), part);
  const Space space{H5Dget_space(open_->dataset.get())};
  const hssize_t count = space ? H5Sget_simple_extent_npoints(space.get()) : -1;
  if (!in_file || H5Tget_class(in_file.get()) != H5T_STRING || shape_.size() != 1 || count < 0 ||
      count > most_texts ||
      (H5Tis_variable_str(in_file.get()) <= 0 &&
       H5Tget_size(in_file.get()) >
           std::min(longest_text, most_column_bytes / static_cast<std::size_t>(count + 1))))
    return unreadable_part(open_->name);
  const Type text = text_in_memory(in_file.get());
  const Type in_memory = part_alone(part, text.get());
  const std::size_t width = H5Tget_size(text.get());
  std::vector<char> bytes(width * static_cast<std::size_t>(count));
  if (H5Dread(open_->dataset.get(), in_memory.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0)
    return unreadable_part(open_->name);
  std::vector<std::string> result;
  const bool variable = H5Tis_variable_str(text.get()) > 0;
  for (std::size_t at = 0; at < bytes.size(); at += width) {
    if (!variable) {
      result.push_back(bounded_text(bytes.data() + at, width));
      continue;
    }
    const char* pointed{};
    std::memcpy(&pointed, bytes.data() + at, sizeof pointed);
    result.push_back(pointed == nullptr ? "" : bounded_text(pointed, longest_text));
  }
  if (variable) H5Dvlen_reclaim(in_memory.get(), space.get(), H5P_DEFAULT, bytes.data());
  return result;
}

Checked<Hdf5Group> Hdf5Group::root_of(const std::filesystem::path& file) {
  const QuietHdf5 quiet;
  // Open objects keep the file open until the last of them is closed.
  const Hdf5Handle<H5Fclose> opened{H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)};
  if (!opened) return unreadable_part(file.filename());
  Hdf5Group root;
  root.open_ =
      std::make_shared<const Open>(Open{Hdf5Handle<H5Oclose>{H5Oopen(opened.get(), "/", H5P_DEFAULT)}});
  if (!root.open_->object) return unreadable_part(file.filename());
  return root;
}

std::optional<double> Hdf5Group::number(const std::string& attribute) const {
  const QuietHdf5 quiet;
  const Attribute found = single_attribute(open_->object.get(), attribute);
  if (!found) return std::nullopt;
  const Type stated{H5Aget_type(found.get())};
  const Type counted{H5Tget_class(stated.get()) == H5T_ENUM ? H5Tget_super(stated.get())
                                                            : H5Tcopy(stated.get())};
  const H5T_class_t kind = H5Tget_class(counted.get());
  if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || H5Tget_size(counted.get()) > largest_number)
    return std::nullopt;
  alignas(largest_number) std::array<std::byte, largest_number> bytes{};
  if (H5Aread(found.get(), stated.get(), bytes.data()) < 0 ||
      H5Tconvert(counted.get(), H5T_NATIVE_DOUBLE, 1, bytes.data(), nullptr, H5P_DEFAULT) < 0)
    return std::nullopt;
  double value{};
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

std::optional<std::string> Hdf5Group::text(const std::string& attribute) const {
  const QuietHdf5 quiet;
  const Attribute found = single_attribute(open_->object.get(), attribute);
  if (!found) return std::nullopt;
  const Type stated{H5Aget_type(found.get())};
  if (H5Tget_class(stated.get()) != H5T_STRING) return std::nullopt;
  const Type in_memory = text_in_memory(stated.get());
  if (H5Tis_variable_str(stated.get()) > 0) {
    char* bytes = nullptr;
    if (H5Aread(found.get(), in_memory.get(), &bytes) < 0 || bytes == nullptr) return std::nullopt;
    std::string text = bounded_text(bytes, longest_text);
    H5free_memory(bytes);
    return text;
  }
  const std::size_t size = H5Tget_size(stated.get());
  if (size > longest_text) return std::nullopt;
  std::vector<char> bytes(size);
  if (H5Aread(found.get(), in_memory.get(), bytes.data()) < 0) return std::nullopt;
  return bounded_text(bytes.data(), size);
}

std::string Hdf5Group::characters(const std::string& dataset) const {
  const QuietHdf5 quiet;
  if (H5Lexists(open_->object.get(), dataset.c_str(), H5P_DEFAULT) <= 0) return {};
  const Hdf5Handle<H5Dclose> opened{H5Dopen2(open_->object.get(), dataset.c_str(), H5P_DEFAULT)};
  if (!opened) return {};
  const Type type{H5Dget_type(opened.get())};
  const Space space{H5Dget_space(opened.get())};
  const hssize_t count = space ? H5Sget_simple_extent_npoints(space.get()) : -1;
  if (!type || H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0 ||
      H5Tget_size(type.get()) != 1 || count <= 0 || count > most_texts)
    return {};
  std::string text(static_cast<std::size_t>(count), '\0');
  if (H5Dread(opened.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0) return {};
  return bounded_text(text.data(), text.size());
}

Checked<std::vector<std::int64_t>> Hdf5Group::integers(const std::string& dataset,
                                                       std::size_t columns) const {
  const QuietHdf5 quiet;
  const Hdf5Handle<H5Dclose> opened{H5Dopen2(open_->object.get(), dataset.c_str(), H5P_DEFAULT)};
  if (!opened) return unreadable_part(dataset);
  const Type type{H5Dget_type(opened.get())};
  const Space space{H5Dget_space(opened.get())};
  std::array<hsize_t, 2> sizes{};
  if (!type || H5Tget_class(type.get()) != H5T_INTEGER || !space ||
      H5Sget_simple_extent_ndims(space.get()) != 2 ||
      H5Sget_simple_extent_dims(space.get(), sizes.data(), nullptr) < 0 || sizes[1] != columns ||
      sizes[0] > static_cast<hsize_t>(most_numbers))
    return unreadable_part(dataset);
  std::vector<std::int64_t> values(static_cast<std::size_t>(sizes[0]) * columns);
  if (H5Dread(opened.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    return unreadable_part(dataset);
  return values;
}

std::vector<std::string> Hdf5Group::members() const {
  const QuietHdf5 quiet;
  std::vector<std::string> names;
  H5Literate(open_->object.get(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, add_member_name, &names);
  std::ranges::sort(names);
  return names;
}

Checked<Hdf5Group> Hdf5Group::group(const std::string& name) const {
  const QuietHdf5 quiet;
  Hdf5Group found;
  found.open_ = std::make_shared<const Open>(
      Open{Hdf5Handle<H5Oclose>{H5Oopen(open_->object.get(), name.c_str(), H5P_DEFAULT)}});
  if (!found.open_->object || H5Iget_type(found.open_->object.get()) != H5I_GROUP)
    return unreadable_part(name);
  return found;
}

Checked<Hdf5Table> Hdf5Group::table(const std::string& name) const {
  const QuietHdf5 quiet;
  Hdf5Handle<H5Dclose> dataset{H5Dopen2(open_->object.get(), name.c_str(), H5P_DEFAULT)};
  if (!dataset) return unreadable_part(name);
  Type type{H5Dget_type(dataset.get())};
  const Space space{H5Dget_space(dataset.get())};
  const int dimensions = space ? H5Sget_simple_extent_ndims(space.get()) : -1;
  if (!type || H5Tget_class(type.get()) != H5T_COMPOUND || !parts_lie_inside(type.get()) || dimensions < 1 ||
      dimensions > 2)
    return unreadable_part(name);
  std::array<hsize_t, 2> sizes{};
  H5Sget_simple_extent_dims(space.get(), sizes.data(), nullptr);
  Hdf5Table table;
  table.shape_.assign(sizes.begin(), sizes.begin() + dimensions);
  table.open_ =
      std::make_shared<const Hdf5Table::Open>(Hdf5Table::Open{name, std::move(dataset), std::move(type)});
  return table;
}

}  // namespace floeplan::ingest
