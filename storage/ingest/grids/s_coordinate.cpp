#include "storage/ingest/grids/s_coordinate.hpp"

#include <cmath>
#include <limits>

#include "engine/messages/ingest_grid_messages.hpp"
#include "storage/ingest/formats/netcdf/formula_terms.hpp"
#include "storage/ingest/formats/netcdf/netcdf_coordinates.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double max_surface_m = 20.0;  // the highest tides reach 16 m

const NetcdfVariable* find(const NetcdfFiles& files, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    for (const auto& file : files)
      if (const NetcdfVariable* variable = file->find(name)) return variable;
  return nullptr;
}

std::optional<double> scalar(const NetcdfFiles& files, const std::vector<std::string>& names) {
  if (const NetcdfVariable* variable = find(files, names)) {
    const auto values = variable->read_all();
    if (values && values->size() == 1 && std::isfinite(values->front())) return values->front();
  }
  for (const std::string& name : names)
    for (const auto& file : files)
      if (const auto value = file->numeric_attribute(name)) return value;
  return std::nullopt;
}

const NetcdfVariable* named_or(const NetcdfFiles& files, const std::string& named,
                               std::vector<std::string> usual) {
  if (!named.empty()) usual.insert(usual.begin(), named);
  return find(files, usual);
}

std::optional<SCoordinate> form_of(const NetcdfFiles& files, const NetcdfVariable* coordinate) {
  const std::string name = coordinate == nullptr ? "" : lower(coordinate->attribute("standard_name"));
  if (name == "ocean_sigma_coordinate") return SCoordinate::sigma;
  std::optional<SCoordinate> by_name;
  if (name == "ocean_s_coordinate_g1" || name == "ocean_s_coordinate") by_name = SCoordinate::g1;
  if (name == "ocean_s_coordinate_g2") by_name = SCoordinate::g2;
  const auto number = scalar(files, {"Vtransform", "vtransform"});
  if (!number) return by_name;
  if (*number != 1.0 && *number != 2.0) return std::nullopt;
  const SCoordinate by_number = *number == 1.0 ? SCoordinate::g1 : SCoordinate::g2;
  if (by_name && *by_name != by_number) return std::nullopt;
  return by_number;
}

/// Values along the levels, in the file's order; between -1 and 0.
Checked<std::vector<double>> level_values(const NetcdfVariable& variable, std::size_t levels) {
  auto values = variable.read_all();
  if (!values) return values;
  bool usable = values->size() == levels;
  for (const double value : *values) usable = usable && value >= -1.0 - 1e-6 && value <= 1e-6;
  if (!usable) return refuse(messages::ingest_grid_message<"levels-no-shares">(variable.name()));
  return values;
}

class SLevels : public BedLevels {
 public:
  struct Parts {
    NetcdfFiles files;  // references that keep the files open
    SCoordinate form{};
    std::vector<double> s;  // of each level, in the file's order
    std::vector<double> stretching;
    double critical_depth_m{};
    std::vector<double> bed_m;  // depth of the sea bed below the mean surface at the centres
    const NetcdfVariable* surface{nullptr};
    std::optional<AxisNodes> times;
    CentreTables tables;
  };

  explicit SLevels(Parts parts) : parts_{std::move(parts)}, upwards_{parts_.s.front() < parts_.s.back()} {}

  [[nodiscard]] std::size_t file_level(std::size_t level) const override {
    return upwards_ ? parts_.s.size() - 1 - level : level;
  }

  [[nodiscard]] Checked<std::vector<float>> depths(std::size_t time, std::size_t level) const override {
    if (const auto read = read_surface(time); !read) return refuse(read.error());
    const bool bed = level == parts_.s.size();
    const std::size_t k = bed ? 0 : file_level(level);
    std::vector<float> result(parts_.bed_m.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
      const double surface = surface_m_.empty() || std::isnan(surface_m_[i]) ? 0.0 : surface_m_[i];
      const double height = bed ? -parts_.bed_m[i]
                                : s_level_height_m(parts_.form, parts_.s[k], parts_.stretching[k],
                                                   parts_.critical_depth_m, parts_.bed_m[i], surface);
      result[i] = static_cast<float>(surface - height);
    }
    return result;
  }

