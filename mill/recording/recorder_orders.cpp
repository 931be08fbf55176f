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

bool is_sampled(const RecordingPlan& plan, long step) {
  return step > plan.first_step && step <= plan.last_step &&
         ((step - plan.first_step) % plan.every_steps == 0 || step == plan.last_step);
}

long measured_until(const RecordingPlan& plan, long step) {
  return plan.measured_before.value_or(0) + step - plan.first_step;
}

long steps_of_blocks(const RecordingPlan& plan) {
  return plan.block_steps.value_or(plan.last_step - plan.first_step);
}

long samples_between(const RecordingPlan& plan, long from, long to) {
  const long begin = from - plan.first_step;
  const long end = to - plan.first_step;
  return end / plan.every_steps - begin / plan.every_steps + (end % plan.every_steps != 0 ? 1 : 0);
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

std::vector<std::string> to_arguments(DeckRunOptions options) {
  std::vector<std::string> words = {running_verb};
  for_each_option(options, into(words));
  return words;
}

}  // namespace millwear
