#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "orchestrator/study/study_axes.h"

namespace millwear::orchestrator {

/// How the values of several axes become points.
enum class Combine {
  product,          ///< every value of one with every value of the others
  zip,              ///< the first of all, the second of all, ...
  latin_hypercube,  ///< as many as `samples`, spread evenly over every axis
  table,            ///< the rows of a CSV
  search,           ///< the next from the results so far, as many as `budget_points`
};

/// What "best" means: the largest or the least of a result, or of a ratio of two.
struct Objective {
  enum class Sense { maximise, minimise };
  Sense sense;
  std::string result;   ///< a column of `study.csv`
  std::string divisor;  ///< likewise; empty for none
};

/// What a point of a search must keep.
struct Limit {
  enum class Kind { at_least, at_most };
  Kind kind;
  std::string result;  ///< a column of `study.csv`
  double value;
};

/// A question to many campaigns of one case (docs/how_to_run_a_study.md).
struct Study {
  std::filesystem::path file;  ///< the study file, or the case where axes came by the command line
  std::string name;
  std::filesystem::path case_file;
  Combine combine = Combine::product;
  int replicates = 1;  ///< campaigns of each point that differ in the seed
  int samples = 0;     ///< points of a `latin_hypercube`, or that a `search` may try
  std::uint64_t seed = 1;
  std::vector<StudyAxis> axes{};
  std::vector<std::uint64_t> seeds{};  ///< of the replicates, from an axis `dem.seed`; else none
  std::optional<Objective> objective{};
  std::vector<Limit> limits{};  ///< of a search
  /// The base case is mixed once, and all campaigns begin with its charge (`charge_from`).
  bool charge_from_base = false;
};

/// Reads and checks a study file. Throws InputError with all that is wrong, "file:line: what".
[[nodiscard]] Study read_study(const std::filesystem::path& file);

/// A study of a case by axes as the command line gives them, `KEY=V,V,...` or `KEY=LOW:HIGH:STEP`.
/// Throws InputError.
[[nodiscard]] Study study_of_case(const std::filesystem::path& case_file,
                                  const std::vector<std::string>& axes);

/// Reads "maximise life_hours" or "minimise power_w / life_hours". Throws InputError.
[[nodiscard]] Objective objective_from(const std::string& words);

/// "maximise life_hours"
[[nodiscard]] std::string spoken(const Objective& objective);

}  // namespace millwear::orchestrator
