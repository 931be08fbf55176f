#include "mill/load/steady_mixing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace millwear {
namespace {

constexpr int pieces_of_revolution = 32;  // at most, with rows enough
constexpr int least_left_out = 4;         // as a part of a revolution
constexpr double steady_drift = 0.05;
constexpr double most_noise = 0.15;
constexpr double clearly = 2.0;
constexpr double clearly_of_many = 2.5;  // one of several classes passes two errors by chance
constexpr long parts_of_history = 4;
constexpr double stay_on_liner = 0.25;  // revolutions

constexpr std::size_t half = pieces_of_window / 2;
constexpr std::size_t looked_at = 2 * pieces_of_window;

long divided_up(long number, long by) { return (number + by - 1) / by; }

double sum(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double mean(std::span<const double> values) {
  return sum(values) / static_cast<double>(values.size());
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

/// Particles of each class on the liner, mean of some pieces.
std::vector<double> mean_on_liner(std::span<const MixedPiece> pieces) {
  std::vector<double> mean(pieces.front().on_liner.size(), 0.0);
  for (const auto& piece : pieces)
    for (std::size_t kind = 0; kind < mean.size(); ++kind)
      mean[kind] += piece.on_liner[kind] / static_cast<double>(pieces.size());
  return mean;
}

/// `populations`: how often all particles on the liner have changed within a window.
Drift drift_of_share(double before, double all_before, double now, double all_now,
                     double populations) {
  const double share = 0.5 * (before / all_before + now / all_now);
  const double variance = (1.0 - share) / share * (1.0 / all_before + 1.0 / all_now) / populations;
  return {std::abs(now / all_now - before / all_before) / share,
          std::max(steady_drift, clearly_of_many * std::sqrt(variance))};
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

std::optional<ClassDrift> class_drift(const MixingPlan& plan, std::span<const MixedPiece> pieces) {
  const auto history = static_cast<long>(pieces.size()) - plan.left_out / plan.piece;
  const long window = std::max<long>(pieces_of_window, history / parts_of_history);
  if (history < 2 * window || pieces.back().on_liner.size() < 2) return std::nullopt;
  const auto length = static_cast<std::size_t>(window);
  const auto before = mean_on_liner(pieces.last(2 * length).first(length));
  const auto now = mean_on_liner(pieces.last(length));
  const double turned =
      static_cast<double>(window * plan.piece) / static_cast<double>(plan.revolution);
  std::optional<ClassDrift> worst;
  for (std::size_t kind = 0; kind < now.size(); ++kind) {
    if (before[kind] + now[kind] == 0.0) continue;
    const Drift drift = drift_of_share(before[kind], sum(before), now[kind], sum(now),
                                       std::max(1.0, turned / stay_on_liner));
    if (!worst || drift.relative / drift.limit > worst->share.relative / worst->share.limit)
      worst = ClassDrift{kind, drift};
  }
  return worst;
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
  return MixingDrift{drift_of(torques), drift_of(energies), class_drift(plan, pieces)};
}

MixingState mixing_state(const MixingPlan& plan, std::span<const MixedPiece> pieces) {
  const auto drift = mixing_drift(plan, pieces);
  if (drift && is_steady(drift->torque) && is_steady(drift->kinetic_energy) &&
      (!drift->on_liner || is_steady(drift->on_liner->share)))
    return MixingState::steady;
  const bool is_the_last = static_cast<long>(pieces.size()) * plan.piece >= plan.most;
  return is_the_last ? MixingState::at_most : MixingState::drifts;
}

}  // namespace millwear
