#pragma once
#include <liggghts/neighbor.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "recorder/neighbours/size_grids.h"

namespace millwear::recorder {

/// LIGGGHTS's lists of the neighbours of its particles, with the same neighbours in the same order,
/// found by `SizeGrids`. Lists that LIGGGHTS would not build by its search for granular particles,
/// or from which pairs or groups are left out, it builds as before.
class ParticleNeighbours : public LAMMPS_NS::Neighbor {
 public:
  explicit ParticleNeighbours(LAMMPS_NS::LAMMPS* liggghts);

  /// The particles of this rank and their copies from others, where a list was built in this step;
  /// else none.
  [[nodiscard]] const SizeGrids* grids_of_this_step() const;

  /// Rank of the bin that a particle was in at the last build: LIGGGHTS's walls go through its bins
  /// by x, then y, then z.
  [[nodiscard]] std::uint64_t order_by_columns(int particle) const;

 protected:
  void choose_build(int index, LAMMPS_NS::NeighRequest* request) override;

 private:
  void build_by_size(LAMMPS_NS::NeighList* list);
  void note_bins();

  std::optional<SizeGrids> grids_;
  LAMMPS_NS::bigint built_at_ = -1;
  std::vector<int> bin_of_;
  std::vector<int> near_;
  std::vector<std::pair<int, int>> ordered_;  ///< bin and particle
};

}  // namespace millwear::recorder
