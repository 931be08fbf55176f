#include "mill/recording/recorder_orders.h"

namespace millwear {
namespace {

/// Appends what `for_each_option` tells of.
auto into(std::vector<std::string>& words) {
  return
      [&words](const RecorderOption& option, const auto& value) { append(words, option, value); };
}

GoingOnOptions apart(const std::optional<GoingOn>& going_on) {
  if (!going_on) return {};
  return {going_on->target_error, going_on->by_steps, going_on->at_most};
}

}  // namespace

long samples_of(const RecordingPlan& plan) {
  return plan.last_step / plan.every_steps - plan.first_step / plan.every_steps;
}

std::vector<std::string> to_arguments(RecordingPlan plan) {
  std::vector<std::string> words;
  GoingOnOptions going_on = apart(plan.going_on);
  for_each_option(plan, going_on, into(words));
  return words;
}

std::vector<std::string> to_arguments(MixingOptions options) {
  std::vector<std::string> words = {mixing_verb};
  for_each_option(options, into(words));
  return words;
}

std::vector<std::string> to_arguments(RunOptions options) {
  std::vector<std::string> words = {running_verb};
  for_each_option(options, into(words));
  return words;
}

}  // namespace millwear
