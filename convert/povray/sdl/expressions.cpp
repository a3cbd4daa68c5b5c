// Expressions. From the loosest to the tightest: ? :, & |, comparisons, + -, * /, signs and !.

#include "convert/povray/sdl/builtins.h"
#include "convert/povray/sdl/colour_words.h"
#include "convert/povray/sdl/function.h"
#include "convert/povray/sdl/interpreter.h"
#include "convert/povray/sdl/spline.h"
#include "convert/povray/sdl/words.h"

#include <fmt/format.h>

#include <cmath>

namespace yarte::convert::povray::sdl {
namespace {

constexpr double tolerance = 1e-10; // POV-Ray's, of comparisons

template <typename Operation>
Vector combined(Vector a, Vector b, Operation operation) {
    const int size = std::max(a.size, b.size);
    a = a.promoted(size), b = b.promoted(size);
    for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) a.at[i] = operation(a.at[i], b.at[i]);
    return a;
}

bool compare(const Token& op, double order) {
    if (op.is('<')) return order < 0;
    if (op.is('>')) return order > 0;
    if (op.is('=')) return std::abs(order) < tolerance;
    if (op.is(Mark::notEqual)) return std::abs(order) >= tolerance;
    if (op.is(Mark::lessOrEqual)) return order < tolerance;
    return order > -tolerance;
}

bool isComparison(const Token& t) {
    return t.is('<') || t.is('>') || t.is('=') || t.is(Mark::notEqual) || t.is(Mark::lessOrEqual) ||
           t.is(Mark::greaterOrEqual);
}

} // namespace

double Interpreter::number() {
    const Span where = peek().span;
    const Vector v = term();
    if (v.size != 1) fail("sdl.not-a-number", fmt::format("expected a number, found {}", kindOf(v)), where);
    return v.at[0];
}

int Interpreter::integer() {
    const Span where = peek().span;
    const double v = number();
    if (!(std::abs(v) < 2147483647.0)) fail("sdl.range", "this number is too large here", where);
    return static_cast<int>(v);
}

Vector Interpreter::expression() {
    const Nested nested(*this);
    return choice(logical());
}

Vector Interpreter::term() {
    const Nested nested(*this);
    return choice(sum());
}

bool Interpreter::flag() {
    const Span where = peek().span;
    const Vector v = expression();
    if (v.size != 1) fail("sdl.not-a-number", fmt::format("expected a number, found {}", kindOf(v)), where);
    return isTrue(v.at[0]);
}

Vec3 Interpreter::vector3() {
    const Span where = peek().span;
    const Vector v = term();
    if (v.size > 3)
        fail("sdl.not-a-vector", fmt::format("expected a vector of 3, found {}", kindOf(v)), where);
    return v.promoted(3).vec3();
}

Vec3 Interpreter::listedPoint() {
    if (ahead_.empty()) {
        Lexer& lexer = frame().lexer;
        const std::size_t begin = lexer.offset();
        if (const auto literal = lexer.literalVector()) {
            if (lexer.skip(',')) return *literal;
            lexer.seek(begin);
        }
    }
    const Vec3 result = point();
    comma();
    return result;
}

Vec3 Interpreter::point() {
    if (ahead_.empty()) {
        if (const auto literal = frame().lexer.literalVector()) {
            // Usually followed by a comma or a brace, but this may go on: <1, 2, 3>*2.
            const Token& after = peekTail();
            if (!after.is('*') && !after.is('/') && !after.is('+') && !after.is('-') && !after.is('.'))
                return *literal;
            Token product{.kind = TokenKind::word, .text = "vector", .span = after.span};
            product.symbol = std::make_shared<Symbol>(Symbol{"vector", Value(Vector::of(*literal))});
            putBack(std::move(product));
        }
    }
    return vector3();
}

bool Interpreter::startsString() {
    const Token& token = peek();
    if (token.kind == TokenKind::string) return true;
    if (token.kind != TokenKind::word) return false;
    if (!token.symbol) return isStringFunction(token.text);
    const Value* value = token.symbol->value();
    if (value && std::holds_alternative<ArrayPtr>(*value)) value = namedValue();
    return value && std::holds_alternative<std::string>(*value);
}

