#include "validate/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace yarte::validate {

TemporaryFolder::TemporaryFolder(const std::filesystem::path& parent) {
    std::string name = std::filesystem::absolute(parent) / "yarte-validate-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr)
        throw std::filesystem::filesystem_error("cannot make a temporary folder", parent,
                                                std::error_code(errno, std::generic_category()));
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored; // nothing better to do with it here
    std::filesystem::remove_all(path_, ignored);
}

} // namespace yarte::validate
