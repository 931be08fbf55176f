#include "mill/load/steady_mixing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace millwear {
namespace {

constexpr int pieces_of_revolution = 32;  // at most, with rows enough
constexpr int least_left_out = 4;         // as a part of a revolution
constexpr double steady_drift = 0.05;
constexpr double most_noise = 0.15;
constexpr double clearly = 2.0;

constexpr std::size_t half = pieces_of_window / 2;
constexpr std::size_t looked_at = 2 * pieces_of_window;

long divided_up(long number, long by) { return (number + by - 1) / by; }

double mean(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double largest_contrast(const std::array<double, 4>& h) {
  return 0.5 * std::max({std::abs(h[2] + h[3] - h[0] - h[1]), std::abs(h[0] + h[3] - h[1] - h[2]),
                         std::abs(h[0] + h[2] - h[1] - h[3])});
}

/// Variance of a piece from neighbours, which a drift over many pieces hardly reaches.
double variance_of_piece(std::span<const double> pieces) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < pieces.size(); i += 2)
    sum += 0.5 * (pieces[i] - pieces[i + 1]) * (pieces[i] - pieces[i + 1]);
  return sum / (0.5 * static_cast<double>(pieces.size()));
}

}  // namespace

MixingPlan mixing_plan(const Case& mill, const StepPlan& plan) {
  const long rows = mill.liner.sector.rows;
  const long pitches = divided_up(rows, pieces_of_revolution);
  const long piece = pitches * plan.steps_per_pitch;
  const auto wanted =
      static_cast<long>(std::ceil(mill.dem.mix_revolutions * static_cast<double>(rows) - 1e-9));
  return {.piece = piece,
          .left_out = divided_up(rows, least_left_out * pitches) * piece,
          .most = divided_up(wanted, pitches) * piece,
          .revolution = plan.steps_per_revolution(static_cast<int>(rows))};
}

long least_steps(const MixingPlan& plan) {
  return plan.left_out + static_cast<long>(looked_at) * plan.piece;
}

bool is_steady(const Drift& drift) { return drift.relative <= drift.limit; }

Drift drift_of(std::span<const double> series) {
  if (series.size() < looked_at) throw std::invalid_argument("too few pieces for a drift");
  const auto pieces = series.last(looked_at);
  std::array<double, 4> halves{};
  for (std::size_t i = 0; i < halves.size(); ++i) halves[i] = mean(pieces.subspan(i * half, half));
  const double scale = std::abs(mean(pieces));
  const double error = std::sqrt(variance_of_piece(pieces) * 2.0 / pieces_of_window);
  return {largest_contrast(halves) / scale,
          std::clamp(clearly * error / scale, steady_drift, most_noise)};
}

std::optional<MixingDrift> mixing_drift(const MixingPlan& plan,
                                        std::span<const MixedPiece> pieces) {
  if (static_cast<long>(pieces.size()) * plan.piece < least_steps(plan)) return std::nullopt;
  std::vector<double> torques;
  std::vector<double> energies;
  for (const auto& piece : pieces) {
    torques.push_back(piece.torque);
    energies.push_back(piece.kinetic_energy);
  }
  return MixingDrift{drift_of(torques), drift_of(energies)};
}

MixingState mixing_state(const MixingPlan& plan, std::span<const MixedPiece> pieces) {
  const auto drift = mixing_drift(plan, pieces);
  if (drift && is_steady(drift->torque) && is_steady(drift->kinetic_energy))
    return MixingState::steady;
  const bool is_the_last = static_cast<long>(pieces.size()) * plan.piece >= plan.most;
  return is_the_last ? MixingState::at_most : MixingState::drifts;
}

}  // namespace millwear
