#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace floeplan::codec {

/// A NetCDF file of the classic model, put together in memory: a response needs no file on disk, and the same content
/// gives the same bytes, which HDF5 does not promise.
/// Format   64-bit offset (CDF-2) without record dimension; readers since NetCDF 3.6.0 (2004) know it
/// Errors   std::invalid_argument for values that do not fill their dimensions
/// Source   The NetCDF classic format specification, Unidata, NetCDF user's guide, appendix "File formats"
class NetcdfClassic {
 public:
  using Dimension = std::size_t;
  using Texts = std::vector<std::pair<std::string, std::string>>;

  [[nodiscard]] Dimension add_dimension(std::string name, std::size_t length);
  /// Attributes of the whole file.
  void add_text(std::string name, std::string text);

  void add_doubles(const std::string& name, const std::vector<Dimension>& shape,
                   std::span<const double> values, const Texts& attributes);
  void add_integers(const std::string& name, const std::vector<Dimension>& shape,
                    std::span<const std::int32_t> values, const Texts& attributes);
  /// Values that have names: CF's flag_values 0, 1, ... and flag_meanings.
  void add_flags(const std::string& name, const std::vector<Dimension>& shape,
                 std::span<const std::int32_t> values, const std::vector<std::string>& meanings,
                 const Texts& attributes);
  /// Texts of equal length, filled up with blanks; the last dimension is that length.
  void add_characters(const std::string& name, const std::vector<Dimension>& shape,
                      const std::vector<std::string>& texts, const Texts& attributes);

  [[nodiscard]] std::string bytes() const;

 private:
  struct Attribute {
    std::string name;
    std::uint32_t type{};
    std::size_t count{};
    std::string values;  // as they stand in the file
  };
  struct Variable {
    std::string name;
    std::vector<Dimension> shape;
    std::vector<Attribute> attributes;
    std::uint32_t type{};
    std::string values;  // as they stand in the file, filled up to a multiple of four bytes
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
