// What libFuzzer calls, and replay.cpp beside it: one input, which must neither crash nor hang, nor take
// memory without bound. Each target is a file that defines it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace yarte::fuzz {

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

} // namespace yarte::fuzz
