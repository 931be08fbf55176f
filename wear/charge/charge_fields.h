#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

namespace millwear::wear {

/// Square cells over the mill's section in the frame at rest: x to the right, z up, the axis in the
/// middle. Cell `column + cells * row`, rows from the bottom.
struct SectionGrid {
  double half_width;  ///< [m]
  int cells;          ///< along a side

  [[nodiscard]] double cell_size() const { return 2.0 * half_width / cells; }
  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(cells) * cells; }
  bool operator==(const SectionGrid&) const = default;
};

/// One particle at one instant.
struct ChargeParticle {
  Eigen::Vector3d place;     ///< of its centre [m], mill frame
  Eigen::Vector3d velocity;  ///< [m/s]
  double radius;             ///< [m]
  double mass;               ///< [kg]
  std::size_t particle_class;
};

/// What is told of a cell; sums over the instants of `ChargeFields`.
enum class FieldSum {
  solid,       ///< share of the cell's volume that is particle [-]; also the share of time that a
               ///< place in it is inside of one
  mass,        ///< [kg]
  momentum_x,  ///< [kg m/s]
  momentum_y,
  momentum_z,
  kinetic,  ///< sum of m |v|^2, twice the kinetic energy [J]
};
inline constexpr std::size_t field_sum_count = 6;

/// Where the charge is and how it moves, averaged over the time of a measurement and the length of
/// the slice, in the frame at rest. A particle counts to all cells whose middle lies in its
/// section, in proportion to the length of its chord there.
struct ChargeFields {
  SectionGrid grid;
  double slice_length;                 ///< [m]
  double instants;                     ///< that were summed [-]
  Eigen::MatrixXd sums;                ///< cells x `field_sum_count`
  Eigen::MatrixXd class_mass;          ///< [kg], cells x particle classes
  double pair_duration;                ///< that the collisions between particles were recorded [s]
  Eigen::VectorXd normal_dissipation;  ///< of contacts between particles in that time [J], by cell
  Eigen::VectorXd shear_dissipation;   ///< likewise
};

[[nodiscard]] ChargeFields no_charge_fields(const SectionGrid& grid, double slice_length,
                                            std::size_t class_count);

/// Sums a charge over instants.
class ChargeFieldSums {
 public:
  ChargeFieldSums(const SectionGrid& grid, double slice_length, std::size_t class_count);

  void begin_instant() { fields_.instants += 1.0; }
  void add(const ChargeParticle& particle);
  /// What a contact between two particles at a place dissipates in `interval` [s].
  void add_contact(const Eigen::Vector3d& place, double normal_power, double shear_power,
                   double interval);
  /// The contacts of another `interval` [s] are added.
  void add_pair_time(double interval) { fields_.pair_duration += interval; }

  [[nodiscard]] const ChargeFields& fields() const { return fields_; }

 private:
  ChargeFields fields_;
  std::vector<std::pair<Eigen::Index, double>> chords_;  ///< of one particle, by cell [m]
};

/// Sum of the records of two parts of the time. They have the same grid and classes
/// (std::logic_error).
[[nodiscard]] ChargeFields sum_of(const ChargeFields& first, const ChargeFields& second);

/// A sum at a place (x, z) [m], between the middles of the four cells around it.
[[nodiscard]] double interpolated(const ChargeFields& fields, FieldSum sum,
                                  const Eigen::Vector2d& place);

/// What is drawn of the fields, a value a cell; NaN where no particle came.
struct FieldMap {
  Eigen::VectorXd occupied;      ///< share of the time that a place is inside of a particle [-]
  Eigen::VectorXd velocity_x;    ///< of the mass [m/s]
  Eigen::VectorXd velocity_z;    ///< [m/s]
  Eigen::VectorXd temperature;   ///< granular temperature (<v^2> - <v>^2) / 3 [m2/s2]
  Eigen::VectorXd normal_power;  ///< of collisions between particles, for a volume [W/m3]
  Eigen::VectorXd shear_power;   ///< likewise
  Eigen::MatrixXd class_share;   ///< of the mass, cells x classes
};

[[nodiscard]] FieldMap map_of(const ChargeFields& fields);

/// Means over five by five cells around each, as far as they lie on the grid: for what few events
/// make.
[[nodiscard]] Eigen::VectorXd averaged(const SectionGrid& grid, const Eigen::VectorXd& values);

}  // namespace millwear::wear
