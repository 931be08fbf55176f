#pragma once
#include <filesystem>
#include <fstream>
#include <string>

#include "liggghts_inputs/outputs/snapshot_reader.h"

namespace millwear::orchestrator {

/// A dump that lies in a file, read piece by piece.
class DumpSource {
 public:
  /// Throws InputError where the file cannot be opened.
  DumpSource(const std::filesystem::path& file, liggghts::ChooseColumns choose,
             liggghts::SnapshotReader::Take take);
  DumpSource(const DumpSource&) = delete;
  DumpSource& operator=(const DumpSource&) = delete;

  [[nodiscard]] bool at_end() const { return at_end_; }
  [[nodiscard]] long latest_step() const { return latest_step_; }

  /// Reads on; at the end of the file the dump has to be whole. Throws as `SnapshotReader` does.
  void read_piece();

 private:
  std::ifstream in_;
  std::string buffer_;
  bool at_end_ = false;
  long latest_step_ = -1;
  liggghts::SnapshotReader reader_;
};

/// Reads two dumps of one run to their ends, so that neither runs far ahead of the other. Throws
/// Interrupted.
void read_side_by_side(DumpSource& first, DumpSource& second);

}  // namespace millwear::orchestrator
