// Wears a lifter by the wall contacts that any DEM program wrote as a table (see README.md):
//     postprocess contacts.csv FOLDER
#include <Eigen/Core>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <vector>

#include "meshgen/liner_mesh.h"
#include "meshgen/stl_file.h"
#include "mill/base/published_file.h"
#include "mill/base/user_table.h"
#include "mill/base/whole_file.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_csv.h"
#include "mill/liner/profile_measures.h"
#include "wear/evolve/evolution.h"
#include "wear/rate/load_rate.h"
#include "wear/record/load_accumulator.h"

using namespace millwear;

namespace {

// The mill, in m, rad and rad/s, and its charge.
constexpr LinerSector sector{.shell_radius = 0.5, .plate_radius = 0.465, .rows = 12};
constexpr ParametricLifter new_lifter{
    .height = 0.04, .top_width = 0.04, .leading_face_angle = 0.35, .trailing_face_angle = 0.35};
constexpr double slice_length = 0.12;
constexpr double mill_speed = 3.3;
const std::vector<ParticleClass> charge = {{.material = 0, .diameter = 0.03, .count = 1200}};

// Archard's law with k = 1e-12 1/Pa, on 60 bins along the profile.
const WearSettings wear_settings{.mechanisms = {{WearLaw::archard, 1e-12}}, .bins = 60};

// What was recorded: 4 s, a sample of all wall contacts every 10 ms.
const LoadMeasurement measurement{.bins = wear_settings.bins,
                                  .class_mass = {0.11},
                                  .particles = 1200,
                                  .block_count = 8,
                                  .slice_length = slice_length,
                                  .duration = 4.0,
                                  .sample_interval = 0.01,
                                  .contact_limit = 0.002};

// The load wears the liner in 5 steps, until a fifth of the lifter is gone or a limit is met.
const CampaignSettings until{
    .threshold = 0.2, .steps_per_cycle = 5, .height_limit = 0.01, .plate_limit = 0.005};

std::vector<WallContacts> read_contacts(const std::filesystem::path& file) {
  const UserTable table = user_table(read_file(file), file);
  const auto column = [&](std::string_view name) { return needed_column(table, name); };
  const auto time = column("time_s"), particle = column("particle");
  const auto x = column("x_m"), y = column("y_m"), z = column("z_m");
  const auto force = column("normal_force_n"), slip = column("slip_speed_m_per_s");

  std::vector<WallContacts> samples;
  for (const UserRow& row : table.rows) {
    const auto number = [&](std::size_t at) { return number_in(table, row, at, "such as 0.25"); };
    const double now = number(time);
    if (samples.empty() || samples.back().time != now)
      samples.push_back({.time = now, .mill_angle = mill_speed * now, .contacts = {}});
    samples.back().contacts.push_back(
        {.point = {number(x), number(y), number(z)},
         .into_wall = Eigen::Vector3d(number(x), 0.0, number(z)).normalized(),
         .normal_force = number(force),
         .slip_speed = number(slip),
         .particle = static_cast<std::size_t>(number(particle))});
  }
  return samples;
}

WallLoad load_on(const LinerProfile& liner, const std::vector<WallContacts>& samples) {
  wear::LoadAccumulator accumulator(liner, measurement);
  for (const WallContacts& sample : samples) accumulator.add(sample);
  const WallLoad load = accumulator.finish().load;
  wear::check_rejected_share(load, 0.01);
  return load;
}

void postprocess(const std::filesystem::path& contacts, const std::filesystem::path& folder) {
  const LinerProfile liner = profile_of(sector, new_lifter);
  const WallLoad load = load_on(liner, read_contacts(contacts));
  const wear::LoadRate rate = wear::rate_of_load(wear_settings, charge, liner, load);
  const std::vector<wear::TimedLoad> loads = {
      {0.0, liner, rate.smoothed.rate, rate.by_block, wear::rolling_of(rate)}};
  const auto steps = wear::evolve(loads, lifter_area(liner), until).steps;

  double hours = 0.0;
  for (const wear::GeometryStep& step : steps) {
    hours += step.duration / 3600.0;
    std::printf("%6.0f h: lifter %.1f mm high\n", hours, 1e3 * lifter_height(step.profile));
  }
  const LinerProfile& worn = steps.back().profile;
  std::filesystem::create_directories(folder);
  publish(folder / "new_profile.csv", profile_csv(liner));
  publish(folder / "worn_profile.csv", profile_csv(worn));
  write_stl(meshgen::build_liner_mesh(worn, slice_length, {.tolerance = 5e-4}),
            folder / "worn_liner.stl");
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) return std::fprintf(stderr, "usage: postprocess contacts.csv FOLDER\n"), 2;
  postprocess(argv[1], argv[2]);
} catch (const std::exception& problem) {
  return std::fprintf(stderr, "postprocess: %s\n", problem.what()), 1;
}
