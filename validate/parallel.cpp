#include "validate/parallel.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace yarte::validate {

namespace {

class Work {
public:
    Work(std::size_t count, const std::function<void(std::size_t)>& make,
         const std::function<void(std::size_t)>& done)
        : make_(make), done_(done), made_(count) {}

    /// What each thread does until nothing is left.
    void takePart() noexcept {
        try {
            for (std::size_t i = 0; takeNext(i);) {
                make_(i);
                finish(i);
            }
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!failure_) failure_ = std::current_exception();
        }
    }
    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    bool takeNext(std::size_t& index) {
        const std::lock_guard lock(mutex_);
        if (failure_ || next_ == made_.size()) return false;
        index = next_++;
        return true;
    }
    void finish(std::size_t index) {
        const std::lock_guard lock(mutex_);
        made_[index] = true;
        while (told_ < made_.size() && made_[told_]) done_(told_++);
    }

    const std::function<void(std::size_t)>&make_, &done_;
    std::mutex mutex_;
    std::vector<bool> made_;
    std::size_t next_ = 0, told_ = 0;
    std::exception_ptr failure_;
};

} // namespace

void inParallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& make,
                const std::function<void(std::size_t)>& done) {
    Work work(count, make, done);
    {
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < std::min(count, static_cast<std::size_t>(std::max(jobs, 1))); ++i)
            others.emplace_back([&work] { work.takePart(); });
        work.takePart();
    }
    work.rethrow();
}

} // namespace yarte::validate
