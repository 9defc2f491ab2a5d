#pragma once

#include <string>

/// What pictures are made of, in picture units, y downwards.
namespace floeplan::codec {

struct PicturePoint {
  double x{};
  double y{};
};

struct PictureLabel {
  PicturePoint at;
  std::string text;
};

}  // namespace floeplan::codec
