#include "liggghts_inputs/outputs/stretch_log.h"

#include <fmt/format.h>

#include <cmath>

#include "liggghts_inputs/outputs/run_log.h"
#include "mill/base/failure.h"

namespace millwear::liggghts {

void check_stretch_log(std::string_view log, const std::string& log_name,
                       const StretchExpectation& expected) {
  const RunLog run = read_run_log(log);
  const auto reject = [&](const std::string& why) { throw ResultRejected(log_name + ": " + why); };
  if (!run.error.empty()) reject("LIGGGHTS stopped: " + run.error);
  if (!run.complete)
    reject(
        fmt::format("LIGGGHTS stopped half way, its last step was {} of {}; see this log for why",
                    run.thermo.empty() ? 0 : run.thermo.back().step, expected.last_step));
  if (run.triangles != expected.triangles)
    reject(fmt::format("LIGGGHTS read {} of the mesh's {} triangles", run.triangles,
                       expected.triangles));
  for (const auto& line : run.thermo) {
    if (line.atoms != expected.particles)
      reject(fmt::format("{} of {} particles are left at step {}; particles were lost", line.atoms,
                         expected.particles, line.step));
    if (!std::isfinite(line.kinetic_energy) || !std::isfinite(line.spin_energy) ||
        !std::isfinite(line.torque))
      reject(fmt::format("energy or torque is not finite at step {}", line.step));
  }
  if (run.thermo.empty() || run.thermo.back().step != expected.last_step)
    reject(fmt::format("the run ended at step {} and not at {}",
                       run.thermo.empty() ? 0 : run.thermo.back().step, expected.last_step));
}

}  // namespace millwear::liggghts