std::string Interpreter::string() {
    const Nested nested(*this);
    std::string text = someString();
    if (text.size() > stringsLeft_)
        fail("sdl.string-too-long",
             fmt::format("strings of more than {} bytes in all", environment_.limits.strings), peekSpan());
    stringsLeft_ -= text.size();
    return text;
}

std::string Interpreter::someString() {
    if (peek().kind == TokenKind::string) return unescaped(next());
    if (!startsString()) failExpected("a string");
    if (auto named = acceptNamed<std::string>()) return *named;
    const Token name = next();
    return stringFunction(*this, name);
}

/// "? yes : no" after `condition`, if it comes.
Vector Interpreter::choice(const Vector& condition) {
    if (!peekTail().is('?')) return condition;
    const Token mark = next();
    if (condition.size != 1) fail("sdl.not-a-number", "the condition of '?' is not a number", mark.span);
    // POV-Ray evaluates both.
    const Vector yes = expression();
    expect(':');
    const Vector no = expression();
    return isTrue(condition.at[0]) ? yes : no;
}

Vector Interpreter::logical() {
    Vector left = comparison();
    while (peekTail().is('&') || peekTail().is('|')) {
        const bool both = next().is('&');
        left = combined(left, comparison(), [&](double a, double b) -> double {
            return both ? isTrue(a) && isTrue(b) : isTrue(a) || isTrue(b);
        });
    }
    return left;
}

Vector Interpreter::comparison() {
    if (startsString()) {
        const std::string left = string();
        if (!isComparison(peekTail())) failExpected("a comparison of strings, or a number");
        const Token op = next();
        const std::string right = string();
        return Vector::number(compare(op, left.compare(right)));
    }
    Vector left = sum();
    while (isComparison(peekTail())) {
        const Token op = next();
        left = combined(left, sum(), [&](double a, double b) -> double {
            // Differences of infinities would be no numbers.
            return compare(op, a == b ? 0 : a - b);
        });
    }
    return left;
}

Vector Interpreter::sum() {
    Vector left = product();
    while (peekTail().is('+') || peekTail().is('-')) {
        const bool plus = next().is('+');
        left = combined(left, product(), [&](double a, double b) { return plus ? a + b : a - b; });
    }
    return left;
}

Vector Interpreter::product() {
    Vector left = unary();
    while (peekTail().is('*') || peekTail().is('/')) {
        const Token op = next();
        if (op.is('*')) {
            left = combined(left, unary(), [](double a, double b) { return a * b; });
            continue;
        }
        bool byZero = false;
        left = combined(left, unary(), [&](double a, double b) {
            byZero |= b == 0;
            return b == 0 ? HUGE_VAL : a / b; // as POV-Ray has it
        });
        if (byZero) warn("sdl.division-by-zero", "division by zero", op.span);
    }
    return left;
}

Vector Interpreter::unary() {
    const Token& token = peek();
    if (token.is('-') || token.is('+') || token.is('!')) {
        const Token sign = next();
        const Nested nested(*this);
        Vector v = unary();
        for (double& c : v.at)
            if (sign.is('-'))
                c = -c;
            else if (sign.is('!'))
                c = isTrue(c) ? 0 : 1;
        return v;
    }
    const Token begin = token;
    return components(begin, primary());
}

/// ".x", ".red", ... after what `v` is.
Vector Interpreter::components(const Token& place, Vector v) {
    while (v.size > 1 && peekTail().is('.')) {
        next();
        const Token name = next();
        const std::string_view w = name.text;
        int index = channel(w);
        if (w == "x" || w == "u") index = 0;
        if (w == "y" || w == "v") index = 1;
        if (w == "z") index = 2;
        if (w == "t") index = 3;
        if (w == "gray" || w == "grey")
            return Vector::number(0.297 * v.at[0] + 0.589 * v.at[1] + 0.114 * v.at[2]);
        if (name.kind != TokenKind::word || index < 0)
            fail("sdl.component", "expected a component such as .x or .red", name.span);
        if (index >= v.size)
            fail("sdl.component", fmt::format("{} has no component .{}", kindOf(v), w), place.span);
        v = Vector::number(v.at[static_cast<std::size_t>(index)]);
    }
    return v;
}

