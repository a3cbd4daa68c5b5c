#include "validate/verdict.h"

namespace yarte::validate {

const char* name(Verdict verdict) {
    switch (verdict) {
    case Verdict::pass: return "pass";
    case Verdict::fail: return "fail";
    case Verdict::error: break;
    }
    return "error";
}

Verdict judge(const Tolerance& tolerance, std::size_t pixelsOver) {
    return pixelsOver > tolerance.pixels ? Verdict::fail : Verdict::pass;
}

} // namespace yarte::validate
