#include "recorder/record/liner_census.h"

#include <liggghts/atom.h>
#include <liggghts/lammps.h>

#include <algorithm>
#include <utility>

#include "recorder/record/mesh_hook.h"
#include "recorder/record/rank_exchange.h"

namespace millwear::recorder {

LinerCensus::LinerCensus(LAMMPS_NS::LAMMPS& liggghts, long every_steps)
    : liggghts_(liggghts),
      kinds_(kinds_of_all_ranks()),
      counts_(kinds_.size(), 0.0),
      module_(
          liggghts, the_mesh(liggghts),
          [every_steps](long step) { return step % every_steps == 0; },
          [this](long, const std::vector<WallTouch>& touches) { count(touches); },
          [](long, const WallTouch&) {}) {
  hang_on(liggghts, the_mesh(liggghts), module_);
}

std::vector<LinerCensus::Kind> LinerCensus::kinds_of_all_ranks() const {
  const auto sorted = [](std::vector<Kind> kinds) {
    std::ranges::sort(kinds, [](const Kind& a, const Kind& b) {
      return a.radius != b.radius ? a.radius > b.radius : a.type < b.type;
    });
    const auto repeated = std::ranges::unique(kinds);
    kinds.erase(repeated.begin(), repeated.end());
    return kinds;
  };
  const auto& atom = *liggghts_.atom;
  std::vector<Kind> mine;
  for (int i = 0; i < atom.nlocal; ++i) mine.push_back({atom.radius[i], atom.type[i]});
  return sorted(of_all_ranks(sorted(std::move(mine)), liggghts_.world));
}

void LinerCensus::count(const std::vector<WallTouch>& touches) {
  std::vector<int> particles;
  for (const WallTouch& touch : touches) particles.push_back(touch.particle);
  std::ranges::sort(particles);  // a particle may touch several triangles
  const auto repeated = std::ranges::unique(particles);
  particles.erase(repeated.begin(), repeated.end());
  const auto& atom = *liggghts_.atom;
  for (const int particle : particles) {
    const auto found = std::ranges::find(kinds_, Kind{atom.radius[particle], atom.type[particle]});
    if (found != kinds_.end()) ++counts_[static_cast<std::size_t>(found - kinds_.begin())];
  }
  ++samples_;
}

std::vector<double> LinerCensus::take_means() {
  auto means = sums_over_ranks(counts_, liggghts_.world);
  for (double& mean : means) mean /= static_cast<double>(std::max(1L, samples_));
  std::ranges::fill(counts_, 0.0);
  samples_ = 0;
  return means;
}

}  // namespace millwear::recorder
