#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace floeplan::codec {

/// Builds a NetCDF file of the classic model in memory. A response then needs no file on disk, and the same
/// content gives the same bytes, which HDF5 does not guarantee.
/// Format   64-bit offset (CDF-2) without record dimension; all readers since NetCDF 3.6.0 (2004) can read it
/// Errors   std::invalid_argument for values that do not fill their dimensions
/// Source   The NetCDF classic format specification, Unidata, NetCDF user's guide, appendix "File formats"
class NetcdfClassic {
 public:
  using Dimension = std::size_t;
  using Texts = std::vector<std::pair<std::string, std::string>>;

  [[nodiscard]] Dimension add_dimension(std::string name, std::size_t length);
  /// Adds an attribute of the whole file.
  void add_text(std::string name, std::string text);

  void add_doubles(const std::string& name, const std::vector<Dimension>& shape,
                   std::span<const double> values, const Texts& attributes);
  void add_integers(const std::string& name, const std::vector<Dimension>& shape,
                    std::span<const std::int32_t> values, const Texts& attributes);
  /// Adds a variable of named values, with CF's flag_values 0, 1, ... and flag_meanings.
  void add_flags(const std::string& name, const std::vector<Dimension>& shape,
                 std::span<const std::int32_t> values, const std::vector<std::string>& meanings,
                 const Texts& attributes);
  /// Adds texts, padded with blanks to equal length; the last dimension is this length.
  void add_characters(const std::string& name, const std::vector<Dimension>& shape,
                      const std::vector<std::string>& texts, const Texts& attributes);

  [[nodiscard]] std::string bytes() const;

 private:
  struct Attribute {
    std::string name;
    std::uint32_t type{};
    std::size_t count{};
    std::string values;  // encoded for the file
  };
  struct Variable {
    std::string name;
    std::vector<Dimension> shape;
    std::vector<Attribute> attributes;
    std::uint32_t type{};
    std::string values;  // encoded for the file, padded to a multiple of four bytes
  };

  [[nodiscard]] static std::vector<Attribute> text_attributes(const Texts& texts);
  [[nodiscard]] static std::string attributes_text(const std::vector<Attribute>& attributes);
  [[nodiscard]] std::string header(std::size_t begin) const;
  void add(Variable variable, std::size_t values);

  std::vector<std::pair<std::string, std::size_t>> dimensions_;
  std::vector<Attribute> attributes_;
  std::vector<Variable> variables_;
};

}  // namespace floeplan::codec
