#include "recorder/run/leak_check.h"

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>

/// LIGGGHTS never deletes the modules that it makes for a mesh, nor PMIx, in its own thread, what
/// it hashes. Nothing of ours is called from there.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:meshmodule_creator\nleak:libpmix.so\n";
}

namespace millwear::recorder {

UncheckedForLeaks::UncheckedForLeaks() { __lsan_disable(); }
UncheckedForLeaks::~UncheckedForLeaks() { __lsan_enable(); }
void check_for_leaks() { __lsan_do_leak_check(); }

}  // namespace millwear::recorder
#else
namespace millwear::recorder {

UncheckedForLeaks::UncheckedForLeaks() = default;
UncheckedForLeaks::~UncheckedForLeaks() = default;
void check_for_leaks() {}

}  // namespace millwear::recorder
#endif