 private:
  Checked<bool> read_surface(std::size_t time) const {
    if (parts_.surface == nullptr || (time_read_ && *time_read_ == time)) return true;
    std::vector<std::uint64_t> leading;
    if (parts_.surface->dimensions().size() == 3)
      leading.push_back(parts_.surface->dimensions()[0].size == 1 ? 0 : parts_.times->source[time]);
    auto values = parts_.tables.read(*parts_.surface, leading);
    if (!values) return refuse(values.error());
    for (const double value : *values)
      if (std::abs(value) > max_surface_m)
        return refuse(
            messages::ingest_grid_message<"surface-impossible">(parts_.surface->name(), number(value)));
    surface_m_ = std::move(*values);
    time_read_ = time;
    return true;
  }

  Parts parts_;
  bool upwards_;
  mutable std::vector<double> surface_m_;  // elevation of the surface at the time read last
  mutable std::optional<std::size_t> time_read_;
};

/// The standard name of levels with a formula that this program does not know; empty if it is known.
std::string unread_layout_of(const NetcdfVariable* coordinate) {
  const std::string name = coordinate == nullptr ? "" : lower(coordinate->attribute("standard_name"));
  const bool read = name == "ocean_s_coordinate" || name == "ocean_s_coordinate_g1" ||
                    name == "ocean_s_coordinate_g2" || name == "ocean_sigma_coordinate";
  return read || !name.starts_with("ocean_") ? std::string{} : name;
}

messages::Message incomplete(const NetcdfVariable& variable, const std::string& what) {
  return messages::ingest_grid_message<"levels-incomplete">(
      variable.name(), what,
      "Give the model's grid file in the same command, or ask the producer for a complete file");
}

}  // namespace

double s_level_height_m(SCoordinate form, double s, double stretching, double critical_depth_m,
                        double bed_depth_m, double surface_m) {
  if (form == SCoordinate::sigma) return surface_m + s * (surface_m + bed_depth_m);
  if (form == SCoordinate::g1) {
    const double level = critical_depth_m * s + (bed_depth_m - critical_depth_m) * stretching;
    return level + surface_m * (1.0 + level / bed_depth_m);
  }
  const double level = (critical_depth_m * s + bed_depth_m * stretching) / (critical_depth_m + bed_depth_m);
  return surface_m + (surface_m + bed_depth_m) * level;
}

std::optional<double> s_stretching(int form, double s, double theta_s, double theta_b) {
  if (theta_s < 0.0 || theta_b < 0.0) return std::nullopt;
  if (form == 1) {
    if (theta_s == 0.0) return s;
    const double at_surface = std::sinh(theta_s * s) / std::sinh(theta_s);
    const double at_bed = std::tanh(theta_s * (s + 0.5)) / (2.0 * std::tanh(0.5 * theta_s)) - 0.5;
    return (1.0 - theta_b) * at_surface + theta_b * at_bed;
  }
  if (form == 2) {
    if (theta_s == 0.0) return s;
    const double at_surface = (1.0 - std::cosh(theta_s * s)) / (std::cosh(theta_s) - 1.0);
    if (theta_b == 0.0) return at_surface;
    const double at_bed = std::sinh(theta_b * (s + 1.0)) / std::sinh(theta_b) - 1.0;
    const double weight = s + 1.0;  // (s+1)^a (1 + a/b (1 - (s+1)^b)) with a = b = 1
    const double share = weight * (1.0 + (1.0 - weight));
    return share * at_surface + (1.0 - share) * at_bed;
  }
  if (form == 4) {
    const double at_surface =
        theta_s > 0.0 ? (1.0 - std::cosh(theta_s * s)) / (std::cosh(theta_s) - 1.0) : -s * s;
    return theta_b > 0.0 ? (std::exp(theta_b * at_surface) - 1.0) / (1.0 - std::exp(-theta_b)) : at_surface;
  }
  return std::nullopt;
}

