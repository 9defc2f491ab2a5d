#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// A dataset whose elements have named parts (a compound type), opened for reading.
/// Threads  one thread at a time
class Hdf5Table {
 public:
  /// Length of each dimension.
  [[nodiscard]] const std::vector<std::size_t>& shape() const { return shape_; }
  [[nodiscard]] bool has(const std::string& part) const;
  /// One part of `rows` rows from `first_row` on, in a table of two dimensions.
  /// Shape   [row][column]
  /// Errors  there is no such part, or it is not numeric; damage
  [[nodiscard]] Checked<std::vector<float>> numbers(const std::string& part, std::size_t first_row,
                                                    std::size_t rows) const;
  /// One part of all elements, whatever the shape, the last index fastest.
  /// Errors  there is no such part, or it is not numeric; more than ten million elements; damage
  [[nodiscard]] Checked<std::vector<double>> all_numbers(const std::string& part) const;
  /// One part of all elements of a table of one dimension.
  /// Errors  there is no such part, or it is no text; more than 100000 elements; damage
  [[nodiscard]] Checked<std::vector<std::string>> texts(const std::string& part) const;

 private:
  friend class Hdf5Group;
  struct Open;

  std::shared_ptr<const Open> open_;
  std::vector<std::size_t> shape_;
};

/// A group of an HDF5 file, opened for reading. Call check_hdf5_references on the file first.
/// Threads  one thread at a time
class Hdf5Group {
 public:
  /// Errors  damage
  [[nodiscard]] static Checked<Hdf5Group> root_of(const std::filesystem::path& file);

  /// An attribute that is one number, or one member of an enumeration.
  [[nodiscard]] std::optional<double> number(const std::string& attribute) const;
  /// An attribute that is one text, without the blanks round it.
  [[nodiscard]] std::optional<std::string> text(const std::string& attribute) const;
  /// The text of a dataset of single characters, as NetCDF stores texts; empty if there is no such dataset or
  /// it is longer than a thousand characters.
  [[nodiscard]] std::string characters(const std::string& dataset) const;
  /// The rows of a dataset of whole numbers with this number of columns, one after the other.
  /// Errors  no dataset of this name and shape; more than ten million rows; damage
  [[nodiscard]] Checked<std::vector<std::int64_t>> integers(const std::string& dataset,
                                                            std::size_t columns) const;
  /// Names of the group's members, sorted.
  [[nodiscard]] std::vector<std::string> members() const;
  /// Errors  there is none of this name; damage
  [[nodiscard]] Checked<Hdf5Group> group(const std::string& name) const;
  [[nodiscard]] Checked<Hdf5Table> table(const std::string& name) const;

 private:
  struct Open;

  std::shared_ptr<const Open> open_;
};

}  // namespace floeplan::ingest
