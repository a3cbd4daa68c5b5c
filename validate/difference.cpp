#include "validate/difference.h"

namespace yarte::validate {

Difference::Difference(ImageView a, ImageView b, double threshold)
    : a_(a), b_(b), threshold_(threshold),
      differs_(static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height)) {
    for (std::size_t i = 0; i < differs_.size(); ++i) {
        differs_[i] = error(i) > threshold;
        count_ += differs_[i];
    }
}

} // namespace yarte::validate
