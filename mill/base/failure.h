#pragma once
#include <stdexcept>
#include <string>

namespace millwear {

/// Exit codes of the command line. Scripts and clusters rely on them.
enum class ExitCode {
  ok = 0,
  internal = 1,
  usage = 2,
  bad_case_file = 3,
  external_program_failed = 4,
  result_rejected = 5,
  disk = 6,
  locked = 7,
};

/// A failure that the user can act on. Its text says what is wrong, where, and what would be right.
/// Thrown anywhere, caught once in `main`, which prints the text and leaves with `exit_code`.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode code, const std::string& text) : std::runtime_error(text), exit_code(code) {}
  ExitCode exit_code;
};

/// Something that the user wrote cannot be simulated: a case file, a profile, a value.
class InputError : public Failure {
 public:
  explicit InputError(const std::string& text) : Failure(ExitCode::bad_case_file, text) {}
};

/// gmsh, LIGGGHTS, mpirun: missing, or ended badly.
class ExternalProgramError : public Failure {
 public:
  explicit ExternalProgramError(const std::string& text)
      : Failure(ExitCode::external_program_failed, text) {}
};

/// A program ended well but its result does not pass our checks, or a published file was changed.
class ResultRejected : public Failure {
 public:
  explicit ResultRejected(const std::string& text) : Failure(ExitCode::result_rejected, text) {}
};

/// The disk is full, or a file cannot be written or read.
class DiskError : public Failure {
 public:
  explicit DiskError(const std::string& text) : Failure(ExitCode::disk, text) {}
};

}  // namespace millwear
