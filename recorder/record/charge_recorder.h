#pragma once
#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "mill/case/case.h"
#include "mill/recording/recorder_orders.h"
#include "wear/charge/charge_record.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace millwear::recorder {

struct PairTouch;

/// A particle's class of the charge, by its local number.
using ClassOfParticle = std::function<std::size_t(int particle)>;

/// Records how the charge of all ranks looks: its fields at every census, and frames at the
/// beginning of a measurement. Its memory does not grow with the length of the run.
class ChargeRecorder {
 public:
  ChargeRecorder(LAMMPS_NS::LAMMPS& liggghts, const Case& mill, const RecordingPlan& plan,
                 ClassOfParticle class_of);

  /// Sums the charge at a census.
  void take_census();
  /// Keeps a frame where one is due at the end of this step; every rank has to call it for the same
  /// steps.
  void take_frame(long step);
  /// What a contact between particles dissipates in the time of one step.
  void add(const PairTouch& touch);
  /// The contacts of a step were added.
  void end_step_of_pairs();

  /// Writes the record from rank 0; every rank has to call it.
  void publish(const std::filesystem::path& path);

 private:
  struct Row;
  [[nodiscard]] std::vector<Row> rows() const;
  void add_frame(const std::vector<Row>& rows, long step);

  LAMMPS_NS::LAMMPS& liggghts_;
  ClassOfParticle class_of_;
  double mill_speed_;  ///< [rad/s]
  long first_step_;
  long frame_steps_;  ///< between two frames
  std::size_t frames_left_;
  wear::ChargeFieldSums fields_;
  std::optional<wear::ChargeFrames> frames_;
};

}  // namespace millwear::recorder
