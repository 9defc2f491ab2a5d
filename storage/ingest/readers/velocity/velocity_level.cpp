#include "storage/ingest/readers/velocity/velocity_level.hpp"

#include <utility>

namespace floeplan::ingest {
namespace {

class OneLevel : public VelocitySource {
 public:
  OneLevel(std::shared_ptr<const VelocitySource> source, std::size_t level, std::optional<double> depth_m)
      : source_{std::move(source)}, level_{level}, shape_{source_->shape()} {
    shape_.levels = 1;
    shape_.depths_m.reset();
    if (depth_m) shape_.depths_m = {*depth_m};
  }

  [[nodiscard]] const SourceShape& shape() const override { return shape_; }
  [[nodiscard]] geo::LonLat place(std::size_t point) const override { return source_->place(point); }
  [[nodiscard]] Checked<VelocitySlice> read(std::size_t time, std::size_t /*level*/) const override {
    return source_->read(time, level_);
  }
  [[nodiscard]] Checked<std::vector<float>> level_depths(std::size_t time, std::size_t level) const override {
    return source_->level_depths(time, level);
  }

 private:
  std::shared_ptr<const VelocitySource> source_;
  std::size_t level_;
  SourceShape shape_;
};

}  // namespace

std::shared_ptr<const VelocitySource> one_level(std::shared_ptr<const VelocitySource> source,
                                                std::size_t level, std::optional<double> depth_m) {
  return std::make_shared<const OneLevel>(std::move(source), level, depth_m);
}

}  // namespace floeplan::ingest
