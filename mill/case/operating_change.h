#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "mill/liner/rotation.h"

namespace millwear {

/// A change of how a mill is operated, at a time of milling or at a height of the worn lifter. What
/// it does not give stays as it was.
struct OperatingChange {
  std::optional<double> from_time{};    ///< of milling since the liner was new [s]; or
  std::optional<double> from_height{};  ///< once the lifter is worn to this height [m]
  std::optional<double> speed{};        ///< [rad/s]
  std::vector<std::size_t> counts{};    ///< particles of each class of the charge, in its order;
                                        ///< empty where the charge stays
  std::optional<double> feed_rate{};    ///< [kg/s]
  std::optional<Rotation> rotation{};
  double idle_time = 0.0;  ///< that the mill stands still before it goes on [s]
};

/// Where a liner stands in its life: milling time since it was new [s], lifter height [m].
struct LinerMoment {
  double time;
  double height;
};

/// Numbers of the changes that have begun by a moment, in the order of `changes`. Later ones in
/// this order count over earlier ones. A time less than a second ahead and a height less than two
/// micrometres below count, so that a geometry step need not meet them to the last bit.
[[nodiscard]] std::vector<std::size_t> changes_begun(std::span<const OperatingChange> changes,
                                                     const LinerMoment& moment);

/// Whether the charge moves otherwise after a change, so that a new load has to be measured: speed,
/// particle counts or rotation. Feed rate and idle time leave the load as it is.
[[nodiscard]] bool asks_for_load(const OperatingChange& change);

/// The changes among `begun` that ask for a load.
[[nodiscard]] std::vector<std::size_t> loads_asked_for(std::span<const OperatingChange> changes,
                                                       std::span<const std::size_t> begun);

/// Up to where the load of a moment holds: milling time from then on [s], at least a second, and
/// lifter height [m].
struct LoadRange {
  double time = std::numeric_limits<double>::infinity();
  double height = -std::numeric_limits<double>::infinity();
};

/// Up to the next change that asks for a load.
[[nodiscard]] LoadRange range_of_load(std::span<const OperatingChange> changes,
                                      const LinerMoment& moment);

/// Hours of the calendar [h] at `hours` of milling: these and the idle times of all changes that
/// have begun by then. `begun_hours` are the milling hours at which each change began, NaN where it
/// has not.
[[nodiscard]] double calendar_hours(std::span<const OperatingChange> changes,
                                    std::span<const double> begun_hours, double hours);

/// Feed milled in `hours` [t], at `first_rate` [kg/s] until a change gives another; NaN where no
/// rate is known. `begun_hours` as above.
[[nodiscard]] double tonnes_milled(std::optional<double> first_rate,
                                   std::span<const OperatingChange> changes,
                                   std::span<const double> begun_hours, double hours);

/// The milling hours at which changes begin during a geometry step [h], NaN where they do not: at
/// their time, or where it is a height that is met, at the step's end.
[[nodiscard]] std::vector<double> begun_hours_after(std::span<const OperatingChange> changes,
                                                    std::vector<double> begun_hours,
                                                    const LinerMoment& step_end, double end_hours);

}  // namespace millwear
