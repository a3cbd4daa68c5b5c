// Reading tolerances from JSON. Every mistake of a file is found in one run.
#pragma once

#include "validate/tolerance.h"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace yarte::validate {

struct ToleranceProblem {
    std::string place;     ///< a JSON pointer ("/all/0/rmse"), or line:column of text that is no JSON
    std::string_view code; ///< stable: "tolerance.limit-negative"; the list is in the README
    std::string message;
};

/// what() has a line per problem: "FILE#/all/0/rmse: error: must not be negative, got -1
/// [tolerance.limit-negative]".
class ToleranceError : public std::runtime_error {
public:
    ToleranceError(const std::filesystem::path& file, std::vector<ToleranceProblem>);
    const std::vector<ToleranceProblem>& problems() const { return problems_; }

private:
    std::vector<ToleranceProblem> problems_;
};

/// `file` is what to call it, and where the paths of mask images start. Throws ToleranceError.
Tolerance parseTolerance(std::string_view text, const std::filesystem::path& file);

/// Throws ToleranceError, or FileError if it cannot be read.
Tolerance readTolerance(const std::filesystem::path& file);

/// Of a scene: that in `named` unless it is empty, else in tolerance.json beside the scene if there is one,
/// else the default. Errors as readTolerance.
Tolerance toleranceFor(const std::filesystem::path& scene, const std::filesystem::path& named);

} // namespace yarte::validate
