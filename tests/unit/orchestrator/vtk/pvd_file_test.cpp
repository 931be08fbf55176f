#include "orchestrator/vtk/pvd_file.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace millwear::orchestrator {
namespace {

TEST(PvdFile, NamesAFileATime) {
  EXPECT_EQ(pvd_file({{0.0, "liner/a.vtp"}, {804.5, "liner/b.vtp"}}),
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
            "  <Collection>\n"
            "    <DataSet timestep=\"0\" part=\"0\" file=\"liner/a.vtp\"/>\n"
            "    <DataSet timestep=\"804.5\" part=\"0\" file=\"liner/b.vtp\"/>\n"
            "  </Collection>\n"
            "</VTKFile>\n");
}

TEST(PvdFile, GoesOnInTime) {
  EXPECT_THROW(static_cast<void>(pvd_file({{2.0, "a"}, {1.0, "b"}})), std::logic_error);
}

}  // namespace
}  // namespace millwear::orchestrator
