// StopSignal: SIGINT and SIGTERM as something to wait for, so that nothing is left behind when they come.
#pragma once

#include <exception>

namespace yarte::validate {

/// Somebody asked the program to stop. Thrown so that folders and children are cleaned up on the way out.
class Interrupted : public std::exception {
public:
    explicit Interrupted(int signal) : signal_(signal) {}
    int signal() const { return signal_; }
    const char* what() const noexcept override { return "interrupted"; }

private:
    int signal_;
};

/// While one exists the signals do not end the process but make `descriptor` readable. Make it before any
/// thread.
class StopSignal {
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    int descriptor() const { return descriptor_; }
    /// Throws Interrupted once a signal has come.
    void check() const;

private:
    int descriptor_;
};

} // namespace yarte::validate
