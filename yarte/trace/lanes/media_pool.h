// MediaPool: the media stacks that occur, each kept once and known by a number, with what leads from one to
// the other.
#pragma once

#include "yarte/trace/media.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace yarte::trace {

/// 0 is the stack that camera rays start with.
using MediaIndex = std::uint32_t;

class MediaPool {
public:
    struct Transition {
        double ratio;
        bool isContinued;
        MediaIndex after;
    };

    explicit MediaPool(const World& world) : world_(world), stacks_{world.cameraMedia} {}

    /// `pass` of yarte/trace/media.h, looked up if it was asked before.
    const Transition& pass(MediaIndex before, BodyId body) {
        const std::uint64_t key = std::uint64_t{before} << 32 | body.index;
        const auto known = transitions_.find(key);
        if (known != transitions_.end()) return known->second;
        Passage passage = trace::pass(world_, stacks_[before], body);
        const auto same = std::find(stacks_.begin(), stacks_.end(), passage.after);
        const auto after = static_cast<MediaIndex>(same - stacks_.begin());
        if (same == stacks_.end()) stacks_.push_back(std::move(passage.after));
        return transitions_.emplace(key, Transition{passage.ratio, passage.isContinued, after}).first->second;
    }

private:
    const World& world_;
    std::vector<MediaStack> stacks_;
    std::unordered_map<std::uint64_t, Transition> transitions_;
};

} // namespace yarte::trace
