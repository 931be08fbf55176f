#pragma once
#include <cstddef>
#include <cstdint>

namespace millwear::wear {

/// A collision that was not seen from its beginning to its end.
enum class Unfinished : std::uint8_t {
  none = 0,
  began_before = 1,  ///< the particle touched already when the measurement began
  open_at_end = 2,   ///< ... and still touched when it ended
  both = 3,
};

/// One particle's unbroken contact with one side of it on the liner: from the first sample in which
/// it touches to the last. A plain row, as it is written to events.h5.
struct Collision {
  double start;                 ///< time of the first sample in contact [s]
  double end;                   ///< time of the last [s]
  double arc_length;            ///< where it began, along the profile [m]; negative: off it
  double axial_place;           ///< y where it began [m]
  double impact_speed;          ///< of the centre against the wall, at the first sample [m/s]
  double impact_angle;          ///< of that velocity from the surface [rad], 0 ... pi / 2
  double largest_normal_force;  ///< of simultaneous contacts on this side together [N]
  double normal_dissipation;    ///< int Fn v_n dt [J]
  double sliding_work;          ///< int max(Fn, 0) v_slide dt [J], see mill/load/contact_motion.h
  double shear_dissipation;     ///< int -Ft . v_slip dt [J]
  double slip_distance;         ///< int v_slide dt, the largest of simultaneous contacts [m]
  std::uint32_t particle;       ///< its number, from 1
  std::uint32_t particle_class;
  std::int32_t row;  ///< lifter where it began
  Unfinished unfinished;
};

}  // namespace millwear::wear
