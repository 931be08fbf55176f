#include "orchestrator/postprocess/dump_source.h"

#include <fmt/format.h>

#include <utility>

#include "mill/base/failure.h"
#include "orchestrator/process/child_process.h"

namespace millwear::orchestrator {
namespace {

constexpr std::size_t piece_size = 1 << 18;

}  // namespace

DumpSource::DumpSource(const std::filesystem::path& file, liggghts::ChooseColumns choose,
                       liggghts::SnapshotReader::Take take)
    : in_(file, std::ios::binary),
      buffer_(piece_size, '\0'),
      reader_(file.string(), std::move(choose),
              [this, take = std::move(take)](const liggghts::Snapshot& snapshot) {
                latest_step_ = snapshot.step;
                take(snapshot);
              }) {
  std::error_code ignored;
  if (!in_ || !std::filesystem::is_regular_file(file, ignored))
    throw InputError(fmt::format("{}: there is no such file, or it cannot be read", file.string()));
}

void DumpSource::read_piece() {
  in_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  reader_.feed({buffer_.data(), static_cast<std::size_t>(in_.gcount())});
  at_end_ = !in_;
  if (at_end_) reader_.finish();
}

void read_side_by_side(DumpSource& first, DumpSource& second) {
  while (!first.at_end() || !second.at_end()) {
    stop_if_interrupted();
    const bool first_is_behind =
        second.at_end() || (!first.at_end() && first.latest_step() <= second.latest_step());
    (first_is_behind ? first : second).read_piece();
  }
}

}  // namespace millwear::orchestrator
