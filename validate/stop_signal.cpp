#include "validate/stop_signal.h"

#include <cerrno>
#include <csignal>
#include <sys/signalfd.h>
#include <system_error>
#include <unistd.h>

namespace yarte::validate {

namespace {

sigset_t stopSignals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    return signals;
}

} // namespace

StopSignal::StopSignal() {
    const sigset_t signals = stopSignals();
    descriptor_ = ::signalfd(-1, &signals, SFD_CLOEXEC);
    if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "signalfd");
    ::sigprocmask(SIG_BLOCK, &signals, nullptr);
}

StopSignal::~StopSignal() {
    ::close(descriptor_);
} // the signals stay blocked: cleaning up must not be interrupted

void StopSignal::check() const {
    sigset_t pending;
    ::sigpending(&pending);
    for (const int signal : {SIGINT, SIGTERM})
        if (sigismember(&pending, signal) == 1) throw Interrupted(signal);
}

} // namespace yarte::validate
