#include "signals.hpp"

namespace reye::apps {

namespace {

constexpr int asking[] = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t signals = 0;
volatile std::sig_atomic_t second_ends = 0;

extern "C" void on_signal(int signal) {
  signals = signals + 1;
  if (second_ends && signal != SIGHUP) std::signal(signal, SIG_DFL);
}

}  // namespace

StopSignals::StopSignals(bool twice_ends) {
  signals = 0;
  second_ends = twice_ends;
  struct sigaction action {};
  action.sa_handler = on_signal;
  for (int i = 0; i < 3; ++i) {
    ::sigaction(asking[i], nullptr, &before_[i]);
    const bool wanted = asking[i] != SIGHUP || before_[i].sa_handler != SIG_IGN;
    if (wanted) ::sigaction(asking[i], &action, nullptr);
  }
}

StopSignals::~StopSignals() {
  for (int i = 0; i < 3; ++i) ::sigaction(asking[i], &before_[i], nullptr);
}

int StopSignals::count() { return signals; }

void ignore_lost_output() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace reye::apps
