// Prints how the error of the final profile falls with the number of loads, for both schemes and
// the loads that are known in closed form: columns load, scheme, loads, error.
#include <fmt/format.h>

#include "tests/verification/wear/closed_form_campaign.h"

int main() {
  using namespace millwear;
  using namespace millwear::wear;
  fmt::print("load,scheme,loads,error\n");
  for (const auto& load : {growing_rate(), rate_by_slope()}) {
    for (const Scheme scheme : {Scheme::threshold, Scheme::adaptive}) {
      for (const auto& found : refined(load, scheme)) {
        fmt::print("{},{},{},{:.3e}\n", load.name, name_of(scheme), found.loads, found.error);
      }
    }
  }
}
