#include "orchestrator/loads/impacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace millwear::orchestrator {
namespace {

using wear::ImpactSpectrum;

struct ClassPair {
  std::string first;
  std::string second;
};

void add_rows(std::vector<SpectrumRow>& rows, SpectrumRow row, const Eigen::MatrixXd& events,
              const Eigen::MatrixXd& energy, Eigen::Index group, double duration) {
  static const Eigen::VectorXd edges = wear::energy_edges();
  for (Eigen::Index i = 0; i < events.rows(); ++i) {
    if (events(i, group) == 0.0) continue;
    row.energy_low = edges[i];
    row.energy_high = edges[i + 1];
    row.events_per_second = events(i, group) / duration;
    row.power = energy(i, group) / duration;
    rows.push_back(row);
  }
}

void add_rows(std::vector<SpectrumRow>& rows, int cycle, CollisionWith contact,
              const ClassPair& classes, const ImpactSpectrum& spectrum, Eigen::Index group,
              double duration) {
  SpectrumRow row{cycle, contact, classes.first, classes.second, EnergyDirection::normal, 0.0, 0.0,
                  0.0,   0.0};
  add_rows(rows, row, spectrum.normal_events, spectrum.normal_energy, group, duration);
  row.direction = EnergyDirection::shear;
  add_rows(rows, row, spectrum.shear_events, spectrum.shear_energy, group, duration);
}

std::vector<double> rates(const Eigen::VectorXd& events, double duration) {
  const Eigen::VectorXd rate = events / duration;
  return {rate.begin(), rate.end()};
}

/// All that is in some columns of a spectrum.
ImpactLine line_of(std::string name, const ImpactSpectrum& spectrum,
                   const std::vector<Eigen::Index>& groups, double duration) {
  const auto sum = [&](const Eigen::MatrixXd& by_group) -> Eigen::VectorXd {
    return by_group(Eigen::all, groups).rowwise().sum();
  };
  const double whole = sum(spectrum.normal_events).sum();
  const double unfinished = spectrum.unfinished(groups).sum();
  return {.name = std::move(name),
          .normal = rates(sum(spectrum.normal_events), duration),
          .shear = rates(sum(spectrum.shear_events), duration),
          .events_per_second = whole / duration,
          .normal_power = sum(spectrum.normal_energy).sum() / duration,
          .shear_power = sum(spectrum.shear_energy).sum() / duration,
          .unfinished_share = whole + unfinished > 0.0 ? unfinished / (whole + unfinished) : 0.0,
          .impact_speed = std::nan("")};
}

/// Columns of the pairs of a class of one material with a class of the other.
std::vector<Eigen::Index> groups_of_materials(const std::vector<ParticleClass>& classes,
                                              std::size_t first, std::size_t second) {
  std::vector<Eigen::Index> groups;
  for (std::size_t a = 0; a < classes.size(); ++a)
    for (std::size_t b = a; b < classes.size(); ++b) {
      const auto [low, high] = std::minmax({classes[a].material, classes[b].material});
      if (low == first && high == second)
        groups.push_back(wear::pair_group(static_cast<Eigen::Index>(a),
                                          static_cast<Eigen::Index>(b), std::ssize(classes)));
    }
  return groups;
}

/// Root mean square of the speeds at which a class met the liner, from the kinetic energies [m/s].
double impact_speed(const WallLoad& load, std::size_t particle_class, double mass) {
  const auto blocks = static_cast<Eigen::Index>(load.block_count);
  const auto sum = [&](Measure measure) {
    return load.values[index_of(measure)]
        .middleCols(static_cast<Eigen::Index>(particle_class) * blocks, blocks)
        .sum();
  };
  return std::sqrt(2.0 * sum(Measure::incident_energy) / (mass * sum(Measure::events)));
}

}  // namespace

std::vector<std::string> class_names(const Case& mill) {
  std::vector<std::string> names;
  for (const auto& kind : mill.charge.classes) {
    std::string name =
        fmt::format("{}_{:.7g}mm", mill.materials[kind.material].name, 1e3 * kind.diameter);
    for (char& c : name)
      if (c == ',' || c == '"' || c == '\n' || c == '\r') c = '_';
    while (std::find(names.begin(), names.end(), name) != names.end())
      name += fmt::format("_{}", names.size());
    names.push_back(name);
  }
  return names;
}

std::vector<SpectrumRow> spectrum_rows(int cycle, const wear::LinerRecord& record,
                                       const std::vector<std::string>& names) {
  std::vector<SpectrumRow> rows;
  const auto classes = std::ssize(names);
  for (Eigen::Index a = 0; a < classes; ++a)
    add_rows(rows, cycle, CollisionWith::liner, {names[static_cast<std::size_t>(a)], ""},
             record.spectrum, a, record.load.duration);
  if (!record.pairs) return rows;
  for (Eigen::Index a = 0; a < classes; ++a)
    for (Eigen::Index b = a; b < classes; ++b)
      add_rows(rows, cycle, CollisionWith::particles,
               {names[static_cast<std::size_t>(a)], names[static_cast<std::size_t>(b)]},
               record.pairs->spectrum, wear::pair_group(a, b, classes), record.pairs->duration);
  return rows;
}

Impacts impacts_of(int cycle, const wear::LinerRecord& record, const Case& mill) {
  Impacts impacts{cycle, {}, {}};
  const auto& classes = mill.charge.classes;
  for (std::size_t c = 0; c < classes.size(); ++c) {
    auto line = line_of(fmt::format("{} {:.4g} mm", mill.materials[classes[c].material].name,
                                    1e3 * classes[c].diameter),
                        record.spectrum, {static_cast<Eigen::Index>(c)}, record.load.duration);
    line.impact_speed = impact_speed(record.load, c, particle_mass(mill, classes[c]));
    impacts.liner.push_back(std::move(line));
  }
  if (!record.pairs) return impacts;
  for (std::size_t m = 0; m < mill.materials.size(); ++m)
    for (std::size_t n = m; n < mill.materials.size(); ++n) {
      const auto groups = groups_of_materials(classes, m, n);
      if (!groups.empty())
        impacts.particles.push_back(
            line_of(fmt::format("{} on {}", mill.materials[m].name, mill.materials[n].name),
                    record.pairs->spectrum, groups, record.pairs->duration));
    }
  return impacts;
}

}  // namespace millwear::orchestrator
