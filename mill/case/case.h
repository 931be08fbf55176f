#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mill/case/campaign_settings.h"
#include "mill/case/charge.h"
#include "mill/case/wear_settings.h"
#include "mill/liner/liner_profile.h"

namespace millwear {

/// A solid: density [kg/m3], shear modulus as measured [Pa] (before it is softened for the DEM) and
/// Poisson's ratio.
struct Material {
  std::string name;
  double density;
  double shear_modulus;
  double poisson_ratio;
  std::optional<double> modulus_reduction{};  ///< in place of the DEM's for all
};

/// How two materials touch: coefficients of sliding and rolling friction and of restitution.
struct MaterialPair {
  std::size_t first;   ///< index into Case::materials
  std::size_t second;  ///< index into Case::materials
  double sliding_friction;
  double rolling_friction;
  double restitution;
};

/// What the owner declares about the filling, shares of the mill's inside volume. Used for the
/// counts where the charge is given by filling, and only compared with where it is given by counts.
struct DeclaredFilling {
  std::optional<double> total;  ///< J
  std::optional<double> balls;
};

struct Charge {
  std::vector<ParticleClass> classes;  ///< largest first
  DeclaredFilling declared;
  double porosity = 0.4;        ///< voids of the charge at rest
  double truncate_below = 0.0;  ///< sizes under this are left out [m]; 0 keeps all
};

enum class RollingFriction { cdt, epsd2 };

/// How the wall contacts of a run are seen.
enum class ContactPath {
  recorder,  ///< every step, from inside LIGGGHTS, by millwear-recorder
  dumps,     ///< sampled, through text dumps of the plain liggghts
};

/// How MPI ranks share the mill.
enum class RankSplit {
  charge,  ///< half of them on either side of the moving charge's middle, each half along the axis
  axis,    ///< slabs along the axis
  balanced,  ///< columns across the mill with equally many particles each (recorder only)
};

/// As the case file writes them.
[[nodiscard]] std::string_view name_of(RollingFriction model);
[[nodiscard]] std::string_view name_of(ContactPath path);
[[nodiscard]] std::string_view name_of(RankSplit split);

/// How well a measurement is to know the smoothed rate of loss at its peaks before it ends.
struct ErrorTarget {
  double relative_error;    ///< above 0, up to 1
  double most_revolutions;  ///< it ends then, however well it is known
};

/// The defaults are those of the case file, here and in the settings of wear and campaign.
struct DemSettings {
  double modulus_reduction = 100.0;           ///< the moduli are divided by this
  double rayleigh_fraction = 0.3;             ///< time step as a share of the least Rayleigh time
  std::optional<double> longest_time_step{};  ///< [s]; the step is never above this
  RollingFriction rolling_friction = RollingFriction::cdt;
  double mix_revolutions = 2.0;       ///< before the first measurement
  int settle_pitches = 2;             ///< turned on a new mesh before the load is measured
  double measure_revolutions = 1.0;   ///< with a target the least number
  double chunk_particle_steps = 5e9;  ///< longer stretches are cut into chunks
                                      ///< (liggghts_inputs/decks/chunks.h; recorder only)
  ContactPath contact_path = ContactPath::recorder;
  int sample_every_steps = 1;       ///< steps between two samples of the wall contacts
  int ranks = 0;                    ///< MPI ranks; 0 takes every core
  std::string launcher = "mpirun";  ///< how ranks are started; no result depends on it
  std::optional<double> skin{};     ///< neighbour skin [m]; by default the least particle radius
  std::optional<RankSplit> rank_split{};  ///< by default `charge`
  double mesh_tolerance = 0.03;  ///< mesh against profile, share of the least particle radius
  std::uint64_t seed = 1;        ///< of the first packing
  /// The campaign, or cycle of one, whose charge the first mixing begins with in place of a
  /// packing; from the folder of the case file, and in a campaign from that of the campaign.
  std::optional<std::filesystem::path> charge_from{};
  bool keep_dumps = false;            ///< keep the contact dumps as files
  bool keep_events = false;           ///< keep a row a collision with the liner (recorder only)
  double pair_revolutions = 0.02;     ///< at the end of a measurement in which collisions between
                                      ///< particles are recorded (recorder only)
  std::optional<double> time_step{};  ///< wanted [s], in place of the share of the Rayleigh time
  std::optional<ErrorTarget> error_target{};  ///< recorder only
  bool tune = false;  ///< a campaign chooses `skin` and `rank_split` by a trial; they are not given
  bool mix_until_steady = false;  ///< mixing ends once it is steady (mill/load/steady_mixing.h;
                                  ///< recorder only), with `mix_revolutions` the most
};

/// How the gauge readings are held against the campaign. Nothing that is simulated depends on it.
struct GaugeSettings {
  std::optional<double> calibrate_until{};  ///< on the readings up to these operating hours [h]
};

/// A mill as its owner describes it, complete and checked. SI units, angles in radians.
struct Case {
  std::string name;
  std::filesystem::path file;       ///< where it was read
  double slice_length;              ///< of the periodic slice, along the axis [m]
  double speed;                     ///< [rad/s], > 0
  std::optional<double> feed_rate;  ///< [kg/s]
  LinerProfile liner;               ///< as new
  std::vector<Material> materials;
  std::vector<MaterialPair> pairs;  ///< one for each unordered pair in use
  std::size_t liner_material;
  Charge charge;
  DemSettings dem;
  WearSettings wear;
  CampaignSettings campaign;
  GaugeSettings gauge{};
};

/// The pair of two materials, in either order. Throws InputError if no pair covers them.
[[nodiscard]] const MaterialPair& pair_of(const Case& mill, std::size_t a, std::size_t b);

[[nodiscard]] ChargeTotals totals(const Case& mill);

/// Inside volume of the simulated slice with its liner as new [m3].
[[nodiscard]] double inside_volume(const Case& mill);

/// Filling that the particle counts make at rest: solid volume / (1 - porosity) / inside volume.
[[nodiscard]] double computed_filling(const Case& mill);

/// Filling that the counts make by the mill owner's reckoning: bulk volume over the volume inside
/// the plate's circle, pi R^2 L, lifters not deducted.
[[nodiscard]] double filling_inside_plate(const Case& mill);

/// Share of the speed at which the largest particle would centrifuge on the plate [-]:
///     omega_c = sqrt(g / (R - d/2)),   R the plate's radius, d the largest diameter.
[[nodiscard]] double critical_speed_fraction(const Case& mill);

/// The speed omega_c [rad/s] at which a particle of diameter `largest` [m] would centrifuge.
[[nodiscard]] double critical_speed(const LinerSector& sector, double largest);

/// What a material's modulus is divided by, for a longer time step.
[[nodiscard]] double modulus_reduction(const Case& mill, std::size_t material);

/// Shear modulus as it enters the DEM [Pa].
[[nodiscard]] double softened_shear_modulus(const Case& mill, std::size_t material);

/// How far the DEM mesh may lie from the profile [m].
[[nodiscard]] double mesh_tolerance(const Case& mill);

/// Mass of one particle of a class [kg].
[[nodiscard]] double particle_mass(const Case& mill, const ParticleClass& kind);

/// "steel of 0.03 m, ore of 0.02 m": the classes of the charge.
[[nodiscard]] std::string spoken_classes(const Case& mill);

/// Largest and smallest particle diameters of the charge [m].
[[nodiscard]] double largest_diameter(const Case& mill);
[[nodiscard]] double smallest_diameter(const Case& mill);

}  // namespace millwear
