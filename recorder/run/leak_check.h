#pragma once

namespace millwear::recorder {

/// In a build with the address sanitizer: what is allocated while it lives counts as never lost.
/// For MPI_Init, which loses some bytes of its own.
class UncheckedForLeaks {
 public:
  UncheckedForLeaks();
  ~UncheckedForLeaks();
  UncheckedForLeaks(const UncheckedForLeaks&) = delete;
  UncheckedForLeaks& operator=(const UncheckedForLeaks&) = delete;
};

/// In a build with the address sanitizer: fails the program where memory was lost. To be called
/// before MPI_Finalize, which unloads MPI's plugins, so that whatever they hold would look lost.
void check_for_leaks();

}  // namespace millwear::recorder