Vector Interpreter::angled() {
    const Nested nested(*this);
    const Token open = expect('<');
    Vector v{0, {}};
    while (!peek().is('>')) {
        if (v.size == 5) fail("sdl.not-a-vector", "a vector has at most 5 components", open.span);
        v.at[static_cast<std::size_t>(v.size++)] = number();
        comma();
    }
    expect('>');
    if (v.size < 2) fail("sdl.not-a-vector", "a vector has at least 2 components", open.span);
    return v;
}

Vector Interpreter::primary() {
    const Token& token = peek();
    switch (token.kind) {
    case TokenKind::number: return Vector::number(next().number);
    case TokenKind::punctuation:
        if (token.is('<')) return angled();
        if (token.is('(')) {
            next();
            const Vector v = expression();
            expect(')');
            return v;
        }
        break;
    case TokenKind::word: {
        if (token.symbol) {
            const Token name = token;
            return ofName(name);
        }
        if (isColourWord(token.text)) return colourWords();
        Token name = next();
        if (const auto found = constant(name.text)) return *found;
        if (const auto found = numericBuiltin(*this, name)) return *found;
        const Span span = name.span;
        putBack(std::move(name));
        if (!isReserved(peek().text))
            fail("sdl.undeclared", fmt::format("'{}' is not declared", peek().text), span);
        break;
    }
    default: break;
    }
    failExpected("a number or a vector");
}

Vector Interpreter::ofName(const Token& name) {
    if (const auto v = acceptNamed<Vector>()) return *v;
    if (const auto function = acceptNamed<Shared<Function>>()) {
        const Token open = expect('(');
        std::vector<double> arguments;
        while (!peek().is(')')) {
            const Vector argument = expression(); // f(<1, 2, 3>) for functions of patterns
            for (int i = 0; i < argument.size && arguments.size() < 100; ++i)
                arguments.push_back(argument.at[static_cast<std::size_t>(i)]);
            comma();
        }
        expect(')');
        return call(**function, arguments, *this, open.span);
    }
    if (const auto spline = acceptNamed<Shared<Spline>>()) {
        expect('(');
        const double at = number();
        SplineKind kind = (*spline)->kind;
        if (accept(',')) kind = splineKind(*this).value_or(kind);
        expect(')');
        return evaluate(**spline, at, kind);
    }
    const Value* value = namedValue();
    fail("sdl.not-a-number",
         value ? fmt::format("expected a number or a vector, but '{}' is {}", name.text, kindOf(*value))
               : fmt::format("'{}' is not declared", name.text),
         name.span);
}

bool Interpreter::startsExpression() {
    const Token& token = peek();
    if (token.kind == TokenKind::number || token.is('<') || token.is('(') || token.is('-') || token.is('+') ||
        token.is('!'))
        return true;
    if (token.kind != TokenKind::word) return false;
    if (!token.symbol)
        return isColourWord(token.text) || constant(token.text) || isNumericBuiltin(token.text);
    const Value* value = namedValue();
    return value &&
           (std::holds_alternative<Vector>(*value) || std::holds_alternative<Shared<Function>>(*value) ||
            std::holds_alternative<Shared<Spline>>(*value));
}

Value Interpreter::value() {
    const Nested nested(*this);
    if (peek().isWord("array")) return arrayLiteral(next());
    if (peek().isWord("function")) return parseFunction(*this);
    if (peek().isWord("spline")) return parseSpline(*this);
    if (std::optional<Value> statement = statements_.value(*this)) return std::move(*statement);
    if (startsString()) {
        std::string text = string();
        if (!isComparison(peekTail())) return text;
        const Token op = next();
        return Vector::number(compare(op, text.compare(string())));
    }
    if (const Value* named = namedValue()) {
        const bool isCalled = std::holds_alternative<Shared<Function>>(*named) ||
                              std::holds_alternative<Shared<Spline>>(*named);
        if (isCalled) {
            Token name = next();
            const bool call = peekTail().is('(');
            Value function = *name.symbol->value();
            if (!call) return function;
            putBack(std::move(name));
        } else if (!std::holds_alternative<Vector>(*named)) {
            Value result = copied(*named, peekSpan());
            takeNamed();
            return result;
        }
    }
    const Token& token = peek();
    if (token.kind == TokenKind::word && !token.symbol && isColourWord(token.text))
        return Vector::of(colour());
    return expression();
}

} // namespace yarte::convert::povray::sdl
