#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "liggghts_inputs/decks/stretch.h"
#include "liggghts_inputs/outputs/snapshot_reader.h"
#include "mill/case/case.h"
#include "mill/case/liner_friction.h"
#include "mill/load/wall_contacts.h"

namespace millwear::liggghts {

inline constexpr std::size_t contact_columns = 11;  ///< of `dump contacts` in templates/measure.in
inline constexpr std::size_t spin_columns = 12;     ///< of `dump spins`

/// How the steps and axes of dumps stand to the mill's.
struct DumpFrame {
  double time_step;    ///< of the deck [s]
  long first_step;     ///< with it the measurement begins
  long last_step;      ///< ... and with it ends
  long samples;        ///< snapshots after the first step up to the last
  double angle = 0.0;  ///< of the mill at `angle_step` [rad], see mill/liner/mill_frame.h
  long angle_step = 0;
  Eigen::Matrix3d to_mill = Eigen::Matrix3d::Identity();  ///< turns the deck's axes to the mill's
};

/// That of a measuring deck of ours.
[[nodiscard]] DumpFrame dump_frame(const StretchSteps& steps);

/// Joins the two dumps of a measuring deck, wall contacts and particles near the wall, step by
/// step. LIGGGHTS's wall contacts carry no spin; with it the slip velocity of the surfaces is
///     v_slip = v + omega x (contact - centre) - Omega x contact,   less its normal part.
/// The dumped tangential force is right while a contact holds, but for its damper's velocity, and
/// too large while it slides: it is cut to mu |Fn|. Finnie's force is Fn alone. A sample stands for
/// the time since the one before, the first for that since the measurement began. Holds the
/// snapshots of one dump that the other has not reached yet.
class ContactJoin {
 public:
  using Take = std::function<void(const WallContacts&)>;

  /// `begin` gets what touches the liner as the measurement begins; `particles` is the largest
  /// particle number.
  ContactJoin(const Case& mill, std::size_t particles, const DumpFrame& frame, Take take,
              Take begin = {});

  /// Of a deck of ours, with the particles of the case.
  ContactJoin(const Case& mill, const StretchSteps& steps, Take take, Take begin = {});

  void take_contacts(const Snapshot& contacts);
  void take_spins(const Snapshot& spins);

  /// The end of both dumps. Throws ResultRejected unless the beginning and every sample have come,
  /// from both.
  void finish() const;

  [[nodiscard]] long last_step() const { return last_step_; }

 private:
  struct ParticleState {
    std::size_t particle_class;
    double radius;
    Eigen::Vector3d centre, velocity, spin;
  };

  void join_ready();
  void join(const Snapshot& contacts, const Snapshot& spins);
  void index_spins(const Snapshot& spins);
  [[nodiscard]] bool is_id(double id) const;
  [[nodiscard]] std::size_t class_of_particle(std::size_t material, double radius) const;
  [[nodiscard]] Eigen::Vector3d vector_at(std::span<const double> row, std::size_t column) const;
  void check_arm(const Eigen::Vector3d& arm, double id, double radius, long step) const;
  [[nodiscard]] WallContact contact_from(std::span<const double> row, long step) const;
  [[nodiscard]] const ParticleState& state_of(double id, long step) const;

  std::vector<ParticleClass> classes_;
  std::vector<LinerFriction> friction_;  ///< of each class
  double slice_length_;
  double mill_speed_;
  DumpFrame frame_;
  Take take_;
  Take begin_;
  std::map<long, Snapshot> waiting_contacts_, waiting_spins_;
  std::vector<std::uint32_t> row_of_particle_;  ///< by particle id, 1 + row, 0 where absent
  std::vector<ParticleState> states_;
  WallContacts joined_{};
  bool begun_ = false;
  long samples_ = 0;
  long last_step_;  ///< joined; at first that with which the measurement begins
};

}  // namespace millwear::liggghts
