#include "sim/march/recording.hpp"

namespace reye::sim {

Observer quiet(const Observer& outside) {
  Observer o;
  o.progress = outside.progress;
  o.interrupted = outside.interrupted;
  o.log = outside.log;
  return o;
}

Observer Recording::observer(const Observer& outside) {
  Observer o = quiet(outside);
  if (outside.increment)
    o.increment = [this](const IncrementRecord& r) {
      events_.push_back([r](const Observer& to, const auto& adjust) {
        IncrementRecord row = r;
        if (adjust) adjust(row);
        to.increment(row);
      });
    };
  if (outside.frame)
    o.frame = [this](const Frame& f) { events_.push_back([f](const Observer& to, const auto&) { to.frame(f); }); };
  if (outside.remesh)
    o.remesh = [this](const RemeshRecord& r) {
      events_.push_back([r](const Observer& to, const auto&) { to.remesh(r); });
    };
  return o;
}

void Recording::play_back(const Observer& outside, const std::function<void(IncrementRecord&)>& adjust) {
  for (const auto& event : events_) event(outside, adjust);
  events_.clear();
}

}  // namespace reye::sim
