#pragma once
#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include "mill/base/failure.h"

namespace millwear::wear {

/// GSL returns its errors as long as one of these lives, in place of ending the program.
class QuietGsl {
 public:
  QuietGsl() : previous_(gsl_set_error_handler_off()) {}
  ~QuietGsl() { gsl_set_error_handler(previous_); }
  QuietGsl(const QuietGsl&) = delete;
  QuietGsl& operator=(const QuietGsl&) = delete;

 private:
  gsl_error_handler_t* previous_;
};

/// Throws ResultRejected with GSL's reason unless a call of it went well.
inline void check_gsl(int status) {
  if (status != GSL_SUCCESS) {
    throw ResultRejected(
        fmt::format("the load cannot be smoothed along the profile: {}", gsl_strerror(status)));
  }
}

}  // namespace millwear::wear
