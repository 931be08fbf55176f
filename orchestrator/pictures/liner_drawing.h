#pragma once
#include <string>

#include "mill/case/case.h"

namespace millwear::orchestrator {

enum class DrawingFormat { svg, png };

/// The liner in its mill, to scale: on the left the section of the mill with all lifters, on the
/// right one pitch in the frame of the master lifter, with height, thickness of the plate, pitch
/// and angle of the leading face, and the classes of the charge beside it for size (as many as fit,
/// the smallest among them). Throws ExternalProgramError where gnuplot is missing or fails.
[[nodiscard]] std::string liner_drawing(const Case& mill, DrawingFormat format);

}  // namespace millwear::orchestrator
