#include "recorder/run/steady_mixing_run.h"

#include <fmt/format.h>
#include <liggghts/comm.h>
#include <liggghts/fix.h>
#include <liggghts/input.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/update.h>
#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/load/mixing_record.h"
#include "mill/recording/recorder_lines.h"
#include "recorder/balance/balanced_columns.h"
#include "recorder/record/liner_census.h"
#include "recorder/run/deck_lines.h"
#include "recorder/run/deck_run.h"

namespace millwear::recorder {
namespace {

using LAMMPS_NS::LAMMPS;

constexpr long censuses_a_piece = 8;

/// The deck's averages over a piece: torque, then kinetic energy.
LAMMPS_NS::Fix& averages_of(LAMMPS& liggghts, const MixingOptions& options) {
  auto* const fix = liggghts.modify->find_fix_id_style("drift", "ave/time");
  if (fix == nullptr || fix->size_vector != 2 || fix->global_freq != options.plan.piece)
    throw InputError(fmt::format(
        "{}: no `fix drift all ave/time 1 {} {} v_torque c_kinetic` stands before its `run`",
        options.deck.string(), options.plan.piece, options.plan.piece));
  return *fix;
}

void check_run(const LAMMPS& liggghts, const MixingOptions& options, const std::string& line) {
  if (argument_of(line) != std::to_string(options.plan.most) || liggghts.update->ntimestep != 0)
    throw InputError(
        fmt::format("{}: `{}`: the one `run` of a mixing deck is of --at-most {} "
                    "steps, from step 0",
                    options.deck.string(), line, options.plan.most));
}

/// The state after one piece more, the same on every rank.
MixingState take_piece(LAMMPS& liggghts, LAMMPS_NS::Fix& averages, LinerCensus& census,
                       MixingRecord& record) {
  record.pieces.push_back(
      {averages.compute_vector(0), averages.compute_vector(1), census.take_means()});
  auto state = mixing_state(record.plan, record.pieces);
  MPI_Bcast(&state, sizeof state, MPI_BYTE, 0, liggghts.world);
  if (liggghts.comm->me == 0) {
    fmt::print("{}\n",
               printed(MixingLine{record.steps(), mixing_drift(record.plan, record.pieces)}));
    std::fflush(stdout);
  }
  return state;
}

void run_until_steady(LAMMPS& liggghts, const MixingOptions& options, LinerCensus& census,
                      MixingRecord& record) {
  auto& averages = averages_of(liggghts, options);
  const auto run_piece = [&](const char* how) {
    liggghts.input->one(fmt::format("run {}{}", record.plan.piece, how).c_str());
    const long step = liggghts.update->ntimestep;
    if (step != record.steps() + record.plan.piece)
      throw ResultRejected(fmt::format("the mixing was stopped at step {}", step));
  };
  run_piece("");
  while (take_piece(liggghts, averages, census, record) == MixingState::drifts)
    run_piece(" pre no post no");
}

}  // namespace

void mix_until_steady(LAMMPS& liggghts, const MixingOptions& options) {
  MixingRecord record{options.plan, {}};
  std::optional<LinerCensus> census;  // LIGGGHTS knows it until the deck has come to its end
  run_deck(liggghts, options.deck, [&](const std::string& line) {
    check_run(liggghts, options, line);
    balance_columns(liggghts, options.columns);
    census.emplace(liggghts, std::max(1L, record.plan.piece / censuses_a_piece));
    run_until_steady(liggghts, options, *census, record);
  });
  if (record.pieces.empty()) throw InputError(options.deck.string() + ": the deck has no `run`");
  if (liggghts.comm->me == 0) publish(options.record, mixing_csv(record));
}

}  // namespace millwear::recorder
