#include "recorder/turning/turned_vectors.h"

#include <cstddef>

namespace millwear::recorder {
namespace {

Triple sum(const Triple& a, const Triple& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Triple difference(const Triple& a, const Triple& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Products with zero stay: they decide the sign of a zero.
[[gnu::always_inline]] inline Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + b[0] * a[1] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + b[0] * a[2] + a[3] * b[1] - a[1] * b[3],
          a[0] * b[3] + b[0] * a[3] + a[1] * b[2] - a[2] * b[1]};
}

[[gnu::always_inline]] inline Triple turned(const Triple& v, const Quaternion& q) {
  const Quaternion half = product(q, {0.0, v[0], v[1], v[2]});
  const Quaternion whole = product(half, {q[0], -q[1], -q[2], -q[3]});
  return {whole[1], whole[2], whole[3]};
}

Triple of(const double* vectors, std::size_t n) {
  return {vectors[3 * n], vectors[3 * n + 1], vectors[3 * n + 2]};
}
void set(double* vectors, std::size_t n, const Triple& value) {
  vectors[3 * n] = value[0];
  vectors[3 * n + 1] = value[1];
  vectors[3 * n + 2] = value[2];
}

// The body of each loop is one function: GCC does not take several vectors at once where a loop
// holds arrays of its own.
[[gnu::always_inline]] inline void turn_direction(double* vectors, std::size_t n,
                                                  const Quaternion& q) {
  set(vectors, n, turned(of(vectors, n), q));
}

[[gnu::always_inline]] inline void turn_point(double* points, std::size_t n, const Turn& turn) {
  const Triple arm = difference(of(points, n), turn.centre);
  set(points, n, sum(turned(arm, turn.quaternion), turn.centre));
}

[[gnu::always_inline]] inline void set_centre(const double* corners, std::size_t n,
                                              double* centres) {
  constexpr double third = 1.0 / 3.0;
  const Triple first = sum(of(corners, 3 * n), {0.0, 0.0, 0.0});
  const Triple both = sum(of(corners, 3 * n + 1), first);
  const Triple all = sum(of(corners, 3 * n + 2), both);
  set(centres, n, {third * all[0], third * all[1], third * all[2]});
}

[[gnu::always_inline]] inline void set_velocity(const double* points, std::size_t n,
                                                const TurningSpeed& speed, double* velocities) {
  const Triple velocity = cross(speed.spin, difference(of(points, n), speed.centre));
  set(velocities, n, sum({0.0, 0.0, 0.0}, velocity));
}

// The compiler makes one function for each kind of vector unit. All give the same bits.
#if defined(__x86_64__) && defined(__gnu_linux__)
#define MILLWEAR_EACH_VECTOR_UNIT [[gnu::target_clones("avx512f", "avx2", "default")]]
#else
#define MILLWEAR_EACH_VECTOR_UNIT
#endif

MILLWEAR_EACH_VECTOR_UNIT
void turn_about_origin(double* vectors, std::size_t count, const Quaternion& quaternion) {
  const Quaternion q = quaternion;
#pragma omp simd
  for (std::size_t n = 0; n < count; ++n) turn_direction(vectors, n, q);
}

MILLWEAR_EACH_VECTOR_UNIT
void turn_about_centre(double* points, std::size_t count, const Turn& about) {
  const Turn turn = about;
#pragma omp simd
  for (std::size_t n = 0; n < count; ++n) turn_point(points, n, turn);
}

MILLWEAR_EACH_VECTOR_UNIT
void set_centres(const double* corners, std::size_t count, double* centres) {
#pragma omp simd
  for (std::size_t n = 0; n < count; ++n) set_centre(corners, n, centres);
}

MILLWEAR_EACH_VECTOR_UNIT
void set_velocities(const double* points, std::size_t count, const TurningSpeed& of_turn,
                    double* velocities) {
  const TurningSpeed speed = of_turn;
#pragma omp simd
  for (std::size_t n = 0; n < count; ++n) set_velocity(points, n, speed, velocities);
}

}  // namespace

void turn_directions(std::span<double> directions, const Quaternion& quaternion) {
  turn_about_origin(directions.data(), directions.size() / 3, quaternion);
}

void turn_points(std::span<double> points, const Turn& turn) {
  const auto& c = turn.centre;
  if (c[0] * c[0] + c[1] * c[1] + c[2] * c[2] > 0.0)
    turn_about_centre(points.data(), points.size() / 3, turn);
  else
    turn_about_origin(points.data(), points.size() / 3, turn.quaternion);
}

void find_centres(std::span<const double> corners, std::span<double> centres) {
  set_centres(corners.data(), centres.size() / 3, centres.data());
}

void find_velocities(std::span<const double> points, const TurningSpeed& speed,
                     std::span<double> velocities) {
  set_velocities(points.data(), velocities.size() / 3, speed, velocities.data());
}

}  // namespace millwear::recorder
