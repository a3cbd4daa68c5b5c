#include "yarte/interrupt.h"

#include <atomic>
#include <csignal>

#include <unistd.h>

namespace yarte {

namespace {

// A signal handler can reach nothing but globals, and do nothing to them that is not lock-free.
std::atomic<bool> deferred = false;
std::atomic<int> noted = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void handle(int signal) {
    if (!deferred) _exit(interruptExitCode(signal));
    noted = signal;
}

} // namespace

void installInterruptHandlers() {
    struct sigaction action {};
    action.sa_handler = handle;
    action.sa_flags = SA_RESTART; // a write is not torn; sleeping for workers ends early all the same
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

DeferredInterrupts::DeferredInterrupts() { deferred = true; }
DeferredInterrupts::~DeferredInterrupts() { deferred = false; }
int DeferredInterrupts::pending() { return noted; }

} // namespace yarte
