#include "wear/hdf5/hdf5_file.h"

#include <fmt/format.h>
#include <hdf5.h>

namespace millwear::wear {
namespace {

void check_written(herr_t status, const std::string& failure) {
  if (status < 0) throw DiskError(failure);
}

Handle found(hid_t id, Handle::Closer closer, const std::string& damaged) {
  if (id < 0) throw ResultRejected(damaged);
  return {id, closer, damaged};
}

std::string read_text(hid_t owner, const char* name, const std::string& damaged) {
  const Handle attribute = found(H5Aopen(owner, name, H5P_DEFAULT), H5Aclose, damaged);
  const Handle type = found(H5Aget_type(attribute.id()), H5Tclose, damaged);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0)
    throw ResultRejected(damaged);
  std::string text(H5Tget_size(type.id()), '\0');
  if (H5Aread(attribute.id(), type.id(), text.data()) < 0) throw ResultRejected(damaged);
  return text.substr(0, text.find('\0'));
}

void write_scalar(hid_t owner, const char* name, hid_t stored_as, hid_t given_as, const void* value,
                  const std::string& failure) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, failure);
  Handle attribute(H5Acreate2(owner, name, stored_as, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose, failure);
  check_written(H5Awrite(attribute.id(), given_as, value), failure);
  attribute.close(failure);
}

}  // namespace

QuietErrors::QuietErrors() {
  H5dont_atexit();
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietErrors::~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

std::string damaged_text(const std::filesystem::path& path) {
  return fmt::format("{}: is damaged or incomplete; write it anew", path.string());
}

std::string unwritten_text(const std::filesystem::path& path) {
  return fmt::format("{}: cannot be written; is the disk full?", path.string());
}

void write_attribute(std::int64_t owner, const char* name, std::string_view text,
                     const std::string& failure) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, failure);
  check_written(H5Tset_size(type.id(), text.size() + 1), failure);
  write_scalar(owner, name, type.id(), type.id(), std::string(text).c_str(), failure);
}

void write_attribute(std::int64_t owner, const char* name, std::int64_t number,
                     const std::string& failure) {
  write_scalar(owner, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &number, failure);
}

void write_format(std::int64_t file, const FileFormat& format, const std::string& failure) {
  write_attribute(file, "type", format.type, failure);
  write_attribute(file, "format_version", format.version, failure);
}

std::int64_t read_attribute(std::int64_t owner, const char* name, const std::string& damaged) {
  const Handle attribute = found(H5Aopen(owner, name, H5P_DEFAULT), H5Aclose, damaged);
  std::int64_t number = 0;
  if (H5Aread(attribute.id(), H5T_NATIVE_INT64, &number) < 0) throw ResultRejected(damaged);
  return number;
}

Handle unlocked_access(const std::string& failure) {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, failure);
  if (H5Pset_file_locking(access.id(), false, true) < 0) throw DiskError(failure);
  return access;
}

Handle open_to_read(const std::filesystem::path& path, const FileFormat& format) {
  if (!std::filesystem::is_regular_file(path))
    throw DiskError(path.string() + ": there is no such file");
  const std::string damaged = damaged_text(path);
  const Handle access = unlocked_access(damaged);
  Handle file = found(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose, damaged);
  if (read_text(file.id(), "type", damaged) != format.type)
    throw ResultRejected(fmt::format("{}: is no {}", path.string(), format.type));
  const std::int64_t version = read_attribute(file.id(), "format_version", damaged);
  if (version != format.version) {
    throw ResultRejected(fmt::format(
        "{}: has format version {}, this program reads version {}; write it anew with this one",
        path.string(), version, format.version));
  }
  return file;
}

}  // namespace millwear::wear
