#pragma once
#include <vector>

#include "recorder/record/wall_module.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace millwear::recorder {

/// Counts the particles that touch the liner, by class: diameter and atom type, the largest first,
/// the lower type first. Changes nothing in LIGGGHTS.
class LinerCensus {
 public:
  /// Counts at every step that is a multiple of `every_steps`. The deck's charge and mesh have to
  /// stand; every rank makes one. Throws InputError where the deck has not one mesh that is
  /// touched.
  LinerCensus(LAMMPS_NS::LAMMPS& liggghts, long every_steps);

  LinerCensus(const LinerCensus&) = delete;
  LinerCensus& operator=(const LinerCensus&) = delete;

  /// The mean count of each class since the last call, over all ranks. Every rank has to call it.
  [[nodiscard]] std::vector<double> take_means();

 private:
  struct Kind {
    double radius;
    int type;
    auto operator<=>(const Kind&) const = default;
  };

  [[nodiscard]] std::vector<Kind> kinds_of_all_ranks() const;
  void count(const std::vector<WallTouch>& touches);

  LAMMPS_NS::LAMMPS& liggghts_;
  std::vector<Kind> kinds_;
  std::vector<double> counts_;  ///< on this rank
  long samples_ = 0;
  WallModule module_;
};

}  // namespace millwear::recorder
