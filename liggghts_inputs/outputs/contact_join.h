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

/// Joins the two dumps of a measuring deck, wall contacts and particles near the wall, step by
/// step. LIGGGHTS's wall contacts carry no spin; with it the slip velocity of the surfaces is
///     v_slip = v + omega x (contact - centre) - Omega x contact,   less its normal part.
/// The dumped tangential force is right while a contact holds, but for its damper's velocity, and
/// too large while it slides: it is cut to mu |Fn|. Finnie's force is Fn alone. Holds the snapshots
/// of one dump that the other has not reached yet.
class ContactJoin {
 public:
  using Take = std::function<void(const WallContacts&)>;

  /// `begin` gets what touches the liner as the measurement begins, where the dumps have it.
  ContactJoin(const Case& mill, const StretchSteps& steps, Take take, Take begin = {});

  void take_contacts(const Snapshot& contacts);
  void take_spins(const Snapshot& spins);

  /// The end of both dumps. Throws ResultRejected unless every sample has come, from both.
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
  [[nodiscard]] WallContact contact_from(std::span<const double> row, long step) const;
  [[nodiscard]] const ParticleState& state_of(double id, long step) const;

  std::vector<ParticleClass> classes_;
  std::vector<LinerFriction> friction_;  ///< of each class
  double slice_length_;
  double mill_speed_;
  StretchSteps steps_;
  Take take_;
  Take begin_;
  std::map<long, Snapshot> waiting_contacts_, waiting_spins_;
  std::vector<std::uint32_t> row_of_particle_;  ///< by particle id, 1 + row, 0 where absent
  std::vector<ParticleState> states_;
  WallContacts joined_{};
  long samples_ = 0;
  long last_step_ = 0;
};

}  // namespace millwear::liggghts
