#include "orchestrator/postprocess/dump_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mill/base/failure.h"
#include "orchestrator/postprocess/dump_source.h"

namespace millwear::orchestrator {
namespace {

using liggghts::Snapshot;

/// Columns of the joined rows, see `choose_contact_columns` and `choose_spin_columns`.
constexpr std::size_t triangle_column = 3;
constexpr std::size_t contact_particle_column = 4;
constexpr std::size_t particle_column = 0;
constexpr std::size_t type_column = 1;
/// More particles than any run has; a column that is no particle number often has larger ones.
constexpr double most_particles = 1e8;

[[noreturn]] void refuse(const std::filesystem::path& file, long step, const std::string& why) {
  throw ResultRejected(fmt::format("{}: step {}: {}", file.string(), step, why));
}

void check_whole(double value, double least, double most, std::string_view what,
                 const std::filesystem::path& file, long step) {
  if (value == std::floor(value) && value >= least && value <= most) return;
  refuse(file, step, fmt::format("{} cannot be {} of {}", value, what, file.string()));
}

bool is_measured(const HandRun& run, long step) {
  return step >= run.after.value_or(step) && step <= run.until.value_or(step);
}

void check_same_steps(const HandRun& run, const std::vector<long>& contacts,
                      const std::vector<long>& particles) {
  const auto [a, b] = std::ranges::mismatch(contacts, particles);
  if (a == contacts.end() && b == particles.end()) return;
  const auto spoken = [](auto at, const std::vector<long>& steps) {
    return at == steps.end() ? std::string("ends") : fmt::format("has step {}", *at);
  };
  throw ResultRejected(fmt::format(
      "{} {} where {} {}; give two dumps of one run with the same steps", run.contacts.string(),
      spoken(a, contacts), run.particles.string(), spoken(b, particles)));
}

long usual_interval(const std::vector<long>& steps) {
  std::vector<long> intervals;
  for (std::size_t i = 1; i < steps.size(); ++i) intervals.push_back(steps[i] - steps[i - 1]);
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::ranges::nth_element(intervals, middle);
  return *middle;
}

void check_no_gap(const HandRun& run, const DumpOutline& outline) {
  for (std::size_t i = 1; i < outline.steps.size(); ++i)
    if (outline.steps[i] - outline.steps[i - 1] > outline.sample_steps)
      refuse(run.contacts, outline.steps[i],
             fmt::format("the snapshot before is that of step {}, though the others lie {} steps "
                         "apart; snapshots are missing",
                         outline.steps[i - 1], outline.sample_steps));
}

}  // namespace

DumpOutline outline_of(const HandRun& run, std::size_t triangles) {
  DumpOutline outline;
  std::vector<long> particle_steps;
  const auto take_contacts = [&](const Snapshot& snapshot) {
    if (!is_measured(run, snapshot.step)) return;
    if (!outline.steps.empty()) outline.contacts += snapshot.rows();
    outline.steps.push_back(snapshot.step);
    for (std::size_t i = 0; i < snapshot.rows(); ++i) {
      const auto row = snapshot.row(i);
      check_whole(row[contact_particle_column], 1.0, most_particles,
                  "the particle number of a contact", run.contacts, snapshot.step);
      check_whole(row[triangle_column], 0.0, most_particles, "the triangle of a contact",
                  run.contacts, snapshot.step);
      if (row[triangle_column] >= static_cast<double>(triangles))
        refuse(
            run.contacts, snapshot.step,
            fmt::format("a contact on triangle {}, and the liner's mesh has {} (from 0 on); give "
                        "the mesh that the deck reads with --mesh",
                        row[triangle_column], triangles));
    }
  };
  const auto take_particles = [&](const Snapshot& snapshot) {
    if (!is_measured(run, snapshot.step)) return;
    particle_steps.push_back(snapshot.step);
    for (std::size_t i = 0; i < snapshot.rows(); ++i) {
      const auto row = snapshot.row(i);
      check_whole(row[particle_column], 1.0, most_particles, "the id of a particle", run.particles,
                  snapshot.step);
      check_whole(row[type_column], 1.0, most_particles, "the type of a particle", run.particles,
                  snapshot.step);
      outline.largest_particle =
          std::max(outline.largest_particle, static_cast<std::size_t>(row[particle_column]));
    }
  };
  DumpSource contacts(run.contacts, liggghts::choose_contact_columns(run.contact_keywords),
                      take_contacts);
  DumpSource particles(run.particles, liggghts::choose_spin_columns(), take_particles);
  read_side_by_side(contacts, particles);
  check_same_steps(run, outline.steps, particle_steps);
  if (outline.steps.size() < 2)
    throw ResultRejected(fmt::format(
        "{}: {} in the measurement; it takes two at least, one to begin with and one that stands "
        "for the time since",
        run.contacts.string(), outline.steps.empty() ? "no snapshot lies" : "one snapshot lies"));
  if (outline.contacts == 0)
    throw ResultRejected(
        fmt::format("{}: nothing touches the wall in {} snapshots; was the compute defined on the "
                    "liner's wall?",
                    run.contacts.string(), outline.steps.size()));
  outline.sample_steps = usual_interval(outline.steps);
  check_no_gap(run, outline);
  return outline;
}

}  // namespace millwear::orchestrator
