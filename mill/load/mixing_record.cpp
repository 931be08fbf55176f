#include "mill/load/mixing_record.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "mill/base/failure.h"
#include "mill/base/user_table.h"
#include "mill/load/drift_text.h"

namespace millwear {
namespace {

constexpr std::string_view version_line = "# millwear mixing 2\n";
constexpr std::string_view columns =
    "step,revolutions,torque_n_m,kinetic_energy_j,torque_drift,torque_drift_limit,"
    "kinetic_energy_drift,kinetic_energy_drift_limit,class_drift,class_drift_limit,drifting_class,"
    "state";
constexpr std::size_t first_class_column = 12;

std::string_view name_of(MixingState state) {
  switch (state) {
    case MixingState::drifts:
      return "drifts";
    case MixingState::steady:
      return "steady";
    case MixingState::at_most:
      return "at_most";
  }
  throw std::logic_error("a mixing in no state");
}

/// The record as it stood after its first pieces.
MixingRecord after(const MixingRecord& record, std::size_t pieces) {
  const auto first = record.pieces.begin();
  return {record.plan, {first, first + static_cast<std::ptrdiff_t>(pieces)}};
}

std::string field(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

std::string drift_fields(const std::optional<MixingDrift>& drift) {
  if (!drift) return ",,,,,,";
  const auto& worst = drift->on_liner;
  return fmt::format("{},{},{},{},{}", field(drift->torque.relative), field(drift->torque.limit),
                     field(drift->kinetic_energy.relative), field(drift->kinetic_energy.limit),
                     worst ? fmt::format("{},{},{}", field(worst->share.relative),
                                         field(worst->share.limit), worst->particle_class + 1)
                           : ",,");
}

MixingRecord record_of(const UserTable& table, const MixingPlan& plan) {
  constexpr std::size_t torque = 2;
  constexpr std::size_t energy = 3;
  MixingRecord record{plan, {}};
  for (const auto& row : table.rows) {
    MixedPiece piece{number_in(table, row, torque, "newton metres"),
                     number_in(table, row, energy, "joules")};
    for (std::size_t column = first_class_column; column < row.fields.size(); ++column)
      piece.on_liner.push_back(number_in(table, row, column, "a number of particles"));
    record.pieces.push_back(std::move(piece));
  }
  return record;
}

}  // namespace

std::string mixing_csv(const MixingRecord& record) {
  std::string text = std::string(version_line) + std::string(columns);
  const std::size_t classes = record.pieces.empty() ? 0 : record.pieces.front().on_liner.size();
  for (std::size_t kind = 1; kind <= classes; ++kind)
    fmt::format_to(std::back_inserter(text), ",on_liner_{}", kind);
  text += "\n";
  for (std::size_t i = 0; i < record.pieces.size(); ++i) {
    const MixingRecord so_far = after(record, i + 1);
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}", so_far.steps(),
                   so_far.revolutions(), record.pieces[i].torque, record.pieces[i].kinetic_energy,
                   drift_fields(mixing_drift(record.plan, so_far.pieces)),
                   name_of(mixing_state(record.plan, so_far.pieces)));
    for (const double touching : record.pieces[i].on_liner)
      fmt::format_to(std::back_inserter(text), ",{}", touching);
    text += "\n";
  }
  return text;
}

MixingRecord mixing_from_csv(std::string_view text, const std::filesystem::path& file,
                             const MixingPlan& plan) {
  if (!text.starts_with(std::string(version_line) + std::string(columns)))
    throw ResultRejected(
        fmt::format("{}:1: it is not a `millwear mixing` of version 2", file.string()));
  MixingRecord record{};
  try {
    record = record_of(user_table(text, file), plan);
  } catch (const InputError& problem) {
    throw ResultRejected(problem.what());
  }
  if (mixing_state(plan, record.pieces) == MixingState::drifts)
    throw ResultRejected(fmt::format("{}:{}: it ends at step {}, where the mixing had to go on",
                                     file.string(), record.pieces.size() + 2, record.steps()));
  if (mixing_csv(record) != text)
    throw ResultRejected(fmt::format(
        "{}: it is not what a mixing in pieces of {} steps with at most {} leaves; is it torn?",
        file.string(), plan.piece, plan.most));
  return record;
}

std::string spoken_mixing(const MixingRecord& record) {
  const bool steady = mixing_state(record.plan, record.pieces) == MixingState::steady;
  return fmt::format("mixed for {:.3g} revolutions{}: {}", record.revolutions(),
                     steady ? "" : ", the most, and not steady",
                     spoken_drift(mixing_drift(record.plan, record.pieces)));
}

}  // namespace millwear
