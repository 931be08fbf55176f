/// What the leak sanitizer asks a program for: OpenCASCADE, which gmsh calls, keeps tables of its own
/// until the program ends.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libTK"; }
