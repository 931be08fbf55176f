#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "mill/base/failure.h"

namespace millwear {

/// What is wrong with a case file, gathered so that all of it is told at once.
class CaseProblems {
 public:
  explicit CaseProblems(std::filesystem::path file) : file_(std::move(file)) {}

  /// "what is wrong (why, with numbers); what would be right"
  void add(int line, std::string text) { problems_.emplace_back(line, std::move(text)); }

  /// Runs `step`; an InputError it throws becomes a problem of `line`.
  template <typename Step>
  void attempt(int line, Step&& step) {
    try {
      step();
    } catch (const InputError& error) {
      add(line, error.what());
    }
  }

  [[nodiscard]] bool empty() const { return problems_.empty(); }

  /// Throws InputError with one line "file:line: text" a problem, if there is any.
  void throw_if_any() const;

 private:
  std::filesystem::path file_;
  std::vector<std::pair<int, std::string>> problems_;
};

}  // namespace millwear
