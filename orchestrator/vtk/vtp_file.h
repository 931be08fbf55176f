#pragma once
#include <string>

#include "orchestrator/vtk/poly_data.h"

namespace millwear::orchestrator {

/// The bytes of a .vtp file: VTK's XML format for `vtkPolyData`, version 1.0, little-endian, with
/// the numbers behind the XML as raw bytes (`AppendedData`), each array after its length as UInt64.
/// ParaView and every VTK from 6 on read it. Source: "VTK File Formats", the VTK user's guide.
/// All arrays have as many numbers as there are points or cells times components
/// (std::logic_error).
[[nodiscard]] std::string vtp_file(const VtkPolyData& data);

}  // namespace millwear::orchestrator
