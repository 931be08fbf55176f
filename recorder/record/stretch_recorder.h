#pragma once
#include <mpi.h>

#include <optional>
#include <vector>

#include "mill/case/case.h"
#include "mill/case/liner_friction.h"
#include "mill/recording/recorder_orders.h"
#include "recorder/record/charge_census.h"
#include "recorder/record/charge_recorder.h"
#include "recorder/record/collision_spool.h"
#include "recorder/record/going_on.h"
#include "recorder/record/wall_module.h"
#include "wear/record/load_accumulator.h"
#include "wear/record/pair_tracker.h"

namespace millwear::recorder {

/// Records one stretch from inside LIGGGHTS: hangs itself on the liner's mesh, sums every wall
/// contact of the measurement as it happens, and publishes the sums of all ranks at its end.
class StretchRecorder {
 public:
  /// The deck's mesh has to stand and no step of the measurement be done. Throws InputError where
  /// deck and case do not belong together.
  StretchRecorder(LAMMPS_NS::LAMMPS& liggghts, const Case& mill, const RecordingPlan& plan);

  StretchRecorder(const StretchRecorder&) = delete;
  StretchRecorder& operator=(const StretchRecorder&) = delete;

  /// To be called before every run of the deck.
  void before_run();

  /// By how many steps the measurement goes on now, to be called after every run of the deck by
  /// every rank: 0 unless it has come to its end, its load is not known well enough, and it may go
  /// on. Those steps have to be run next, without setting up anew.
  [[nodiscard]] long steps_to_go_on();

  /// Writes what was recorded, from rank 0; every rank has to call it. Throws ResultRejected where
  /// the deck ended before the measurement did.
  void publish();

 private:
  StretchRecorder(LAMMPS_NS::LAMMPS& liggghts, const Case& mill, const RecordingPlan& plan,
                  const LinerProfile& liner);

  void take_step(long step, const std::vector<WallTouch>& touches);
  void take_census(double time);
  void take_pairs();
  void finish_pairs();
  [[nodiscard]] NextPiece decide();
  void sum_waiting();
  void exchange_collisions(long step);
  [[nodiscard]] WallContact contact_from(const WallTouch& touch, Company company) const;
  [[nodiscard]] std::size_t class_of_particle(int particle) const;
  [[nodiscard]] double time_at(long step) const;  ///< of the measurement [s]
  [[nodiscard]] bool left_this_rank(std::uint32_t particle) const;
  void check_that_it_turns(const WallTouch& touch) const;
  void take_standing(long step, const WallTouch& touch);
  void begin_with_standing();

  LAMMPS_NS::LAMMPS& liggghts_;
  Case mill_;
  RecordingPlan plan_;
  LinerProfile liner_;
  LAMMPS_NS::FixMeshSurface& mesh_;
  std::vector<LinerFriction> liner_friction_;  ///< by particle class
  std::optional<CollisionSpool> spool_;
  wear::LoadAccumulator load_;
  wear::TurningMill turning_;
  long census_steps_;  ///< between two censuses of the charge
  CompanyFinder company_;
  std::optional<ChargeRecorder> charge_;
  std::optional<wear::PairTracker> pairs_;
  std::optional<wear::PairRecord> pair_record_;  ///< once their window is over
  std::optional<wear::MeasurementGoal> goal_;    ///< once the measurement has come to its end
  WallModule module_;
  /// Samples that wait to be summed together: from one sample to the next LIGGGHTS sweeps the
  /// caches empty, so several in one go cost a third less.
  std::vector<WallContacts> waiting_;
  std::size_t waiting_count_ = 0;
  WallContacts standing_{};  ///< what touches where a run begins with the measurement
  bool begun_ = false;
  bool ended_ = false;  ///< it was decided not to go on
  bool seen_turning_ = false;
  long samples_ = 0;
  long wanted_samples_;  ///< of the measurement as far as it is known to go
  long sampled_until_;   ///< the latest sample's step; at first that with which it all begins
  long latest_step_ = 0;
  mutable std::vector<std::uint16_t>
      class_of_number_;  ///< by particle number, + 1; 0: not yet known
};

}  // namespace millwear::recorder
