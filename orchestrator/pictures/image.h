#pragma once
#include <string>

namespace millwear::orchestrator {

struct PictureSize {
  int width;   ///< [px]
  int height;  ///< [px]
};

/// Three bytes a pixel, red, green and blue, row by row from the top.
struct Image {
  PictureSize size;
  std::string pixels;
};

/// Reads a PPM of eight bits a colour (P6). Throws ExternalProgramError for anything else: a
/// program wrote it.
[[nodiscard]] Image image_from_ppm(const std::string& bytes);

/// Every `factor` x `factor` pixels as one of their mean colour; what is left over at the right and
/// the bottom is dropped.
[[nodiscard]] Image shrunk(const Image& image, int factor);

}  // namespace millwear::orchestrator
