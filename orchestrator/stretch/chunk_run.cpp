#include "orchestrator/stretch/chunk_run.h"

#include <fmt/format.h>

#include <map>

#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "orchestrator/campaign/folder_hashes.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/campaign/work_folder.h"
#include "orchestrator/stretch/stretch_decks.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

/// Of the work that a chunk's folder comes from.
constexpr const char* inputs_file = "inputs.hash";

std::string hash_of_inputs(const fs::path& folder, const std::string& depends_on) {
  std::map<std::string, std::string> hashes;
  for (const auto& file : fs::directory_iterator(folder))
    hashes[file.path().filename().string()] = hash_of_file(file.path());
  std::string text = depends_on;
  for (const auto& [name, hash] : hashes) text += fmt::format("\n{} {}", name, hash);
  return hash_of_text(text);
}

bool is_done(const fs::path& folder, const std::string& inputs) {
  return is_as_sealed(folder) && fs::exists(folder / inputs_file) &&
         read_file(folder / inputs_file) == inputs;
}

}  // namespace

void run_chunk(const Campaign& campaign, const ChunkWork& work) {
  const fs::path partial = work.folder.string() + ".partial";
  const fs::path into = begin_work(campaign, partial);
  work.write_inputs(into);
  const std::string inputs = hash_of_inputs(into, work.depends_on);
  if (is_done(work.folder, inputs)) {
    fs::remove_all(into);
    return;
  }
  fs::remove_all(work.folder);
  work.simulate(into);
  write_file(into / inputs_file, inputs);
  end_work(into, partial);
  seal_folder(partial);
  fs::rename(partial, work.folder);
  sync_path(work.folder.parent_path());
}

void remove_chunks(const Campaign& campaign, const StageId& stage) {
  const fs::path first = chunk_folder(campaign, stage, 0);
  const std::string name = first.filename().string();
  const std::string common = name.substr(0, name.size() - 1);
  std::vector<fs::path> chunks;
  for (const auto& entry : fs::directory_iterator(first.parent_path()))
    if (entry.path().filename().string().starts_with(common)) chunks.push_back(entry.path());
  for (const auto& chunk : chunks) fs::remove_all(chunk);
}

int chunks_done(const Campaign& campaign, const StageId& stage) {
  int done = 0;
  while (fs::exists(chunk_folder(campaign, stage, done))) ++done;
  return done;
}

}  // namespace millwear::orchestrator
