#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <random>

#include "liggghts_inputs/outputs/contact_join.h"
#include "mill/liner/mill_frame.h"
#include "mill/liner/parametric_lifter.h"

namespace millwear::liggghts {
namespace {

constexpr std::size_t contact_rows = 2500;  ///< a sample of the 8 m mill, 0.25 m slice
constexpr std::size_t spin_rows = 5000;
constexpr std::size_t particles = 26765;
constexpr double radius = 0.016;

Case seed_like_mill() {
  Case mill{};
  mill.slice_length = 0.25;
  mill.speed = 1.19;
  mill.liner = profile_of({4.0, 3.9005, 52}, {0.215, 0.10, 0.2, 0.1});
  mill.materials = {{"rock", 2700.0, 7.55e9, 0.2}};
  mill.charge.classes = {{0, 2.0 * radius, particles}};
  return mill;
}

std::string header(long step, std::size_t rows, const char* what) {
  return fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF {}\n{}\nITEM: BOX BOUNDS ff pp ff\n-4.08 4.08\n0 0.25\n"
      "-4.08 4.08\nITEM: {} c_hits[1] c_hits[2] c_hits[3]\n",
      step, what, rows, what);
}

/// Dumps of one sample, with the digits that templates/measure.in asks for.
struct Sample {
  std::string contacts, spins;
};

/// Feeds a sample that was made for step 20 as that of another step.
void feed_at(SnapshotReader& reader, const std::string& sample, long step) {
  const std::size_t made_for = sample.find("20");
  reader.feed(std::string_view(sample).substr(0, made_for));
  reader.feed(fmt::format("{}", step));
  reader.feed(std::string_view(sample).substr(made_for + 2));
}

Sample sample_text(long step) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Sample text{header(step, contact_rows, "ENTRIES"), header(step, spin_rows, "ATOMS")};
  for (std::size_t i = 0; i < spin_rows; ++i) {
    const double x = 3.0 * unit(random);
    const double y = 0.125 + 0.12 * unit(random);
    text.spins += fmt::format("{} 1 {:.9g} {:.9g} {:.9g} {:.9g}", i + 1, radius, x, y, -2.4);
    for (int k = 0; k < 6; ++k) text.spins += fmt::format(" {:.9g}", 3.0 * unit(random));
    text.spins += " \n";
    if (i % 2 == 0)
      text.contacts +=
          fmt::format("{:.9g} {:.9g} {:.9g} {} {} {:.7g} {:.7g} {:.7g} {:.7g} {:.7g} 0 \n", x, y,
                      -2.4 - radius, i % 728, i + 1, 5.0 * unit(random), 5.0 * unit(random),
                      90.0 + unit(random), 40.0 * unit(random), 40.0 * unit(random));
  }
  return text;
}

void read_contacts(benchmark::State& state) {
  const Sample sample = sample_text(20);
  double sum = 0.0;
  SnapshotReader reader("contacts", contact_columns,
                        [&](const Snapshot& snapshot) { sum += snapshot.values.back(); });
  long step = 0;
  for (auto _ : state) feed_at(reader, sample.contacts, step += 20);
  benchmark::DoNotOptimize(sum);
  state.SetItemsProcessed(state.iterations() * static_cast<long>(contact_rows));
  state.SetBytesProcessed(state.iterations() * static_cast<long>(sample.contacts.size()));
}
BENCHMARK(read_contacts)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// Both dumps and the join; items are contacts.
void read_and_join(benchmark::State& state) {
  const Sample sample = sample_text(20);
  double work = 0.0;
  ContactJoin join(seed_like_mill(), {1e-4, 0, 20, 20}, [&](const WallContacts& joined) {
    for (const auto& contact : joined.contacts) work += contact.normal_force * contact.slip_speed;
  });
  SnapshotReader contacts("contacts", contact_columns,
                          [&](const Snapshot& snapshot) { join.take_contacts(snapshot); });
  SnapshotReader spins("spins", spin_columns,
                       [&](const Snapshot& snapshot) { join.take_spins(snapshot); });
  long step = 0;
  for (auto _ : state) {
    feed_at(contacts, sample.contacts, step += 20);
    feed_at(spins, sample.spins, step);
  }
  benchmark::DoNotOptimize(work);
  state.SetItemsProcessed(state.iterations() * static_cast<long>(contact_rows));
}
BENCHMARK(read_and_join)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace
}  // namespace millwear::liggghts

BENCHMARK_MAIN();
