/// What the leak sanitizer asks a program for: libraries that keep memory until the program ends.
/// OpenCASCADE, which gmsh calls, keeps tables of its own. HDF5 cannot tidy up after a full disk.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libTK\nleak:libhdf5"; }
