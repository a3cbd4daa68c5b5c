#include "validate/verdict.h"

#include "validate/aov_edges.h"
#include "validate/image_file.h"
#include "validate/metrics.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace yarte::validate {

namespace {

using Mask = std::vector<bool>;

/// A limit as people write it: a 16-bit fraction where it is one.
std::string limitText(double limit) {
    const double steps = limit * 65535;
    if (steps >= 1 && steps < 1000 && std::abs(steps - std::round(steps)) < 1e-9)
        return fmt::format("{}/65535", std::round(steps));
    return fmt::format("{:.4g}", limit);
}

std::string setText(const PixelSet& set) {
    std::vector<std::string> parts;
    for (const PixelBox& r : set.rectangles)
        parts.push_back(fmt::format("[{}, {}, {}, {}]", r.x0, r.y0, r.x1, r.y1));
    for (const std::filesystem::path& image : set.images) parts.push_back(image.filename().string());
    if (set.silhouette > 0) parts.push_back(fmt::format("within {} px of an outline", set.silhouette));
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string text(const Condition& c) {
    std::string words;
    switch (c.kind) {
    case Condition::Kind::all: words = "all of"; break;
    case Condition::Kind::any: words = "any of"; break;
    case Condition::Kind::maxAbs: words = "max_abs <= " + limitText(c.limit); break;
    case Condition::Kind::rmse: words = "rmse <= " + limitText(c.limit); break;
    case Condition::Kind::flipMean: words = fmt::format("flip_mean <= {:.4g}", c.limit); break;
    case Condition::Kind::pixelCount:
        words = fmt::format("pixels over {} <= {:.12g}", limitText(c.threshold), c.limit);
        break;
    case Condition::Kind::pixelFraction:
        words = fmt::format("part of pixels over {} <= {:.4g}", limitText(c.threshold), c.limit);
        break;
    }
    if (!c.only.empty()) words += " only " + setText(c.only);
    if (!c.except.empty()) words += " except " + setText(c.except);
    return words;
}

class Judge {
public:
    explicit Judge(const JudgedPictures& pictures) : p_(pictures) {}

    /// Appends the results of the condition and its parts; true if it holds.
    bool apply(const Condition&, Mask judged, int depth);
    Judgement judgement;

private:
    std::size_t size() const {
        return static_cast<std::size_t>(p_.a.width) * static_cast<std::size_t>(p_.a.height);
    }
    Mask maskOf(const PixelSet&) const;
    void addImage(Mask&, const std::filesystem::path&) const;
    double measured(const Condition&, const Mask& judged) const;

    const JudgedPictures& p_;
};

void Judge::addImage(Mask& mask, const std::filesystem::path& file) const {
    Picture image;
    try {
        image = readPicture(file);
    } catch (const ImageError& error) {
        throw JudgementError(fmt::format("mask {}", error.what()));
    }
    if (image.width != p_.a.width || image.height != p_.a.height)
        throw JudgementError(fmt::format("mask {}: is {}x{}, the picture {}x{}", file.string(), image.width,
                                         image.height, p_.a.width, p_.a.height));
    for (std::size_t i = 0; i < size(); ++i)
        if (!isBlack(image.pixels[i])) mask[i] = true;
}

Mask Judge::maskOf(const PixelSet& set) const {
    Mask mask(size());
    const auto width = static_cast<std::size_t>(p_.a.width);
    for (const PixelBox& r : set.rectangles)
        for (int y = r.y0; y < std::min(r.y1, p_.a.height); ++y)
            for (int x = r.x0; x < std::min(r.x1, p_.a.width); ++x)
                mask[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] = true;
    for (const std::filesystem::path& image : set.images) addImage(mask, image);
    if (set.silhouette > 0) {
        if (p_.aov == nullptr)
            throw JudgementError("a tolerance with \"silhouette\" needs a scene that YARTE renders");
        const Mask near = nearOutline(*p_.aov, set.silhouette);
        for (std::size_t i = 0; i < size(); ++i)
            if (near[i]) mask[i] = true;
    }
    return mask;
}

double Judge::measured(const Condition& c, const Mask& judged) const {
    double largest = 0, squares = 0, flip = 0;
    std::size_t count = 0, over = 0;
    for (std::size_t i = 0; i < size(); ++i) {
        if (!judged[i]) continue;
        const Colour a = p_.a.pixels[i], b = p_.b.pixels[i];
        const double error = pixelError(a, b);
        ++count;
        largest = std::max(largest, error);
        over += error > c.threshold;
        squares += (a.r - b.r) * (a.r - b.r) + (a.g - b.g) * (a.g - b.g) + (a.b - b.b) * (a.b - b.b);
        flip += static_cast<double>(p_.flip.values[i]);
    }
    if (count == 0) return 0;
    const auto n = static_cast<double>(count);
    switch (c.kind) {
    case Condition::Kind::maxAbs: return largest;
    case Condition::Kind::rmse: return std::sqrt(squares / (3 * n));
    case Condition::Kind::flipMean: return flip / n;
    case Condition::Kind::pixelCount: return static_cast<double>(over);
    case Condition::Kind::pixelFraction: return static_cast<double>(over) / n;
    case Condition::Kind::all:
    case Condition::Kind::any: break;
    }
    return 0;
}

bool Judge::apply(const Condition& c, Mask judged, int depth) {
    const Mask only = c.only.empty() ? Mask(size(), true) : maskOf(c.only), except = maskOf(c.except);
    for (std::size_t i = 0; i < size(); ++i) judged[i] = judged[i] && only[i] && !except[i];
    const std::size_t place = judgement.conditions.size();
    judgement.conditions.push_back({depth, false, c.isGroup(), text(c), 0, c.limit, c.reason, c.pointer});
    bool holds = c.kind == Condition::Kind::all;
    if (c.isGroup()) {
        for (const Condition& part : c.parts) {
            const bool one = apply(part, judged, depth + 1);
            holds = c.kind == Condition::Kind::all ? holds && one : holds || one;
        }
        judgement.conditions[place].limit = 0;
    } else {
        const double value = measured(c, judged);
        judgement.conditions[place].measured = value;
        holds = value <= c.limit;
    }
    judgement.conditions[place].holds = holds;
    return holds;
}

/// Three digits, or as many as show that the limit was passed.
std::string factorText(double factor) {
    return fmt::format("{:.{}g}", factor, factor < 1.005 ? 6 : 3);
}

/// "max_abs <= 4/65535 does not hold: 0.0123, 202 times the limit".
std::string failure(const ConditionResult& r) {
    const std::string factor =
        r.limit > 0 ? fmt::format(", {} times the limit", factorText(r.measured / r.limit)) : "";
    return fmt::format("{} does not hold: {:.4g}{}{}", r.text, r.measured, factor,
                       r.pointer.empty() ? "" : fmt::format(" ({})", r.pointer));
}

bool hasSilhouette(const Condition& c) {
    return c.only.silhouette > 0 || c.except.silhouette > 0 ||
           std::any_of(c.parts.begin(), c.parts.end(), hasSilhouette);
}

} // namespace

const char* name(Verdict verdict) {
    switch (verdict) {
    case Verdict::pass: return "pass";
    case Verdict::fail: return "fail";
    case Verdict::error: break;
    }
    return "error";
}

bool needsAov(const Tolerance& tolerance) { return hasSilhouette(tolerance.condition); }

Judgement judge(const Tolerance& tolerance, const JudgedPictures& pictures) {
    Judge judge(pictures);
    const auto pixels =
        static_cast<std::size_t>(pictures.a.width) * static_cast<std::size_t>(pictures.a.height);
    judge.judgement.holds = judge.apply(tolerance.condition, Mask(pixels, true), 0);
    if (judge.judgement.holds) return std::move(judge.judgement);
    for (const ConditionResult& r : judge.judgement.conditions) {
        if (r.holds || r.isGroup) continue;
        if (!judge.judgement.message.empty()) judge.judgement.message += '\n';
        judge.judgement.message += failure(r);
    }
    return std::move(judge.judgement);
}

} // namespace yarte::validate
