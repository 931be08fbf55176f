#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "mill/liner/mill_frame.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_measures.h"
#include "wear/evolve/profile_motion.h"
#include "wear/rate/smoothing_error.h"
#include "wear/record/load_accumulator.h"

namespace millwear::wear {
namespace {

LinerProfile seed_lifter() { return profile_of({4.0, 3.9005, 52}, {0.215, 0.10, 0.2, 0.1}); }

void accumulate_contacts(benchmark::State& state) {
  const LinerProfile profile = seed_lifter();
  const double tolerance = 2e-3;
  const std::size_t contacts = 40000;
  LoadAccumulator accumulator(profile, {.bins = 200,
                                        .class_mass = std::vector<double>(9, 1.0),
                                        .particles = contacts,
                                        .triangles = 0,
                                        .block_count = 20,
                                        .slice_length = 0.25,
                                        .duration = 1.0,
                                        .sample_interval = 1e-3,
                                        .contact_limit = tolerance,
                                        .excess_speed = 0.1});
  std::mt19937 random(1);
  std::uniform_int_distribution<std::size_t> node(0, profile.nodes.size() - 2);
  std::uniform_int_distribution<int> row(0, 51);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  WallContacts sample{0.5, 0.3, {}};
  for (std::size_t i = 0; i < contacts; ++i) {
    const auto n = node(random);
    const Eigen::Vector2d place =
        profile.nodes[n] + share(random) * (profile.nodes[n + 1] - profile.nodes[n]);
    const auto xz = to_mill(profile.sector, place, row(random), sample.mill_angle);
    sample.contacts.push_back({.point = {xz.x(), 0.1, xz.y()},
                               .into_wall = Eigen::Vector3d(xz.x(), 0.0, xz.y()).normalized(),
                               .normal_force = 10.0,
                               .slip_speed = 0.1,
                               .normal_speed = 0.0,
                               .impact_speed = 0.1,
                               .impact_normal_speed = 0.0,
                               .shear_power = 0.3,
                               .finnie_power = 0.2,
                               .particle_class = i % 9,
                               .particle = i + 1,
                               .triangle = 0});
  }
  for (auto _ : state) accumulator.add(sample);
  state.SetItemsProcessed(state.iterations() * static_cast<long>(sample.contacts.size()));
}
BENCHMARK(accumulate_contacts)->Unit(benchmark::kMillisecond);

void move_one_step(benchmark::State& state) {
  LinerProfile profile = seed_lifter();
  const auto length = arc_lengths(profile).back();
  const double bin = length / 200.0;
  const auto depth = [&](double s) { return 1.0 + 0.5 * std::sin(40.0 * s / length); };
  const double area = 0.005 * lifter_area(profile);
  for (int i = 0; i < 10; ++i) {
    profile = move_profile(profile, loss_nodes(profile, bin, depth), area, bin).profile;
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(move_profile(profile, loss_nodes(profile, bin, depth), area, bin));
  }
  state.counters["nodes"] = static_cast<double>(profile.nodes.size());
}
BENCHMARK(move_one_step)->Unit(benchmark::kMillisecond);

/// Rates of 200 bins in 50 time blocks, of a sharp load and a noise of a half for every block.
Eigen::MatrixXd noisy_rates() {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(1.0, 0.5);
  return Eigen::MatrixXd::NullaryExpr(200, 50, [&](auto bin, auto) {
    return std::fmax(
        noise(random) *
            (1.0 + 3.0 * std::exp(-0.001 * std::pow(static_cast<double>(bin) - 80.0, 2))),
        0.0);
  });
}

Eigen::VectorXd edges_on(const LinerProfile& profile) {
  return Eigen::VectorXd::LinSpaced(201, 0.0, arc_lengths(profile).back());
}

void smooth_with_errors(benchmark::State& state) {
  const Eigen::VectorXd edges = edges_on(seed_lifter());
  const Eigen::MatrixXd by_block = noisy_rates();
  const Eigen::VectorXd rate = by_block.rowwise().mean();
  const Smoothing how{static_cast<SmoothingMethod>(state.range(0)), 0.0};
  for (auto _ : state)
    benchmark::DoNotOptimize(standard_error(smoothed(edges, rate, by_block, how)));
}
BENCHMARK(smooth_with_errors)
    ->Arg(static_cast<int>(SmoothingMethod::penalised))
    ->Arg(static_cast<int>(SmoothingMethod::paper))
    ->Unit(benchmark::kMillisecond);

void make_replicates(benchmark::State& state) {
  const Eigen::MatrixXd by_block = noisy_rates();
  const auto loss = smoothed(edges_on(seed_lifter()), by_block.rowwise().mean(), by_block);
  for (auto _ : state) benchmark::DoNotOptimize(rate_replicates(loss, 200, 1, ReplicateOf::noise));
}
BENCHMARK(make_replicates)->Unit(benchmark::kMillisecond);

/// All of one step of the geometry: the load smoothed with its errors, and the profile moved.
void geometry_step(benchmark::State& state) {
  const LinerProfile profile = seed_lifter();
  const Eigen::VectorXd edges = edges_on(profile);
  const Eigen::MatrixXd by_block = noisy_rates();
  const Eigen::VectorXd rate = by_block.rowwise().mean();
  const double area = 0.005 * lifter_area(profile);
  for (auto _ : state) {
    const auto loss = smoothed(edges, rate, by_block);
    benchmark::DoNotOptimize(standard_error(loss));
    const double bin = loss.rate.bin_width();
    const auto nodes = loss_nodes(profile, bin, [&](double s) { return loss.rate.at(s); });
    benchmark::DoNotOptimize(move_profile(profile, nodes, area, bin));
  }
}
BENCHMARK(geometry_step)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace millwear::wear

BENCHMARK_MAIN();
