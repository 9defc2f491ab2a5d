#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/messages/ingest_tide_messages.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/tides/tide_layout.hpp"
#include "storage/ingest/readers/tides/tide_readers.hpp"
#include "storage/ingest/readers/tides/tide_variables.hpp"
#include "storage/repository/fields/tide_repository.hpp"

namespace floeplan::ingest {
namespace {

using ocean::TideQuantity;

constexpr double highest_m =
    20.0;  // the greatest tide on Earth, in the Bay of Fundy, has an amplitude of 8 m
constexpr double fastest_tide_m_s = 10.0;  // the fastest tidal stream, Saltstraumen, reaches about this
constexpr double shallowest_m = 1.0;       // dividing a transport by less water gives unrealistic speeds

struct Part {
  TideVariables variables;
  TideLayout layout;
  std::vector<double> depths_m;  // depths for transports; otherwise empty
};

/// All that is needed to read fields of a file, for checking and later for writing.
struct TideSource {
  NetcdfFiles files;  // references that keep the files open
  std::vector<Part> parts;
  // constituent of each line; empty: unknown to this program
  std::vector<std::optional<tide::Constituent>> lines;
  ocean::HorizontalGrid grid;  // grid on which the tide is stored
};

/// The field of one constituent at its own nodes, in metres or m/s.
Checked<ocean::TideGrid::Field> read_at_own_nodes(const Part& part, std::size_t line) {
  const auto raw = read_tide_field(part.variables, part.layout, line);
  if (!raw) return refuse(raw.error());
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const double most = part.variables.quantity == TideQuantity::elevation ? highest_m : fastest_tide_m_s;
  ocean::TideGrid::Field field;
  field.reserve(raw->size());
  for (std::size_t i = 0; i < raw->size(); ++i) {
    std::complex<double> value = part.variables.factor * (*raw)[i];
    if (part.variables.transport) value = part.depths_m[i] >= shallowest_m ? value / part.depths_m[i] : nan;
    if (std::abs(value) > most) {
      const std::string unit = part.variables.quantity == TideQuantity::elevation ? "m" : "m/s";
      return refuse(messages::ingest_tide_message<"tide-too-high">(
          part.variables.first->name(), number(std::abs(value)), unit, number(most)));
    }
    field.push_back(std::isnan(value.real()) ? std::complex<float>{nan, nan} : std::complex<float>{value});
  }
  return field;
}

bool same_nodes(const ocean::HorizontalGrid& a, const ocean::HorizontalGrid& b) {
  return a.x().nodes() == b.x().nodes() && a.y().nodes() == b.y().nodes();
}

/// The field at the nodes of the stored grid, interpolated linearly.
Checked<ocean::TideGrid::Field> read_line(const TideSource& source, const Part& part, std::size_t line) {
  auto field = read_at_own_nodes(part, line);
  if (!field || same_nodes(part.layout.grid, source.grid)) return field;
  const ocean::TideGrid own{{part.layout.grid, {{tide::Constituent{}, std::move(*field), {}, {}}}}};
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  ocean::TideGrid::Field result;
  result.reserve(source.grid.size());
  for (std::size_t iy = 0; iy < source.grid.y().size(); ++iy) {
    for (std::size_t ix = 0; ix < source.grid.x().size(); ++ix) {
      const auto value = own.constants(TideQuantity::elevation, source.grid.place(ix, iy));
      result.push_back(value ? std::complex<float>{value->front().value} : std::complex<float>{nan, nan});
    }
  }
  return result;
}

/// The stored grid: the nodes of the elevations, or, for a C grid without them, the longitudes of v and the
/// latitudes of u.
ocean::HorizontalGrid grid_of_store(const std::vector<Part>& parts) {
  const auto part = [&](TideQuantity quantity) {
    return std::ranges::find_if(parts, [&](const Part& p) { return p.variables.quantity == quantity; });
  };
  if (part(TideQuantity::elevation) != parts.end()) return part(TideQuantity::elevation)->layout.grid;
  return {part(TideQuantity::east)->layout.grid.frame(), part(TideQuantity::north)->layout.grid.x(),
          part(TideQuantity::east)->layout.grid.y()};
}

Checked<std::vector<std::optional<tide::Constituent>>> lines_of(const NetcdfFile& file,
                                                                const std::string& stem, std::size_t count,
                                                                Messages& warnings) {
  const auto names = tide_names(file, stem, count);
  if (!names) return refuse(names.error());
  std::vector<std::optional<tide::Constituent>> lines;
  std::vector<std::string> unknown;
  for (const std::string& name : *names) {
    auto line = tide::find_constituent(name);
    if (!line) unknown.push_back(name);
    if (line && std::ranges::find(lines, line) != lines.end())
      return refuse(messages::ingest_tide_message<"constituent-twice">(name));
    lines.push_back(line);
  }
  if (unknown.size() == names->size())
    return refuse(messages::ingest_tide_message<"constituents-unknown">(enumeration(unknown)));
  if (!unknown.empty())
    warnings.push_back(messages::ingest_tide_message<"constituents-left-out">(enumeration(unknown)));
  return lines;
}

struct TideInFile {
  std::shared_ptr<const NetcdfFile> file;
  TideVariables variables;
};

/// The tides of the first file; from other files only the component that is missing.
Checked<std::vector<TideInFile>> find_in_all(const NetcdfFiles& files) {
  std::vector<TideInFile> all;
  const auto has = [&](TideQuantity quantity) {
    return std::ranges::any_of(all, [&](const TideInFile& t) { return t.variables.quantity == quantity; });
  };
  for (const auto& file : files) {
    if (file != files.front() && !holds_tides(*file)) continue;
    const auto found = find_tides(*file);
    if (!found) return refuse(found.error());
    for (const TideVariables& variables : *found)
      if (!has(variables.quantity)) all.push_back({file, variables});
  }
  if (has(TideQuantity::east) != has(TideQuantity::north))
    return refuse(messages::ingest_tide_message<"tide-component-missing">(
        has(TideQuantity::east) ? "eastward" : "northward"));
  return all;
}

Checked<TideSource> open_source(const NetcdfFiles& files, const std::string& stem,
                                const IngestOptions& options, Messages& warnings) {
  const auto found = find_in_all(files);
  if (!found) return refuse(found.error());
  std::vector<Part> parts;
  std::optional<std::size_t> lines;
  for (const auto& [file, variables] : *found) {
    auto layout = tide_layout_of(*file, variables, options.crs);
    if (!layout) return refuse(layout.error());
    const std::size_t count =
        layout->line_dimension
            ? static_cast<std::size_t>(variables.first->dimensions()[*layout->line_dimension].size)
            : 1;
    if (lines && *lines != count)
      return refuse(messages::ingest_tide_message<"tides-differ-in-constituents">());
    lines = count;
    std::vector<double> depths_m;
    if (variables.transport) {
      auto depths = read_tide_depths(files, variables, *layout, options.crs);
      if (!depths) return refuse(depths.error());
      depths_m = std::move(*depths);
      if (depths_m.empty())
        return refuse(messages::ingest_tide_message<"transport-without-depths">(variables.first->name()));
    }
    parts.push_back({variables, std::move(*layout), std::move(depths_m)});
  }
  auto names = lines_of(*files.front(), stem, *lines, warnings);
  if (!names) return refuse(names.error());
  const ocean::HorizontalGrid grid = grid_of_store(parts);
  return TideSource{files, std::move(parts), std::move(*names), grid};
}

/// Reads every field once. Returns the number of nodes with a value.
Checked<std::int64_t> look_through(const TideSource& source, const core::ProgressCallback& progress) {
  std::int64_t nodes = 0;
  const double steps = static_cast<double>(source.parts.size() * source.lines.size());
  double done = 0.0;
  for (const Part& part : source.parts) {
    for (std::size_t line = 0; line < source.lines.size(); ++line) {
      if (progress) progress("checking", 0.5 * ++done / steps);
      if (!source.lines[line]) continue;
      const auto field = read_at_own_nodes(part, line);
      if (!field) return refuse(field.error());
      const auto known = std::ranges::count_if(*field, [](const auto& v) { return !std::isnan(v.real()); });
      if (known == 0)
        return refuse(messages::ingest_tide_message<"tide-all-missing">(
            part.variables.first->name(), tide::constituent_name(*source.lines[line])));
      nodes = std::max<std::int64_t>(nodes, known);
    }
  }
  return nodes;
}

Checked<void> write(const TideSource& source, const core::ProgressCallback& progress, sql::Connection& db,
                    const repository::DatasetId& id) {
  repository::TideRepository tides{db};
  tides.create(id, source.grid);
  const double steps = static_cast<double>(source.parts.size() * source.lines.size());
  double done = 0.0;
  for (const Part& part : source.parts) {
    for (std::size_t line = 0; line < source.lines.size(); ++line) {
      if (progress) progress("storing", 0.5 + 0.5 * ++done / steps);
      if (!source.lines[line]) continue;
      const auto field = read_line(source, part, line);
      if (!field) return refuse(field.error());
      tides.write(id, *source.lines[line], part.variables.quantity, *field);
    }
  }
  return {};
}

}  // namespace

Checked<PreparedDataset> read_tides(const NetcdfFiles& files, const std::filesystem::path& path,
                                    const IngestOptions& options, const core::ProgressCallback& progress) {
  PreparedDataset data;
  data.kind = repository::DatasetKind::tides;
  auto source = open_source(files, path.stem().string(), options, data.warnings);
  if (!source) return refuse(source.error());
  const auto nodes = look_through(*source, progress);
  if (!nodes) return refuse(nodes.error());

  for (const auto& line : source->lines)
    if (line) data.variables.push_back(tide::constituent_name(*line));
  data.bounds = source->grid.bounds();
  data.rows_accepted = *nodes;
  data.write = [source = std::move(*source), progress](sql::Connection& db, const repository::DatasetId& id) {
    return write(source, progress, db, id);
  };
  return data;
}

}  // namespace floeplan::ingest
