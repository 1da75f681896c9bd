#include "sim/solid/solid_recording.hpp"

namespace reye::sim {

SolidObserver quiet(const SolidObserver& outside) {
  SolidObserver o;
  o.progress = outside.progress;
  o.interrupted = outside.interrupted;
  o.log = outside.log;
  return o;
}

SolidObserver SolidRecording::observer(const SolidObserver& outside) {
  SolidObserver o = quiet(outside);
  if (outside.increment)
    o.increment = [this](const SolidIncrement& r) {
      events_.push_back([r](const SolidObserver& to, const auto& adjust) {
        SolidIncrement row = r;
        if (adjust) adjust(row);
        to.increment(row);
      });
    };
  if (outside.frame)
    o.frame = [this](const SolidFrame& f) {
      events_.push_back([f](const SolidObserver& to, const auto&) { to.frame(f); });
    };
  return o;
}

void SolidRecording::play_back(const SolidObserver& outside, const std::function<void(SolidIncrement&)>& adjust) {
  for (const auto& event : events_) event(outside, adjust);
  events_.clear();
}

}  // namespace reye::sim
