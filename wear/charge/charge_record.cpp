#include "wear/charge/charge_record.h"

#include <string>
#include <utility>

#include "wear/hdf5/hdf5_reader.h"
#include "wear/hdf5/hdf5_writer.h"

namespace millwear::wear {
namespace {

constexpr FileFormat format{charge_file_type, charge_format_version};
constexpr std::size_t state_rows = 9;

void write_fields(const Hdf5Writer& writer, const ChargeFields& fields) {
  const Handle group = writer.new_group("fields");
  writer.write_number(group.id(), "half_width", "m", fields.grid.half_width);
  writer.write_number(group.id(), "cells", "1", fields.grid.cells);
  writer.write_number(group.id(), "slice_length", "m", fields.slice_length);
  writer.write_number(group.id(), "instants", "1", fields.instants);
  writer.write_number(group.id(), "pair_duration", "s", fields.pair_duration);
  writer.write_matrix(group.id(), "sums", "1, kg, kg m/s, kg m/s, kg m/s, J", fields.sums);
  writer.write_matrix(group.id(), "class_mass", "kg", fields.class_mass);
  writer.write_matrix(group.id(), "normal_dissipation", "J", fields.normal_dissipation);
  writer.write_matrix(group.id(), "shear_dissipation", "J", fields.shear_dissipation);
}

ChargeFields fields_from(const Hdf5Reader& reader) {
  const Handle group = reader.group("fields");
  const SectionGrid grid{reader.read_number(group.id(), "half_width"),
                         static_cast<int>(reader.read_number(group.id(), "cells"))};
  const Eigen::MatrixXd class_mass = reader.read_matrix(group.id(), "class_mass");
  ChargeFields fields = no_charge_fields(grid, reader.read_number(group.id(), "slice_length"),
                                         static_cast<std::size_t>(class_mass.cols()));
  const auto take = [&](const char* name, auto& into) {
    const Eigen::MatrixXd found = reader.read_matrix(group.id(), name);
    reader.require(found.rows() == into.rows() && found.cols() == into.cols());
    into = found;
  };
  fields.instants = reader.read_number(group.id(), "instants");
  fields.pair_duration = reader.read_number(group.id(), "pair_duration");
  take("sums", fields.sums);
  take("class_mass", fields.class_mass);
  take("normal_dissipation", fields.normal_dissipation);
  take("shear_dissipation", fields.shear_dissipation);
  return fields;
}

void write_range(const Hdf5Writer& writer, const Handle& group, const char* name, const char* unit,
                 const FrameRange& range) {
  const double ends[] = {range.low, range.high};
  writer.write_values(group.id(), name, unit, {2}, ends);
}

FrameRange range_from(const Hdf5Reader& reader, const Handle& group, const char* name) {
  const auto ends = reader.read_values(group.id(), name, 1).values;
  reader.require(ends.size() == 2);
  return {ends[0], ends[1]};
}

void write_frames(const Hdf5Writer& writer, ChargeFrames frames) {
  const Handle group = writer.new_group("frames");
  const Extents sizes{frames.frames(), 3, frames.particles()};
  write_range(writer, group, "range_across", "m", frames.across);
  write_range(writer, group, "range_along", "m", frames.along);
  write_range(writer, group, "range_speed", "m/s", frames.speed);
  writer.write_number(group.id(), "thinning", "1", static_cast<double>(frames.thinning));
  writer.write_values(group.id(), "time", "s", {frames.frames()}, frames.times.data());
  writer.write_values(group.id(), "mill_angle", "rad", {frames.frames()},
                      frames.mill_angles.data());
  writer.write_values(group.id(), "class_radius", "m", {frames.class_radius.size()},
                      frames.class_radius.data());
  writer.write_values(group.id(), "class", "1", {frames.particles()}, frames.classes.data());
  to_differences(frames.places, 3 * frames.particles());
  to_differences(frames.speeds, frames.particles());
  writer.write_values(group.id(), "place_differences", "1", sizes, frames.places.data());
  writer.write_values(group.id(), "speed_differences", "1", {sizes[0], sizes[2]},
                      frames.speeds.data());
  writer.write_values(group.id(), "state", "m, m/s, rad/s", {state_rows, frames.particles()},
                      frames.state.data());
}

ChargeFrames frames_from(const Hdf5Reader& reader) {
  const Handle group = reader.group("frames");
  ChargeFrames frames{
      .across = range_from(reader, group, "range_across"),
      .along = range_from(reader, group, "range_along"),
      .speed = range_from(reader, group, "range_speed"),
      .thinning = static_cast<std::size_t>(reader.read_number(group.id(), "thinning")),
      .times = reader.read_values(group.id(), "time", 1).values,
      .mill_angles = reader.read_values(group.id(), "mill_angle", 1).values,
      .class_radius = reader.read_values(group.id(), "class_radius", 1).values,
      .classes = reader.read_values<std::uint8_t>(group.id(), "class", 1).values,
      .places = reader.read_values<std::uint16_t>(group.id(), "place_differences", 3).values,
      .speeds = reader.read_values<std::uint16_t>(group.id(), "speed_differences", 2).values,
      .state = reader.read_values<float>(group.id(), "state", 2).values};
  const std::size_t values = frames.frames() * frames.particles();
  reader.require(frames.mill_angles.size() == frames.frames() &&
                 frames.places.size() == 3 * values && frames.speeds.size() == values &&
                 frames.state.size() == state_rows * frames.particles());
  for (const auto kind : frames.classes) reader.require(kind < frames.class_radius.size());
  from_differences(frames.places, 3 * frames.particles());
  from_differences(frames.speeds, frames.particles());
  return frames;
}

}  // namespace

ChargeRecord joined(ChargeRecord first, const ChargeRecord& last) {
  return {sum_of(first.fields, last.fields), first.frames ? std::move(first.frames) : last.frames};
}

void write_charge(const std::filesystem::path& path, const ChargeRecord& record) {
  Hdf5Writer writer(path, format);
  write_fields(writer, record.fields);
  if (record.frames) write_frames(writer, *record.frames);
  writer.publish();
}

ChargeRecord read_charge(const std::filesystem::path& path, ChargeParts parts) {
  const Hdf5Reader reader(path, format);
  ChargeRecord record{fields_from(reader), std::nullopt};
  if (parts == ChargeParts::all && reader.has("frames")) record.frames = frames_from(reader);
  return record;
}

}  // namespace millwear::wear
