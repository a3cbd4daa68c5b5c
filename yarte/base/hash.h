// Hashes of content: to find damage and to tell versions apart, not against malice (XXH3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace yarte {

std::uint64_t checksum(std::string_view bytes);

/// 128 bits over everything that was added, in order.
class ContentHash {
public:
    ContentHash();
    ~ContentHash();
    ContentHash(const ContentHash&) = delete;
    ContentHash& operator=(const ContentHash&) = delete;

    void add(std::string_view bytes);
    /// The number of elements, then their bytes: lists cannot run into one another.
    template <class T>
    void add(const std::vector<T>& list) {
        const std::uint64_t size = list.size();
        add({reinterpret_cast<const char*>(&size), sizeof size});
        add({reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T)});
    }
    std::string hex() const;

private:
    void* state_;
};

} // namespace yarte
