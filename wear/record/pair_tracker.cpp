#include "wear/record/pair_tracker.h"

namespace millwear::wear {
namespace {

std::uint64_t key_of(std::uint32_t first, std::uint32_t second) {
  return (static_cast<std::uint64_t>(first) << 32) | second;
}

}  // namespace

PairTracker::PairTracker(std::size_t class_count, double duration, double sample_interval)
    : sample_interval_(sample_interval),
      class_count_(static_cast<Eigen::Index>(class_count)),
      record_{duration, empty_spectrum(pair_groups(class_count_)), 0.0, 0.0, 0.0} {}

void PairTracker::begin_sample() { ++sample_; }

void PairTracker::add(const PairContact& contact) {
  const auto [found, fresh] = open_.try_emplace(key_of(contact.first, contact.second));
  OpenPair& pair = found->second;
  if (fresh) {
    const Eigen::Index group = pair_group(contact.first_class, contact.second_class, class_count_);
    pair = {
        contact.first, contact.second, static_cast<std::int32_t>(group), sample_ == 1, 0, 0.0, 0.0};
  }
  pair.sample = sample_;
  pair.normal_energy += contact.normal_power * sample_interval_;
  pair.shear_energy += contact.shear_power * sample_interval_;
  record_.normal_dissipation += contact.normal_power * sample_interval_;
  record_.shear_dissipation += contact.shear_power * sample_interval_;
  record_.rolling_dissipation += contact.rolling_power * sample_interval_;
}

void PairTracker::close(const OpenPair& pair) {
  if (pair.began_before)
    record_.spectrum.unfinished[pair.group] += 1.0;
  else
    add_collision(record_.spectrum, pair.group, pair.normal_energy, pair.shear_energy);
}

void PairTracker::end_sample() {
  std::erase_if(open_, [&](const auto& entry) {
    if (entry.second.sample == sample_) return false;
    close(entry.second);
    return true;
  });
}

PairRecord PairTracker::finish() {
  for (const auto& [key, pair] : open_) record_.spectrum.unfinished[pair.group] += 1.0;
  open_.clear();
  return record_;
}

std::vector<OpenPair> PairTracker::release(const std::function<bool(std::uint32_t)>& left) {
  std::vector<OpenPair> released;
  std::erase_if(open_, [&](const auto& entry) {
    if (!left(entry.second.first)) return false;
    released.push_back(entry.second);
    return true;
  });
  return released;
}

void PairTracker::adopt(const OpenPair& pair) {
  OpenPair& mine = open_[key_of(pair.first, pair.second)];
  mine = pair;
  mine.sample = sample_;
}

}  // namespace millwear::wear
