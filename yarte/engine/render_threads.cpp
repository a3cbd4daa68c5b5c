#include "yarte/engine/render_job.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace yarte {

namespace {

/// Where the threads meet the one that waits for them.
class Crew {
public:
    explicit Crew(int workers) : running_(workers) {}

    /// A thread leaves, with the exception that ended it or none.
    void leave(std::exception_ptr failure) {
        const std::scoped_lock lock(mutex_);
        if (failure && !failure_) failure_ = std::move(failure);
        --running_;
        changed_.notify_one();
    }

    /// Sleeps until all have left, or for `progressInterval`; true if all have. Throws what a thread threw.
    bool wait() {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, progressInterval, [this] { return running_ == 0 || failure_; });
        if (failure_) std::rethrow_exception(failure_);
        return running_ == 0;
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int running_;
    std::exception_ptr failure_;
};

void work(const std::stop_token& stop, int worker, const RenderJob& job, Crew& crew) {
    std::exception_ptr failure;
    try {
        std::vector<Colour> pixels;
        while (!stop.stop_requested() && job.renderNext(worker, pixels)) {
        }
    } catch (...) {
        failure = std::current_exception();
    }
    crew.leave(std::move(failure));
}

} // namespace

bool renderInThreads(const RenderJob& job, int workers) {
    Crew crew(workers);
    std::vector<std::jthread> threads; // on every way out, they are told to stop and joined
    for (int worker = 0; worker < workers; ++worker)
        threads.emplace_back([&, worker](const std::stop_token& stop) { work(stop, worker, job, crew); });
    for (bool finished = false; !finished;) {
        finished = crew.wait();
        if (!job.report()) return false;
    }
    return true;
}

} // namespace yarte
