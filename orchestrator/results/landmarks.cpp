#include "orchestrator/results/landmarks.h"

#include <array>

namespace millwear::orchestrator {
namespace {

using Row = LandmarksRow;
using Degrees = InDegrees<Row>;

constexpr std::array<CsvColumn<Row>, 7> columns{{
    {"cycle", "1", "as in `history.csv`", "", &Row::cycle},
    {"shoulder_deg", "degree",
     "where the bulk of the charge leaves the lifters: half of the share of time that is occupied "
     "in the bulk; angles as in `history.csv`",
     "", Degrees{&Row::shoulder}},
    {"bulk_toe_deg", "degree", "where it meets them again", "", Degrees{&Row::bulk_toe}},
    {"head_x_m", "m",
     "the highest place that is occupied for more than a hundredth of the time: to the right of "
     "the axis, with the rising side on the left",
     "", &Row::head_x},
    {"head_z_m", "m", "above the axis", "", &Row::head_z},
    {"centre_x_m", "m", "centre of circulation, likewise", "", &Row::centre_x},
    {"centre_z_m", "m", "", "", &Row::centre_z},
}};

}  // namespace

std::span<const CsvColumn<LandmarksRow>> landmark_columns() { return columns; }

std::string landmarks_csv(const std::vector<ChargeOfCycle>& cycles) {
  std::vector<Row> rows;
  for (const ChargeOfCycle& one : cycles) {
    const auto& marks = one.landmarks;
    rows.push_back({one.cycle, marks.shoulder, marks.bulk_toe, marks.head.x(), marks.head.y(),
                    marks.centre.x(), marks.centre.y()});
  }
  return csv_table("millwear landmarks 1", landmark_columns(), rows);
}

}  // namespace millwear::orchestrator
