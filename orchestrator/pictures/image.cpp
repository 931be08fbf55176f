#include "orchestrator/pictures/image.h"

#include <sstream>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

constexpr std::size_t colours = 3;

std::size_t bytes_of(const PictureSize& size) {
  return colours * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

}  // namespace

Image image_from_ppm(const std::string& bytes) {
  std::istringstream head(bytes.substr(0, 64));
  std::string type;
  PictureSize size{};
  int brightest = 0;
  head >> type >> size.width >> size.height >> brightest;
  const bool read =
      head.good() && type == "P6" && size.width > 0 && size.height > 0 && brightest == 255;
  const std::size_t start = read ? static_cast<std::size_t>(head.tellg()) + 1 : 0;
  if (!read || bytes.size() != start + bytes_of(size))
    throw ExternalProgramError("the renderer wrote no PPM picture of eight bits a colour");
  return {size, bytes.substr(start)};
}

Image shrunk(const Image& image, int factor) {
  const PictureSize size{image.size.width / factor, image.size.height / factor};
  Image small{size, std::string(bytes_of(size), '\0')};
  const auto of = [&](int x, int y, std::size_t colour) {
    const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.width) +
                       static_cast<std::size_t>(x);
    return static_cast<unsigned char>(image.pixels[colours * pixel + colour]);
  };
  std::size_t next = 0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      for (std::size_t colour = 0; colour < colours; ++colour) {
        int sum = 0;
        for (int dy = 0; dy < factor; ++dy)
          for (int dx = 0; dx < factor; ++dx) sum += of(factor * x + dx, factor * y + dy, colour);
        small.pixels[next++] = static_cast<char>(sum / (factor * factor));
      }
  return small;
}

}  // namespace millwear::orchestrator
