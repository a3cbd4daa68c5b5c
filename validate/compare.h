// Comparing two pictures by every metric.
#pragma once

#include "validate/picture.h"
#include "validate/report.h"

#include <stdexcept>
#include <string>

namespace yarte::validate {

/// A case cannot be decided; what() says why.
class CaseError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A picture and what to call it.
struct NamedPicture {
    std::string name;
    const Picture& picture;
};

/// Throws CaseError if the picture has a nan or an infinity: it cannot be compared.
void checkFinite(const NamedPicture&);

struct Compared {
    Comparison numbers;
    FlipMap flip;
};

/// Pixels count as over `threshold`. Throws CaseError if the sizes differ or a value is not finite.
Compared compare(const NamedPicture& a, const NamedPicture& b, double threshold);

/// The factor 2^-k, k >= 0, just small enough that `max` times it is at most 1.
double exposureFor(double max);

} // namespace yarte::validate
