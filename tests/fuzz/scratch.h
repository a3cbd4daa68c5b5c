// A folder of the process's own in memory, for readers that want a file.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

namespace yarte::fuzz {

class Scratch {
public:
    Scratch() : folder_("/dev/shm/yarte-fuzz-" + std::to_string(::getpid())) {
        std::filesystem::create_directory(folder_);
    }
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::filesystem::path operator/(std::string_view name) const { return folder_ / name; }

    /// The file with these bytes; one of that name is overwritten.
    std::filesystem::path put(std::string_view name, std::string_view bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }

private:
    std::filesystem::path folder_;
};

} // namespace yarte::fuzz