Checked<std::shared_ptr<const BedLevels>> s_coordinate_levels(
    const NetcdfFiles& files, const NetcdfFile& file, const NetcdfVariable& variable,
    const NetcdfLayout& layout, const CentreTables& tables, Messages& warnings) {
  const NetcdfDimension& dimension = variable.dimensions()[layout.depth_dimension.value()];
  const NetcdfVariable* coordinate = coordinate_of(file, dimension);
  const NetcdfVariable* s = coordinate != nullptr ? coordinate : find(files, {"s_rho", "sc_r"});
  if (s == nullptr) return refuse(incomplete(variable, "where they lie (s_rho)"));
  if (const std::string layout = unread_layout_of(coordinate); !layout.empty())
    return refuse(messages::ingest_grid_message<"levels-of-unknown-layout">(coordinate->name(), layout, ""));
  const auto form = form_of(files, coordinate);
  if (!form)
    return refuse(incomplete(variable, "without contradiction in which form they do so (Vtransform 1 or 2)"));
  std::vector<std::string> critical_names{"hc", "Tcline"};
  if (const std::string named = formula_term(coordinate, "depth_c"); !named.empty())
    critical_names.insert(critical_names.begin(), named);
  const bool sigma = *form == SCoordinate::sigma;
  const auto critical = sigma ? std::optional{0.0} : scalar(files, critical_names);
  if (!critical || *critical < 0.0) return refuse(incomplete(variable, "their critical depth (hc)"));

  auto s_values = level_values(*s, layout.bed_levels);
  if (!s_values) return refuse(s_values.error());
  std::vector<double> stretching;
  if (sigma) {
    stretching = *s_values;
  } else if (const NetcdfVariable* table =
                 named_or(files, formula_term(coordinate, "C"), {"Cs_r", "Cs_rho"})) {
    auto values = level_values(*table, layout.bed_levels);
    if (!values) return refuse(values.error());
    stretching = std::move(*values);
  } else {
    const auto number = scalar(files, {"Vstretching"});
    const auto theta_s = scalar(files, {"theta_s"});
    const auto theta_b = scalar(files, {"theta_b"});
    for (const double at : *s_values) {
      const auto value = number && theta_s && theta_b
                             ? s_stretching(static_cast<int>(*number), at, *theta_s, *theta_b)
                             : std::nullopt;
      if (!value)
        return refuse(incomplete(variable, "how they are stretched (Cs_r, or Vstretching 1, 2 or 4)"));
      stretching.push_back(*value);
    }
  }

  const NetcdfVariable* bed = named_or(files, formula_term(coordinate, "depth"), {"h"});
  if (bed == nullptr || bed->dimensions().size() != 2 || !tables.fits(*bed))
    return refuse(incomplete(variable, "how deep the sea is (h)"));
  auto bed_m = tables.read(*bed, {});
  if (!bed_m) return refuse(bed_m.error());
  for (double& depth : *bed_m) {
    if (depth > max_bed_depth_m)
      return refuse(messages::ingest_grid_message<"bed-impossible">(bed->name(), number(depth)));
    if (!(depth > 0.0)) depth = std::numeric_limits<double>::quiet_NaN();
  }
  const NetcdfVariable* surface = named_or(files, formula_term(coordinate, "eta"), {"zeta"});
  const bool usable = surface != nullptr && tables.fits(*surface) &&
                      (surface->dimensions().size() == 2 ||
                       (surface->dimensions().size() == 3 && layout.times_s &&
                        (surface->dimensions()[0].size == 1 ||
                         surface->dimensions()[0].size == layout.times_s->nodes.size())));
  const bool of_the_moment = sigma && is_depth_of_the_moment(*bed);
  if (!usable && !of_the_moment) warnings.push_back(messages::ingest_grid_message<"surface-not-stated">());
  return std::make_shared<const SLevels>(
      SLevels::Parts{.files = files,
                     .form = *form,
                     .s = std::move(*s_values),
                     .stretching = std::move(stretching),
                     .critical_depth_m = *critical,
                     .bed_m = std::move(*bed_m),
                     .surface = usable && !of_the_moment ? surface : nullptr,
                     .times = layout.times_s,
                     .tables = tables});
}

}  // namespace floeplan::ingest
