#include "orchestrator/export/paraview_folder.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "orchestrator/export/charge_particles.h"
#include "orchestrator/export/liner_values.h"
#include "orchestrator/vtk/pvd_file.h"
#include "orchestrator/vtk/vtp_file.h"
#include "wear/record/profile_index.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr const char* liner_folder = "liner";
constexpr const char* charge_folder = "charge";

VtkArray number(const char* name, double value) { return {name, 1, std::vector<double>{value}}; }
VtkArray number(const char* name, int value) { return {name, 1, std::vector<std::int32_t>{value}}; }

/// One cycle of the campaign, with what is here of its measurement.
struct CycleView {
  int cycle;
  CycleStart start;
  std::optional<LoadOnLiner> load;
};

/// Removes the series of an earlier export: they name files that may be another campaign's.
void remove_series(const fs::path& folder) {
  std::vector<fs::path> series;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().stem().string();
    const std::string kind = name.substr(0, name.find("_cycle_"));
    if (entry.path().extension() == ".pvd" && (kind == liner_folder || kind == charge_folder))
      series.push_back(entry.path());
  }
  for (const auto& file : series) fs::remove(file);
}

class ParaviewFolder {
 public:
  ParaviewFolder(const PublishedCampaign& published, LinerExtent extent, const fs::path& folder)
      : published_(published),
        mill_(published.campaign.mill),
        extent_(extent),
        folder_(folder),
        fresh_(mill_.liner, mill_.liner.sector.plate_radius * fresh_reach) {}

  ParaviewExport write() {
    make_folder(folder_ / liner_folder);
    remove_series(folder_);
    for (int cycle = 0; cycle < cycles_begun(published_); ++cycle) write_cycle(cycle);
    put_series("liner.pvd", liner_);
    if (!charge_.empty()) put_series("charge.pvd", charge_);
    return std::move(written_);
  }

 private:
  using Series = std::vector<PvdEntry>;
  static constexpr double fresh_reach = 0.1;  ///< share of the radius that the quick search covers

  void write_cycle(int cycle) {
    const CycleView view = view_of(cycle);
    const auto frames = frames_of(published_, cycle);
    const bool has_frames = frames && frames->frames() > 0;
    const bool has_steps = cycle <= published_.profiles.back().cycle;
    if (has_steps && !view.load) written_.cycles_without_load.push_back(cycle);
    if (has_steps && !has_frames) written_.cycles_without_charge.push_back(cycle);
    if (has_frames) write_frames(view, *frames);
    // Lifters stand between the particles of `charge.pvd`, and lifter 0 at six o'clock.
    const double mill_angle =
        has_frames ? std::remainder(angle_of_frame(view, *frames, 0), mill_.liner.sector.pitch())
                   : 0.0;
    for (const auto& row : published_.profiles)
      if (row.cycle == cycle) write_step(view, row, mill_angle);
  }

  /// By which the steel has turned along xi.
  static double angle_of_frame(const CycleView& view, const wear::ChargeFrames& frames,
                               std::size_t frame) {
    return (view.start.rotation == Rotation::as_new ? 1.0 : -1.0) * frames.mill_angles[frame];
  }

  [[nodiscard]] CycleView view_of(int cycle) const {
    CycleView view{cycle, start_of(published_, cycle), std::nullopt};
    if (auto load = load_of(published_, cycle))
      view.load = LoadOnLiner{view.start.liner, view.start.rotation, std::move(*load)};
    return view;
  }

  /// The liner in a cycle, `liner` being what it began with or worn from that.
  [[nodiscard]] VtkPolyData surface(const CycleView& view, const LinerProfile& liner,
                                    double mill_angle) const {
    const LinerProfile outline = cut_at_bins(liner, mill_.wear.bins);
    std::vector<VtkArray> values{wear_depth(outline, fresh_)};
    if (view.load)
      for (auto& array : load_values(*view.load, liner)) values.push_back(std::move(array));
    return liner_surface(outline, values, {extent_, mill_.slice_length, mill_angle});
  }

  void write_step(const CycleView& view, const ProfileRow& row, double mill_angle) {
    VtkPolyData data = surface(view, {mill_.liner.sector, row.nodes}, mill_angle);
    data.field_data = {number("cycle", row.cycle), number("step", row.step),
                       number("operating_hours", row.operating_hours)};
    put(data, row.operating_hours,
        fmt::format("{}/cycle_{:03}_step_{:03}.vtp", liner_folder, row.cycle, row.step), liner_);
  }

  void write_frames(const CycleView& view, const wear::ChargeFrames& frames) {
    make_folder(folder_ / charge_folder);
    const double hours = view.start.operating_hours;
    Series liner;
    Series charge;
    for (std::size_t frame = 0; frame < frames.frames(); ++frame) {
      const double time = frames.times[frame];
      const std::string name = fmt::format("cycle_{:03}_frame_{:02}.vtp", view.cycle, frame);
      const std::vector<VtkArray> moment{number("cycle", view.cycle),
                                         number("operating_hours", hours), number("time_s", time)};
      VtkPolyData turned = surface(view, view.start.liner, angle_of_frame(view, frames, frame));
      turned.field_data = moment;
      put(turned, time, fmt::format("{}/{}", liner_folder, name), liner);
      VtkPolyData particles = charge_particles(frames, frame, view.start.rotation);
      particles.field_data = moment;
      put(particles, time, fmt::format("{}/{}", charge_folder, name), charge);
    }
    put_series(fmt::format("liner_cycle_{:03}.pvd", view.cycle), liner);
    put_series(fmt::format("charge_cycle_{:03}.pvd", view.cycle), charge);
    charge_.push_back({hours, charge.front().file});
  }

  void put(const VtkPolyData& data, double time, const std::string& name, Series& series) const {
    publish(folder_ / name, vtp_file(data));
    series.push_back({time, name});
  }

  void put_series(const std::string& name, const Series& series) {
    publish(folder_ / name, pvd_file(series));
    written_.series.push_back({name, series.size()});
  }

  const PublishedCampaign& published_;
  const Case& mill_;
  LinerExtent extent_;
  fs::path folder_;
  wear::ProfileIndex fresh_;
  Series liner_{};
  Series charge_{};
  ParaviewExport written_{};
};

}  // namespace

ParaviewExport export_to_paraview(const PublishedCampaign& published, LinerExtent extent,
                                  const fs::path& folder) {
  return ParaviewFolder(published, extent, folder).write();
}

}  // namespace millwear::orchestrator
