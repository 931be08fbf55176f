#pragma once
#include <string>

#include "orchestrator/pictures/image.h"
#include "orchestrator/pictures/scene.h"

namespace millwear::orchestrator {

/// A scene in the language of tachyon. Its frame is left-handed, so x is written with the opposite
/// sign.
[[nodiscard]] std::string tachyon_scene(const Scene& scene, const PictureSize& size);

/// Draws a scene on a white ground, one ray a pixel. Throws ExternalProgramError where tachyon
/// fails or is not installed.
[[nodiscard]] Image rendered(const Scene& scene, const PictureSize& size);

}  // namespace millwear::orchestrator
