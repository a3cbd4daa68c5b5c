// SIGINT and SIGTERM: they end the program at once, or, where something must be cleaned up first, soon.
#pragma once

namespace yarte {

/// The exit code of a program that a signal ended, as shells give it: 130 for SIGINT.
constexpr int interruptExitCode(int signal) { return 128 + signal; }

/// From now on SIGINT and SIGTERM end the program at once with interruptExitCode.
void installInterruptHandlers();

/// While one lives, the signals are only noted: whoever made it asks for them, and cleans up.
class DeferredInterrupts {
public:
    DeferredInterrupts();
    ~DeferredInterrupts();
    DeferredInterrupts(const DeferredInterrupts&) = delete;
    DeferredInterrupts& operator=(const DeferredInterrupts&) = delete;

    /// The signal that came meanwhile; 0 for none.
    static int pending();
};

} // namespace yarte
